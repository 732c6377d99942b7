"""A table as a value: its size, balls, cloth and laws, what stands and what is marked on it."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from physics import laws
from physics.ball import Ball
from physics.checks import keep, positive, sizable
from physics.cloth import Cloth, a_cloth
from physics.world import World

from .pieces import Piece, four_lines, solid

if TYPE_CHECKING:
    from .markings import Markings, Point
    from .pockets import Pockets
    from .regions import Region

# Pockets, markings and racks are imported on first use: a world of a carom table needs none.
KINDS = ("carom", "pool", "snooker", "pyramid")


@dataclass(frozen=True, slots=True)
class Table:
    """A table to play on, with what belongs to it. The middle is (0, 0), and x runs along it, from
    its head in the west.

    length, width: between the cushions' noses, m.
    radius: of a ball, m.
    mass: of a ball, kg.
    cloth, ball_law, cushion_law: as a World takes them.
    name: for messages and pictures.
    kind: "carom", "pool", "snooker" or "pyramid": what is marked on it and racked.
    pockets: or None for a table without.

    ValueError for what is not finite or not above zero, a kind that is none of these, no room for
    the spots and racks of its kind, and pockets that leave no room for a cushion, overlap, are too
    narrow for a ball, or leave it a way past a hole.
    """

    length: float
    width: float
    radius: float
    mass: float
    cloth: Cloth
    ball_law: laws.BallLaw
    cushion_law: laws.CushionLaw
    name: str = "carom table"
    kind: str = "carom"
    pockets: "Pockets | None" = None

    def __repr__(self) -> str:
        return f"<Table {self.name!r}, {self.length:g} x {self.width:g} m>"

    def __post_init__(self) -> None:
        keep(self, positive, "length", "width", "radius")
        keep(self, sizable, "mass")
        object.__setattr__(self, "cloth", Cloth() if self.cloth is None else a_cloth(self.cloth))
        object.__setattr__(self, "ball_law", laws.ball_law(self.ball_law))
        object.__setattr__(self, "cushion_law", laws.cushion_law(self.cushion_law))
        if not isinstance(self.name, str):
            raise ValueError(f"Table.name must be text, not {self.name!r}")
        if self.kind not in KINDS:
            known = ", ".join(KINDS)
            raise ValueError(f"Table.kind must be one of {known}, not {self.kind!r}")
        if self.pockets is not None:
            from .pockets import check

            check(self.length, self.width, self.pockets, self.radius)
        if self.kind != "carom":
            self._insist_on_room()

    def _insist_on_room(self) -> None:
        """ValueError, naming its size, if its largest rack, which is the first, has no room."""
        try:
            self._racked(self.racks[0])
        except ValueError as error:
            size = f"{self.length!r} by {self.width!r} m"
            raise ValueError(f"{self.name}, {size}: {error}") from None

    @property
    def obstacles(self) -> tuple[Piece, ...]:
        """What a ball can meet: rails, and at pockets facings, round noses and holes."""
        if self.pockets is None:
            return four_lines(self.length, self.width)
        from .pockets import obstacles

        return obstacles(self.length, self.width, self.pockets)

    @property
    def outline(self) -> tuple[complex, ...]:
        """The edge of the cushions, anticlockwise, m: a polygon, round noses in chords.

        At a pocket it runs along the facings, and across behind the middle of the hole.
        """
        if self.pockets is None:
            x, y = 0.5 * self.length, 0.5 * self.width
            return complex(x, -y), complex(x, y), complex(-x, y), complex(-x, -y)
        from .pockets import outline

        return outline(self.length, self.width, self.pockets)

    @property
    def spots(self) -> "dict[str, Point]":
        """(x, y) in m by name: "foot" and the like, or snooker's "pink"."""
        return self._marked().spots

    @property
    def head_string(self) -> float | None:
        """x of the line behind which play opens, m: snooker's baulk line, a pyramid's house."""
        return self._marked().line

    @property
    def regions(self) -> "dict[str, Region]":
        """Where the centre of a ball in hand may be, by name, with `contains((x, y))`.

        "anywhere" is all of the table; "kitchen", "baulk", "D" or "house" a part of it.
        """
        return self._marked().regions

    @property
    def racks(self) -> tuple[str, ...]:
        """What `rack` takes on this table."""
        return self._marked().racks

    def _marked(self) -> "Markings":
        from .markings import MARKINGS

        return MARKINGS[self.kind](0.5 * self.length, 0.5 * self.width, self.radius)

    def rack(
        self, kind: str, gap: float = 0.0, disorder: float = 0.0, seed: int | None = None
    ) -> list[Ball]:
        """The object balls of a game, at rest where they are racked.

        kind: one of `racks`.
        gap: between neighbours, m.
        disorder: how far a ball may lie off its place, m; places are farther apart by twice that.
        seed: draws one of the orders that the rules allow, and the disorder; None: a standard one.

        Balls are named by their numbers; snooker's reds are "red1" to "red15", and its colours
        are on their spots. ValueError, naming the value, for what cannot be, and where there is
        no room for so loose a rack.
        """
        if kind not in self.racks:
            known = ", ".join(self.racks) or "none"
            raise ValueError(f"{self.name}: no rack {kind!r}: there is {known}")
        places = self._racked(kind, gap, disorder, seed)
        return [Ball(name, at, radius=self.radius, mass=self.mass) for name, at in places.items()]

    def _racked(
        self, kind: str, gap: float = 0.0, disorder: float = 0.0, seed: int | None = None
    ) -> "dict[str, Point]":
        """The places of a rack; ValueError for what cannot be."""
        from .racks import insist_on_room, racked

        marked = self._marked()
        spot, balls = racked(kind, self.radius, gap, disorder, seed)
        x, y = marked.spots[spot]
        places = {name: (x + at.real, y + at.imag) for name, at in balls}
        if kind == "snooker":
            places |= marked.spots
        insist_on_room(places, marked.regions["anywhere"], self.radius)
        return places

    def world(self) -> World:
        """An empty world: the cushions, named west, east, south and north, cloth and laws.

        A ball that is added without a radius or a mass is one of this table's.
        """
        world = World(self.cloth, self.ball_law, self.cushion_law, table=self)
        for piece in self.obstacles:
            world.add(solid(piece))
        return world
