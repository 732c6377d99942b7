"""Numbers that carry their derivatives: the kernel, run on them, differentiates itself.

A `Dual` behaves as its value, bit for bit, and takes its slope along by the rules of calculus.
Comparisons look at the value: so the slope is that of the branch taken.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from types import ModuleType
from typing import Any

from physics.binding import load
from physics.kernel import elementary
from physics.kernel import subset as plain

NAME = "physics.dual_kernel"
SLOPES: dict[str, Callable[[float, Any], Any]] = {  # of the elementary functions, at x and f(x)
    "direction": lambda x, y: 1j * elementary.RADIANS * y,
    "exp": lambda x, y: y,
}
STEP = 1e-3  # of the size of its arguments: how far apart a custom law is probed


class Dual:
    """value: a real or complex number; slope: its derivatives, a numpy array."""

    __slots__ = ("slope", "value")
    __array_ufunc__ = None  # numpy leaves the arithmetic to us
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, value: Any, slope: Any) -> None:
        self.value, self.slope = value, slope

    def __repr__(self) -> str:
        return f"Dual({self.value!r}, {self.slope!r})"

    def __add__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.value + other.value, self.slope + other.slope)
        return Dual(self.value + other, self.slope)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.value - other.value, self.slope - other.slope)
        return Dual(self.value - other, self.slope)

    def __rsub__(self, other: Any) -> Dual:
        return Dual(other - self.value, -self.slope)

    def __neg__(self) -> Dual:
        return Dual(-self.value, -self.slope)

    def __abs__(self) -> Dual:
        return -self if self.value < 0.0 else self

    def __mul__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            slope = other.value * self.slope + self.value * other.slope
            return Dual(self.value * other.value, slope)
        return Dual(self.value * other, other * self.slope)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            ratio = self.value / other.value
            return Dual(ratio, (self.slope - ratio * other.slope) / other.value)
        return Dual(self.value / other, self.slope / other)

    def __rtruediv__(self, other: Any) -> Dual:
        ratio = other / self.value
        return Dual(ratio, -ratio / self.value * self.slope)

    @property
    def real(self) -> Dual:
        return Dual(self.value.real, self.slope.real)

    @property
    def imag(self) -> Dual:
        return Dual(self.value.imag, self.slope.imag)

    def conjugate(self) -> Dual:
        return Dual(self.value.conjugate(), self.slope.conjugate())

    def __int__(self) -> int:
        return int(self.value)

    def __lt__(self, other: Any) -> bool:
        return bool(self.value < value(other))

    def __le__(self, other: Any) -> bool:
        return bool(self.value <= value(other))

    def __gt__(self, other: Any) -> bool:
        return bool(self.value > value(other))

    def __ge__(self, other: Any) -> bool:
        return bool(self.value >= value(other))

    def __eq__(self, other: object) -> bool:
        """Equal for all shots near by: a zero that is about to change is not zero."""
        if self is other:
            return True
        difference = self - other
        return bool(difference.value == 0.0 and not difference.slope.any())


def value(x: Any) -> Any:
    """The number itself, whether or not it carries a slope."""
    return x.value if isinstance(x, Dual) else x


def slope(x: Any, inputs: int) -> Any:
    """Its derivatives: zeros, (inputs,), for a plain number."""
    if isinstance(x, Dual):
        return x.slope
    import numpy as np

    return np.zeros(inputs)


def smooth(function: Callable[[float], Any], derivative: Callable[[float, Any], Any]) -> Any:
    """A function of the kernel's subset, of plain and of dual numbers; derivative(x, f(x))."""

    def extended(x: Any) -> Any:
        if not isinstance(x, Dual):
            return function(x)
        y = function(x.value)
        return Dual(y, derivative(x.value, y) * x.slope)

    return extended


def complex_number(x: Any, y: Any) -> Any:
    """x + iy, of plain or of dual numbers."""
    number = complex(value(x), value(y))
    if not isinstance(x, Dual) and not isinstance(y, Dual):
        return number
    rise = x.slope if isinstance(x, Dual) else 0.0
    return Dual(number, rise + 1j * y.slope if isinstance(y, Dual) else rise + 0j)


def probed(law: Callable[..., tuple[Any, ...]], *arguments: Any) -> tuple[Any, ...]:
    """law(*arguments) for a law that knows only plain numbers: its slopes by differences.

    Fourth order: about 1e-11 of the slope, if the law has no kink within `STEP`.
    """
    at = [value(x) for x in arguments]
    inputs = next((len(x.slope) for x in arguments if isinstance(x, Dual)), 0)
    step = STEP * max(abs(x) for x in at)
    results = law(*at)
    slopes = [slope(0.0, inputs) for _ in results]
    for k, x in enumerate(arguments):
        for unit, change in ((1.0, slope(x, inputs).real), (1j, slope(x, inputs).imag)):
            if not change.any():
                continue
            a, b, c, d = (
                law(*at[:k], at[k] + n * unit * step, *at[k + 1 :]) for n in (-2, -1, 1, 2)
            )
            for m in range(len(results)):
                rate = (8.0 * (c[m] - b[m]) - (d[m] - a[m])) / (12.0 * step)
                slopes[m] = slopes[m] + rate * change
    return tuple(map(Dual, results, slopes))


def _custom_cushion(v: Any, roll: Any, side: Any, rule: Any) -> Any:
    return probed(rule.function, v, roll, side)


def _custom_ball(v: Any, roll: Any, side: Any, mass: float, rule: Any) -> Any:
    return probed(lambda *contact: rule.function(*contact, mass), v, roll, side)


@cache
def kernel() -> ModuleType:
    """The kernel package on dual numbers."""
    subset = ModuleType(f"{NAME}.subset")
    vars(subset).update(vars(plain))
    vars(subset).update(
        # a length of zero has no slope: there only its value may matter
        sqrt=smooth(math.sqrt, lambda x, y: 0.5 / y if y > 0.0 else math.nan),
        elementary=lambda function: smooth(function, SLOPES[function.__name__]),
        complex=complex_number,
        custom_cushion=_custom_cushion,
        custom_ball=_custom_ball,
    )
    return load(NAME, subset)
