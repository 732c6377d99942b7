"""What the kernel works on: records, objects when interpreted, rows of arrays when compiled."""

from collections import namedtuple
from collections.abc import Sequence
from dataclasses import dataclass, fields
from math import inf, sqrt
from operator import attrgetter
from typing import Any, NamedTuple

# the columns of a batch: how each ball lies or moves before, and in the first two where it ends
X, Y, VX, VY, ROLL_X, ROLL_Y, SIDE, HEIGHT, CLIMB = 0, 1, 2, 3, 4, 5, 6, 7, 8
COLUMNS = 9
SPEED, ANGLE, FOLLOW, MASSE, ENGLISH, JUMP = 0, 1, 2, 3, 4, 5  # and those of its shots
NUMBERS = 6

CONTACTS = 7  # a ball, in a cluster: five with balls (docs/physics.md), and two walls


@dataclass(slots=True, eq=False)
class Body:
    """A ball: what it is, the leg it is on, and its page of the calendar."""

    radius: float = 0.03275
    mass: float = 0.25
    lift: float = 0.0  # of the centre above the cloth that it lies on: its radius, or 0 for a disc
    # the leg: how it moves from `since` on
    since: float = 0.0
    position: complex = 0j
    velocity: complex = 0j
    acceleration: complex = 0j
    roll: complex = 0j  # the velocity at which it would roll with the spin it has, -i R ω
    side: float = 0.0  # R ω_z
    height: float = 0.0  # above the cloth; below 0 when it has left the table
    climb: float = 0.0  # the velocity upward
    fall: float = 0.0  # and what takes it, in the air
    phase: int = 0
    # what ends the leg, and the box it sweeps until then
    leg_end: float = inf
    goal: int = -1  # the number of the wall that does, or -1
    ending: int = 0  # the kind of event that does, see kernel/kinds.py
    west: float = 0.0
    east: float = 0.0
    south: float = 0.0
    north: float = 0.0
    # the calendar
    meets: float = inf
    partner: int = -1
    next: float = inf
    trapped: int = 0  # how many cushions it has hit in one instant
    # contacts that last, see kernel/lasting.py
    hopped: float = -1.0  # when it last met something, slowly; below 0: quickly
    met: int = -1  # and in whose event: the number of a ball
    hops: int = 0  # so many from contacts that last, in a row
    lent: float = 0.0  # the most that a contact was given to part with, m/s


_values = attrgetter(*Body.__slots__)


def twin(ball: Body) -> Body:
    """A copy of the record."""
    return Body(*_values(ball))


@dataclass(slots=True, eq=False)
class Felt:
    """The cloth: decelerations of sliding and rolling balls, m/s², and the loss of ω_z, rad/s²;
    and for balls in the air gravity, restitution and friction where they come down."""

    slide: float
    roll: float
    fade: float
    gravity: float = 0.0
    bounce: float = 0.0
    grip: float = 0.0
    still: float = 1e-12  # m/s: what is slower does not move, see motion.STILL


@dataclass(slots=True, eq=False)
class Band:
    """The rolling resistance of balls that are faster than `speed`, m/s, and no faster than the
    next band's: so many times the cloth's."""

    speed: float = 0.0
    share: float = 1.0


@dataclass(slots=True, eq=False)
class Rule:
    """A law of collision: which one, and its coefficients."""

    kind: int
    restitution: float = 1.0
    friction: float = 0.0
    height: float = 0.0  # of the contact above the centre, in radii
    level: float = 1.0  # its distance from the vertical axis, sqrt(1 - height²)
    slide: float = 0.0  # friction at the cloth while a cushion is touched
    parting: float = 1e-3  # m/s: the least speed at which touching bodies separate
    restitution_slope: float = 0.0  # what both gain for each m/s, see kernel/coefficients.py
    friction_slope: float = 0.0
    address: int = 0  # of a custom law's machine code, for the compiled kernel


@dataclass(slots=True, eq=False)
class Tie:
    """One contact of a cluster."""

    first: int = 0  # the ball it is between
    second: int = 0  # and the other, or -1 less the number of a wall
    target: float = 0.0  # the speed at which it closes, then at which it shall part
    grip: float = 0.0  # the coefficient of friction
    total: float = 0.0  # of all pushes
    # while it is solved together with others, see kernel/impulses.py
    line: complex = 0j  # from the first ball to the second
    size: float = 1.0  # impulses are counted in this, so that every contact yields by 1
    bound: float = 0.0  # the most that friction holds
    impulse: complex = 0j
    more: complex = 0j  # what of it the balls have not felt yet
    slope: complex = 0j
    way: complex = 0j
    answer: complex = 0j  # what an impulse along the way would change


@dataclass(slots=True, eq=False)
class Blow:
    """What trial impulses would do to a ball."""

    mass: float = 1.0
    radius: float = 1.0
    lift: float = 0.0
    velocity: complex = 0j
    roll: complex = 0j
    side: float = 0.0
    climb: float = 0.0
    contacts: int = 0  # of this ball, among those solved together
    # how it moved before, see kernel/plastic.py
    kept: complex = 0j
    kept_roll: complex = 0j


@dataclass(slots=True, eq=False)
class Seat:
    """A ball's place in the cells: its cell, its neighbours on the cell's list, its way out."""

    after: int = -1
    before: int = -1
    column: int = -1
    row: int = -1
    cross: float = inf  # when the ball leaves its cell
    edge: int = 0  # and over which edge
    turn: int = 0  # how many legs the ball has begun
    promise: int = 0  # what that was for its partner when their meeting was foreseen


