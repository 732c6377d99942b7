"""The balls on one table: how each has turned, its picture, its shadow, and where they go."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from math import ceil
from typing import NamedTuple

import pygame

from game.render.layout import Layout
from game.render.theme import CLOTHS, LINE_INPUT, BallLook, Colour

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
from .sheet import Fine, Sheet, Turn
from .wells import Wells

CELLS, FEW_CELLS = (17, 9), (9, 5)
"""Light changes in steps of this many cells along and across the table; for many balls of fewer."""
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
    still: does it rest?  Then it is worth a finer picture.
    """

    ball: int
    at: Place
    height: float = 0.0
    still: bool = False


class Sight(NamedTuple):
    """What a ball's picture depends on: how it has turned, the cell of its light (m), by how many
    half pixels it is off; then where it is (m), and where its top left corner and its middle go."""

    turn: Quaternion
    cell: Place
    half: tuple[int, int]
    at: Place
    corner: tuple[int, int]
    middle: tuple[int, int]


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
        first = {i: self._orientations[i] for i, look in enumerate(self.looks) if look.number}
        self._ends = {i: (q, other_end(q)) for i, q in first.items()}
        self._sprites: list[tuple[object, pygame.Surface] | None] = [None] * len(self.looks)
        self._seen: list[Sight | None] = [None] * len(self.looks)
        self._shadows = {px: Shadows(px, layout.scale) for px in {*self._px}}
        self._grid = FEW_CELLS if many else CELLS
        self._sides_of_bed = layout.length, layout.width
        self._sheets: dict[float, Sheet] = {}
        self._fine: dict[float, Fine] = {}
        self._painters: dict[float, Painter] = {}
        self._cells: dict[int, int] = {}
        (self._together if many else self._alone)(CLOTHS[cloth])

    def _together(self, cloth: Colour) -> None:
        """A sheet for all balls of a size."""
        for px in {*self._px}:
            own = [i for i, size in enumerate(self._px) if size == px]
            self._cells |= {i: k for k, i in enumerate(own)}
            looks = [self.looks[i] for i in own]
            self._sheets[px], self._fine[px] = Sheet(px, looks, cloth), Fine(px, looks, cloth)

    def _alone(self, cloth: Colour) -> None:
        """A painter for each size."""
        self._painters = {px: Painter(px, cloth) for px in {*self._px}}
        pairs = zip(self.looks, self._px, strict=True)
        self._shades = [shades(look, 2 * px) for look, px in pairs]

    # -- how they have turned ------------------------------------------------------------------

    def rotate(self, index: int, spin: tuple[float, float, float], dt: float) -> None:
        """Turn a ball with `spin` (wx, wy, wz in rad/s, z to the viewer) for `dt` seconds."""
        self.orient(index, rotated(self._orientations[index], spin, dt))

    def orientation(self, index: int) -> Quaternion:
        """Return how a ball has turned since it was made of glass and light, scalar part first."""
        return self._orientations[index]

    def orient(self, index: int, turn: Quaternion) -> None:
        """Set how a ball has turned, as `orientation` gave it (for scrubbing and undo)."""
        if turn != self._orientations[index]:  # what is painted asks whether it is the same object
            self._orientations[index] = turn

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
        for index, at, _, still in spots if self._sheets else ():
            if still:
                continue
            seen, turn = self._seen[index], self._orientations[index]
            if seen is not None and seen.at == at and seen.turn is turn:
                continue
            px = self._px[index]
            now = self._seen[index] = self._sight(index, at, 2 * self._sheets[px].side)
            turn, cell, half = now[:3]
            if seen is None or seen[:3] != (turn, cell, half):
                found.setdefault(px, []).append(Turn(self._cells[index], turn, cell, half))
        for px, turns in found.items():
            self._sheets[px].paint(turns)

    def _sight(self, index: int, at: Place, side: int) -> Sight:
        """What a ball's picture depends on, and where it goes; `side`: of it, in half pixels."""
        x, y = self.layout.to_screen(*at)
        left, top = round(2 * x) - side // 2, round(2 * y) - side // 2
        half, corner = (left & 1, top & 1), (left >> 1, top >> 1)
        middle = round(x), round(y)
        return Sight(self._orientations[index], self._cell(at), half, at, corner, middle)

    def sprite(
        self, index: int, at: Place, *, still: bool = False
    ) -> tuple[pygame.Surface, tuple[int, int]]:
        """Return the picture of a ball at `at` (m) and where its top left corner goes.

        The same surface comes back while the ball neither turns nor moves half a pixel. Of many,
        one that is `still` is painted finer.
        """
        px = self._px[index]
        if self._sheets and not still:
            self.prepare([Spot(index, at)])
            seen = self._seen[index]
            assert seen is not None
            return self._sheets[px].cells[self._cells[index]], seen.corner
        side = self._fine[px].side if self._sheets else self._painters[px].side
        now, kept = self._sight(index, at, side), self._sprites[index]
        if kept is None or kept[0] != now[:3]:
            kept = self._sprites[index] = (now[:3], self._painted(index, now))
        return kept[1], now.corner

    def _painted(self, index: int, now: Sight) -> pygame.Surface:
        """The picture of one ball as smooth as it gets."""
        px = self._px[index]
        if self._sheets:
            return self._fine[px].sprite(Turn(self._cells[index], *now[:3]))
        look, turn = self.looks[index], matrix(now.turn)
        return self._painters[px].sprite(self._shades[index], look.banded, turn, now.cell, now.half)

    def portrait(self, index: int) -> pygame.Surface:
        """Return a ball as it is racked in the middle of the table, for plates and lists."""
        look = self.looks[index]
        if self._sheets:
            return portrait(look, self._px[index])
        turn, painter = matrix(_racked(index, look)), self._painters[self._px[index]]
        return painter.sprite(self._shades[index], look.banded, turn, (0.0, 0.0), (0, 0))

    def shadow(self, surface: pygame.Surface, spot: Spot) -> pygame.Rect:
        """Draw the shadow of a ball, thrown away from the lamps."""
        shadows, seen = self._shadows[self._px[spot.ball]], self._seen[spot.ball]
        if seen is not None and seen.at == spot.at and not spot.height:
            return shadows.draw_joined(surface, seen.middle, seen.cell)
        centre = self.layout.to_screen(*spot.at)
        if spot.height > 0.0:
            return shadows.draw_below(surface, centre, spot.at, spot.height)
        if self._sheets:
            middle = round(centre[0]), round(centre[1])
            return shadows.draw_joined(surface, middle, self._cell(spot.at))
        return shadows.draw(surface, centre, spot.at)

    def draw_all(self, surface: pygame.Surface, spots: Iterable[Spot]) -> None:
        """Draw balls, all shadows below all balls, those in the air above the others."""
        placed = [*spots]
        heights = [spot.height for spot in placed]
        if any(heights):
            placed.sort(key=_height)
            sunk = [spot for spot in placed if spot.height < 0.0]
            for spot in sunk:
                self._sink(surface, spot)
            placed = placed[len(sunk) :]
        for spot in placed:
            self.shadow(surface, spot)
        for spot in placed:
            self._put(surface, spot)

    def _sink(self, surface: pygame.Surface, spot: Spot) -> None:
        """Draw a ball that is below the cloth, if there are holes."""
        if self.wells is not None:
            picture, _ = self.sprite(spot.ball, spot.at)
            centre = self.layout.to_screen(*spot.at)
            radius = self._px[spot.ball] / self.layout.scale
            self.wells.sink(surface, picture, centre, radius, -spot.height)

    def _put(self, surface: pygame.Surface, spot: Spot) -> pygame.Rect:
        seen = self._seen[spot.ball] if not (spot.still or spot.height) else None
        turn = self._orientations[spot.ball]
        if seen is not None and seen.at == spot.at and seen.turn is turn:  # painted in the sheet
            sheet, cell = self._sheets[self._px[spot.ball]], self._cells[spot.ball]
            return surface.blit(sheet.whole, seen.corner, sheet.areas[cell])
        picture, corner = self.sprite(spot.ball, spot.at, still=spot.still)
        if spot.height <= 0.0:
            return surface.blit(picture, corner)
        side = ceil(picture.get_width() * (1 + LENS * spot.height))
        x, y = self.layout.to_screen(*spot.at)
        nearer = pygame.transform.smoothscale(picture, (side, side))
        return surface.blit(nearer, (round(x - side / 2), round(y - side / 2)))

    def _cell(self, at: Place) -> Place:
        """Return the middle of the light cell that holds `at`, metres."""
        (across, down), (length, width) = self._grid, self._sides_of_bed
        x, y = round(at[0] / length * across), round(at[1] / width * down)
        if abs(x) > across // 2 or abs(y) > down // 2:  # in a pocket, or off the table
            x = min(max(x, -(across // 2)), across // 2)
            y = min(max(y, -(down // 2)), down // 2)
        return x * length / across, y * width / down


def _height(spot: Spot) -> float:
    return spot.height


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
    sheet.paint([Turn(0, _racked(1, look), (0.45, 0.25), (0, 0))])
    picture = sheet.cells[0].copy()
    if ringed and max(look.body) < DARK:
        middle = picture.get_width() // 2
        pygame.draw.circle(picture, LINE_INPUT, (middle, middle), round(px), 1)
    return picture
