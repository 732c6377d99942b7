"""The shots of a batch and where the balls lie before each: taken in, and refused by name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from physics.ball import Placed
from physics.checks import LARGEST, array
from physics.kernel.body import COLUMNS, VX
from physics.kernel.kinds import RESTING
from physics.kernel.leg import DOWN
from physics.places import OVERLAP, off_bed
from physics.shot import NUMBERS, Shot, rows

if TYPE_CHECKING:
    from physics.ball import Ball
    from physics.world import World


MARKED = 62  # balls that a whole number of the kernel has room to mark


class Asked(NamedTuple):
    """What is to be played, checked.

    names: of the balls.
    struck: the number of the ball.
    table: (shots, 6), the shots.
    places: (shots, balls, 2) m, where the balls lie before each; (0, balls, 2): as in the world.
    before: (balls, COLUMNS), how they lie or move in the world.
    """

    names: tuple[str, ...]
    struck: int
    table: Any
    places: Any
    before: Any

    def cut(self, piece: slice) -> tuple[Any, Any]:
        """The rows of the table and the places of those shots."""
        return self.table[piece], self.places[piece]


def asked_of(
    world: World, ball: Ball | str, shots: Any, numbers: Mapping[str, Any], positions: Any
) -> Asked:
    """What is to be played; ValueError, naming it, if it cannot be."""
    world.plan()
    names = tuple([each.name for each in world.balls])
    cue = world.ball(ball)
    struck = names.index(cue.name)
    if positions is None:
        cue.on_table()
        table = table_of(shots, numbers, None)
        return Asked(names, struck, table, np.empty((0, len(names), 2)), before_of(world))
    places = places_of(world, struck, positions)
    table = table_of(shots, numbers, len(places))
    return Asked(names, struck, table, places, np.zeros((len(names), COLUMNS)))


def wanted(asked: Asked, until: Iterable[str], contacts: int) -> int:
    """The balls that a shot is played until they have been met, as kernel.body.Notes has them;
    ValueError for what is no other ball, and where no contacts are kept."""
    found = 0
    for name in until:
        if name not in asked.names or name == asked.names[asked.struck]:
            others = [each for each in asked.names if each != asked.names[asked.struck]]
            raise ValueError(f"until {name!r:.60}: the other balls are {', '.join(others)}")
        found |= 1 << asked.names.index(name)
    if found and contacts == 0:
        raise ValueError("simulate_many until= needs contacts=: how many are kept")
    if found >= 1 << MARKED:
        raise ValueError(f"simulate_many until= takes the first {MARKED} balls of a world")
    return found


def before_of(world: World) -> Any:
    """(balls, COLUMNS): how the balls of the world lie or move now, parted if they overlap."""
    if world.clock.loose:
        world = world.copy()
        world.part()
    bodies = [ball.body for ball in world.balls]
    for body in bodies:
        if body.phase != RESTING or body.side != 0.0:
            return np.array([start(ball) for ball in world.balls])
    return _at_rest([body.position + 0j for body in bodies])  # as most do, and quicker


_last: list[tuple[list[complex], Any]] = [([], None)]
"""The places of balls at rest that were asked for last, and what came of them: shots from one
layout, one after another, find it there."""


def _at_rest(places: list[complex]) -> Any:
    """(balls, COLUMNS), not to be written to: balls that lie there."""
    known, before = _last[0]  # looked at once: another thread may put its own there
    if known != places:
        before = np.zeros((len(places), COLUMNS))
        before[:, :VX] = np.array(places).view(float).reshape(-1, 2)
        before.setflags(write=False)
        _last[0] = places, before
    return before


def start(ball: Ball) -> tuple[float, ...]:
    """How a ball lies or moves now, in the order of the kernel's columns."""
    p, v, w, side, height, climb = ball.placed
    return p.real, p.imag, v.real, v.imag, w.real, w.imag, side, height, climb


def table_of(shots: Any, numbers: Mapping[str, Any], places: int | None) -> Any:
    """The shots as an array (shots, 6): given as they are, or number by number.

    places: for how many shots it has been said where the balls lie, or None.
    ValueError if one of them cannot be played, or if there are not as many as places.
    """
    if not numbers and shots is not None and places is None:  # as most are, and quicker
        return _listed_shots(shots)
    given = {name: value for name, value in numbers.items() if value is not None}
    for name in given.keys() - {*NUMBERS}:
        raise TypeError(f"simulate_many has no argument {name!r}")
    if shots is None:
        table = _spread(given, places)
    elif given:
        raise ValueError(f"simulate_many takes shots or {_listed(given)}, not both")
    else:
        table = _listed_shots(shots)
    if places is not None and len(table) != places:
        raise ValueError(f"there are {len(table)} shots, but positions for {places}")
    return table


def _check(table: Any) -> None:
    """ValueError for the first row that is no shot."""
    if (abs(table) <= LARGEST).all() and (table[:, 0] > 0.0).all():
        return
    for k, row in enumerate(table.tolist()):
        try:
            Shot(*row)
        except ValueError as error:
            raise ValueError(f"shot {k}: {error}") from None


