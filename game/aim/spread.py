"""The spread of a shot: where it goes if angle, speed and tip are a little off, as they will be."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random
from typing import NamedTuple

from danggu.rules.stroke import counts
from physics import Log, Shot, World, simulate

from .preview import Place, foretold, path
from .tip import LEVER

ANGLE, SPEED, TIP = 0.05, 0.02, 0.01
"""Standard errors of the angle, degrees, of the speed, a share, and of the tip, ball radii: those
of a good amateur."""
SAMPLES = 40
MOST_CUSHIONS = 6
"""Cushions after which a path is drawn no farther: by then the haze is everywhere."""


Scores = Callable[[Log], bool]
"""Does the stroke in a log score, by the rules that are played by?"""


class Sample(NamedTuple):
    """One way it may go: the cue ball's path until it differs in kind, and whether it scored."""

    way: tuple[Place, ...]
    made: bool | None


def off(shot: Shot, rng: Random) -> Shot:
    """The shot as it may come out."""
    lever = LEVER * TIP * shot.speed
    share = max(0.1, rng.gauss(1.0, SPEED))
    return Shot(
        speed=shot.speed * share,
        angle=rng.gauss(shot.angle, ANGLE),
        follow=rng.gauss(shot.follow, lever),
        masse=shot.masse,
        side=rng.gauss(shot.side, lever),
        climb=shot.climb * share,
    )


def plan(log: Log, cue: str) -> list[tuple[str, str]]:
    """What the cue ball meets, one after the other: kind, and name of the ball or the wall."""
    met: list[tuple[str, str]] = []
    for contact in log.brief():
        if cue in contact.balls and counts(contact):
            other = [name for name in contact.balls if name != cue]
            met.append((contact.kind, str(contact.wall) if not other else other[0]))
    return met


def nominal(world: World, cue: str, shot: Shot) -> list[tuple[str, str]]:
    """What the cue ball meets if nothing is off."""
    return plan(simulate(world, cue, shot).log, cue)


def sample(
    world: World,
    cue: str,
    shot: Shot,
    wanted: Sequence[tuple[str, str]],
    rng: Random,
    scores: Scores | None = None,
) -> Sample:
    """Play the shot once more, a little off."""
    after = foretold(world, cue, off(shot, rng))
    if after is None:
        return Sample((), None)
    until = _parting(after, cue, wanted)
    made = None if scores is None else scores(after.log)
    return Sample(path(after.log, cue, world.time, until), made)


def _parting(after: World, cue: str, wanted: Sequence[tuple[str, str]]) -> float:
    """When the path meets something else than planned, or need not be followed any more."""
    own = [met for met in after.log.brief() if cue in met.balls and counts(met)]
    cushions, balls = 0, set()
    for contact, met, planned in zip(own, plan(after.log, cue), wanted, strict=False):
        cushions += met[0] == "cushion"
        balls |= {met[1]} if met[0] == "ball" else set()
        if met != planned or cushions == MOST_CUSHIONS or len(balls) == 2:
            return contact.time
    if len(own) > len(wanted):
        return own[len(wanted)].time
    return after.time


class Spread:
    """Samples of the shot in the boxes, taken a few a frame once the aim is still."""

    def __init__(self) -> None:
        self._key: object = None
        self._wanted: list[tuple[str, str]] = []
        self._rng = Random(0)
        self.still = 0.0
        """Seconds for which the aim has not changed."""
        self.samples: list[Sample] = []

    def clear(self) -> bool:
        """Forget everything; returns whether there was anything."""
        some = bool(self.samples)
        self._key, self.still, self.samples = None, 0.0, []
        return some

    def follow(self, key: object, seconds: float) -> bool:
        """Note the aim, by what it depends on, and how long it has been so.

        Returns whether samples have been dropped.
        """
        if key == self._key:
            self.still += seconds
            return False
        some = self.clear()
        self._key = key
        return some

    def take(
        self, world: World, cue: str, shot: Shot, count: int, scores: Scores | None = None
    ) -> None:
        """Play some more samples."""
        if not self.samples:
            self._rng = Random(0)
            self._wanted = nominal(world, cue, shot)
        for _ in range(min(count, SAMPLES - len(self.samples))):
            self.samples.append(sample(world, cue, shot, self._wanted, self._rng, scores))

    @property
    def done(self) -> bool:
        """Have all samples been taken?"""
        return len(self.samples) >= SAMPLES

    @property
    def share(self) -> float | None:
        """The part of the samples that score; None before all are there, or without a match."""
        if not self.done or self.samples[0].made is None:
            return None
        return sum(bool(one.made) for one in self.samples) / len(self.samples)
