"""Tables with pockets as the picture's tests use them: in the middle of a game, on a stage."""

from __future__ import annotations

import pygame

from game.render.layout import Layout
from game.session.session import Session
from game.settings.settings import Settings
from game.ui.table.stage import Stage
from physics import Ball, Shot, World, tables

TABLES = {
    "pool 9 ft": tables.pool(9), "pool 7 ft": tables.pool(7), "snooker": tables.SNOOKER_12FT,
    "pyramid": tables.PYRAMID_12FT,
}  # fmt: skip
RACKS = {"pool": "8-ball", "snooker": "snooker", "pyramid": "pyramid"}


def layout_of(table: tables.Table, size: tuple[int, int] = (1280, 720)) -> Layout:
    return Layout(size, table.length, table.width)


def racked(table: tables.Table) -> World:
    """A world with its rack, and the cue ball behind the line."""
    world = table.world()
    world.add(Ball("cue", at=(-0.3 * table.length, 0.05)))
    for ball in table.rack(RACKS[table.kind]):
        world.add(ball)
    return world


def break_off(session: Session, speed: float = 7.0) -> None:
    """Strike the cue ball towards the rack."""
    session.aim.texts = [f"{speed}", "0", "0", "0", "-3"]
    session.strike()


def a_stage(world: World, size: tuple[int, int] = (960, 540)) -> tuple[Session, Stage]:
    """A session on a world, and its table's pictures."""
    table = world.table
    session = Session(world)
    return session, Stage(Layout(size, table.length, table.width), session, Settings())


def shown(session: Session, stage: Stage) -> pygame.Surface:
    """The table drawn by a new stage, with the balls turned as on the first one."""
    fresh = Stage(stage.layout, session, stage.settings)
    fresh.take_over(stage)
    surface = pygame.Surface(stage.layout.size, 0, 32)
    fresh.everything(surface, session)
    return surface


def rolled(world: World, seconds: float, speed: float, angle: float) -> World:
    """The world after a stroke at the cue ball."""
    world.strike("cue", Shot(speed, angle))
    world.run(world.time + seconds)
    return world
