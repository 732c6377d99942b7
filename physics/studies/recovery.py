"""The inverse problem: how was a ball struck that was seen to run along this path?

While a ball slides, friction pulls against its slip u = v - w (w: the velocity at which it would
roll): the bend of the path gives the direction of u, and the moment at which the bend ends, T =
2 |u| / 7 μ_s g, gives its length (Jia, Mason and Erdmann). Here all samples are fitted at once, by
least squares, with the path as it follows from position, v and u at the start.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf, nan, sqrt
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.checks import array, finite, positive
from physics.cloth import Cloth
from physics.kernel.motion import length
from physics.shot import Shot, heading

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]

FEWEST = 5  # samples: ten numbers for at most six unknowns
STARTS = 24  # ends of sliding that are tried before the fit
ROUNDS = 60  # of the fit: it needs about six
HALVINGS = 8  # of a step that leads uphill
SETTLED = 1e-10  # of the misfit's square: a gain below it ends the fit
CLEARER = 12.0  # how far a richer model must lower the misfit, in noise variances: 0.3 % by chance
ROUNDING = 1e-12  # m: a misfit below it says nothing


class Recovered(NamedTuple):
    """What `recover` returns: the ball at `start`, in m, m/s and rad/s.

    phase: what the samples show, "sliding", "rolling" or "both".
    position, velocity: (2,).
    spin: (2,), ω_x and ω_y; NaN if the ball slides to the last sample.
    slip: (2,), velocity - w; if the ball slides to the last sample only its direction is known, and
    this is the least that it can be.
    covariance: (6, 6) of x, y, vx, vy, ω_x, ω_y, from the scatter of the samples; infinite for an
    unknown spin.
    misfit: rms distance of a coordinate, m.
    """

    phase: str
    position: Array
    velocity: Array
    spin: Array
    slip: Array
    covariance: Array
    misfit: float

    def __repr__(self) -> str:
        speed = length(complex(*self.velocity))
        return f"<Recovered: {self.phase}, {speed:.4g} m/s, {1e3 * self.misfit:.3g} mm>"

    def shot(self, side: float = 0.0) -> Shot:
        """The shot that sets a ball off like that.

        side: m/s; no path shows it. ValueError for a ball that rests or slides to the last sample.
        """
        if self.phase == "sliding":
            raise ValueError("the ball slides to the last sample: its spin is not known")
        velocity, roll = complex(*self.velocity), complex(*(self.velocity - self.slip))
        speed = length(velocity)
        ahead = roll * velocity.conjugate() / positive("recovered speed", speed)
        return Shot(speed, heading(velocity), ahead.real, 0.0 - ahead.imag, side)


def recover(
    times: Sequence[float] | Array,
    positions: Sequence[Sequence[float]] | Array,
    cloth: Cloth,
    radius: float = 0.03275,
    start: float | None = None,
) -> Recovered:
    """Velocity and horizontal spin with which a ball set out, from its path on the open cloth.

    times: (n,) s, growing, n >= 5.  positions: (n, 2) m.  start: when it set out, s, no later than
    the first sample, which it is by default.  Between start and last sample there must be neither
    cushion nor ball: a misfit far above the noise of the samples shows that there was. The spin
    about the vertical bends no path and cannot be seen. Where sliding and then rolling does not fit
    clearly better than one of them alone, that is returned: so a slip u too short-lived to show in
    the samples is taken for none, and the velocity is then wrong by 2/7 of it. If the cloth has
    bands, `roll` is taken to hold at all speeds.

    ValueError for too few samples, shapes or times that cannot be, or a cloth without friction.
    """
    t, p = _samples(times, positions, start)
    slide = positive("recover: cloth.slide * gravity", cloth.slide * cloth.gravity)
    path = _Path(t, p, slide, cloth.roll * cloth.gravity)
    phase, fit = path.simplest()
    return _recovered(phase, fit, path, positive("recover radius", radius))


def _samples(times: Any, positions: Any, start: float | None) -> tuple[Array, Array]:
    import numpy as np

    t, p = array("recover times", times), array("recover positions", positions)
    if t.ndim != 1 or p.shape != (len(t), 2):
        raise ValueError(f"recover: times (n,) and positions (n, 2), not {t.shape} and {p.shape}")
    if len(t) < FEWEST:
        raise ValueError(f"recover needs {FEWEST} samples or more, not {len(t)}")
    if not (np.isfinite(t).all() and np.isfinite(p).all()):
        raise ValueError("recover: times and positions must be finite")
    if not (np.diff(t) > 0.0).all():
        raise ValueError("recover: times must grow from sample to sample")
    begin = t[0] if start is None else finite("recover start", start)
    if begin > t[0]:
        raise ValueError(f"recover start, {start!r}, is after the first sample, at {t[0]!r}")
    return t - begin, p


class _Fit(NamedTuple):
    """A fit.

    x: (6,) position, velocity, slip.
    square: of the misfit, summed.
    covariance: (6, 6) of x.
    """

    x: Array
    square: float
    covariance: Array


class _Path:
    """Samples, and the model of them."""

    def __init__(self, t: Array, p: Array, slide: float, roll: float) -> None:
        self.t, self.p, self.slide, self.roll = t, p, slide, roll

    def simplest(self) -> tuple[str, _Fit]:
        """The simplest history that fits as well as any."""
        both = self.fit(self.broken(), 6)
        simple = [("rolling", self.fit(self.straight(), 4)), ("sliding", self.fit(self.bent(), 6))]
        numbers = self.p.size
        allowed = both.square * (1.0 + CLEARER / (numbers - 6)) + numbers * ROUNDING**2
        phase, fit = min(simple, key=lambda named: named[1].square)
        return (phase, fit) if fit.square <= allowed else ("both", both)

    def model(self, x: Array) -> tuple[Array, Array]:
        """Where the ball is at every sample, (n, 2), and its derivatives by x, (n, 2, 6)."""
        import numpy as np

        v, u, one = x[2:4], x[4:], np.eye(2)
        slip, against, across = _direction(u)
        speed, ahead, aside = _direction(v - u / 3.5)
        lasts = slip / (3.5 * self.slide)
        t = np.minimum(self.t, lasts)[:, None, None]
        s = np.clip(self.t - lasts, 0.0, speed / self.roll if self.roll else inf)[:, None, None]
        bend, slow = 0.5 * self.slide * t * t, 0.5 * self.roll * s * s
        place = x[:2] + (t * v - bend * against + s * (v - u / 3.5) - slow * ahead)[:, 0]
        slopes = np.zeros((len(self.t), 2, 6))
        rolled = s * one - slow * aside
        slopes[:, :, :2] = one
        slopes[:, :, 2:4] = t * one + rolled
        later = self.roll * s * np.outer(ahead, against) / (3.5 * self.slide)
        slopes[:, :, 4:] = later - bend * across - rolled / 3.5
        return place, slopes

    def fit(self, x: Array, free: int) -> _Fit:
        """Least squares by Gauss and Newton, from x, in the first `free` unknowns."""
        import numpy as np

        square, miss, slopes = self._misfit(x, free)
        for _ in range(ROUNDS):
            step = np.zeros(6)
            step[:free] = np.linalg.lstsq(slopes, miss, rcond=1e-12)[0]
            nearer = (x + step / 2**k for k in range(HALVINGS))
            trials = ((x, *self._misfit(x, free)) for x in nearer)
            better = next((trial for trial in trials if trial[1] < square), None)
            if better is None:
                break
            gained = square - better[1]
            x, square, miss, slopes = better
            if gained < SETTLED * square:
                break
        return _Fit(x, square, self._covariance(slopes, square))

    def _misfit(self, x: Array, free: int) -> tuple[float, Array, Array]:
        place, slopes = self.model(x)
        miss = (self.p - place).ravel()
        return float(miss @ miss), miss, slopes.reshape(-1, 6)[:, :free]

    def _covariance(self, slopes: Array, square: float) -> Array:
        import numpy as np

        free = slopes.shape[1]
        result = np.zeros((6, 6))
        result[:free, :free] = np.linalg.pinv(slopes.T @ slopes) * square / (len(slopes) - free)
        return result

    # -- where the fits begin ------------------------------------------------------------------

    def straight(self) -> Array:
        """It rolls: the speed of the first samples."""
        import numpy as np

        first = slice(0, max(FEWEST, len(self.t) // 4))
        rate, at = np.polyfit(self.t[first], self.p[first], 1)
        return np.concatenate((at, rate, (0.0, 0.0)))

    def bent(self) -> Array:
        """It slides, and for longer than it is seen: one parabola."""
        import numpy as np

        bend, rate, at = np.polyfit(self.t, self.p, 2)
        slip = -7.0 * self.slide * self.t[-1] * _direction(bend)[1]
        return np.concatenate((at, rate, slip))

    def broken(self) -> Array:
        """It slides and then rolls: of some ends of sliding, the one that fits best."""
        import numpy as np

        guesses = []
        for end in np.linspace(self.t[1], self.t[-1], STARTS):
            near = self.t <= max(1.5 * end, self.t[FEWEST - 1])
            t = self.t[near]
            slid = np.minimum(t, end)
            basis = np.stack((np.ones_like(t), t, slid * (t - 0.5 * slid)), axis=1)
            at, rate, bend = np.linalg.lstsq(basis, self.p[near], rcond=None)[0]
            slip = -3.5 * self.slide * end * _direction(bend)[1]
            guesses.append(np.concatenate((at, rate, slip)))
        return min(guesses, key=lambda x: self._misfit(x, 6)[0])


def _direction(vector: Array) -> tuple[float, Array, Array]:
    """Length, unit vector, and the derivative of the unit vector: zeros for a vector of zero."""
    import numpy as np

    length = sqrt(vector @ vector)
    if length == 0.0:
        return 0.0, np.zeros(2), np.zeros((2, 2))
    unit = vector / length
    return length, unit, (np.eye(2) - np.outer(unit, unit)) / length


def _recovered(phase: str, fit: _Fit, path: _Path, radius: float) -> Recovered:
    """Spin from slip: ω_x = -w_y / R and ω_y = w_x / R, where w = v - u."""
    import numpy as np

    position, velocity, slip = fit.x[:2], fit.x[2:4], fit.x[4:]
    turn = np.array([[0.0, -1.0], [1.0, 0.0]]) / radius
    change = np.eye(6)
    change[4:, 2:4], change[4:, 4:] = turn, -turn
    spin, covariance = turn @ (velocity - slip), change @ fit.covariance @ change.T
    if phase == "sliding":
        slip = 3.5 * path.slide * path.t[-1] * _direction(slip)[1]
        spin = np.full(2, nan)
        covariance[4:], covariance[:, 4:] = inf, inf
    misfit = sqrt(fit.square / path.p.size)
    return Recovered(phase, position, velocity, spin, slip, covariance, misfit)
