"""The way from poor coefficients to the best ones.

A track is believed for its first quarter of a second, and then, as the model follows it better, up
to where the two part: so there is always something to learn, and never a ball that goes elsewhere
because it just missed another. If the model cannot be made to follow a track, its stroke is begun
otherwise: with draw, or with side.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf, sqrt
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.world import World

from .least_squares import Block, block, huber, information, inverse, step
from .model import TrackedStroke, bounds_of, set_coefficients, step_of
from .parameters import coefficients

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]

GATE = 0.03  # m: a track and its model that are farther apart than this have parted
MARGIN = 0.03  # s: of a track that is believed beyond where they part
LATE = 3  # samples in a row that show it: one alone is a mistake
SEARCH, POLISH = 80, 40  # rounds
AGAIN = 3  # how often strokes that the model leaves are begun otherwise
IDLE = 8  # rounds without progress that end a search
TRIES = 6  # of a step that leads uphill
SETTLED = 1e-7  # of the misfit: a gain below it ends the fit
BEND, ROUGH = 4.0, 0.03  # misses beyond so many noises, and so many m while searching, count less
LEASH = 10.0  # how much farther what no sample shows may go once the search is over
WHOLE = 0.999  # of a track
POOR = 4.0  # standard deviations of the mean square of the misses, above that of the noise
FIXED = 1e-6  # the step of what shall stay as it is
SHAKE, SHAKES = 3.0, 3  # standard deviations, and how often
# (follow, side) of the speed, with which a stroke may have begun: never without side, because a
# little of it is gone before it meets a cushion, and then its slope shows nothing
STARTS = (
    (0.6, 0.3), (0.6, -0.3), (-0.3, 0.3), (-0.3, -0.3), (0.1, 0.7), (0.1, -0.7), (0.9, 0.1),
    (0.9, -0.1),
)  # fmt: skip


class Guess(NamedTuple):
    """shared: (S,).  own: (n,) for each stroke.  believed: seconds of each track."""

    shared: Any
    own: list[Any]
    believed: list[float]


class Search:
    """From poor values to the best ones."""

    def __init__(self, world: World, strokes: list[TrackedStroke], shared: tuple[str, ...]) -> None:
        import numpy as np

        self.world, self.strokes, self.names = world, strokes, shared
        self.fixed = [stroke.first(*STARTS[0]) for stroke in strokes]
        self.free = np.array([step_of(name) for name in shared])
        self.level = True
        """Is every cue taken for level, so that there is no masse?  It passes for much else."""
        given = {"cloth": world.cloth, "cushion": world.cushion_law, "ball": world.ball_law}
        self.given = {
            name: float(getattr(given[name.partition(".")[0]], name.partition(".")[2]))
            for name in coefficients(world)
        }

    # -- one guess -----------------------------------------------------------------------------

    def begin(self) -> Guess:
        import numpy as np

        shared = np.array([self.given[name] for name in self.names])
        own = [self._own(k, 0) for k in range(len(self.strokes))]
        return Guess(shared, own, [stroke.quiet for stroke in self.strokes])

    def _own(self, k: int, variant: int) -> Any:
        import numpy as np

        bounced, variant = divmod(variant, len(STARTS))
        first = self.given | self.strokes[k].first(*STARTS[variant], bounced)
        return np.array([first[name] for name in self.strokes[k].own])

    def values(self, guess: Guess, k: int) -> dict[str, float]:
        found = self.fixed[k] | dict(zip(self.names, guess.shared, strict=True))
        return found | dict(zip(self.strokes[k].own, guess.own[k], strict=True))

    def misses(self, guess: Guess, k: int, seconds: float) -> Any:
        return self.strokes[k].misses(self.values(guess, k), seconds)

    def cost(self, guess: Guess, k: int, noise: float, bend: float) -> float:
        """The loss of a track as far as it is believed; inf if the stroke cannot be played."""
        import numpy as np

        miss = self.misses(guess, k, guess.believed[k])
        return inf if miss is None else huber(np.abs(miss) / noise, bend)

    def costs(self, guess: Guess, noise: Sequence[float], bend: Sequence[float]) -> float:
        total = 0.0
        for k in range(len(self.strokes)):
            total += self.cost(guess, k, noise[k], bend[k])
        return total

    # -- downhill ------------------------------------------------------------------------------

    def blocks(self, guess: Guess, noise: Sequence[float], bend: Sequence[float]) -> list[Block]:
        found = []
        for k, stroke in enumerate(self.strokes):
            sight = stroke.sight(self.values(guess, k), guess.believed[k])
            assert sight is not None  # its cost is finite
            found.append(block(*sight, len(self.names), noise[k], bend[k]))
        return found

    def _free(self, stroke: TrackedStroke) -> Any:
        """(n,) steps that its own unknowns may take."""
        import numpy as np

        fixed = {"masse"} if self.level else set()
        return np.array([FIXED if name in fixed else step_of(name) for name in stroke.own])

    def moved(self, guess: Guess, change: tuple[Any, list[Any]]) -> Guess:
        """The guess after a step, within bounds."""
        import numpy as np

        shared = np.clip(guess.shared + change[0], *_bounds(self.names))
        own = [
            np.clip(x + dx, *_bounds(stroke.own))
            for stroke, x, dx in zip(self.strokes, guess.own, change[1], strict=True)
        ]
        return Guess(shared, own, guess.believed)

    def descend(
        self, guess: Guess, noise: Sequence[float], bend: Sequence[float], damping: float,
        leash: float = 1.0,
    ) -> tuple[Guess, float, float]:  # fmt: skip
        """One round: (guess, damping for the next, share of the cost gained)."""
        cost = self.costs(guess, noise, bend)
        if cost == inf:
            return guess, damping, 0.0
        blocks = self.blocks(guess, noise, bend)
        own_free = [leash * self._free(stroke) for stroke in self.strokes]
        for _ in range(TRIES):
            trial = self.moved(guess, step(blocks, damping, leash * self.free, own_free))
            new = self.costs(trial, noise, bend)
            if new < cost:
                return trial, max(0.2 * damping, 1e-7), (cost - new) / cost
            damping *= 10.0
        return guess, min(damping, 1e3), 0.0

    def extend(self, guess: Guess) -> Guess:
        """Believe each track up to where its model leaves it."""
        believed = []
        for k, stroke in enumerate(self.strokes):
            miss = self.misses(guess, k, stroke.seconds)
            start = self.values(guess, k)["start"]
            parts = 0.0 if miss is None else parting(stroke, miss, start)
            believed.append(min(max(stroke.quiet, parts), stroke.seconds))
        return guess._replace(believed=believed)

    def share(self, guess: Guess, k: int) -> float:
        """Of a track: how much of it is believed."""
        seconds = self.strokes[k].seconds
        return min(1.0, guess.believed[k] / seconds) if seconds > 0.0 else 1.0

    def followed(self, guess: Guess) -> float:
        """Of all tracks; the number of strokes, if each is followed to its end."""
        total = 0.0
        for k in range(len(self.strokes)):
            total += self.share(guess, k)
        return total

    # -- the whole way -------------------------------------------------------------------------

    def run(self) -> Guess:
        """Search, and begin again where that leads nowhere."""
        guess = self.search(self.begin())
        for _ in range(AGAIN):
            if not any(self.poor(guess, k) for k in range(len(self.strokes))):
                break
            guess, lost = self.agreed(guess)
            own = list(guess.own)
            for k in lost:
                own[k] = self.alone(guess, k)
            guess = self.better(guess, self.search(self.extend(guess._replace(own=own))))
            self.level = False
        return guess

    def _one(self, guess: Guess, k: int) -> tuple[Search, Guess]:
        """The search for a stroke's own unknowns alone, as the coefficients are now."""
        stroke, world = self.strokes[k], self.world.copy()
        set_coefficients(world, dict(zip(self.names, guess.shared, strict=True)))
        own = [name for name in stroke.own if name != "start"]
        search = Search(world, [TrackedStroke(stroke.track, world, (), own, stroke.name)], ())
        search.level = self.level
        return search, Guess(search.begin().shared, [guess.own[k]], [guess.believed[k]])

    def shaken(self, guess: Guess) -> Guess:
        """From a little beside the guess, where that leads lower: where a ball just sticks or just
        slips the misfit has kinks, in which a descent may end."""
        import numpy as np

        chance, own = np.random.default_rng(0), list(guess.own)
        for k in range(len(own)):
            search, alone = self._one(guess, k)
            search.noise, search.bend = self.noise[k : k + 1], self.bend[k : k + 1]
            own[k] = search.beside(alone, chance, 1e-4).own[0]
        return self.beside(guess._replace(own=own), chance, SETTLED)

    def beside(self, guess: Guess, chance: np.random.Generator, enough: float) -> Guess:
        """The best of what is found from here and from some places near by, as errors are."""
        for _ in range(SHAKES):
            blocks = self.blocks(guess, self.noise, self.bend)
            shared = _scattered(inverse(information(blocks)[0]), chance)
            own = []
            for part in blocks:
                alone = inverse(part.own)
                own.append(_scattered(alone, chance) - alone @ part.mixed.T @ shared)
            trial = self.moved(guess, (shared, own))
            trial = self.settle(trial, self.noise, self.bend, enough)
            costs = (self.costs(each, self.noise, self.bend) for each in (trial, guess))
            guess = min(zip(costs, (0, 1), (trial, guess), strict=True))[2]
        return guess

    def agreed(self, guess: Guess) -> tuple[Guess, list[int]]:
        """The coefficients of the strokes that agree on them; and the others, the worst first."""
        rest, lost = list(range(len(self.strokes))), []
        while len(rest) > 1 and any(self.poor(guess, k) for k in rest):
            worst = max(rest, key=lambda k: self.badness(guess, k))
            rest.remove(worst)
            lost.append(worst)
            part = Search(self.world, [self.strokes[k] for k in rest], self.names)
            part.level = self.level
            few = Guess(guess.shared, *([x[k] for k in rest] for x in guess[1:]))
            found = part.search(few)
            own, believed = list(guess.own), list(guess.believed)
            for k, mine, far in zip(rest, found.own, found.believed, strict=True):
                own[k], believed[k] = mine, far
            guess = Guess(found.shared, own, believed)
        return guess, lost or rest

    def alone(self, guess: Guess, k: int) -> Any:
        """A stroke's own unknowns, of its beginnings that whose path stays with the track longest,
        as the coefficients are now."""
        search, best = self._one(guess, k)
        for variant in range(len(STARTS) * len(self.strokes[k].begun.velocities)):
            found = search.search(search.begin()._replace(own=[search._own(0, variant)]))
            best = search.better(best, found)
            if not search.poor(best, 0):
                break
        return best.own[0]

    def poor(self, guess: Guess, k: int) -> bool:
        """Does the model leave the track, or run beside it?  Then it may have begun otherwise."""
        return self.badness(guess, k) > 1.0 + POOR / sqrt(self.strokes[k].size)

    def badness(self, guess: Guess, k: int) -> float:
        """The mean square of the misses, in noises; for a track that is left, more than for any
        that is not."""
        stroke, noise = self.strokes[k], self.strokes[k].track.noise
        if self.share(guess, k) < WHOLE:
            return GATE / noise * (GATE / noise) / self.share(guess, k)
        return self.cost(guess, k, noise, ROUGH / noise) / (2.0 * stroke.size)

    def better(self, guess: Guess, other: Guess) -> Guess:
        """The one that follows more of the tracks, or as much of them more closely."""
        noise = [stroke.track.noise for stroke in self.strokes]
        bend = [ROUGH / sigma for sigma in noise]
        gained = self.followed(other) - self.followed(guess)
        if abs(gained) > 1e-3:
            return other if gained > 0.0 else guess
        nearer = self.costs(other, noise, bend) < self.costs(guess, noise, bend)
        return other if nearer else guess

    def search(self, guess: Guess) -> Guess:
        """Until the model follows every track to its end, or no farther."""
        noise = [stroke.track.noise for stroke in self.strokes]
        bend = [ROUGH / sigma for sigma in noise]
        damping, idle, best = 1e-2, 0, guess
        for _ in range(SEARCH):
            guess, damping, gained = self.descend(guess, noise, bend, damping)
            guess = self.extend(guess)
            done = self.followed(guess) >= WHOLE * len(self.strokes)
            farther = self.followed(guess) > self.followed(best) + 1e-3
            idle = 0 if farther or (done and gained > 1e-2) else idle + 1
            best = guess if farther or done else best
            if idle >= IDLE or (done and gained < 1e-2):
                break
        return self.settle(best, noise, bend, 1e-3)

    def settle(
        self, guess: Guess, noise: Sequence[float], bend: Sequence[float], enough: float
    ) -> Guess:
        """The minimum, or a gain below `enough`; now without a leash."""
        damping = 1e-3
        for _ in range(POLISH):
            guess, damping, gained = self.descend(guess, noise, bend, damping, LEASH)
            if gained < enough:
                break
        return guess

    def polish(self, guess: Guess) -> Guess:
        """The minimum, with misses as large as they are taken for noise; masse is free now."""
        self.level = False
        self.bend = [BEND] * len(self.strokes)
        for _ in range(2):
            self.noise = [
                max(stroke.track.noise, self.scatter(guess, k))
                for k, stroke in enumerate(self.strokes)
            ]
            guess = self.settle(guess, self.noise, self.bend, SETTLED)
        return self.shaken(guess)

    def scatter(self, guess: Guess, k: int) -> float:
        """The noise that a track seems to have, m: from the median, which mistakes do not move."""
        import numpy as np

        miss = self.misses(guess, k, guess.believed[k])
        size = np.abs(miss[np.isfinite(miss)])
        return float(np.median(size)) / 1.1774 if len(size) else 0.0  # of a Rayleigh distribution


def _scattered(covariance: Any, chance: np.random.Generator) -> Any:
    """Some of these errors, SHAKE times as large as they are."""
    import numpy as np

    sizes, ways = np.linalg.eigh(covariance)
    scale = SHAKE * np.sqrt(np.maximum(sizes, 0.0))
    return ways @ (scale * chance.normal(size=len(sizes)))


def _bounds(names: Sequence[str]) -> tuple[Any, Any]:
    import numpy as np

    low, high = np.array([bounds_of(name) for name in names]).reshape(-1, 2).T
    return low, high


def parting(stroke: TrackedStroke, miss: Any, start: float) -> float:
    """Seconds after the start up to which a track is followed, and a little more."""
    import numpy as np

    ends = [stroke.seconds]
    gate = max(GATE, 10.0 * stroke.track.noise)
    for ball in range(miss.shape[1]):
        seen = np.flatnonzero(np.isfinite(miss[:, ball]))
        off = np.abs(miss[seen, ball]) > gate
        late = off.copy()
        for shift in range(1, LATE):
            late[:-shift] &= off[shift:]
        if late.any():
            ends.append(float(stroke.track.times[seen[np.argmax(late)]] - start + MARGIN))
    return float(min(ends))
