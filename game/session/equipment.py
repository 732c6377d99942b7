"""What a game is played with, and how another engine, law, cloth, table or language is taken.

Each takes the key that is wanted, or without one goes on to the next.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from game.table import presets
from game.text import LANGUAGES
from physics import laws

if TYPE_CHECKING:
    from .session import Game


def _after(keys: Sequence[str], now: str) -> str:
    return keys[(keys.index(now) + 1) % len(keys)] if now in keys else keys[0]


def language(game: Game, key: str = "") -> None:
    """Say everything in another language."""
    game.language = key or _after([*LANGUAGES], game.language)


def engine(game: Game, key: str = "") -> None:
    """Continue with another engine; only the exact one knows balls in the air or off the table."""
    key = key or _after([*presets.ENGINES], game.engine)
    if key != "exact" and not all(ball.on_cloth for ball in game.world.balls):
        game.refuse("flight")
        game.engine = "exact"
        return
    game.world.engine = presets.ENGINES[key]()
    game.engine = key
    game.stamp += 1


def law(game: Game, key: str = "") -> None:
    """Continue with another law set; the set a table came with returns with its own numbers."""
    key = key or _after([*presets.LAWS], game.law)
    kinds = presets.law_set(key, game.edition)
    ball, cushion = kinds.ball(), kinds.cushion()
    own = game.came_with
    if isinstance(cushion, laws.MathavanCushion):  # the nose belongs to the table, not to the law
        cushion = replace(cushion, nose=getattr(own.cushion_law, "nose", cushion.nose))
    if (type(own.ball_law), type(own.cushion_law)) == (type(ball), type(cushion)):
        ball, cushion = own.ball_law, own.cushion_law
    game.world.ball_law, game.world.cushion_law = ball, cushion
    game.law = key
    game.stamp += 1


def cloth(game: Game, key: str = "") -> None:
    """Continue on another cloth, or on the one that the table came with ("table")."""
    key = key or _after([*presets.CLOTHS], game.cloth)
    game.world.cloth = presets.cloth(key, game.edition) or game.came_with.cloth
    game.cloth = key
    game.stamp += 1


def table(game: Game, key: str = "") -> None:
    """Lay the balls on another table, with its own cloth and laws; the engine stays."""
    key = key or _after([*presets.TABLES], game.table)
    game.begin(presets.table_world(key), key)
    engine(game, game.engine)
