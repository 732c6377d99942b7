"""What a shot does, taken from its log: paths and first contact.  The preview is the engine."""

from __future__ import annotations

from cmath import phase
from collections.abc import Callable
from dataclasses import dataclass
from math import ceil, degrees, sqrt
from typing import NamedTuple

from danggu.rules.stroke import counts
from physics import Leg, Log, Shot, State, World, simulate

FAILS = (ArithmeticError, RuntimeError, ValueError)
"""What an engine raises when it cannot go on: no reason for a game to end."""
Place = tuple[float, float]

CHORD = 0.00025
"""Metres by which a drawn curve may be off: a quarter of a pixel at 4K."""
HORIZON = 120.0
"""Seconds: no shot that a player can make rolls for longer."""
GLIMPSE = 5.0
"""Seconds foretold of a shot that has no end."""
MOVED = 1e-9
"""Metres: a leg shorter than this is a ball that lies still."""
TIE = 1e-9
"""Seconds: what is no farther apart happens at once."""


@dataclass(frozen=True, slots=True)
class Travel:
    """A ball's time: (from, to, mean speed) of each leg on which it moved."""

    name: str
    legs: tuple[tuple[float, float, float], ...]


class Mark(NamedTuple):
    """A hit, or a ball that comes to "rest": as `physics.Event`, but ten times as quick to make."""

    time: float
    kind: str
    balls: tuple[str, ...]
    wall: str | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Story:
    """What happened since a shot; times count from it, seconds. Each is equal only to itself, so
    that what follows from it can be kept."""

    lanes: tuple[Travel, ...]
    events: tuple[Mark, ...]
    duration: float


Legs = dict[str, list[Leg]]


@dataclass(frozen=True, slots=True)
class FirstContact:
    """The first ball the cue ball meets.

    ball     its name
    ghost    where the cue ball is then
    other    where the ball is
    leaves   velocities with which both leave, the cue ball's first, m/s
    overlap  the thickness, 0 to 1, negative when the cue ball passes on the left of the other
    cut      angle between its way and the line of centres, degrees
    """

    ball: str
    ghost: Place
    other: Place
    leaves: tuple[Place, Place]
    overlap: float
    cut: float


class Meeting(NamedTuple):
    """Two balls that meet later in a shot: their names, and where their centres are then."""

    balls: tuple[str, str]
    places: tuple[Place, Place]


@dataclass(frozen=True, slots=True)
class Preview:
    """A shot that has not been played, until nothing that happens can change what it counts.

    story     of all balls, to the end
    contact   the first one, if the cue ball meets any ball
    way       the cue ball's path to its first contact
    beyond    its path from there on
    bounces   where it meets cushions, and the wall's outward normal
    others    the path of every other ball that moves
    meetings  of balls after the first contact
    whole     do all balls lie still in the end?
    foul      the number of the meeting that is one, -1 if the first contact is, or None
    fault     a key of the texts: which foul the whole shot would be, or ""
    """

    story: Story
    contact: FirstContact | None
    way: tuple[Place, ...]
    beyond: tuple[Place, ...]
    bounces: tuple[tuple[Place, Place], ...]
    others: dict[str, tuple[Place, ...]]
    meetings: tuple[Meeting, ...]
    whole: bool = True
    foul: int | None = None
    fault: str = ""


class Outcome(NamedTuple):
    """What the rules say of a stroke.

    settled  when nothing can change it any more, world seconds; None where it counts to its end
    fault    a key of the texts: which foul it is, or ""
    """

    settled: float | None
    fault: str


Judge = Callable[[World], Outcome]
"""The rules that are played by, asked about a stroke that a copy of the world has played."""


def foretold(world: World, cue: str, shot: Shot) -> World | None:
    """Play the shot on a copy; None if the engine cannot play it, or it would never end."""
    if not rests(world):
        return None
    try:
        return simulate(world, cue, shot)
    except FAILS:
        return None


def preview(world: World, cue: str, shot: Shot, judge: Judge | None = None) -> Preview | None:
    """See what a shot will do; None if the engine cannot play it, or it would never end."""
    after = foretold(world, cue, shot)
    if after is None:
        return None
    since, legs = world.time, _legs(after.log)
    known = _story(after.log, legs, since, after.time)
    settled, fault = judge(after) if judge else (None, "")
    end = since + known.duration if settled is None else settled + TIE
    met = [e for e in known.events if e.kind == "ball" and since + e.time <= end]
    first = next((e for e in met if cue in e.balls), None)
    hit, contact = end, None
    if first is not None:
        hit, contact = since + first.time, _contact(first, legs, cue, since, world)
    others = {name: _way(own, since, end) for name, own in legs.items() if name != cue}
    return Preview(
        known,
        contact,
        _way(legs[cue], since, hit),
        _way(legs[cue], hit, end),
        _bounces(known, legs[cue], cue, since, end - since, world),
        {name: way for name, way in others.items() if way},
        tuple(_meeting(e, legs, since) for e in met if e is not first),
        settled is None,
        _blamed(met, first, end - since) if settled is not None and fault else None,
        fault,
    )


