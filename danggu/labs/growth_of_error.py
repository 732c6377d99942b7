"""Two shots that differ by a millionth of a degree: how their distance grows around a post."""

from __future__ import annotations

from math import hypot, log

from physics import Ball, Cloth, Post, Shot, Wall, World, laws

from .readings import for_seconds, slope
from .shape import Field, Figure, Given, Lab, Numbers, Rows

LESS = 1e-6  # degrees by which the second shot is aimed otherwise
LASTS = 12  # s
CENTIMETRE = 0.01
STEP = 1 / 64  # s between looks at how far apart the two are
ROW = 0.5  # s between rows of the table
CORNERS = (("south", -0.5, -0.5), ("east", 0.5, -0.5), ("north", 0.5, 0.5), ("west", -0.5, 0.5))


def scene(numbers: Numbers, less: float = 0.0) -> World:
    """On ice, a ball among mirrors around a post (Sinai's billiard)."""
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0), laws.RigidCushion(1.0, 0.0, 1.0))
    for k, (name, x, y) in enumerate(CORNERS):
        world.add(Wall.segment((x, y), CORNERS[(k + 1) % 4][1:], name))
    world.add(Post((0.0, 0.0), numbers["post"], "post"))
    world.add(Ball("white", at=(-0.4, 0.1)))
    world.strike("white", Shot(1.0, numbers["angle"] + less))
    return world


def twin(numbers: Numbers) -> World:
    """The other shot, played."""
    world = scene(numbers, LESS)
    LAB.play(world)
    return world


def _apart(after: World, numbers: Numbers) -> list[tuple[float, float]]:
    """Times, and the distance between the two shots, m, until it has been a centimetre."""
    other, found = twin(numbers), []
    for k in range(1, int(LASTS / STEP) + 1):
        (x, y), (u, v) = (w.log.at(k * STEP)["white"].position for w in (after, other))
        found.append((k * STEP, hypot(x - u, y - v)))
        if found[-1][0] % ROW == 0.0 and max(apart for _, apart in found) >= CENTIMETRE:
            break
    return found


def _rows(after: World, numbers: Numbers) -> list[tuple[float, float]]:
    """What the table has of them."""
    return [(time, apart) for time, apart in _apart(after, numbers) if time % ROW == 0.0]


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """The line through the logarithms of the measured distances."""
    times, apart = zip(*_rows(after, numbers), strict=True)
    rate = slope(times, [log(d) for d in apart])
    return {
        "rate": rate,
        "doubling": log(2.0) / rate,
        "centimetre": next(t for t, d in _apart(after, numbers) if d >= CENTIMETRE),
        "more": log(10.0) / rate,
    }


def table(after: World, numbers: Numbers) -> Rows:
    """How far apart the two shots are."""
    return Rows(("time (s)", "distance (m)"), _rows(after, numbers))


def others(numbers: Numbers) -> Figure:
    """The other shot."""
    return [twin(numbers)]


LAB = Lab(
    "growth-of-error",
    (Given("angle", "°", 20.0, 2.0, 40.0, 1.0), Given("post", "m", 0.3, 0.3, 0.32, 0.01)),
    (Field("rate", "1/s", 0.1), Field("doubling", "s", 0.1), Field("centimetre", "s", 0.05, 0.4),
     Field("more", "s", 0.1)),
    scene, truth, table, for_seconds(LASTS), others, ("time (s)", "log10 of distance (m)"),
)  # fmt: skip
