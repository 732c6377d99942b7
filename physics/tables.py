"""Tables to play on: playing surface, balls, cloth and laws (sources in docs/physics.md)."""

from dataclasses import dataclass, replace

from . import laws
from .checks import keep, positive
from .cloth import Cloth
from .wall import Wall
from .world import World


@dataclass(frozen=True, slots=True)
class Table:
    """length and width between the cushions' noses, ball radius: metres; ball mass: kg.

    ValueError for what is not finite or not above zero.
    """

    length: float
    width: float
    radius: float
    mass: float
    cloth: Cloth
    ball_law: laws.BallLaw
    cushion_law: laws.CushionLaw

    def __post_init__(self) -> None:
        keep(self, positive, "length", "width", "radius", "mass")

    def world(self) -> World:
        """An empty world: four walls named west, east, south and north, cloth and laws."""
        world = World(self.cloth, self.ball_law, self.cushion_law)
        world.add(Wall.line(1.0, 0.0, 0.5 * self.length, "west"))
        world.add(Wall.line(-1.0, 0.0, 0.5 * self.length, "east"))
        world.add(Wall.line(0.0, 1.0, 0.5 * self.width, "south"))
        world.add(Wall.line(0.0, -1.0, 0.5 * self.width, "north"))
        return world


# Measured on tracked three-cushion shots, but for spin_decay, a usual value; see edition 2 below.
MEASURED = Cloth(slide=0.212, roll=0.0045, spin_decay=10.0, gravity=9.81)

# No source measures one cloth in its three conditions. These are the low end, the usual value and
# the high end of the published ranges (slide 0.15 to 0.4, roll 0.005 to 0.015, spin_decay 5 to 15
# rad/s²), put to the condition that players say is so: new cloth is slippery and fast, a damp one
# grips and is slow. But the measured cloth is faster than those ranges: `roll` of a new one is what
# its shots give for a ball that hardly moves (docs/physics.md, "Cloths"). From the cloth on which a
# ball runs farthest to the slowest: new, measured, worn, humid.
CLOTHS: dict[str, Cloth] = {
    "new": Cloth(slide=0.15, roll=0.004, spin_decay=5.0, gravity=9.81),
    "measured": MEASURED,
    "worn": Cloth(slide=0.2, roll=0.01, spin_decay=10.0, gravity=9.81),
    "humid": Cloth(slide=0.4, roll=0.015, spin_decay=15.0, gravity=9.81),
}

THESIS = Table(2.448, 1.270, 0.03275, 0.25, Cloth(), laws.ThesisBall(), laws.ThesisCushion())
MEDIUM_CAROM = Table(
    2.54, 1.27, 0.03275, 0.25, MEASURED, laws.RoughBall(), laws.RigidCushion(nose=0.039 / 0.03275)
)
MATCH_CAROM = Table(
    2.84, 1.42, 0.03075, 0.21, MEASURED, laws.RoughBall(), laws.RigidCushion(nose=0.037 / 0.03075)
)

# What more strokes show (docs/physics.md, "Equipment and coefficients"): side that lasts longer,
# cushions that give back less the faster they are met, friction of balls that a constant fits best.
MATCH_CAROM_2 = replace(
    MATCH_CAROM,
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