def rests(world: World) -> bool:
    """Do cloth and engine bring balls to rest?"""
    cloth = world.cloth
    ends = getattr(world.engine, "scheme", "") != "literal"  # the thesis's program never does
    return ends and cloth.slide * cloth.roll * cloth.gravity > 0.0


def _meeting(met: Mark, legs: Legs, since: float) -> Meeting:
    a, b = met.balls
    p, q = (_around(legs[name], since + met.time)[1].position for name in (a, b))
    return Meeting((a, b), (p, q))


def _blamed(met: list[Mark], first: Mark | None, end: float) -> int | None:
    """The number of the meeting that ended the stroke; the first contact is -1."""
    if not met or met[-1].time < end - 2 * TIE:
        return None
    return -1 if met[-1] is first else len(met) - 2


def _bounces(
    known: Story, legs: list[Leg], cue: str, since: float, until: float, world: World
) -> tuple[tuple[Place, Place], ...]:
    walls = {wall.name: wall for wall in world.walls}
    found = []
    for event in known.events:
        if event.kind == "cushion" and event.balls == (cue,) and event.time <= until:
            at = _around(legs, since + event.time)[1].position
            out = -walls[event.wall].facing(at)
            found.append((at, (out.real, out.imag)))
    return tuple(found)


def _around(legs: list[Leg], time: float) -> tuple[State, State]:
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
    events = [Mark(c.time - since, c.kind, c.balls, c.wall) for c in log.brief() if counts(c)]
    lanes = []
    for name in log.names:
        own = legs[name]
        moved = _moved(own, since, now)
        spans = tuple((a - since, b - since, far / (b - a)) for _, a, b, far in moved)
        lanes.append(Travel(name, spans))
        rests = (leg.time for leg in own[1:] if leg.velocity == leg.roll == leg.acceleration == 0j)
        events += [Mark(time - since, "rest", (name,)) for time in rests]
    events.sort(key=lambda mark: mark.time)
    ends = [e.time for e in events] + [lane.legs[-1][1] for lane in lanes if lane.legs]
    return Story(tuple(lanes), tuple(events), max(ends, default=0.0))


NO_STORY = Story((), (), 0.0)


def forecast(world: World, since: float) -> Story:
    """Tell the shot that began at `since` to its end: what has happened and what will."""
    ahead = ahead_of(world)
    return NO_STORY if ahead is None else story(ahead.log, since, ahead.time)


def ahead_of(world: World) -> World | None:
    """A copy that has run to its end, or for a glimpse; None if the engine cannot go on."""
    ahead = world.copy()
    try:
        ahead.run(world.time + (HORIZON if rests(world) else GLIMPSE))
    except FAILS:
        return None
    return ahead


def path(log: Log, name: str, since: float, until: float) -> tuple[Place, ...]:
    """The way of a ball between two world times as points; straight legs are two."""
    return _way(log.legs(name), since, until)


def _way(legs: list[Leg], since: float, until: float) -> tuple[Place, ...]:
    moved = _moved(legs, since, until)
    return tuple(p for leg, a, b, _ in moved for p in _points(leg, a - leg.time, b - leg.time))


def _moved(legs: list[Leg], since: float, until: float) -> list[tuple[Leg, float, float, float]]:
    """The legs on which a ball got anywhere, each with the times between which it was on it, and
    how far it got."""
    ends = [leg.time for leg in legs[1:]] + [until] * bool(legs)
    pairs = zip(legs, ends, strict=True)
    spans = ((leg, max(leg.time, since), min(end, until)) for leg, end in pairs)
    known = ((leg, a, b, _far(leg, a, b)) for leg, a, b in spans if b > a)
    return [span for span in known if span[3] > MOVED]


def _far(leg: Leg, a: float, b: float) -> float:
    start = leg.time
    return abs(leg.place(b - start) - leg.place(a - start))


def _points(leg: Leg, a: float, b: float) -> list[Place]:
    """A leg as points; a straight one is its two ends."""
    v, g = leg.velocity, leg.acceleration
    bent = abs((v.conjugate() * g).imag) > 1e-9 * abs(v) * abs(g)
    # over a time h the parabola is |g| h² / 8 away from its chord
    steps = ceil((b - a) * sqrt(abs(g) / (8 * CHORD))) if bent else 1
    spots = (leg.place(a + (b - a) * k / steps) for k in range(steps + 1))
    return [(p.real, p.imag) for p in spots]


def _contact(met: Mark, legs: Legs, cue: str, since: float, world: World) -> FirstContact:
    ball = next(name for name in met.balls if name != cue)
    own, left = _around(legs[cue], since + met.time)
    other, sent = _around(legs[ball], since + met.time)
    line = complex(other.position[0] - own.position[0], other.position[1] - own.position[1])
    way = complex(*own.velocity) - complex(*other.velocity)
    turn = phase(line / way) if way else 0.0
    aside = abs(line) * abs((line / abs(line) / (way / abs(way))).imag) if way else 0.0
    overlap = 1.0 - aside / world.ball(cue).touching_distance(world.ball(ball))
    leaves = left.velocity, sent.velocity
    signed = -overlap if turn < 0 else overlap
    return FirstContact(ball, own.position, other.position, leaves, signed, abs(degrees(turn)))
