"""Many tables as one Gymnasium environment: one batch of the kernel for a step of all of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from .setup import Setup
from .single import action_space, hall_of, key_of, observation_space


class TableVectorEnv(VectorEnv):  # type: ignore[misc]
    """So many tables, each as a `TableEnv` by itself would be, to the last bit.

    num_envs: how many.
    autoreset_mode: an `AutoresetMode` or its value.
    given: as for `Setup`; ValueError for what cannot be.
    """

    def __init__(
        self, num_envs: int = 1, autoreset_mode: Any = AutoresetMode.NEXT_STEP, **given: Any
    ) -> None:
        self.setup, self.num_envs = Setup(**given), num_envs
        self.hall = hall_of(self.setup, num_envs)
        self.mode = AutoresetMode(autoreset_mode)
        self.metadata = {"render_modes": [], "autoreset_mode": self.mode}
        self.single_action_space = action_space()
        self.single_observation_space = observation_space(self.hall)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self._all, self._over = np.arange(num_envs), np.zeros(num_envs, bool)
        self._begun = False

    def reset(
        self, *, seed: int | list[int | None] | None = None, options: Any = None
    ) -> tuple[Any, dict[str, Any]]:
        """Begin an episode at each table, or at those in options["reset_mask"], (tables,) bool.

        options["state"]: in games without pockets, where all balls lie, (tables, balls, 2) m.
        seed: of the first table, those after it having the next ones; or one for each.
        """
        mask = (options or {}).get("reset_mask")
        rows = self._all if mask is None else self._masked(mask)
        self._seed(rows, seed)
        self._over[rows] = False
        self.hall.deal(rows)
        if options and "state" in options:
            self.hall.put(rows, np.asarray(options["state"])[rows])
        return self.hall.seen(self._all), self._info(rows, np.full(self.num_envs, ""))

    def step(self, actions: Any) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        """Play a stroke at each table: (observations, rewards, terminated, truncated, infos)."""
        actions = np.asarray(actions)
        if actions.shape != self.action_space.shape:
            raise ValueError(f"actions must be {self.action_space.shape}, not {actions.shape}")
        waiting = np.flatnonzero(self._over)
        if len(waiting) and self.mode is not AutoresetMode.NEXT_STEP:
            raise ValueError(f"table {waiting[0]} must be reset before it is played on")
        rows = np.flatnonzero(~self._over)
        rewards, reasons = np.zeros(self.num_envs), np.full(self.num_envs, "", "U32")
        over, late = np.zeros((2, self.num_envs), bool)
        if len(rows):
            struck = self.hall.strike(rows, actions[rows])
            rewards[rows], over[rows], late[rows], reasons[rows] = struck
        if len(waiting):
            self.hall.deal(waiting)
        self._over, final = over | late, {}
        if self.mode is AutoresetMode.SAME_STEP and self._over.any():
            final = self._final(np.flatnonzero(self._over), reasons)
        infos = {**final, **self._info(self._all, reasons)}
        return self.hall.seen(self._all), rewards, over, late, infos

    def _final(self, ended: Any, reasons: Any) -> dict[str, Any]:
        """How the episodes that have ended have ended; the next ones are begun."""
        seen = np.full(self.num_envs, None, object)
        seen[ended] = [*self.hall.seen(ended)]
        final = {
            "final_obs": seen, "_final_obs": self._mask(ended),
            "final_info": self._info(ended, reasons), "_final_info": self._mask(ended),
        }  # fmt: skip
        self.hall.deal(ended)
        reasons[ended], self._over = "", np.zeros(self.num_envs, bool)
        return final

    def _info(self, rows: Any, reasons: Any) -> dict[str, Any]:
        mask = self._mask(rows)
        state = self.hall.places.copy()
        return {"state": state, "_state": mask, "reason": reasons.copy(), "_reason": mask.copy()}

    def _mask(self, rows: Any) -> Any:
        mask = np.zeros(self.num_envs, bool)
        mask[rows] = True
        return mask

    def _masked(self, mask: Any) -> Any:
        found = np.asarray(mask)
        if found.dtype != bool or found.shape != (self.num_envs,) or not found.any():
            raise ValueError(f"reset_mask must be ({self.num_envs},) bool, one true, not {mask!r}")
        return np.flatnonzero(found)

    def _seed(self, rows: Any, seed: int | list[int | None] | None) -> None:
        """Seed the chance of these tables, if there is a seed or none has been needed yet."""
        if isinstance(seed, int | np.integer):
            seed = [int(seed) + k for k in range(self.num_envs)]
        if seed is None:
            seed = [None] * self.num_envs
        if len(seed) != self.num_envs:
            raise ValueError(f"there must be {self.num_envs} seeds, not {len(seed)}")
        fresh = [row for row in rows if seed[row] is not None or not self._begun]
        if fresh:
            keys = [key_of(seed[row]) for row in fresh]
            self.hall.seed(fresh, np.array(keys, np.uint64))
        self._begun = True