def _listed(given: Mapping[str, Any]) -> str:
    return ", ".join(f"{name}=" for name in given)


def _spread(given: Mapping[str, Any], places: int | None) -> Any:
    """(shots, 6) from numbers or arrays (shots,) by name; what is not given is 0."""
    if "speed" not in given:
        raise ValueError("simulate_many needs shots, or at least speed=")
    columns = [array(name, given.get(name, 0.0)) for name in NUMBERS]
    try:
        shape = np.broadcast_shapes(*(each.shape for each in columns), (places or 1,))
    except ValueError:
        shape = ()
    if len(shape) != 1:
        sizes = [(name, columns[k].shape) for k, name in enumerate(NUMBERS) if name in given]
        said = ", ".join(f"{name}= {size}" for name, size in sizes)
        more = f" for {places} positions" if places is not None else ""
        raise ValueError(f"numbers or arrays (shots,) of one length, not {said}{more}")
    table = np.stack([np.broadcast_to(each, shape) for each in columns], axis=1)
    _check(table)
    return table


def _listed_shots(shots: Any) -> Any:
    try:
        if not isinstance(shots, np.ndarray):
            checked = all(type(shot) is Shot for shot in shots)
            shots = rows(shots)
            if checked and shots:
                return np.array(shots)
        table = array("shots", shots) if len(shots) else np.empty((0, 6))
    except (TypeError, ValueError):
        raise ValueError(
            f"shots must be Shots or rows of 5 or 6 numbers, not {shots!r:.80}"
        ) from None
    if table.ndim != 2 or table.shape[1] not in (5, 6):
        raise ValueError(f"shots must be Shots or an array (shots, 5 or 6), not {table.shape}")
    if table.shape[1] == 5:
        table = np.concatenate([table, np.zeros((len(table), 1))], axis=1)
    _check(table)
    return np.ascontiguousarray(table)


def places_of(world: World, struck: int, positions: Any) -> Any:
    """The positions as an array (shots, balls, 2), checked."""
    places, n = np.ascontiguousarray(array("positions", positions)), len(world.balls)
    if places.ndim != 3 or places.shape[1:] != (n, 2):
        raise ValueError(f"positions must be an array (shots, {n}, 2), not {places.shape}")
    gone = np.isnan(places)
    wrong = (gone[:, :, 0] != gone[:, :, 1]) | (abs(places) > LARGEST).any(axis=2)
    if wrong.any():
        shot, ball = map(int, np.argwhere(wrong)[0])
        where = tuple(places[shot, ball].tolist())
        raise ValueError(
            f"positions of shot {shot}: ball {world.balls[ball].name!r} must be at two finite"
            f" numbers, or at two NaN if it is not on the table, not {where}"
        )
    _check_places(world, struck, places)
    return places


def _check_places(world: World, struck: int, places: Any) -> None:
    """ValueError, with the number of the shot, for balls that do not fit where they are."""
    cue = world.balls[struck].name
    spots = places.view(complex)[:, :, 0]
    for shot in np.flatnonzero(_doubtful(world, spots) | np.isnan(spots[:, struck])):
        if np.isnan(spots[shot, struck]):
            raise ValueError(f"positions of shot {shot}: ball {cue!r} is not on the table")
        try:
            laid(world, places[shot]).plan()
        except ValueError as error:
            raise ValueError(f"positions of shot {shot}: {error}") from None


def _doubtful(world: World, spots: Any) -> Any:
    """(shots,): may something overlap?  Quick, and no for most; `laid` and its world know."""
    radii = np.array([ball.radius for ball in world.balls])
    gone = np.isnan(spots)
    doubtful = np.zeros(len(spots), bool)
    if getattr(world.table, "pockets", None) is not None:
        doubtful |= off_bed(spots, world.table).any(axis=1)
    for wall in world.walls:
        need = radii if wall.pushes else 0.0 * radii
        doubtful |= ~(gone | (wall.at_least(spots) >= need - 0.5 * OVERLAP)).all(axis=1)
    return doubtful | _near(world, spots, radii)


def _near(world: World, spots: Any, radii: Any) -> Any:
    """(shots,): do two balls lie nearer than those that just touch?"""
    lifts = np.array([ball.body.lift for ball in world.balls])
    first, second = np.triu_indices(len(radii), 1)
    apart = spots[:, first] - spots[:, second]
    square = apart.real**2 + apart.imag**2 + (lifts[first] - lifts[second]) ** 2
    reach = radii[first] + radii[second] - 0.5 * OVERLAP
    return (square < reach * reach).any(axis=1)


def laid(world: World, places: Sequence[Sequence[float]]) -> World:
    """A copy of the world with its balls lying still at these places, (balls, 2) m; with NaN, in a
    pocket."""
    copy = world.fork(world.log.fresh())
    for ball, (x, y) in zip(copy.balls, np.asarray(places).tolist(), strict=True):
        if x != x:
            ball.placed = Placed(0j, height=DOWN)
        else:
            ball.placed = Placed(complex(x, y))
            ball.position = x, y  # so that its place is checked
    return copy
