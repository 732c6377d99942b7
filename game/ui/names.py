"""What players are called in the window."""

from __future__ import annotations

from game.session.terms import SKILLS, Terms


def player_name(terms: Terms, index: int, w: dict[str, str]) -> str:
    """Return how a player is called: the name that was given, or the usual one."""
    seat = terms.seats[index]
    if seat.name:
        return seat.name
    if seat.level in SKILLS:
        return w["player.computer"].format(level=w[f"level.{seat.level}"])
    return w["player.human"].format(n=index + 1)
