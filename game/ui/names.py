"""What players and scenes are called in the window."""

from __future__ import annotations

from game.session.terms import SKILLS, Terms
from game.table.lab_scenes import sheet


def player_name(terms: Terms, index: int, w: dict[str, str]) -> str:
    """Return how a player is called: the name that was given, or the usual one."""
    seat = terms.seats[index]
    if seat.name:
        return seat.name
    if seat.level in SKILLS:
        return w["player.computer"].format(level=w[f"level.{seat.level}"])
    return w["player.human"].format(n=index + 1)


def short_name(terms: Terms, index: int, w: dict[str, str]) -> str:
    """The name for a narrow place: a computer's without its level."""
    seat = terms.seats[index]
    if seat.name or seat.level not in SKILLS:
        return player_name(terms, index, w)
    return w["player.computer.short"]


def scene_name(key: str, w: dict[str, str], language: str) -> str:
    """Return what a scene is called; that of a lab has the lab's title."""
    return w.get(f"position.{key}") or sheet(key).title(language)
