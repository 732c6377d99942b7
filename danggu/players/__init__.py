"""Players: how well a level carries out a stroke, and an opponent that looks for one."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .levels import LEVELS, Attempt, Level
    from .opponent import Intent, Opponent
    from .positions import Position, opening

__all__ = ["LEVELS", "Attempt", "Intent", "Level", "Opponent", "Position", "opening"]

HOMES = {
    "LEVELS": "levels", "Attempt": "levels", "Level": "levels", "Intent": "opponent",
    "Opponent": "opponent", "Position": "positions", "opening": "positions",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    """Each is imported on first use."""
    if name in HOMES:
        return getattr(import_module(f".{HOMES[name]}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]
