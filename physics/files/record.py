"""A world or a shot as plain data, for JSON: every number as the kernel has it, so none is lost."""

from dataclasses import asdict, fields, is_dataclass
from math import isfinite
from typing import Any

from physics.ball import Ball
from physics.engines.engine import Movable
from physics.kernel.kinds import PHASE_NAMES
from physics.kernel.lasting import NEVER
from physics.shot import Shot

HOMES = (  # of named things
    "physics.laws", "physics.engines.exact", "physics.engines.stepping", "physics.tables.table",
)  # fmt: skip
TABLE = ("name", "kind", "length", "width", "radius", "mass")  # of a table, beside its laws
VERSION = 3  # 2 took balls of unequal radii for discs, 1 knew no balls in the air
LATER = ("e_slope", "mu_slope", "bands")  # written where there are any, as older files are
DISTURBED = "disturbed"
COMPLEX = ("position", "velocity", "acceleration", "roll")
REAL = ("side", "height", "climb", "fall")
# what an engine of fixed steps has noted about the leg's end, and beside it
PAGE = ("leg_end", "goal", "west", "east", "south", "north", "meets", "partner", "next")

Data = dict[str, Any]


def shot_data(shot: Shot) -> Data:
    """A shot's numbers."""
    return {"danggu": "shot", "version": VERSION, **asdict(shot)}


def world_data(world: Movable) -> Data:
    """All that decides how the world goes on; not its log."""
    clock = world.clock
    return {
        "danggu": "world",
        "version": VERSION,
        "cloth": _numbers(world.cloth),
        "ball_law": _named(world.ball_law),
        "cushion_law": _named(world.cushion_law),
        "cluster_law": None if world.cluster_law is None else asdict(world.cluster_law),
        "engine": _named(world.engine),
        "discs": world.discs,
        **({} if world.table is None else {"table": _table(world.table)}),
        "epoch": clock.epoch,
        "now": clock.now,
        "planned": world.planned,
        **({"loose": True} if clock.loose else {}),  # from fixed steps on: things may overlap
        "due": None if foresees(world) or clock.disturbed else _or_none(world.due),
        "walls": [_wall(wall) for wall in world.walls],
        "balls": [_ball(ball, not foresees(world)) for ball in world.balls],
    }


def planned_data(world: Movable, budget: int) -> Data:
    """The world as it was when a ball was last placed or pushed, `budget` events before the last
    allowed one; from its log."""
    data = world_data(world)
    now = world.planned - world.epoch
    data["now"], data["due"] = now, None
    for ball, leg in zip(data["balls"], world.log.legs_when(world.allowed - budget), strict=True):
        then = leg.after(max(0.0, (world.epoch - leg.epoch) + (now - leg.since)))
        ball.update(
            phase=DISTURBED, since=now, page=None,
            **{name: _pair(getattr(then, name)) for name in COMPLEX},
            **{name: getattr(then, name) for name in REAL},
        )  # fmt: skip
    return data


def insist_on_names(world: Movable) -> None:
    """ValueError for a ball, a table, a law or an engine that a file cannot name."""
    things = {name: getattr(world, name) for name in ("ball_law", "cushion_law", "engine")}
    if world.table is not None:
        things["table"] = world.table
        if _ours(world.table):
            things["table's ball_law"] = world.table.ball_law
            things["table's cushion_law"] = world.table.cushion_law
    for name, thing in things.items():
        what = name.replace("_", " ")
        if not _ours(thing):
            raise ValueError(
                f"the {what} {getattr(thing, '__name__', thing)!r} is a custom one: only the"
                " tables, laws and engines of this package can be saved"
            )
    for wall in world.walls:
        if wall.own_law is not None and not _ours(wall.own_law):
            raise ValueError(f"the law of {wall!r} is a custom one: only laws of this package can"
                             " be saved")  # fmt: skip
    for ball in world.balls:
        if not isinstance(ball.name, str):
            raise ValueError(f"ball {ball.name!r}: only names that are text can be saved")


def foresees(world: Movable) -> bool:
    """Does everything that the engine has planned follow from the legs?  Then it is not kept."""
    return bool(getattr(world.engine, "foresees", False))


def _or_none(value: float) -> float | None:
    """JSON has no infinity."""
    return value if isfinite(value) else None


def _pair(z: complex) -> list[float]:
    return [z.real, z.imag]


def _ours(thing: Any) -> bool:
    return is_dataclass(thing) and type(thing).__module__ in HOMES


def _named(thing: Any) -> Data:
    """A law or an engine as data; of a custom one, or of a custom table, only its name."""
    if not _ours(thing):
        return {"name": f"{getattr(thing, '__name__', thing)} (custom)"}
    return {"name": type(thing).__name__, **_numbers(thing)}


def _numbers(thing: Any) -> Data:
    """Its coefficients."""
    return {key: value for key, value in asdict(thing).items() if value or key not in LATER}


def _table(table: Any) -> Data:
    if not _ours(table):
        return _named(table)
    return {
        **{name: getattr(table, name) for name in TABLE},
        "cloth": _numbers(table.cloth),
        "ball_law": _named(table.ball_law),
        "cushion_law": _named(table.cushion_law),
        "pockets": None if table.pockets is None else asdict(table.pockets),
    }


def _wall(wall: Any) -> Data:
    """Its name, what it is if it is no line, and the numbers that make it."""
    kind = {} if wall.kind == "line" else {"kind": wall.kind}
    names = [field.name for field in fields(wall) if field.init and field.name != "law"]
    made = {name: getattr(wall, name) for name in names}
    numbers = {key: _pair(z) if isinstance(z, complex) else z for key, z in made.items()}
    law = {} if wall.own_law is None else {"law": _named(wall.own_law)}
    return {"name": wall.name, **kind, **numbers, **law}


def _ball(ball: Ball, paged: bool) -> Data:
    body = ball.body
    paged = paged and body.phase in PHASE_NAMES
    return {
        "name": ball.name,
        "radius": body.radius,
        "mass": body.mass,
        "phase": PHASE_NAMES.get(body.phase, DISTURBED),
        "since": body.since,
        **{name: _pair(getattr(body, name)) for name in COMPLEX},
        **{name: getattr(body, name) for name in REAL},
        **({"hop": [body.hopped, body.met, body.hops, body.lent]} if body.hopped != NEVER else {}),
        "page": {name: _or_none(getattr(body, name)) for name in PAGE} if paged else None,
    }
