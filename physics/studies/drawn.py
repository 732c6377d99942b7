"""The inverse problem without times: how must a ball be struck to run along a drawn line?

A hand draws where, not when, and errs by a centimetre. So drawing and path are matched point by
point, in their order, and only what lies across the path is a miss; and where a drawing says little
(how fast a ball runs shows in its rebounds alone), a player's habits decide. All five numbers of
the shot are fitted at once, with exact derivatives, from the best of a grid of shots.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby, product
from math import inf, isfinite, pi, sqrt
from operator import itemgetter
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.ball import Ball
from physics.checks import array, finite, positive
from physics.engines.exact import ContactError, EventBudgetError, EventDriven
from physics.kernel.elementary import exp
from physics.shot import Shot, heading
from physics.simulation import simulate
from physics.world import World

from .least_squares import huber
from .parameters import NUMBERS
from .paths import Paths, course

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]
    Points = npt.NDArray[np.complex128]

APART = 0.1  # m along a drawing: nearer points are wrong together
FINE = 0.01  # m along a path
TICK = 0.01  # s
SHORTEST, BEGUN = 0.1, 0.25  # m: a drawing is longer, and begins no farther from its ball
BEND = 3.0  # noises: misses beyond count less
HABIT = {"speed": (3.0, 1.5), "follow": (0.4, 0.5), "masse": (0.0, 0.1), "side": (0.0, 0.5)}
"""How players strike, mean and deviation: m/s, and for spins shares of the speed."""
LEVEL = {"masse": 0.0}  # the cue
SPEEDS, FOLLOWS = (1.5, 2.5, 4.0, 6.0), (0.1, 0.8)
SIDES, TURNS = (-0.7, -0.35, 0.0, 0.35, 0.7), (-1.5, -0.5, 0.5, 1.5)
FIRST, SOON, BEST, ROUNDS, TRIES = 2, 5, 4, 25, 6
"""Fits begun with each speed, their rounds; those that go on, their rounds, and tries of a step."""
SHAKES, FEWER, SHAKE, SHAKEN_ANGLE = 12, 4, 0.5, 0.5  # how often; of habits; degrees
CLOSE = 1.0  # of the cost of a point, if it is off by the noise
MEDIAN = 0.6745  # of the size of misses of one noise
FIXED = 1e-9  # deviation of what is given
SETTLED = 1e-3  # of the cost: a gain below it ends a fit


class Drawn(NamedTuple):
    """What `recover_drawn` returns.

    shot: whose path follows the drawing best.
    covariance: (5, 5) of speed, angle (degrees), follow, masse and side; from the hand's noise, or
    the misses if they are more, and a player's habits, which are all that there is for a number
    that the drawing does not show.
    misfit: rms distance of the drawing from the path, m.
    share: of the drawing, how much there is before it leaves the path for good.
    """

    shot: Shot
    covariance: Array
    misfit: float
    share: float

    @property
    def errors(self) -> dict[str, float]:
        """Standard deviations of the five numbers, by name."""
        return dict(zip(NUMBERS, map(sqrt, self.covariance.diagonal().tolist()), strict=True))


def recover_drawn(
    world: World,
    ball: Ball | str,
    path: Sequence[Sequence[float]] | Array,
    noise: float = 0.01,
    rests: bool = False,
    given: Mapping[str, float] = LEVEL,
) -> Drawn:
    """The shot with which a ball runs along a line that was drawn, cushions and balls and all.

    path: (n, 2) m, in the order in which it is run through; it begins at the ball, roughly.
    noise: by how much the hand errs, m.
    rests: does the ball come to rest where the drawing ends? Else it may run on.
    given: numbers of the shot that are known; by default the cue is level, so that masse is 0.

    See docs/physics.md, "Recovering a shot from a drawing". ValueError for a path that is none or
    begins elsewhere, a name or ball that there is not, or an engine other than EventDriven.
    """
    if not isinstance(world.engine, EventDriven):
        raise ValueError(f"recover_drawn needs the engine EventDriven, not {world.engine!r}")
    for name, number in given.items():
        if name not in NUMBERS:
            raise ValueError(f"recover_drawn: given {name!r} is none of {', '.join(NUMBERS)}")
        finite(f"recover_drawn: given {name}", number)
    noise = positive("recover_drawn noise", noise)
    cue, drawn = world.ball(ball), _points(path, noise)
    if (away := abs(complex(drawn[0]) - complex(*cue.position))) > max(BEGUN, 10.0 * noise):
        raise ValueError(f"recover_drawn: path begins {away:.3g} m from ball {cue.name!r}")
    return _Search(world, cue.name, drawn, noise, rests, given).found()


def _points(path: Any, noise: float) -> Points:
    """(n,) complex, `APART` from each other along the drawing."""
    import numpy as np

    drawn = array("recover_drawn path", path)
    if drawn.ndim != 2 or drawn.shape[1] != 2 or not np.isfinite(drawn).all():
        raise ValueError(f"recover_drawn: path must be finite points (n, 2), not {drawn.shape}")
    spots = drawn[:, 0] + 1j * drawn[:, 1]
    if (length := float(np.abs(np.diff(spots)).sum())) < max(SHORTEST, 4.0 * noise):
        raise ValueError(f"recover_drawn: a path of {length:.3g} m is too short to tell a shot by")
    return _spaced(spots, APART)


def _spaced(spots: Any, apart: float) -> Points:
    """The same line by points about so far apart, with both ends."""
    import numpy as np

    along = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(spots)))))
    at = np.linspace(0.0, along[-1], max(2, round(along[-1] / apart) + 1))
    found: Points = np.interp(at, along, spots.real) + 1j * np.interp(at, along, spots.imag)
    return found


class _Try(NamedTuple):
    """A shot's numbers (5,), and how much is wrong about it: misses and odd habits.

    after: the world after the shot, or None if it cannot be played.
    match: the drawing's with its path.
    """

    numbers: Any
    cost: float
    after: Any = None
    match: Any = None


class _Search:
    """From a drawing to the shot."""

    def __init__(
        self, world: World, ball: str, drawn: Points, noise: float, rests: bool, given: Any
    ) -> None:
        self.world, self.ball, self.drawn, self.noise = world, ball, drawn, noise
        self.rests, self.given = rests, given
        self.number = [each.name for each in world.balls].index(ball)

    def found(self) -> Drawn:
        import numpy as np

        fits = self._fits()
        size = np.abs(fits[0].match.miss)
        off = np.flatnonzero(size > BEND * self.noise)
        ends = len(off) > 2 and off[-1] == len(size) - 1
        late = _last_run(off) if ends else len(size)
        spread = max(1.0, float(np.median(size)) / (MEDIAN * self.noise))
        covariance = self._covariance(fits, spread)
        best = _shot(fits[0].numbers)
        return Drawn(best, covariance, sqrt(float((size * size).mean())), late / len(size))

    def _fits(self) -> list[_Try]:
        """The best first, and others that explain the drawing otherwise."""
        begun: list[_Try] = []
        for _, shots in groupby(sorted(self._starts()), key=itemgetter(0)):
            tried = sorted(map(self._tried, shots), key=_cost)
            begun += [self._descended(fit, SOON) for fit in tried[:FIRST] if isfinite(fit.cost)]
        if not begun:
            raise ValueError("recover_drawn: no shot can be played in this world")
        begun.sort(key=_cost)
        fits = sorted((self._descended(fit, ROUNDS) for fit in begun[:BEST]), key=_cost)
        return sorted((*fits, *self._shaken(fits[0])), key=_cost)

    def _shaken(self, best: _Try) -> Iterator[_Try]:
        """Others, from beside the best: where friction just sticks or just slips a descent may end
        early. Fewer if the drawing is followed as closely as a hand draws."""
        import numpy as np

        chance = np.random.default_rng(0)
        for k in range(SHAKES):
            if k >= FEWER and best.cost < CLOSE * len(self.drawn):
                break
            wide = SHAKE * _habits(best.numbers, self.given)[1]
            wide[1] = 0.0 if "angle" in self.given else SHAKEN_ANGLE
            beside = self._tried(best.numbers + wide * chance.standard_normal(5))
            fit = self._descended(beside, SOON)
            if fit.cost < best.cost:
                best = fit = self._descended(fit, ROUNDS)
            if isfinite(fit.cost):
                yield fit

    def _covariance(self, fits: list[_Try], spread: float) -> Array:
        """About the best of them, with the others as likely as their costs make them."""
        import numpy as np

        whole, total = np.zeros((5, 5)), 0.0
        for fit in fits:
            off = fit.numbers - fits[0].numbers
            share = exp(-0.5 * (fit.cost - fits[0].cost) / (spread * spread))
            here = np.linalg.inv(self._normal(fit, spread)[0])
            whole += share * (here + np.outer(off, off))
            total += share
        return whole / total

    # -- where fits begin ----------------------------------------------------------------------

    def _starts(self) -> set[tuple[float, ...]]:
        """Shots about the direction in which the drawing sets out."""
        toward, error = _sets_out(self.drawn, self.noise)
        speeds = (self.given["speed"],) if "speed" in self.given else SPEEDS
        grid = product(speeds, TURNS, FOLLOWS, SIDES)
        shots = [(v, toward + error * turn, v * f, 0.0, v * s) for v, turn, f, s in grid]
        return {
            tuple(self.given.get(name, x) for name, x in zip(NUMBERS, shot, strict=True))
            for shot in shots
        }

    def _tried(self, numbers: Any) -> _Try:
        import numpy as np

        numbers = np.array(numbers)
        after = self._played(numbers)
        if after is None:
            return _Try(numbers, inf)
        match = _Match(self.drawn, *self._path(after), self.rests)
        mean, wide = _habits(numbers, self.given)
        odd = float((((numbers - mean) / wide) ** 2).sum())
        return _Try(numbers, huber(np.abs(match.miss) / self.noise, BEND) + odd, after, match)

    # -- one shot ------------------------------------------------------------------------------

    def _played(self, numbers: Any) -> World | None:
        if not numbers[0] > 0.0:
            return None
        try:
            return simulate(self.world, self.ball, _shot(numbers))
        except (ValueError, EventBudgetError, ContactError):
            return None

    def _path(self, after: World) -> tuple[Array, Points, bool]:
        """(M,) seconds and places along its path, a little farther than the drawing, if it goes on
        for so long; and whether it ends there."""
        import numpy as np

        last = after.log.legs(self.ball)[-1].since
        times = np.linspace(0.0, last, max(2, round(last / TICK)))
        spots = course(after, self.ball, times)
        along = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(spots)))))
        end = len(times)
        if not self.rests:
            far = 1.2 * APART * len(self.drawn) + 0.3
            end = min(end, int(np.searchsorted(along, far)) + 2)
        at = np.linspace(0.0, along[end - 1], max(2, round(along[end - 1] / FINE)))
        moments = np.interp(at, along[:end], times[:end])
        return moments, course(after, self.ball, moments), end == len(times)

    def _normal(self, fit: _Try, spread: float = 1.0) -> tuple[Any, Any]:
        """Curvature (5, 5) and downhill (5,) of half the cost."""
        import numpy as np

        numbers, match = fit.numbers, fit.match
        paths = Paths(fit.after, self.ball, _shot(numbers), NUMBERS)
        _, slopes, _ = paths.slopes(self.number, match.times)
        miss = np.concatenate((match.across(match.miss), match.along(match.miss)))
        j = np.concatenate((match.across(slopes), match.along(slopes)))
        j = np.where(np.isfinite(j), j, 0.0)
        sigma = spread * self.noise
        size = np.tile(np.abs(match.miss) / sigma, 2)
        weight = np.minimum(1.0, BEND / np.maximum(size, 1e-9))[:, None] / (sigma * sigma)
        mean, wide = _habits(numbers, self.given)
        curve = j.T @ (weight * j) + np.diag(wide**-2.0)
        return curve, j.T @ (weight[:, 0] * miss) + (mean - numbers) / wide**2

    def _descended(self, fit: _Try, rounds: int) -> _Try:
        """Damped steps of Gauss and Newton, as long as they lead downhill."""
        import numpy as np

        damping = 1e-2
        for _ in range(rounds if isfinite(fit.cost) else 0):
            curve, down = self._normal(fit)
            before = fit.cost
            for _ in range(TRIES):
                step = np.linalg.solve(curve + np.diag(damping * np.diag(curve)), down)
                trial = self._tried(fit.numbers + step)
                damping *= 0.2 if trial.cost < before else 5.0
                if trial.cost < before:
                    fit = trial
                    break
            if before - fit.cost < SETTLED * (1.0 + fit.cost):
                break
        return fit


class _Match:
    """The points of a drawing, each with the point of the path that it stands for.

    times: (n,) s.  miss: (n,) complex, drawing less path.
    """

    def __init__(
        self, drawn: Points, moments: Array, spots: Points, ends: bool, rests: bool
    ) -> None:
        import numpy as np

        far = np.abs(drawn[:, None] - spots[None, :])
        at = _in_order(far * far, rests)
        ways = np.gradient(spots)
        ways[np.abs(ways) == 0.0] = 1.0
        self.way = (ways / np.abs(ways))[at]
        last = len(spots) - 1
        self.whole = (at == last) & ends
        """Is it beyond the end of the path, so that the way along counts too?"""
        miss = drawn - spots[at]
        ahead = (np.conj(self.way) * miss).real
        step = np.clip(ahead, -FINE, FINE) * ~self.whole
        speeds = np.gradient(np.arange(last + 1.0) * FINE, moments)[at]
        self.times = np.clip(moments[at] + step / np.maximum(speeds, 1e-3), 0.0, moments[-1])
        self.miss = miss - step * self.way

    def across(self, z: Any) -> Any:
        """(n, …): of z, what is across the path."""
        return (_as(self.way, z).conjugate() * z).imag

    def along(self, z: Any) -> Any:
        """(n, …): of z, what is along it, beyond its end."""
        return (_as(self.way, z).conjugate() * z).real * _as(self.whole, z)


def _as(column: Any, z: Any) -> Any:
    return column.reshape(-1, *[1] * (z.ndim - 1))


def _in_order(cost: Array, rests: bool) -> Any:
    """(n,): for each row a column, never before that of the row above, with the least sum; the last
    row has the last column if it rests there."""
    import numpy as np

    rows, columns = cost.shape
    best, back = cost[0], np.zeros((rows, columns), int)
    numbers = np.arange(columns)
    for k in range(1, rows):
        least = np.minimum.accumulate(best)
        back[k] = np.maximum.accumulate(np.where(best == least, numbers, 0))
        best = cost[k] + least
    at = np.empty(rows, int)
    at[-1] = columns - 1 if rests else int(np.argmin(best))
    for k in range(rows - 1, 0, -1):
        at[k - 1] = back[k, at[k]]
    return at


def _sets_out(drawn: Points, noise: float) -> tuple[float, float]:
    """The angle in which a drawing begins, and its error, degrees: of its first straight part."""
    import numpy as np

    count = 2
    for end in range(3, len(drawn) + 1):
        chord = drawn[end - 1] - drawn[0]
        off = np.abs(((drawn[:end] - drawn[0]) * np.conj(chord)).imag) / max(abs(chord), 1e-9)
        if off.max() > 2.0 * noise:
            break
        count = end
    chord = complex(drawn[count - 1] - drawn[0])
    return heading(chord), min(20.0, 360.0 / pi * noise / max(abs(chord), noise))


def _habits(numbers: Any, given: Mapping[str, float]) -> tuple[Any, Any]:
    """(5,) means and deviations."""
    import numpy as np

    speed, mean, wide = max(float(numbers[0]), 0.1), [], []
    for name in NUMBERS:
        middle, error = HABIT.get(name, (0.0, 1e4))
        scale = 1.0 if name in ("speed", "angle") else speed
        fixed = name in given
        mean.append(given[name] if fixed else middle * scale)
        wide.append(FIXED if fixed else error * scale)
    return np.array(mean), np.array(wide)


def _last_run(off: Any) -> int:
    """Where the last unbroken row of those numbers begins."""
    import numpy as np

    gaps = np.flatnonzero(np.diff(off) > 1)
    return int(off[gaps[-1] + 1] if len(gaps) else off[0])


def _cost(fit: _Try) -> float:
    return fit.cost


def _shot(numbers: Any) -> Shot:
    return Shot(*(float(number) for number in numbers))
