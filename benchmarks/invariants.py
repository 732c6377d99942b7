"""What must hold in every world at every event, read from its log: a list of faults.

Between events the motion is polynomial, so gaps are checked over whole intervals, not at samples:
the gap of two balls is never less than its projection on any line, a quadratic whose minimum is
exact.
"""

from collections.abc import Iterable
from math import hypot, inf, isfinite
from typing import Any, NamedTuple

import numpy as np

from physics import Event, World, laws
from physics.kernel.kinds import OFF
from physics.kernel.lasting import FAR, GROWTH, HOP, LONGEST, PATIENT, SPREAD
from physics.wall import Obstacle

from .nearness import least

OVERLAP = 1e-12  # m
ROUNDING = 1e-12  # of the total energy or momentum
TOUCHING = 1e-8  # m, see _apart
RECENT = 30  # events
BLOWS = 16  # of a contact within one event of a cluster, that the floor may have lifted
CREATIVE = (laws.ThesisCushion, laws.CappedCushion)  # push as if the ball rolled: make energy


class Intervals(NamedTuple):
    """Balls on their legs from each instant on.

    times: s, (instants,).
    place, velocity, acceleration: (instants, balls), complex, m and s.
    lasts: s until the next instant, (instants,).
    here: is the ball on the table?  (instants, balls).
    """

    times: Any
    place: Any
    velocity: Any
    acceleration: Any
    lasts: Any
    here: Any


def faults(world: World, pushed: bool = False) -> list[str]:
    """Everything that is wrong with what has happened in a world, in words.

    pushed: whether balls were pushed on the way, perhaps at the instant of an event; then energy is
    checked only within each event.
    """
    legs = [_table(world.log.legs(ball.name)) for ball in world.balls]
    if not all(np.isfinite(column).all() for leg in legs for column in leg):
        return ["a leg is not finite"]
    found = []
    for epoch in sorted({float(begin) for leg in legs for begin in leg.epoch}):
        found += _epoch_faults(world, legs, epoch, pushed)
    first = 0 if pushed else max(0, len(world.log) - RECENT)
    return found + _event_faults(world, range(first, len(world.log)))


class Legs(NamedTuple):
    """A ball's legs as columns."""

    epoch: Any
    since: Any
    place: Any
    velocity: Any
    acceleration: Any
    roll: Any
    side: Any
    here: Any  # or is it in a pocket, or off?

    def of(self, k: Any) -> "Legs":
        """Some of them: a mask, or an index for each."""
        return Legs(*(column[k] for column in self))


def _table(legs: list[Any]) -> Legs:
    rows = np.array([leg[:8] for leg in legs], complex).reshape(-1, 8)
    epoch, since, place, velocity, acceleration, roll, side, phase = rows.T
    here = phase.real < OFF
    return Legs(epoch.real, since.real, place, velocity, acceleration, roll, side.real, here)


def _epoch_faults(world: World, legs: list[Legs], epoch: float, pushed: bool) -> list[str]:
    """Positions of one stretch of time, from its own zero so that nothing is rounded off."""
    parts = [_part(leg, epoch) for leg in legs]
    later = [float(begin) for leg in legs for begin in leg.epoch if begin > epoch]
    end = (min(later) if later else world.time) - epoch
    times = np.unique(np.concatenate([part.since for part in parts]))
    motion = _motion(parts, times, max(end, float(times[-1])))
    found = _wall_faults(world, motion) + _pair_faults(world, motion)
    found += _shape_faults(world, parts, epoch, end)
    return found + ([] if pushed else _jump_faults(world, parts, times, epoch))


def _part(leg: Legs, epoch: float) -> Legs:
    """A ball's legs of an epoch; until the first of them it lies still on the last before."""
    mine = leg.of(leg.epoch == epoch)
    k = int(np.searchsorted(leg.epoch, epoch)) - 1
    if k < 0 or (len(mine.epoch) and mine.since[0] == 0.0):
        return mine
    still = leg.of(slice(k, k + 1))._replace(since=np.zeros(1))
    return Legs(*(np.concatenate(pair) for pair in zip(still, mine, strict=True)))


