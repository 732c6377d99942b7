"""How the balls of pool, snooker and pyramid look, by name, also for colour-blind eyes.

The safe set of pool was searched for: of every two balls, ivory, black and the cloth the nearest
are 28 apart (CIE76) for all four kinds of eyes; of the usual set 6.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos

from .theme import BallLook, Colour, mix, rgb

IVORY, RED = rgb("#F4F1E6"), rgb("#C4162E")
DASHED = (9.0, 5.0)
"""The paths of stripes."""
SMALL = ((cos(0.22), 1.1),)
"""Six small dots."""
CUE = BallLook(IVORY, RED, rgb("#F4F1E6"), "", SMALL)
Set = Mapping[str, BallLook]

POOL_BODIES = ("#F4B91C", "#1D3C9C", "#C8142A", "#5C2A8C", "#EE6A1A", "#0C7340", "#7C2420")
POOL_PATHS = ("#F6C328", "#86A8FF", "#FF8585", "#CDA2F2", "#FFA366", "#63D69B", "#E39A8C")
SAFE_BODIES = ("#DDC31F", "#410AA6", "#A6490A", "#AA69FA", "#6C3D29", "#70CDFA", "#92BC67")
SAFE_PATHS = ("#F0DA3C", "#A48CFF", "#F29A5C", "#CFA8FF", "#D9A98E", "#9BDDFC", "#B9DA95")


def _numbered(number: str, body: Colour, ui: Colour, *, striped: bool = False) -> BallLook:
    dashes = DASHED if striped else ()
    return BallLook(body, IVORY, ui, number, dashes=dashes, number=number, striped=striped)


def _pool(bodies: tuple[str, ...], paths: tuple[str, ...], black: str, grey: str) -> Set:
    colours = [*zip(bodies, paths, strict=True), (black, grey)]
    found = {"cue": CUE}
    for n in range(1, 16):
        body, path = colours[(n - 1) % 8]
        found[f"{n}"] = _numbered(f"{n}", rgb(body), rgb(path), striped=n > 8)
    return found


POOL = _pool(POOL_BODIES, POOL_PATHS, "#17181B", "#C9D0D8")
SAFE_POOL = _pool(SAFE_BODIES, SAFE_PATHS, "#15171B", "#E8ECF1")

SNOOKER_BALLS = {
    "red": ("#B80F26", "#FF8585", "R"), "yellow": ("#F0BE1A", "#F6C328", "Y"),
    "green": ("#0A7A5A", "#63D69B", "G"), "brown": ("#7B4420", "#E0A878", "N"),
    "blue": ("#1E55C4", "#86A8FF", "B"), "pink": ("#F08CAB", "#FFB3C9", "P"),
    "black": ("#16181B", "#C9D0D8", "K"),
}  # fmt: skip
"""Body, path, and the letter of the colour-blind set: brown is N and black is K."""


def _snooker(*, lettered: bool) -> Set:
    found = {"cue": CUE}
    for name, (body, path, letter) in SNOOKER_BALLS.items():
        colour, ui = rgb(body), rgb(path)
        if lettered:
            found[name] = _numbered(letter, colour, ui)
        else:
            dots = mix(colour, (255, 255, 255), 0.20 if name == "black" else 0.30)
            found[name] = BallLook(colour, dots, ui, letter, SMALL)
    return found


SNOOKER, SAFE_SNOOKER = _snooker(lettered=False), _snooker(lettered=True)

PYRAMID: Set = {
    "cue": BallLook(rgb("#A3232B"), IVORY, rgb("#FF8585"), "", SMALL),
    **{f"{n}": _numbered(f"{n}", IVORY, IVORY) for n in range(1, 16)},
}
"""Ivory, but for the cue ball: their numbers alone tell them apart."""
