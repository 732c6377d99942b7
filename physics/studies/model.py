"""A stroke as a function of what is unknown about it: where its balls should have been seen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import inf
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.ball import Placed
from physics.engines.exact import ContactError, EventBudgetError
from physics.shot import Shot, heading
from physics.world import World

from .parameters import NUMBERS, places
from .paths import Paths
from .paths import places as where
from .tracks import Beginning, Track, beginning, when_moved

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]

SLOWEST = 1e-3  # m/s: a shot is faster
FIRST, FEWEST = 0.25, 4  # s, and samples, of a track that are believed at first
# what a coefficient may be, and by how much it may differ from where a fit begins
BOUNDS = {
    "slide": (1e-3, 1.0), "roll": (0.0, 0.2), "spin_decay": (0.0, 100.0), "gravity": (1.0, 30.0),
    "e": (0.0, 1.0), "mu": (0.0, 1.0), "nose": (0.7, 1.6), "e_slope": (-0.5, 0.5),
    "mu_slope": (-0.5, 0.5),
}  # fmt: skip
STEPS = {
    "slide": 0.1, "roll": 0.005, "spin_decay": 5.0, "gravity": 1.0, "e": 0.1, "mu": 0.1,
    "nose": 0.1, "e_slope": 0.05, "mu_slope": 0.05,
    "speed": 0.5, "angle": 5.0, "follow": 1.0, "masse": 0.5, "side": 1.0, "x": 0.01, "y": 0.01,
    "start": 0.02,
}  # fmt: skip


def step_of(name: str) -> float:
    """By how much an unknown may well be wrong, in its unit."""
    return STEPS[name.rpartition(".")[2]]


def bounds_of(name: str) -> tuple[float, float]:
    """Least and most; for the numbers of a shot there are none, but for its speed."""
    return (SLOWEST, inf) if name == "speed" else BOUNDS.get(name.rpartition(".")[2], (-inf, inf))


class TrackedStroke:
    """One track, and the names of what is unknown about it alone."""

    def __init__(
        self, track: Track, world: World, shared: Sequence[str], own: Sequence[str], name: str
    ) -> None:
        import numpy as np

        self.track, self.world, self.name, self.shared = track, world, name, tuple(shared)
        self.begun: Beginning = beginning(track, world, name)
        self.struck = world.balls[self.begun.struck].name
        self.own = (*own, "start") if self.begun.free else tuple(own)
        self.by = (*self.shared, *own)
        self.spots = track.positions[..., 0] + 1j * track.positions[..., 1]
        self.there = np.isfinite(self.spots)
        self.size = int(self.there.sum())
        self.seconds = float(track.times[-1] - self.begun.start)
        self.quiet = self._quiet()
        """Seconds of it that are believed from the beginning: until another ball moves, if soon."""

    def _quiet(self) -> float:
        import numpy as np

        times = self.track.seen(self.begun.struck)[0] - self.begun.start
        after = times[times > 0.0]
        least = after[min(FEWEST, len(after)) - 1] if len(after) else FIRST
        others = [when_moved(self.track, k) for k in range(len(self.world.balls))]
        others[self.begun.struck] = inf
        frame = float(np.median(np.diff(self.track.times)))
        return float(max(least, min(FIRST, min(others) - self.begun.start - 2.0 * frame)))

    def first(self, follow: float, side: float, bounced: int = 0) -> dict[str, float]:
        """Where a fit begins; follow and side are shares of the speed, bounced is which of the
        velocities it had."""
        velocity = self.begun.velocities[bounced]
        speed = max(abs(velocity), SLOWEST)
        if "follow" not in self.own:
            follow = 0.0
        if "side" not in self.own:
            side = 0.0
        shot = (speed, heading(velocity), follow * speed, 0.0, side * speed)
        found = dict(zip(NUMBERS, shot, strict=True))
        spots = [x for spot in self.begun.spots for x in (spot.real, spot.imag)]
        found |= dict(zip(places(self.world), spots, strict=True))
        return found | {"start": self.begun.start}

    def played(self, values: Mapping[str, float], seconds: float) -> World | None:
        """The stroke in a world with those values; None if nothing comes of it."""
        world = self.world.fork(self.world.log.fresh())
        set_coefficients(world, values)
        spots = places(world)
        world.recall(
            [
                Placed(complex(values[x], values[y]))
                for x, y in zip(spots[::2], spots[1::2], strict=True)
            ]
        )
        try:
            world.strike(self.struck, Shot(*(values[number] for number in NUMBERS)))
            world.run(world.time + max(seconds, 0.0))
        except (ValueError, EventBudgetError, ContactError):
            return None
        return world

    def misses(self, values: Mapping[str, float], seconds: float) -> Any:
        """(T, balls) complex: seen less expected, m, up to so long after the start; else NaN."""
        import numpy as np

        world = self.played(values, seconds)
        times = self.track.times - values["start"]
        if world is None:
            return None
        return np.where((times <= seconds)[:, None], self.spots - where(world, times), np.nan)

    def sight(self, values: Mapping[str, float], seconds: float) -> Sight | None:
        """The misses, and how what is expected depends on shared and own unknowns."""
        import numpy as np

        world = self.played(values, seconds)
        if world is None:
            return None
        times = self.track.times - values["start"]
        paths = Paths(world, self.struck, Shot(*(values[n] for n in NUMBERS)), self.by)
        miss, slopes = [], []
        for ball in range(len(world.balls)):
            rows = self.there[:, ball] & (times <= seconds)
            there, by, speed = paths.slopes(ball, times[rows])
            slopes.append(np.hstack((by, -speed[:, None])) if self.begun.free else by)
            miss.append(self.spots[rows, ball] - there)
        return Sight(np.concatenate(miss), np.concatenate(slopes))


class Sight(NamedTuple):
    """miss: (n,) complex, m, for each sight of a ball.  slopes: (n, unknowns) of its place."""

    miss: Any
    slopes: Any


def set_coefficients(world: World, values: Mapping[str, float]) -> None:
    """Give the world's cloth and laws what the values name as theirs."""
    for part, attribute in (("cloth", "cloth"), ("cushion", "cushion_law"), ("ball", "ball_law")):
        changed = {
            name.removeprefix(f"{part}."): value
            for name, value in values.items()
            if name.startswith(f"{part}.") and name.removeprefix(f"{part}.") in BOUNDS
        }
        if changed:
            setattr(world, attribute, replace(getattr(world, attribute), **changed))
