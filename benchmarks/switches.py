"""The kernel's shortcuts, each with the same thing done the long way.

The kernel has no switches: each variant is the package loaded once more with functions replaced,
so that what is timed without a shortcut is otherwise the very code that runs.
"""

from collections import Counter
from collections.abc import Callable
from importlib import import_module
from math import inf, sqrt
from types import ModuleType
from typing import Any, NamedTuple

from physics.binding import load
from physics.kernel import subset

Package = Any
_numbers = iter(range(10**6))


def fresh() -> Package:
    """The interpreted kernel under a name of its own."""
    name = f"benchmarks.kernel_{next(_numbers)}"
    copy = ModuleType(f"{name}.subset")
    vars(copy).update({k: v for k, v in vars(subset).items() if not k.startswith("__")})
    package = load(name, copy)
    for module in ("cluster", "contact", "grid", "laws", "leg", "motion", "obstacle", "tilt"):
        import_module(f"{name}.{module}")
    return package


def replace(package: Package, old: Callable[..., Any], new: Callable[..., Any]) -> None:
    """Put `new` wherever a module of the package has `old`."""
    names = ("calendar", "cluster", "contact", "grid", "laws", "leg", "obstacle")
    for module in (getattr(package, name) for name in names):
        for name, value in list(vars(module).items()):
            if value is old:
                setattr(module, name, new)


def without_boxes(package: Package) -> None:
    def reach(ball: Any, *_: Any) -> None:
        ball.west = ball.south = -inf
        ball.east = ball.north = inf

    replace(package, package.calendar.reach, reach)


def without_rest(package: Package) -> None:
    contact, place = package.contact, package.leg.place

    def meeting(a: Any, b: Any) -> float:
        if a.since < b.since:
            a, b = b, a
        time = a.since
        t = time - b.since
        q, v = place(b, t) - a.position, b.velocity + t * b.acceleration - a.velocity
        lasts = min(a.leg_end, b.leg_end) - time
        bend, reach = b.acceleration - a.acceleration, package.tilt.touching_distance(a, b)
        return time + contact.contact_time(q, v, bend, reach, lasts)

    replace(package, package.contact.meeting, meeting)


def without_sign(package: Package) -> None:
    contact = package.contact

    def contact_time(q0: complex, v: complex, a: complex, distance: float, horizon: float) -> float:
        time, q, w = 0.0, q0, v
        for _ in range(64):
            line = q.conjugate()
            far = sqrt(q.real * q.real + q.imag * q.imag)
            wait = contact.first_fall(far * (far - distance), (line * w).real, (line * a).real)
            time += wait
            if time >= horizon:
                return inf
            pace = abs(w.real) + abs(w.imag) + wait * (abs(a.real) + abs(a.imag))
            if wait == 0.0 or wait * pace < contact.NEAR * distance:
                return time
            q = q0 + time * (v + 0.5 * time * a)
            w = v + time * a
        return time

    replace(package, package.contact.contact_time, contact_time)


def without_reach(package: Package) -> None:
    """Every cushion is solved for, also those the ball moves away from."""
    obstacle, leg = package.obstacle, package.leg

    def meet_first(ball: Any, walls: Any, lasts: float) -> float:
        p, v, a = ball.position, ball.velocity, ball.acceleration
        for k in range(len(walls)):
            inward = obstacle.facing(walls[k], p).conjugate()
            gap = obstacle.clearance(walls[k], p, ball.radius)
            wait = leg.first_fall(gap, (inward * v).real, (inward * a).real)
            if wait < lasts:
                lasts, ball.goal, ball.ending = wait, k, obstacle.CUSHION
        return lasts

    replace(package, obstacle.meet_first, meet_first)


def without_frame(package: Package) -> None:
    """Every leg asks all that stands on the table, and not only the long walls."""
    replace(package, package.obstacle.meet_framed, lambda *_: -1.0)


def without_boxes_of_walls(package: Package) -> None:
    """What has an end is solved for also where the leg does not come near."""
    obstacle = package.obstacle

    def meet_any(ball: Any, walls: Any, lasts: float) -> float:
        p, v, a = ball.position, ball.velocity, ball.acceleration
        for k, wall in enumerate(walls):
            wait = obstacle.touch(wall, p, v, a, ball.radius, lasts)
            if wait < lasts:
                lasts, ball.goal = wait, k
                ball.ending = obstacle.DROP if wall.kind == obstacle.POCKET else obstacle.CUSHION
        return lasts

    replace(package, obstacle.meet_any, meet_any)


