"""The scenes in pymunk: discs seen from above, with rolling friction by a function of velocity."""

from collections.abc import Callable
from importlib.metadata import version
from typing import Any

import pymunk

from physics import World

from .peers import MASS, RADIUS, Cut, Peer

STEPS = (180, 1000)  # a second
ROLL = 0.01 * 9.8  # m/s²
CUSHION, BALL = 0.9, 0.95
FAR = 10.0  # m: walls are segments, so they need an end


def rolling(body: Any, gravity: Any, damping: float, dt: float) -> None:
    """Constant deceleration, as rolling friction has it."""
    speed = body.velocity.length
    body.velocity = body.velocity * max(0.0, 1.0 - ROLL * dt / speed) if speed else (0.0, 0.0)


def disc(space: Any, at: complex, v: complex, radius: float, mass: float) -> Any:
    body = pymunk.Body(mass, pymunk.moment_for_circle(mass, 0.0, radius))
    body.position, body.velocity = (at.real, at.imag), (v.real, v.imag)
    shape = pymunk.Circle(body, radius)
    # pymunk multiplies the two elasticities; a cushion of CUSHION / BALL gives CUSHION
    shape.elasticity = BALL**0.5
    space.add(body, shape)
    return body


def space_of(world: World, rolls: bool) -> Any:
    """The same balls and walls; contacts may overlap by less than pymunk allows by default."""
    space = pymunk.Space()
    space.collision_slop = 1e-5
    for wall in world.walls:
        foot = wall.offset * wall.normal
        along = 1j * FAR * wall.normal
        thick = 0.5
        a, b = foot + along - thick * wall.normal, foot - along - thick * wall.normal
        rail = pymunk.Segment(space.static_body, (a.real, a.imag), (b.real, b.imag), thick)
        rail.elasticity = CUSHION / BALL**0.5
        space.add(rail)
    for ball in world.balls:
        p, v = complex(*ball.position), complex(*ball.velocity)
        body = disc(space, p, v, ball.radius, ball.mass)
        if rolls:
            body.velocity_func = rolling
    return space


def player(rate: int, rolls: bool) -> Callable[[Callable[[], World], float], Callable[[], None]]:
    def play(make: Callable[[], World], rests: float) -> Callable[[], None]:
        def run() -> None:
            space = space_of(make(), rolls)
            for _ in range(int(rests * rate)):
                space.step(1.0 / rate)

        return run

    return play


def cutter(rate: int) -> Callable[[Cut], complex]:
    def cut(shot: Cut) -> complex:
        space = pymunk.Space()
        space.collision_slop = 1e-5
        disc(space, shot.start, shot.velocity, RADIUS, MASS)
        target = disc(space, 0j, 0j, RADIUS, MASS)
        for _ in range(rate):
            space.step(1.0 / rate)
            if target.velocity.length > 0.0:
                break
        return complex(*target.velocity)

    return cut


def peers() -> list[Peer]:
    name = f"pymunk {version('pymunk')}"
    found = [Peer(f"{name}, 1/{rate} s", player(rate, True), cutter(rate)) for rate in STEPS]
    # to show how much of that is the function in Python
    return [*found, Peer(f"{name}, 1/{STEPS[0]} s, on ice", player(STEPS[0], False), None)]
