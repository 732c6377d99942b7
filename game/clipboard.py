"""The clipboard, where there is one: without a desktop copying and pasting just do not happen."""

from __future__ import annotations

from typing import Any

import pygame


def _scrap() -> Any:
    import pygame.scrap as scrap

    if not hasattr(scrap, "put_text") and not scrap.get_init():
        scrap.init()
    return scrap


def put(text: str) -> bool:
    """Copy a text; returns whether that could be done."""
    try:
        scrap = _scrap()
        if hasattr(scrap, "put_text"):  # pygame-ce
            scrap.put_text(text)
        else:
            scrap.put(pygame.SCRAP_TEXT, text.encode())
    except (pygame.error, ImportError, NotImplementedError, TypeError):
        return False
    return True


def get() -> str:
    """The text that has been copied, or "" if there is none."""
    try:
        scrap = _scrap()
        if hasattr(scrap, "get_text"):
            return str(scrap.get_text() or "")
        raw = scrap.get(pygame.SCRAP_TEXT) or b""
    except (pygame.error, ImportError, NotImplementedError, TypeError, UnicodeDecodeError):
        return ""
    return bytes(raw).decode("utf-8", "replace").replace("\0", "").strip()
