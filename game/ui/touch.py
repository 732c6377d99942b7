"""The mouse: what it is over and what it holds.  Only the picture depends on it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(slots=True)
class Pointer:
    """`over` is the name of the part under the mouse; `held` the part that was pressed."""

    over: str = ""
    held: str = ""
    pressing: bool = False
    """Is it a press that is being answered, rather than a drag?"""
    grip: object = None
    """What the held part has kept from the press."""

    @property
    def down(self) -> bool:
        """Is the button held on the part where it went down?"""
        return bool(self.held) and self.held == self.over
