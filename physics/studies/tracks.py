"""Tracks: where a camera has seen the balls of one stroke, and whether they can be that."""

from __future__ import annotations

import csv
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import nan
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.checks import array, positive
from physics.wall import Obstacle
from physics.world import World

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]

__all__ = ["Track", "balls", "filmed", "read", "write"]

SLOWEST = 20.0  # frames a second
FASTEST = 20.0  # m/s: no ball is faster
OUTSIDE = 0.01  # m: how far a ball may be seen inside a cushion that gives way
OVERLAP = 0.8  # of the distance of two balls that touch: nearer than this they are not seen
MOVED = 6.0  # noises: what is farther from where it lay has moved
LEAST_MOVED = 2e-3  # m
RETURNS = 0.8  # of the speed into a cushion
AT_ONCE = 4.0  # frames: what happens within them hides how a ball set out


@dataclass(frozen=True, eq=False)
class Track:
    """One stroke as it was seen, from before it or from any moment on until whenever.

    times: (T,) s, growing.
    positions: (T, balls, 2) m, in the order of the world's balls, NaN where one was not seen.
    noise: standard deviation of a coordinate, m.
    ball: the name of the one that was struck; None: that which moves first.
    name: for reports.
    ValueError for shapes or numbers that cannot be.
    """

    times: Array
    positions: Array
    noise: float = 5e-4
    ball: str | None = None
    name: str = ""

    def __repr__(self) -> str:
        times, balls, _ = self.positions.shape
        return f"<Track {self.name!r} of {balls} balls at {times} moments>"

    def __post_init__(self) -> None:
        import numpy as np

        times, places = array("Track.times", self.times), array("Track.positions", self.positions)
        if times.ndim != 1 or places.ndim != 3 or places.shape[::2] != (len(times), 2):
            raise ValueError(
                "Track: times (T,) and positions (T, balls, 2), not"
                f" {times.shape} and {places.shape}"
            )
        if not np.isfinite(times).all() or not (np.diff(times) > 0.0).all():
            raise ValueError("Track.times must be finite and grow from sample to sample")
        if np.isinf(places).any():
            raise ValueError("Track.positions must be finite, or NaN where a ball was not seen")
        object.__setattr__(self, "times", times)
        object.__setattr__(self, "positions", np.where(np.isnan(places).any(axis=2, keepdims=True),
                                                       nan, places))  # fmt: skip
        object.__setattr__(self, "noise", positive("Track.noise", self.noise))

    def seen(self, ball: int) -> tuple[Array, Array]:
        """(n,) times and (n,) complex places at which that ball was seen."""
        import numpy as np

        x, y = self.positions[:, ball].T
        there = np.isfinite(x)
        return self.times[there], (x + 1j * y)[there]

    def moves(self, ball: int) -> int:
        """How many of the samples in which it was seen come before it has moved."""
        import numpy as np

        _, spots = self.seen(ball)
        far = np.abs(spots - spots[:1]) > max(MOVED * self.noise, LEAST_MOVED)
        gone = far & np.append(far[1:], True)  # not for a single sample
        return int(np.argmax(gone)) if gone.any() else len(spots)


class Beginning(NamedTuple):
    """How a stroke began, as far as its first samples show.

    struck: number of the ball.
    start: s.
    free: is the moment unknown?  If the ball moves from the first sample on, it begins there.
    spots: (balls,) complex, m.
    velocities: of the struck one, as it is seen to run, and as it must have been if it met a
    cushion or a ball near by at once.
    """

    struck: int
    start: float
    free: bool
    spots: Any
    velocities: tuple[complex, ...]


def check(track: Track, world: World, name: str) -> None:
    """ValueError that says what is wrong with a track of this world, if it cannot be one."""
    balls = [ball.name for ball in world.balls]
    if track.positions.shape[1] != len(balls):
        raise ValueError(f"{name} is of {track.positions.shape[1]} balls, the world has {balls}")
    if track.ball is not None and track.ball not in balls:
        raise ValueError(f"{name}: there is no ball {track.ball!r} in this world")
    for k, ball in enumerate(balls):
        if not len(track.seen(k)[0]):
            raise ValueError(f"{name}: ball {ball!r} is never seen")
    rate = (len(track.times) - 1) / max(track.times[-1] - track.times[0], 1e-9)
    if len(track.times) > 1 and rate < SLOWEST:
        raise ValueError(f"{name} has {rate:.3g} samples a second: too few, or not in seconds?")
    for wrong in (*_outside(track, world), *_swapped(track, world), *_overlapping(track, world)):
        raise ValueError(f"{name}: {wrong}")


def _outside(track: Track, world: World) -> Iterator[str]:
    """Balls beyond the cushions, or a cloth on which nothing is as large as it should be."""
    import numpy as np

    for k, ball in enumerate(world.balls):
        times, spots = track.seen(k)
        for wall in _pushing(world):
            gap = np.array([wall.distance((p.real, p.imag)) for p in spots]) - ball.radius
            if len(at := _in_a_row(gap < -OUTSIDE)):
                at = at[np.argmin(gap[at])]
                yield (
                    f"at {times[at]:.3f} s ball {ball.name!r} is {-gap[at]:.3g} m inside the"
                    f" cushion {wall.name!r}: wrong scale or origin? Places are metres from the"
                    " middle of the world"
                )


