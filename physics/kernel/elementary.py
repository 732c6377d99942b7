"""Sine, cosine and exponential of our own: those of C libraries differ in the last bit.

Only +, -, * and / are used, which round alike everywhere, and powers of two: so every machine gives
the same bits. The largest errors seen are 0.86 (sine), 0.57 (cosine) and 0.93 (exp) units in the
last place; sources are in docs/accuracy.md, "The same digits everywhere".
"""

from math import floor, inf, ldexp

from .subset import complex, elementary, kernel

RADIANS = 0.017453292519943295  # in a degree, π/180
RADIANS_HEAD, RADIANS_TAIL = 0.017453292519803654, 1.396420652344081e-13  # 36 bits, and the rest
HALF_SQUARE = 0.00015230870989335428  # (π/180)²/2
SQUARE_HEAD, SQUARE_TAIL = 0.00015230849385261536, 2.1604073894322807e-10  # 19 bits, and the rest
LOG_2_HEAD, LOG_2_TAIL = 0.6931471806019545, -4.2009150726810846e-11  # 32 bits, and the rest
TINY = 1e-9  # degrees: so small an angle is its own sine
LEAST, LARGEST = -745.2, 709.782712893384  # whose exponential is above 0, and finite


@elementary
def direction(degrees):
    """The unit vector at an angle, exactly symmetric; NaN for an angle that is not finite."""
    if -TINY < degrees < TINY:
        return complex(1.0, RADIANS * degrees)  # a zero keeps its sign
    angle, under = abs(degrees) % 360.0, degrees < 0.0
    if angle > 180.0:
        angle, under = 360.0 - angle, not under
    back = angle > 90.0
    if back:
        angle = 180.0 - angle
    if angle > 45.0:
        y, x = octant(90.0 - angle)
    else:
        x, y = octant(angle)
    return complex(-x if back else x, -y if under else y)


@kernel
def octant(angle):
    """(cosine, sine) of 0 to 45 degrees, to which all others have been folded without rounding.

    The first terms, x and 1 - x²/2, are split: their larger parts are exact.
    """
    shifted = 68719476737.0 * angle
    head = shifted - (shifted - angle)  # 17 bits
    rest, z, square = angle - head, angle * angle, head * head
    bend = (2.2166642478572946e-33 * z - 1.1467578916443701e-27) * z + 4.1412665753045067e-22
    bend = ((bend * z - 9.788384855855388e-17) * z + 1.3496016231614387e-11) * z
    tail = RADIANS_HEAD * rest + angle * (RADIANS_TAIL + z * (bend - 8.86096155701296e-07))
    sine = RADIANS_HEAD * head + tail
    bend = (-2.764705408033331e-36 * z + 1.6678997783006337e-30) * z - 7.2278738866763975e-25
    bend = ((bend * z + 2.1354943025535338e-19) * z - 3.925831985738925e-14) * z
    tail = HALF_SQUARE * rest * (angle + head) + SQUARE_TAIL * square
    drop = SQUARE_HEAD * square
    near = 1.0 - drop
    return near + ((1.0 - near) - drop - tail + z * z * (bend + 3.866323851562987e-09)), sine


@kernel
def sin(degrees):
    """The sine of an angle in degrees."""
    return direction(degrees).imag


@kernel
def cos(degrees):
    """The cosine of an angle in degrees."""
    return direction(degrees).real


@elementary
def exp(x):
    """The exponential; inf beyond the largest number."""
    if not LEAST < x <= LARGEST:
        return 0.0 if x < 0.0 else x + inf  # a NaN stays one
    power = floor(1.4426950408889634 * x + 0.5)
    high, low = x - LOG_2_HEAD * power, LOG_2_TAIL * power
    rest = high - low
    z = rest * rest
    bend = (4.136059524709483e-08 * z - 1.6533837541091572e-06) * z + 6.61375625054828e-05
    bend = rest - z * ((bend * z - 0.0027777777776698265) * z + 0.16666666666666555)
    size = 1.0 - (low - rest * bend / (2.0 - bend) - high)
    # below 1e-308 the product is what rounds: not every C library rounds what it shifts
    return ldexp(size, power) if power > -1000 else ldexp(size, power + 128) * 2.0**-128
