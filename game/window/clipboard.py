"""The clipboard, where there is one: where there is none, copying and pasting just do not happen.

pygame-ce has SDL's clipboard; pygame's own writes nothing under X11, so there SDL is asked itself.
"""

from __future__ import annotations

import ctypes
from typing import Any

import pygame

FAILS = (pygame.error, ImportError, AttributeError, NotImplementedError, OSError, TypeError)


def put(text: str) -> bool:
    """Copy a text; returns whether that could be done."""
    for way in (_put_ce, _put_sdl, _put_pygame):
        try:
            return way(text)
        except FAILS:
            continue
    return False


def get() -> str:
    """The text that has been copied, or "" if there is none."""
    for way in (_get_ce, _get_sdl, _get_pygame):
        try:
            return way().replace("\0", "").strip()
        except FAILS:
            continue
    return ""


def _scrap() -> Any:
    import pygame.scrap as scrap

    return scrap


def _put_ce(text: str) -> bool:
    _scrap().put_text(text)
    return True


def _get_ce() -> str:
    return str(_scrap().get_text())


def _sdl() -> ctypes.CDLL:
    """The library that pygame has loaded; AttributeError later where it hides its names."""
    import pygame.base

    return ctypes.CDLL(pygame.base.__file__)


def _put_sdl(text: str) -> bool:
    return bool(_sdl().SDL_SetClipboardText(text.encode()) == 0)


def _get_sdl() -> str:
    library = _sdl()
    library.SDL_GetClipboardText.restype = ctypes.c_void_p
    address = library.SDL_GetClipboardText()
    if not address:
        return ""
    text = ctypes.string_at(address).decode("utf-8", "replace")
    library.SDL_free(ctypes.c_void_p(address))
    return text


def _ready() -> Any:
    scrap = _scrap()
    if not scrap.get_init():
        scrap.init()
    return scrap


def _put_pygame(text: str) -> bool:
    _ready().put(pygame.SCRAP_TEXT, text.encode())
    return True


def _get_pygame() -> str:
    return bytes(_ready().get(pygame.SCRAP_TEXT) or b"").decode("utf-8", "replace")
