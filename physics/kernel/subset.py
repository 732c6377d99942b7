"""What the kernel is written in: a subset of Python that numba compiles as it stands.

This is the interpreted binding. `physics.batch.compiled` loads the same package a second time with
another module in this place, in which `kernel` is numba's compiler; a test does so with 50-digit
numbers.
"""

from builtins import complex as complex
from collections.abc import Callable
from math import inf as inf
from math import nan as nan
from math import sqrt as sqrt
from typing import Any, TypeVar

from .body import Blow, Tie

F = TypeVar("F", bound=Callable[..., Any])


def kernel(function: F) -> F:
    """Mark a function as part of the subset."""
    return function


def elementary(function: F) -> F:
    """Mark a function of numbers that double precision computes as it is written; other arithmetics
    put their own in its place."""
    return function


def whole(function: F) -> F:
    """The same for what is handed a whole scene and may be called from outside.

    Compiled, it becomes a part of its caller.
    """
    return function


def room(ties: Any, contacts: int) -> None:
    """Room for so many contacts, which compiled code has from the start."""
    while len(ties.contacts) < contacts:
        ties.contacts.append(Tie())
        ties.chosen.append(0)
    while len(ties.blows) < len(ties.member):
        ties.blows.append(Blow())


def custom_cushion(v: complex, roll: complex, side: float, rule: Any) -> Any:
    """A custom cushion law: batches with one run interpreted."""
    return rule.function(v, roll, side)


def custom_ball(v: complex, roll: complex, side: float, mass: float, rule: Any) -> Any:
    """A custom ball law."""
    return rule.function(v, roll, side, mass)


def thread() -> int:
    """The number of the thread that plays, see kernel/lanes.py."""
    return 0


def threads() -> int:
    """And how many there are."""
    return 1
