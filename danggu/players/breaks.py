"""Breaks with power: at the nearest ball of a rack, from several places."""

from __future__ import annotations

from collections.abc import Sequence
from math import asin, degrees

from physics import heading

from .declaring import declared
from .levels import Attempt
from .lies import lie_and_targets
from .potting import Found
from .starts import Start
from .trying import Candidate, Trials

POWER = 10.0  # m/s: at 8.5 a break of 9-ball pots a third less often
OFFSETS = (0.0, 0.12, -0.12, 0.3, -0.3)  # diameters off the full hit
PLACES = 5  # from which it is tried


def places(froms: Sequence[Start], radius: float) -> list[Start]:
    """A few of the places along the line."""
    most = max(start.at.real for start in froms)
    line = [start for start in froms if start.at.real > most - radius]
    return line[:: max(1, len(line) // PLACES)]


def breaks(trials: Trials, froms: Sequence[Start]) -> Found:
    """Hard strokes at the nearest ball of a rack, from some places and not quite full."""
    found: list[Candidate] = []
    for start in froms:
        lie, targets = lie_and_targets(trials.world, start.match)
        at = min((lie[name] for name in targets), key=lambda place: abs(place - start.at))
        for off in OFFSETS:
            wide = trials.judge.eye.width * off / abs(at - start.at)
            aim = Attempt(heading(at - start.at) + degrees(asin(max(-1.0, min(1.0, wide)))), POWER)
            call = declared(start.match)
            done = trials.play(start, call, aim)
            yield
            if done is not None:
                found.append(Candidate(start, call, aim, True, done.worth))
    return found
