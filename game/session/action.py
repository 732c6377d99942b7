"""Actions: what the player means, as small values that can be logged, written down and replayed."""

from __future__ import annotations

from typing import NamedTuple


class Action(NamedTuple):
    """One thing that is to be done: a command's name, and its value if it takes one."""

    name: str
    value: str | int | None = None

    @property
    def arguments(self) -> tuple[str | int, ...]:
        """The value, if there is one: to be handed to what does it."""
        return () if self.value is None else (self.value,)

    @property
    def ident(self) -> str:
        """What settings and texts call it: "pause", or "edit 0" if it has a value."""
        return self.name if self.value is None else f"{self.name} {self.value}"
