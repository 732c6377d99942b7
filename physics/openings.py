"""Where a ball rolls out of a table that does not close.

Walls without a `Table` are a table if they face one another: its inside is the smallest convex area
that holds them and the pockets. A side of that area along which no wall runs is open, and a ball
that leaves through it is off the table. Lines have no ends, so they leave no gaps; a wall by
itself, or a corner, has no inside.
"""

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

from .kernel.body import Scene
from .kernel.motion import length
from .kernel.obstacle import ARC, LINE, SEGMENT, Shape, unit
from .wall import Segment

SAME = 1e-9  # m: points that are no farther apart are one, and on a line if no farther from it
PARALLEL = 1e-9  # radians
HALVINGS = 4  # of the directions along what is round

Side = tuple[complex, complex]  # its ends


def bounded(scene: Scene, closed: bool) -> Scene:
    """The scene with the openings of its table; with none if it is known to be closed."""
    if closed or scene.lines:
        return scene._replace(openings=()) if scene.openings else scene
    return scene._replace(openings=openings(tuple(scene.walls)))


@lru_cache(maxsize=64)
def openings(walls: tuple[Shape, ...]) -> tuple[Shape, ...]:
    """The open sides of the table that these walls make, as segments with the table on their left:
    none if it closes, or if there is no table."""
    kinds = {wall.kind for wall in walls}
    if LINE in kinds or not kinds & {SEGMENT, ARC}:
        return ()
    standing, gaps = _sides([wall for wall in walls if wall.kind in (SEGMENT, ARC)])
    if not gaps or not _face_one_another(standing):
        return ()
    _, free = _sides(walls)
    return tuple(Segment((a.real, a.imag), (b.real, b.imag)).shape for a, b in free)


def _sides(walls: Sequence[Shape]) -> tuple[list[Side], list[Side]]:
    """The sides of the smallest convex area that holds them, anticlockwise: those along which one
    of them runs, and those that are free."""
    links = [link for wall in walls for link in _links(wall)]
    known = _merged([p for link in links for p in link])
    joined = {(known[a], known[b]) for a, b in links}
    joined |= {(b, a) for a, b in joined}
    around = _around(sorted({*known.values()}, key=_westward))
    taken = [side for side in around if side in joined]
    return taken, [side for side in around if side not in joined]


def _links(wall: Shape) -> list[Side]:
    """What it is as straight pieces; those of what is round touch it from outside."""
    if wall.kind == SEGMENT:
        return [(wall.first, wall.last)]
    ways = [1 + 0j, 1j, -1 + 0j, -1j, 1 + 0j]
    if wall.kind == ARC:
        first, last = unit(wall.first - wall.centre), unit(wall.last - wall.centre)
        ways = [first, wall.middle, last] if wall.span >= -1.0 else [first * way for way in ways]
    for _ in range(HALVINGS):
        ways = [way for u, v in pairwise(ways) for way in (u, unit(u + v))] + ways[-1:]
    sums = [u + v for u, v in pairwise(ways)]
    outer = [wall.centre + 2.0 * wall.size / (s.conjugate() * s).real * s for s in sums]
    ends = [wall.first, wall.last] if wall.kind == ARC else [outer[0], outer[0]]
    return [*pairwise([ends[0], *outer, ends[1]])]


def _merged(points: list[complex]) -> dict[complex, complex]:
    """For each point itself, or another one in the same place that stands for it."""
    known: dict[complex, complex] = {}
    kept: list[complex] = []
    for p in sorted(points, key=_westward):
        known[p] = p
        for q in reversed(kept):
            if p.real - q.real > 2.0 * SAME:
                kept.append(p)
                break
            if length(p - q) <= SAME:
                known[p] = q
                break
        else:
            kept.append(p)
    return known


def _westward(p: complex) -> tuple[int, float]:
    return round(p.real / SAME), p.imag


def _lower(points: list[complex]) -> list[complex]:
    """The lower side of it, from west to east."""
    chain: list[complex] = []
    for p in points:
        while len(chain) > 1 and _left_of(chain[-2], p, chain[-1]) > -SAME:
            chain.pop()
        chain.append(p)
    return chain


def _around(points: list[complex]) -> list[Side]:
    """The sides of the smallest convex area that holds these points, which are ordered from west to
    east, from one of them to the next, anticlockwise: none if it is as thin as a line."""
    corners = _lower(points)[:-1] + [-p for p in _lower([-p for p in points[::-1]])[:-1]]
    found = []
    for a, b in pairwise([*corners, *corners[:1]]):
        if max(_left_of(a, b, p) for p in corners) > 2.0 * SAME:
            found += [*pairwise(_along(a, b, points))]
    return found


def _along(a: complex, b: complex, points: list[complex]) -> list[complex]:
    """a, the points on the way to b, and b."""
    back = (b - a).conjugate()
    on = [p for p in points if p not in (a, b) and abs(_left_of(a, b, p)) <= 2.0 * SAME]
    between = [p for p in on if 0.0 < (back * (p - a)).real < (back * (b - a)).real]
    return [a, *sorted(between, key=lambda p: float((back * p).real)), b]


def _left_of(a: complex, b: complex, p: complex) -> float:
    """How far to the left of the way from a to b the point is."""
    way = b - a
    return float((way.conjugate() * (p - a)).imag / length(way))


def _face_one_another(sides: list[Side]) -> bool:
    """Is there no direction that leads away from all these, which go around anticlockwise?"""
    ways = [unit(b - a) for a, b in sides]
    turns = [a.conjugate() * b for a, b in pairwise([*ways, *ways[:1]])]
    half = all(turn.imag >= -PARALLEL for turn in turns)  # none of them more than that
    return half and any(turn.imag > PARALLEL or turn.real < 0.0 for turn in turns)
