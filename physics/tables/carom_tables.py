"""The carom tables, and cloths in their conditions (sources in docs/accuracy.md)."""

from dataclasses import replace

from physics import laws
from physics.cloth import Cloth
from physics.world import World

from .table import Table

# Measured on tracked three-cushion shots, but for spin_decay, which was then a usual value.
MEASURED = Cloth(slide=0.212, roll=0.0045, spin_decay=10.0, gravity=9.81)
MEASURED_2 = replace(MEASURED, spin_decay=4.3)  # measured too, since
USUAL = Cloth(slide=0.2, roll=0.01, spin_decay=10.0, gravity=9.81)  # of the published ranges

# Only "measured" is a measurement; where the others are from, and how unsure: docs/accuracy.md,
# "Cloths". In edition 2 each is in all three coefficients beyond the one before: a cloth in worse
# condition grips more, is slower, and takes side sooner. Edition 1 had them by the published ranges
# alone, so that side lasted shorter on the cloth of the measured table than on a new one.
CLOTH_EDITIONS: dict[int, dict[str, Cloth]] = {
    1: {
        "new": Cloth(slide=0.15, roll=0.004, spin_decay=5.0, gravity=9.81),
        "measured": MEASURED,
        "worn": USUAL,
        "humid": Cloth(slide=0.4, roll=0.015, spin_decay=15.0, gravity=9.81),
    },
    2: {
        "new": Cloth(slide=0.15, roll=0.004, spin_decay=3.0, gravity=9.81),
        "measured": MEASURED_2,
        "hall": Cloth(slide=0.22, roll=0.007, spin_decay=6.5, gravity=9.81),
        "worn": Cloth(slide=0.25, roll=0.01, spin_decay=10.0, gravity=9.81),
        "humid": Cloth(slide=0.4, roll=0.015, spin_decay=15.0, gravity=9.81),
    },
}
CLOTHS = CLOTH_EDITIONS[2]
"""From the cloth on which a ball runs farthest to the slowest."""

THESIS = Table(
    2.448, 1.270, 0.03275, 0.25, Cloth(), laws.ThesisBall(), laws.ThesisCushion(), "thesis"
)
MEDIUM_CAROM = Table(
    2.54, 1.27, 0.03275, 0.25, MEASURED, laws.RoughBall(), laws.RigidCushion(nose=0.039 / 0.03275),
    "medium carom",
)  # fmt: skip
MATCH_CAROM = Table(
    2.84, 1.42, 0.03075, 0.21, MEASURED, laws.RoughBall(), laws.RigidCushion(nose=0.037 / 0.03075),
    "match carom",
)  # fmt: skip

# What more strokes show (docs/accuracy.md, "Equipment and coefficients"): side that lasts longer,
# cushions that give back less the faster they are met, friction of balls that a constant fits best.
BALLS_2 = laws.RoughBall(0.946, 0.05)
MATCH_CAROM_2 = replace(
    MATCH_CAROM,
    name="match carom 2",
    cloth=MEASURED_2,
    ball_law=BALLS_2,
    cushion_law=laws.RigidCushion(0.871, 0.269, 0.037 / 0.03075, e_slope=-0.051),
)
# A medium table as halls have it, unheated: the same rubber and balls as far as anybody knows, the
# nose and the balls of its own, and the cloth of a hall. Nothing of it is measured.
MEDIUM_CAROM_2 = replace(
    MEDIUM_CAROM,
    name="medium carom 2",
    cloth=CLOTHS["hall"],
    ball_law=BALLS_2,
    cushion_law=laws.RigidCushion(0.871, 0.269, 0.039 / 0.03275, e_slope=-0.051),
)
MATCH_EDITIONS = {1: MATCH_CAROM, 2: MATCH_CAROM_2}
MEDIUM_EDITIONS = {1: MEDIUM_CAROM, 2: MEDIUM_CAROM_2}


def thesis() -> World:
    """The thesis's table and laws, with exact events."""
    return THESIS.world()


def medium_carom(edition: int = 1) -> World:
    """The Korean medium table (중대) with 65.5 mm balls, for 4-ball.

    edition: 1, on the cloth of the measured match table; or 2, as a hall has it, which nobody has
    measured. An edition never changes; ValueError for one that there is not.
    """
    return _edition("medium_carom", MEDIUM_EDITIONS, edition).world()


def match_carom(edition: int = 2) -> World:
    """The match table (대대) with 61.5 mm balls, for three-cushion.

    edition: 2, which is nearest to the tracks of real strokes; or 1, from before they had been seen
    through. An edition never changes, so that what was played on it keeps its digits: name it where
    they matter. ValueError for one that there is not.
    """
    return _edition("match_carom", MATCH_EDITIONS, edition).world()


def _edition(name: str, editions: dict[int, Table], edition: int) -> Table:
    if edition not in editions:
        known = ", ".join(map(str, editions))
        raise ValueError(f"{name} edition must be one of {known}, not {edition!r}")
    return editions[edition]
