"""Tables with pockets: pool after the WPA, snooker and pyramid (sources in docs/tables.md).

Coefficients are the usual values of their ranges: nobody has published a fit to tracked shots.
"""

from dataclasses import replace

from physics import laws
from physics.world import World

from .carom_tables import USUAL
from .pockets import Mouth, Pockets
from .table import Table

INCH = 0.0254
LENGTHS = {9: 100.0, 8: 92.0, 7: 78.0}  # inches; for 7 ft the WPA has none
# the WPA's, in the middle of what it allows; the holes' radii are Alciatore's (TP 3.5, TP 3.6)
CORNER = Mouth(width=4.5625 * INCH, facing=7.0, shelf=1.625 * INCH, hole=2.75 * INCH)
SIDE = Mouth(width=5.0625 * INCH, facing=14.0, shelf=0.1875 * INCH, hole=3.0 * INCH)


def _cushion(nose: float) -> laws.RigidCushion:
    return laws.RigidCushion(e=0.85, mu=0.2, nose=nose)


def pool(
    feet: int,
    corner_mouth: float = CORNER.width,
    side_mouth: float = SIDE.width,
    shelf: float = CORNER.shelf,
    facing: float = CORNER.facing,
    side_shelf: float = SIDE.shelf,
    side_facing: float = SIDE.facing,
) -> Table:
    """A table of 9, 8 or 7 ft. Mouths, between the nose vertices, and shelves in m; facings are the
    degrees by which each closes in on the pocket's axis: a cut of 142° is 7°, at the side 104° 14°.
    Without `side_` it is the corner pockets'. ValueError, naming the value, for what cannot be.
    """
    if not isinstance(feet, int | float) or feet not in LENGTHS:
        raise ValueError(f"a pool table is of 9, 8 or 7 ft, not {feet!r}")
    length = LENGTHS[feet] * INCH
    corner = Mouth(corner_mouth, facing, shelf, CORNER.hole)
    side = Mouth(side_mouth, side_facing, side_shelf, SIDE.hole)
    return Table(
        length, 0.5 * length, 1.125 * INCH, 0.163, USUAL, laws.RoughBall(), _cushion(1.27),
        f"pool {feet} ft", "pool", Pockets(corner, side),
    )  # fmt: skip


# The pockets are approximate, those of pooltool's generic table: the templates are secret.
SNOOKER_12FT = Table(
    3.569, 1.778, 0.02625, 0.142, USUAL, laws.RoughBall(), _cushion(1.4), "snooker 12 ft",
    "snooker",
    Pockets(
        Mouth(width=0.083, facing=0.0, shelf=0.036, hole=0.043, rounding=0.09144),
        Mouth(width=0.075, facing=0.0, shelf=0.02413, hole=0.042672, rounding=0.0635),
    ),
)  # fmt: skip

# Of the holes only where they begin is known.
PYRAMID_12FT = Table(
    3.55, 1.775, 0.034125, 0.255, USUAL, laws.RoughBall(), _cushion(0.042 / 0.034125),
    "pyramid 12 ft", "pyramid",
    Pockets(
        Mouth(width=0.0725, facing=0.0, shelf=0.0076, hole=0.04, rounding=0.005),
        Mouth(width=0.0825, facing=0.0, shelf=0.011, hole=0.045, rounding=0.011),
    ),
)  # fmt: skip


# name: of which mouth, and what of it
SIZES = {
    "corner_mouth": ("corner", "width"), "side_mouth": ("side", "width"),
    "shelf": ("corner", "shelf"), "facing": ("corner", "facing"),
    "side_shelf": ("side", "shelf"), "side_facing": ("side", "facing"),
}  # fmt: skip


def pool_9ft(**sizes: float) -> World:
    """The WPA's 9 ft table; sizes: corner_mouth, side_mouth, shelf, facing and so on, as `pool`."""
    return _sized(pool(9), sizes).world()


def pool_8ft(**sizes: float) -> World:
    """The WPA's 8 ft table; sizes as `pool` has them."""
    return _sized(pool(8), sizes).world()


def pool_7ft(**sizes: float) -> World:
    """A 7 ft bar table with the WPA's pockets; sizes as `pool` has them."""
    return _sized(pool(7), sizes).world()


def snooker_12ft(**sizes: float) -> World:
    """The 12 ft snooker table; its pockets are approximate. Sizes are named as those of `pool`."""
    return _sized(SNOOKER_12FT, sizes).world()


def pyramid_12ft(**sizes: float) -> World:
    """The 12 ft table of Russian pyramid; sizes are named as those of `pool`."""
    return _sized(PYRAMID_12FT, sizes).world()


def _sized(table: Table, sizes: dict[str, float]) -> Table:
    """The table with pockets of these sizes; TypeError, with those that there are, for others."""
    for name in sizes.keys() - SIZES.keys():
        raise TypeError(f"{table.name} has no size {name!r}: there are {', '.join(SIZES)}")
    pockets = table.pockets
    for name, value in sizes.items():
        which, part = SIZES[name]
        mouth: Mouth = replace(getattr(pockets, which), **{part: value})
        pockets = replace(pockets, **{which: mouth})  # type: ignore[type-var]
    return replace(table, pockets=pockets) if sizes else table
