"""What the loop has done, counted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from game.session.session import Session


@dataclass(slots=True)
class Stats:
    """What the loop has done."""

    drawn: int = 0
    skipped: int = 0
    inputs: int = 0

    def line(self, session: Session) -> str:
        """All of it in a line."""
        return (
            f"frames drawn {self.drawn}, frames skipped {self.skipped}, "
            f"physics calls {session.calls}, events {session.events}, inputs {self.inputs}"
        )
