"""How what comes from outside is repeated in a message: in one line that is not long."""

from __future__ import annotations

from unicodedata import category

LONGEST = 60
UNSEEN = ("Cc", "Cs", "Zl", "Zp")
"""Kinds of characters that cannot be drawn: controls, lone surrogates, breaks of a line."""


def shortly(value: object) -> str:
    """Return a value as it is written in Python, cut short."""
    try:
        return f"{value!r:.{LONGEST}}"
    except (RecursionError, ValueError):  # lists in lists in lists, or thousands of digits
        return f"a {type(value).__name__}"


def in_a_line(text: object, most: int = 400) -> str:
    """Return a text without breaks of lines, and without what is beyond `most` characters."""
    line = " ".join(str(text).split())
    return line if len(line) <= most else line[: most - 1] + "…"


def drawable(text: str) -> str:
    """Return a text with a sign for each character that cannot be drawn."""
    if text.isprintable():  # nearly always
        return text
    return "".join("\ufffd" if category(c) in UNSEEN else c for c in text)
