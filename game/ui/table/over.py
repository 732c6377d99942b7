"""Cards that lie over the table, above balls and cue: a toast, a guide, what a drill asks for."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import NamedTuple

import pygame

from game.render import theme
from game.render.font import Type
from game.render.parts import shapes
from game.render.theme import Colour

PAD, LINE = 12, 20
"""Room around the words of a card, and the height of a line; px at s = 1."""


class LaidCard(NamedTuple):
    """A picture and where it lies.

    key: equal keys, equal pictures.
    """

    key: Hashable
    rect: pygame.Rect
    picture: pygame.Surface


class Over:
    """What lies over a table; only what has changed is drawn again."""

    def __init__(self) -> None:
        self.cards: tuple[LaidCard, ...] = ()
        self._shown: dict[Hashable, pygame.Rect] = {}

    def changed(self) -> list[pygame.Rect]:
        """Return where cards have come or gone since the last time."""
        now = {card.key: card.rect for card in self.cards}
        before, self._shown = self._shown, now
        both = [(before, now), (now, before)]
        return [rect for one, other in both for key, rect in one.items() if key not in other]

    def undrawn(self) -> None:
        """Nothing of them is on the screen any more."""
        self._shown = {}

    def draw(self, surface: pygame.Surface, area: pygame.Rect) -> None:
        """Draw what reaches into an area."""
        for card in self.cards:
            if card.rect.colliderect(area):
                surface.blit(card.picture, card.rect)


def outlined(surface: pygame.Surface, rect: pygame.Rect, s: float) -> None:
    """Light the edge of a part that is spoken of."""
    width, radius = max(2, round(2 * s)), round(shapes.RADIUS * s)
    pygame.draw.rect(surface, theme.ACCENT, rect, width, border_radius=radius)


def written(
    type_: Type,
    rows: Sequence[tuple[str, float, Colour]],
    edge: Colour,
    most: float,
    line: float = LINE,
    before: int = 0,
) -> pygame.Surface:
    """Return the picture of a card with rows of (text, size, colour), at most so many px wide.

    `line` is the height of a row, px at s = 1; `before` px stay free before the rows.
    """
    s = type_.s
    pad, high = round(PAD * s), max(round(line * s), 12)
    room = most - 2 * pad - before
    fitted = [(type_.fitted(text, size, room), size, ink) for text, size, ink in rows]
    wide = max((type_.width(text, size) for text, size, _ in fitted), default=0)
    whole = round(wide) + 2 * pad + before, high * len(rows) + pad
    picture = pygame.Surface(whole, pygame.SRCALPHA)
    shapes.box(picture, picture.get_rect(), s, theme.PANEL, edge)
    for place, (text, size, ink) in enumerate(fitted):
        middle = pad / 2 + high * (place + 0.5)
        type_.draw(picture, text, (pad + before, middle + type_.cap(size) / 2), size, ink)
    return picture
