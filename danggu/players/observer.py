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
from danggu.rules.stroke import Act, Rest, Stroke, stroke
from danggu.rules.verdict import Verdict
from physics import Leg, World

from .hand import Point

ANCHORED = {"balkline_47_1", "balkline_47_2", "balkline_71_2"}
FINE = 16  # points of a bent leg
GONE = {"off", "pocketed"}
GRAZE = 1e-6  # m by which a ball may seem to be over one that it only touches


def seen(world: World, match: Match) -> Stroke:
    """The stroke in the log of a world at rest, with what the rules of the match ask of the lie."""
    done = stroke(world.log.brief(), match.cue)
    places = {ball.name: ball.position for ball in world.balls if not ball.gone}
    rest = Rest(touching(places, 2 * world.balls[0].radius))
    if isinstance(match.rules, Balkline):
        rest = _zones(world, match.rules, match.cue, rest)
    acts = jumps(world, match.cue) if match.rules.key == "snooker" else ()
    return replace(done, rest=rest, acts=(*done.acts, *acts))


def jumps(world: World, cue: str) -> tuple[Act, ...]:
    """The cue ball's jump over a ball before it met any; none over the one that it met first, for
    where it came down then is not looked at."""
    log, own = world.log, world.ball(cue)
    met = next((c for c in log.brief() if c.kind == "ball" and cue in c.balls), None)
    until, first = (world.time, ()) if met is None else (met.time, met.balls)
    others = [ball for ball in world.balls if ball.name not in (cue, *first)]
    for leg, after in pairwise(log.legs(cue)):
        if leg.fall and leg.time < until:
            lasts = min(after.time, until) - leg.time
            for ball in others:
                lay, width = log.legs(ball.name)[0], own.touching_distance(ball) - GRAZE
                if lay.state().phase not in GONE and _nearest(leg, lay.position, lasts) < width:
                    return (Act(cue, "jumps", ball.name),)
    return ()


def _nearest(leg: Leg, spot: complex, lasts: float) -> float:
    """How near a ball that flies comes to a spot of the table, m."""
    away, v = spot - leg.position, leg.velocity
    speed = abs(v)
    time = (away * v.conjugate()).real / (speed * speed) if speed else 0.0
    return abs(away - min(max(time, 0.0), lasts) * v)


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
