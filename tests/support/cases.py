"""A scene that once broke the engine, from a data file of tests/cases.

Numbers are hexadecimal floats, so that no bit is lost, or as people write them. Worlds with more
than lines in them are as `store.save` writes worlds.
"""

import json
from pathlib import Path
from typing import Any

from physics import Ball, Cloth, EventDriven, Wall, World, laws, store


def _floats(numbers: list[Any]) -> tuple[float, ...]:
    return tuple(_float(x) for x in numbers)


def _float(x: Any) -> float:
    return float.fromhex(x) if isinstance(x, str) else float(x)


def load(path: Path) -> tuple[World, dict[str, Any]]:
    """(the world, the case with why it is kept, until when it runs and what must then hold)"""
    case: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    if "world" in case:
        world = store.restore(case["world"])
        assert isinstance(world, World)
        return world, case
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
