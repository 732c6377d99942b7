"""Euler and Runge-Kutta on the equations of motion, as a textbook has them.

Friction is evaluated at the step's start, or at its four stages; where it would reverse the
slip or the ball within the step, the slip or the ball stops at the step's end. Between such points
the motion is quadratic in time, so Euler is of order 1 there and Runge-Kutta exact; through them,
and through contacts, both are of order 1.
"""

from collections.abc import Callable
from functools import partial
from math import inf
from typing import Any, NamedTuple

from physics.engines.engine import Movable
from physics.kernel.kinds import PHASES, ROLLING
from physics.kernel.motion import faded, motion

from .overlap import bring, catch_up, contacts, end_phase, kept, launch, mark, touching

HALVINGS = 50  # of a step: to the last digits of the time of contact


class Variables(NamedTuple):
    """Where a ball is, how fast, and at what velocity it would roll; or how fast these change."""

    position: complex
    velocity: complex
    roll: complex

    def plus(self, h: float, rate: "Variables") -> "Variables":
        """The motion h seconds on, at this rate of change."""
        return Variables(
            self.position + h * rate.position,
            self.velocity + h * rate.velocity,
            self.roll + h * rate.roll,
        )


Rate = Callable[[Variables], Variables]
Integrator = Callable[[Variables, float, Rate], Variables]


def friction(cloth: Any, now: Variables) -> Variables:
    """The rate of change of a ball's motion on the cloth."""
    phase, a, _ = motion(now.velocity, now.roll, cloth)
    return Variables(now.velocity, a, a if phase == ROLLING else -2.5 * a)


def euler(now: Variables, h: float, rate: Rate) -> Variables:
    """One step with the rate at its start: order 1."""
    return now.plus(h, rate(now))


def rk4(now: Variables, h: float, rate: Rate) -> Variables:
    """One step with the classical four stages: order 4."""
    first = rate(now)
    second = rate(now.plus(0.5 * h, first))
    third = rate(now.plus(0.5 * h, second))
    fourth = rate(now.plus(h, third))
    return now.plus(h / 6, first).plus(h / 3, second).plus(h / 3, third).plus(h / 6, fourth)


def start(world: Movable, disturbed: list[int]) -> None:
    """Placed or pushed balls, and all others with them, are at a step's start."""
    catch_up(world)
    for i in disturbed:
        launch(world.scene.balls[i], world.scene.cloth)
    for i, ball in enumerate(world.scene.balls):
        if not PHASES[ball.phase].lies or i in disturbed:
            mark(world, i)


def trial(ball: Any, h: float, cloth: Any, integrator: Integrator) -> Variables:
    """The ball's motion h seconds after its step's start."""
    if PHASES[ball.phase].lies or h == 0.0:
        return Variables(ball.position, ball.velocity, ball.roll)
    rate = partial(friction, cloth)
    return integrator(Variables(ball.position, ball.velocity, ball.roll), h, rate)


def move(world: Movable, time: float, integrator: Integrator) -> None:
    """Move all balls to `time`."""
    cloth = world.scene.cloth
    for i, ball in enumerate(world.scene.balls):
        if PHASES[ball.phase].lies:
            continue
        h = time - ball.since
        ball.position, ball.velocity, ball.roll = trial(ball, h, cloth, integrator)
        ball.side = faded(ball.side, h * ball.radius * cloth.fade)
        ball.since = time
        if ball.leg_end > time:
            launch(ball, cloth)
            continue
        bring(world, time, i)
        # sliding friction leaves this sum as it is: the speed at which the ball will roll
        ball.velocity = (5 * ball.velocity + 2 * ball.roll) / 7
        end_phase(world, time, i)


def substep(world: Movable, time: float, ahead: float, k: int, integrator: Integrator) -> None:
    """Motion up to `time`, then the contacts that it has led to."""
    move(world, time, integrator)
    contacts(world, time)
    if kept(k, ahead):
        for i, ball in enumerate(world.scene.balls):
            if not PHASES[ball.phase].lies:
                mark(world, i)


def located(world: Movable, time: float, ahead: float, k: int) -> None:
    """Runge-Kutta; and a contact due within the step to come ends that step where it happens."""
    substep(world, time, ahead, k, rk4)
    for ball in world.scene.balls:
        ball.next = inf
    if not touches(world, ahead):
        return
    low, high = time, time + ahead
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if touches(world, middle - time) else (middle, high)
    world.scene.balls[0].next = high


def touches(world: Movable, h: float) -> bool:
    """Will anything overlap and approach h seconds after the step's start?"""
    there = [trial(ball, h, world.scene.cloth, rk4) for ball in world.scene.balls]
    spots = [ball.position for ball in there]
    return any(touching(world.scene, spots, lambda i: there[i].velocity))
