"""What tables of each kind are made of: cloth, leather, diamonds, and the lines marked on them."""

from __future__ import annotations

from typing import NamedTuple

from game.render.theme import Colour, rgb


class Finish(NamedTuple):
    """The look of a kind of table.

    cloth: a key of `theme.CLOTHS`.
    leather, stitch: colours of what lines a hole.
    brass: is there a lip of brass between leather and wood?
    diamonds: are sights laid into the rails?
    line: is the line of the opening shot drawn on the cloth?
    spots: names of the spots that are marked, where there are such.
    """

    cloth: str
    leather: Colour = rgb("#191513")
    stitch: Colour = rgb("#5A4A3A")
    brass: bool = False
    diamonds: bool = True
    line: bool = False
    spots: tuple[str, ...] = ()


TAN, BRASS = rgb("#2A1D14"), rgb("#B58A3C")
ON_AXIS = ("head", "front", "centre", "foot", "back")
COLOURS = ("yellow", "green", "brown", "blue", "pink", "black")
FINISHES = {
    "carom": Finish("blue", spots=("head", "centre", "foot")),
    "pool": Finish("pool", spots=("head", "foot")),
    "snooker": Finish("snooker", TAN, BRASS, True, False, True, COLOURS),
    "pyramid": Finish("pyramid", TAN, BRASS, True, True, True, ON_AXIS),
}
"""By `Table.kind`."""
