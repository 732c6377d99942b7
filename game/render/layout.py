"""Where everything is: every rectangle of a window of any size, and metres to pixels."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from pygame import Rect

CUSHION = 0.046
"""Depth of the cushion's cloth from the nose line to the wood, m."""
WOOD = 0.088
"""Width of the wooden rail, m."""
BORDER = CUSHION + WOOD
PANEL_LEAST, PANEL_MOST = 284, 480
"""Width of the right column, px at s = 1."""


@dataclass(frozen=True)
class Layout:
    """The rectangles of a picture of `size` px with a table of `length` x `width` metres.

    Four rows from the top (score, table, fields, timeline) and a column at their right.  Everything
    is a multiple of `s`, the scale at which 1280 x 720 is 1; one of another shape is filled by a
    wider column, then by margins.  Below 960 x 540 texts, never less than 11 px, would not fit.
    """

    size: tuple[int, int]
    length: float
    width: float

    @cached_property
    def s(self) -> float:
        """Scale of the window, 1 at 1280 x 720."""
        return min(self.size[0] / 1280, self.size[1] / 720)

    def px(self, design: float) -> int:
        """Return a length given in px at s = 1 in whole px of this window, at least 1."""
        return max(1, round(design * self.s))

    @cached_property
    def scale(self) -> float:
        """Pixels per metre."""
        columns = self.size[0] - 2 * self._margin - self._margin - self.px(PANEL_LEAST)
        rows = self.size[1] - 2 * self._margin - 3 * self.px(12) - sum(map(self.px, (48, 52, 36)))
        return min(rows / (self.width + 2 * BORDER), columns / (self.length + 2 * BORDER))

    @cached_property
    def table(self) -> Rect:
        """The table with its rails."""
        return Rect(self._left, self._top + self.px(48) + self.px(12), *self._outer)

    @cached_property
    def bed(self) -> Rect:
        """The playing surface between the nose lines, rounded outwards to whole px."""
        left, top = self.to_screen(-self.length / 2, self.width / 2)
        right, bottom = self.to_screen(self.length / 2, -self.width / 2)
        return Rect(int(left), int(top), -int(-right) - int(left), -int(-bottom) - int(top))

    @cached_property
    def score(self) -> list[Rect]:
        """Player 1, the inning, player 2."""
        gap, middle = self.px(8), self.px(105)
        side = (self.table.w - middle - 2 * gap) // 2
        middle = self.table.w - 2 * (side + gap)
        x, y, height = self.table.x, self._top, self.px(48)
        return [
            Rect(x, y, side, height),
            Rect(x + side + gap, y, middle, height),
            Rect(self.table.right - side, y, side, height),
        ]

    @cached_property
    def fields(self) -> list[Rect]:
        """The five input boxes."""
        gap = self.px(8)
        edges = [self.table.x + round(i * (self.table.w + gap) / 5) for i in range(6)]
        y, height = self._fields_top, self.px(52)
        return [Rect(a, y, b - a - gap, height) for a, b in pairwise(edges)]

    @cached_property
    def timeline(self) -> Rect:
        """The strip with one lane a ball."""
        return Rect(self.table.x, self._timeline_top, self.table.w, self.px(36))

    @cached_property
    def engine(self) -> Rect:
        """The card that names the engine and the table."""
        return self._column(self._top, self.px(48))

    @cached_property
    def panel(self) -> Rect:
        """The right column beside the table."""
        return self._column(self.table.y, self.table.h)

    @cached_property
    def shoot(self) -> Rect:
        """The primary button."""
        return self._column(self._fields_top, self.px(52))

    @cached_property
    def hint(self) -> Rect:
        """The line of help or error."""
        return self._column(self._timeline_top, self.px(36))

    @cached_property
    def tip(self) -> Rect:
        """Aim panel: the tip-point picker."""
        return self._aim_cards[0]

    @cached_property
    def power(self) -> Rect:
        """Aim panel: the power bar."""
        return self._aim_cards[1]

    @cached_property
    def thickness(self) -> Rect:
        """Aim panel: the overlap with the object ball."""
        return self._aim_cards[2]

    @cached_property
    def readouts(self) -> Rect:
        """Aim panel: the three speeds."""
        return self._aim_cards[3]

    @cached_property
    def result(self) -> Rect:
        """After panel: what the shot counted."""
        return self._column(self.panel.y, self.px(64))

    @cached_property
    def log(self) -> Rect:
        """After panel: the list of events."""
        top = self.result.bottom + self.px(8)
        return self._column(top, self.readouts_after.y - self.px(8) - top)

    @cached_property
    def readouts_after(self) -> Rect:
        """After panel: the three speeds."""
        return self._column(self.panel.bottom - self.px(72), self.px(72))

    def to_screen(self, x: float, y: float) -> tuple[float, float]:
        """Return the screen point of the table point (x, y) in metres."""
        return self._centre[0] + x * self.scale, self._centre[1] - y * self.scale

    def to_table(self, px: float, py: float) -> tuple[float, float]:
        """Return the table point in metres of a screen point: the inverse of `to_screen`."""
        return (px - self._centre[0]) / self.scale, (self._centre[1] - py) / self.scale

    @property
    def _margin(self) -> int:
        return self.px(16)

    @cached_property
    def _outer(self) -> tuple[int, int]:
        across, down = self.length + 2 * BORDER, self.width + 2 * BORDER
        return int(across * self.scale + 1e-6), int(down * self.scale + 1e-6)

    @cached_property
    def _centre(self) -> tuple[float, float]:
        return self.table.x + self.table.w / 2, self.table.y + self.table.h / 2

    @cached_property
    def _panel_width(self) -> int:
        free = self.size[0] - 3 * self._margin - self._outer[0]
        return min(free, self.px(PANEL_MOST))

    @cached_property
    def _left(self) -> int:
        return (self.size[0] - self._outer[0] - self._margin - self._panel_width) // 2

    @cached_property
    def _top(self) -> int:
        rows = self._outer[1] + 3 * self.px(12) + sum(map(self.px, (48, 52, 36)))
        return (self.size[1] - rows) // 2

    @property
    def _fields_top(self) -> int:
        return self.table.bottom + self.px(12)

    @property
    def _timeline_top(self) -> int:
        return self._fields_top + self.px(52) + self.px(12)

    def _column(self, y: int, height: int) -> Rect:
        return Rect(self.table.right + self._margin, y, self._panel_width, height)

    @cached_property
    def _aim_cards(self) -> list[Rect]:
        """Tip, power, thickness, and read-outs in the room that is left."""
        gap, top, cards = self.px(8), self.panel.y, []
        for share in (0.45, 0.155, 0.185):
            cards.append(self._column(top, round(self.panel.h * share)))
            top = cards[-1].bottom + gap
        return [*cards, self._column(top, self.panel.bottom - top)]
