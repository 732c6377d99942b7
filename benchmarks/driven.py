"""Families in which the caller meddles: bad scenes, steps of all lengths, pushes, many steps."""

from cmath import rect
from math import inf, pi
from random import Random

from physics import Ball, Cloth, EventDriven, Shot, World, laws, scenes

from .trials import RADIUS, Finding, Trial, box, engine, push, scatter, world_of


def rejected(k: int, dice: Random) -> Trial:
    """Balls that coincide, overlap or lie outside: ValueError, and the world stays as it was."""
    world = world_of(dice)
    first = world.add(Ball("0", at=(dice.uniform(-0.5, 0.5), dice.uniform(-0.5, 0.5))))
    too_near = (0.0, 1e-300, 1e-9, RADIUS, 2.0 * RADIUS * (1.0 - 1e-6))[k % 5]
    p = complex(*first.position) + too_near * rect(1.0, dice.uniform(-pi, pi))
    if k % 7 == 0:
        p = complex(3.0, 0.0) * rect(1.0, dice.uniform(-pi, pi))
    world.add(Ball("1", at=(p.real, p.imag), velocity=(dice.choice((0.0, 1.0)), 0.0)))
    return Trial(world, _expect_refusal)


def _expect_refusal(world: World) -> None:
    before = [ball.position for ball in world.balls]
    for _ in range(2):  # the second time it must be refused as well
        try:
            world.run()
        except ValueError:
            pass
        else:
            raise Finding("a scene that cannot be was accepted")
    if [ball.position for ball in world.balls] != before or len(world.log):
        raise Finding("a refused scene was changed")
    far = 0.1
    for ball in world.balls:  # and once it can be, it must run
        ball.position, far = (far, 0.0), far + 0.1
    world.log.clear()
    world.run()


def stepped(k: int, dice: Random) -> Trial:
    """Steps of 1e-9 to 1e3 s, all lengths mixed: at rest as in one run, bit for bit."""
    world = world_of(dice)
    scatter(world, dice.randrange(1, 7), dice, alike=True)
    push(world.balls[0], dice, 3.0)
    shortest = -9 + k % 12

    def drive(world: World) -> None:
        whole = world.copy()
        whole.run()
        for _ in range(100):
            world.step(10.0 ** dice.uniform(shortest, shortest + 1))
        for _ in range(1000):
            world.step(10.0 ** dice.uniform(-3.0, -1.0))
        world.step(1e3)
        ends = [[(ball.position, ball.velocity) for ball in w.balls] for w in (world, whole)]
        if ends[0] != ends[1]:
            raise Finding("steps end elsewhere than one run")

    return Trial(world, drive)


def landing(k: int, dice: Random) -> Trial:
    """Runs that end exactly at an event, a bit before it or after it, again and again."""
    world = world_of(dice)
    scatter(world, dice.randrange(1, 5), dice, alike=True)
    push(world.balls[0], dice, 2.0)

    def drive(world: World) -> None:
        whole = world.copy()
        whole.run()
        for _ in range(100_000):
            if world.next_event == inf:
                break
            happened = len(world.log)
            world.run(max(world.time, world.next_event * (1.0 + dice.choice((-1e-16, 0.0, 1e-15)))))
            if len(world.log) == happened:
                world.run(world.next_event)
            if len(world.log) == happened:
                raise Finding("run(next_event) does not reach it")
        if [ball.position for ball in world.balls] != [ball.position for ball in whole.balls]:
            raise Finding("runs from event to event end elsewhere than one run")

    return Trial(world, drive)


def agitated(k: int, dice: Random) -> Trial:
    """Between steps the caller pushes, spins, stops, strikes or moves balls, at any moment."""
    world = world_of(dice)
    scatter(world, dice.randrange(1, 7), dice, alike=k % 2 == 0)

    def drive(world: World) -> None:
        for _ in range(40):
            ball = dice.choice(world.balls)
            meddle(ball, world, dice)
            world.step(10.0 ** dice.uniform(-6.0, 0.5))
        world.run()

    return Trial(world, drive, pushed=True)


def meddle(ball: Ball, world: World, dice: Random) -> None:
    """One of the things that a person can do to a ball."""
    kind = dice.randrange(6)
    if kind == 0:
        push(ball, dice, 3.0)
    elif kind == 1:
        ball.spin = tuple(dice.uniform(-100.0, 100.0) for _ in range(3))
    elif kind == 2:
        ball.velocity = ball.velocity  # a touch that changes nothing
    elif kind == 3:
        world.strike(ball, Shot(dice.uniform(0.1, 5.0), dice.uniform(0.0, 360.0)))
    elif kind == 4:
        world.stop()
    else:
        p = complex(*ball.position)
        q = p + rect(10.0 ** dice.uniform(-9.0, -1.0), dice.uniform(-pi, pi))
        free = all(
            abs(q - complex(*b.position)) > b.touching_distance(ball)
            for b in world.balls
            if b is not ball
        )
        inside = all(w.distance((q.real, q.imag)) > ball.radius for w in world.walls)
        if free and inside:
            ball.position = (q.real, q.imag)


STEPS = (100_000, 1_000_000)


def drift(k: int, dice: Random) -> Trial:
    """1e5 or 1e6 steps: a frictionless ball keeps its energy and its orbit, a real one its rest."""
    world = World(Cloth(0.0, 0.0, 0.0), "smooth", laws.RigidCushion(1.0, 0.0, 1.0), engine(0.0))
    for wall in box():
        world.add(wall)
    world.add(Ball("0", at=(-0.3, 0.1), velocity=(1.3, 0.7)))
    steps, dt = STEPS[k % 2], 1e-3 if k % 2 else 1e-2

    def drive(world: World) -> None:
        world.engine = EventDriven(vmin=0.0, budget=10**7)
        for n in range(steps):
            world.step(dt)
            if n % 1000 == 0:
                world.log.clear()
        x, y = world.balls[0].position
        far = world.time  # whose own sum of a million steps is some 1e-8 s off
        miss = max(
            abs(x - unfolded(-0.3 + 1.3 * far, 1.27 - RADIUS)),
            abs(y - unfolded(0.1 + 0.7 * far, 0.635 - RADIUS)),
        )
        if miss > 1e-9 or world.balls[0].velocity[0] not in (1.3, -1.3):
            raise Finding(f"after {steps} steps {miss:.2e} m off")
        world.log.clear()

    return Trial(world, drive)


def unfolded(x: float, half: float) -> float:
    """Where a point is that runs back and forth between -half and half and has come as far as x."""
    y = (x + half) % (4.0 * half)
    return (y if y < 2.0 * half else 4.0 * half - y) - half


def pi_digits(k: int, dice: Random) -> Trial:
    """The number of collisions of two balls and a wall, as long as the digits are few."""
    digits = k % 4 + 1

    def drive(world: World) -> None:
        world.run()
        if len(world.log) != int(pi * 10 ** (digits - 1)):
            raise Finding(f"{len(world.log)} collisions for {digits} digits")

    return Trial(scenes.pi_collisions(digits), drive)
