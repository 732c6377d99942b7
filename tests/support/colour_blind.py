"""How far colours are apart for eyes that lack a kind of cone: Machado et al. 2009, CIE 1976."""

from itertools import combinations

import numpy as np

from game.render.theme import Colour

EYES = {
    "usual": np.eye(3),
    "protan": np.array([
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ]),
    "deutan": np.array([
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ]),
    "tritan": np.array([
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ]),
}  # fmt: skip
"""What they see of linear red, green and blue, at full severity."""
TO_XYZ = np.array([
    [0.4124564, 0.3575761, 0.1804375],
    [0.2126729, 0.7151522, 0.0721750],
    [0.0193339, 0.1191920, 0.9503041],
])  # fmt: skip
WHITE = TO_XYZ @ np.ones(3)


def lab(colour: Colour, eyes: str = "usual") -> np.ndarray:
    """Return L*, a* and b* of a colour as those eyes see it."""
    c = np.array(colour) / 255
    linear = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    x, y, z = np.cbrt(TO_XYZ @ (EYES[eyes] @ linear).clip(0, 1) / WHITE).clip(0.138, None)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def nearest(colours: list[Colour], eyes: str) -> float:
    """Return the least difference of any two of them."""
    seen = [lab(colour, eyes) for colour in colours]
    return min(float(np.linalg.norm(p - q)) for p, q in combinations(seen, 2))
