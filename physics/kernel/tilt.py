"""Two balls that touch on the cloth: how far apart they are, and how their line of centres tilts.

Balls of radii r and R touch where their centres are r + R apart in space. The bigger ball's centre
is higher, so over the table they are then only 2 √(r R) apart. `lift` is how high a centre is: it
is the same for balls of one size and for all discs, which touch level and r + R apart.
"""

from .subset import complex, kernel, sqrt


@kernel
def touching_distance(a, b):
    """How far apart, over the table, two balls are that lie on the cloth and touch."""
    if a.lift == b.lift:
        return a.radius + b.radius
    return 2.0 * sqrt(a.radius * b.radius)


@kernel
def between(a, b, offset):
    """How far their centres are from each other in space, at that offset over the table."""
    rise = b.lift - a.lift
    return sqrt(offset.real * offset.real + offset.imag * offset.imag + rise * rise)


@kernel
def tilt(a, b):
    """The direction from a to b, of length 1, when they do so: (along the table, upward)."""
    if a.lift == b.lift:
        return 1.0, 0.0
    far = a.radius + b.radius
    return touching_distance(a, b) / far, (b.lift - a.lift) / far


@kernel
def levelled(a, b, roll, side):
    """Summed roll and side, with b towards +x, turned about y until that direction is level."""
    level, rise = tilt(a, b)
    return complex(roll.real, level * roll.imag - rise * side), level * side + rise * roll.imag
