"""Where on a table only the long walls matter: a part of it in front of which nothing stands."""

from functools import lru_cache
from itertools import pairwise
from math import fsum, inf

from .kernel.body import Scene
from .kernel.motion import length
from .kernel.obstacle import ARC, LINE, POCKET, POST, SEGMENT, Shape, beside
from .room import cut

FAR = 1e6  # m: what is farther away is not asked about
ALONG = 1e-12  # m: what reaches no farther in front of a line is along it


def framed(scene: Scene) -> Scene:
    """The scene as its walls and balls are now."""
    lines = all(wall.kind == LINE for wall in scene.walls)
    if lines and scene.lines:
        return scene
    smallest = min((ball.radius for ball in scene.balls), default=0.0)
    return scene._replace(lines=lines, frame=() if lines else frame(tuple(scene.walls), smallest))


@lru_cache(maxsize=64)
def frame(walls: tuple[Shape, ...], radius: float) -> tuple[int, ...]:
    """The sides of a part of the table in which no ball of that radius or more meets anything but
    them: of each, how many walls it has, and their numbers.  Empty if there is none.

    Walls of one line are one side; the longest are taken until all else is behind one of them.
    """
    sides: dict[tuple[complex, float], list[int]] = {}
    for k, wall in enumerate(walls):
        if wall.kind in (LINE, SEGMENT):
            sides.setdefault((wall.normal, wall.offset), []).append(k)
    longest = sorted(sides.values(), key=lambda side: -fsum(_length(walls[k]) for k in side))
    left, found = [wall for wall in walls if wall.kind not in (LINE, POCKET)], []
    holes = [wall for wall in walls if wall.kind == POCKET]
    corners = [FAR * 1j**k for k in range(4)]
    for side in longest:
        found += [len(side), *side]
        left = [wall for wall in left if _in_front(wall, walls[side[0]])]
        corners = cut(corners, [_ahead(walls[side[0]], p) - radius for p in corners])
        if not left and all(_far_from(corners, hole) for hole in holes):
            return tuple(found) if len(corners) > 2 else ()
    return ()


def _length(wall: Shape) -> float:
    return wall.size if wall.kind == SEGMENT else inf


def _in_front(wall: Shape, side: Shape) -> bool:
    """Is any of it in front of that line?"""
    if wall.kind == POST:
        return _ahead(side, wall.centre) + wall.size > ALONG
    far = max(_ahead(side, wall.first), _ahead(side, wall.last))
    if wall.kind == ARC and beside(wall, wall.centre + wall.size * side.normal):
        far = _ahead(side, wall.centre) + wall.size
    return far > ALONG


def _ahead(side: Shape, p: complex) -> float:
    """How far the point is in front of the line that the side lies on."""
    return (side.inward * p).real - side.offset


def _far_from(corners: list[complex], hole: Shape) -> bool:
    """Is all of the polygon outside the hole?"""
    if not corners:
        return True
    sides = pairwise([*corners, corners[0]])
    far = min(length(_nearest(p, q, hole.centre) - hole.centre) for p, q in sides)
    return bool(far > hole.size + ALONG) and not _contains(corners, hole.centre)


def _nearest(p: complex, q: complex, to: complex) -> complex:
    """The point between p and q that is nearest."""
    way = q - p
    square = way.real * way.real + way.imag * way.imag
    part = (way.conjugate() * (to - p)).real / square if square > 0.0 else 0.0
    return p + min(1.0, max(0.0, part)) * way


def _contains(corners: list[complex], p: complex) -> bool:
    """Is the point inside the polygon, which is anticlockwise?"""
    return all(
        ((b - a).conjugate() * (p - a)).imag >= 0.0 for a, b in pairwise([*corners, corners[0]])
    )
