"""A line that tells the player something."""

from __future__ import annotations

from typing import NamedTuple


class Notice(NamedTuple):
    """Something to tell the player: a key of the texts, whether it is an error, and about what.

    key    of the texts
    error  is it one?
    about  a name that the text has room for, of a ball, or numbers with spaces between; or ""
    at     where a ball in hand may not be put, m; None for all else
    """

    key: str
    error: bool = False
    about: str = ""
    at: tuple[float, float] | None = None