def without_memory(package: Package) -> None:
    """After an event every ball is planned again, not only those that it touched."""
    calendar, happen = package.calendar, package.calendar.happen

    def replan(i: int, scene: Any) -> Any:
        kind, other = happen(i, scene)
        for k in range(len(scene.balls)):
            calendar.start_leg(k, scene)
        for k in range(len(scene.balls)):
            calendar.plan_meetings(k, scene)
        return kind, other

    replace(package, happen, replan)


def without_table(package: Package) -> None:
    """A ball that loses its partner asks all others again."""
    contact, sooner = package.contact, package.grid.sooner

    def appoint(j: int, i: int, when: float, balls: Any, meetings: Any) -> None:
        ball = balls[j]
        if sooner(when, i, ball):
            ball.meets, ball.partner = when, i
        else:
            ball.meets, ball.partner = inf, -1
            for k, other in enumerate(balls):
                again = contact.meeting(ball, other) if k != j else inf
                if again < ball.meets:
                    ball.meets, ball.partner = again, k
        ball.next = min(ball.meets, ball.leg_end)

    replace(package, package.calendar.appoint, appoint)


def with_clusters(package: Package) -> None:
    """Every hit of two balls goes through the solver of clusters."""
    replace(package, package.cluster.crowded, lambda *_: True)
    replace(package, package.cluster.crowded_near, lambda *_: True)


def with_rubbing(package: Package) -> None:
    """Friction between balls is worked out where there is none."""
    laws = package.laws

    def ball(v: complex, roll: complex, side: float, mass: float, level: float, rule: Any) -> Any:
        push = mass * laws.rebound(v.real, rule)
        slip = complex(v.imag + side, -roll.real)
        return push, laws.friction(slip, 0.0 * push / level, 3.5 / mass)

    replace(package, laws.ball_law, ball)


def with_spin_events(package: Package) -> None:
    """The end of a spin about the vertical is an event, after which its ball is planned again."""
    calendar = package.calendar

    def fades(ball: Any, cloth: Any) -> float:
        return float(ball.since + abs(ball.side) / (ball.radius * cloth.fade)) if ball.side else inf

    def advance(until: float, budget: int, scene: Any) -> tuple[int, float]:
        balls, cloth, events, last = scene.balls, scene.cloth, 0, 0.0
        done = [0.0] * len(balls)
        while events <= budget:
            i = calendar.soonest(scene)
            time = balls[i].next
            ends = [fades(ball, cloth) for ball in balls]
            due, k = min((end, k) for k, end in enumerate(ends) if end > done[k])
            if due < time:
                done[k] = due
                calendar.start_leg(k, scene)
                calendar.plan_meetings(k, scene)
                continue
            if time > until or time == inf:
                break
            kind, other = calendar.happen(i, scene)
            events += calendar.blows(other, scene.ties) if kind == calendar.CLUSTER else 1
            last = time
        return events, last

    replace(package, calendar.advance, advance)


class Switch(NamedTuple):
    """A shortcut, and how to do without it."""

    name: str
    off: Callable[[Package], None]


def everything(package: Package) -> None:
    """The long way in everything that the table of meetings is for."""
    for off in (without_boxes, without_rest, without_sign, without_reach, without_memory):
        off(package)


SWITCHES = (
    Switch("swept boxes", without_boxes),
    Switch("pairs at rest", without_rest),
    Switch("sign before root", without_sign),
    Switch("only cushions within reach", without_reach),
    Switch("only touched balls planned again", without_memory),
    Switch("table of meetings", without_table),
    Switch("clusters only where a third ball touches", with_clusters),
    Switch("no event where a spin ends", with_spin_events),
    Switch("the first five at once", everything),
)
POCKETS = (
    Switch("only long walls within the frame", without_frame),
    Switch("boxes around obstacles", without_boxes_of_walls),
)
SMOOTH = Switch("no friction between smooth balls", with_rubbing)


def count(package: Package, work: Counter[str]) -> None:
    """Make the package count its work: pair solves, box tests, quadratics and legs planned."""
    calendar, grid = package.calendar, package.grid

    def counted(old: Callable[..., Any], name: str, size: Callable[..., int]) -> None:
        def new(*args: Any) -> Any:
            result = old(*args)
            work[name] += size(result, *args)
            return result

        replace(package, old, new)

    def boxes(_: Any, i: int, scene: Any) -> int:
        return 0 if scene.celled else len(scene.balls) - 1

    counted(calendar.plan_meetings, "box tests", boxes)
    counted(grid.neighbours, "box tests", lambda near, *_: near)
    counted(package.obstacle.touch, "obstacles met", lambda *_: 1)
    counted(package.contact.contact_time, "pair solves", lambda *_: 1)
    counted(package.contact.first_fall, "quadratics", lambda *_: 1)
    counted(calendar.start_leg, "legs planned", lambda *_: 1)
