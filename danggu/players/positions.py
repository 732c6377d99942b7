"""Where the balls lie: opening positions on the standard spots, and a shelf to practise on.

Places are in diamonds, as players write them: (0, 0) is the south-west corner of the nose lines,
(8, 4) the north-east one, on a table of any size.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import hypot

Place = tuple[float, float]
Answer = tuple[float, float, float, float]

HEAD, CENTRE, FOOT = (2.0, 2.0), (4.0, 2.0), (6.0, 2.0)
# The starting spots lie 182.5 mm beside the head spot of a table 1420 mm wide (UMB).
BESIDE = 4 * 0.1825 / 1.42

SAGU, THREE_CUSHION = "sagu", "three_cushion"


@dataclass(frozen=True, slots=True)
class Position:
    """How the balls lie.

    key: in the texts.
    game: in which it occurs.
    balls: by name, their places in diamonds.
    cue: the name of the cue ball.
    way: what the cue ball meets when it is played as the name says.
    answer: a stroke that goes this way on the game's own table (medium for 4-ball, match for
    three-cushion): direction in degrees, speed in m/s, tip right and up in radii of the ball;
    `tools/shelf_answers.py` finds it, the tests play it.
    """

    key: str
    game: str
    balls: Mapping[str, Place]
    way: tuple[str, ...]
    answer: Answer
    cue: str = "white"

    def on(self, length: float, width: float) -> dict[str, Place]:
        """Centres in m from the middle of a table that is `length` by `width` m between noses."""
        return {name: metres(place, length, width) for name, place in self.balls.items()}


def metres(place: Place, length: float, width: float) -> Place:
    """A place in diamonds as (x, y) in m from the middle of the table."""
    return (place[0] / 8 - 0.5) * length, (place[1] / 4 - 0.5) * width


def opening(game: str, cue: str = "white") -> Position:
    """The balls before the first stroke of a match, which the ball `cue` plays.

    4-ball: the reds on head and foot spot, each cue ball beside one of them (Korean opening: one
    plays at the far red).  Games with three balls (UMB): red on the foot spot, the opponent's
    ball on the head spot, the own one beside it.
    """
    other = "white" if cue == "yellow" else "yellow"
    own = (2.0, 2.0 - BESIDE)
    if game == SAGU:
        balls = {cue: own, other: (6.0, 2.0 + BESIDE), "red1": FOOT, "red2": HEAD}
        sagu_way = ("red1", "east", "south", "red2")
        return Position("opening", game, balls, sagu_way, (5.71, 2.17, -0.01, 0.34), cue)
    way = ("red", "north", "east", "south", other)
    balls = {cue: own, other: HEAD, "red": FOOT}
    return Position("opening", game, balls, way, (8.68, 5.43, 0.43, 0.13), cue)


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


def _sagu(key: str, way: str, answer: Answer, *places: Place) -> Position:
    balls = dict(zip(("white", "yellow", "red1", "red2"), places, strict=True))
    return Position(key, SAGU, balls, tuple(way.split()), answer)


def _three(key: str, way: str, answer: Answer, *places: Place) -> Position:
    balls = dict(zip(("white", "yellow", "red"), places, strict=True))
    return Position(key, THREE_CUSHION, balls, tuple(way.split()), answer)


# fmt: off
SHELF: tuple[Position, ...] = (
    _sagu("follow", "red1 red2", (3.22, 1.53, -0.15, 0.29),
           (1.8, 1.5), (6.6, 3.2), (3.0, 1.6), (4.6, 1.8)),
    _sagu("draw", "red1 red2", (4.66, 2.5, 0.06, -0.44),
           (3.5, 2.0), (6.4, 0.7), (4.4, 2.05), (2.6, 2.6)),
    _sagu("stun", "red1 red2", (38.58, 3.42, -0.31, -0.01),
           (2.5, 1.0), (1.2, 3.3), (3.7, 2.1), (4.5, 1.6)),
    _sagu("gather", "red1 red2", (31.88, 0.83, 0.03, 0.16),
           (3.6, 1.0), (1.0, 1.0), (4.7, 1.5), (5.1, 2.3)),
    _sagu("rail_nurse", "red1 red2", (-28.03, 0.83, 0.03, 0.16),
           (3.05, 0.55), (7.0, 3.5), (3.45, 0.16), (3.95, 0.4)),
    _sagu("one_cushion", "red1 south red2", (-9.18, 1.68, -0.25, 0.01),
           (2.0, 0.8), (4.6, 2.4), (4.2, 0.6), (6.6, 1.0)),
    _sagu("two_cushions", "red1 north east red2", (-3.01, 3.63, 0.23, 0.32),
           (1.2, 2.6), (2.4, 0.8), (4.8, 2.3), (7.2, 2.9)),
    _sagu("bank", "south red1 red2", (-32.61, 1.77, 0.38, 0.26),
           (1.5, 1.5), (3.4, 1.4), (6.2, 1.2), (6.7, 0.95)),
    _sagu("thin", "red1 red2", (7.73, 2.17, -0.32, 0.29),
           (2.0, 1.0), (1.0, 3.4), (4.0, 1.3), (6.2, 0.9)),
    _sagu("two_rails_first", "south east red1 red2", (-29.07, 1.78, 0.02, 0.43),
           (4.0, 1.0), (1.2, 3.2), (6.3, 1.7), (5.6, 3.1)),
    _sagu("cross", "red1 north south red2", (54.53, 1.02, -0.05, 0.37),
           (3.0, 1.2), (7.0, 0.5), (4.2, 2.6), (5.4, 1.0)),
    _three("outside", "red north east south yellow", (33.5, 3.17, 0.25, 0.37),
            (2.4, 1.0), (6.9, 0.45), (5.0, 2.6)),
    _three("inside", "red east south west yellow", (6.91, 2.94, -0.24, 0.35),
            (2.2, 2.9), (1.2, 0.6), (4.6, 3.3)),
    _three("around", "red north east south west yellow", (37.21, 2.26, 0.38, 0.2),
            (3.0, 2.0), (0.3, 1.6), (4.2, 3.1)),
    _three("cross_table", "red north south north yellow", (74.44, 4.72, 0.25, -0.32),
            (3.4, 1.2), (4.8, 0.3), (3.9, 2.4)),
    _three("reverse", "red east north west yellow", (34.27, 2.08, -0.35, 0.15),
            (4.4, 1.5), (1.0, 0.6), (6.4, 3.0)),
    _three("bank_one", "north red north east yellow", (33.42, 3.02, 0.26, 0.24),
            (2.5, 2.0), (2.6, 0.5), (5.5, 3.7)),
    _three("bank_three", "east north south yellow red", (57.08, 2.56, -0.25, 0.08),
            (6.5, 0.6), (2.2, 1.3), (1.7, 1.15)),
    _three("back_round", "red south west north yellow", (-51.17, 3.49, 0.35, 0.13),
            (2.0, 3.2), (4.2, 0.5), (2.9, 2.2)),
    _three("long_round", "red south east north south yellow", (-47.39, 2.97, -0.42, 0.17),
            (5.5, 3.0), (2.0, 0.6), (6.9, 1.6)),
    _three("corner_round", "red south east north yellow", (-92.72, 2.35, -0.39, 0.15),
            (6.5, 3.4), (4.0, 2.8), (6.3, 1.2)),
    _three("short_rail", "red west south north yellow", (-109.72, 4.89, -0.35, 0.26),
            (2.0, 3.4), (6.6, 3.2), (1.5, 1.8)),
)
# fmt: on
