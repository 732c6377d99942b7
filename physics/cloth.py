"""The cloth: what it does to a ball that lies on it."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from math import fsum

from .checks import keep, nonnegative, positive, vector, whole
from .kernel.body import Band, Felt

Bands = tuple[tuple[float, float], ...]
# Gauss and Legendre's points and weights in a band: exact up to the ninth power of the speed
GAUSS = (
    (0.5, 0.28444444444444444), (0.23076534494715845, 0.23931433524968324),
    (0.7692346550528415, 0.23931433524968324), (0.04691007703066802, 0.11846344252809454),
    (0.953089922969332, 0.11846344252809454),
)  # fmt: skip
MOST = 10_000  # bands


@dataclass(frozen=True, slots=True)
class Cloth:
    """Coefficients of a cloth (docs/physics.md, "Cloth").

    slide: friction μ_s of a sliding ball.
    roll: resistance μ_r to a rolling one.
    spin_decay: loss of the spin about the vertical, α_z, rad/s².
    gravity: m/s².
    bounce: restitution of a ball that comes down on it, below 1.
    bands: pairs (speed in m/s, share), from (0, …) on: a ball that rolls faster than that speed has
    so many times the resistance `roll`; `rolling` makes them. Empty: it is the same at all speeds.
    ValueError unless each is finite and not negative, and the speeds of bands begin at 0 and grow.
    """

    slide: float = 0.2
    roll: float = 0.01
    spin_decay: float = 10.0
    gravity: float = 9.8
    bounce: float = 0.5
    bands: Bands = ()

    def __post_init__(self) -> None:
        keep(self, nonnegative, "slide", "roll", "spin_decay", "gravity", "bounce")
        if self.bounce >= 1.0:
            raise ValueError(f"Cloth.bounce must be below 1, not {self.bounce!r}")
        object.__setattr__(self, "bands", _bands(self.bands))

    def felt(self) -> Felt:
        """The decelerations that the kernel works with."""
        slide, roll = self.slide * self.gravity, self.roll * self.gravity
        return Felt(slide, roll, self.spin_decay, self.gravity, self.bounce, self.slide)

    def strips(self) -> list[Band]:
        """The bands as the kernel has them."""
        return [Band(*band) for band in self.bands]

    def rolling(
        self, law: Callable[[float], float], step: float = 0.1, fastest: float = 8.0
    ) -> "Cloth":
        """This cloth with a law of rolling of one's own.

        law: speed in m/s -> deceleration in m/s², above zero. It is called at speeds above zero.
        step, fastest: m/s; the law is followed in bands of that width, up to that speed.

        In a band the deceleration is constant, so events stay exact; it is chosen so that a ball
        runs exactly as far in it as by the law. The error between is in docs/accuracy.md, "Cloths".
        `roll` becomes the resistance at 1 m/s, and scales all bands.
        ValueError for what is no law or not above zero somewhere, or for too many bands.
        """
        if not callable(law):
            raise ValueError(f"rolling: law is called with m/s and returns m/s², not {law!r:.60}")
        step, fastest = positive("rolling: step", step), positive("rolling: fastest", fastest)
        count = whole("rolling: fastest / step", round(fastest / step), 1, MOST)
        gravity = positive("rolling: Cloth.gravity", self.gravity)
        one = positive("rolling: law(1.0)", law(1.0))
        edges = [step * k for k in range(count + 1)]
        found = [(low, _even(law, low, high) / one) for low, high in pairwise(edges)]
        return replace(self, roll=one / gravity, bands=tuple(found))


def _even(law: Callable[[float], float], low: float, high: float) -> float:
    """The constant deceleration with which a ball runs as far between those speeds."""
    wide, way = high - low, []
    for at, weight in GAUSS:
        speed = low + at * wide
        loss = positive(f"rolling: law({speed:.6g})", law(speed))
        way.append(weight * wide * speed / loss)
    return 0.5 * wide * (low + high) / fsum(way)


def _bands(given: Bands) -> Bands:
    """The same as plain numbers, or ValueError."""
    try:
        found = tuple((s, x) for s, x in (vector("Cloth.bands", band, 2) for band in given))
    except TypeError:
        raise ValueError(f"Cloth.bands must be pairs (speed, share), not {given!r:.60}") from None
    for speed, share in found:
        nonnegative("Cloth.bands: speed", speed)
        nonnegative("Cloth.bands: share", share)
    speeds = [speed for speed, _ in found]
    if found and (speeds[0] != 0.0 or any(b <= a for a, b in pairwise(speeds))):
        raise ValueError(f"Cloth.bands: speeds must begin at 0 and grow, not {speeds!r:.60}")
    return found


def a_cloth(thing: Cloth) -> Cloth:
    """The cloth, or ValueError if the thing is not one."""
    if not isinstance(thing, Cloth):
        raise ValueError(f"a world's cloth is a Cloth, not {thing!r}")
    return thing
