"""Custom laws are watched: what they must not do is refused, and the run undone."""

import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from math import hypot, inf, isfinite
from operator import attrgetter
from typing import Any

from .ball import Ball
from .engines.engine import Movable
from .engines.exact import EventBudgetError
from .kernel.body import Body, twin_grid
from .kernel.leg import aloft
from .kernel.motion import length
from .kernel.tilt import levelled
from .laws import CustomRule

ROUNDING = 1e-9  # of the energy: what a law may gain by rounding
ALIKE = 1e-9  # m/s: how well a ball must fit what a law was given, to be named

_values = attrgetter(*Body.__slots__)


class EnergyGainWarning(UserWarning):
    """A custom law has made energy; given once for a world, its copies and the law."""


@dataclass(slots=True)
class Watch:
    """A custom law's stand-in, with the same numbers in and out, but checked.

    law: the custom law.
    balls: those of the world.
    asking: where the world looks for the law that is being asked.
    warned: the laws of which it is known that they gain energy.
    """

    law: Callable[..., Any]
    parting: float
    balls: list[Ball]
    asking: list[str]
    warned: list[object]

    def call(self, what: str, *given: Any) -> Any:
        """What the law returns; ValueError if it changes a ball behind the engine's back."""
        before = [_values(ball.body) for ball in self.balls]
        spots = [ball.body.position for ball in self.balls]
        self.asking.append(what)
        try:
            said = self.law(*given)
        except Exception as error:
            error.add_note(f"raised by {what}")
            raise
        finally:
            self.asking.pop()
        for ball, was, spot in zip(self.balls, before, spots, strict=False):
            if _values(ball.body) != was:
                raise ValueError(
                    f"{what} changed {ball!r}, which was at {(spot.real, spot.imag)}: a law only"
                    " returns what becomes of a hit"
                )
        return said

    def warn(self, what: str, gained: float, share: float) -> None:
        """Once for this law."""
        if any(law is self.law for law in self.warned):
            return
        self.warned.append(self.law)
        warnings.warn(
            f"{what} gained {gained:.3g} J, {100.0 * share:.3g} % of the energy it was given",
            EnergyGainWarning,
            stacklevel=2,
        )


class CushionWatch(Watch):
    """A custom cushion law."""

    __slots__ = ()

    def __call__(self, v: complex, roll: complex, side: float) -> tuple[complex, complex, float]:
        ball = self._find(v, side)
        which = f"ball {ball.name!r}" if ball else "a ball"
        what = f"the cushion law {_name(self.law)}, at {which},"
        said = self.call(what, v, roll, side)
        new_v, new_roll, new_side = numbers = _numbers(what, said, (complex, complex, float))
        if new_v.real < -ROUNDING * length(v):
            raise ValueError(f"{what} lets it go on into the wall: it returned v = {new_v!r}")
        had, has = _energy(v, roll, side), _energy(*numbers)
        if has > had * (1.0 + ROUNDING):
            self.warn(what, (has - had) * (ball.mass if ball else 1.0), has / had - 1.0)
        # touching bodies always separate; otherwise contacts could last forever
        return complex(max(new_v.real, self.parting), new_v.imag), new_roll, new_side

    def _find(self, v: complex, side: float) -> Ball | None:
        """The ball that the law was asked about, found by its motion."""

        def unlike(ball: Ball) -> float:
            return float(abs(length(ball.body.velocity) - length(v)) + abs(ball.body.side - side))

        return min((b for b in self.balls if unlike(b) < ALIKE), key=unlike, default=None)


class BallWatch(Watch):
    """A custom ball law."""

    __slots__ = ()

    def __call__(
        self, v: complex, roll: complex, side: float, mass: float
    ) -> tuple[float, complex]:
        what = f"the ball law {_name(self.law)}, at {self._find(v, side)},"
        said = self.call(what, v, roll, side, mass)
        push, rub = _numbers(what, said, (float, complex))
        if mass * v.real - push > ROUNDING * mass * length(v):
            raise ValueError(
                f"{what} returned push = {push!r} N s; balls that close with {v.real!r} m/s need"
                f" {mass * v.real!r} N s to part"
            )
        gained = _gain(v, roll, side, mass, push, rub)
        had = 0.5 * mass * length(v) ** 2 + 0.1 * mass * (length(roll) ** 2 + side * side)
        if gained > had * ROUNDING:
            self.warn(what, gained, gained / had)
        return max(push, mass * (v.real + self.parting)), rub

    def _find(self, v: complex, side: float) -> str:
        """The balls that the law was asked about, found by their motion and places."""
        found, names = ALIKE, "two balls"
        for i, one in enumerate(self.balls):
            for other in self.balls[i + 1 :]:
                unlike = _unlike(one.body, other.body, v.real, side)
                if unlike < found:
                    found, names = unlike, f"balls {one.name!r} and {other.name!r}"
        return names


