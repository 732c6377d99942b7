"""A line on the rail that says what the numbers at the diamonds are."""

from __future__ import annotations

from game.render.layout import WOOD
from game.render.theme import LINE_INPUT, TEXT_SOFT
from game.ui.sight import Sight
from game.ui.table.diamond_marks import DiamondMarks
from game.ui.table.over import LaidCard, written

SIZE = 12


def cards(sight: Sight, diamonds: DiamondMarks) -> list[LaidCard]:
    """The card, on the long rail that has no numbers; none while there are no numbers at all."""
    said = diamonds.words(sight.session, sight.words)
    if not said or diamonds.fan is None:
        return []
    table, out = sight.layout.table, sight.layout.scale * WOOD / 2
    picture = written(sight.type, [(said, SIZE, TEXT_SOFT)], LINE_INPUT, 0.9 * table.w, 14)
    below = diamonds.fan.rail != "south"
    middle = table.bottom - out if below else table.top + out
    rect = picture.get_rect(center=(table.centerx, round(middle)))
    return [LaidCard(("diamonds", said, below), rect.clamp(table), picture)]
