"""What tracks cannot show is refused, with the reason."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from typing import TYPE_CHECKING, Any

from .least_squares import information
from .model import TrackedStroke, step_of

if TYPE_CHECKING:
    from .search import Guess, Search

UNSHOWN = 3.0  # steps that an unknown may take: an error beyond them means that nothing is known
JOINT = 0.05  # of a direction in which nothing is known: what has less to do with it is not named
WHY = {  # what has to happen for a coefficient to show
    "cloth.slide": "a ball that slides",
    "cloth.roll": "a ball that rolls for some time",
    "cloth.spin_decay": "a ball with side that meets a cushion or another ball",
    "cloth.gravity": "a ball that slides or rolls",
    "cushion": "a ball that meets a cushion",
    "ball": "two balls that meet",
}


def enough(strokes: Sequence[TrackedStroke], shared: Sequence[str]) -> None:
    """ValueError if there are fewer numbers than unknowns."""
    numbers, unknown = 0, len(shared)
    for stroke in strokes:
        numbers += 2 * stroke.size
        unknown += len(stroke.own)
    if numbers < unknown:
        raise ValueError(
            f"{numbers} numbers in {len(strokes)} tracks are too few for {unknown} unknown: give"
            " more or longer tracks, or fewer unknown"
        )


def insist(search: Search, guess: Guess) -> None:
    """ValueError if the tracks do not show one of the shared unknowns."""
    import numpy as np

    if not search.names:
        return
    noise = [stroke.track.noise for stroke in search.strokes]
    whole, alone = information(search.blocks(guess, noise, [inf] * len(noise)))
    limit = np.array([UNSHOWN * step_of(name) for name in search.names])
    # an unknown of which nothing is known has less than 1 here
    sizes, directions = np.linalg.eigh(whole * np.outer(limit, limit))
    if sizes[0] < 1.0:
        raise ValueError(_why(search.names, np.abs(directions[:, 0]), alone * limit * limit))


def _why(names: Sequence[str], direction: Any, alone: Any) -> str:
    """direction: that nothing is known of.  alone: what would be known if all else were."""
    import numpy as np

    worst = int(np.argmax(direction))
    name = names[worst]
    if alone[worst] < 1.0:
        need = WHY.get(name) or WHY[name.partition(".")[0]]
        return f"the tracks do not show {name!r}: that takes {need}"
    others = [names[k] for k in np.argsort(-direction) if k != worst and direction[k] > JOINT]
    if others:
        return (
            f"the tracks do not tell {name!r} from {', '.join(map(repr, others))}: what is seen"
            " depends on them together; leave one of them as it is"
        )
    return (
        f"the tracks do not tell {name!r} from how the strokes began, which is unknown too: that"
        " takes more tracks, or longer ones"
    )
