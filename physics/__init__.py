"""Billiards, exact: balls, walls and laws on a cloth; `docs/tour.py` shows it in a page."""

from . import laws, ledger, scenes, store, tables
from .ball import Ball
from .batch import Outcomes, simulate_many
from .cloth import Cloth
from .cue import CueStroke
from .engine import EventBudgetError, EventDriven
from .log import Event, Leg, Log, State
from .recover import Recovered, recover
from .sensitivity import Sensitivity, sensitivity
from .shot import Shot
from .stepping import TimeStepping
from .trace import trace
from .wall import Wall
from .watch import EnergyGainWarning
from .world import World, simulate

__all__ = [
    "Ball", "Cloth", "CueStroke", "EnergyGainWarning", "Event", "EventBudgetError",
    "EventDriven", "Leg", "Log", "Outcomes", "Recovered", "Sensitivity", "Shot", "State",
    "TimeStepping", "Wall", "World", "laws", "ledger", "recover", "scenes", "sensitivity",
    "simulate", "simulate_many", "store", "tables", "trace",
]  # fmt: skip
