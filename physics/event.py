"""What is read of a shot: how a ball moves at a moment, and what happened."""

from collections.abc import Iterable
from math import inf, sqrt
from typing import Any, NamedTuple, overload

from .shot import heading

Vector = tuple[float, float]


class State(NamedTuple):
    """A ball at a moment.

    position: (x, y), m.
    velocity: (vx, vy), m/s.
    spin: (wx, wy, wz), rad/s.
    height: above the cloth, m.
    climb: velocity upward, m/s.
    phase: what it does, as `Ball.phase` has it; "" where that is not known.
    """

    position: Vector
    velocity: Vector
    spin: tuple[float, float, float]
    height: float = 0.0
    climb: float = 0.0
    phase: str = ""

    @property
    def speed(self) -> float:
        """Over the table, m/s."""
        x, y = self.velocity
        return sqrt(x * x + y * y)

    @property
    def heading(self) -> float:
        """Where it moves to, degrees anticlockwise from +x, -180 to 180; 0 if it does not move."""
        return heading(complex(*self.velocity))

    def __repr__(self) -> str:
        x, y = self.position
        moving = f"{self.speed:.4g} m/s at {self.heading:.4g}°"
        aloft = f", {self.height:.4g} m high" if self.height else ""
        phase = f", {self.phase}" if self.phase else ""
        return f"<({x:.6g}, {y:.6g}) m, {moving}{aloft}{phase}>"


class States(tuple[State, ...]):
    """A State for each ball of an event, by its number or by its name."""

    names: tuple[str, ...]

    def __new__(cls, names: tuple[str, ...], states: Iterable[State]) -> "States":
        made = super().__new__(cls, states)
        made.names = names
        return made

    def __getnewargs__(self) -> tuple[tuple[str, ...], tuple[State, ...]]:
        return self.names, tuple(self)

    @overload  # type: ignore[override]
    def __getitem__(self, key: int | str) -> State: ...
    @overload
    def __getitem__(self, key: slice) -> tuple[State, ...]: ...
    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            if key not in self.names:
                raise KeyError(f"no ball {key!r} in this event, only {', '.join(self.names)}")
            key = self.names.index(key)
        return super().__getitem__(key)


class Event(NamedTuple):
    """One thing that happened.

    time: s; the same for all events of one instant.
    kind: "roll", "rest", "cushion", "ball" or "pocket" (it goes down), and for balls that fly
    "land" (on the cloth); "off" (over a cushion or out through a gap between walls, for good).
    balls: names.
    wall: name of the cushion or the pocket, or None.
    point: (x, y) of the contact (of the centre, where nothing touched), m.
    before, after: a State for each ball, by its number or its name: `event.after["red"]`.
    closing: speed along the contact's normal before, m/s (along the table at a cushion, and between
    balls on the cloth).
    energy_lost: J; in a cluster of contacts their common loss, shared by impulse.
    impulse: m |Δv| of the first ball, N s: push and rub together, less what is vertical, which the
    cloth takes up while a ball stays on it. In a cluster it is the push.
    push: the part of the impulse along the contact's normal (at a cushion and between balls on the
    cloth, the level one), N s.
    away: at a cushion, the greatest gap between it and the ball since they last touched, or since
    the log began, m; inf for other events. (docs/physics.md, "What an event says".)
    """

    time: float
    kind: str
    balls: tuple[str, ...]
    wall: str | None
    point: Vector
    before: States
    after: States
    closing: float
    impulse: float
    energy_lost: float
    push: float = 0.0
    away: float = inf

    def __repr__(self) -> str:
        what = ", ".join([*self.balls, *([self.wall] if self.wall else [])])
        closing = f", closing at {self.closing:.4g} m/s" if self.closing else ""
        return f"<{self.kind} at {self.time:.6g} s: {what}{closing}>"


class Contact(NamedTuple):
    """What the rules of a game need of an event "cushion", "ball", "pocket" or "off": no states.

    time, kind, balls, wall, away: as in Event.
    """

    time: float
    kind: str
    balls: tuple[str, ...]
    wall: str | None
    away: float = inf
