"""Derivatives through contacts that last: against central differences of the plain kernel."""

import numpy as np
import pytest

from physics import Ball, Shot, sensitivity, simulate, tables

STEP = 1e-6  # m/s or degrees: by this the differences are right to
ROUNDING = 1e-5  # of the greatest
COLUMNS = range(5)


def frozen(turn):
    """A ball, and two that touch each other beyond it, not quite in a row."""
    world = tables.medium_carom()
    reach = 2.0 * tables.MEDIUM_CAROM.radius
    near = 0.2 + 0.0j
    far = near + reach * complex(np.cos(turn), np.sin(turn))
    world.add(Ball("white", (-0.5, 0.01)))
    world.add(Ball("red", (near.real, near.imag)))
    world.add(Ball("yellow", (far.real, far.imag)))
    return world


def differences(world, numbers, column):
    """(balls, 2) of where the balls rest; None if the events are others on the two sides."""
    ends, logs = [], []
    for sign in (1.0, -1.0):
        shot = np.array(numbers)
        shot[column] += sign * STEP
        after = simulate(world, "white", Shot(*shot))
        ends.append(np.array([ball.position for ball in after.balls]))
        logs.append([(event.kind, event.balls, event.wall) for event in after.log])
    return (ends[0] - ends[1]) / (2.0 * STEP) if logs[0] == logs[1] else None


LASTING = [(0.5, -0.1), (2.0, -0.1), (0.5, -0.2), (2.0, -0.2), (5.0, -0.2)]


@pytest.mark.parametrize(("follow", "turn"), LASTING)
def test_balls_that_stay_pressed_together_have_the_derivatives_of_differences(follow, turn):
    world, numbers = frozen(turn), (2.0, 0.0, follow, 0.0, 0.2)
    found = sensitivity(world, "white", Shot(*numbers))
    lasting = [raw for raw in found.world.log._events if raw[-1] and raw[-1][3]]
    assert lasting, "no contact lasts"
    for column in COLUMNS:
        slopes = differences(world, numbers, column)
        assert slopes is not None
        error = abs(slopes - found.rest[:, :, column]).max()
        assert error < ROUNDING * abs(slopes).max(), (column, error)
