"""Worlds, shots and scenes with what was played in them, in JSON files: what is loaded goes on as
what was saved, bit for bit."""

import json
import os
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from physics import laws, whole_files
from physics.ball import Ball
from physics.checks import array, vector
from physics.cloth import Cloth
from physics.engines import exact, stepping
from physics.kernel.body import Body
from physics.kernel.leg import place, risen
from physics.post import OBSTACLES
from physics.shot import NUMBERS, Shot
from physics.wall import Obstacle, Point, Wall
from physics.world import World

from .history import PHASES, Played, log_data, log_of, outcomes_data, outcomes_of
from .node import Node
from .record import (
    COMPLEX,
    DISTURBED,
    LATER,
    PAGE,
    REAL,
    VERSION,
    Data,
    foresees,
    insist_on_names,
    shot_data,
    world_data,
)

__all__ = ["Played", "dumps", "load", "loads", "restore", "save"]


def dumps(thing: World | Shot | Played) -> str:
    """The world, the shot or the scene as JSON text; a world alone without its log.

    ValueError for a custom table, law or engine, which no file can hold, and for a scene whose log
    is of another world.
    """
    if isinstance(thing, Played):
        return _played_text(thing)
    if isinstance(thing, Shot):
        data = shot_data(thing)
    elif not isinstance(thing, World):
        raise ValueError(f"only a World or a Shot, or what was Played, can be saved, not {thing!r}")
    else:
        insist_on_names(thing)
        data = world_data(thing)
    return json.dumps(data, indent=1, allow_nan=False) + "\n"


def _played_text(scene: Played) -> str:
    """Its parts, the long ones each on a line of its own."""
    insist_on_names(scene.world)
    parts: Data = {"danggu": "scene", "version": VERSION, "world": world_data(scene.world)}
    if scene.shot is not None:
        parts |= {"ball": scene.ball, "shot": shot_data(scene.shot)}
    long: Data = {}
    if scene.log is not None:
        long["log"] = log_data(scene.log, scene.world)
    if scene.outcomes is not None:
        long["outcomes"] = outcomes_data(scene.outcomes)
    if scene.shots is not None:
        long["shots"] = scene.shots.tolist()
    lines = json.dumps(parts, indent=1, allow_nan=False).removesuffix("\n}")
    more = [f',\n "{key}": {json.dumps(value, allow_nan=False)}' for key, value in long.items()]
    return "".join([lines, *more, "\n}\n"])


def loads(text: str) -> World | Shot | Played:
    """The inverse of `dumps`; ValueError, saying what is wrong and where, for any other text."""
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        raise ValueError(f"not JSON: {error}") from None
    except RecursionError:
        raise ValueError("not JSON of this kind: nested too deep") from None
    return restore(data)


def save(thing: World | Shot | Played, path: str | os.PathLike[str]) -> None:
    """Write `dumps` to a file, all of it or nothing; OSError where that is impossible.

    A file that is there already must be a regular one, or a link to one, which stays a link.
    """
    whole_files.replace(path, dumps(thing).encode())


def load(path: str | os.PathLike[str]) -> World | Shot | Played:
    """The inverse of `save`; ValueError, naming the file, what is wrong and where."""
    try:
        return loads(Path(path).read_text(encoding="utf-8"))
    except ValueError as error:
        raise ValueError(f"{os.fspath(path)}: {error}") from None


def restore(data: Any) -> World | Shot | Played:
    """A world, a shot or a scene from plain data, such as `EventBudgetError.scene`."""
    node = Node(data, "")
    kind = node["danggu"].text()
    version = node["version"].value
    if version not in (1, 2, VERSION):
        raise ValueError(f"version is {version!r}; this program reads versions 1 to {VERSION}")
    if version == 1:
        node = Node(_in_the_air(data), "")
    if version != VERSION and kind == "world":
        node = Node({**node.value, "discs": _unequal(node)}, "")
    if kind == "shot":
        return _shot(node)
    if kind == "scene":
        return _scene(node)
    if kind != "world":
        raise ValueError(f'danggu is {kind!r}; it must be "world", "shot" or "scene"')
    return _world(node)


