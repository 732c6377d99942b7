"""What an environment is made of: its game, its table, and how strokes are aimed and go wrong."""

from __future__ import annotations

import importlib.util
from dataclasses import dataclass
from math import isfinite
from typing import Any

from danggu.players.levels import Level
from danggu.rules import GAMES, RACKS
from danggu.rules.verdict import Rules
from physics import World, tables

from .actions import AIMS, BALL
from .noise import Noise, noise_of

SPEEDS, BREAKS = (0.5, 7.0), (0.5, 10.0)  # m/s: without pockets, and with them
FOUR_BALL = "four-ball"


@dataclass(frozen=True, slots=True)
class Setup:
    """What all environments take; ValueError for what cannot be.

    game: a name in `danggu.rules.GAMES`.
    noise: how strokes go wrong: None, a `Noise`, a level of players, or a name in `NOISES`.
    aim: "ball", the first two numbers of an action choose a ball and where it is hit, or
    "absolute", they are the direction (x, y).
    inning: whether an episode ends with the first stroke after which the turn would pass. None: in
    games without pockets; in others it ends with the rack.
    limit: strokes after which an episode is truncated.
    table: a world without balls, None for the usual table of the game.
    speeds: the slowest and the fastest stroke, m/s; None: 0.5 to 7, with pockets to 10.
    compiled: by the compiled kernel? None: for many tables if numba is there, and else as
    `physics.simulate_many` chooses.
    """

    game: str
    noise: str | Noise | Level | None = None
    aim: str = BALL
    inning: bool | None = None
    limit: int = 100
    table: World | None = None
    speeds: tuple[float, float] | None = None
    compiled: bool | None = None

    def __post_init__(self) -> None:
        if self.game not in GAMES:
            raise ValueError(f"game must be one of {', '.join(GAMES)}, not {self.game!r:.60}")
        if self.aim not in AIMS:
            raise ValueError(f"aim must be one of {', '.join(AIMS)}, not {self.aim!r:.60}")
        if type(self.limit) is not int or self.limit < 1:
            raise ValueError(f"limit must be a whole number above 0, not {self.limit!r:.60}")
        if self.table is not None and (not isinstance(self.table, World) or self.table.balls):
            raise ValueError(f"table must be a world without balls, not {self.table!r:.60}")
        slow, fast = self.pace
        if not (0.0 < slow < fast and isfinite(fast)):
            raise ValueError(f"speeds must be two, the slower first, not {self.speeds!r:.60}")
        noise_of(self.noise)

    @property
    def rules(self) -> Rules:
        return GAMES[self.game]()

    @property
    def racked(self) -> bool:
        """Whether the game begins with a rack."""
        return self.game in RACKS

    @property
    def by_inning(self) -> bool:
        return not self.racked if self.inning is None else self.inning

    @property
    def pace(self) -> tuple[float, float]:
        return self.speeds or (BREAKS if self.racked else SPEEDS)

    def world(self) -> World:
        """The table, without balls."""
        if self.table is not None:
            return self.table.copy()
        if not self.racked:
            return tables.medium_carom() if self.game == FOUR_BALL else tables.match_carom()
        makers: dict[str, Any] = {"snooker": tables.snooker_12ft, "pyramid": tables.pyramid_12ft}
        return makers.get(RACKS[self.game], tables.pool_9ft)()  # type: ignore[no-any-return]

    def kernel(self, count: int) -> bool | None:
        """What `simulate_many` is asked for: many tables are worth the wait for the kernel."""
        if self.compiled is None and count > 1 and importlib.util.find_spec("numba"):
            return True
        return self.compiled
