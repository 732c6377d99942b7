"""What an outcome can be differentiated by: the numbers of a shot, places of balls, coefficients.

Their names are "speed" and the other numbers of a `Shot`; "white.x" and "white.y", where a ball lay
before it, and "positions" for all of these; "cloth.slide" and other coefficients of `Cloth`,
"cushion.e" and "ball.e" and other coefficients of the world's laws.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from copy import copy
from math import pi
from typing import TYPE_CHECKING, Any

from physics.kernel.laws import CUSTOM_BALL, CUSTOM_CUSHION
from physics.laws import MathavanCushion
from physics.shot import Shot, direction
from physics.world import World

from .dual import Dual

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

NUMBERS = ("speed", "angle", "follow", "masse", "side")
Rates = dict[str, float]  # of a record's fields

CLOTH: dict[str, Callable[[Any], Rates]] = {  # what the kernel's record of a cloth gains
    "slide": lambda cloth: {"slide": cloth.gravity, "grip": 1.0},
    "roll": lambda cloth: {"roll": cloth.gravity},
    "spin_decay": lambda cloth: {"fade": 1.0},
    "gravity": lambda cloth: {"slide": cloth.slide, "roll": cloth.roll, "gravity": 1.0},
}
LAW: dict[str, Callable[[Any], Rates]] = {  # and of a law, which has its coefficients at no speed
    "e": lambda rule: {"restitution": 1.0},
    "mu": lambda rule: {"friction": 1.0},
    "e_slope": lambda rule: {"restitution": -1.0, "restitution_slope": 1.0 / rule.level},
    "mu_slope": lambda rule: {"friction": -1.0, "friction_slope": 1.0 / rule.level},
    "slide": lambda rule: {"slide": 1.0},
    "nose": lambda rule: {
        "height": 1.0,
        "level": -rule.height / rule.level,
        "restitution_slope": rule.restitution_slope * rule.height / (rule.level * rule.level),
        "friction_slope": rule.friction_slope * rule.height / (rule.level * rule.level),
    },
}


def names(world: World, by: Iterable[str]) -> tuple[str, ...]:
    """All of them, each once, "positions" as those of every ball; ValueError for what is none."""
    if isinstance(by, str):
        by = (by,)
    found: list[str] = []
    for name in by:
        found += places(world) if name == "positions" else [name]
    known = coefficients(world)
    for k, name in enumerate(found):
        if name in found[:k]:
            raise ValueError(f"{name!r} is there twice")
        if name not in NUMBERS and name not in places(world) and name not in known:
            raise ValueError(_unknown(world, name, known))
    return tuple(found)


def _unknown(world: World, name: Any, known: Sequence[str]) -> str:
    if name == "cushion.slide" and isinstance(world.cushion_law, MathavanCushion):
        return "'cushion.slide' is the cloth's friction here: name 'cloth.slide'"
    if name == "ball.mu" and "ball.e" in known:
        return f"'ball.mu' is no number of {world.ball_law!r}"
    there = ", ".join((*NUMBERS, "positions", *places(world)[:2], *known))
    return f"{name!r} is no input of this world: there are {there}"


def places(world: World) -> list[str]:
    """Two names for each ball."""
    return [f"{ball.name}.{axis}" for ball in world.balls for axis in "xy"]


def coefficients(world: World) -> list[str]:
    """The names of all that the world's cloth and laws have; a custom law has none."""
    found = [f"cloth.{key}" for key in CLOTH]
    laws = (
        ("cushion", world.cushion_law, world.scene.cushion_rule.kind == CUSTOM_CUSHION),
        ("ball", world.ball_law, world.scene.ball_rule.kind == CUSTOM_BALL),
    )
    for part, law, custom in laws:
        if not custom:
            found += [f"{part}.{key}" for key in LAW if isinstance(getattr(law, key, None), float)]
    return [name for name in found if not _idle(world, name)]


def _idle(world: World, name: str) -> bool:
    """Friction that follows Alciatore's fit has no slope of its own."""
    return name == "ball.mu_slope" and isinstance(getattr(world.ball_law, "mu", 0.0), str)


class Seeds:
    """Where the named inputs enter a shot in this world; each is a column of every slope."""

    def __init__(self, world: World, by: tuple[str, ...]) -> None:
        self.by, self.column = by, {name: k for k, name in enumerate(by)}
        scene = world.scene
        law = world.cushion_law
        on_cloth = isinstance(law, MathavanCushion) and law.slide is None
        more = {"cloth.slide": {"slide": 1.0}} if on_cloth else {}
        self.cloth = self._sloping(scene.cloth, self._rates("cloth", CLOTH, world.cloth))
        rates = self._rates("cushion", LAW, scene.cushion_rule)
        self.cushion_rule = self._sloping(scene.cushion_rule, rates | more)
        self.ball_rule = self._sloping(scene.ball_rule, self._rates("ball", LAW, scene.ball_rule))

    def _rates(
        self, part: str, table: dict[str, Callable[[Any], Rates]], thing: Any
    ) -> dict[str, Rates]:
        chosen = {f"{part}.{key}": rates for key, rates in table.items()}
        return {name: rates(thing) for name, rates in chosen.items() if name in self.column}

    def _sloping(self, record: Any, rates: dict[str, Rates]) -> Any:
        """The record, with dual numbers in the fields that depend on an input."""
        slopes: dict[str, Any] = {}
        for name, fields in rates.items():
            if name in self.column:
                for field, rate in fields.items():
                    slopes.setdefault(field, self.zeros())[self.column[name]] += rate
        twin = copy(record) if slopes else record
        for field, slope in slopes.items():
            setattr(twin, field, Dual(getattr(record, field), slope))
        return twin

    def zeros(self, kind: type = float) -> Any:
        """(inputs,)."""
        import numpy as np

        return np.zeros(len(self.by), kind)

    def place(self, ball: Any) -> npt.NDArray[np.complex128]:
        """How its position depends on the inputs."""
        slope = self.zeros(complex)
        for axis, unit in (("x", 1.0), ("y", 1j)):
            if f"{ball}.{axis}" in self.column:
                slope[self.column[f"{ball}.{axis}"]] = unit
        return slope  # type: ignore[no-any-return]

    def push(self, shot: Shot) -> tuple[Any, Any, Any]:
        """How velocity, roll and side of the struck ball depend on the numbers of the shot."""
        along, degree = direction(shot.angle), 1j * pi / 180.0
        velocity, roll, side = self.zeros(complex), self.zeros(complex), self.zeros()
        rates: dict[str, tuple[complex, complex, float]] = {
            "speed": (along, 0j, 0.0),
            "angle": (degree * shot.velocity(), degree * shot.roll(), 0.0),
            "follow": (0j, along, 0.0),
            "masse": (0j, -1j * along, 0.0),
            "side": (0j, 0j, 1.0),
        }
        for name, (v, w, s) in rates.items():
            if name in self.column:
                k = self.column[name]
                velocity[k], roll[k], side[k] = v, w, s
        return velocity, roll, side
