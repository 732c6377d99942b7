"""Custom laws: callables in the place of a law, and those of them that can be compiled."""

from collections.abc import Callable
from typing import Any, TypeVar

from .kernel.body import Rule

Law = TypeVar("Law", bound=Callable[..., Any])


class CustomRule(Rule):
    """A custom law, for the kernel."""

    __slots__ = ("function", "law")

    def __init__(self, rule: Rule, function: Callable[..., Any]) -> None:
        super().__init__(rule.kind, rule.restitution, rule.friction, rule.height, rule.level)
        self.function = self.law = function  # the first of them may be watched

    @property
    def interpreted(self) -> bool:
        """Is it for Python alone?"""
        return not getattr(self.law, "compiled", False)


def compiled(law: Law) -> Law:
    """Mark a custom law as one that numba can compile: then batches with it run compiled.

    Each law takes a fraction of a second to compile, once in a process; the kernel calls it by its
    address and is not compiled again. The digits are the same as long as the law only adds,
    multiplies, divides and takes square roots. In a compiled batch no one watches it: numbers that
    are not finite leave a ball at rest where it was, and energy gained is not told.
    ValueError for what is no function.

    >>> @compiled
    ... def felt(v, roll, side):
    ...     return complex(-v.real * 2 / 3, v.imag * 0.9), roll, side
    """
    try:
        law.compiled = True  # type: ignore[attr-defined]
    except AttributeError:
        raise ValueError(f"only a function can be marked as compiled, not {law!r}") from None
    return law
