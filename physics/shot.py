"""A shot: the five numbers that the thesis's boxes ask for, and one for balls that jump."""

from collections.abc import Iterable
from dataclasses import asdict, dataclass, fields
from math import copysign
from operator import attrgetter
from typing import Any

from .checks import finite, keep, positive
from .kernel import elementary

UNITS = {
    "speed": "m/s", "angle": "° anticlockwise from +x", "follow": "m/s, + follow, − draw",
    "masse": "m/s, + curves right, − left", "side": "m/s, + right english, − left",
    "climb": "m/s upward",
}  # fmt: skip


def direction(degrees: float) -> complex:
    """The unit vector at an angle in degrees: the same bits on every machine, within one unit in
    the last place, and of exact symmetry; NaN for an angle that is not finite."""
    vector: complex = elementary.direction(degrees)
    return vector


def heading(vector: complex) -> float:
    """The angle at which a vector points, degrees from -180 to 180, 0 for none: the inverse of
    `direction`, within three units in the last place for lengths of 1e-150 to 1e150."""
    along, across = abs(vector.real), abs(vector.imag)
    steep = across > along
    if steep:
        along, across = across, along
    if along == 0.0:
        return 0.0
    slope = across / along
    guess = slope * (60.6 - 15.6 * slope)  # a quarter of a degree off at most: exact at 0 and 45
    near = direction(guess)
    off = (across * near.real - along * near.imag) / (along * near.real + across * near.imag)
    square = off * off
    angle = guess + off * (1.0 - square * (1.0 / 3.0 - 0.2 * square)) / elementary.RADIANS
    angle = 90.0 - angle if steep else angle
    return copysign(180.0 - angle if vector.real < 0.0 else angle, vector.imag)


@dataclass(frozen=True, slots=True)
class Shot:
    """What the cue gives the ball; spins are surface speeds.

    speed: V, m/s.
    angle: degrees, anticlockwise from +x.
    follow: Wx·R, m/s, about the horizontal axis left of the direction of travel: + runs on after a
    hit, - draws back.
    masse: Wy·R, m/s, about the direction of travel: + curves to the right, - to the left.
    side: Wz·R, m/s, about the vertical: + anticlockwise from above, which players call right
    english (the tip right of the centre, the ball leaves the far cushion to the right), - left
    english.
    climb: velocity upward, m/s; downward, the ball bounces off the cloth.
    ValueError unless all are finite and the speed is above zero.
    """

    speed: float
    angle: float = 0.0
    follow: float = 0.0
    masse: float = 0.0
    side: float = 0.0
    climb: float = 0.0

    def __post_init__(self) -> None:
        keep(self, positive, "speed")
        keep(self, finite, "angle", "follow", "masse", "side", "climb")

    def __repr__(self) -> str:
        given = [f"{name}={value!r}" for name, value in asdict(self).items() if value]
        return f"Shot({', '.join(given)})"

    def _repr_html_(self) -> str:
        from .markup import table

        rows = [(name, value, UNITS[name]) for name, value in asdict(self).items() if value]
        return table(("Shot", "", ""), rows)

    def velocity(self) -> complex:
        """m/s, in the plane of the table."""
        return self.motion()[0]

    def roll(self) -> complex:
        """The velocity at which the ball would roll with this spin, -i R ω, m/s."""
        return self.motion()[1]

    def motion(self) -> tuple[complex, complex]:
        """(velocity, roll)."""
        along = direction(self.angle)
        return self.speed * along, complex(self.follow, -self.masse) * along


NUMBERS = tuple(field.name for field in fields(Shot))
_numbers = attrgetter(*NUMBERS)


def rows(shots: Iterable[Any]) -> list[Any]:
    """The numbers of each shot; what is no Shot, but a row already, stays as it is."""
    return [_numbers(shot) if isinstance(shot, Shot) else shot for shot in shots]
