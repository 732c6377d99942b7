"""The lag: how balls are laid for it, what one came to, and how the computer plays its own."""

from __future__ import annotations

from random import Random

from danggu.rules.lag import Lag, lagged
from danggu.rules.match import Match
from danggu.rules.pocketed import CUE
from danggu.rules.stroke import stroke
from physics import Shot, World, simulate

from .levels import Attempt, Level
from .spotting import lay, take

BEHIND = 0.05  # m behind the line from which balls are played
ASIDE = 0.2  # of the table's width, beside the middle
SLOW, FAST, HALVINGS = 1.0, 6.0, 14  # m/s: between these speeds one is looked for


def begun(world: World, match: Match) -> str:
    """Take all balls off but the one that the player at the table lags with; returns its name."""
    table, name = world.table, CUE if CUE in match.rules.cues else match.cue_of(match.at)
    for ball in world.balls:
        take(world, ball.name)
    line = table.head_string if table.head_string is not None else -0.25 * table.length
    aside = ASIDE * table.width * (1 if match.at else -1)
    lay(world, name, (line - BEHIND, aside))
    return name


def read(world: World, name: str, *, pool: bool) -> Lag:
    """What the stroke in the log of a world at rest came to."""
    done, ball = stroke(world.log.brief(), name), world.ball(name)
    gap = ball.position[0] - ball.radius + 0.5 * world.table.length
    return lagged(done, gap, far="east", near="west", pool=pool)


def shot(world: World, name: str, level: Level, rng: Random) -> Shot:
    """The stroke that stops just before the near cushion, with the level's error."""
    low, high = SLOW, FAST
    for _ in range(HALVINGS):
        speed = 0.5 * (low + high)
        after = simulate(world, name, Attempt(0.0, speed).shot())
        walls = {event.wall for event in after.log.brief()}
        low, high = (low, speed) if "west" in walls else (speed, high)
    return level.missed(Attempt(0.0, low), rng, world.ball(name).radius).shot()
