"""A rolling ball is turned by about thirty degrees, whatever of the other it meets."""

from __future__ import annotations

from physics import Ball, Shot, World, laws, tables

from .readings import happened, moved, runs, to_cushion, turned, unit
from .shape import Field, Given, Lab, Numbers, Rows

AWAY = 0.5  # m that the cue ball has to go
SPOT = (-0.1, 0.0)
CUTS = (10.0, 60.0)  # degrees between which the greatest turn is looked for
GOLDEN = 0.6180339887498949


def scene(numbers: Numbers) -> World:
    """A cut with a cue ball that rolls; balls that lose nothing."""
    world = tables.medium_carom()
    world.ball_law = laws.SmoothBall(1.0)
    red = world.add(Ball("red", at=SPOT))
    ghost = moved(SPOT, unit(numbers["cut"]), -2.0 * red.radius)
    world.add(Ball("white", at=moved(ghost, (1.0, 0.0), -AWAY)))
    world.strike("white", Shot(numbers["speed"], follow=numbers["speed"]))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """The directions right after the hit, and that of the cue ball once it rolls again."""
    event = happened(after, "ball")
    return {
        "red": turned(event.after["red"].heading, 0.0),
        "first": turned(event.after["white"].heading, 0.0),
        "last": _turn(after),
        "greatest": _greatest(numbers),
    }


def _turn(after: World) -> float:
    """By how much the white has been turned once it rolls again."""
    rolls = happened(after, "roll", "white", since=happened(after, "ball").time)
    return turned(rolls.after[0].heading, 0.0)


def _greatest(numbers: Numbers) -> float:
    """The greatest turn of all cuts, between bounds that close in on it."""
    low, high = CUTS
    while high - low > 0.01:
        inner = GOLDEN * (high - low)
        if _turned_at(numbers, high - inner) > _turned_at(numbers, low + inner):
            high = low + inner
        else:
            low = high - inner
    return _turned_at(numbers, 0.5 * (low + high))


def _turned_at(numbers: Numbers, cut: float) -> float:
    world = scene({**numbers, "cut": cut})
    to_cushion(world)
    return _turn(world)


def table(after: World, numbers: Numbers) -> Rows:
    """Where both balls are from the hit on."""
    begin = happened(after, "ball").time
    step = (after.time - begin) / 11.0
    times = [begin + step * k for k in range(12)]
    pairs = zip(runs(after, "white", times), runs(after, "red", times), strict=True)
    heads = "time (s)", "white x (m)", "white y (m)", "red x (m)", "red y (m)"
    return Rows(heads, [(time, *w.position, *r.position) for (time, w), (_, r) in pairs])


LAB = Lab(
    "thirty-degrees",
    (Given("speed", "m/s", 1.5, 1.2, 2.0, 0.1), Given("cut", "°", 30.0, 20.0, 45.0, 1.0)),
    tuple(Field(name, "°", 0.0, 1.5) for name in ("red", "first", "last", "greatest")),
    scene, truth, table, to_cushion,
)  # fmt: skip
