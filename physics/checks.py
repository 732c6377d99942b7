"""Numbers from outside: refused with their name when they are not what they should be."""

from collections.abc import Sequence
from math import isfinite


def finite(name: str, value: float) -> float:
    """The value as a float, or ValueError with its name."""
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name} must be a number, not {value!r}") from None
    if not isfinite(number):
        raise ValueError(f"{name} must be finite, not {value!r}")
    return number


def positive(name: str, value: float) -> float:
    number = finite(name, value)
    if number <= 0.0:
        raise ValueError(f"{name} must be above zero, not {value!r}")
    return number


def nonnegative(name: str, value: float) -> float:
    number = finite(name, value)
    if number < 0.0:
        raise ValueError(f"{name} must not be negative, not {value!r}")
    return number


def vector(name: str, value: Sequence[float], length: int) -> tuple[float, ...]:
    """So many finite numbers, or ValueError with their name."""
    try:
        numbers = tuple(value)
    except TypeError:
        raise ValueError(f"{name} must be {length} numbers, not {value!r}") from None
    if len(numbers) != length:
        raise ValueError(f"{name} must be {length} numbers, not {value!r}")
    return tuple(finite(name, number) for number in numbers)
