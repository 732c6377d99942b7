"""What the page of the lab asks of the physics: a table with its balls, and shots, as JSON.

It runs under Pyodide in a browser and under any Python at a desk, with the same digits; the page
draws a ball at time t from the leg it is on, as the game does.
"""

import json
import platform
from collections.abc import Callable
from hashlib import sha256

from physics import Ball, Pocket, Shot, World, scenes, simulate, tables

NUMBERS = "speed", "angle", "follow", "masse", "side"
ENOUGH = 400  # events that the page lists
GAP = 1e-5  # m, between the balls of the rack


def three_cushion() -> World:
    """The opening of three-cushion on a match table."""
    world = tables.match_carom()
    spots = world.table.spots
    for name, spot in (("white", "right"), ("yellow", "head"), ("red", "foot")):
        world.add(Ball(name, at=spots[spot]))
    return world


def rack() -> World:
    """The break of 8-ball on a 9-foot table."""
    world = tables.pool_9ft()
    world.add(Ball("cue", at=world.table.spots["head"]))
    for ball in world.table.rack("8-ball", gap=GAP):
        world.add(ball)
    return world


SET_UPS: dict[str, tuple[Callable[[], World], Shot, str]] = {
    "carom": (scenes.carom, Shot(3.0, 40.0, follow=0.5, side=1.5), "scenes.carom()"),
    "three-cushion": (three_cushion, Shot(4.5, 8.6, follow=2.0, side=2.0), ""),
    "break": (rack, Shot(9.0, 2.4), ""),
}
"""By name: what makes it, the shot to begin with, and how Python makes it in a line."""
LAWS = "table", "rigid", "mathavan", "thesis"
"""Of the cushion; the first is the table's own."""


def laid(name: str) -> str:
    """The table, m: its outline, pockets and balls, and the shot to begin with."""
    make, shot, _ = SET_UPS[name]
    world = make()
    table = world.table
    holes = [[*w.at, w.radius] for w in world.walls if isinstance(w, Pocket)]
    return json.dumps({
        "length": table.length, "width": table.width, "kind": table.kind,
        "outline": [[p.real, p.imag] for p in table.outline], "pockets": holes,
        "spots": list(table.spots.values()), "line": table.head_string,
        "balls": [[b.name, *b.position, b.radius] for b in world.balls],
        "shot": {key: getattr(shot, key) for key in NUMBERS},
    })  # fmt: skip


def played(name: str, law: str, numbers: str, places: str) -> str:
    """A shot of the first ball with all its legs and events; {"error": ...} says what cannot be.

    numbers: JSON with the five numbers of the shot; places: JSON with [x, y] of every ball, m, or
    null for those of the set-up.
    """
    try:
        return json.dumps(_played(name, law, json.loads(numbers), json.loads(places)))
    except (ValueError, TypeError, RuntimeError) as error:
        return json.dumps({"error": str(error)})


def _played(name: str, law: str, numbers: dict[str, float], places: list | None) -> dict:
    world, shot = SET_UPS[name][0](), Shot(**numbers)
    if law != LAWS[0]:
        world.cushion_law = law
    for ball, place in zip(world.balls, places or [], strict=False):
        ball.position = tuple(place)
    after = simulate(world, world.balls[0], shot)
    log = after.log
    rest = [[repr(x + 0.0) for x in ball.position] for ball in after.balls]
    return {
        "end": after.time, "events": len(log), "code": _code(name, law, shot, places),
        "legs": [[_leg(leg) for leg in log.legs(ball.name)] for ball in after.balls],
        "log": [_event(event) for event in log[:ENOUGH]],
        "gone": [ball.phase == "pocketed" for ball in after.balls],
        "rest": rest, "sum": sha256(json.dumps(rest).encode()).hexdigest()[:16],
    }  # fmt: skip


def _leg(leg) -> list[float]:
    """When it begins, and the coefficients of its polynomials; the phase by its number."""
    p, v, a = leg.position, leg.velocity, leg.acceleration
    return [leg.time, p.real, p.imag, v.real, v.imag, a.real, a.imag, leg.phase]


def _event(event) -> list:
    return [event.time, event.kind, list(event.balls), event.wall, event.closing, event.energy_lost]


def _code(name: str, law: str, shot: Shot, places: list | None) -> str:
    """The same shot for Python at a desk, if a line or two say it."""
    made = SET_UPS[name][2]
    if not made or places is not None:
        return ""
    lines = ["from physics import Shot, scenes, simulate", f"world = {made}"]
    lines += [] if law == LAWS[0] else [f"world.cushion_law = {law!r}"]
    lines += [f"after = simulate(world, {SET_UPS[name][0]().balls[0].name!r}, {shot!r})"]
    return "\n".join([*lines, "print([ball.position for ball in after.balls])"])


def python() -> str:
    """The version of Python that plays."""
    return platform.python_version()
