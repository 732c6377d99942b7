"""A scene with what was played in it, and its log and outcomes as plain data for JSON."""

from __future__ import annotations

from math import inf, isfinite, nan
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.ball import Ball
from physics.batch.outcomes import Outcomes
from physics.checks import array
from physics.kernel.kinds import KINDS, PHASE_NAMES
from physics.log import Leg, Log
from physics.shot import Shot, rows
from physics.simulation import simulate
from physics.world import World

from .node import Node
from .record import Data

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

PHASES = {name: number for number, name in PHASE_NAMES.items()}
EVENTS = {kind.name: number for number, kind in enumerate(KINDS)}
PAIRS = ("position", "velocity", "acceleration", "roll")  # of a leg: complex numbers


class Played(NamedTuple):
    """A world and what was played in it; all but the world may be None.

    world: as it was before the shot.
    ball, shot: the name of the ball that was struck, and how.
    log: what happened: that of the world after the shot.
    outcomes, shots: of a batch played in it, and its shots, (S, 5 or 6).
    """

    world: World
    ball: str | None = None
    shot: Shot | None = None
    log: Log | None = None
    outcomes: Outcomes | None = None
    shots: npt.NDArray[np.float64] | None = None

    @classmethod
    def of(cls, world: World, ball: Ball | str, shot: Shot) -> Played:
        """The scene of that shot, with its log; the world stays as it is."""
        after = simulate(world, ball, shot)
        return cls(world.copy(), world.ball(ball).name, shot, after.log)

    @classmethod
    def batch(cls, world: World, ball: Ball | str, shots: Any, outcomes: Outcomes) -> Played:
        """The scene of a batch: shots and outcomes as `simulate_many` takes and returns them."""
        name = world.ball(ball).name
        return cls(world.copy(), name, outcomes=outcomes, shots=array("shots", rows(shots)))

    def after(self) -> World:
        """The world after the shot, played again; as it is, if there is no shot."""
        if self.ball is None or self.shot is None:
            return self.world.copy()
        return simulate(self.world, self.ball, self.shot)

    def __repr__(self) -> str:
        parts = [f"{self.shot!r} at {self.ball}" if self.shot else "no shot"]
        parts += [f"{part!r}" for part in (self.log,) if part is not None]
        parts += [f"{len(self.outcomes.times)} outcomes"] if self.outcomes is not None else []
        return f"<Played with {len(self.world.balls)} balls: {', '.join(parts)}>"


# -- the log ---------------------------------------------------------------------------------------


def log_data(log: Log, world: World) -> Data:
    """All of a log; ValueError if it is of another world."""
    if log.names != [ball.name for ball in world.balls] or log._walls != [*world.walls]:
        raise ValueError("the log of a scene must be of its world: its balls or walls differ")
    return {
        "fields": [*Leg._fields],
        "legs": [[[*map(_plain, _phase_named(leg))] for leg in legs] for legs in log._legs],
        "events": [
            [epoch, time, KINDS[kind].name, *whole, _shared_data(shared)]
            for epoch, time, kind, *whole, shared in log._events
        ],
    }


def _phase_named(leg: tuple[Any, ...]) -> list[Any]:
    values = Leg(*leg)._asdict()
    return [*{**values, "phase": PHASE_NAMES[values["phase"]]}.values()]


def _plain(value: Any) -> Any:
    return [value.real, value.imag] if isinstance(value, complex) else value


def _shared_data(shared: Any) -> Any:
    """What the contacts of a cluster share; a contact that was asked nothing has null."""
    if shared is None:
        return None
    push, share, members, asked = shared
    targets = [[i, j, target if isfinite(target) else None] for i, j, target in asked]
    return {"push": push, "share": share, "members": members, "asked": targets}


def log_of(node: Node, world: World) -> Log:
    """The inverse of `log_data`, for the world that was saved with it."""
    log = Log()
    for ball in world.balls:
        log.register(ball.name, ball.mass)
    log.watch([*world.walls])
    if [one.text() for one in node["fields"].items()] != [*Leg._fields]:
        raise ValueError(f"{node.where}.fields must be {', '.join(Leg._fields)}")
    legs = node["legs"].items()
    if len(legs) != len(world.balls):
        raise ValueError(f"{node.where}.legs must be of {len(world.balls)} balls, not {len(legs)}")
    log._legs = [[_leg(leg) for leg in mine.items()] for mine in legs]
    events = [_event(event, log) for event in node["events"].items()]
    clusters: dict[tuple[Any, ...], tuple[Any, Any]] = {}
    for k, event in enumerate(events):  # contacts of one cluster have the same list of members
        if event[-1] is not None:
            push, share, members, asked = event[-1]
            same = clusters.setdefault((event[0], event[1], members, asked), (members, asked))
            events[k] = (*event[:-1], (push, share, *same))
    log._events = events
    return log


