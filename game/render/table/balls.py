"""The balls on one table: how each has turned, its picture, its shadow, and where they go."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from math import ceil
from typing import NamedTuple

import pygame

from game.render.layout import Layout
from game.render.theme import CLOTHS, LINE_INPUT, BallLook

from . import prints
from .painter import Painter
from .rotation import (
    RACKED,
    Quaternion,
    between,
    matrix,
    other_end,
    resting,
    rotated,
    unit,
)
from .shades import shades
from .shadows import Shadows
from .sheet import Sheet, Turn
from .wells import Wells

CELLS = (17, 9)
"""Light changes in steps of this many cells along and across the table."""
RADIUS = 0.03275
DARK = 64
"""A body whose brightest channel is below that is lost on a panel."""
LENS = 1.2
"""How much larger a ball looks for each metre that it is nearer."""
Place = tuple[float, float]


class Spot(NamedTuple):
    """Where a ball is.

    ball: its place among the balls.
    at: (x, y), m.
    height: above the cloth, m; below it is negative.
    """

    ball: int
    at: Place
    height: float = 0.0


class BallSprites:
    """The pictures of some balls on one table, each with its own orientation.

    `looks` is one look a ball, drawn by its place in that order; `radius` is theirs in metres, or
    one for each. `many` paints them together: for that, see `sheet`.
    """

    def __init__(
        self,
        layout: Layout,
        looks: Sequence[BallLook],
        radius: float | Sequence[float] = RADIUS,
        cloth: str = "blue",
        *,
        many: bool = False,
    ) -> None:
        self.layout, self.looks = layout, tuple(looks)
        radii = [radius] * len(looks) if isinstance(radius, int | float) else [*radius]
        self._px = [r * layout.scale for r in radii]
        self.px = max(self._px, default=RADIUS * layout.scale)
        """Radius of the largest, px."""
        self.wells: Wells | None = None
        """The holes that they fall into."""
        self._orientations = [_racked(i, look) for i, look in enumerate(self.looks)]
        self._matrices = [matrix(q) for q in self._orientations]
        first = {i: self._orientations[i] for i, look in enumerate(self.looks) if look.number}
        self._ends = {i: (q, other_end(q)) for i, q in first.items()}
        self._sprites: list[tuple[tuple[object, ...], pygame.Surface] | None]
        self._sprites = [None] * len(self.looks)
        self._shadows = {px: Shadows(px, layout.scale) for px in {*self._px}}
        colour = CLOTHS[cloth]
        self._sheets: dict[float, Sheet] = {}
        self._cells: dict[int, int] = {}
        if many:
            for px in {*self._px}:
                own = [i for i, size in enumerate(self._px) if size == px]
                self._cells |= {i: k for k, i in enumerate(own)}
                self._sheets[px] = Sheet(px, [self.looks[i] for i in own], colour)
            self._sides = {px: sheet.side for px, sheet in self._sheets.items()}
        else:
            self._painters = {px: Painter(px, colour) for px in {*self._px}}
            self._sides = {px: painter.side for px, painter in self._painters.items()}
            pairs = zip(self.looks, self._px, strict=True)
            self._shades = [shades(look, 2 * px) for look, px in pairs]

    # -- how they have turned ------------------------------------------------------------------

    def rotate(self, index: int, spin: tuple[float, float, float], dt: float) -> None:
        """Turn a ball with `spin` (wx, wy, wz in rad/s, z to the viewer) for `dt` seconds."""
        self.orient(index, rotated(self._orientations[index], spin, dt))

    def advance(self, index: int, rotation: tuple[float, float, float]) -> None:
        """Turn a ball by a rotation vector in radians."""
        self.rotate(index, rotation, 1.0)

    def orientation(self, index: int) -> Quaternion:
        """Return how a ball has turned since it was made of glass and light, scalar part first."""
        return self._orientations[index]

    def orient(self, index: int, turn: Quaternion) -> None:
        """Set how a ball has turned, as `orientation` gave it (for scrubbing and undo)."""
        if turn != self._orientations[index]:
            self._orientations[index] = turn
            self._matrices[index] = matrix(turn)

    def rack(self) -> None:
        """Turn every ball back to how it lay at the beginning."""
        for index, look in enumerate(self.looks):
            self.orient(index, _racked(index, look))

    def settle(self) -> None:
        """Turn balls with numbers so that these can be read, from the end that is nearer."""
        for index, ends in self._ends.items():
            turn = self._orientations[index]
            if turn not in ends:
                self.orient(index, max(ends, key=lambda q: between(q, turn)))

    # -- what they look like -------------------------------------------------------------------

    def prepare(self, spots: Iterable[Spot]) -> None:
        """Paint all balls whose pictures have changed at once, where that is cheaper."""
        found: dict[float, list[Turn]] = {}
        for index, at, _ in spots if self._sheets else ():
            key, _ = self._key(index, at)
            kept = self._sprites[index]
            if kept is None or kept[0] != key:
                px = self._px[index]
                turn = Turn(self._cells[index], self._matrices[index], key[2], key[1])
                found.setdefault(px, []).append(turn)
                self._sprites[index] = key, self._sheets[px].cells[turn.cell]
        for px, turns in found.items():
            self._sheets[px].paint(turns)

    def _key(
        self, index: int, at: Place
    ) -> tuple[tuple[Quaternion, tuple[int, int], Place], tuple[int, int]]:
        """What a picture depends on, and where its top left corner goes."""
        x, y = self.layout.to_screen(*at)
        side = self._sides[self._px[index]]
        # a painter's side is in halves of a pixel, a sheet's in pixels
        reach = side if self._sheets else side // 2
        left, top = round(2 * x) - reach, round(2 * y) - reach
        half = (left % 2, top % 2)
        corner = (left - half[0]) // 2, (top - half[1]) // 2
        return (self._orientations[index], half, self._cell(at)), corner

    def sprite(self, index: int, at: Place) -> tuple[pygame.Surface, tuple[int, int]]:
        """Return the picture of a ball at `at` (m) and where its top left corner goes.

        The same surface comes back while the ball neither turns nor moves half a pixel.
        """
        if self._sheets:
            self.prepare([Spot(index, at)])
        key, corner = self._key(index, at)
        kept = self._sprites[index]
        if kept is None or kept[0] != key:
            look, painter = self.looks[index], self._painters[self._px[index]]
            picture = painter.sprite(
                self._shades[index], look.banded, self._matrices[index], key[2], key[1]
            )
            kept = self._sprites[index] = (key, picture)
        return kept[1], corner

    def portrait(self, index: int) -> pygame.Surface:
        """Return a ball as it is racked in the middle of the table, for plates and lists."""
        look = self.looks[index]
        if self._sheets:
            return portrait(look, self._px[index])
        turn, painter = matrix(_racked(index, look)), self._painters[self._px[index]]
        return painter.sprite(self._shades[index], look.banded, turn, (0.0, 0.0), (0, 0))

    def shadow(self, surface: pygame.Surface, spot: Spot) -> pygame.Rect:
        """Draw the shadow of a ball, thrown away from the lamps."""
        shadows = self._shadows[self._px[spot.ball]]
        centre = self.layout.to_screen(*spot.at)
        if spot.height > 0.0:
            return shadows.draw_below(surface, centre, spot.at, spot.height)
        if self._sheets:
            return shadows.draw_joined(surface, centre, self._cell(spot.at))
        return shadows.draw(surface, centre, spot.at)

    def draw(
        self, surface: pygame.Surface, index: int, at: Place, height: float = 0.0
    ) -> pygame.Rect:
        """Draw one ball and its shadow, centred at `at` (m)."""
        return self.draw_all(surface, [Spot(index, at, height)])[0]

    def draw_all(self, surface: pygame.Surface, spots: Iterable[Spot]) -> list[pygame.Rect]:
        """Draw balls, all shadows below all balls, those in the air above the others."""
        placed = sorted(spots, key=lambda spot: spot.height)
        sunk = [self._sink(surface, spot) for spot in placed if spot.height < 0.0]
        placed = placed[len(sunk) :]
        shadows = [self.shadow(surface, spot) for spot in placed]
        return sunk + [
            shadow.union(self._put(surface, spot))
            for shadow, spot in zip(shadows, placed, strict=True)
        ]

    def _sink(self, surface: pygame.Surface, spot: Spot) -> pygame.Rect:
        """Draw a ball that is below the cloth, if there are holes."""
        if self.wells is None:
            return pygame.Rect(0, 0, 0, 0)
        picture, _ = self.sprite(spot.ball, spot.at)
        centre, radius = self.layout.to_screen(*spot.at), self._px[spot.ball] / self.layout.scale
        return self.wells.sink(surface, picture, centre, radius, -spot.height)

    def _put(self, surface: pygame.Surface, spot: Spot) -> pygame.Rect:
        picture, corner = self.sprite(spot.ball, spot.at)
        if spot.height <= 0.0:
            return surface.blit(picture, corner)
        side = ceil(picture.get_width() * (1 + LENS * spot.height))
        x, y = self.layout.to_screen(*spot.at)
        nearer = pygame.transform.smoothscale(picture, (side, side))
        return surface.blit(nearer, (round(x - side / 2), round(y - side / 2)))

    def _cell(self, at: Place) -> Place:
        """Return the middle of the light cell that holds `at`, metres."""
        sides = (self.layout.length, self.layout.width)
        x, y = (
            (min(max(round(p / side * n), -(n // 2)), n // 2)) * side / n
            for p, side, n in zip(at, sides, CELLS, strict=True)
        )
        return x, y


def _racked(index: int, look: BallLook) -> Quaternion:
    """Return the first orientation of a ball: seen from above, each is turned another way."""
    if look.number:
        return resting(index)
    return rotated(unit(RACKED), (0.0, 0.0, 1.0), 0.5 - 0.9 * (index % 3))


@lru_cache(maxsize=256)
def portrait(look: BallLook, px: float, *, ringed: bool = True) -> pygame.Surface:
    """Return a ball as it is drawn in plates and trays, with a radius of `px` pixels.

    Its number is larger than on the table; a black ball is `ringed`, or it would be lost there.
    """
    disc = prints.PLATE if px < prints.UNDERLINED else prints.DISC
    sheet = Sheet(px, [look], CLOTHS["pool"], disc)
    turn = matrix(rotated(resting(0), (0.0, 0.0, 0.1), 1.0) if look.number else _racked(1, look))
    sheet.paint([Turn(0, turn, (0.45, 0.25), (0, 0))])
    picture = sheet.cells[0].copy()
    if ringed and max(look.body) < DARK:
        middle = picture.get_width() // 2
        pygame.draw.circle(picture, LINE_INPUT, (middle, middle), round(px), 1)
    return picture
