"""Balls that fill the gap between obstacles, but for a little play."""

from cmath import phase, rect
from math import degrees, pi
from random import Random

from physics import Ball, Cloth, Post, Shot, Wall, World, laws
from physics.wall import Obstacle

from .trials import BALL_LAWS, RADIUS, Trial, engine

PLAYS = (0.0, *(10.0**-k for k in range(15, 3, -1)))  # m
LOSSY = (
    laws.RigidCushion(), laws.RigidCushion(0.9, 0.1, 1.4), laws.RigidCushion(0.85, 0.0),
    laws.RigidCushion(0.0, 0.5, 1.2), laws.MathavanCushion(),
)  # fmt: skip


def tight(k: int, dice: Random) -> Trial:
    """One to three balls in a row or a zigzag between two obstacles, perhaps beside a third."""
    world = World(Cloth(), dice.choice(BALL_LAWS[:6]), dice.choice(LOSSY), engine())
    play, across = PLAYS[k % len(PLAYS)], rect(1.0, dice.choice((0.0, dice.uniform(-pi, pi))))
    if across != 1.0:
        play += 1e-15  # above rounding
    spots = _zigzag(k // len(PLAYS) % 3 + 1, play, across, dice)
    lean = dice.choice((0.0, 0.0, 10.0 ** -dice.uniform(2.0, 12.0)))  # of one of the two
    faces = ((spots[0], across * rect(1.0, lean)), (spots[-1], -across))
    if dice.random() < 0.3:
        faces += ((spots[0], 1j * across),)
    for n, (spot, normal) in enumerate(faces):
        world.add(_obstacle(spot - (RADIUS + 0.5 * play) * normal, normal, f"o{n}", dice))
    for n, spot in enumerate(spots):
        world.add(Ball(f"{n}", at=(spot.real, spot.imag)))
    shot = Shot(
        dice.choice((0.01, 1.0, 3.0)), _angle(across, dice), side=dice.choice((0.0, 2.0)),
        follow=dice.choice((0.0, 1.0, 3.0)),
    )  # fmt: skip
    world.strike(dice.choice(world.balls), shot)
    return Trial(world)


def _zigzag(balls: int, play: float, across: complex, dice: Random) -> list[complex]:
    spots = [0j]
    bend = dice.choice((0.0, 0.0, 10.0 ** -dice.uniform(1.0, 9.0)))
    for n in range(1, balls):
        step = across * rect(1.0, bend if n % 2 else -bend)
        spots.append(spots[-1] + (2.0 * RADIUS + 0.5 * play) * step)
    return spots


def _obstacle(foot: complex, normal: complex, name: str, dice: Random) -> Obstacle:
    """A line, a segment or a post whose surface is at the foot."""
    kind, along = dice.randrange(3), dice.uniform(0.1, 1.0) * 1j * normal
    if kind == 0:
        return Wall.line(normal.real, normal.imag, -(normal.conjugate() * foot).real, name)
    if kind == 1:
        a, b = foot + along, foot - along
        return Wall.segment((b.real, b.imag), (a.real, a.imag), name)
    radius = dice.uniform(0.02, 0.2)
    centre = foot - radius * normal
    return Post((centre.real, centre.imag), radius, name)


def _angle(across: complex, dice: Random) -> float:
    """Along the gap, across it, or anyhow."""
    turned = dice.choice((0.0, 0.5 * pi, dice.uniform(-pi, pi), 10.0 ** -dice.uniform(1.0, 9.0)))
    return degrees(pi + phase(across) + turned)
