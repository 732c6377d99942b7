"""The hand that lays balls between strokes: what is spotted, racked, removed, or put in hand.

The rules say which balls; here it is done to a world at rest. `GameState.left` says which object
balls are on the table: what lies there beside them is taken off, what is missing is spotted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import dist

from danggu.rules import GAMES, RACKS
from danggu.rules.match import Match
from danggu.rules.nine_ball import NineBall
from danggu.rules.pocketed import CUE
from danggu.rules.snooker import COLOURS
from danggu.rules.spots import CENTRE, FOOT, HEAD, along, carom_spots, colour_spots, respotted
from danggu.rules.state import KITCHEN
from danggu.rules.straight_pool import ELSEWHERE, RACK
from danggu.rules.straight_pool import racked as moved_by_rack
from physics import Ball, Placed, World

from .hand import GAP, Point, hindrance, usual

KINDS = {GAMES[game]().key: kind for game, kind in RACKS.items()}
"""How a game is racked, by the key of its rules: what `Table.rack` takes."""
LOOSE = 5e-5  # m: how far balls of a rack lie off their places; no rack is perfect
IN_A_POCKET = -2.0  # m: the height of a ball that is down


def take(world: World, name: str) -> None:
    """Take a ball off the table, as if it had been pocketed."""
    ball = world.ball(name)
    if not ball.gone:
        ball.placed = Placed(complex(*ball.position), height=IN_A_POCKET)


def lay(world: World, name: str, at: Point) -> None:
    """Lay a ball down at rest, m."""
    world.ball(name).placed = Placed(complex(*at))


def opened(world: World, match: Match, seed: int) -> None:
    """Rack all balls for a break, and put the cue ball in hand; balls that are not in the world
    yet are added."""
    there = {ball.name for ball in world.balls}
    places = {CUE: (0.0, 0.0), **dict(rack(world, match, seed))}
    for name in (CUE, *match.rules.balls):
        if name not in there:
            world.add(Ball(name, places[name]))
            there.add(name)
        lay(world, name, places[name])
    lay(world, CUE, usual(world, CUE, match.state.region))


def settled(world: World, match: Match, spot: Sequence[str], count: int, seed: int) -> Match:
    """Lay the balls for the stroke that comes; returns the match, with the cue ball in hand where
    a rack has taken its place.

    spot: the balls that are spotted, in their order.
    count: how many are racked, 0 for none.
    """
    if match.rules.key not in KINDS:
        return match
    left = {*match.state.left}
    if count:
        match = _racked(world, match, count, seed)
    else:
        for ball in world.balls:
            if ball.name != CUE and ball.name not in left:
                take(world, ball.name)
        missing = [ball.name for ball in world.balls if ball.gone and ball.name in left]
        named = [name for name in dict.fromkeys(spot) if name in missing]
        spot_all(world, match, [*named, *(name for name in missing if name not in named)])
    in_hand(world, match)
    return match


def in_hand(world: World, match: Match) -> None:
    """Put a cue ball that is in hand where it may be, unless it is there already.

    While a question is open, a ball that still lies on the table stays.
    """
    region, cue = match.state.region, match.cue
    if not region or match.asked is not None or match.finished:
        return
    ball = world.ball(cue)
    if ball.gone or hindrance(world, cue, ball.position, region) is not None:
        lay(world, cue, usual(world, cue, region))


def spot_all(world: World, match: Match, names: Sequence[str]) -> None:
    """Spot balls of a game with pockets, one after the other."""
    if match.rules.key == "snooker":
        _spot_colours(world, names)
        return
    spots, half = world.table.spots, 0.5 * world.table.length - world.table.radius
    start = spots.get("foot") or spots["back"]
    for name in names:
        _on_line(world, name, start, (half, 0.0))


def _spot_colours(world: World, names: Sequence[str]) -> None:
    spots, half = world.table.spots, 0.5 * world.table.length - world.table.radius
    colours = [name for name in names if name in COLOURS]
    if not colours:
        return
    taken = [name for name in COLOURS if _occupied(world, spots[name])]
    for name, spot in colour_spots(colours, taken).items():
        if spot:
            lay(world, name, spots[spot])
        else:
            _on_line(world, name, spots[name], (half, spots[name][1]))


def _occupied(world: World, at: Point) -> bool:
    """Whether a ball laid there would overlap another one."""
    near = 2 * world.table.radius
    return any(dist(ball.position, at) < near for ball in world.balls if not ball.gone)


def _on_line(world: World, name: str, start: Point, end: Point) -> None:
    """Lay a ball as near to a spot as there is room, towards a cushion or else away from it."""
    others = [ball.position for ball in world.balls if not ball.gone and ball.name != name]
    far = (-end[0], end[1])
    for to in (end, far):
        at = along(start, to, others, 2 * world.table.radius + GAP)
        if at is not None:
            lay(world, name, at)
            return
    lay(world, name, usual(world, name, "anywhere"))


# -- racks -----------------------------------------------------------------------------------------


def rack(world: World, match: Match, seed: int) -> list[tuple[str, Point]]:
    """Names and places of the balls of a full rack, the apex first, m."""
    table = world.table
    balls = table.rack(KINDS[match.rules.key], disorder=LOOSE, seed=seed)
    places = [(ball.name, ball.position) for ball in balls]
    if isinstance(match.rules, NineBall) and match.rules.on_foot_spot == "9":
        x = table.spots["foot"][0] - dict(places)["9"][0]
        places = [(name, (at[0] + x, at[1])) for name, at in places]
    return places


def _racked(world: World, match: Match, count: int, seed: int) -> Match:
    """Rack so many balls; with fourteen the last one stays where it can (14.1)."""
    full = rack(world, match, seed)
    if count == len(full):
        own = world.ball(CUE)
        for name, at in full:
            lay(world, name, at)
        clear = own.gone or match.state.region or not _in_the_way(own.position, full, own.radius)
        return match if clear else _handed(match)
    last = next((ball.name for ball in world.balls if ball.name != CUE and not ball.gone), "")
    if not last:
        return match
    rest = [name for name, _ in full if name != last]
    spot, cue = moved_by_rack(_whereabouts(world, last, full), _whereabouts(world, CUE, full))
    take(world, last)
    for name, (_, at) in zip(rest, full[1:], strict=True):
        lay(world, name, at)
    apex = full[0][1]
    lay(world, last, apex if spot == FOOT else _spot(world, spot) or world.ball(last).position)
    if cue == KITCHEN:
        return _handed(match)
    if moved := _spot(world, cue):
        lay(world, CUE, moved)
    return match


def _handed(match: Match) -> Match:
    return replace(match, state=replace(match.state, region=KITCHEN))


def _spot(world: World, spot: str) -> Point | None:
    """The place of a spot that `straight_pool.racked` names, None if the ball stays."""
    at: Point | None = world.table.spots.get(spot) if spot in (HEAD, CENTRE) else None
    return at


def _whereabouts(world: World, name: str, full: Sequence[tuple[str, Point]]) -> str:
    ball, table = world.ball(name), world.table
    if _in_the_way(ball.position, full, ball.radius):
        return RACK
    if dist(ball.position, table.spots["head"]) < 2 * ball.radius:
        return HEAD
    return KITCHEN if table.regions["kitchen"].contains(ball.position) else ELSEWHERE


def _in_the_way(at: Point, full: Sequence[tuple[str, Point]], radius: float) -> bool:
    return any(dist(at, place) < 2 * radius for _, place in full)


# -- carom -----------------------------------------------------------------------------------------


def carom_places(world: World, match: Match, names: Sequence[str]) -> dict[str, Point]:
    """Where balls of carom go that are spotted (UMB 3.7), m; `match.cue` plays next."""
    marks = world.table.spots
    other = next(name for name in match.rules.cues if name != match.cue)
    spots = carom_spots(match.cue, other)
    staying = [b for b in world.balls if not b.gone and b.name not in names]
    covered = {
        spot: ball.name
        for spot in (FOOT, HEAD, CENTRE)
        for ball in staying
        if dist(ball.position, marks[spot]) < 2 * ball.radius
    }
    return {b: marks[s] for b, s in respotted(names, spots, covered).items()}
