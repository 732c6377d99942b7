"""An angle corrected by the engine: shots are played until one does what geometry meant."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise
from math import inf, nan
from typing import NamedTuple

from physics.kernel.motion import length
from physics.log import Event, Leg
from physics.shot import Shot, direction, heading
from physics.world import World

FAN = 12.0  # degrees: how far from the guess is looked
FINE, COARSE = 0.05, 0.25  # degrees: how finely, within a degree and beyond
ROUNDS = 60  # of the search between two angles: it needs about eight
HALVINGS = 60  # of a leg, for the moment at which it passes a place
LONGEST = 60.0  # s that a shot is played for: on ice, balls never rest
SHORT = 0.1  # m before the place a path may end: at the rim of a pocket, or at a cushion
CONTACTS = ("ball", "cushion", "off", "pocket")


class Wanted(NamedTuple):
    """What a shot shall do.

    ball, other: the ball meets the other one, and no third before.
    line: degrees: where the other leaves to, if no place is given.
    walls: that the ball meets before, in their order.
    rails: that the other meets after, in their order.
    place: (x, y), m, that the other then comes over.
    """

    ball: str
    other: str
    line: float
    walls: tuple[str, ...] = ()
    rails: tuple[str, ...] = ()
    place: tuple[float, float] | None = None

    @property
    def enough(self) -> float:
        """A miss that is none: degrees, or m beside the place."""
        return 1e-6 if self.place is None else 1e-9

    def miss(self, world: World) -> tuple[float, bool]:
        """How far left of where it was to go the other ball has gone in that world's shot: degrees,
        or m beside the place, NaN if they have not met so; and if it has come as far as that."""
        contacts = [event for event in world.log if event.kind in CONTACTS]
        hit = self._hit(contacts)
        if hit is None:
            return nan, False
        if self.place is None:
            leaves = complex(*contacts[hit].after[self.other].velocity)
            return heading(leaves * direction(self.line).conjugate()), True
        mine = [event for event in contacts[hit + 1 :] if self.other in event.balls]
        turns, rest = mine[: len(self.rails)], mine[len(self.rails) :]
        if tuple(event.wall for event in turns) != self.rails:
            return nan, False
        begins = (turns[-1] if turns else contacts[hit]).time
        return _beside(
            complex(*self.place), world.log.legs(self.other), begins, rest[0].time if rest else inf
        )

    def _hit(self, contacts: list[Event]) -> int | None:
        """The number of the contact in which they meet, if the ball met what it should before."""
        met: list[str | None] = []
        for k, event in enumerate(contacts):
            if {*event.balls} == {self.ball, self.other}:
                return k if tuple(met) == self.walls else None
            if event.balls != (self.ball,):
                break
            met.append(event.wall)
        return None


def _beside(place: complex, legs: list[Leg], begins: float, ends: float) -> tuple[float, bool]:
    """How far left of the place a ball passes on its way between those times, m, or would pass if
    it went on; and does it come there?"""
    miss = nan
    path = [leg for leg in legs if begins <= leg.time < ends and leg.velocity]
    for leg, after in zip(path, [*path[1:], None], strict=True):
        last = ends if after is None else after.time
        if last == inf:  # it comes to rest
            last = leg.time + float(length(leg.velocity) / length(leg.acceleration))
        early, late = 0.0, last - leg.time
        off = _ahead(leg, late, place)
        miss = -off.imag
        if off.real <= 0.0:
            for _ in range(HALVINGS):
                middle = 0.5 * (early + late)
                ahead = _ahead(leg, middle, place).real > 0.0
                early, late = (middle, late) if ahead else (early, middle)
            return -_ahead(leg, late, place).imag, True
    return miss, bool(path) and off.real < SHORT


def _ahead(leg: Leg, t: float, place: complex) -> complex:
    """The place as seen from the ball t seconds into its leg: ahead + i left, m."""
    velocity = leg.velocity + t * leg.acceleration
    speed = float(length(velocity))
    way = velocity / speed if speed > 0.0 else leg.velocity / float(length(leg.velocity))
    return (place - leg.place(t)) * way.conjugate()


def refined(world: World, shot: Shot, guess: float, wanted: Wanted) -> Shot:
    """The shot at the angle near the guess, degrees, that does what is wanted."""

    world.plan()

    def miss(angle: float) -> tuple[float, bool]:
        after = world.fork(world.log.fresh())
        after.strike(wanted.ball, replace(shot, angle=angle))
        after.run(after.time + LONGEST)
        return wanted.miss(after)

    for low, high in _brackets(lambda angle: miss(angle)[0], guess):
        angle = _root(lambda angle: miss(angle)[0], low, high, wanted.enough)
        left, comes = miss(angle)
        if comes and abs(left) <= wanted.enough:
            return replace(shot, angle=angle)
    raise ValueError(
        f"no angle within {FAN:g}° of {guess:.6g}° has {wanted.ball!r} send {wanted.other!r} there"
    )


def _brackets(miss: Callable[[float], float], guess: float) -> Iterator[tuple[float, float]]:
    """Neighbouring angles, nearest to the guess first, with a miss on either side."""
    before = [miss(guess)] * 2
    near = [k * FINE for k in range(round(1.0 / FINE))]
    far = [1.0 + k * COARSE for k in range(round((FAN - 1.0) / COARSE) + 1)]
    for offset, further in pairwise((*near, *far)):
        for n, sign in enumerate((-1.0, 1.0)):
            found = miss(guess + sign * further)
            if before[n] * found <= 0.0:
                yield guess + sign * offset, guess + sign * further
            before[n] = found


def _root(miss: Callable[[float], float], low: float, high: float, enough: float) -> float:
    """An angle between the two at which no more is missed than that, if there is one (Illinois)."""
    kept, at_kept, angle, at = low, miss(low), high, miss(high)
    for _ in range(ROUNDS):
        if abs(at) <= enough or at_kept == at:
            break
        new = angle - at * (angle - kept) / (at - at_kept)
        found = miss(new)
        if found * at < 0.0:
            kept, at_kept = angle, at
        else:
            at_kept *= 0.5
        angle, at = new, found
    return angle
