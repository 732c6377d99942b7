"""The log as a ledger: where the energy of a scene has gone, event by event and leg by leg.

What the cloth takes is computed from its friction, not as the difference of two energies, so the
sum of all entries shows whether they are right.
"""

import csv
import os
from collections.abc import Iterator
from itertools import groupby
from math import fsum, sqrt
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.event import Event, State, States
from physics.kernel.kinds import AIRBORNE, ROLLING, SLIDING
from physics.kernel.motion import faded, length
from physics.log import SHOWN, Leg, Log
from physics.markup import table

if TYPE_CHECKING:
    import numpy.typing as npt


class Entry(NamedTuple):
    """One line.

    time: s.
    kind: as of an Event, or "hand" where a ball was placed or pushed by hand.
    ball, other, wall: names, or "".
    x, y: where, m.
    speed_before, speed_after, other_before, other_after: of ball and other, in space, m/s.
    closing: closing speed, m/s.
    impulse: N s.
    energy_lost: in the event, J; what a hand gave is a loss below zero.
    cloth_lost: by all balls on their legs since the entry before, J.
    energy: of all balls after it, J, of moving and turning and what gravity has stored in those
    aloft.
    height: of the ball, m.
    """

    time: float
    kind: str
    ball: str
    other: str
    wall: str
    x: float
    y: float
    speed_before: float
    speed_after: float
    other_before: float
    other_after: float
    closing: float
    impulse: float
    energy_lost: float
    cloth_lost: float
    energy: float
    height: float

    def __repr__(self) -> str:
        what = " ".join(filter(None, (self.ball, self.other, self.wall)))
        lost = f"{self.energy_lost:.4g} J and {self.cloth_lost:.4g} J to the cloth"
        return f"<{self.kind} at {self.time:.6g} s: {what}, lost {lost}>"


class Ledger(tuple[Entry, ...]):
    """The entries of a log, in their order; their losses and what is left add up to its start."""

    __slots__ = ()

    def table(self) -> "npt.NDArray[Any]":
        """As a NumPy structured array; its fields are those of Entry."""
        import numpy as np

        longest = max((len(str(value)) for entry in self for value in entry[1:5]), default=1)
        kinds = [(name, f"U{longest}" if kind is str else "f8")
                 for name, kind in Entry.__annotations__.items()]  # fmt: skip
        return np.array([tuple(entry) for entry in self], dtype=kinds)

    def lost(self) -> dict[str, float]:
        """J by cause, the greatest first: each kind of event, and "cloth"; below zero for what a
        hand gave."""
        causes: dict[str, list[float]] = {"cloth": [entry.cloth_lost for entry in self]}
        for entry in self:
            causes.setdefault(entry.kind, []).append(entry.energy_lost)
        sums = [(fsum(losses), cause) for cause, losses in causes.items()]
        return {cause: lost for lost, cause in sorted(sums, reverse=True)}

    def write_csv(self, path: str | os.PathLike[str]) -> None:
        """As a CSV file with a line of names; every number with all its digits."""
        with Path(path).open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(Entry._fields)
            writer.writerows(self)

    def _repr_html_(self) -> str:
        note = "" if len(self) <= SHOWN else f"{len(self)} entries"
        return table(Entry._fields, self[:SHOWN], note)

    def __repr__(self) -> str:
        lost = ", ".join(f"{cause} {joule:.4g}" for cause, joule in self.lost().items() if joule)
        return f"<Ledger of {len(self)} entries; J lost: {lost or 'none'}>"


def ledger(log: Log) -> Ledger:
    """Where the energy of what the log tells has gone.

    >>> from physics import Shot, scenes, simulate
    >>> book = ledger(simulate(scenes.carom(), "white", Shot(3.0, 1.0)).log)
    >>> [(cause, round(joule, 2)) for cause, joule in book.lost().items() if joule > 1e-9]
    [('cloth', 0.85), ('cushion', 0.22), ('ball', 0.06)]
    """
    return Ledger(_entries(log))


def _entries(log: Log) -> Iterator[Entry]:
    book = _Book(log)
    hands = book.hands()
    for begun, numbers in groupby(range(len(log)), log.begun):
        events = log[slice((run := list(numbers))[0], run[-1] + 1)]
        while hands and book.comes_first(hands[0], begun, events[0].time):
            yield book.by_hand(*hands.pop(0))
        yield from book.together(begun, events)
    for hand in hands:
        yield book.by_hand(*hand)


