"""What a player answers: the option after which the table is worth the most."""

from __future__ import annotations

from danggu.rules.match import Match
from physics import World

from .chances import Eye
from .levels import Level
from .worth import Worth


def answer(world: World, match: Match, level: Level) -> str:
    """The key of the best option for the player who is asked, balls lying as in `world`, of those
    that are as good the first; ValueError if there is no question."""
    if match.asked is None:
        raise ValueError("there is no question to answer")
    options = match.asked.options
    if world.table is None or world.table.pockets is None:
        return options[0].key
    judge = Worth(Eye(world.table, level), match)
    lie = {ball.name: complex(*ball.position) for ball in world.balls if not ball.gone}
    return max(options, key=lambda option: judge.option(match, option, lie)).key
