"""How near a ball comes to an obstacle between two events: the least clearance on a whole path.

A path is a parabola, so the moments at which the clearance may be least are roots of polynomials.
They are found apart from the kernel's own search for contacts, which they are to check.
"""

from collections.abc import Iterator

import numpy as np

from physics.kernel import obstacle
from physics.kernel.leg import travelled
from physics.kernel.obstacle import ARC, LINE, SEGMENT, Shape

Path = tuple[complex, complex, complex]  # place, velocity and acceleration: m and s


def least(wall: Shape, path: Path, lasts: float, radius: float) -> float:
    """The least clearance, m, of a ball on that path for `lasts` seconds; below 0 if it was in the
    obstacle, or passed through it."""
    times = [0.0, lasts]
    times += [float(t) for poly in turns(wall, path) for t in _roots(poly) if 0.0 < t < lasts]
    return min(float(obstacle.clearance(wall, travelled(*path, t), radius)) for t in times)


def _roots(poly: list[float]) -> list[float]:
    return [float(root.real) for root in np.roots(poly)]  # a moment too many does no harm


def turns(wall: Shape, path: Path) -> Iterator[list[float]]:
    """The polynomials, highest power first, whose roots are the moments that matter."""
    if wall.kind == LINE:
        yield _slope(_along(path, wall.inward, wall.offset))
        return
    if wall.kind in (SEGMENT, ARC):
        yield _approach(path, wall.first)
        yield _approach(path, wall.last)
    if wall.kind == SEGMENT:
        far = _along(path, wall.inward, wall.offset)
        beside = _along(path, 1j * wall.inward, (1j * wall.inward * wall.first).real)
        yield from (far, _slope(far), beside)
        yield [*beside[:2], beside[2] + wall.size]
        yield [*beside[:2], beside[2] - wall.size]
        return
    yield _approach(path, wall.centre)
    if wall.kind == ARC:
        yield _distance(path, wall.centre, wall.size)
        for end in (wall.first, wall.last):
            across = 1j * (end - wall.centre).conjugate()
            yield _along(path, across, (across * wall.centre).real)


def _along(path: Path, inward: complex, offset: float) -> list[float]:
    """(inward * place).real - offset."""
    p, v, a = path
    return [0.5 * (inward * a).real, (inward * v).real, (inward * p).real - offset]


def _slope(poly: list[float]) -> list[float]:
    return [2.0 * poly[0], poly[1]]


def _approach(path: Path, spot: complex) -> list[float]:
    """Half the derivative of the distance's square."""
    p, v, a = path
    q = p - spot
    return [
        0.5 * abs(a) ** 2, 1.5 * (v.conjugate() * a).real,
        abs(v) ** 2 + (q.conjugate() * a).real, (q.conjugate() * v).real,
    ]  # fmt: skip


def _distance(path: Path, spot: complex, reach: float) -> list[float]:
    """The distance's square, less that of `reach`."""
    p, v, a = path
    q = p - spot
    return [
        0.25 * abs(a) ** 2, (v.conjugate() * a).real, abs(v) ** 2 + (q.conjugate() * a).real,
        2.0 * (q.conjugate() * v).real, abs(q) ** 2 - reach * reach,
    ]  # fmt: skip
