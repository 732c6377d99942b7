"""Which cloth, cushions and balls were these?  Coefficients from tracks of strokes.

Every stroke is played as the model has it, and differs from its track by what is wrong about the
coefficients and about how it began. Both are corrected by Gauss and Newton's method, with exact
derivatives. Far from the truth a track and its model soon have nothing in common any more; so each
track is only believed up to where the two part, which is ever later (docs/physics.md).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import inf, sqrt
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.engines.exact import EventDriven
from physics.shot import Shot
from physics.world import World

from . import observable
from .least_squares import information, inverse
from .model import TrackedStroke, set_coefficients
from .parameters import NUMBERS, coefficients, names, places
from .search import Guess, Search
from .tracks import Track, check

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]

START = (*NUMBERS, "positions")


class StrokeFound(NamedTuple):
    """How a stroke began, as the fit has it.

    name: of the track, for reports.
    ball: the name of the one that was struck.
    shot: how.
    start: when, s.
    positions: (balls, 2) m, of the balls before it.
    values: by name, all that was unknown about this stroke alone.
    errors: their standard deviations, by name; inf where the track does not show them.
    residuals: (T, balls, 2) m, seen less expected, NaN where nothing was seen or the track is no
    longer believed.
    misfit: rms of a coordinate, m.
    share: of the track, up to where the model leaves it.
    """

    name: str
    ball: str
    shot: Shot
    start: float
    positions: Array
    values: dict[str, float]
    errors: dict[str, float]
    residuals: Array
    misfit: float
    share: float

    def __repr__(self) -> str:
        return f"<StrokeFound: {self.shot!r} at {self.ball}, {1e3 * self.misfit:.3g} mm>"


class Fit(NamedTuple):
    """What `fit` returns.

    world: as given, with the coefficients that were found.
    names: of those.
    values: (n,).
    covariance: (n, n), from the noise as it was stated, or as it is if that is more.
    strokes: one for each track.
    misfit: rms of a coordinate over all tracks, m.
    noise: that the covariance is for, m.
    """

    world: World
    names: tuple[str, ...]
    values: Array
    covariance: Array
    strokes: tuple[StrokeFound, ...]
    misfit: float
    noise: float

    @property
    def table(self) -> Any:
        """The world's `tables.Table` with what was found, which `tables.save` writes; or None."""
        return self.world.table

    @property
    def errors(self) -> Array:
        """(n,): standard deviations of the values."""
        import numpy as np

        deviations: Array = np.sqrt(np.diag(self.covariance))
        return deviations

    def __repr__(self) -> str:
        found = zip(self.names, self.values, self.errors, strict=True)
        values = ", ".join(f"{name} {value:.4g} ± {error:.2g}" for name, value, error in found)
        return f"<Fit of {len(self.strokes)} strokes, {1e3 * self.misfit:.3g} mm: {values}>"


def fit(
    world: World,
    tracks: Sequence[Track],
    unknown: Iterable[str],
    share: Iterable[str] | None = None,
    start: Iterable[str] = START,
) -> Fit:
    """The coefficients with which this world's balls run along those tracks.

    unknown: names as `sensitivity` has them, such as "cloth.slide", "cushion.e" or "ball.mu"; the
    world has the values to begin with, and all that is known. With none, only the strokes are
    fitted: so a fit is tested on others.
    share: those that are the same in all tracks, all of them by default; the others are found for
    each track.
    start: what is unknown about the beginning of every stroke; also when it was, if its first
    samples show the ball at rest.

    The world must have the balls of the tracks; where they lie does not matter. Misses beyond four
    noises count less. See docs/physics.md, "Fitting a table".

    ValueError for tracks that cannot be of this world (units, names, places) or are too few, and
    for an unknown that they do not show, with the reason.
    """
    if not isinstance(world.engine, EventDriven):
        raise ValueError(f"fit needs the engine EventDriven, not {world.engine!r}")
    unknown, start = names(world, unknown), names(world, start)
    shared = unknown if share is None else names(world, share)
    _check_names(world, unknown, shared, start)
    if not tracks:
        raise ValueError("fit needs at least one track")
    own = [name for name in unknown if name not in shared]
    strokes = [
        _stroke_of(track, k, world, shared, [*own, *start]) for k, track in enumerate(tracks)
    ]
    observable.enough(strokes, shared)
    search = Search(world, strokes, shared)
    rough = search.run()
    observable.insist(search, rough)  # first, because what is not seen runs away
    return _found(search, search.polish(rough))


def _stroke_of(
    track: Track, k: int, world: World, shared: Sequence[str], own: Sequence[str]
) -> TrackedStroke:
    """The k-th track with its unknowns; ValueError if it cannot be one of this world."""
    name = f"track {track.name or k}"
    check(track, world, name)
    return TrackedStroke(track, world, shared, own, name)


def _check_names(world: World, unknown: Any, shared: Any, start: Any) -> None:
    known = coefficients(world)
    for name in unknown:
        if name not in known:
            raise ValueError(f"unknown {name!r} is no coefficient: there are {', '.join(known)}")
    for name in shared:
        if name not in unknown:
            raise ValueError(f"share: {name!r} is none of the unknown {', '.join(unknown)}")
    for name in start:
        if name in known:
            raise ValueError(f"start: {name!r} is a coefficient: name it in `unknown`")


def _found(search: Search, guess: Guess) -> Fit:
    """What there is to tell of the best guess."""
    import numpy as np

    observable.insist(search, guess)
    noise = search.noise
    blocks = search.blocks(guess, noise, search.bend)
    whole, _ = information(blocks)
    world = search.world.copy()
    set_coefficients(world, dict(zip(search.names, guess.shared, strict=True)))
    covariance = inverse(whole)
    strokes = tuple(
        _stroke(search, guess, k, blocks[k], covariance) for k in range(len(search.strokes))
    )
    every = np.concatenate([stroke.residuals.ravel() for stroke in strokes])
    return Fit(
        world, search.names, guess.shared, covariance, strokes, _rms(every), _rms(np.array(noise))
    )


def _stroke(search: Search, guess: Guess, k: int, part: Any, covariance: Any) -> StrokeFound:
    import numpy as np

    stroke, values = search.strokes[k], search.values(guess, k)
    alone = inverse(part.own)
    lever = alone @ part.mixed.T
    wide = np.diag(alone) + np.einsum("ij,jk,ik->i", lever, covariance, lever)
    errors = np.where(np.diag(part.own) > 0.0, np.sqrt(wide), inf)
    miss = search.misses(guess, k, guess.believed[k])
    residuals = np.stack((miss.real, miss.imag), axis=-1)
    spots = np.array([values[name] for name in places(search.world)]).reshape(-1, 2)
    return StrokeFound(
        stroke.name, stroke.struck, Shot(*(values[number] for number in NUMBERS)), values["start"],
        spots, dict(zip(stroke.own, map(float, guess.own[k]), strict=True)),
        dict(zip(stroke.own, map(float, errors), strict=True)), residuals, _rms(residuals),
        search.share(guess, k),
    )  # fmt: skip


def _rms(numbers: Any) -> float:
    import numpy as np

    return sqrt(np.nanmean(numbers * numbers)) if np.isfinite(numbers).any() else inf
