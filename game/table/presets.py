"""Tables to begin with, balls on them, and the law sets and engines to choose from."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import physics
from physics import Ball, Cloth, EventDriven, Placed, World, laws, scenes, tables

from .lab_scenes import Scenes
from .own_table import Tables, base

Place = tuple[float, float]

CAROM = {"thesis": tables.THESIS, "medium": tables.MEDIUM_CAROM, "match": tables.MATCH_CAROM_2}
POOL = {"pool-9": tables.pool(9), "pool-8": tables.pool(8), "pool-7": tables.pool(7)}
TABLES = Tables(
    {**CAROM, **POOL, "snooker": tables.SNOOKER_12FT, "pyramid": tables.PYRAMID_12FT}
)
FREE_RACKS = {"pool": "8-ball", "snooker": "snooker", "pyramid": "pyramid"}
"""What is racked on a free table of each kind."""
BALLS: dict[str, Place] = {
    "white": (-0.22, -0.24),
    "yellow": (0.33, -0.06),
    "red1": (0.05, 0.07),
    "red2": (-0.34, 0.26),
}
"""Where the balls lie at the start, as shares of the table's length and width."""
CUE = "cue"
THREE = ("white", "yellow", "red1")
TRIES = 10_000
"""Random places tried for one ball before giving up: a quarter of a table is never that full."""


@dataclass(frozen=True, slots=True)
class LawSet:
    """A law for balls and one for cushions, chosen together."""

    key: str
    ball: Callable[[], laws.BallLaw]
    cushion: Callable[[], laws.CushionLaw]


LAWS = {
    law.key: law
    for law in (
        LawSet("rigid", laws.RoughBall, laws.RigidCushion),
        LawSet("thesis", laws.ThesisBall, laws.ThesisCushion),
        LawSet("mathavan", laws.RoughBall, laws.MathavanCushion),
    )
}
ENGINES: dict[str, Callable[[], Any]] = {
    "exact": EventDriven,
    "thesis": lambda: physics.TimeStepping(dt=1 / 180),
}
CLOTHS: dict[str, Cloth | None] = {
    "table": None,
    **{key: tables.CLOTHS[key] for key in ("new", "hall", "worn", "humid")},
}
"""Conditions of the cloth; "table" is the one that a table comes with."""
EDITIONS = (1, 2, 3, 4)
"""Of tables, laws, cloths and strokes: a record is played with those of its time, and so comes out
the same."""
EDITION = EDITIONS[-1]
HOPPING = 4
"""The edition from which on a cue that is raised makes the ball hop."""
FIRST_LAWS = {
    "mathavan": LawSet("mathavan", laws.RoughBall, lambda: laws.MathavanCushion(slide=0.212)),
}
FIRST_CLOTHS = {"new": Cloth(slide=0.15, roll=0.005, spin_decay=5.0, gravity=9.81)}
"""What was otherwise in edition 1."""
SECOND_TABLES = {"match": tables.MATCH_CAROM}
SECOND_CLOTHS = tables.CLOTH_EDITIONS[1]
"""What was otherwise in edition 2, and in the first."""
SCENES = Scenes(scenes.SCENES)
SIDES = ("west", "east", "south", "north")


def table_world(key: str) -> World:
    """A table with its balls at rest: four, three on the match table, or racked by the pockets."""
    table = TABLES[key]
    world = table.world()
    if table.kind in FREE_RACKS:
        return _racked(world, table.rack(FREE_RACKS[table.kind]))
    for name, (x, y) in BALLS.items():
        if base(key) == "match" and name not in THREE:
            continue
        at = (x * table.length, y * table.width)
        world.add(Ball(_name(key, name), at, radius=table.radius, mass=table.mass))
    return world


def _racked(world: World, balls: list[Ball]) -> World:
    x = -0.3 * world.table.length  # behind the line of each kind of table
    world.add(Ball(CUE, (x, -0.15 if world.table.kind == "snooker" else 0.0)))
    for ball in balls:
        world.add(ball)
    return world


def known(key: str) -> tuple[str, ...]:
    """Names of all balls that may lie on a table."""
    table = TABLES[key]
    if table.kind not in FREE_RACKS:
        return (*BALLS, "red")
    return (CUE, *(ball.name for ball in table.rack(FREE_RACKS[table.kind])))


