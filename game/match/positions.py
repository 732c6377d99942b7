"""Where the balls lie: opening positions on the standard spots, and a shelf to practise on.

Places are in diamonds, as players write them: (0, 0) is the south-west corner of the nose lines,
(8, 4) the north-east one, whatever the size of the table.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import hypot

Place = tuple[float, float]

HEAD, CENTRE, FOOT = (2.0, 2.0), (4.0, 2.0), (6.0, 2.0)
# The starting spots lie 182.5 mm beside the head spot of a table 1420 mm wide (UMB).
BESIDE = 4 * 0.1825 / 1.42

SAGU, THREE_CUSHION = "sagu", "three_cushion"


@dataclass(frozen=True, slots=True)
class Position:
    """Balls by name and their places in diamonds.  `key` names it in the texts."""

    key: str
    game: str
    balls: Mapping[str, Place]
    cue: str = "white"

    def on(self, length: float, width: float) -> dict[str, Place]:
        """Centres in m from the middle of a table whose nose lines enclose `length` × `width` m."""
        return {name: metres(place, length, width) for name, place in self.balls.items()}


def metres(place: Place, length: float, width: float) -> Place:
    """A place in diamonds as (x, y) in m from the middle of the table."""
    return (place[0] / 8 - 0.5) * length, (place[1] / 4 - 0.5) * width


def _sagu(key: str, white: Place, yellow: Place, red1: Place, red2: Place) -> Position:
    return Position(key, SAGU, {"white": white, "yellow": yellow, "red1": red1, "red2": red2})


def _three(key: str, white: Place, yellow: Place, red: Place) -> Position:
    return Position(key, THREE_CUSHION, {"white": white, "yellow": yellow, "red": red})


def opening(game: str, cue: str = "white") -> Position:
    """The balls before the first stroke of a match, which the ball `cue` plays.

    4-ball: the reds on head and foot spot, each cue ball beside one of them (Korean opening: one
    plays at the far red).  Games with three balls (UMB): red on the foot spot, the opponent's
    ball on the head spot, the own one beside it.
    """
    other = "white" if cue == "yellow" else "yellow"
    own = (2.0, 2.0 - BESIDE)
    if game == SAGU:
        far = (6.0, 2.0 + BESIDE)
        return Position("opening", game, {cue: own, other: far, "red1": FOOT, "red2": HEAD}, cue)
    return Position("opening", game, {cue: own, other: HEAD, "red": FOOT}, cue)


def spotted(
    lie: Mapping[str, Place],
    off: tuple[str, ...],
    cue: str,
    length: float,
    width: float,
    gap: float,
) -> dict[str, Place]:
    """`lie` (m) with the balls `off` put back (UMB): the red on the foot spot, the ball of the next
    player `cue` on the head spot, the other one on the centre spot; where a ball closer than `gap`
    m covers it, on the first free one of the three.
    """
    rest = {name: place for name, place in lie.items() if name not in off}
    for name in sorted(off):
        own = FOOT if name.startswith("red") else HEAD if name == cue else CENTRE
        for spot in (own, FOOT, HEAD, CENTRE):
            x, y = metres(spot, length, width)
            if all(hypot(x - a, y - b) >= gap for a, b in rest.values()):
                rest[name] = (x, y)
                break
    return rest


# Names of the classic shots are in the texts, under "position_" + key.
SHELF: tuple[Position, ...] = (
    _sagu("follow", (1.5, 1.2), (6.6, 3.2), (3.0, 1.5), (5.2, 1.95)),
    _sagu("draw", (3.2, 2.0), (6.4, 0.7), (4.6, 2.1), (2.1, 2.5)),
    _sagu("thin", (1.2, 2.6), (2.4, 0.8), (4.8, 2.3), (7.2, 2.9)),
    _sagu("stun", (2.5, 1.0), (1.2, 3.3), (3.7, 2.3), (5.1, 1.4)),
    _sagu("gather", (3.6, 1.0), (1.0, 1.0), (4.7, 1.5), (5.1, 2.3)),
    _sagu("rail_nurse", (3.05, 0.55), (7.0, 3.5), (3.45, 0.16), (3.95, 0.4)),
    _sagu("one_cushion", (2.0, 0.8), (4.6, 2.4), (4.2, 0.6), (6.6, 1.0)),
    _sagu("bank", (1.5, 1.5), (3.4, 1.4), (6.2, 1.2), (6.7, 0.95)),
    _sagu("screen", (1.0, 2.0), (3.0, 2.05), (5.2, 2.1), (6.6, 3.1)),
    _three("outside", (2.4, 1.0), (6.9, 0.45), (5.0, 2.6)),
    _three("inside", (2.2, 2.9), (1.2, 0.6), (4.6, 3.3)),
    _three("side", (2.0, 1.2), (1.0, 0.5), (6.0, 2.8)),
    _three("around", (3.0, 2.2), (0.5, 0.5), (4.0, 3.2)),
    _three("cross_table", (2.6, 0.8), (4.6, 3.5), (3.6, 1.6)),
    _three("double_rail", (5.4, 2.4), (7.5, 3.1), (6.7, 1.6)),
    _three("reverse", (4.4, 1.5), (1.0, 0.6), (6.4, 3.0)),
    _three("bank_three", (1.0, 1.0), (5.6, 0.7), (6.3, 0.5)),
    _three("bank_one", (2.4, 2.4), (2.0, 3.5), (5.4, 0.35)),
    _three("long", (5.6, 0.9), (7.5, 3.5), (3.4, 0.5)),
)
