"""What actions do to the balls: strike, lay, place, stop and put back; and how they roll on."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING

from game.aim.preview import FAILS
from game.table import placing, presets
from physics import EventBudgetError, Placed, Shot, World

from . import equipment, timeline

if TYPE_CHECKING:
    from .session import Game


def moves(world: World) -> bool:
    """Does anything move, roll or spin on the spot?  What has left the table does not."""
    return any(
        not ball.lies or (ball.on_cloth and ball.spin[2] != 0.0) for ball in world.balls
    )


def strike(game: Game) -> None:
    """Play the shot in the boxes, if they hold one and the cue ball may be struck."""
    shot = game.aim.shot
    if shot is None:
        return
    if why := _refusal(game, shot):
        game.refuse(why)
        return
    game.arranging = False
    if not game.moving:
        game.lies = game.world.layout()
    game.head.live()
    game.world.log.clear()
    game.began = game.world.time
    game.world.strike(game.cue, shot)
    game.changed()
    game.shooter = game.cue
    if game.contest is not None:
        game.contest.struck(game.aim.texts)
    game.aim.spent()
    game.shots += 1
    game.moving = game.shown_shot = True
    game.read()


def _refusal(game: Game, shot: Shot) -> str:
    """Why the cue ball cannot be struck now, or ""."""
    if game.contest is not None and (why := game.contest.refusal(game)):
        return why
    if game.world.ball(game.cue).gone:
        return "off"
    return "flight" if shot.climb and game.engine != "exact" else ""


def put(game: Game, layout: Sequence[Placed]) -> None:
    """Put all balls back; those of a scene that had begun in motion move again."""
    game.head.live()
    if game.engine != "exact" and any(ball.height or ball.climb for ball in layout):
        equipment.engine(game, "exact")  # no other knows balls in the air
    game.world.recall(layout)
    game.world.log.clear()
    game.changed()
    game.began = game.world.time
    game.moving = game.shown_shot = moves(game.world)
    game.read()


def lay(game: Game, places: Sequence[presets.Place]) -> None:
    """Lay all balls down at rest, in their order, metres."""
    put(game, presets.lying(places))
    game.lies = game.world.layout()


def place(game: Game) -> None:
    """Lay all balls down at random; not those of a match, and not where there is no room."""
    if game.contest is not None:
        game.refuse("match")
        return
    try:
        places = presets.places(game.world, game.rng)
    except ValueError:
        game.refuse("room")
        return
    put(game, presets.lying(places))


def spot(game: Game, spots: World) -> None:
    """Lay what has left the table on its spot, or as near as there is room."""
    gone = [ball for ball in game.world.balls if ball.gone]
    for ball in gone:
        ball.position = placing.slid(game.world, ball.name, spots.ball(ball.name).position)
    if gone:
        game.changed()


def stop(game: Game) -> None:
    """Stop all balls; the stroke of a match goes on to its end instead, for it counts."""
    if game.contest is not None and game.moving:
        timeline.skip(game)
        return
    game.world.stop()
    if moves(game.world):
        game.changed()  # what was in the air falls
    else:
        game.rest()
    game.read()


def retry(game: Game) -> None:
    """The balls go back to where they lay before the last shot; the same entry may be shot."""
    if game.contest is not None:
        game.contest.take_back(game)
    put(game, game.lies)
    game.aim.leave()
    if not game.moving:
        game.aim.finish()


def roll(game: Game, dt: float) -> None:
    """Let the balls roll for dt seconds; an engine that cannot go on stops them, and says so."""
    before = len(game.world.log)
    game.calls += 1
    try:
        game.world.step(dt)
    except EventBudgetError:
        game.world.stop()
        game.warn("budget")
    except FAILS as error:
        warnings.warn(f"the engine failed: {error!r}", RuntimeWarning, stacklevel=2)
        game.put(game.lies)
        game.world.stop()
        game.warn("failed")
    game.events += max(len(game.world.log) - before, 0)
    if not moves(game.world):
        game.rest()
