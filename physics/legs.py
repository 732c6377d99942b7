"""A ball between two events, and the speeds that change at one."""

from math import sqrt
from typing import NamedTuple

from .event import State
from .kernel.kinds import PHASE_NAMES
from .kernel.leg import moved, place, risen
from .kernel.motion import length


class Leg(NamedTuple):
    """Motion between two events, with constant acceleration.

    epoch, since: it begins at epoch + since, s.
    position, velocity, acceleration: as complex numbers, m, m/s, m/s².
    roll: -i R ω, m/s.
    side: R ω_z, m/s.
    phase: as in physics.kernel.motion.
    radius: of the ball, m.
    fade: loss of ω_z, rad/s².
    height, climb: above the cloth, m, and the velocity upward, m/s.
    fall: deceleration of the climb, m/s².
    lift: of the centre above the lowest point, m: the radius, or 0 for a disc.
    """

    epoch: float
    since: float
    position: complex
    velocity: complex
    acceleration: complex
    roll: complex
    side: float
    phase: int
    radius: float
    fade: float
    height: float = 0.0
    climb: float = 0.0
    fall: float = 0.0
    lift: float = 0.0

    def __repr__(self) -> str:
        p, v = self.position, self.velocity
        place, way = f"({p.real:.6g}, {p.imag:.6g}) m", f"({v.real:.4g}, {v.imag:.4g}) m/s"
        return f"<Leg from {self.time:.6g} s: {PHASE_NAMES[self.phase]}, {place}, {way}>"

    @property
    def time(self) -> float:
        """When it begins, seconds."""
        return self.epoch + self.since

    def after(self, t: float) -> "Leg":
        """The leg as it is t seconds on: the same motion, begun later."""
        position, velocity, roll, side = moved(self, t, self.fade)
        height, climb = risen(self, t)
        return self._replace(
            since=self.since + t, position=position, velocity=velocity, roll=roll, side=side,
            height=height, climb=climb,
        )  # fmt: skip

    def place(self, t: float) -> complex:
        """Where it is t seconds on."""
        return complex(place(self, t))

    def state(self) -> State:
        """Where it begins and how."""
        p, v, w, r = self.position, self.velocity, self.roll / self.radius, self.radius
        spin = 0.0 - w.imag, 0.0 + w.real, 0.0 + self.side / r  # no zero shows a sign
        height, phase = max(0.0, self.height), PHASE_NAMES[self.phase]
        return State((p.real, p.imag), (v.real, v.imag), spin, height, self.climb, phase)

    def energy(self, mass: float) -> float:
        """Kinetic energy of moving and turning, and what gravity has stored, J."""
        v, w, side = length(self.velocity), length(self.roll), self.side
        lift = 0.5 * self.climb * self.climb + self.fall * self.height
        return float(mass * (0.5 * v * v + lift + 0.2 * (w * w + side * side)))


def toward(a: Leg, b: Leg) -> tuple[complex, float]:
    """The direction between two centres: over the table, upward."""
    line, rise = b.position - a.position, b.height - a.height + (b.lift - a.lift)
    far = sqrt(line.real * line.real + line.imag * line.imag + rise * rise)
    return line / far, rise / far


def along(leg: Leg, normal: complex, rise: float) -> float:
    """The speed in that direction."""
    return (normal.conjugate() * leg.velocity).real + rise * leg.climb


def kick(before: Leg, after: Leg) -> float:
    """By how much the velocity has changed, m/s."""
    level, climb = length(after.velocity - before.velocity), after.climb - before.climb
    return sqrt(level * level + climb * climb)
