"""Numbers from callers: refused, naming them, when they are not what they should be."""

from collections.abc import Callable, Sequence
from math import isfinite
from operator import index
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

NO_NUMBERS = (str, bytes, bytearray, bool)  # though float takes them
SMALLEST = 1e-250  # of a mass: its inverse is still a number
LARGEST = 1e50  # in any unit: its fourth power is still a number, and so is all that comes of it


def finite(name: str, value: float) -> float:
    """The value as a plain float, or ValueError with its name; NumPy's numbers become plain."""
    try:
        number = float("text" if isinstance(value, NO_NUMBERS) else value)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name} must be a number, not {value!r}") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, not {value!r}")
    if abs(number) > LARGEST:
        raise ValueError(f"{name} must be at most {LARGEST:g}, not {value!r}")
    return number


def positive(name: str, value: float) -> float:
    number = finite(name, value)
    if number <= 0.0:
        raise ValueError(f"{name} must be above zero, not {value!r}")
    return number


def sizable(name: str, value: float) -> float:
    number = positive(name, value)
    if number < SMALLEST:
        raise ValueError(f"{name} must be at least {SMALLEST:g}, not {value!r}")
    return number


def nonnegative(name: str, value: float) -> float:
    number = finite(name, value)
    if number < 0.0:
        raise ValueError(f"{name} must not be negative, not {value!r}")
    return number


def fraction(name: str, value: float) -> float:
    if not 0.0 <= finite(name, value) <= 1.0:
        raise ValueError(f"{name} must be from 0 to 1, not {value!r}")
    return float(value)


def whole(name: str, value: int, least: int, most: int) -> int:
    """The value as an int, or ValueError unless it is a whole number from least to most."""
    try:
        number = index(value)
    except TypeError:
        number = least - 1
    if isinstance(value, bool) or not least <= number <= most:
        raise ValueError(f"{name} must be a whole number from {least} to {most}, not {value!r}")
    return number


def truth(name: str, value: bool) -> bool:
    if not isinstance(value, bool):
        raise ValueError(f"{name} is True or False, not {value!r}")
    return value


def keep(owner: object, check: Callable[[str, float], float], *names: str) -> None:
    """Check these fields of a frozen dataclass, each under its full name, and make them floats."""
    for name in names:
        number = check(f"{type(owner).__name__}.{name}", getattr(owner, name))
        object.__setattr__(owner, name, number)


def array(name: str, values: Any) -> "npt.NDArray[np.float64]":
    """The values as an array of floats, or ValueError: NumPy would accept text and truth values."""
    import numpy as np

    try:
        found = np.asarray(values)
        if found.dtype.kind in "iufO":
            return found.astype(float)
    except (TypeError, ValueError, OverflowError):
        pass
    raise ValueError(f"{name} must be numbers, not {values!r:.80}")


def vector(name: str, value: Sequence[float], length: int) -> tuple[float, ...]:
    """That many finite numbers, or ValueError with their name."""
    try:
        numbers = tuple(value)
    except TypeError:
        raise ValueError(f"{name} must be {length} numbers, not {value!r}") from None
    if len(numbers) != length:
        raise ValueError(f"{name} must be {length} numbers, not {value!r}")
    return tuple(finite(name, number) for number in numbers)