def _motion(parts: list[Legs], times: Any, end: float) -> Intervals:
    columns = []
    for part in parts:
        k = np.maximum(np.searchsorted(part.since, times, side="right") - 1, 0)
        leg = part.of(k)
        t, v, a = times - leg.since, leg.velocity, leg.acceleration
        columns.append((leg.place + t * (v + 0.5 * t * a), v + t * a, a, leg.here))
    place, velocity, acceleration, here = (
        np.array(column).T for column in zip(*columns, strict=True)
    )
    return Intervals(times, place, velocity, acceleration, np.diff(times, append=end), here)


def lowest(gap: Any, speed: Any, bend: Any, lasts: Any) -> Any:
    """The least of gap + speed t + bend t²/2 for t from 0 to `lasts`."""
    end = gap + lasts * (speed + 0.5 * lasts * bend)
    low = np.minimum(gap, end)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        turn = -speed / bend
        dip = gap - 0.5 * speed * speed / bend
    return np.where((bend > 0.0) & (turn > 0.0) & (turn < lasts), np.minimum(low, dip), low)


def _wall_faults(world: World, motion: Intervals) -> list[str]:
    """Of lines, which all balls may meet."""
    found = []
    radii = np.array([ball.radius for ball in world.balls])
    for wall in world.walls:
        if wall.kind != "line":
            continue
        inward = wall.normal.conjugate()
        gap = (inward * motion.place).real - wall.offset - radii
        low = lowest(
            gap, (inward * motion.velocity).real, (inward * motion.acceleration).real,
            motion.lasts[:, None],
        )  # fmt: skip
        allowed = np.minimum(gap[0], 0.0) - OVERLAP  # as it was placed
        for k, i in zip(*np.nonzero(motion.here & (low < allowed)), strict=True):
            found.append(
                f"ball {world.balls[i].name} is {-low[k, i]:.2e} m outside {wall.name or wall}"
                f" after t = {motion.times[k]!r}"
            )
    return found[:3]


def _shape_faults(world: World, parts: list[Legs], epoch: float, end: float) -> list[str]:
    """Of all else: legs whose boxes touch that of the obstacle are looked at one by one."""
    found = []
    for ball, legs in zip(world.balls, parts, strict=True):
        lasts = np.maximum(np.diff(legs.since, append=max(end, float(legs.since[-1]))), 0.0)
        box = _boxes(legs, lasts, ball.radius)
        for wall in world.walls:
            if wall.kind == "line":
                continue
            radius = ball.radius if wall.pushes else 0.0  # over a hole its centre counts
            allowed = min(0.0, wall.distance(_xy(legs.place[0])) - radius) - OVERLAP
            for k in np.nonzero(legs.here & _touches(box, wall))[0]:
                path = complex(legs.place[k]), complex(legs.velocity[k]), legs.acceleration[k]
                low = least(wall.shape, path, float(lasts[k]), radius)
                if low < allowed:
                    where = "in" if wall.pushes else "over"
                    found.append(
                        f"ball {ball.name} is {-low:.2e} m {where} {wall.name or wall} after"
                        f" t = {epoch + float(legs.since[k])!r}"
                    )
    return found[:3]


def _xy(p: complex) -> tuple[float, float]:
    return float(p.real), float(p.imag)


def _boxes(legs: Legs, lasts: Any, radius: float) -> list[Any]:
    """West, east, south, north of each leg."""
    sides = []
    for part in (np.real, np.imag):
        p, v, a = part(legs.place), part(legs.velocity), part(legs.acceleration)
        sides += [lowest(p, v, a, lasts) - radius, radius - lowest(-p, -v, -a, lasts)]
    return sides


def _touches(box: list[Any], wall: Obstacle) -> Any:
    west, east, south, north = box
    shape = wall.shape
    return (
        (west <= shape.east) & (east >= shape.west) & (south <= shape.north)
        & (north >= shape.south)
    )  # fmt: skip