def scene_world(name: str) -> World:
    """A scene of the physics package; one without a table gets the thesis's around it."""
    world = SCENES[name]()
    if not {wall.name for wall in world.walls}.issuperset(SIDES):
        own = [*world.walls]
        for wall in own:
            world.remove(wall)
        for wall in (*tables.THESIS.world().walls, *own):  # a scene's own may stand before them
            world.add(wall)
    return world


def _name(key: str, name: str) -> str:
    """With one red ball it is just red."""
    return "red" if base(key) == "match" and name == "red1" else name


def size(world: World) -> Place:
    """Length and width between the noses of the four sides, metres."""
    if world.table is not None:
        return world.table.length, world.table.width
    sides = {wall.name: wall.distance((0.0, 0.0)) for wall in world.walls}
    return sides["west"] + sides["east"], sides["south"] + sides["north"]


def cue_ball(world: World) -> str:
    """Name of the ball that is shot: white, or cue, or the first one."""
    names = [ball.name for ball in world.balls]
    return next((name for name in ("white", "cue") if name in names), names[0])


def law_set(key: str, edition: int = EDITION) -> LawSet:
    """The laws of that key; KeyError if there are none."""
    return FIRST_LAWS.get(key, LAWS[key]) if edition == 1 else LAWS[key]


def cloth(key: str, edition: int = EDITION) -> Cloth | None:
    """The cloth of that key, None for the table's own; KeyError if there is none."""
    old: list[dict[str, Cloth]] = [FIRST_CLOTHS, SECOND_CLOTHS][edition - 1 :]
    return next((cloths[key] for cloths in old if key in cloths), CLOTHS[key])


def as_of(world: World, key: str, edition: int) -> None:
    """Give a table that has just been laid the cloth and the laws that it had in an edition."""
    if edition <= 2 and key in SECOND_TABLES:
        table = SECOND_TABLES[key]
        world.cloth, world.ball_law, world.cushion_law = (
            table.cloth, table.ball_law, table.cushion_law
        )  # fmt: skip


def law_of(world: World) -> str:
    """Key of the law set whose kinds of law the world has, or of none ("own")."""
    kinds = (type(world.ball_law), type(world.cushion_law))
    return next((key for key, law in LAWS.items() if (law.ball, law.cushion) == kinds), "own")


def places(world: World, rng: random.Random) -> list[Place]:
    """Random places for all balls, one after the other in each quadrant; none overlap.

    Where a wall of a scene takes a quadrant, the next one. Raises ValueError naming the ball that
    found no room.
    """
    length, width = size(world)
    found: list[tuple[Place, Ball]] = []
    quadrants = rng.sample(range(4), 4)
    for i, ball in enumerate(world.balls):
        tries = (quadrants[(i + k) % 4] for k in range(4) for _ in range(TRIES))
        spots = (_somewhere(rng, q, length / 2, width / 2, ball.radius) for q in tries)
        at = next((at for at in spots if _fits(at, ball, found, world)), None)
        if at is None:
            raise ValueError(f"no room for ball {ball.name!r}")
        found.append((at, ball))
    return [at for at, _ in found]


def lying(places: Sequence[Place]) -> list[Placed]:
    """Balls that lie there at rest."""
    return [Placed(complex(*at)) for at in places]


def _somewhere(rng: random.Random, quadrant: int, x: float, y: float, radius: float) -> Place:
    """A place in a quadrant (bit 0 right, bit 1 far) at which a ball crosses none of its edges."""
    at = rng.uniform(radius, x - radius), rng.uniform(radius, y - radius)
    return (at[0] if quadrant & 1 else -at[0]), (at[1] if quadrant & 2 else -at[1])


def _fits(at: Place, ball: Ball, others: list[tuple[Place, Ball]], world: World) -> bool:
    apart = all(
        (at[0] - p[0]) ** 2 + (at[1] - p[1]) ** 2 >= ball.touching_distance(other) ** 2
        for p, other in others
    )
    return apart and all(wall.distance(at) >= ball.radius for wall in world.walls)
