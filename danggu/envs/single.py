"""One table as a Gymnasium environment."""

from __future__ import annotations

from typing import Any, ClassVar

import gymnasium
import numpy as np
from gymnasium import spaces

from . import actions
from .cannon_hall import CannonHall
from .hall import Hall
from .match_hall import MatchHall
from .setup import Setup

ONE = np.array([0])


def hall_of(setup: Setup, count: int) -> Hall:
    """So many tables for one player."""
    return MatchHall(setup, count) if setup.racked else CannonHall(setup, count)


def action_space() -> Any:
    """The space of actions of all environments."""
    return spaces.Box(-1.0, 1.0, (actions.SIZE,), np.float32)


def observation_space(hall: Hall) -> Any:
    """The space of what is observed at a table."""
    return spaces.Box(-hall.bound, hall.bound, (hall.size,), np.float32)


def key_of(seed: int | None) -> Any:
    """Where the chance of a table begins whose environment has that seed, uint64."""
    generator, _ = gymnasium.utils.seeding.np_random(seed)
    return generator.integers(2**64, dtype=np.uint64)


class TableEnv(gymnasium.Env):  # type: ignore[misc]
    """One player at one table; how it is seen and struck: docs/environments.md.

    given: as for `Setup`; ValueError for what cannot be.
    """

    metadata: ClassVar[dict[str, Any]] = {"render_modes": []}

    def __init__(self, **given: Any) -> None:
        self.setup = Setup(**given)
        self.hall = hall_of(self.setup, 1)
        self.action_space = action_space()
        self.observation_space = observation_space(self.hall)
        self._begun = False

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[Any, dict[str, Any]]:
        """Begin another episode: (observation, info); options["state"]: in games without pockets,
        where the balls lie, as info has it."""
        super().reset(seed=seed)
        if seed is not None or not self._begun:
            self.hall.seed(ONE, self.np_random.integers(2**64, dtype=np.uint64))
        self._begun = True
        self.hall.deal(ONE)
        if options and "state" in options:
            self.hall.put(ONE, np.asarray(options["state"])[None])
        return self.hall.seen(ONE)[0], {"state": self.hall.places[0].copy(), "reason": ""}

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Play a stroke: (observation, reward, terminated, truncated, info). In info, "state" has
        the places of the balls, (balls, 2) m, NaN for one that is not on the table, and "reason"
        the key of the verdict."""
        struck = self.hall.strike(ONE, np.asarray(action)[None])
        info = {"state": self.hall.places[0].copy(), "reason": str(struck.reasons[0])}
        over, late = bool(struck.terminated[0]), bool(struck.truncated[0])
        return self.hall.seen(ONE)[0], float(struck.rewards[0]), over, late, info
