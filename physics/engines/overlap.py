"""Contacts noticed on a grid of times: two things overlap, and still approach each other."""

from collections.abc import Callable, Iterator
from typing import Any

from physics.engines.engine import Movable
from physics.kernel.body import Scene
from physics.kernel.kinds import CUSHION, DROP, LEAVE, OFF, PAIR, REST, RESTING, ROLL
from physics.kernel.laws import hit_ball, hit_wall, law_at
from physics.kernel.leg import begin, carry, end, place
from physics.kernel.obstacle import NOBODY, POCKET, clearance, facing
from physics.kernel.opening import just_left
from physics.kernel.tilt import between

KEEP = 1 / 2000  # s between legs in the log: every leg of a finer grid would fill the memory


def launch(ball: Any, cloth: Any) -> None:
    """How friction moves the ball from now on, and until when, if it meets nothing."""
    ball.leg_end = ball.next = ball.since + begin(ball, cloth)


def catch_up(world: Movable) -> None:
    """Bring every ball along its leg to now: a new grid begins with all of them."""
    for ball in world.scene.balls:
        if ball.phase >= RESTING:
            carry(ball, world.now, world.scene.cloth)


def mark(world: Movable, i: int) -> None:
    """Enter in the log the leg that ball i is on."""
    world.log.begin(i, world.epoch, world.scene.balls[i], world.scene.cloth.fade)


def kept(k: int, dt: float) -> bool:
    """Do the legs that begin at the k-th grid time go into the log?"""
    return k % max(1, int(KEEP / dt)) == 0


def note(world: Movable, time: float, kind: int, i: int, other: int) -> None:
    """Enter in the log what has happened, after the new legs."""
    world.log.note(world.epoch, time, kind, i, other)


def end_phase(world: Movable, time: float, i: int) -> None:
    """Ball i, at `time` already, stops sliding or rolling."""
    ball = world.scene.balls[i]
    end(ball, ROLL)
    launch(ball, world.scene.cloth)
    mark(world, i)
    note(world, time, REST if ball.phase == RESTING else ROLL, i, -1)


def touching(
    scene: Scene, spots: list[complex], speed: Callable[[int], complex]
) -> Iterator[tuple[int, int, int]]:
    """(PAIR, ball, ball), (CUSHION, ball, wall), (DROP, ball, pocket) or (LEAVE, ball, opening), in
    order, where two overlap and approach.

    The balls are at `spots`; ball i's velocity is speed(i), asked each time: a contact found here
    may have changed it by then.
    """
    balls = scene.balls
    for i, (ball, p) in enumerate(zip(balls, spots, strict=True)):
        if ball.phase >= OFF:
            continue
        for j in range(i + 1, len(balls)):
            if balls[j].phase >= OFF:
                continue
            line, reach = spots[j] - p, ball.radius + balls[j].radius
            if (
                line.real * line.real + line.imag * line.imag <= reach * reach
                and (line.conjugate() * (speed(i) - speed(j))).real > 0.0
                and (ball.lift == balls[j].lift or between(ball, balls[j], line) <= reach)
            ):
                yield PAIR, i, j
        if ball.phase == RESTING:
            continue
        for k, wall in enumerate(scene.walls):
            if wall.kind == POCKET:
                if clearance(wall, p, 0.0) <= 0.0:
                    yield DROP, i, k
                    break
                continue
            # beyond the wall counts as overlap: only a wall's back would let a ball escape
            if (
                clearance(wall, p, ball.radius) <= 0.0
                and (facing(wall, p).conjugate() * speed(i)).real < 0.0
            ):
                yield CUSHION, i, k
        through = just_left(scene.openings, p, speed(i), ball.radius)
        if through != NOBODY and ball.phase < OFF:
            yield LEAVE, i, NOBODY - through


def contacts(world: Movable, time: float) -> None:
    """All contacts that are there at `time`, in the order of balls and walls; the world's laws."""
    balls = world.scene.balls

    def speed(i: int) -> complex:
        ball = balls[i]
        velocity: complex = ball.velocity + (time - ball.since) * ball.acceleration
        return velocity

    spots = [place(ball, time - ball.since) for ball in balls]
    for kind, i, other in touching(world.scene, spots, speed):
        HAPPENS[kind](world, time, i, other)


def bring(world: Movable, time: float, i: int) -> Any:
    """Ball i at `time`, on a leg that the log knows."""
    ball = world.scene.balls[i]
    if ball.since == time:  # an integrator has put it here
        mark(world, i)
    carry(ball, time, world.scene.cloth)
    return ball


def meet(world: Movable, time: float, i: int, j: int) -> None:
    """Balls i and j collide."""
    a, b = bring(world, time, i), bring(world, time, j)
    hit_ball(a, b, world.scene.ball_rule)
    for ball, index in ((a, i), (b, j)):
        launch(ball, world.scene.cloth)
        mark(world, index)
    note(world, time, PAIR, i, j)


def bounce(world: Movable, time: float, i: int, k: int) -> None:
    """Ball i hits wall k."""
    scene = world.scene
    ball = bring(world, time, i)
    rule = law_at(k, scene.rules, scene.cushion_rule)
    hit_wall(ball, facing(scene.walls[k], ball.position), rule)
    launch(ball, scene.cloth)
    mark(world, i)
    note(world, time, CUSHION, i, k)


def drop(world: Movable, time: float, i: int, k: int) -> None:
    """Ball i falls into pocket k."""
    end(bring(world, time, i), DROP)
    launch(world.scene.balls[i], world.scene.cloth)
    mark(world, i)
    note(world, time, DROP, i, k)


def go_off(world: Movable, time: float, i: int, k: int) -> None:
    """Ball i leaves the table through opening NOBODY - k."""
    end(bring(world, time, i), LEAVE)
    launch(world.scene.balls[i], world.scene.cloth)
    mark(world, i)
    note(world, time, LEAVE, i, k)


HAPPENS = {PAIR: meet, CUSHION: bounce, DROP: drop, LEAVE: go_off}