def _pair_faults(world: World, motion: Intervals) -> list[str]:
    n = len(world.balls)
    if n < 2:
        return []
    first, second = np.triu_indices(n, 1)
    pairs = [(world.balls[i], world.balls[j]) for i, j in zip(first, second, strict=True)]
    reach = np.array([[one.touching_distance(other) for one, other in pairs]])
    q, w, b = (x[:, second] - x[:, first] for x in motion[1:4])
    t = motion.lasts[:, None]
    put = np.minimum(np.abs(q[0]) - reach[0], 0.0) - OVERLAP
    low = np.full(q.shape, -np.inf)
    for share in (0.0, 1.0, 0.5):  # a line of centres at the start, the end, the middle
        line = np.exp(1j * np.angle(q + share * t * (w + 0.5 * share * t * b))).conjugate()
        low = np.maximum(low, lowest((line * q).real - reach, (line * w).real, (line * b).real, t))
    found = []
    both = motion.here[:, first] & motion.here[:, second]
    for k, p in zip(*np.nonzero(both & (low < put)), strict=True):
        gap = _closest(q[k, p], w[k, p], b[k, p], float(motion.lasts[k])) - reach[0, p]
        if gap < put[p]:
            names = world.balls[first[p]].name, world.balls[second[p]].name
            found.append(f"balls {names} overlap by {-gap:.2e} m after t = {motion.times[k]!r}")
    return found[:3]


def _closest(q: complex, w: complex, b: complex, lasts: float) -> float:
    """The least |q + w t + b t²/2| for t from 0 to `lasts`: where the cubic derivative is zero."""
    cubic = [
        0.5 * abs(b) ** 2,
        1.5 * (w.conjugate() * b).real,
        abs(w) ** 2 + (q.conjugate() * b).real,
        (q.conjugate() * w).real,
    ]
    turns = [float(t.real) for t in np.roots(cubic) if 0.0 < t.real < lasts]
    return min(abs(q + t * (w + 0.5 * t * b)) for t in [0.0, lasts, *turns])


def _jump_faults(world: World, parts: list[Legs], times: Any, epoch: float) -> list[str]:
    """What changes at an instant: places never, energy only down, momentum only at a wall."""
    mass = np.array([ball.mass for ball in world.balls])
    radius = np.array([ball.radius for ball in world.balls])
    fade = world.cloth.spin_decay
    before, after = (_states(parts, radius, fade, times, side) for side in ("left", "right"))
    step = np.abs(after[0] - before[0]).max(axis=1)
    whole = energy(mass, *before[1:])
    scale = (mass * (np.abs(before[1]) + np.abs(after[1]) + 1.0)).sum(axis=1)
    gain = energy(mass, *after[1:]) - whole - ROUNDING * (whole + scale)
    drift = np.abs((mass * (after[1] - before[1])).sum(axis=1)) / scale
    twist = np.abs(_turn(mass, radius, after) - _turn(mass, radius, before)) / scale
    several = (after[1] != before[1]).sum(axis=1) > 1
    floor = 0.25 * float(mass.min()) * world.engine.vmin**2
    odd = (
        (step > OVERLAP)
        | (gain > floor)
        | (several & (drift > ROUNDING))
        | (several & (twist > _apart(world)))
    )
    odd[0] = False  # the epoch begins
    return _named(world, np.nonzero(odd)[0], times, epoch, (step, gain, drift, twist))


def _named(world: World, odd: Any, times: Any, epoch: float, faults: tuple[Any, ...]) -> list[str]:
    """What is wrong at the odd instants, given what happened there; the first three of it."""
    step, gain, drift, twist = faults
    happened: dict[float, list[int]] = {}
    for n, event in enumerate(world.log if len(odd) else ()):
        happened.setdefault(event.time, []).append(n)
    found = []
    for k in odd:
        events = happened.get(epoch + float(times[k]), [])  # none if a ball was pushed
        kinds = {world.log[n].kind for n in events}
        lent = sum(_lightest(world, world.log[n]) * _floor(world, n) for n in events)
        bound = 0.5 * BLOWS * lent
        if events and step[k] > OVERLAP:
            found.append(f"a ball jumps by {step[k]:.2e} m at t = {times[k]}")
        if events and gain[k] > bound and not _creates(world, kinds):
            found.append(f"energy grows by {gain[k]:.3e} J at t = {times[k]} {sorted(kinds)}")
        if kinds == {"ball"} and not isinstance(world.ball_law, laws.ThesisBall):
            if drift[k] > ROUNDING:
                found.append(f"momentum changes by {drift[k]:.3e} of all at t = {times[k]}")
            if twist[k] > max(_apart(world), *(_hop(world, n) for n in events)):
                found.append(f"angular momentum changes by {twist[k]:.3e} m at t = {times[k]}")
    return found[:3]


def _apart(world: World) -> float:
    """m: how far apart the contacts of a cluster may be, and so rub off their line."""
    return TOUCHING if world.cluster_law is None else max(TOUCHING, world.cluster_law.gap)


