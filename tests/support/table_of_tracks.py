"""Synthetic tables with known truth: tracks of strokes, as a camera would have them."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from physics import Ball, Shot, World, laws, tables
from physics.studies.tracks import Track, filmed

NOSE = 0.037 / 0.03075
RADIUS, MASS = tables.MATCH_CAROM.radius, tables.MATCH_CAROM.mass
UNKNOWN = ("cloth.slide", "cloth.roll", "cushion.e", "cushion.mu")
RANGES = {
    "cloth.slide": (0.15, 0.3), "cloth.roll": (0.004, 0.012), "cushion.e": (0.75, 0.92),
    "cushion.mu": (0.14, 0.27),
}  # fmt: skip


class Case(NamedTuple):
    """world: with the poor values that a fit begins with.  truth: (n,) of UNKNOWN."""

    world: World
    tracks: list[Track]
    truth: np.ndarray


def table(slide: float, roll: float, e: float, mu: float, *places: complex) -> World:
    world = tables.match_carom(edition=1)
    world.cloth = replace(world.cloth, slide=slide, roll=roll, spin_decay=4.3)
    world.cushion_law = laws.RigidCushion(e, mu, NOSE)
    world.ball_law = laws.RoughBall(0.946, 0.05)
    for name, place in zip(("white", "yellow", "red"), places, strict=True):
        world.add(Ball(name, (place.real, place.imag), radius=RADIUS, mass=MASS))
    return world


def spots(chance: np.random.Generator) -> list[complex]:
    """Three places on the table, not too near to each other."""
    found: list[complex] = []
    while len(found) < 3:
        spot = complex(chance.uniform(-1.3, 1.3), chance.uniform(-0.6, 0.6))
        if all(abs(spot - other) > 0.15 for other in found):
            found.append(spot)
    return found


def stroke(chance: np.random.Generator) -> Shot:
    speed = chance.uniform(2.0, 5.0)
    follow, side = chance.uniform(-0.3, 0.9), chance.uniform(-0.6, 0.6)
    return Shot(speed, chance.uniform(0.0, 360.0), follow * speed, 0.0, side * speed)


def case(seed: int, strokes: int = 4, rate: float = 50.0, lost: float = 0.0) -> Case:
    """A table, some strokes on it, and values that are up to 30 % wrong."""
    chance = np.random.default_rng(seed)
    truth = np.array([chance.uniform(*RANGES[name]) for name in UNKNOWN])
    tracks = []
    for _ in range(strokes):
        world = table(*truth, *spots(chance))
        tracks.append(filmed(world, "white", stroke(chance), chance, rate=rate, lost=lost))
    poor = truth * chance.uniform(0.7, 1.3, len(truth))
    poor[2] = min(poor[2], 0.98)
    return Case(table(*poor, -0.5 + 0j, 0.3 + 0.2j, 0.6 - 0.2j), tracks, truth)
