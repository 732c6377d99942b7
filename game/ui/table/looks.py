"""Which ball looks how: names of balls to looks and words."""

from __future__ import annotations

from game.render.theme import BALLS, SAFE_BALLS, BallLook

SETS = {"usual": BALLS, "safe": SAFE_BALLS}
"""The usual balls, and those that colour-blind eyes can tell apart."""
KINDS = {"white": "white", "cue": "white", "yellow": "yellow"}
KINDS |= {"red": "red 1", "red1": "red 1", "red2": "red 2", "red 1": "red 1", "red 2": "red 2"}
OTHERS = ("red 1", "yellow", "red 2")


def look(name: str, place: int, colours: str = "usual") -> BallLook:
    """Return the look of a ball in a set by its name, or by its place among the balls."""
    return SETS[colours][KINDS.get(name) or OTHERS[place % len(OTHERS)]]


def ball_words(name: str, words: dict[str, str]) -> str:
    """Return a ball's name in the words of a language."""
    known = words.get("ball." + name.replace(" ", ""))
    return known or words["ball.other"].format(name=name)
