"""A cushion that is a spring along its face too: Stronge's compliant law, integrated.

Stronge, Impact Mechanics (2000), ch. 5. In units of the normal stroke's frequency the push is half
a sine, whose second part is e times as long; the face gives way sideways with `frequency`, up to
Coulomb's limit. The picture is that of laws: the wall is x = 0, the table x > 0; see laws.py.
"""

from math import pi, sin, sqrt

STEPS = 2000


def impulses(slip, closing, e, mu, frequency):
    """(push, rub) per mass, from the slip (along, upward) and closing speed at the contact."""
    push, rub, bent, dt = 0.0, 0j, 0j, 0.5 * pi * (1.0 + e) / STEPS
    stiff = frequency * frequency / 3.5
    for k in range(STEPS):
        t = (k + 0.5) * dt
        phase = t if t < 0.5 * pi else 0.5 * pi * (1.0 - 1.0 / e) + t / e
        press = closing * sin(phase)
        bent += dt * (slip + 3.5 * rub)
        most = mu * press / stiff
        if abs(bent) > most:
            bent *= most / abs(bent)
        push += dt * press
        rub -= dt * stiff * bent
    return push, rub


def stronge(v, roll, side, e, mu, nose, frequency=1.7):
    """v, roll and side after the hit, as a cushion law returns them."""
    height = nose - 1.0
    level = sqrt(1.0 - height * height)
    slip = complex(v.imag + height * roll.imag - level * side, height * v.real + roll.real)
    push, rub = impulses(slip, -level * v.real, e, mu, frequency)
    v += complex(level * push + height * rub.imag, rub.real)
    return v, roll + 2.5 * complex(rub.imag, height * rub.real), side - 2.5 * level * rub.real
