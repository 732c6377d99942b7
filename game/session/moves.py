"""Balls that move, stop and are put back: what the session asks of a world."""

from __future__ import annotations

import warnings
from functools import lru_cache

from game.aim.preview import FAILS, Story
from game.table import placing
from physics import EventBudgetError, World


def moves(world: World) -> bool:
    """Does anything move, roll or spin on the spot?  What has left the table does not."""
    return any(
        not ball.lies or (ball.on_cloth and ball.spin[2] != 0.0) for ball in world.balls
    )


def spot(world: World, spots: World) -> bool:
    """Lay what has left the table on its spot, or as near as there is room; was there anything?"""
    gone = [ball for ball in world.balls if ball.gone]
    for ball in gone:
        ball.position = placing.slid(world, ball.name, spots.ball(ball.name).position)
    return bool(gone)


@lru_cache(maxsize=8)
def of_note(story: Story, cue: str, most: int) -> tuple[str, ...]:
    """The balls of a shot that are worth a trace: the cue ball, those it hits, those that drop."""
    hit = [name for e in story.events if e.kind == "ball" and cue in e.balls for name in e.balls]
    down = [name for e in story.events if e.kind == "pocket" for name in e.balls]
    return tuple(dict.fromkeys([cue, *hit[:2], *down, *hit]))[:most]


def step(world: World, dt: float) -> str:
    """Let the balls roll for `dt` seconds; returns why they cannot: "budget" "failed", or "".

    After "failed" the world is as the engine has left it.
    """
    try:
        world.step(dt)
    except EventBudgetError:
        return "budget"
    except FAILS as error:
        warnings.warn(f"the engine failed: {error!r}", RuntimeWarning, stacklevel=2)
        return "failed"
    return ""
