"""The palette: every colour of the interface, the table and the balls has one name here."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import cos

Colour = tuple[int, int, int]


def rgb(code: str) -> Colour:
    """Return the colour written "#RRGGBB"."""
    return int(code[1:3], 16), int(code[3:5], 16), int(code[5:7], 16)


def mix(first: Colour, second: Colour, share: float) -> Colour:
    """Return `first` moved by `share` (0 to 1) of the way towards `second`."""
    r, g, b = (round(p + (q - p) * share) for p, q in zip(first, second, strict=True))
    return r, g, b


BACKGROUND = rgb("#0E1217")
PANEL = rgb("#161B22")
PANEL_RAISED = rgb("#1C222B")
LINE = rgb("#2A323D")
LINE_TRACK = rgb("#3A4451")
LINE_INPUT = rgb("#687583")
TEXT = rgb("#E8ECF1")
TEXT_SOFT = rgb("#A9B4C0")
TEXT_FAINT = rgb("#7F8B98")
ACCENT = rgb("#7CC4FF")
PRIMARY = rgb("#24659B")
PRIMARY_EDGE = rgb("#4C92CC")
ERROR = rgb("#FF8A7A")
WARNING = rgb("#FFC56B")
"""What was put right, or is unusual, and yet may be done."""
GOOD = rgb("#7BD88F")
GOLD = rgb("#F4C95D")
"""Stars, and what they are earned in."""
WHITE = (255, 255, 255)
HALO = rgb("#030E1A")
LILAC = rgb("#CDB8FF")
"""What the computer intends: no ball and no state of the interface has this colour."""

CLOTHS = {
    "blue": rgb("#1B6292"), "green": rgb("#17694B"), "pool": rgb("#1E6B9F"),
    "snooker": rgb("#1B6D3F"), "pyramid": rgb("#1B6D3F"),
}  # fmt: skip
WOOD = rgb("#5C3B27")
DIAMOND = rgb("#E9E2D2")
DIAMOND_SHADE = rgb("#C9BFAA")
DIAMOND_EDGE = rgb("#140C08")

CUE_TIP = rgb("#3F6FA8")
CUE_FERRULE = rgb("#F1EDE3")
CUE_SHAFT = rgb("#D9B57E")
CUE_JOINT = rgb("#C8CBD0")
CUE_BUTT = rgb("#3A1E16")
CUE_POINTS = rgb("#C79A5B")
CUE_WRAP = rgb("#23262B")


@dataclass(frozen=True)
class BallLook:
    """How one ball looks.

    body    colour of the ball
    mark    colour of what is painted on it
    ui      its colour in traces and lists
    letter  beside its colour in the colour-blind set
    marks   intervals of a direction's coordinate on the ball (0 to 1) painted in `mark`
    banded  that coordinate is the distance from the equator plane, so intervals are bands; without,
            it is the largest of the three distances, so an interval that ends at 1 is six dots
    dashes  of its traces, px at s = 1: on, off, ...; empty is solid
    number  on two discs in `mark`, which take the place of the marks
    striped is a ball with a number also white above and below a band?
    """

    body: Colour
    mark: Colour
    ui: Colour
    letter: str
    marks: tuple[tuple[float, float], ...] = ((cos(0.30), 1.1),)
    banded: bool = False
    dashes: tuple[float, ...] = field(default=())
    number: str = ""
    striped: bool = False


BALLS = {
    "white": BallLook(rgb("#F4F1E6"), rgb("#C4162E"), rgb("#F4F1E6"), "W"),
    "yellow": BallLook(rgb("#F6C328"), rgb("#1F3F91"), rgb("#F6C328"), "Y"),
    "red 1": BallLook(rgb("#C4152C"), rgb("#F3DFC9"), rgb("#FF8585"), "1", ((cos(0.22), 1.1),)),
    "red 2": BallLook(rgb("#C4152C"), rgb("#F3DFC9"), rgb("#FFBDB5"), "2", ((cos(0.22), 1.1),)),
}
"""The usual set."""

SAFE_BALLS = {
    "white": BallLook(rgb("#F7F6F0"), rgb("#15171B"), rgb("#FFFFFF"), "W"),
    "yellow": BallLook(
        rgb("#F5D000"), rgb("#15171B"), rgb("#F5D000"), "Y", ((-0.1, 0.22),), True, (9, 5)
    ),
    "red 1": BallLook(
        rgb("#D94F00"), rgb("#F7F6F0"), rgb("#FF9A5C"), "1", ((-0.1, 0.22),), True, (14, 4)
    ),
    "red 2": BallLook(
        rgb("#15171B"), rgb("#F7F6F0"), rgb("#DCC8FF"), "2", ((0.20, 0.46),), True, (3, 4)
    ),
}
"""The set for colour-blind eyes: the marks and the dashes differ as well as the colours."""
