"""Players: how well a level carries out a stroke, an opponent that looks for one, and a coach that
shows all there are."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .levels import LEVELS, Attempt, Level
    from .opponent import Intent, Opponent
    from .positions import Position, opening
    from .solution import Solution, Thickness, Tip, Tolerance
    from .ways import solutions

__all__ = [
    "LEVELS", "Attempt", "Intent", "Level", "Opponent", "Position", "Solution", "Thickness", "Tip",
    "Tolerance", "opening", "solutions",
]  # fmt: skip

HOMES = {
    "LEVELS": "levels", "Attempt": "levels", "Level": "levels", "Intent": "opponent",
    "Opponent": "opponent", "Position": "positions", "opening": "positions",
    "Solution": "solution", "Thickness": "solution", "Tip": "solution", "Tolerance": "solution",
    "solutions": "ways",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    """Each is imported on first use."""
    if name in HOMES:
        return getattr(import_module(f".{HOMES[name]}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]
