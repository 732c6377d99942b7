"""A ball at many moments, as arrays: the polynomials of its legs, evaluated at once."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from .checks import array
from .kernel.kinds import AIRBORNE, PHASE_NAMES, ROLLING
from .kernel.leg import travelled

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]

# where a leg, as the log keeps it, has what
EPOCH, SINCE, POSITION, VELOCITY, ACCELERATION, ROLL, SIDE, PHASE, RADIUS, FADE = range(10)
HEIGHT, CLIMB, FALL = 10, 11, 12


class Motion(NamedTuple):
    """A ball at T moments: what a State has, in arrays.

    position: (T, 2), m.
    velocity: (T, 2), m/s.
    spin: (T, 3), rad/s.
    height: (T,) above the cloth, m.
    climb: (T,) velocity upward, m/s.
    phase: (T,), as `Ball.phase` has it.
    """

    position: "Array"
    velocity: "Array"
    spin: "Array"
    height: "Array"
    climb: "Array"
    phase: "npt.NDArray[Any]"

    @property
    def speed(self) -> "Array":
        """(T,) over the table, m/s."""
        import numpy as np

        speed: Array = np.sqrt((self.velocity**2).sum(axis=1))
        return speed

    @property
    def heading(self) -> "Array":
        """(T,) where it moves to, degrees anticlockwise from +x; 0 where it does not move."""
        import numpy as np

        heading: Array = np.degrees(np.arctan2(self.velocity[:, 1], self.velocity[:, 0]))
        return heading

    def __repr__(self) -> str:
        return f"<Motion of a ball at {len(self.height)} moments>"


def moments(name: str, times: Any) -> "Array":
    """(T,) s, or ValueError."""
    import numpy as np

    found = array(name, times)
    if found.ndim != 1 or not np.isfinite(found).all():
        raise ValueError(f"{name} must be a row of finite numbers, not {times!r:.80}")
    return found


class Course:
    """The legs of a ball at T moments, as arrays."""

    def __init__(self, legs: Sequence[tuple[Any, ...]], times: "Array") -> None:
        import numpy as np

        begins = np.array([leg[EPOCH] + leg[SINCE] for leg in legs])
        self.leg = np.maximum(np.searchsorted(begins, times, side="right") - 1, 0)
        self.t = np.maximum(times - begins[self.leg], 0.0)
        self.legs = legs

    def __getitem__(self, column: int) -> Any:
        """(T,): this number of the leg at each moment."""
        import numpy as np

        return np.array([leg[column] for leg in self.legs])[self.leg]

    def place(self) -> Any:
        """(T,) complex, m."""
        return travelled(self[POSITION], self[VELOCITY], self[ACCELERATION], self.t)

    def height(self) -> Any:
        """(T,) m; below zero off the table."""
        return travelled(self[HEIGHT], self[CLIMB], -self[FALL], self.t)


def motion(legs: Sequence[tuple[Any, ...]], times: "Array") -> Motion:
    """The ball with these legs, as the log keeps them, at those times, s."""
    import numpy as np

    at = Course(legs, times)
    t, phase, radius, side = at.t, at[PHASE], at[RADIUS], at[SIDE]
    gain = t * at[ACCELERATION]
    roll = (at[ROLL] + np.where(phase == ROLLING, gain, -2.5 * gain)) / radius
    spun = np.where(phase == AIRBORNE, 0.0, t * radius * at[FADE])
    turn = np.copysign(np.maximum(np.abs(side) - spun, 0.0), side) / radius
    place, velocity = at.place(), at[VELOCITY] + gain
    return Motion(
        np.stack((place.real, place.imag), axis=1),
        np.stack((velocity.real, velocity.imag), axis=1),
        np.stack((0.0 - roll.imag, 0.0 + roll.real, 0.0 + turn), axis=1),
        np.maximum(at.height(), 0.0),
        at[CLIMB] - t * at[FALL],
        np.array([PHASE_NAMES[number] for number in phase.tolist()]),
    )
