"""Billiards, exact: balls, walls and laws on a cloth; `docs/tour.py` shows it in a page."""

from typing import TYPE_CHECKING, Any

from . import laws
from .ball import Ball, Placed
from .cloth import Cloth
from .engines.exact import ContactError, EventBudgetError, EventDriven
from .log import Contact, Event, Leg, Log, State
from .post import Pocket, Post
from .shot import Shot, direction, heading
from .simulation import simulate
from .wall import Wall
from .world import World

if TYPE_CHECKING:
    from . import scenes, tables
    from .batch.many import simulate_many
    from .batch.outcomes import Outcomes
    from .cue import CueStroke
    from .engines.stepping import TimeStepping
    from .files import store
    from .studies import aim, tracks
    from .studies.animation import Animation, animate
    from .studies.drawn import Drawn, recover_drawn
    from .studies.fit import Fit, StrokeFound, fit
    from .studies.frames import columns, to_pandas, to_xarray
    from .studies.ledger import Ledger, ledger
    from .studies.recovery import Recovered, recover
    from .studies.sensitivity import Sensitivity, sensitivity
    from .studies.trace import heights, trace
    from .studies.tracks import Track
    from .watch import EnergyGainWarning

__version__ = "0.1.0"

# loaded on first use: a program that only wants a world waits for nothing else
MODULES = {
    "aim": "studies.aim", "scenes": "scenes", "store": "files.store",
    "tables": "tables", "tracks": "studies.tracks",
}  # fmt: skip
HOMES = {
    "Outcomes": "batch.outcomes", "simulate_many": "batch.many", "CueStroke": "cue",
    "Recovered": "studies.recovery", "recover": "studies.recovery",
    "Drawn": "studies.drawn", "recover_drawn": "studies.drawn",
    "Sensitivity": "studies.sensitivity", "sensitivity": "studies.sensitivity",
    "Fit": "studies.fit", "StrokeFound": "studies.fit", "fit": "studies.fit",
    "columns": "studies.frames", "to_pandas": "studies.frames", "to_xarray": "studies.frames",
    "Animation": "studies.animation", "animate": "studies.animation",
    "Ledger": "studies.ledger", "ledger": "studies.ledger", "Track": "studies.tracks",
    "heights": "studies.trace", "trace": "studies.trace",
    "TimeStepping": "engines.stepping", "EnergyGainWarning": "watch",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name in MODULES:
        return import_module(f".{MODULES[name]}", __name__)
    if name in HOMES:
        return getattr(import_module(f".{HOMES[name]}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """All public names, loaded or not, so that completion finds them."""
    return [*__all__, "__version__"]


__all__ = [
    "Animation", "Ball", "Cloth", "Contact", "ContactError", "CueStroke", "Drawn",
    "EnergyGainWarning", "Event", "EventBudgetError", "EventDriven", "Fit", "Ledger", "Leg", "Log",
    "Outcomes", "Placed", "Pocket", "Post", "Recovered", "Sensitivity", "Shot", "State",
    "StrokeFound", "TimeStepping", "Track", "Wall", "World", "aim", "animate", "columns",
    "direction", "fit", "heading", "heights", "laws", "ledger", "recover", "recover_drawn",
    "scenes", "sensitivity", "simulate", "simulate_many", "store", "tables", "to_pandas",
    "to_xarray", "trace", "tracks",
]  # fmt: skip
