"""The font and the icons, read as package data so that a wheel or a zip works like a checkout."""

from __future__ import annotations

from importlib.resources import files
from io import BytesIO

FONT = "NotoSansKR-subset.otf"
ICONS = ("icon-64.png", "icon-256.png")


def stream(name: str) -> BytesIO:
    """Return the asset `name` as a file in memory, which is what pygame's loaders take."""
    return BytesIO(files(__name__).joinpath(name).read_bytes())
