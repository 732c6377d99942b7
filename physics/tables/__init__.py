"""Tables to play on: playing surface, balls, cloth, laws, what is marked on them, and racks.

Sources are in docs/tables.md, and for the carom tables in docs/accuracy.md.
"""

from typing import TYPE_CHECKING, Any

from .carom_tables import (
    CLOTH_EDITIONS,
    CLOTHS,
    MATCH_CAROM,
    MATCH_CAROM_2,
    MATCH_EDITIONS,
    MEASURED,
    MEDIUM_CAROM,
    MEDIUM_CAROM_2,
    MEDIUM_EDITIONS,
    THESIS,
    USUAL,
    match_carom,
    medium_carom,
    thesis,
)
from .table import Table

if TYPE_CHECKING:
    from .pocket_tables import (
        PYRAMID_12FT,
        SNOOKER_12FT,
        pool,
        pool_7ft,
        pool_8ft,
        pool_9ft,
        pyramid_12ft,
        snooker_12ft,
    )
    from .pockets import Mouth, Pockets
    from .table_file import load, save

__all__ = [
    "CLOTHS", "CLOTH_EDITIONS", "MATCH_CAROM", "MATCH_CAROM_2", "MATCH_EDITIONS", "MEASURED",
    "MEDIUM_CAROM", "MEDIUM_CAROM_2", "MEDIUM_EDITIONS", "PYRAMID_12FT", "SNOOKER_12FT", "THESIS",
    "USUAL", "Mouth", "Pockets", "Table", "load", "match_carom", "medium_carom", "pool", "pool_7ft",
    "pool_8ft", "pool_9ft", "pyramid_12ft", "save", "snooker_12ft", "thesis",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in __all__:  # what has to do with pockets or files is imported on first use
        from . import pocket_tables, pockets, table_file

        homes = {"Mouth": pockets, "Pockets": pockets, "load": table_file, "save": table_file}
        return getattr(homes.get(name, pocket_tables), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """All public names, loaded or not, so that completion finds them."""
    return [*__all__]