def _hop(world: World, n: int) -> float:
    """m: how far apart things may be that stay together after event n; 0 if it is too quick."""
    event = world.log[n]
    radius = max(world.ball(name).radius for name in event.balls)
    hop = min(SPREAD * HOP * _stretch(world, n) ** 2, FAR) * radius
    return hop if event.closing**2 <= 8.0 * world.cloth.slide * world.cloth.gravity * hop else 0.0


def _stretch(world: World, n: int) -> float:
    """How many times longer than at first a ball of event n hops, if all its legs were hops."""
    legs = max(leg for _, leg in world.log.begun(n))
    return min(max(1.0, 1.0 + GROWTH * (legs - PATIENT)), LONGEST)


def _floor(world: World, n: int) -> float:
    """The square of the speed at which things may part in event n under any law: what it lends."""
    lent = 2.0 * world.cloth.slide * world.cloth.gravity * _hop(world, n)
    return max(world.engine.vmin**2, lent)


def _states(parts: list[Legs], radius: Any, fade: float, times: Any, side: Any) -> list[Any]:
    """(place, velocity, roll, side) of all balls just before or just after each instant."""
    columns = []
    for part, r in zip(parts, radius, strict=True):
        leg = part.of(np.maximum(np.searchsorted(part.since, times, side=side) - 1, 0))
        t, v, spin = times - leg.since, leg.velocity, leg.side
        gain = t * leg.acceleration
        columns.append(
            (
                leg.place + t * (v + 0.5 * gain),
                v + gain,
                leg.roll + np.where(v == leg.roll, gain, -2.5 * gain),
                np.sign(spin) * np.maximum(np.abs(spin) - t * r * fade, 0.0),
            )
        )
    return [np.array(column).T for column in zip(*columns, strict=True)]


def _creates(world: World, kinds: set[str]) -> bool:
    """Laws of the thesis may make energy, and a custom law may do anything."""
    cushion = isinstance(world.cushion_law, CREATIVE) and "cushion" in kinds
    return cushion or (isinstance(world.ball_law, laws.ThesisBall) and "ball" in kinds)


def _lightest(world: World, event: Any) -> float:
    """The mass that the floor of the parting speed may set in motion."""
    if event.kind not in ("ball", "cushion"):
        return 0.0
    masses = [world.ball(name).mass for name in event.balls]
    return masses[0] if len(masses) == 1 else masses[0] * masses[1] / sum(masses)


def energy(mass: Any, velocity: Any, roll: Any, side: Any) -> Any:
    """Kinetic energy of moving and turning, J, at each instant."""
    v, w = np.abs(velocity), np.abs(roll)
    return (mass * (0.5 * v * v + 0.2 * (w * w + side * side))).sum(axis=-1)


def _turn(mass: Any, radius: Any, state: list[Any]) -> Any:
    """Angular momentum about the vertical, kg m²/s; m R ω_z R 2/5 of it is spin."""
    place, velocity, _, side = state
    return (mass * ((place.conjugate() * velocity).imag + 0.4 * radius * side)).sum(axis=-1)


def _event_faults(world: World, events: Iterable[int]) -> list[str]:
    """What is wrong within single events; a cluster shares its loss among them."""
    heaviest = max((ball.mass for ball in world.balls), default=0.0)
    found, last = [], -inf
    for n in events:
        event = world.log[n]
        if event.time < last:
            found.append(f"event at {event.time!r} after one at {last!r}")
        last = event.time
        if not all(map(isfinite, (event.time, event.closing, event.impulse, event.energy_lost))):
            found.append(f"an event is not finite: {event}")
        bound = BLOWS * 0.5 * heaviest * _floor(world, n)
        made = -event.energy_lost - bound - ROUNDING * _weight(world, event)
        if made > 0.0 and not _creates(world, {event.kind}):
            found.append(f"an event makes {-event.energy_lost:.3e} J at t = {event.time}")
    return found[:3]


def _weight(world: World, event: Event) -> float:
    """Energy and momentum, in plain numbers: slip below 1e-12 m/s counts as none, which rounds
    both.
    """
    size = event.impulse  # a cluster shares its loss among its contacts
    for name, state in zip(event.balls, event.before, strict=True):
        ball = world.ball(name)
        speed = hypot(*state.velocity) + hypot(*state.spin) * ball.radius
        size += ball.mass * speed * (speed + 1.0)
    return size
