"""What a referee sees of a stroke that is over: its log, and how the balls lie afterwards."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from danggu.rules import balkline
from danggu.rules.balkline import Area, Balkline
from danggu.rules.lie import snookered, touching
from danggu.rules.match import Match
from danggu.rules.pocketed import CUE
from danggu.rules.snooker import COLOUR, lowest
from danggu.rules.snooker import kind as colour_of
from danggu.rules.stroke import Rest, Stroke, stroke
from danggu.rules.verdict import Verdict
from physics import World

from .hand import Point

ANCHORED = {"balkline_47_1", "balkline_47_2", "balkline_71_2"}
FINE = 16  # points of a bent leg


def seen(world: World, match: Match) -> Stroke:
    """The stroke in the log of a world at rest, with what the rules of the match ask of the lie."""
    done = stroke(world.log.contacts(), match.cue)
    places = {ball.name: ball.position for ball in world.balls if not ball.gone}
    rest = Rest(touching(places, 2 * world.balls[0].radius))
    if isinstance(match.rules, Balkline):
        rest = _zones(world, match.rules, match.cue, rest)
    return replace(done, rest=rest)


def lie_of(world: World, verdict: Verdict, done: Stroke, match: Match) -> Stroke:
    """The stroke of snooker with whether the next player is snookered, once balls are spotted.

    verdict: on the stroke, without that.
    match: before the stroke.
    """
    state, cue = verdict.state, world.ball(CUE)
    if state is None or cue.gone or state.region:
        return done
    on = lowest(state) if verdict.passes or state.on != COLOUR else ""
    own = [b.position for b in world.balls if not b.gone and colour_of(b.name) == on]
    if not own:
        return done
    others = {
        b.name: b.position
        for b in world.balls
        if not b.gone and b.name != CUE and colour_of(b.name) != on
    }
    width = 2 * cue.radius
    hidden = snookered(cue.position, own, others.values(), width)
    free = match.call.ball if match.state.free else ""
    without = [at for name, at in others.items() if name != free]
    by = free if hidden and free and not snookered(cue.position, own, without, width) else ""
    return replace(done, rest=replace(done.rest, snookered=hidden, hidden=by))


# -- balkline --------------------------------------------------------------------------------------


def _zones(world: World, rules: Balkline, cue: str, rest: Rest) -> Rest:
    table = world.table
    first, second = (_way(world, name) for name in rules.balls if name != cue)
    areas, anchors = areas_of(rules.name, table.length, table.width)
    zone = balkline.zone(areas, first, second)
    return replace(rest, zone=zone, anchor=balkline.zone(anchors, first, second))


def areas_of(name: str, length: float, width: float) -> tuple[Sequence[Area], Sequence[Area]]:
    """The zones and the anchors of a game on a table of that size, m; "straight_rail" has its
    corners, and no anchors."""
    if name not in ANCHORED:
        return balkline.corners(length, width), ()
    apart = float(name.split("_")[1]) / 100 * width / 1.42
    if apart > 0.4 * width:  # 71: one line along the middle, six zones
        return _sixths(length, width, apart), _beside(length, width, apart)
    return balkline.squares(length, width, apart), balkline.anchors(length, width, apart)


def _sixths(length: float, width: float, apart: float) -> tuple[Area, ...]:
    xs = (-length / 2, -length / 2 + apart, length / 2 - apart, length / 2)
    ys = (-width / 2, 0.0, width / 2)
    return tuple(
        balkline.rectangle((xs[i], xs[i + 1]), (ys[j], ys[j + 1]))
        for i in range(3)
        for j in range(2)
    )


def _beside(length: float, width: float, apart: float) -> tuple[Area, ...]:
    """The anchors of 71/2: where each line meets a cushion."""
    every = balkline.anchors(length, width, apart)
    half = 0.178 / 2
    across = [
        balkline.rectangle(x, (-half, half))
        for x in ((-length / 2, 2 * half - length / 2), (length / 2 - 2 * half, length / 2))
    ]
    return (*every[:4], *across)


def _way(world: World, name: str) -> list[Point]:
    """The path of a ball during the stroke: points from first to last, m."""
    legs = world.log.legs(name)
    found: list[Point] = []
    for leg, after in pairwise(legs):
        parts = FINE if leg.acceleration else 1
        for k in range(parts):
            at = leg.place((after.time - leg.time) * k / parts)
            found.append((at.real, at.imag))
    return [*found, world.ball(name).position]
