"""What is read of a played world: speeds around a hit, a ball at some moments, momentum, angles."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from math import atan2, cos, degrees, hypot, inf, radians, sin

from physics import Event, State, World

from .shape import Rows

Vector = tuple[float, float]

HIT = Rows(("ball", "mass (kg)", "vx before (m/s)", "vy before (m/s)", "vx after (m/s)",
            "vy after (m/s)"), ())  # fmt: skip


def happened(world: World, kind: str, *names: str, since: float = -inf) -> Event:
    """The first such event from a moment on; RuntimeError if there is none."""
    for event in world.log.all(kind, *names):
        if event.time >= since:
            return event
    raise RuntimeError(f"no {kind} of {', '.join(names)} in this scene")


def to_cushion(world: World) -> None:
    """Let the world run until a ball first meets a cushion, or until all rest."""
    ahead = world.copy()
    ahead.run()
    met = ahead.log.first("cushion")
    world.run(met.time if met else inf)


def for_seconds(seconds: float) -> Callable[[World], None]:
    """Let a world run for so long."""
    return lambda world: world.run(world.time + seconds)


def unit(angle: float) -> Vector:
    """The direction at so many degrees."""
    return cos(radians(angle)), sin(radians(angle))


def moved(at: Sequence[float], way: Vector, length: float) -> Vector:
    """A place so many metres farther that way."""
    return at[0] + length * way[0], at[1] + length * way[1]


def turned(a: float, b: float) -> float:
    """The angle between two headings, 0 to 180 degrees."""
    return abs((a - b + 180.0) % 360.0 - 180.0)


def slope(xs: Sequence[float], ys: Sequence[float]) -> float:
    """Of the line that fits best by least squares."""
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    over = sum((a - x) * (b - y) for a, b in zip(xs, ys, strict=True))
    return over / sum((a - x) ** 2 for a in xs)


def root(value: Callable[[float], float], low: float, high: float) -> float:
    """Where a function that changes its sign between two numbers is zero."""
    falls = value(low) > 0.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        if (value(middle) > 0.0) == falls:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def momentum(states: Iterable[State], masses: Sequence[float]) -> Vector:
    """Of balls together, kg m/s."""
    pairs = [*zip(states, masses, strict=True)]
    return sum(m * s.velocity[0] for s, m in pairs), sum(m * s.velocity[1] for s, m in pairs)


def moving(states: Iterable[State], masses: Sequence[float]) -> float:
    """Kinetic energy of balls together, but for that of their spin, J."""
    return sum(0.5 * m * s.speed**2 for s, m in zip(states, masses, strict=True))


def masses(world: World, event: Event) -> list[float]:
    """Of the balls in an event, kg."""
    return [world.ball(name).mass for name in event.balls]


def parting(event: Event) -> float:
    """The share of the closing speed with which the two balls of a hit part."""
    (ax, ay), (bx, by) = (state.position for state in event.before)
    far = hypot(bx - ax, by - ay)
    (ux, uy), (vx, vy) = (state.velocity for state in event.after)
    return ((vx - ux) * (bx - ax) + (vy - uy) * (by - ay)) / far / event.closing


def hit(world: World, event: Event) -> Rows:
    """Masses and velocities of two balls around their hit."""
    both = zip(event.balls, masses(world, event), event.before, event.after, strict=True)
    return HIT._replace(rows=[(n, m, *b.velocity, *a.velocity) for n, m, b, a in both])


def runs(world: World, ball: str, times: Iterable[float]) -> list[tuple[float, State]]:
    """A ball at some moments."""
    return [(time, world.log.at(time)[ball]) for time in times]


def heading(velocity: Sequence[float]) -> float:
    """Degrees anticlockwise from the x axis."""
    return degrees(atan2(velocity[1], velocity[0]))
