"""Where a stroke may begin: the cue ball as it lies, where it may be placed, or any ball at all."""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterator
from dataclasses import replace
from math import radians
from typing import NamedTuple

from danggu.rules.match import Match
from danggu.rules.state import ANYWHERE
from physics import Placed, World

from .chances import Eye
from .declaring import FREE_PYRAMID
from .hand import hindrance, usual
from .lies import lie_and_targets
from .plan import Point

BEHIND = (0.16, 0.32)  # m: between a ball placed for a pot and the ghost ball
CUTS = (0.0, 18.0, -18.0, 36.0, -36.0)  # degrees
OPENINGS = 8  # pockets for which a ball in hand is placed, the widest first
ACROSS = 8  # places across the table that are tried in a small region


class Start(NamedTuple):
    """Where a stroke begins.

    match: with the ball that is played, where any may be.
    place: where the cue ball is put first, m, or None.
    at: where it lies then, m.
    """

    match: Match
    place: Point | None
    at: complex


def starts(world: World, match: Match, eye: Eye) -> Iterator[Start]:
    """All starts that are worth a thought, the usual one first; ValueError if there is none."""
    state, cue = match.state, match.cue
    if state.region:
        yield from (Start(match, at, complex(*at)) for at in _places(world, match, eye))
        return
    there = {ball.name: complex(*ball.position) for ball in world.balls if not ball.gone}
    cues = [cue] if cue in there else []
    if match.rules.key == FREE_PYRAMID and match.call.cue == "":
        cues += [name for name in state.left if name != cue and name in there]
    if not cues:
        raise ValueError(f"there is no ball {cue!r} to play with")
    for name in cues:
        call = replace(match.call, cue=name) if name != cue else match.call
        yield Start(match.called(call), None, there[name])


def laid(world: World, start: Start) -> World:
    """A copy of the world in which the stroke begins so."""
    copy = world.copy()
    if start.place is not None:
        copy.ball(start.match.cue).placed = Placed(start.at)
    return copy


def _places(world: World, match: Match, eye: Eye) -> Iterator[Point]:
    region, cue = match.state.region, match.cue
    ball = world.ball(cue)

    def free(at: Point) -> bool:
        return hindrance(world, cue, at, region) is None

    lies = not ball.gone and free(ball.position)
    yield ball.position if lies else usual(world, cue, region)
    yield from filter(free, map(_written, _behind(world, match, eye)))
    if region != ANYWHERE:
        yield from filter(free, map(_written, _spread(world, region)))


def _written(at: Point) -> Point:
    """The place in tenths of a millimetre, which is how a person would enter it."""
    return round(at[0], 4), round(at[1], 4)


def _behind(world: World, match: Match, eye: Eye) -> Iterator[Point]:
    """Places from which a ball is easily potted."""
    lie, targets = lie_and_targets(world, match)
    found = []
    for name in targets:
        others = [at for ball, at in lie.items() if ball != name]
        found += [(o.half, lie[name], o.way) for o in eye.openings(lie[name], others)]
    found.sort(key=lambda one: -one[0])
    for _, at, way in found[:OPENINGS]:
        for far in BEHIND:
            for cut in CUTS:
                place = at - eye.width * way - far * way * rect(1.0, radians(cut))
                yield place.real, place.imag


def _spread(world: World, region: str) -> Iterator[Point]:
    """Places all over a region, from the line backwards."""
    table = world.table
    step = table.width / (2 * ACROSS)
    line = table.head_string or 0.0
    for back in (0.1, 2.0, 4.0):
        for k in range(1 - ACROSS, ACROSS):
            at = line - back * step, k * step
            if table.regions[region].contains(at):
                yield at
