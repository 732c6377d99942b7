"""What is written on a key."""

from __future__ import annotations

SIGNS = {
    "left": "←", "right": "→", "up": "↑", "down": "↓", "period": ".", "comma": ",", "slash": "/",
    "semicolon": ";", "quote": "'", "backslash": "\\", "leftbracket": "[", "rightbracket": "]",
    "backquote": "`", "equals": "=", "pageup": "PgUp", "pagedown": "PgDn",
}  # fmt: skip


def cap_name(key: str, words: dict[str, str]) -> str:
    """Return the sign or word for a key by pygame's name of it."""
    if key == "space":
        return words["name.space"]
    return SIGNS.get(key) or (key.upper() if key[1:].isdigit() else key.capitalize())
