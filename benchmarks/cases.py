"""A scene as data, every number to its last bit: how a failure is kept (tests/cases)."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from physics import Ball, Cloth, EventDriven, Wall, World, laws


def dump(world: World, why: str, holds: dict[str, Any], until: float | None = None) -> str:
    """The world as it is, why it is kept, what must hold when it has run until then."""
    case = {
        "why": why,
        "until": until,
        "holds": holds,
        "cloth": _numbers(world.cloth),
        "engine": _numbers(world.engine),
        "ball_law": [type(world.ball_law).__name__, _numbers(world.ball_law)],
        "cushion_law": [type(world.cushion_law).__name__, _numbers(world.cushion_law)],
        "discs": world.discs,
        "walls": [
            {
                "name": wall.name,
                "normal": _hex((wall.normal.real, wall.normal.imag)),
                "offset": wall.offset.hex(),
            }
            for wall in world.walls
        ],
        "balls": [
            {
                "name": ball.name, "radius": ball.radius.hex(), "mass": ball.mass.hex(),
                "at": _hex(ball.position), "velocity": _hex(ball.velocity), "spin": _hex(ball.spin),
            }
            for ball in world.balls
        ],
    }  # fmt: skip
    return json.dumps(case, indent=1) + "\n"


def _numbers(record: Any) -> dict[str, Any]:
    return asdict(record)


def _hex(numbers: tuple[float, ...]) -> list[str]:
    return [float(x).hex() for x in numbers]


def _floats(numbers: list[Any]) -> tuple[float, ...]:
    return tuple(_float(x) for x in numbers)


def _float(x: Any) -> float:
    """A number may also be written as people write it."""
    return float.fromhex(x) if isinstance(x, str) else float(x)


def load(path: Path) -> tuple[World, dict[str, Any]]:
    """(the world, the case)"""
    case: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    (ball_law, ball_numbers), (cushion_law, cushion_numbers) = case["ball_law"], case["cushion_law"]
    world = World(
        Cloth(**case["cloth"]),
        getattr(laws, ball_law)(**ball_numbers),
        getattr(laws, cushion_law)(**cushion_numbers),
        EventDriven(**case["engine"]),
        case.get("discs", len({ball["radius"] for ball in case["balls"]}) > 1),  # as it was once
    )
    for wall in case["walls"]:
        world.add(Wall(complex(*_floats(wall["normal"])), _float(wall["offset"]), wall["name"]))
    for ball in case["balls"]:
        world.add(
            Ball(
                ball["name"], _floats(ball["at"]), _floats(ball["velocity"]), _floats(ball["spin"]),
                _float(ball["radius"]), _float(ball["mass"]),
            )
        )  # fmt: skip
    return world, case