def _unlike(a: Body, b: Body, closing: float, side: float) -> float:
    """How far these two are from closing like that, m/s, and with such spin where it is given."""
    flies = aloft(a) or aloft(b)
    line = b.position - a.position
    rise = b.height - a.height + (b.lift - a.lift) if flies else 0.0
    far = hypot(line.real, line.imag, rise)
    if far > 1.1 * (a.radius + b.radius):
        return inf
    v = a.velocity - b.velocity
    level, upright = (line.conjugate() * v).real, rise * (a.climb - b.climb)
    turned = line.conjugate() / far * (a.roll + b.roll)
    other_spin = 0.0 if flies else abs(levelled(a, b, turned, a.side + b.side)[1] - side)
    return float(abs((level + upright) / far - closing) + other_spin)


def watch(rules: Sequence[Any], *world: Any) -> None:
    """Have the custom laws among these rules, of balls and then of cushions, watched, each once."""
    kinds: dict[int, tuple[Any, Any]] = {id(rule): (rule, CushionWatch) for rule in rules[1:]}
    for rule, kind in ((rules[0], BallWatch), *kinds.values()):
        if isinstance(rule, CustomRule):
            rule.function = kind(rule.function, rule.parting, *world)


def _name(law: object) -> str:
    return str(getattr(law, "__name__", None) or repr(law))


def _numbers(what: str, said: Any, kinds: tuple[type, ...]) -> Any:
    """As many finite numbers of these kinds, or ValueError."""
    try:
        values = tuple(_number(kind, value) for kind, value in zip(kinds, said, strict=True))
    except (TypeError, ValueError, OverflowError):
        values = ()
    if not values or not all(isfinite(z.real) and isfinite(z.imag) for z in values):
        wanted = ", ".join(kind.__name__ for kind in kinds)
        raise ValueError(f"{what} returned {said!r}; it must be finite numbers ({wanted})")
    return values


def _number(kind: type, value: Any) -> Any:
    """A complex number, or a real one; NumPy's complex numbers without imaginary part are real."""
    z = complex(value)
    if isinstance(value, str) or (kind is float and z.imag != 0.0):
        raise TypeError
    return z if kind is complex else z.real


def _energy(v: complex, roll: complex, side: float) -> float:
    """J/kg."""
    return float(0.5 * length(v) ** 2 + 0.2 * (length(roll) ** 2 + side * side))


def _gain(v: complex, roll: complex, side: float, mass: float, push: float, rub: complex) -> float:
    """Energy, J, that these impulses give two balls which have `mass` as their reduced mass."""
    moving = length(v - complex(push, -rub.real) / mass) ** 2 - length(v) ** 2
    turning = rub.real * side - rub.imag * roll.real + 1.25 * length(rub) ** 2 / mass
    return float(0.5 * mass * moving + turning)


@contextmanager
def undone(world: Movable) -> Iterator[None]:
    """If this fails, the world is as it was before, unless the event budget was exceeded."""
    scene, clock = world.scene, world.clock
    kept = scene._replace(meetings=scene.meetings[:], grid=twin_grid(scene.grid))
    bodies = [_values(body) for body in scene.balls]
    state = world.due, world.planned, world.allowed
    then, mark = clock.copy(), world.log.mark()
    try:
        yield
    except EventBudgetError:
        raise
    except BaseException:
        for body, values in zip(scene.balls, bodies, strict=False):
            for name, value in zip(Body.__slots__, values, strict=True):
                setattr(body, name, value)
        clock.assign(then)
        world.scene = kept
        world.due, world.planned, world.allowed = state
        world.log.rewind(mark)
        raise
