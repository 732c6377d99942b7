"""Billiards, exact: balls, walls and laws on a cloth; `docs/tour.py` shows it in a page."""

from typing import TYPE_CHECKING, Any

from . import laws
from .ball import Ball, Placed
from .cloth import Cloth
from .engine import ContactError, EventBudgetError, EventDriven
from .log import Contact, Event, Leg, Log, State
from .shot import Shot, direction, heading
from .simulation import simulate
from .trace import heights, trace
from .wall import Wall
from .world import World

if TYPE_CHECKING:
    from . import ledger, scenes, store, tables
    from .batch import Outcomes, simulate_many
    from .cue import CueStroke
    from .recovery import Recovered, recover
    from .slopes import Sensitivity, sensitivity
    from .stepping import TimeStepping
    from .watch import EnergyGainWarning

# loaded when first asked for: who only wants a world waits for nothing else
MODULES = {"ledger", "scenes", "store", "tables"}
HOMES = {
    "Outcomes": "batch", "simulate_many": "batch", "CueStroke": "cue", "Recovered": "recovery",
    "recover": "recovery", "Sensitivity": "slopes", "sensitivity": "slopes",
    "TimeStepping": "stepping", "EnergyGainWarning": "watch",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name in MODULES:
        return import_module(f".{name}", __name__)
    if name in HOMES:
        return getattr(import_module(f".{HOMES[name]}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """Return what there is to use, loaded or not: a prompt completes names by it."""
    return sorted(__all__)


__all__ = [
    "Ball", "Cloth", "Contact", "ContactError", "CueStroke", "EnergyGainWarning", "Event",
    "EventBudgetError", "EventDriven", "Leg", "Log", "Outcomes", "Placed", "Recovered",
    "Sensitivity", "Shot", "State", "TimeStepping", "Wall", "World", "direction", "heading",
    "heights", "laws", "ledger", "recover", "scenes", "sensitivity", "simulate", "simulate_many",
    "store", "tables", "trace",
]  # fmt: skip
