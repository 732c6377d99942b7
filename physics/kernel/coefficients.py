"""Coefficients of a law that change with speed: linearly, and never below 0 nor above 1.

In a rule they stand as they are at no speed; most have no slope, and then cost one comparison.
"""

from .subset import kernel


@kernel
def fraction(value, slope, speed):
    """So much of it at that speed."""
    share = value + slope * speed
    return 0.0 if share < 0.0 else 1.0 if share > 1.0 else share


@kernel
def restitution(closing, rule):
    """What comes back of a closing speed along the contact's normal."""
    if rule.restitution_slope != 0.0:
        return fraction(rule.restitution, rule.restitution_slope, closing)
    return rule.restitution


@kernel
def roughness(speed, rule):
    """The friction at a cushion that is met with that speed along the contact's normal, or between
    balls that slip with it."""
    if rule.friction_slope != 0.0:
        return fraction(rule.friction, rule.friction_slope, speed)
    return rule.friction
