"""The rings in which the cue ball of a drill is to come to rest."""

from __future__ import annotations

import pygame

from danggu.players.goals import ZONE
from danggu.players.positions import metres
from game.practice.trainer import Trainer
from game.render.layout import Layout
from game.render.table import lines
from game.render.theme import GOLD


def key(trainer: Trainer | None) -> str:
    """What they depend on: the drill, if it has a zone."""
    return trainer.drill if trainer and trainer.drill and trainer.goal.kind == ZONE else ""


def draw(surface: pygame.Surface, layout: Layout, trainer: Trainer | None) -> list[pygame.Rect]:
    """Draw the rings, as far as they are on the bed."""
    if trainer is None or not key(trainer):
        return []
    at = layout.to_screen(*metres(trainer.goal.zone, layout.length, layout.width))
    clip = surface.get_clip()
    surface.set_clip(clip.clip(layout.bed))
    rects = []
    for ring, fill in zip(trainer.goal.rings(layout.length), (0.07, 0.12), strict=True):
        radius = ring * layout.scale
        rects.append(lines.ring(surface, at, radius, GOLD, 1.6 * layout.s, 0.75, fill))
    surface.set_clip(clip)
    return rects