def _scene(node: Node) -> Played:
    world, shot, log, outcomes, shots = _world(node["world"]), None, None, None, None
    ball = None
    if "shot" in node.value:
        ball = world.ball(node["ball"].text()).name
        shot = _shot(node["shot"])
    if "log" in node.value:
        log = log_of(node["log"], world)
    if "outcomes" in node.value:
        outcomes = outcomes_of(node["outcomes"])
    if "shots" in node.value:
        shots = array("shots", node["shots"].value)
    return Played(world, ball, shot, log, outcomes, shots)


def _shot(node: Node) -> Shot:
    return Shot(**{name: node[name].number() for name in NUMBERS})


def _unequal(node: "Node") -> bool:
    """Do the balls of a file of version 1 or 2 differ in radius?  Then they were meant as discs."""
    return len({ball["radius"].number() for ball in node["balls"].items()}) > 1


def _in_the_air(data: Data) -> Data:
    """A file of version 1 with what version 2 added: before it, no ball left the cloth."""
    new = {"climb": 0.0, **data}
    if isinstance(data.get("cloth"), dict):
        new["cloth"] = {"bounce": Cloth().bounce, **data["cloth"]}
    if isinstance(data.get("balls"), list):
        down = dict.fromkeys(REAL, 0.0)
        new["balls"] = [{**down, **b} if isinstance(b, dict) else b for b in data["balls"]]
    return new


READS: dict[Any, Callable[[Node], Any]] = {
    complex: Node.complex, float: Node.number, Point: Node.point
}  # fmt: skip


def _world(node: Node) -> World:
    world = World(
        _made(Cloth, node["cloth"]),
        _one_of((laws,), node["ball_law"]),
        _one_of((laws,), node["cushion_law"]),
        _one_of((exact, stepping), node["engine"]),
        node["discs"].truth(),
        _table(node["table"]) if "table" in node.value else None,
    )
    if node["cluster_law"].value is not None:
        world.cluster_law = _made(laws.HertzCluster, node["cluster_law"])
    for wall in node["walls"].items():
        world.add(_obstacle(wall))
    _put_balls(world, node)
    return world


def _obstacle(node: Node) -> Obstacle:
    """From its fields, of the kind that it says; else a line."""
    name = None if node["name"].value is None else node["name"].text()
    kind = node["kind"].text() if "kind" in node.value else Wall.kind
    if kind not in OBSTACLES:
        raise ValueError(f"{node.where}.kind is {kind!r}; it must be one of {', '.join(OBSTACLES)}")
    asked = [field for field in fields(OBSTACLES[kind]) if field.init and field.type in READS]
    made = {field.name: READS[field.type](node[field.name]) for field in asked}
    if "law" in node.value:
        made["law"] = _one_of((laws,), node["law"])
    obstacle: Obstacle = OBSTACLES[kind](**made, name=name)
    return obstacle


def _table(node: Node) -> Any:
    """What the world stands on; files from before tables were kept do not say."""
    from physics.tables.table import Table

    pockets = node["pockets"]
    made = {
        **{name: node[name].text() for name in ("name", "kind")},
        **{name: node[name].number() for name in ("length", "width", "radius", "mass")},
        "cloth": _made(Cloth, node["cloth"]),
        **{name: _one_of((laws,), node[name]) for name in ("ball_law", "cushion_law")},
        "pockets": None if pockets.value is None else _pockets(pockets),
    }
    try:
        return Table(**made)
    except ValueError as error:
        raise ValueError(f"{node.where}: {error}") from None


def _pockets(node: Node) -> Any:
    from physics.tables.pockets import Mouth, Pockets

    return Pockets(_made(Mouth, node["corner"]), _made(Mouth, node["side"]))


