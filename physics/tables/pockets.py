"""The geometry of pockets: rails, facings, noses and holes, and the outline that they make.

Points are complex numbers, metres, and the middle of the table is 0. One quarter is computed, and
the others are its mirror images, exactly.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import sqrt
from typing import NamedTuple

from physics.checks import keep, nonnegative, positive
from physics.kernel.elementary import direction

from .pieces import Piece

ARC = 12  # chords that a rounded nose has in an outline
QUARTERS = ((1, 1), (-1, 1), (-1, -1), (1, -1))  # signs of x and y, anticlockwise
SIDES = {(1, 0): "east", (-1, 0): "west", (0, 1): "north", (0, -1): "south"}


@dataclass(frozen=True, slots=True)
class Mouth:
    """One kind of pocket.

    width: between the two vertices at which the lines of noses and facings meet, before any
        rounding, m.
    facing: by how many degrees each facing closes in on the pocket's axis.
    shelf: from the middle of the mouth to the hole's edge, m.
    hole: its radius, m.
    rounding: the radius of the noses, m; 0 for points.

    ValueError, naming the value, for what no pocket can be.
    """

    width: float
    facing: float
    shelf: float
    hole: float
    rounding: float = 0.0

    def __post_init__(self) -> None:
        keep(self, positive, "width", "hole")
        keep(self, nonnegative, "shelf", "rounding", "facing")
        if self.facing >= 45.0:
            raise ValueError(f"Mouth.facing must be below 45, not {self.facing!r}")


@dataclass(frozen=True, slots=True)
class Pockets:
    """The four in the corners, and the two at the middle of the long sides."""

    corner: Mouth
    side: Mouth

    def __post_init__(self) -> None:
        for mouth in (self.corner, self.side):
            if not isinstance(mouth, Mouth):
                raise ValueError(f"Pockets takes two of Mouth, not {mouth!r}")


class Jaw(NamedTuple):
    """How a rail ends at a pocket: its nose line at the first point of `line`, its facing at the
    last; from `start` on the facing is straight. Before it the nose is a post, or else a vertex."""

    line: tuple[complex, ...]
    start: complex
    centre: complex
    radius: float

    def mirrored(self, sx: int, sy: int) -> "Jaw":
        """The same in another quarter."""
        line = tuple(_mirrored(p, sx, sy) for p in self.line)
        start, centre = _mirrored(self.start, sx, sy), _mirrored(self.centre, sx, sy)
        return Jaw(line, start, centre, self.radius)


def _mirrored(p: complex, sx: int, sy: int) -> complex:
    return complex(sx * p.real, sy * p.imag)


def _jaw(vertex: complex, along: complex, out: complex, turn: float, mouth: Mouth) -> Jaw:
    """The end of a rail at its vertex, which it reaches going along; out: away from the table.

    turn: degrees between the rail and the pocket's axis. The facing ends beside the hole's centre:
    `check` sees to it that no ball comes past there.
    """
    angle = turn - mouth.facing
    towards, r = direction(angle), mouth.rounding
    facing = along * towards.real + out * towards.imag
    used = r * towards.imag / (1.0 + towards.real)  # of both lines by the rounding
    far = max(used, (mouth.shelf + mouth.hole) / direction(mouth.facing).real)
    nose, start = vertex - used * along, vertex + used * facing
    centre = nose + r * out
    bends = [direction(angle * k / ARC) for k in range(1, ARC)] if r else []
    around = [centre + r * (along * b.imag - out * b.real) for b in bends]
    line = [nose, *around, *([start] if r else []), vertex + far * facing]
    return Jaw(tuple(line), start, centre, r)


class Quarter(NamedTuple):
    """The quarter in the north-east: where its two rails end, and its holes."""

    east: Jaw
    north: Jaw
    middle: Jaw
    corner: complex
    side: complex


@lru_cache(maxsize=64)
def quarter(length: float, width: float, pockets: Pockets) -> Quarter:
    """ValueError, naming the numbers, if a rail has no room between its pockets."""
    x, y, (corner, side) = 0.5 * length, 0.5 * width, (pockets.corner, pockets.side)
    across, half = corner.width * sqrt(0.5), 0.5 * side.width
    deep = (corner.shelf + corner.hole) * sqrt(0.5) - 0.5 * across
    found = Quarter(
        _jaw(complex(x, y - across), 1j, 1.0, 45.0, corner),
        _jaw(complex(x - across, y), 1.0, 1j, 45.0, corner),
        _jaw(complex(half, y), -1.0, 1j, 90.0, side),
        complex(x + deep, y + deep),
        complex(0.0, y + side.shelf + side.hole),
    )
    if found.east.line[0].imag <= 0.0 or found.north.line[0].real <= found.middle.line[0].real:
        raise ValueError(f"a table of {length!r} by {width!r} has no room for {pockets!r}")
    return found


def check(length: float, width: float, pockets: Pockets, ball: float) -> None:
    """ValueError for what is no Pockets, has no room on such a table, takes no ball, or has a way
    past a hole.

    ball: the radius, m. Beside a hole's middle its centre must be in the hole wherever it fits.
    """
    if not isinstance(pockets, Pockets):
        raise ValueError(f"Table.pockets must be Pockets, not {pockets!r}")
    _check_holes(length, width, pockets)
    for mouth, turn in ((pockets.corner, 45.0), (pockets.side, 90.0)):
        deep, facing = mouth.shelf + mouth.hole, direction(mouth.facing)
        if 0.5 * mouth.width * facing.real <= mouth.shelf * facing.imag + ball:
            raise ValueError(f"no ball of radius {ball!r} reaches the hole of {mouth!r}")
        half = 0.5 * mouth.width - (deep * facing.imag + ball) / facing.real
        towards = direction(turn - mouth.facing)
        rounded = mouth.rounding * towards.imag / (1.0 + towards.real) * facing.real
        if half >= mouth.hole or rounded > deep:
            raise ValueError(f"a ball of radius {ball!r} could pass beside the hole of {mouth!r}")


def _check_holes(length: float, width: float, pockets: Pockets) -> None:
    """ValueError, naming the numbers, if two of the holes overlap."""
    found, corner, side = quarter(length, width, pockets), pockets.corner.hole, pockets.side.hole
    x, y = found.corner.real, found.corner.imag
    across = abs(found.corner - found.side)
    apart = min(x - corner, y - corner, found.side.imag - side, across - corner - side)
    if apart < 0.0:
        raise ValueError(f"on a table of {length!r} by {width!r} the holes of {pockets!r} overlap")


@lru_cache(maxsize=64)
def obstacles(length: float, width: float, pockets: Pockets) -> tuple[Piece, ...]:
    """All that a ball can meet: rails, facings, round noses, holes, and what is behind them."""
    found = quarter(length, width, pockets)
    return (*_rails(found), *_jaws(found), *_holes(found, pockets), *_backs(found))


def _rails(found: Quarter) -> Iterator[Piece]:
    """Two short and four half long ones, the table on their left."""
    for sx, name in ((-1, "west"), (1, "east")):
        north, south = (_mirrored(found.east.line[0], sx, s) for s in (1, -1))
        ends = (south, north) if sx == 1 else (north, south)
        yield Piece("segment", ends, 0.0, name, "rail")
    for sx, sy in QUARTERS:
        ends = (found.north.mirrored(sx, sy).line[0], found.middle.mirrored(sx, sy).line[0])
        yield Piece("segment", ends if sx == sy else ends[::-1], 0.0, place(sx, sy), "rail")


def place(sx: int, sy: int) -> str:
    """Which corner, or end, or side, it is: a direction of the compass."""
    return SIDES.get((sx, sy)) or f"{SIDES[0, sy]}-{SIDES[sx, 0]}"


def _jaws(found: Quarter) -> Iterator[Piece]:
    """Facings, the pocket on their left, and noses that are round; behind these, for balls in the
    air, what a ball passes over that leaves the table there."""
    for sx, sy in QUARTERS:
        corner, side = f"{place(sx, sy)} pocket", f"{place(0, sy)} pocket"
        for jaw, name, left in (
            (found.east, f"{corner}, {place(sx, 0)}", True),
            (found.north, f"{corner}, {place(0, sy)}", False),
            (found.middle, f"{side}, {place(sx, 0)}", True),
        ):
            mine = jaw.mirrored(sx, sy)
            ends = (mine.start, mine.line[-1])
            if mine.start != mine.line[-1]:
                ends = ends if left == (sx == sy) else ends[::-1]
                yield Piece("segment", ends, 0.0, f"{name} facing", "facing")
            if mine.radius > 0.0:
                yield Piece("post", (mine.centre,), mine.radius, f"{name} nose", "nose")
                ends = (mine.line[0], mine.start)
                ends = ends if left == (sx == sy) else ends[::-1]
                yield Piece("segment", ends, 0.0, f"{name} nose, back", "back")


def _holes(found: Quarter, pockets: Pockets) -> Iterator[Piece]:
    for sx, sy in QUARTERS:
        at, name = _mirrored(found.corner, sx, sy), f"{place(sx, sy)} pocket"
        yield Piece("pocket", (at,), pockets.corner.hole, name, "hole")
    for sy in (1, -1):
        at = complex(0.0, sy * found.side.imag)
        yield Piece("pocket", (at,), pockets.side.hole, f"{place(0, sy)} pocket", "hole")


def _backs(found: Quarter) -> Iterator[Piece]:
    """Half circles from facing to facing behind the holes: only balls in the air come there."""
    wide = abs(found.east.line[-1] - found.corner)
    for (sx, sy), start in zip(QUARTERS, (-45.0, 45.0, 135.0, 225.0), strict=True):
        at, name = _mirrored(found.corner, sx, sy), f"{place(sx, sy)} pocket, back"
        yield Piece("arc", (at,), wide, name, "back", start, start + 180.0)
    wide = found.middle.line[-1].real
    for sy, start in ((1, 0.0), (-1, 180.0)):
        at, name = complex(0.0, sy * found.side.imag), f"{place(0, sy)} pocket, back"
        yield Piece("arc", (at,), wide, name, "back", start, start + 180.0)


@lru_cache(maxsize=64)
def outline(length: float, width: float, pockets: Pockets) -> tuple[complex, ...]:
    """The edge of the cushions, anticlockwise from the east; open at the back of the pockets."""
    found: Quarter = quarter(length, width, pockets)
    edge: list[complex] = []
    for sx, sy in QUARTERS:
        east, north, middle = (j.mirrored(sx, sy).line for j in found[:3])
        path = (*east, *north[::-1], *middle)
        edge += path if sx == sy else path[::-1]
    return tuple(edge)
