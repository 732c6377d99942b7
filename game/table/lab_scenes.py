"""Scenes by their names; those of the labs have names too, and are not listed.

"lab:cradle" is that of a lab with its usual numbers, "lab:cradle:7" with those of a seed. So what
names a scene, records and set-ups among it, names a lab's too.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from physics import World

from .unlisted import Unlisted

if TYPE_CHECKING:
    from danggu.labs import Worksheet

MARK = "lab:"


class Scenes(Unlisted[Callable[[], World]]):
    """What makes a scene, by its name."""

    def __missing__(self, key: str) -> Callable[[], World]:
        return sheet(key).world


def key_of(name: str, seed: int | None) -> str:
    """The name of a lab's scene."""
    return f"{MARK}{name}" if seed is None else f"{MARK}{name}:{seed}"


def sheet(key: str) -> Worksheet:
    """The worksheet of a lab's scene; KeyError for a key that names none."""
    if not key.startswith(MARK):
        raise KeyError(key)
    from danggu import labs  # read when the first is asked for: few games open one

    name, _, seed = key.removeprefix(MARK).partition(":")
    try:
        found = labs.lab(name, int(seed) if seed else None)
    except ValueError as error:
        raise KeyError(f"{key!r:.60}: {error}") from None
    if key != key_of(found.name, found.seed):  # a scene has one name
        raise KeyError(key)
    return found
