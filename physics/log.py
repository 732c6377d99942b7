"""What happened: every event, and every leg that a ball has moved on."""

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from math import fsum, inf
from typing import TYPE_CHECKING, Any, overload

from .away import Departures
from .checks import finite
from .event import Contact, Event, State, States
from .kernel.body import Body
from .kernel.impulses import WALL
from .kernel.kinds import AIRBORNE, CUSHION, KINDS, PAIR, Kind
from .kernel.motion import length
from .legs import Leg, along, kick, toward
from .wall import Obstacle

if TYPE_CHECKING:
    import numpy.typing as npt

    from .moments import Motion

__all__ = ["Contact", "Event", "Leg", "Log", "State"]

SHOWN = 30  # events, in a notebook
EVENTS = tuple(kind.name for kind in KINDS)
OTHERS = "wall", "ball"


class Log(Sequence[Event]):
    """The events in their order; each is computed when it is looked at."""

    def __init__(self, walls: list[Obstacle] | None = None) -> None:
        self.names: list[str] = []
        self._masses: list[float] = []
        self._walls = [] if walls is None else walls
        self._legs: list[list[tuple[Any, ...]]] = []
        self._events: list[tuple[Any, ...]] = []
        self._departures = Departures()

    # -- written by the world and its engine ---------------------------------------------------

    def register(self, name: str, mass: float) -> None:
        """One more ball."""
        self.names.append(name)
        self._masses.append(mass)
        self._legs.append([])

    def watch(self, walls: list[Obstacle]) -> None:
        """The walls that events will speak of, in their order."""
        self._walls = walls

    def begin(self, i: int, epoch: float, body: Body, fade: float) -> None:
        """Ball i is on a new leg."""
        self._legs[i].append(
            (epoch, body.since, body.position, body.velocity, body.acceleration, body.roll,
             body.side, body.phase, body.radius, fade, body.height, body.climb, body.fall,
             body.lift)
        )  # fmt: skip

    def begin_rest(self, epoch: float, bodies: Sequence[Body], fade: float) -> None:
        """The balls of which there is no leg are on their first."""
        if not all(self._legs):
            for i, body in enumerate(bodies):
                if not self._legs[i]:
                    self.begin(i, epoch, body, fade)

    def note(self, epoch: float, time: float, kind: int, i: int, other: int) -> None:
        """Something of that kind has happened to ball i, and wall or ball `other` if there is one;
        new legs have begun."""
        legs = self._legs
        j = other if kind == PAIR else i
        begun = i, len(legs[i]) - 1, j, len(legs[j]) - 1
        self._events.append((epoch, time, kind, other, *begun, None))

    def note_cluster(
        self,
        epoch: float,
        time: float,
        pairs: Sequence[tuple[int, int, float]],
        members: Sequence[int],
        asked: Sequence[tuple[int, int, float]],
    ) -> None:
        """Contacts (ball, ball or -1 - wall, impulse) of one instant among the members; new legs
        have begun.  Of contacts that last, also how fast each was asked to part."""
        last = tuple((m, len(self._legs[m]) - 1) for m in members)
        legs = dict(last)
        whole = fsum(push for _, _, push in pairs)
        for i, j, push in pairs:
            shared = (push, push / whole, last, asked)
            if j <= WALL:
                self._events.append(
                    (epoch, time, CUSHION, WALL - j, i, legs[i], i, legs[i], shared)
                )
            else:
                self._events.append((epoch, time, PAIR, j, i, legs[i], j, legs[j], shared))

    def clear(self) -> None:
        """Forget what happened, but not the legs that balls are on."""
        self._events.clear()
        self._departures.clear()
        for legs in self._legs:
            del legs[:-1]

    def mark(self) -> list[int]:
        """How long it is, for `rewind`."""
        return [len(self._events), *(len(legs) for legs in self._legs)]

    def rewind(self, mark: list[int]) -> None:
        """Forget what came after the mark."""
        for entries, count in zip([self._events, *self._legs], mark, strict=True):
            del entries[count:]
        self._departures.clear()

    def begun(self, event: int) -> tuple[tuple[int, int], ...]:
        """The legs that began with that event: (number of the ball, number of its leg)."""
        _, _, kind, _, i, leg_i, j, leg_j, shared = self._events[event]
        if shared is not None:
            return tuple(shared[2])
        return ((i, leg_i), (j, leg_j)) if kind == PAIR else ((i, leg_i),)

    def legs_when(self, events: int) -> list[Leg]:
        """The leg that each ball was on when there were so many events."""
        before: dict[int, int] = {}
        for event in range(max(0, events), len(self)):
            for ball, leg in self.begun(event):
                before.setdefault(ball, max(0, leg - 1))
        return [Leg(*legs[before.get(ball, -1)]) for ball, legs in enumerate(self._legs)]

    def copy(self) -> "Log":
        """The same history, to be continued apart."""
        log = self.fresh()
        log._legs = [legs[:] for legs in self._legs]
        log._events = self._events[:]
        return log

    def fresh(self) -> "Log":
        """An empty log of the same balls and walls."""
        log = Log()
        log.names, log._masses, log._walls = self.names[:], self._masses[:], self._walls
        log._legs = [[] for _ in self.names]
        return log

    # -- for reading ---------------------------------------------------------------------------

    def __len__(self) -> int:
        return len(self._events)

    @overload
    def __getitem__(self, index: int) -> Event: ...
    @overload
    def __getitem__(self, index: slice) -> list[Event]: ...
    def __getitem__(self, index: int | slice) -> Event | list[Event]:
        chosen = range(len(self))[index]
        return self._event(chosen) if isinstance(chosen, int) else [*map(self._event, chosen)]

    def __iter__(self) -> Iterator[Event]:
        return map(self._event, range(len(self)))

    def contacts(self) -> Iterator[Contact]:
        """The hits, and balls that go down or leave the table, in order; ten times as quick as the
        events."""
        return (self._contact(k, self._away(k)) for k in self._touched())

    def brief(self) -> Iterator[Contact]:
        """The same for rules, as batches keep them, quicker again: `away` is 0 where the ball had
        not left the cushion, and else inf."""
        return (self._contact(k, inf if self._left(k) else 0.0) for k in self._touched())

    def touches(self) -> Iterator[tuple[float, Kind, int, int, bool]]:
        """The same by number: time, kind, ball, other ball or wall, had it left the cushion?"""
        for k in self._touched():
            epoch, time, number, other, i, *_ = self._events[k]
            yield epoch + time, KINDS[number], i, other, self._left(k)

    def _touched(self) -> Iterator[int]:
        return (k for k, event in enumerate(self._events) if KINDS[event[2]].other in OTHERS)

    def _contact(self, index: int, away: float) -> Contact:
        epoch, time, number, other, i, *_ = self._events[index]
        kind, names = KINDS[number], self.names
        if kind.other == "ball":
            return Contact(epoch + time, kind.name, (names[i], names[other]), None)
        wall = self._walls[other].name if other >= 0 else None
        return Contact(epoch + time, kind.name, (names[i],), wall, away)

    def __repr__(self) -> str:
        return f"<Log of {len(self)} events>"

    def _repr_html_(self) -> str:
        from .markup import table

        head = "time, s", "event", "balls", "wall", "closing, m/s", "lost, J"
        rows = [
            (e.time, e.kind, ", ".join(e.balls), e.wall, e.closing, e.energy_lost)
            for e in self[:SHOWN]
        ]
        return table(head, rows, f"{len(self)} events" if len(self) > SHOWN else "")

    @property
    def masses(self) -> list[float]:
        """Of the balls in `names`, kg."""
        return self._masses[:]

    @property
    def start(self) -> float:
        """When the first leg begins, seconds."""
        return min((Leg(*legs[0]).time for legs in self._legs if legs), default=0.0)

    def legs(self, name: str) -> list[Leg]:
        """The legs of a ball, in their order."""
        return [Leg(*leg) for leg in self._legs[self.names.index(name)]]

    @overload
    def at(self, time: float) -> dict[str, State]: ...
    @overload
    def at(self, time: "npt.ArrayLike") -> "dict[str, Motion]": ...
    def at(self, time: "float | npt.ArrayLike") -> "dict[str, State] | dict[str, Motion]":
        """Every ball as it was at `time`, seconds; before the log began, as it began.

        At an array of times (T,), in any order, a Motion for each ball: the same in arrays.
        """
        if getattr(time, "ndim", 0) or (isinstance(time, Sequence) and not isinstance(time, str)):
            from .moments import moments, motion

            times = moments("Log.at time", time)
            return {name: motion(self._known(i), times) for i, name in enumerate(self.names)}
        time = finite("Log.at time", time)  # type: ignore[arg-type]
        return {name: self._leg(i, time).state() for i, name in enumerate(self.names)}

    def first(self, kind: str, *names: str) -> Event | None:
        """The first event of that kind in which all these balls and walls are, or None.

        ValueError for a kind, a ball or a wall of which the log has never heard.
        """
        return next(self._all(kind, names), None)

    def all(self, kind: str, *names: str) -> list[Event]:
        """All such events, in their order."""
        return [*self._all(kind, names)]

    def _all(self, kind: str, names: tuple[str, ...]) -> Iterator[Event]:
        walls = [wall.name for wall in self._walls]
        if kind not in EVENTS:
            raise ValueError(f"no event {kind!r}: there are {', '.join(EVENTS)}")
        for name in names:
            if name not in self.names and name not in walls:
                raise ValueError(f"there is no ball or wall {name!r} in this log")
        wanted = {*names}
        for k, (_, _, number, other, i, _, j, _, _) in enumerate(self._events):
            if KINDS[number].name == kind:
                wall = walls[other] if KINDS[number].other == "wall" and other >= 0 else None
                if wanted <= {self.names[i], self.names[j], wall}:
                    yield self._event(k)

    def _known(self, i: int) -> list[tuple[Any, ...]]:
        if not self._legs[i]:
            raise ValueError(f"nothing is known of ball {self.names[i]!r} before the world runs")
        return self._legs[i]

    def _leg(self, i: int, time: float) -> Leg:
        legs = self._known(i)
        k = bisect_right(legs, time, key=lambda leg: leg[0] + leg[1]) - 1
        leg = Leg(*legs[max(k, 0)])
        return leg.after(max(0.0, time - leg.epoch - leg.since))

    def _turn(self, i: int, leg: int, epoch: float, time: float) -> tuple[Leg, Leg]:
        """The end of the leg before, and the leg."""
        before = Leg(*self._legs[i][max(leg - 1, 0)])
        return before.after((epoch - before.epoch) + (time - before.since)), Leg(
            *self._legs[i][leg]
        )

    def _lost(self, i: int, turn: tuple[Leg, Leg]) -> float:
        return turn[0].energy(self._masses[i]) - turn[1].energy(self._masses[i])

    def _away(self, index: int) -> float:
        """How far a ball has been from the cushion that it meets in that event."""
        return self._departures.gap.before(index, self._events, self._legs, self._walls)

    def _left(self, index: int) -> bool:
        """Has it been more than a millimetre from it?"""
        return self._departures.left.before(index, self._events, self._legs, self._walls)

    def _event(self, index: int) -> Event:
        epoch, time, number, other, i, leg_i, j, leg_j, shared = self._events[index]
        kind, first = KINDS[number], self._turn(i, leg_i, epoch, time)
        lost = self._lost(i, first)
        names: tuple[str, ...] = (self.names[i],)
        turns: tuple[tuple[Leg, Leg], ...] = (first,)
        point, normal, rise = first[1].position, 0j, -1.0 if kind.other == "cloth" else 0.0
        wall = self._walls[other] if kind.other == "wall" and other >= 0 else None
        if wall and kind.closes:
            spot = point.real, point.imag
            normal = -wall.facing(spot)
            point += wall.distance(spot) * normal
        elif kind.other == "ball":
            second = self._turn(j, leg_j, epoch, time)
            names, turns = (self.names[i], self.names[j]), (first, second)
            normal, rise = toward(first[1], second[1])
            point += first[1].radius * normal
            lost += self._lost(j, second)
        closing = along(first[0], normal, rise)
        push = self._masses[i] * (closing - along(first[1], normal, rise))
        impulse = self._masses[i] * kick(*first) if kind.contact else 0.0
        if kind.other == "ball":
            closing -= along(second[0], normal, rise)
            if rise and AIRBORNE not in (first[0].phase, second[0].phase):
                level = length(normal)
                closing, push = closing / level, push / level
        if shared is not None:
            push, share, members, _ = shared
            impulse = push
            lost = share * fsum(
                self._lost(m, self._turn(m, leg, epoch, time)) for m, leg in members
            )
        return Event(
            epoch + time, kind.name, names, wall and wall.name, (point.real, point.imag),
            States(names, (turn[0].state() for turn in turns)),
            States(names, (turn[1].state() for turn in turns)),
            closing, impulse, lost, push, self._away(index),
        )  # fmt: skip
