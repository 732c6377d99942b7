"""Balls of carom that are laid elsewhere after a stroke: spotted, or in the opening position."""

from __future__ import annotations

from collections.abc import Sequence

from danggu.players.positions import THREE_CUSHION, opening
from danggu.players.spotting import carom_places, lay
from danggu.rules.match import Match
from danggu.rules.sagu import Sagu
from danggu.rules.verdict import Verdict
from physics import World

from . import moves


def spot(world: World, match: Match, names: Sequence[str]) -> bool:
    """Spot the balls of that name (UMB 3.7), all of them in the opening position; was there any?"""
    if len(names) == len(world.balls):
        open_up(world, match)
    else:
        for name, at in carom_places(world, match, names).items():
            lay(world, name, at)
    return bool(names)


def open_up(world: World, match: Match) -> None:
    """Lay all balls as the player at the table opens."""
    table = world.table
    game = "sagu" if isinstance(match.rules, Sagu) else THREE_CUSHION
    for name, at in opening(game, match.cue).on(table.length, table.width).items():
        lay(world, name, at)


def settled(
    world: World, before: Match, match: Match, verdict: Verdict | None, spots: World
) -> bool:
    """Lay the balls for the next stroke; returns whether any has been laid.

    before, match: before the stroke, and after it.
    spots: a world with the balls on their spots.
    """
    if match.reached and match.reached != before.reached and not match.finished:
        open_up(world, match)  # the last innings begin
        return True
    if verdict is None:
        return False
    if getattr(match.rules, "umb", False):
        return bool(verdict.facts.off) and spot(world, match, verdict.spot)
    return bool(verdict.facts.off) and moves.spot(world, spots)
