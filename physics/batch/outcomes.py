"""What a batch returns: where balls come to rest, when, and what they met on the way."""

from __future__ import annotations

from functools import cache
from math import inf
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.kernel.notes import BALL_TOUCH, CUSHION_TOUCH, OFF_TOUCH, POCKET_TOUCH
from physics.log import Contact

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

KIND = {"ball": BALL_TOUCH, "cushion": CUSHION_TOUCH, "pocket": POCKET_TOUCH, "off": OFF_TOUCH}
NAME = {number: name for name, number in KIND.items()}


@cache
def contact_type() -> np.dtype[np.void]:
    """The type of the records of `Outcomes.contacts`."""
    import numpy as np

    fields = [("kind", "u1"), ("again", "?"), ("first", "i2"), ("second", "i2"), ("time", "f8")]
    return np.dtype(fields, align=True)


class Outcomes(NamedTuple):
    """What `simulate_many` returns, as arrays.

    positions: (shots, balls, 2) at rest, m; NaN for a ball that is in a pocket or off the table.
    times: (shots,) until rest, s.
    events: (shots,), how many there were.
    balls: their names, in the order of the second axis of positions.
    contacts: (shots, contacts) records of the first contacts of each shot, in order of time: what
    `Log.contacts` has.
      kind: 0 none, 1 ball, 2 cushion, 3 pocket, 4 off the table.
      again: true at a cushion which the ball has not left (by more than 1 mm) since they last
      touched, or since the shot began: rules do not count it.
      first: number of the ball.  second: of the other ball, or of the wall or pocket; below 0
      where a ball left through an opening.
      time: s, since the shot.
    dropped: (shots,), how many contacts there were after those.
    walls: the names of walls and pockets (None for those without), by number.
    """

    positions: npt.NDArray[np.float64]
    times: npt.NDArray[np.float64]
    events: npt.NDArray[np.int64]
    balls: tuple[str, ...]
    contacts: npt.NDArray[np.void]
    dropped: npt.NDArray[np.int64]
    walls: tuple[str | None, ...]

    @property
    def part(self) -> Part:
        """Its arrays alone."""
        return Part(*self[:3], *self[4:6])

    def log(self, shot: int) -> list[Contact]:
        """The contacts that were kept of a shot, for rules that read the log of one.

        `away` is 0 where the ball had not left the cushion, and else inf.
        """
        return [
            Contact(time, NAME[kind], *self._names(kind, first, second), 0.0 if again else inf)
            for kind, again, first, second, time in self.contacts[shot].tolist()
            if kind
        ]

    def _names(self, kind: int, first: int, second: int) -> tuple[tuple[str, ...], str | None]:
        if kind == BALL_TOUCH:
            return (self.balls[first], self.balls[second]), None
        return (self.balls[first],), self.walls[second] if second >= 0 else None


class Part(NamedTuple):
    """The arrays of some of the shots, as in `Outcomes`."""

    positions: Any
    times: Any
    events: Any
    contacts: Any
    dropped: Any

    @classmethod
    def room(cls, shots: int, balls: int, contacts: int) -> Part:
        """Room for so many, with no contacts yet."""
        import numpy as np

        return cls(
            np.empty((shots, balls, 2)), np.empty(shots), np.empty(shots, np.int64),
            np.zeros((shots, contacts), contact_type()), np.zeros(shots, np.int64),
        )  # fmt: skip

    def whole(self, balls: tuple[str, ...], walls: tuple[str | None, ...]) -> Outcomes:
        """The outcomes, with the names of balls and walls."""
        return Outcomes(*self[:3], balls, *self[3:], walls)

    def cut(self, piece: slice) -> Part:
        """The part of it for those shots, in the same memory."""
        return Part(*(column[piece] for column in self))

    def take(self, other: Part) -> None:
        """Take over the numbers of another."""
        for mine, its in zip(self, other, strict=True):
            mine[...] = its


def together(batches: list[Outcomes]) -> Outcomes:
    """One batch after the other of the same world, as one."""
    import numpy as np

    parts = zip(*(each.part for each in batches), strict=True)
    return Part(*map(np.concatenate, parts)).whole(batches[0].balls, batches[0].walls)
