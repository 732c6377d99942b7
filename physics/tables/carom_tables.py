"""The carom tables, and cloths in their conditions (sources in docs/accuracy.md)."""

from dataclasses import replace

from physics import laws
from physics.cloth import Cloth
from physics.world import World

from .table import Table

# Measured on tracked three-cushion shots, but for spin_decay, a usual value; see edition 2 below.
MEASURED = Cloth(slide=0.212, roll=0.0045, spin_decay=10.0, gravity=9.81)

# No source measures one cloth in its three conditions. These are the low end, the usual value and
# the high end of the published ranges (slide 0.15 to 0.4, roll 0.005 to 0.015, spin_decay 5 to 15
# rad/s²), assigned to the condition that players describe so: new cloth is slippery and fast, a
# damp one grips and is slow. But the measured cloth is faster than those ranges: `roll` of a new
# one is what its shots give for a ball that hardly moves (docs/accuracy.md, "Cloths"). From the
# cloth on which a ball runs farthest to the slowest: new, measured, worn, humid.
CLOTHS: dict[str, Cloth] = {
    "new": Cloth(slide=0.15, roll=0.004, spin_decay=5.0, gravity=9.81),
    "measured": MEASURED,
    "worn": Cloth(slide=0.2, roll=0.01, spin_decay=10.0, gravity=9.81),
    "humid": Cloth(slide=0.4, roll=0.015, spin_decay=15.0, gravity=9.81),
}

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
MATCH_CAROM_2 = replace(
    MATCH_CAROM,
    name="match carom 2",
    cloth=replace(MEASURED, spin_decay=4.3),
    ball_law=laws.RoughBall(0.946, 0.05),
    cushion_law=laws.RigidCushion(0.871, 0.269, 0.037 / 0.03075, e_slope=-0.051),
)
MATCH_EDITIONS = {1: MATCH_CAROM, 2: MATCH_CAROM_2}


def thesis() -> World:
    """The thesis's table and laws, with exact events."""
    return THESIS.world()


def medium_carom() -> World:
    """The Korean medium table (중대) with 65.5 mm balls, for 4-ball."""
    return MEDIUM_CAROM.world()


def match_carom(edition: int = 1) -> World:
    """The match table (대대) with 61.5 mm balls, for three-cushion.

    edition: 1, or 2 with what later measurements say. An edition never changes, so that what was
    played on it keeps its digits; ValueError for one that there is not.
    """
    if edition not in MATCH_EDITIONS:
        known = ", ".join(map(str, MATCH_EDITIONS))
        raise ValueError(f"match_carom edition must be one of {known}, not {edition!r}")
    return MATCH_EDITIONS[edition].world()
