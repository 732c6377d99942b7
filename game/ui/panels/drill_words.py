"""What is said of the drill that is practised: its goal, what has been reached, the last stroke."""

from __future__ import annotations

from collections.abc import Hashable

import pygame

from danggu.players.goals import CLEAR, GOALS, STARS, ZONE
from game.practice.trainer import AWAY, OVER, Result, Trainer
from game.render.parts import cards, stars
from game.render.theme import BACKGROUND, TEXT, TEXT_SOFT
from game.ui.sight import Sight

from .toast import Toast

NUMBER = 96
"""Width of a number with its name, px at s = 1."""


def wanted(sight: Sight) -> bool:
    """Is a drill practised?"""
    return sight.trainer is not None and bool(sight.trainer.drill)


def key(sight: Sight) -> Hashable:
    """What the row above the table depends on."""
    assert sight.trainer is not None, "a drill is practised"
    return "drill", sight.trainer.version


def name(drill: str, w: dict[str, str]) -> str:
    """What a drill is called."""
    return w[f"position.{drill.partition('.')[2]}"]


def goal(drill: str, w: dict[str, str]) -> str:
    """What a drill asks for, in a line."""
    found, family = GOALS[drill], drill.partition(".")[0]
    pots = "" if family in ("pool", "snooker", "pyramid") else ".carom"
    text = w.get(f"goal.{found.kind}{pots}") or w[f"goal.{found.kind}"]
    return text.format(*found.steps)


def draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Draw name, stars and goal at the left, what has been reached at the right."""
    trainer, s, t, w = sight.trainer, sight.layout.s, sight.type, sight.words
    assert trainer is not None, "a drill is practised"
    surface.fill(BACKGROUND, rect)
    cards.card(surface, rect, s, raised=True)
    left, right = rect.x + round(16 * s), rect.right - round(16 * s)
    for label, value in reversed(_numbers(trainer, w)):
        middle = right - round(NUMBER / 2 * s)
        t.draw(surface, label, (middle, rect.y + 18 * s), 12, TEXT_SOFT, "centre")
        t.draw(surface, value, (middle, rect.y + 40 * s), 20, TEXT, "centre")
        right -= round(NUMBER * s)
    end = t.draw(surface, name(trainer.drill, w), (left, rect.y + 21 * s), 15, TEXT).right
    stars.draw(surface, (end + 10 * s, rect.y + 16 * s), 14 * s, trainer.reached.stars, STARS)
    said = w["drill.again"] if trainer.state in (AWAY, OVER) else goal(trainer.drill, w)
    said = t.fitted(said, 12, right - left - 8 * s)
    t.draw(surface, said, (left, rect.y + 39 * s), 12, TEXT_SOFT)
    return rect


def _numbers(trainer: Trainer, w: dict[str, str]) -> list[tuple[str, str]]:
    """The names and values of what has been reached."""
    kind, reached, result = trainer.goal.kind, trainer.reached, trainer.result
    best = "–" if reached.best is None else _value(kind, reached.best)
    now = str(trainer.count)
    if kind == ZONE:
        off = result.off if result is not None else None
        now = "–" if off is None else _value(kind, off)
    share = f"{reached.made}/{reached.tries}"
    return [(w[f"drill.now.{kind}"], now), (w["drill.best"], best), (w["drill.made"], share)]


def _value(kind: str, value: float) -> str:
    return f"{100 * value:.1f} cm" if kind == ZONE else f"{value:.0f}"


def tell(trainer: Trainer, toast: Toast, w: dict[str, str]) -> None:
    """Say over the table what the last stroke came to."""
    if trainer.result is not None:
        toast.show(_told(trainer, trainer.result, w), trainer.result.stars)


def _told(trainer: Trainer, result: Result, w: dict[str, str]) -> str:
    kind = trainer.goal.kind
    if result.off is not None:
        parts = [w["drill.off"].format(cm=f"{100 * result.off:.1f}")]
    elif not result.made:
        parts = [w["drill.missed"]]
    else:
        parts = [w["drill.stroke" if kind == CLEAR else "drill.row"].format(n=result.value)]
    if kind == CLEAR and trainer.state == OVER and result.made:
        parts = [w["drill.clear"].format(n=result.value)]
    if result.best:
        parts.append(w["drill.record"])
    if trainer.book.trouble:
        parts.append(w["drill.unsaved"])
    if trainer.state in (AWAY, OVER):
        parts.append(w["drill.again"])
    return " · ".join(parts)
