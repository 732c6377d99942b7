"""What a table is played with: engine, laws and cloth, and the set that a table came with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from game.table import presets
from physics import Cloth, World, laws


class Equipment(NamedTuple):
    """The laws and the cloth that a table came with."""

    ball_law: laws.BallLaw
    cushion_law: laws.CushionLaw
    cloth: Cloth

    @classmethod
    def of(cls, world: World) -> Equipment:
        """What a world has now."""
        return cls(world.ball_law, world.cushion_law, world.cloth)


def after(keys: Sequence[str], now: str) -> str:
    """The key that follows `now`, round the end; the first one after a key that is none of them."""
    return keys[(keys.index(now) + 1) % len(keys)] if now in keys else keys[0]


def with_engine(world: World, key: str) -> bool:
    """Give a world an engine; False if it keeps its own: only the exact one knows flying balls."""
    if key != "exact" and not all(ball.on_cloth for ball in world.balls):
        return False
    world.engine = presets.ENGINES[key]()
    return True


def with_laws(world: World, key: str, edition: int, own: Equipment) -> None:
    """Give a world a law set; the one that the table came with returns with its own numbers."""
    kinds = presets.law_set(key, edition)
    ball, cushion = kinds.ball(), kinds.cushion()
    if isinstance(cushion, laws.MathavanCushion):  # the nose belongs to the table, not to the law
        cushion = replace(cushion, nose=getattr(own.cushion_law, "nose", cushion.nose))
    if (type(own.ball_law), type(own.cushion_law)) == (type(ball), type(cushion)):
        ball, cushion = own.ball_law, own.cushion_law
    world.ball_law, world.cushion_law = ball, cushion


def with_cloth(world: World, key: str, edition: int, own: Equipment) -> None:
    """Give a world a cloth, or the one that the table came with ("table")."""
    world.cloth = presets.cloth(key, edition) or own.cloth
