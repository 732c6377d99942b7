"""A line of text as it is edited: its caret, what is selected, and what is still being composed."""

from __future__ import annotations

from typing import NamedTuple

import pygame

from game.render import theme
from game.render.font import Type
from game.render.theme import Colour, mix

from . import shapes

SELECTION = mix(theme.PANEL_RAISED, theme.ACCENT, 0.20)
TALL = 1.1
"""Height of caret and selection over the size of the text."""


class TextLine(NamedTuple):
    """A text in a box, edited or not.

    text       what is written
    caret      its place, None if it is not edited
    selection  where the selected part begins and ends
    composing  what an input method has not written yet: it stands in the selection's place
    """

    text: str
    caret: int | None = None
    selection: tuple[int, int] = (0, 0)
    composing: str = ""

    @property
    def whole(self) -> TextLine:
        """The line with what is being composed in it, and that as its selection."""
        if self.caret is None or not self.composing:
            return self
        low, high = self.selection if self.selection[0] < self.selection[1] else (self.caret,) * 2
        end = low + len(self.composing)
        text = self.text[:low] + self.composing + self.text[high:]
        return TextLine(text, end, (low, end), self.composing)


def draw(
    surface: pygame.Surface,
    window: pygame.Rect,
    type_: Type,
    line: TextLine,
    size: float,
    baseline: float,
    ink: Colour,
    align: str = "left",
) -> None:
    """Draw a line in `window`, scrolled so that its caret, or else its end, stays visible."""
    line, s = line.whole, type_.s
    left = _left(window, type_, line, size, align)
    edges = [left + type_.width(line.text[:at], size) for at in line.selection]
    middle, high = round(baseline - type_.cap(size) / 2), round(TALL * size * s)
    clip = surface.get_clip()
    surface.set_clip(window.inflate(round(8 * s), round(8 * s)).clip(clip))
    if edges[0] < edges[1] and not line.composing:
        block = pygame.Rect(edges[0], 0, edges[1] - edges[0], high).inflate(round(6 * s), 0)
        block.centery = middle
        shapes.box(surface, block, s, SELECTION, SELECTION, radius=3)
    type_.draw(surface, line.text, (left, baseline), size, ink)
    if line.composing:
        below = round(baseline + 3 * s)
        surface.fill(theme.ACCENT, (edges[0], below, edges[1] - edges[0], max(1, round(1.5 * s))))
    if line.caret is not None:
        place = left + type_.width(line.text[: line.caret], size)
        bar = pygame.Rect(place, 0, max(1, round(1.5 * s)), high)
        bar.centery = middle
        surface.fill(theme.ACCENT, bar)
    surface.set_clip(clip)


def place_at(
    window: pygame.Rect, type_: Type, line: TextLine, size: float, x: float, align: str = "left"
) -> int:
    """Return the place in a line, as it is drawn, that is nearest to the screen's `x`."""
    left = _left(window, type_, line, size, align)
    gaps = [abs(left + type_.width(line.text[:i], size) - x) for i in range(len(line.text) + 1)]
    return gaps.index(min(gaps))


def _left(window: pygame.Rect, type_: Type, line: TextLine, size: float, align: str) -> int:
    """Return where a line begins: as aligned, but with its caret, or else its end, in view."""
    room = window.w - type_.width(line.text, size)
    left = window.x + {"left": 0, "centre": room // 2, "right": room}[align]
    at = left + type_.width(line.text[: line.caret], size)
    return left + max(window.x - at, 0) - max(at - window.right, 0)
