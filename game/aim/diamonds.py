"""Where a stroke over each diamond leads: the engine plays it on the table at hand, without balls.

Systems of diamonds are tables of such numbers, measured on some table; here they are computed
for this one: its cloth, its cushions, and the place where the cue ball lies.
"""

from __future__ import annotations

from cmath import phase
from dataclasses import dataclass
from math import cos, degrees, radians, sin
from statistics import fmean
from typing import NamedTuple

from danggu.players.spotting import take
from danggu.rules.stroke import counts
from physics import EventDriven, Shot, World, simulate

from .preview import FAILS

Place = tuple[float, float]
BEHIND = 0.09
"""Metres from the nose line to the diamonds, in the middle of the rail's wood."""
CUSHIONS = 3
"""The cushion that is looked for."""
SPEED, FOLLOW, RUNNING = 4.0, 0.25, 1.0
"""The stroke of the corner system: m/s, and its follow and running side as parts of the speed, as
from a tip 0.1 R above and 0.4 R beside the centre."""
ACROSS = {"north": "south", "south": "north", "west": "east", "east": "west"}


class DiamondStroke(NamedTuple):
    """What is played over every diamond: speed and spins, m/s.

    running  does the side turn over, so that it always runs along the rail?
    """

    speed: float
    follow: float
    masse: float
    side: float
    running: bool = False


FIVE = DiamondStroke(SPEED, FOLLOW * SPEED, 0.0, RUNNING * SPEED, running=True)
"""The stroke of the corner system."""


class Diamond(NamedTuple):
    """A diamond, and where the ball meets its third cushion if it is played over it.

    at      the diamond, m
    number  its place along its rail, in diamonds: from the left, or from the near end
    rail    of the third cushion, "" where it is not met or the ball drops
    third   where on it, m
    value   that place along its rail, in diamonds
    first, last  the numbers of the corner system: ten a diamond, from the corner that the ball runs
            to; None where the third cushion is another rail than the system's
    right   does the ball run to the right along the rail, as one sees it from the table?
    """

    at: Place
    number: int
    rail: str = ""
    third: Place = (0.0, 0.0)
    value: float = 0.0
    first: float | None = None
    last: float | None = None
    right: bool = True


@dataclass(frozen=True, slots=True)
class DiamondFan:
    """The diamonds of the rail that is aimed at.

    rail    its name
    sights  of its diamonds, in their order
    """

    rail: str
    sights: tuple[Diamond, ...]

    def start(self, *, right: bool) -> tuple[float, float] | None:
        """The corner system's number of the cue ball's place for balls that run this way: first
        plus third, as the mean over the diamonds, and the most that one is off it; None if fewer
        than two have one."""
        ways = [s for s in self.sights if s.right == right]
        sums = [s.first + s.last for s in ways if s.first is not None and s.last is not None]
        if len(sums) < 2:
            return None
        mean = fmean(sums)
        return mean, max(abs(one - mean) for one in sums)


def aimed_at(world: World, cue: str, angle: float) -> str:
    """The rail that a ball meets first which leaves at an angle, degrees, if no ball is there."""
    ball, ahead = world.ball(cue), (cos(radians(angle)), sin(radians(angle)))
    half = _half(world)
    found = []
    for axis, names in enumerate((("west", "east"), ("south", "north"))):
        if abs(ahead[axis]) > 1e-12:
            side = 1 if ahead[axis] > 0.0 else -1
            reach = (side * (half[axis] - ball.radius) - ball.position[axis]) / ahead[axis]
            found.append((reach, names[side > 0]))
    return min(found)[1]


def fan(world: World, cue: str, rail: str, stroke: DiamondStroke) -> DiamondFan:
    """Play a stroke from where the cue ball lies over each diamond of a rail, without other balls.

    Engine: the exact one, whatever the world has.
    """
    alone = world.copy()
    alone.engine = EventDriven()
    for ball in world.balls:
        if ball.name != cue and not ball.gone:
            take(alone, ball.name)
    played = (_played(alone, cue, rail, sight, stroke) for sight in sights(world, rail))
    return DiamondFan(rail, (*played,))


def sights(world: World, rail: str) -> list[Diamond]:
    """The diamonds of a rail; not those that a pocket takes the place of."""
    half, long = _half(world), rail in ("north", "south")
    count, out = (8, half[1]) if long else (4, half[0])
    sign = 1 if rail in ("north", "east") else -1
    holes = any(not wall.pushes for wall in world.walls)
    taken = {0, count} | ({4} if long else set()) if holes else set()
    found = []
    for number in range(count + 1):
        along, beyond = (2 * number / count - 1) * half[0 if long else 1], sign * (out + BEHIND)
        if number not in taken:
            found.append(Diamond((along, beyond) if long else (beyond, along), number))
    return found


def _half(world: World) -> Place:
    """Half of the length and the width between the noses, m."""
    if world.table is not None:
        return world.table.length / 2, world.table.width / 2
    sides = {wall.name: wall.distance((0.0, 0.0)) for wall in world.walls}
    return (sides["west"] + sides["east"]) / 2, (sides["south"] + sides["north"]) / 2


def _played(world: World, cue: str, rail: str, sight: Diamond, stroke: DiamondStroke) -> Diamond:
    x, y = world.ball(cue).position
    way = complex(sight.at[0] - x, sight.at[1] - y)
    right = turns_right(way, rail)
    side = stroke.side * (1 if right or not stroke.running else -1)
    shot = Shot(stroke.speed, degrees(phase(way)), stroke.follow, stroke.masse, side)
    try:
        log = simulate(world, cue, shot).log
    except FAILS:
        return sight
    met = [
        (event.wall or "", event.after[0].position)
        for event in log
        if event.kind == "cushion" and event.balls[0] == cue and counts(event)
    ]
    sight = sight._replace(right=right)
    if len(met) < CUSHIONS or met[0][0] != rail or met[CUSHIONS - 1][0] not in ACROSS:
        return sight
    return _with_third(world, sight, rail, met[CUSHIONS - 1], right)


def turns_right(way: complex, rail: str) -> bool:
    """Does a ball on its way to a rail run to the right along it, seen from the table?"""
    out = {"north": 1j, "south": -1j, "east": 1 + 0j, "west": -1 + 0j}[rail]
    return (way / out).imag < 0.0


def _with_third(
    world: World, sight: Diamond, rail: str, third: tuple[str, Place], right: bool
) -> Diamond:
    """A diamond with where the third cushion is met, and the numbers of the corner system."""
    wall, at = third
    value = _along(world, wall, at)
    found = sight._replace(rail=wall, third=at, value=value)
    if wall != ACROSS[rail] or rail in ("west", "east"):
        return found
    # on the north rail a ball that turns right runs to the east, on the south rail to the west
    east = right == (rail == "north")
    last = 10 * (8 - value if east else value)
    first = 10.0 * (8 - sight.number if east else sight.number)
    return found._replace(first=first, last=last)


def _along(world: World, wall: str, at: Place) -> float:
    """Where on a rail a place is, in diamonds."""
    half = _half(world)
    long = wall in ("north", "south")
    axis, count = (0, 8) if long else (1, 4)
    return (at[axis] / half[axis] + 1.0) / 2 * count