def cloth_loss(leg: Leg, mass: float, begin: float, end: float) -> float:
    """J that friction takes from a ball between `begin` and `end`, seconds into its leg.

    Sliding: ∫ m μ_s g |u| with |u| falling at 7/2 μ_s g; rolling: 7/5 of the work of the
    deceleration; spinning: 1/5 m (Rω_z)² falls with ω_z. In the air, nothing.
    """
    if leg.phase == AIRBORNE:
        return 0.0
    t, brake, fade = end - begin, length(leg.acceleration), leg.radius * leg.fade
    first, last = faded(leg.side, begin * fade), faded(leg.side, end * fade)
    lost = 0.2 * mass * (first - last) * (first + last)
    middle = 0.5 * (begin + end)
    if leg.phase == SLIDING:
        lost += mass * brake * t * (length(leg.velocity - leg.roll) - 3.5 * brake * middle)
    elif leg.phase == ROLLING:
        lost += 1.4 * mass * brake * t * (length(leg.velocity) - brake * middle)
    return float(lost)


class _Book:
    """Which leg every ball is on, and since when the cloth has not been charged."""

    def __init__(self, log: Log) -> None:
        self.log = log
        self.legs = [log.legs(name) for name in log.names]
        self.at = [0] * len(self.legs)
        self.time = log.start

    def hands(self) -> list[tuple[int, int]]:
        """The legs (ball, number) that were begun by hand and not by an event, in order of time."""
        begun = {leg for event in range(len(self.log)) for leg in self.log.begun(event)}
        put = [
            (i, k)
            for i, legs in enumerate(self.legs)
            for k in range(1, len(legs))
            if (i, k) not in begun
        ]
        return sorted(put, key=lambda leg: self.legs[leg[0]][leg[1]].time)

    def comes_first(
        self, hand: tuple[int, int], begun: tuple[tuple[int, int], ...], time: float
    ) -> bool:
        """Was that leg begun by hand before this event?"""
        i, k = hand
        when = self.legs[i][k].time
        return when < time or (when == time and self.at[i] == k - 1 and (i, k - 1) not in begun)

    def charge(self, time: float) -> float:
        """What the cloth has taken from all balls since the last call."""
        lost = 0.0
        for legs, k, mass in zip(self.legs, self.at, self.log.masses, strict=True):
            leg = legs[k]
            begin, end = (max(0.0, t - leg.time) for t in (self.time, time))
            if end > begin and (leg.phase or leg.side):
                lost += cloth_loss(leg, mass, begin, end)
        self.time = max(self.time, time)
        return lost

    def energy(self) -> float:
        """Of all balls, now."""
        return fsum(
            legs[k].after(max(0.0, self.time - legs[k].time)).energy(mass)
            for legs, k, mass in zip(self.legs, self.at, self.log.masses, strict=True)
        )

    def together(self, begun: tuple[tuple[int, int], ...], events: list[Event]) -> Iterator[Entry]:
        """The events of one instant that began the same legs."""
        cloth = self.charge(events[0].time)
        for i, k in begun:
            self.at[i] = k
        to_come = fsum(event.energy_lost for event in events)
        after = self.energy()
        for event in events:
            to_come -= event.energy_lost
            yield _entry(event, cloth, after + to_come)
            cloth = 0.0

    def by_hand(self, i: int, k: int) -> Entry:
        leg, mass = self.legs[i][k], self.log.masses[i]
        cloth = self.charge(leg.time)
        before = self.legs[i][k - 1]
        then = before.after(max(0.0, leg.time - before.time))
        self.at[i] = k
        name, lost = (self.log.names[i],), then.energy(mass) - leg.energy(mass)
        was, now = States(name, [then.state()]), States(name, [leg.state()])
        event = Event(leg.time, "hand", name, None, now[0].position, was, now, 0.0, 0.0, lost)
        return _entry(event, cloth, self.energy())


def _entry(event: Event, cloth: float, energy: float) -> Entry:
    before, after = ([_speed(s) for s in states] + [0.0] for states in (event.before, event.after))
    height = (event.after if event.kind == "hand" else event.before)[0].height
    return Entry(
        event.time, event.kind, event.balls[0], event.balls[1] if len(event.balls) > 1 else "",
        event.wall or "", *event.point, before[0], after[0], before[1], after[1], event.closing,
        event.impulse, event.energy_lost, cloth, energy, height,
    )  # fmt: skip


def _speed(state: State) -> float:
    x, y = state.velocity
    return sqrt(x * x + y * y + state.climb * state.climb)
