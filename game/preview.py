"""What a shot does, told from its log: paths and first contact.  The preview is the engine."""

from __future__ import annotations

from cmath import phase
from dataclasses import dataclass
from math import ceil, degrees, sqrt
from typing import NamedTuple

from physics import EventBudgetError, Leg, Log, Shot, State, World, simulate

Place = tuple[float, float]

CHORD = 0.00025
"""Metres by which a drawn curve may be off: a quarter of a pixel at 4K."""
MOST_CUSHIONS = 6
"""Cushions after which a previewed path ends: nobody plans for more."""
SAME = 0.02
"""Seconds: contacts with one ball that follow each other faster are one contact to the eye."""
HORIZON = 120.0
"""Seconds: no shot that a player can make rolls for longer."""
GLIMPSE = 5.0
"""Seconds foretold of a shot that has no end."""
MOVED = 1e-9
"""Metres: a leg shorter than this is a ball that lies still."""


@dataclass(frozen=True, slots=True)
class Lane:
    """A ball's time: (from, to, mean speed) of each leg on which it moved."""

    name: str
    legs: tuple[tuple[float, float, float], ...]


class Mark(NamedTuple):
    """A hit, or a ball that comes to "rest": as `physics.Event`, but ten times as quick to make."""

    time: float
    kind: str
    balls: tuple[str, ...]
    wall: str | None = None


@dataclass(frozen=True, slots=True)
class Story:
    """What happened since a shot; times count from it, seconds."""

    lanes: tuple[Lane, ...]
    events: tuple[Mark, ...]
    duration: float


Legs = dict[str, list[Leg]]


@dataclass(frozen=True, slots=True)
class Contact:
    """The first ball the cue ball meets: where both are then, and where they leave to.

    overlap is the thickness, 0 to 1, negative when the cue ball passes on the left of the other;
    cut is the angle between its way and the line of centres, degrees.
    """

    ball: str
    ghost: Place
    other: Place
    leaves: tuple[Place, Place]
    overlap: float
    cut: float


@dataclass(frozen=True, slots=True)
class Preview:
    """A shot that has not been played.

    way: the cue ball's path to its first contact; beyond: from there to the decision, which is the
    second ball it meets, its last cushion worth drawing, or its rest; path: the object ball's.
    bounces: where the cue ball meets cushions until the decision, and the wall's outward normal.
    """

    story: Story
    contact: Contact | None
    way: tuple[Place, ...]
    beyond: tuple[Place, ...]
    path: tuple[Place, ...]
    bounces: tuple[tuple[Place, Place], ...]


def preview(world: World, cue: str, shot: Shot) -> Preview | None:
    """Play the shot on a copy; None if it has too many events for the engine, or never an end."""
    if not rests(world):
        return None
    try:
        after = simulate(world, cue, shot)
    except EventBudgetError:
        return None
    since, log = world.time, after.log
    legs = _legs(log)
    told = _story(log, legs, since, after.time)
    first = next((e for e in told.events if e.kind == "ball" and cue in e.balls), None)
    decision = _decision(told, cue, first.time if first else None)
    bounces = _bounces(told, legs[cue], cue, since, decision, world)
    end = since + decision
    if first is None:
        return Preview(told, None, _way(legs[cue], since, end), (), (), bounces)
    contact = _contact(first, legs, cue, since, world)
    hit = since + first.time
    own, other = legs[cue], legs[contact.ball]
    parts = _way(own, since, hit), _way(own, hit, end), _way(other, hit, end)
    return Preview(told, contact, *parts, bounces)


def rests(world: World) -> bool:
    """Does the cloth bring balls to rest?"""
    cloth = world.cloth
    return cloth.slide * cloth.roll * cloth.gravity > 0.0


def _decision(told: Story, cue: str, met: float | None) -> float:
    """When the preview ends, seconds."""
    cushions = 0
    for event in told.events:
        if cue not in event.balls:
            continue
        if event.kind == "ball" and met is not None and event.time > met + SAME:
            return event.time
        cushions += event.kind == "cushion"
        if event.kind == "rest" or cushions == MOST_CUSHIONS:
            return event.time
    return told.duration


def _bounces(
    told: Story, legs: list[Leg], cue: str, since: float, until: float, world: World
) -> tuple[tuple[Place, Place], ...]:
    normals = {wall.name: wall.normal for wall in world.walls}
    found = []
    for event in told.events:
        if event.kind == "cushion" and event.balls == (cue,) and event.time <= until:
            out = -normals[event.wall]
            at = _turn(legs, since + event.time)[1].position
            found.append((at, (out.real, out.imag)))
    return tuple(found)


