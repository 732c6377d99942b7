"""How far a path gets from what is convex, where that is known without a search."""

from .kernel.leg import travelled
from .kernel.motion import length
from .kernel.obstacle import ARC, SEGMENT, Shape, clearance

STRAIGHT = 1e-12  # m: a path that bends by no more is straight


def known_farthest(shape: Shape, p: complex, v: complex, a: complex, t: float) -> float | None:
    """The greatest distance, m, of a path from an obstacle within t seconds, or None.

    p, v, a: its start, m, velocity and acceleration.
    """
    if shape.kind == SEGMENT:
        low, high = _range(1j * shape.inward, p - shape.first, v, a, t)
        near, far = _range(shape.inward, p - shape.first, v, a, t)
        if low >= 0.0 and high <= shape.size and near >= 0.0:
            return far  # in front of it all the way, where it is a line
    bend = _bend(v, a, t) if shape.kind != ARC else None  # an arc is not convex
    if bend is None:
        return None
    # the distance from what is convex is greatest at an end of a straight path
    spots = (p, travelled(p, v, a, t), travelled(p, v, a, bend))
    return max(float(clearance(shape, spot, 0.0)) for spot in spots)


def _range(n: complex, p: complex, v: complex, a: complex, t: float) -> tuple[float, float]:
    """The least and the greatest of (n q).real for the points q of a path."""
    start, speed, pull = (n * p).real, (n * v).real, (n * a).real
    ends = [start, start + t * (speed + 0.5 * pull * t)]
    if pull and 0.0 < -speed / pull < t:
        ends.append(start - 0.5 * speed * speed / pull)
    return min(ends), max(ends)


def _bend(v: complex, a: complex, t: float) -> float | None:
    """When within t a path turns back, or 0; None if it curves by more than the rounding of it."""
    speed = length(v)
    if not speed or abs((v.conjugate() * a).imag) * t * t > STRAIGHT * speed:
        return None if a else 0.0
    back = -(v.conjugate() * a).real
    return float(speed * speed / back) if speed * speed < back * t else 0.0
