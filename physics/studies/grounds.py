"""What lies under a picture: the cloth, as far as walls bound it, and the rails of a table."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import fsum

from physics.engines.engine import Movable
from physics.room import inside
from physics.wall import Obstacle, Wall

RAIL = 0.07  # m: the rail around the noses of the cushions
PLANE = 10.0  # m: the table, as far as no wall bounds it
JOINED = 1e-6  # m: walls whose ends are no farther apart go on into each other
INK, CLOTH, WOOD, NOSE = "#1C222B", "#DFEAEF", "#C9AE94", "#5C3B27"
FILLED = {"pocket": INK, "post": WOOD}


def layers(world: Movable) -> list[tuple[str, str, list[complex]]]:
    """Fill, edge and corners of what is drawn first: rails, if there are any, and the cloth."""
    cloth = CLOTH, NOSE, outline(world)
    return [(WOOD, WOOD, outline(world, RAIL)), cloth] if railed(world) else [cloth]


def railed(world: Movable) -> bool:
    """Do rails stand around it, or behind each line: those of lines, or a whole table's?"""
    pieces = getattr(world.table, "obstacles", ())
    lines = any(isinstance(wall, Wall) for wall in world.walls)
    return lines or not world.walls or 0 < len(pieces) <= len(world.walls)


def outline(world: Movable, out: float = 0.0) -> list[complex]:
    """The corners of the cloth: of what lies inside all lines, or of a table's box, moved out by so
    many metres; else inside the largest ring of walls, or without end where there is none."""
    lines = [wall for wall in world.walls if isinstance(wall, Wall)]
    if lines or not world.walls:
        return inside(lines, PLANE, out)
    if not railed(world):
        return max(rings(world.walls), key=_area, default=inside([], 100.0 * PLANE))
    west, east, south, north = box(world.walls)
    far = complex(out, out)
    first, last = complex(west, south) - far, complex(east, north) + far
    return [first, complex(last.real, first.imag), last, complex(first.real, last.imag)]


def box(walls: Sequence[Obstacle]) -> tuple[float, float, float, float]:
    """West, east, south, north of all that is no line."""
    spots = [spot for wall in walls for spot in wall.curve()]
    xs, ys = [p.real for p in spots], [p.imag for p in spots]
    return min(xs), max(xs), min(ys), max(ys)


def rings(walls: Sequence[Obstacle]) -> Iterator[list[complex]]:
    """Corners of what segments and arcs close around, each beginning where another one ends."""
    left = [[*wall.curve()] for wall in walls if wall.kind not in FILLED and wall.curve()]
    while left:
        way = left.pop()
        while not _closed(way) and (more := _next(way[-1], left)):
            way += more
        if _closed(way):
            yield way


def _next(end: complex, left: list[list[complex]]) -> list[complex]:
    """The wall that goes on from there, taken out of those that are left; empty if none does."""
    for k, curve in enumerate(left):
        for way in (curve, curve[::-1]):
            if abs(way[0] - end) <= JOINED:
                del left[k]
                return way
    return []


def _closed(way: list[complex]) -> bool:
    return len(way) > 2 and abs(way[-1] - way[0]) <= JOINED


def _area(corners: list[complex]) -> float:
    return abs(fsum((p.conjugate() * q).imag for p, q in pairwise([*corners, corners[0]])))
