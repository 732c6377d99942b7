"""Logs, ledgers and batches as columns, which every library of tables takes, and as DataFrame or
xarray.Dataset where pandas or xarray are there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from physics.checks import array
from physics.log import Log
from physics.moments import Motion
from physics.shot import NUMBERS, rows

from .ledger import Ledger, ledger

if TYPE_CHECKING:
    import numpy.typing as npt

    Columns = dict[str, npt.NDArray[Any]]


def columns(
    thing: Any, shots: Any = None, balls: Sequence[str] | None = None
) -> dict[str, npt.NDArray[Any]]:
    """Columns by their names: arrays of one length, which pandas.DataFrame, polars.DataFrame,
    pyarrow.table and others take as they are.

    thing: a Log or a Ledger, a row an event: what an `Entry` of the ledger has; or the Outcomes of
    a batch, a row a shot: its time, events, and where each ball came to rest, "white x" and so on.
    shots: of a batch, as `simulate_many` took them: their numbers are the first columns.
    balls: names of a batch's balls, if it does not know them itself.
    ValueError for anything else, and for shots or names that are not as many.
    """
    if isinstance(thing, Log):
        thing = ledger(thing)
    if isinstance(thing, Ledger):
        entries = thing.table()
        return {name: entries[name] for name in entries.dtype.names or ()}
    _insist_on_outcomes(thing)
    found = _numbers(shots, len(thing.times)) if shots is not None else {}
    found |= {"time": thing.times, "events": thing.events}
    for k, name in enumerate(_names(thing, balls)):
        found |= {f"{name} {axis}": thing.positions[:, k, n] for n, axis in enumerate("xy")}
    return found


def to_pandas(thing: Any, shots: Any = None, balls: Sequence[str] | None = None) -> Any:
    """`columns` as a pandas.DataFrame; ImportError where pandas is not installed."""
    try:
        from pandas import DataFrame
    except ImportError:
        raise ImportError(
            "a DataFrame needs pandas: pip install 'danggu[frames]', or pass columns(...) to"
            " another library"
        ) from None
    return DataFrame(columns(thing, shots, balls))


def variables(
    thing: Any, shots: Any = None, balls: Sequence[str] | None = None, times: Any = None
) -> dict[str, Any]:
    """What xarray.Dataset.from_dict takes: arrays with the names of their axes.

    thing: the Outcomes of a batch, over shot, ball and axis; or a Log at `times`, (T,) s, over
    time, ball and axis, with what a Motion has.  shots, balls: as for `columns`.
    """
    if isinstance(thing, Log):
        if times is None:
            raise ValueError("a Log has to be asked at times: variables(log, times=...)")
        return _moving(thing, times)
    _insist_on_outcomes(thing)
    found = _numbers(shots, len(thing.times)) if shots is not None else {}
    over = {name: _over(values, "shot") for name, values in found.items()}
    return {
        "coords": {"ball": _over(_names(thing, balls), "ball"), "axis": _over(["x", "y"], "axis")},
        "data_vars": {
            **over, "time": _over(thing.times, "shot"), "events": _over(thing.events, "shot"),
            "position": _over(thing.positions, "shot", "ball", "axis"),
        },
    }  # fmt: skip


def to_xarray(
    thing: Any, shots: Any = None, balls: Sequence[str] | None = None, times: Any = None
) -> Any:
    """`variables` as an xarray.Dataset; ImportError where xarray is not installed."""
    try:
        from xarray import Dataset
    except ImportError:
        raise ImportError("a Dataset needs xarray: pip install 'danggu[frames]'") from None
    return Dataset.from_dict(variables(thing, shots, balls, times))


def _over(values: Any, *axes: str) -> dict[str, Any]:
    return {"dims": axes, "data": values}


def _moving(log: Log, times: Any) -> dict[str, Any]:
    import numpy as np

    motions = log.at(np.asarray(times))
    kinds = {name: np.stack([getattr(motion, name) for motion in motions.values()], axis=1)
             for name in Motion._fields}  # fmt: skip
    axes = {"position": ["axis"], "velocity": ["axis"], "spin": ["about"]}
    return {
        "coords": {
            "time": _over(np.asarray(times), "time"), "ball": _over([*motions], "ball"),
            "axis": _over(["x", "y"], "axis"), "about": _over(["x", "y", "z"], "about"),
        },
        "data_vars": {
            name: _over(values, "time", "ball", *axes.get(name, ()))
            for name, values in kinds.items()
        },
    }  # fmt: skip


def _insist_on_outcomes(thing: Any) -> None:
    if not all(hasattr(thing, name) for name in ("positions", "times", "events")):
        raise ValueError(f"tables are made of a Log, a Ledger or Outcomes, not {thing!r:.80}")


def _names(outcomes: Any, balls: Sequence[str] | None) -> list[str]:
    count = outcomes.positions.shape[1]
    if balls is None:
        balls = getattr(outcomes, "balls", None) or [f"{k}" for k in range(count)]
    names = [getattr(ball, "name", ball) for ball in balls]
    if len(names) != count:
        raise ValueError(f"balls must be {count} names, not {len(names)}")
    return names


def _numbers(shots: Any, count: int) -> Columns:
    """The numbers of the shots that there are, by name."""
    table = array("shots", rows(shots))
    if table.ndim != 2 or len(table) != count or table.shape[1] > len(NUMBERS):
        raise ValueError(f"shots must be those of the batch, {count}, not {table.shape}")
    return dict(zip(NUMBERS, table.T, strict=False))
