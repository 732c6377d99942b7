"""Who plays which game: the opponents of all games, by the keys of their rules."""

from __future__ import annotations

from danggu.rules.match import Match
from physics import World

from .answers import chosen
from .levels import Level
from .opponent import EFFORT, Opponent
from .plan import Answers, Maker, Mind
from .potter import Potter

POCKETS = (
    "eight_ball", "nine_ball", "ten_ball", "straight_pool", "snooker", "free_pyramid",
    "dynamic_pyramid", "combined_pyramid",
)  # fmt: skip
MINDS: dict[str, Maker] = dict.fromkeys(POCKETS, Potter)
"""What thinks about a stroke, by the key of the rules; for any other game it is `Opponent`."""
ANSWERS: dict[str, Answers] = {}
"""What answers questions, by the key of the rules; for any other game it is `chosen`."""


def mind(world: World, match: Match, level: Level, seed: int = 0, effort: int = EFFORT) -> Mind:
    """An opponent that thinks about the coming stroke of the match; ValueError if the ball that it
    would play is not there."""
    return MINDS.get(match.rules.key, Opponent)(world, match, level, seed, effort)


def answer(world: World, match: Match, level: Level, seed: int = 0) -> str:
    """The key of the option with which the player at the table answers; ValueError if nothing has
    been asked."""
    return ANSWERS.get(match.rules.key, chosen)(world, match, level, seed)
