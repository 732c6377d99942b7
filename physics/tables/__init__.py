"""Tables to play on: playing surface, balls, cloth, laws, what is marked on them, and racks.

Sources are in docs/tables.md, and for the carom tables in docs/physics.md.
"""

from typing import TYPE_CHECKING, Any

from .carom_tables import (
    CLOTHS,
    MATCH_CAROM,
    MATCH_CAROM_2,
    MATCH_EDITIONS,
    MEASURED,
    MEDIUM_CAROM,
    THESIS,
    match_carom,
    medium_carom,
    thesis,
)
from .table import Table

if TYPE_CHECKING:
    from .pockets import Mouth, Pockets

__all__ = [
    "CLOTHS", "MATCH_CAROM", "MATCH_CAROM_2", "MATCH_EDITIONS", "MEASURED", "MEDIUM_CAROM",
    "THESIS", "Mouth", "Pockets", "Table", "match_carom", "medium_carom", "thesis",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in ("Mouth", "Pockets"):  # imported on first use
        from . import pockets

        return getattr(pockets, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