def _pushing(world: World) -> list[Obstacle]:
    """All but pockets, in which balls may well be seen."""
    return [wall for wall in world.walls if wall.pushes]


def _in_a_row(wrong: Any) -> Any:
    """The samples that are wrong, but for single ones, which are a camera's mistakes."""
    import numpy as np

    wrong = np.asarray(wrong)
    padded = np.concatenate(([False, False], wrong, [False, False]))
    both = padded[:-1] & padded[1:]
    three = both[:-1] & both[1:]
    return np.flatnonzero(three[:-2] | three[1:-1] | three[2:])


def _overlapping(track: Track, world: World) -> Iterator[str]:
    import numpy as np

    spots = track.positions[..., 0] + 1j * track.positions[..., 1]
    for i, one in enumerate(world.balls):
        for j, other in enumerate(world.balls[:i]):
            far = np.abs(spots[:, i] - spots[:, j])
            least = one.touching_distance(other)
            if len(at := _in_a_row(far < OVERLAP * least)):
                at = at[np.argmin(far[at])]
                yield (
                    f"at {track.times[at]:.3f} s balls {other.name!r} and {one.name!r} are"
                    f" {far[at]:.3g} m apart, but touch at {least:.3g} m: wrong scale?"
                )


def _swapped(track: Track, world: World) -> Iterator[str]:
    """Two balls that jump to where the other one was; and one that was struck but moves later."""
    import numpy as np

    names = [ball.name for ball in world.balls]
    spots = track.positions[..., 0] + 1j * track.positions[..., 1]
    step = np.diff(track.times)
    for i in range(len(names)):
        for j in range(i):
            straight = np.abs(np.diff(spots[:, i])) + np.abs(np.diff(spots[:, j]))
            crossed = np.abs(spots[1:, i] - spots[:-1, j]) + np.abs(spots[1:, j] - spots[:-1, i])
            jump = (straight > 4.0 * crossed) & (straight > 2.0 * FASTEST * step)
            for at in np.flatnonzero(jump):
                yield (
                    f"balls {names[j]!r} and {names[i]!r} change places at"
                    f" {track.times[at + 1]:.3f} s: swapped?"
                )
    began = [when_moved(track, k) for k in range(len(names))]
    first = int(np.argmin(began))
    if track.ball is not None and began[first] < began[names.index(track.ball)] - 2.0 * step.max():
        yield f"{track.ball!r} is said to be struck, but {names[first]!r} moves first: swapped?"


def when_moved(track: Track, ball: int) -> float:
    times, _ = track.seen(ball)
    k = track.moves(ball)
    return float(times[k]) if k < len(times) else float("inf")


def beginning(track: Track, world: World, name: str) -> Beginning:
    """What the first samples show; ValueError if nothing moves."""
    import numpy as np

    names = [ball.name for ball in world.balls]
    began = [when_moved(track, k) for k in range(len(names))]
    struck = int(np.argmin(began)) if track.ball is None else names.index(track.ball)
    if not np.isfinite(began[struck]):
        raise ValueError(f"{name}: ball {names[struck]!r} does not move")
    lay = [max(1, track.moves(k)) for k in range(len(names))]
    spots = np.array([track.seen(k)[1][: lay[k]].mean() for k in range(len(names))])
    times, seen = track.seen(struck)
    free, first = lay[struck] > 1, lay[struck] if lay[struck] > 1 else 0
    velocity, spot = _away(times[first:] - times[first], seen[first:])
    if not free:
        spots[struck] = seen[0]
        return Beginning(struck, float(times[0]), False, spots, (velocity,))
    wait = abs(spot - spots[struck]) / max(abs(velocity), 1e-3)
    start = max(times[first] - wait, times[first - 1] - (times[first] - times[first - 1]))
    frame = times[first] - times[first - 1]
    velocities = [velocity, *_before(world, struck, spots[struck], velocity, AT_ONCE * frame)]
    for k, moved in enumerate(began):
        if k != struck and moved <= began[struck] + AT_ONCE * frame:
            seen_at, there = (row[lay[k] :] for row in track.seen(k))
            if len(there) > 1:
                passed, _ = _away(seen_at - seen_at[0], there)
                velocities += _to_ball(world, struck, k, spots, velocity, passed)
    return Beginning(struck, float(start), True, spots, tuple(velocities))


def _to_ball(
    world: World, struck: int, other: int, spots: Any, velocity: complex, passed: complex
) -> list[complex]:
    """The velocity with which it met another ball, which has got that: by momentum, and aimed at
    where it must have been when they touched."""
    one, two = world.balls[struck], world.balls[other]
    whole = velocity + two.mass / one.mass * passed
    line = passed / max(abs(passed), 1e-12)
    aim = spots[other] - one.touching_distance(two) * line - spots[struck]
    return [abs(whole) * aim / abs(aim), whole] if abs(aim) > 0.0 else [whole]


