"""Tables to play on: playing surface, balls, cloth and laws (sources in docs/accuracy.md)."""

from dataclasses import dataclass

from . import laws
from .checks import keep, positive
from .cloth import Cloth
from .wall import Wall
from .world import World


@dataclass(frozen=True, slots=True)
class Table:
    """A table to play on, with what belongs to it.

    length, width: between the cushions' noses, m.
    radius: of a ball, m.
    mass: of a ball, kg.
    cloth, ball_law, cushion_law: as a World takes them.

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


# Measured on tracked three-cushion shots, but for spin_decay, which those cannot show.
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

THESIS = Table(2.448, 1.270, 0.03275, 0.25, Cloth(), laws.ThesisBall(), laws.ThesisCushion())
MEDIUM_CAROM = Table(
    2.54, 1.27, 0.03275, 0.25, MEASURED, laws.RoughBall(), laws.RigidCushion(nose=0.039 / 0.03275)
)
MATCH_CAROM = Table(
    2.84, 1.42, 0.03075, 0.21, MEASURED, laws.RoughBall(), laws.RigidCushion(nose=0.037 / 0.03075)
)


def thesis() -> World:
    """The thesis's table and laws, with exact events."""
    return THESIS.world()


def medium_carom() -> World:
    """The Korean medium table (중대) with 65.5 mm balls, for 4-ball."""
    return MEDIUM_CAROM.world()


def match_carom() -> World:
    """The match table (대대) with 61.5 mm balls, for three-cushion."""
    return MATCH_CAROM.world()
