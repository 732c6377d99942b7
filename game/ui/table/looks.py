"""Which ball looks how: names of balls to looks and words."""

from __future__ import annotations

from collections.abc import Mapping

from game.render.ball_sets import POOL, PYRAMID, SAFE_POOL, SAFE_SNOOKER, SNOOKER
from game.render.theme import BALLS, SAFE_BALLS, BallLook
from physics import World, tables

SETS: dict[str, dict[str, Mapping[str, BallLook]]] = {
    "carom": {"usual": BALLS, "safe": SAFE_BALLS},
    "pool": {"usual": POOL, "safe": SAFE_POOL},
    "snooker": {"usual": SNOOKER, "safe": SAFE_SNOOKER},
    "pyramid": {"usual": PYRAMID, "safe": PYRAMID},
}
"""By the kind of table: the usual balls, and those that colour-blind eyes can tell apart."""
KINDS = {"white": "white", "cue": "white", "yellow": "yellow"}
KINDS |= {"red": "red 1", "red1": "red 1", "red2": "red 2", "red 1": "red 1", "red 2": "red 2"}
OTHERS = ("red 1", "yellow", "red 2")


def kind_of(world: World) -> str:
    """The kind of the table that a world is of, "carom" without one."""
    return world.table.kind if isinstance(world.table, tables.Table) else "carom"


def look(name: str, place: int, colours: str = "usual", kind: str = "carom") -> BallLook:
    """Return the look of a ball in a set by its name, or by its place among the balls.

    kind: of the table, as `kind_of` has it; colours: "usual" or "safe".
    """
    found = SETS[kind][colours]
    if kind == "carom":
        return found[KINDS.get(name) or OTHERS[place % len(OTHERS)]]
    name = "cue" if name == "white" else name
    return found.get(name) or found.get(name.rstrip("0123456789 ")) or found[_other(found, place)]


def _other(found: Mapping[str, BallLook], place: int) -> str:
    """The look of a ball that no game knows."""
    names = [name for name in found if name != "cue"]
    return names[place % len(names)]


def looks_of(world: World, colours: str = "usual") -> list[BallLook]:
    """The looks of all balls of a world, in their order."""
    kind = kind_of(world)
    return [look(ball.name, i, colours, kind) for i, ball in enumerate(world.balls)]


def ball_words(name: str, words: dict[str, str]) -> str:
    """Return a ball's name in the words of a language."""
    known = words.get("ball." + name.replace(" ", ""))
    return known or words["ball.other"].format(name=name)