def _before(
    world: World, struck: int, spot: complex, velocity: complex, seconds: float
) -> Iterator[complex]:
    """The velocities with which it would have met a cushion within those seconds."""
    for wall in _pushing(world):
        normal = wall.facing((spot.real, spot.imag))
        gap = wall.distance((spot.real, spot.imag)) - world.balls[struck].radius
        away = (normal.conjugate() * velocity).real
        if away > 0.0 and gap < seconds * abs(velocity):
            yield velocity - (1.0 + 1.0 / RETURNS) * away * normal


def _away(times: Array, spots: Array) -> tuple[complex, complex]:
    """Velocity and place in the first of these samples, before the path turns."""
    import numpy as np

    count = max(3, int(np.searchsorted(times, 0.1)))
    steps = np.diff(spots[: count + 1])
    straight = (steps * np.conj(steps[:1])).real > 0.9 * np.abs(steps) * np.abs(steps[:1])
    count = max(2, 1 + (int(np.argmin(straight)) if not straight.all() else len(steps)))
    if len(spots) < 2:
        raise ValueError("a ball that moves is seen only once")
    t = times[:count]
    rate, at = np.polyfit(t, spots[:count], 1)
    return complex(rate), complex(at)


def balls(path: str | os.PathLike[str]) -> list[str]:
    """The names of the balls in such a file, in its order; ValueError if there are none."""
    with Path(path).open(newline="", encoding="utf-8-sig") as file:
        head = next(csv.reader(file), [])
    found = [cell.strip()[:-2] for cell in head if cell.strip().endswith(" x")]
    if not found:
        raise ValueError(f"{os.fspath(path)}: no columns such as 'white x': {', '.join(head):.80}")
    return found


def read(path: str | os.PathLike[str], world: World, noise: float = 5e-4) -> list[Track]:
    """Tracks from a file of comma-separated values, as `python -m physics scene --csv` writes one.

    A line of names: "time", "white x", "white y", … for the world's balls, and "track" if there is
    more than one stroke, which then has a name for each. A cell without a number: not seen.
    ValueError says what is wrong, and in which line; OSError where there is no such file.
    """
    with Path(path).open(newline="", encoding="utf-8-sig") as file:
        rows = [row for row in csv.reader(file) if row]
    wanted = ["time", *(f"{ball.name} {axis}" for ball in world.balls for axis in "xy")]
    head = [cell.strip() for cell in rows[0]] if rows else []
    missing = [name for name in wanted if name not in head]
    if missing:
        raise ValueError(f"{os.fspath(path)}: no column {', '.join(map(repr, missing))}")
    columns = [head.index(name) for name in wanted]
    strokes: dict[str, list[list[float]]] = {}
    for line, row in enumerate(rows[1:], 2):
        stroke = row[head.index("track")].strip() if "track" in head and len(row) > 0 else ""
        numbers = [_number(row, k, f"{os.fspath(path)}: line {line}") for k in columns]
        strokes.setdefault(stroke, []).append(numbers)
    return [_track(name, numbers, noise) for name, numbers in strokes.items()]


def _number(row: Sequence[str], column: int, where: str) -> float:
    text = row[column].strip() if column < len(row) else ""
    try:
        return float(text or "nan")
    except ValueError:
        raise ValueError(f"{where}: {text!r} is no number") from None


def _track(name: str, numbers: list[list[float]], noise: float) -> Track:
    import numpy as np

    table = np.array(numbers)
    try:
        return Track(table[:, 0], table[:, 1:].reshape(len(table), -1, 2), noise, name=name)
    except ValueError as error:
        raise ValueError(f"track {name!r}: {error}") from None


def write(tracks: Sequence[Track], path: str | os.PathLike[str], names: Sequence[str]) -> None:
    """The file that `read` reads; names: of the balls."""
    with Path(path).open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(["track", "time", *(f"{name} {axis}" for name in names for axis in "xy")])
        for k, track in enumerate(tracks):
            for time, spots in zip(track.times, track.positions, strict=True):
                cells = ["" if spot != spot else float(spot) for spot in spots.flat]
                rows.writerow([track.name or k, float(time), *cells])


def filmed(
    world: World, ball: str, shot: Any, chance: np.random.Generator, *,
    rate: float = 50.0, noise: float = 5e-4, before: float = 0.2, lost: float = 0.0,
    until: float | None = None,
) -> Track:  # fmt: skip
    """The track that a camera would have of a shot in this world, to try what a fit can find.

    chance: where noise, gaps (a share `lost` of all samples) and the phase of the frames come from.
    rate: frames a second.
    noise: m.
    before, until: seconds before and after the stroke.
    """
    import numpy as np

    from physics.simulation import simulate

    from .paths import places

    after = simulate(world, ball, shot)
    ends = after.time - after.epoch if until is None else until
    times = np.arange(-before + chance.uniform(0.0, 1.0 / rate), ends, 1.0 / rate)
    spots = places(after, times)
    seen = np.stack((spots.real, spots.imag), axis=-1)
    seen += chance.normal(0.0, noise, seen.shape)
    seen[chance.random(seen.shape[:2]) < lost] = nan
    return Track(times + 10.0, seen, noise)


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]
