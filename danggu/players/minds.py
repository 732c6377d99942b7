"""Which opponent plays a game: one for those with pockets, one for all others."""

from __future__ import annotations

from danggu.rules.match import Match
from physics import World

from .levels import Level
from .opponent import EFFORT, Opponent
from .plan import Mind
from .potter import Potter
from .spotting import KINDS


def mind(world: World, match: Match, level: Level, seed: int = 0, effort: int = EFFORT) -> Mind:
    """An opponent that thinks about the coming stroke of the match; ValueError if the ball that it
    would play is not there."""
    if match.rules.key in KINDS:
        return Potter(world, match, level, seed, effort)
    return Opponent(world, match, level, seed, effort)