def _made(kind: Any, node: Node) -> Any:
    """A dataclass from its fields; its own ValueError, with the place, if it refuses them."""
    names = [field.name for field in fields(kind)]
    there = node.value if isinstance(node.value, dict) else ()
    names = [name for name in names if name not in LATER or name in there]
    bands = [band.point() for band in node["bands"].items()] if "bands" in names else []
    values = {name: node[name].value for name in names if name != "bands"}
    for name, value in values.items():
        if isinstance(value, bool) or not isinstance(value, int | float | str | None):
            raise ValueError(f"{node.where}.{name} must be a number or text, not {value!r:.60}")
    try:
        return kind(**values, bands=tuple(bands)) if bands else kind(**values)
    except (ValueError, TypeError) as error:
        raise ValueError(f"{node.where}: {error}") from None


def _one_of(modules: tuple[ModuleType, ...], node: Node) -> Any:
    """The law or engine of that name."""
    name = node["name"].text()
    for module in modules:
        kind = vars(module).get(name)
        if is_dataclass(kind) and isinstance(kind, type) and kind.__module__ == module.__name__:
            return _made(kind, node)
    raise ValueError(f"{node.where}.name is {name!r}, which this program does not know")


def _put_balls(world: World, node: Node) -> None:
    """The balls where they are, first at rest and checked, then each on its leg."""
    epoch, now = node["epoch"].number(), node["now"].number()
    planned, due = node["planned"].number(), node["due"].number_or_inf()
    bodies = [_body(ball) for ball in node["balls"].items()]
    for ball, body in zip(node["balls"].items(), bodies, strict=True):
        t = 0.0 if body.phase < 0 else now - body.since
        p = place(body, t)
        mine = Ball(ball["name"].text(), (p.real, p.imag), radius=body.radius, mass=body.mass)
        world.add(mine).body.height = risen(body, t)[0]
    world.clock.loose = bool(node.value.get("loose"))
    if world.clock.loose or not foresees(world):
        world.trust()  # fixed steps let things overlap
    world.plan()
    world.clock.epoch, world.clock.now = epoch, now
    for mine, body in zip(world.balls, bodies, strict=True):
        for name in ("since", *COMPLEX, *REAL, "phase", "hopped", "met", "hops", "lent"):
            setattr(mine.body, name, getattr(body, name))
    going = [k for k, body in enumerate(bodies) if body.phase >= 0]
    world.log.rewind([0] * (1 + len(bodies)))
    world.engine.plan(world, going)
    world.planned = planned
    if not foresees(world):
        _keep_grid(world, due, bodies, going)
    world.clock.disturbed = len(going) < len(bodies)


def _keep_grid(world: World, due: float, bodies: list[Body], going: list[int]) -> None:
    """Fixed steps count from when they began: that count must go on."""
    for k in going:
        mine, body = world.scene.balls[k], bodies[k]
        for name in ("since", *COMPLEX, *REAL, "phase", *PAGE):
            setattr(mine, name, getattr(body, name))
    world.due = due


def _body(node: Node) -> Body:
    body = Body(node["radius"].number(), node["mass"].number(), since=node["since"].number())
    for name in COMPLEX:
        setattr(body, name, node[name].complex())
    for name in REAL:
        setattr(body, name, node[name].number())
    if "hop" in node.value:  # of a contact that lasts; since version 2 is out
        hop = vector(f"{node.where}.hop", [note.number() for note in node["hop"].items()], 4)
        body.hopped, body.met, body.hops, body.lent = hop[0], int(hop[1]), int(hop[2]), hop[3]
    if node["page"].value is not None:
        for name in PAGE:
            note = node["page"][name]
            whole = name in ("goal", "partner")
            setattr(body, name, int(note.number()) if whole else note.number_or_inf())
    phase = node["phase"].text()
    if phase != DISTURBED and phase not in PHASES:
        known = ", ".join([DISTURBED, *PHASES])
        raise ValueError(f"{node.where}.phase is {phase!r}; it must be one of {known}")
    body.phase = PHASES.get(phase, -1)
    return body


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]
