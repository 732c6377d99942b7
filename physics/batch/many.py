"""Many shots of one scene: shots in, arrays out; compiled where the extra `fast` is there."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor
from functools import cache
from types import ModuleType
from typing import TYPE_CHECKING, TypedDict

from physics.ball import Ball
from physics.checks import whole
from physics.shot import Shot
from physics.world import World

from .outcomes import Outcomes

if TYPE_CHECKING:
    from typing import Unpack

    import numpy.typing as npt

    Number = float | npt.ArrayLike

CHUNK = 4096  # shots that an executor is handed at once: 10 ms compiled, 0.5 s interpreted
MOST = 10_000  # contacts of a shot: a break has 200


class Numbers(TypedDict, total=False):
    """Shots number by number: each is one number or an array (shots,), as in `Shot`."""

    speed: Number
    angle: Number
    follow: Number
    masse: Number
    side: Number
    climb: Number


def simulate_many(
    world: World, ball: Ball | str, shots: Sequence[Shot] | npt.ArrayLike | None = None, *,
    positions: npt.ArrayLike | None = None, contacts: int = 0, executor: Executor | None = None,
    compiled: bool | None = None, progress: Callable[[int], object] | None = None,
    device: str = "cpu", until: Iterable[str] = (), **numbers: Unpack[Numbers],
) -> Outcomes:  # fmt: skip
    """The outcome of each shot at `ball`, all from the state the world is in, which stays as it is.

    shots: `Shot`s, or an array (shots, 5) of speed, angle, follow, masse, side, or (shots, 6) with
    climb. Or none, but speed=, angle=, follow=, masse=, side=, climb=, in m/s and degrees: each is
    one number or an array (shots,).
    positions: (shots, balls, 2) m, where the balls lie still before each shot, or NaN, NaN for one
    that is not on the table: as in `Outcomes.positions`. None: as in the world, moving or not.
    contacts: how many of each shot are kept, from its first on, in `Outcomes.contacts`.
    executor: any of concurrent.futures' kind shares the work: threads (the compiled kernel lets
    them run at once), processes, a cluster's.
    compiled: True asks for numba (ImportError without it), False for the interpreter; None takes
    numba where it is installed and worth it. The digits are the same, and those of `simulate` if
    all balls lie still before the shot.
    progress: called with the number of shots done since it was last called.
    device: "cuda" plays on a graphics card (the extra `cuda`), with the same digits; not yet run on
    hardware. ImportError without numba, RuntimeError without a card.
    until: names of balls: a shot is over with the first event after the ball has met all of them,
    if nothing is in the air and the table is closed; positions and times are then those of that
    moment, when balls may still move. (): to rest. Needs contacts.
    ValueError names a bad shot, number, position (with its shot), executor, progress, device or
    until, and custom laws and engines that a card does not play; other errors are those of a run.
    """
    contacts = _checked(executor, progress, contacts)
    work = _work()
    asked = work.asked_of(world, ball, shots, numbers, positions)
    enough = work.wanted(asked, until, contacts) if until else 0
    if device == "cpu":
        job = work.job_of(world, asked, contacts, enough, compiled, CHUNK)
    else:
        job = _card(device, executor, compiled).job_on(world, asked, contacts, enough)
    outcomes: Outcomes = work.play(world, asked, job, executor, progress)
    return outcomes


def _checked(executor: object, progress: object, contacts: int) -> int:
    """The number of contacts; ValueError for what does no work, is not called, or is no number."""
    if executor is not None and not hasattr(executor, "submit"):
        raise ValueError(f"simulate_many executor must have a submit, not be {executor!r}")
    if progress is not None and not callable(progress):
        raise ValueError(f"simulate_many progress must be callable, not {progress!r}")
    return whole("simulate_many contacts", contacts, 0, MOST)


def _card(device: str, executor: Executor | None, compiled: bool | None) -> ModuleType:
    """What plays batches on a graphics card; ImportError without numba."""
    if device != "cuda":
        raise ValueError(f"simulate_many device must be 'cpu' or 'cuda', not {device!r}")
    if executor is not None or compiled is False:
        wrong = "executor" if executor is not None else "compiled=False"
        raise ValueError(f"simulate_many device='cuda' does the work itself: no {wrong}")
    try:
        from . import card
    except ImportError as error:
        raise ImportError(
            f"simulate_many device='cuda' needs the extra `cuda` (pip install 'danggu[cuda]'):"
            f" {error}"
        ) from error
    return card


@cache
def _work() -> ModuleType:
    """What does the work; imported on first use, since it needs NumPy."""
    from . import play

    return play
