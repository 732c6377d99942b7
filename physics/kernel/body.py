"""What the kernel works on: records, objects when interpreted, rows of arrays when compiled."""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from math import inf
from operator import attrgetter
from typing import Any, NamedTuple


@dataclass(slots=True, eq=False)
class Body:
    """A ball: what it is, the leg it is on, and its page of the calendar."""

    radius: float = 0.03275
    mass: float = 0.25
    # the leg: how it moves from `since` on
    since: float = 0.0
    position: complex = 0j
    velocity: complex = 0j
    acceleration: complex = 0j
    roll: complex = 0j  # the velocity at which it would roll with the spin it has, -i R ω
    side: float = 0.0  # R ω_z
    phase: int = 0
    # what ends the leg, and the box it sweeps till then
    leg_end: float = inf
    goal: int = -1
    west: float = 0.0
    east: float = 0.0
    south: float = 0.0
    north: float = 0.0
    # the calendar
    meets: float = inf
    partner: int = -1
    next: float = inf


_values = attrgetter(*Body.__slots__)


def twin(ball: Body) -> Body:
    """The same record once more."""
    return Body(*_values(ball))


@dataclass(slots=True, eq=False)
class Line:
    """A wall: the table is where (inward * p).real > offset."""

    normal: complex
    offset: float
    inward: complex  # the conjugate normal: (inward * v).real is the speed out of the wall


@dataclass(slots=True, eq=False)
class Felt:
    """The cloth: decelerations of sliding and rolling balls, m/s², and the loss of ω_z, rad/s²."""

    slide: float
    roll: float
    fade: float


@dataclass(slots=True, eq=False)
class Rule:
    """A law of collision: which one, and its coefficients."""

    kind: int
    restitution: float = 1.0
    friction: float = 0.0
    height: float = 0.0  # of the contact above the centre, in radii
    level: float = 1.0  # its distance from the vertical axis, sqrt(1 - height²)
    slide: float = 0.0  # friction at the cloth while a cushion is touched
    parting: float = 1e-3  # m/s: the least speed at which what touched parts


class Ties(NamedTuple):
    """Room for the contacts of a cluster: lists when interpreted, arrays when compiled."""

    member: Any
    first: Any
    second: Any
    chosen: Any
    target: Any
    grip: Any
    push: Any
    rub: Any
    total: Any


class Scene(NamedTuple):
    """All that an event may read or change."""

    balls: Any
    meetings: Any  # when ball i meets ball j, at n i + j
    walls: Any
    cloth: Any
    ball_rule: Any
    cushion_rule: Any
    cushion_table: Any
    ties: Ties


def ties(balls: int) -> Ties:
    """Room for as many contacts as discs on a table can have: three a ball."""
    pairs = 3 * balls
    whole, real = [0] * pairs, [0.0] * pairs
    return Ties(
        [0] * balls, whole, whole[:], whole[:], real, real[:], real[:], [0j] * pairs, real[:]
    )


def rows(items: Sequence[Any]) -> Any:
    """The same records as a numpy array: what the compiled kernel works on."""
    import numpy as np

    code = {"float": "f8", "complex": "c16", "int": "i8"}
    columns = fields(items[0])
    kinds = [f.type if isinstance(f.type, str) else f.type.__name__ for f in columns]
    layout = np.dtype(
        [(f.name, code[kind]) for f, kind in zip(columns, kinds, strict=True)], align=True
    )
    return np.array([tuple(getattr(item, f.name) for f in columns) for item in items], layout)
