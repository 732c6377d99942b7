"""The window on the screen: of a size that its user drags, or filling all of it."""

from __future__ import annotations

import pygame

Size = tuple[int, int]


def opened(size: Size, *, full: bool) -> pygame.Surface:
    """Show a window of so many px, or one that fills the screen; returns its surface.

    Where the screen cannot be filled it stays a window: pygame.error if not even that can be.
    """
    if full:
        try:
            return pygame.display.set_mode(_desktop(size), pygame.FULLSCREEN)
        except pygame.error:
            pass
    window = pygame.display.set_mode(size, pygame.RESIZABLE)
    if window.get_size() != size:  # some drivers only leave the full screen, and keep its size
        window = pygame.display.set_mode(size, pygame.RESIZABLE)
    return window


def _desktop(size: Size) -> Size:
    """The size of the screen, or `size` where no one knows it."""
    found = pygame.display.get_desktop_sizes()
    return found[0] if found and min(found[0]) > 0 else size