@dataclass(slots=True, eq=False)
class Way:
    """A leg, kept after its ball has begun another, as long as it is near a wall; and when the ball
    that was struck first met the ball."""

    near: int = 0  # how many walls the ball has not left since they last touched
    since: float = 0.0
    position: complex = 0j
    velocity: complex = 0j
    acceleration: complex = 0j
    met: float = inf


@dataclass(slots=True, eq=False)
class Kept:
    """A contact as a batch keeps it: see kernel/notes.py."""

    kind: int = 0
    again: bool = False  # at a cushion that the ball has not left since it last touched it
    first: int = 0  # the number of the ball
    second: int = 0  # and of the other ball, the wall or the pocket
    time: float = 0.0  # since the shot, s


class Notes(NamedTuple):
    """Room for what a batch keeps of its shots."""

    most: int  # contacts of a shot, which are kept
    contacts: Any  # (shots, most)
    found: Any  # how many each shot has had
    ways: Any  # for each ball
    near: Any  # has ball i not left wall k since they last touched?  At i * walls + k
    until: int = 0  # the balls that a shot is played until they have been met, ball i as 1 << i


ROOMY = 2.11  # radii: a cell at least, so that all that may touch is in it or beside it
_places = attrgetter(*Seat.__slots__)


class Ties(NamedTuple):
    """Room for a cluster: lists when interpreted, arrays when compiled."""

    member: Any  # which balls
    contacts: Any
    chosen: Any  # which contacts are solved together
    blows: Any  # for each ball


class Grid(NamedTuple):
    """Cells over the table, each with a list of the balls in it; empty for few balls."""

    size: float
    west: float
    south: float
    columns: int
    rows: int
    head: Any  # of every cell's list
    seats: Any  # of the balls
    tree: Any  # the tournament of next events
    near: Any  # room for a list of neighbours


@dataclass(slots=True, eq=False)
class Scene:
    """All that an event may read or change.

    Compiled it is a tuple; interpreted, an object with slots, which CPython reads three times as
    fast: an event asks it fifteen times.
    """

    balls: Any
    meetings: Any  # when ball i meets ball j, at n i + j
    walls: Any
    cloth: Any
    ball_rule: Any
    cushion_rule: Any
    ties: Ties
    celled: bool  # is the grid used?
    grid: Grid
    lines: bool = True  # are all walls lines?
    rules: Any = ()  # the law of every wall, if one of them has its own
    frame: Any = ()  # in which only long walls matter, see kernel/obstacle.py
    bands: Any = ()  # of rolling resistance, from the slowest on, if it depends on the speed
    openings: Any = ()  # through which a ball leaves a table that does not close

    def _replace(self, **changes: Any) -> "Scene":
        """A copy with these changes, as of a tuple."""
        scene = Scene(*map(changes.pop, Scene.__slots__, _parts(self)))
        if changes:
            raise ValueError(f"a scene has no {', '.join(changes)}")
        return scene


_parts = attrgetter(*Scene.__slots__)
Packed: Any = namedtuple("Packed", Scene.__slots__)  # type: ignore[misc]  # when compiled


def ties(balls: int) -> Ties:
    """Room for as many contacts as there may be."""
    pairs = CONTACTS * balls
    return Ties(
        [0] * balls, [Tie() for _ in range(pairs)], [0] * pairs, [Blow() for _ in range(balls)]
    )


def no_ties(balls: int) -> Ties:
    """Room for balls that need none as long as no three touch: interpreted, it grows."""
    return Ties([0] * balls, [], [], [])


def no_grid(balls: int) -> Grid:
    """No cells: every ball is near."""
    return Grid(1.0, 0.0, 0.0, 0, 0, [], [], [], [0] * balls)


def grid(spots: Sequence[complex], radius: float) -> Grid:
    """Cells over the spots of balls up to that radius: not smaller than a ball, a ball in each."""
    n = len(spots)
    west, south = min(p.real for p in spots), min(p.imag for p in spots)
    length, width = max(p.real for p in spots) - west, max(p.imag for p in spots) - south
    size = max(ROOMY * radius, sqrt(length * width / n), length / n, width / n)
    columns, lines = max(1, int(length / size)), max(1, int(width / size))
    leaves = 1
    while leaves < n:
        leaves *= 2
    tree = [-1] * leaves + list(range(n)) + [-1] * (leaves - n)
    for node in range(leaves - 1, 0, -1):
        tree[node] = tree[2 * node]
    seats = [Seat() for _ in spots]
    return Grid(size, west, south, columns, lines, [-1] * (columns * lines), seats, tree, [0] * n)


def twin_grid(grid: Grid) -> Grid:
    """A copy of the cells."""
    seats = [Seat(*_places(seat)) for seat in grid.seats]
    return grid._replace(head=grid.head[:], seats=seats, tree=grid.tree[:], near=grid.near[:])


def celled(scene: Scene) -> Scene:
    """The scene with cells over its balls, in place of the table of all their meetings."""
    widest = max(ball.radius for ball in scene.balls)
    cells = grid([ball.position for ball in scene.balls], widest)
    return scene._replace(celled=True, grid=cells, meetings=[])


def twin_scene(scene: Scene, balls: list[Body]) -> Scene:
    """A copy of the scene, with those records of its balls."""
    n = len(balls)
    grid = twin_grid(scene.grid) if scene.celled else no_grid(n)
    meetings, walls = scene.meetings[:], scene.walls[:]
    return scene._replace(balls=balls, meetings=meetings, walls=walls, ties=no_ties(n), grid=grid)


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
