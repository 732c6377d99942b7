"""Safeties, and ways out of a snooker: what leaves the least of many strokes that are tried."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

from danggu.rules.state import Call

from .candidates import Style, aims
from .declaring import declared
from .levels import Attempt, Level
from .lies import lie_and_targets
from .potting import Found
from .starts import Start
from .trying import Candidate, Trials

GENTLE = Style(0.6, 3.2, 0.35, 0.1)
OPENING = Style(2.0, 4.2, 0.3, 0.0)
ESCAPE = Style(1.2, 4.0, 0.3, 1.0)
KEPT = 8  # strokes that leave the least
DRAWN = 0.6  # of the strokes are drawn at random, the others near the best
NEIGHBOURED = 3  # strokes near which others are tried
NEARBY = Level("nearby", 0.5, 0.08, 2.0)


def safeties(
    trials: Trials, froms: Sequence[Start], count: int, rng: Random, *, push: bool = False
) -> Found:
    """The best of so many strokes: first drawn at random, then near the best of those; some may
    happen to pot."""
    found: list[Candidate] = []
    for k in range(count):
        if k < DRAWN * count or not found:
            start = froms[0] if len(froms) == 1 else rng.choice(froms)
            call, aim = _drawn(trials, start, rng, push)
        else:
            best = found[k % min(NEIGHBOURED, len(found))]
            start, call, aim = best.start, best.call, NEARBY.missed(best.aim, rng, trials.radius)
        done = trials.play(start, call, aim)
        yield
        if done is None:
            continue
        made = done.verdict.made and not done.verdict.lost
        found.append(Candidate(start, call, aim, made, 0.5 * done.worth if made else done.worth))
        found.sort(key=lambda one: -one.worth)
        del found[KEPT:]
    return found


def _drawn(trials: Trials, start: Start, rng: Random, push: bool) -> tuple[Call, Attempt]:
    lie, targets = lie_and_targets(trials.world, start.match)
    seen = trials.judge.eye.hittable(start.at, lie, targets)
    name = rng.choice(seen or targets or [*lie])
    style = OPENING if start.match.opening else GENTLE if seen or push else ESCAPE
    drawn = aims(_pair(start.at), [_pair(lie[name])], trials.radius, style, rng)
    call = Call(push=True) if push else declared(start.match, name, safety=True)
    return call, next(drawn)


def _pair(at: complex) -> tuple[float, float]:
    return at.real, at.imag