def _turn(legs: list[Leg], time: float) -> tuple[State, State]:
    """A ball just before and just after something happened to it, at a world time."""
    index = min(range(len(legs)), key=lambda i: abs(legs[i].time - time))
    before, leg = legs[max(index - 1, 0)], legs[index]
    return before.after(leg.time - before.time).state(), leg.state()


def story(log: Log, since: float, now: float) -> Story:
    """Tell the log of one shot from `since` to `now`, world seconds."""
    return _story(log, _legs(log), since, now)


def _legs(log: Log) -> Legs:
    return {name: log.legs(name) for name in log.names}


def _story(log: Log, legs: Legs, since: float, now: float) -> Story:
    events = [Mark(c.time - since, c.kind, c.balls, c.wall) for c in log.contacts()]
    lanes = []
    for name in log.names:
        own = legs[name]
        moved = _moved(own, since, now)
        lanes.append(Lane(name, tuple((a - since, b - since, _pace(g, a, b)) for g, a, b in moved)))
        rests = (leg.time for leg in own[1:] if leg.velocity == leg.roll == leg.acceleration == 0j)
        events += [Mark(time - since, "rest", (name,)) for time in rests]
    events.sort(key=lambda mark: mark.time)
    ends = [e.time for e in events] + [lane.legs[-1][1] for lane in lanes if lane.legs]
    return Story(tuple(lanes), tuple(events), max(ends, default=0.0))


NO_STORY = Story((), (), 0.0)


def forecast(world: World, since: float) -> Story:
    """Tell the shot that began at `since` to its end: what has happened and what will."""
    ahead = world.copy()
    try:
        ahead.run(world.time + (HORIZON if rests(world) else GLIMPSE))
    except EventBudgetError:
        return NO_STORY
    return story(ahead.log, since, ahead.time)


def path(log: Log, name: str, since: float, until: float) -> tuple[Place, ...]:
    """The way of a ball between two world times as points; straight legs are two."""
    return _way(log.legs(name), since, until)


def _way(legs: list[Leg], since: float, until: float) -> tuple[Place, ...]:
    moved = _moved(legs, since, until)
    return tuple(p for leg, a, b in moved for p in _points(leg, a - leg.time, b - leg.time))


def _moved(legs: list[Leg], since: float, until: float) -> list[tuple[Leg, float, float]]:
    """The legs on which a ball got anywhere, each with the times between which it was on it."""
    ends = [leg.time for leg in legs[1:]] + [until] * bool(legs)
    pairs = zip(legs, ends, strict=True)
    spans = ((leg, max(leg.time, since), min(end, until)) for leg, end in pairs)
    return [(leg, a, b) for leg, a, b in spans if b > a and _far(leg, a, b)]


def _place(leg: Leg, t: float) -> complex:
    return leg.position + t * (leg.velocity + 0.5 * t * leg.acceleration)


def _far(leg: Leg, a: float, b: float) -> bool:
    start = leg.time
    return abs(_place(leg, b - start) - _place(leg, a - start)) > MOVED


def _pace(leg: Leg, a: float, b: float) -> float:
    start = leg.time
    return abs(_place(leg, b - start) - _place(leg, a - start)) / (b - a)


def _points(leg: Leg, a: float, b: float) -> list[Place]:
    """A leg as points; a straight one is its two ends."""
    v, g = leg.velocity, leg.acceleration
    bent = abs((v.conjugate() * g).imag) > 1e-9 * abs(v) * abs(g)
    # over a time h the parabola is |g| h² / 8 away from its chord
    steps = ceil((b - a) * sqrt(abs(g) / (8 * CHORD))) if bent else 1
    spots = (_place(leg, a + (b - a) * k / steps) for k in range(steps + 1))
    return [(p.real, p.imag) for p in spots]


def _contact(met: Mark, legs: Legs, cue: str, since: float, world: World) -> Contact:
    ball = next(name for name in met.balls if name != cue)
    own, left = _turn(legs[cue], since + met.time)
    other, sent = _turn(legs[ball], since + met.time)
    line = complex(other.position[0] - own.position[0], other.position[1] - own.position[1])
    way = complex(*own.velocity) - complex(*other.velocity)
    turn = phase(line / way) if way else 0.0
    aside = abs(line) * abs((line / abs(line) / (way / abs(way))).imag) if way else 0.0
    overlap = 1.0 - aside / world.ball(cue).touching_distance(world.ball(ball))
    leaves = left.velocity, sent.velocity
    signed = -overlap if turn < 0 else overlap
    return Contact(ball, own.position, other.position, leaves, signed, abs(degrees(turn)))