def _leg(node: Node) -> tuple[Any, ...]:
    values = node.items()
    if len(values) != len(Leg._fields):
        raise ValueError(f"{node.where} must be {len(Leg._fields)} values, not {len(values)}")
    made: list[Any] = []
    for name, value in zip(Leg._fields, values, strict=True):
        if name == "phase":
            made.append(_one_of(value, PHASES))
        else:
            made.append(value.complex() if name in PAIRS else value.number())
    return tuple(made)


def _event(node: Node, log: Log) -> tuple[Any, ...]:
    values = node.items()
    if len(values) != 9:
        raise ValueError(f"{node.where} must be 9 values, not {len(values)}")
    kind = _one_of(values[2], EVENTS)
    balls, walls = len(log.names), len(log._walls)
    other = {"wall": walls, "ball": balls}.get(KINDS[kind].other)
    numbers = [_index(values[3], other) if other is not None else int(values[3].number())]
    for k in (4, 6):
        ball = _index(values[k], balls)
        numbers += [ball, _index(values[k + 1], len(log._legs[ball]))]
    shared = None if values[8].value is None else _shared(values[8], log)
    return (values[0].number(), values[1].number(), kind, *numbers, shared)


def _shared(node: Node, log: Log) -> tuple[Any, ...]:
    members = []
    for member in node["members"].items():
        ball = _index(member.items()[0], len(log.names))
        members.append((ball, _index(member.items()[1], len(log._legs[ball]))))
    asked = [
        (int(i.number()), int(j.number()), -inf if target.value is None else target.number())
        for i, j, target in (each.items() for each in node["asked"].items())
    ]
    return node["push"].number(), node["share"].number(), tuple(members), tuple(asked)


def _one_of(node: Node, names: dict[str, int]) -> int:
    if node.text() not in names:
        raise ValueError(f"{node.where} is {node.value!r}; it must be one of {', '.join(names)}")
    return names[node.text()]


def _index(node: Node, count: int) -> int:
    number = int(node.number())
    if number != node.value or not 0 <= number < count:
        raise ValueError(f"{node.where} must be a number from 0 to {count - 1}, not {node.value!r}")
    return number


# -- the outcomes of a batch -----------------------------------------------------------------------


def outcomes_data(outcomes: Outcomes) -> Data:
    """Its arrays."""
    return {
        name: array_data(value) if hasattr(value, "dtype") else [*value]
        for name, value in outcomes._asdict().items()
    }


def array_data(values: Any) -> Data:
    """An array of numbers or of records of them; what is no number is null."""
    kind = values.dtype
    fields = [[name, kind.fields[name][0].str] for name in kind.names or ()]
    flat = values.ravel().tolist()
    numbers = [None if isinstance(x, float) and not isfinite(x) else x for x in flat]
    return {"type": fields or kind.str, "shape": values.shape, "data": numbers}


def outcomes_of(node: Node) -> Outcomes:
    """The inverse of `outcomes_data`."""
    parts = {name: node[name] for name in Outcomes._fields}
    made: dict[str, Any] = {
        name: tuple(part.value) if isinstance(part.value, list) else array_of(part)
        for name, part in parts.items()
    }
    if len({len(made[name]) for name in ("positions", "times", "events")}) != 1:
        raise ValueError(f"{node.where}: positions, times and events must be of as many shots")
    return Outcomes(**made)


def array_of(node: Node) -> npt.NDArray[Any]:
    """The inverse of `array_data`."""
    import numpy as np

    kind, data = node["type"].value, node["data"].items()
    try:
        fields = [(name, _numeric(each)) for name, each in kind] if isinstance(kind, list) else []
        if fields:
            flat = np.array([tuple(one.value) for one in data], np.dtype(fields, align=True))
        else:
            numbers = [nan if one.value is None else one.value for one in data]
            flat = np.array(numbers, _numeric(kind))
        return flat.reshape([int(one.number()) for one in node["shape"].items()])
    except (ValueError, TypeError) as error:
        raise ValueError(f"{node.where}: {error}") from None


def _numeric(kind: Any) -> np.dtype[Any]:
    import numpy as np

    found: np.dtype[Any] = np.dtype(kind)
    if found.kind not in "iufb":
        raise ValueError(f"{found!r} is no type of numbers")
    return found
