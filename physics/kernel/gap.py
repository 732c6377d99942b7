"""How far a ball gets from a cushion before it meets it again."""

from .leg import travelled
from .obstacle import LINE, clearance, farthest
from .subset import inf, kernel

LEFT = 1e-3  # m: a ball that has come no farther from a cushion has not left it (docs/physics.md)
LOOKS = 16  # how often a path is looked at for the part of it that is farthest away
TURNS = 48  # of the search within that part
GOLDEN = 0.6180339887498949


@kernel
def greatest(wall, p, v, a, t):
    """The greatest distance of a point on that path within t, to 1e-9 of the path: golden section,
    around the farthest of some looks."""
    best, most = 0.0, -inf
    for k in range(LOOKS + 1):
        far = clearance(wall, travelled(p, v, a, k * t / LOOKS), 0.0)
        if far > most:
            best, most = k * t / LOOKS, far
    low, high = max(0.0, best - t / LOOKS), min(t, best + t / LOOKS)
    for _ in range(TURNS):
        first, second = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        here = clearance(wall, travelled(p, v, a, first), 0.0)
        if here < clearance(wall, travelled(p, v, a, second), 0.0):
            low = first
        else:
            high = second
    return clearance(wall, travelled(p, v, a, 0.5 * (low + high)), 0.0)


@kernel
def leaves(wall, p, v, a, t, radius):
    """Does a ball leave the wall on that path?  Nearly always one of its ends says so."""
    if clearance(wall, p, radius) > LEFT or clearance(wall, travelled(p, v, a, t), radius) > LEFT:
        return True
    if wall.kind == LINE:
        return farthest(wall, p, v, a, t) - radius > LEFT
    return greatest(wall, p, v, a, t) - radius > LEFT
