"""A ball: a name and the kernel's record of it, shown through properties."""

from collections.abc import Sequence
from dataclasses import replace
from operator import attrgetter
from typing import Any, NamedTuple, Protocol, TypeVar

from .checks import finite, nonnegative, positive, sizable, vector
from .kernel.body import Body, Felt, twin
from .kernel.kinds import PHASES, Phase
from .kernel.lasting import NEVER, forget
from .kernel.leg import aloft, begin, carry, moved, place, risen
from .kernel.motion import STILL, length
from .kernel.tilt import touching_distance

DISTURBED = -1  # the phase of a ball that was changed and that no engine has looked at yet
RADIUS, MASS = 0.03275, 0.25  # m and kg, where nothing says otherwise
NOWHERE = Felt(0.0, 0.0, 0.0)


class Sized(Protocol):
    """What knows the size of its balls: a table."""

    @property
    def radius(self) -> float: ...
    @property
    def mass(self) -> float: ...


Kind = TypeVar("Kind", bound=Sized | None)


def a_table(thing: Kind) -> Kind:
    """It, or None; ValueError for what knows no size of balls, or one that no ball has."""
    size: tuple[Any, Any] = getattr(thing, "radius", None), getattr(thing, "mass", None)
    if thing is None:
        return thing
    if not all(isinstance(number, float) for number in size):
        raise ValueError(f"a world's table is a Table, not {thing!r}")
    positive("the radius of a table's balls", size[0])
    sizable("the mass of a table's balls", size[1])
    return thing


class _Open(NamedTuple):
    """What a ball in no world was given, and its last spin, rad/s: the rest is up to a table."""

    radius: bool
    mass: bool
    spin: tuple[float, ...] = (0.0, 0.0, 0.0)


class Placed(NamedTuple):
    """How a ball lies or moves, to the last digit; with a place alone, it lies still there.

    position: m, as a complex number.
    velocity: m/s, as a complex number.
    roll: -i R ω, m/s.
    side: R ω_z, m/s.
    height: m above the cloth; below zero, off the table.
    climb: velocity upward, m/s.
    """

    position: complex
    velocity: complex = 0j
    roll: complex = 0j
    side: float = 0.0
    height: float = 0.0
    climb: float = 0.0


_placed = attrgetter(*Placed._fields)


class Clock:
    """The moment that the balls of a world share, `now` seconds after `epoch`; and their cloth."""

    __slots__ = ("cloth", "disturbed", "epoch", "loose", "moved", "now")

    def __init__(self, cloth: Felt) -> None:
        self.epoch = 0.0
        self.now = 0.0
        self.cloth = cloth
        self.disturbed = True  # has a ball been placed or pushed?
        self.moved = True  # has one been placed where it might not fit?
        self.loose = False  # may balls overlap, because fixed steps have left them so?

    def copy(self) -> "Clock":
        clock = Clock.__new__(Clock)
        clock.assign(self)
        return clock

    def begin_epoch(self, bodies: Sequence[Body]) -> None:
        """Count time from now on: the same shot has the same digits, whenever it is played."""
        for body in bodies:
            if body.since != self.now:
                carry(body, self.now, self.cloth)
            body.since = 0.0
            if body.hopped != NEVER:
                forget(body)
        self.epoch, self.now = self.epoch + self.now, 0.0

    def settle(self, radius: float, first: bool) -> None:
        """One more ball is on the cloth: the smallest decides what counts as still."""
        still = STILL * radius
        if first or still < self.cloth.still:
            self.cloth = replace(self.cloth, still=still)

    def assign(self, other: "Clock") -> None:
        """Take over the moment and the cloth of another clock."""
        self.cloth, self.disturbed, self.epoch = other.cloth, other.disturbed, other.epoch
        self.loose, self.moved, self.now = other.loose, other.moved, other.now


class Alone(Clock):
    """That of a ball that is in no world yet; a copy that another process gets is one, too."""

    __slots__ = ()

    def __init__(self) -> None:
        super().__init__(NOWHERE)


class Ball:
    """A ball on the table.

    at and velocity are (x, y) in m and m/s, spin (wx, wy, wz) in rad/s, right-handed with z up (wz
    above zero is anticlockwise from above), radius in m, mass in kg. A ball without a radius or a
    mass takes that of the balls of its world's table when it is added: until then, and in a world
    without a table, 0.03275 m and 0.25 kg.
    position, velocity, spin, and for jumps height and climb can be read and assigned at any moment;
    the world takes it from there. ValueError, naming the ball and the value, for any not finite
    or not positive, and for what a ball that has left the table cannot take.
    """

    __slots__ = ("_body", "_clock", "_name", "_open", "put")

    def __init__(
        self,
        name: str,
        at: Sequence[float],
        velocity: Sequence[float] = (0.0, 0.0),
        spin: Sequence[float] = (0.0, 0.0, 0.0),
        radius: float | None = None,
        mass: float | None = None,
    ) -> None:
        self._name = name
        self.put = True
        """Has it been placed since its world last checked that all fits?"""
        self._clock: Clock = Alone()
        given = radius is not None, mass is not None
        self._open = None if all(given) else _Open(*given)
        radius = RADIUS if radius is None else positive(f"ball {name!r}: radius", radius)
        mass = MASS if mass is None else sizable(f"ball {name!r}: mass", mass)
        self._body = Body(radius, mass, lift=radius)
        self.position = at
        self.velocity = velocity
        self.spin = spin

    def __repr__(self) -> str:
        return f"Ball({self.name!r}, at={self.position}, {self.phase})"

    @property
    def name(self) -> str:
        """The name by which its world knows it."""
        return self._name

    @property
    def radius(self) -> float:
        """Metres."""
        return self._body.radius

    @property
    def mass(self) -> float:
        """Kilograms."""
        return self._body.mass

    def touching_distance(self, other: "Ball") -> float:
        """m between the centres, over the table, of two balls of a world that touch on its cloth.

        2 √(r R) for radii r and R; for discs r + R, which is the same if they are equal.
        """
        return float(touching_distance(self._body, other._body))

    @property
    def position(self) -> tuple[float, float]:
        """(x, y) of the centre, metres."""
        p = place(self._body, self._clock.now - self._body.since)
        return p.real, p.imag

    @position.setter
    def position(self, value: Sequence[float]) -> None:
        x, y = vector(f"ball {self.name!r}: position", value, 2)
        body = self.disturb()
        body.position = complex(x, y)
        body.height = max(0.0, body.height)  # a ball off the table is put back on it
        self._clock.moved = self.put = True

    @property
    def velocity(self) -> tuple[float, float]:
        """(vx, vy), m/s."""
        _, v, _, _ = self._moved()
        return v.real, v.imag

    @velocity.setter
    def velocity(self, value: Sequence[float]) -> None:
        vx, vy = vector(f"ball {self.name!r}: velocity", value, 2)
        self.on_table().disturb().velocity = complex(vx, vy)

    @property
    def height(self) -> float:
        """How far its lowest point is above the cloth, m."""
        return float(max(0.0, risen(self._body, self._clock.now - self._body.since)[0]))

    @height.setter
    def height(self, value: float) -> None:
        height = nonnegative(f"ball {self.name!r}: height", value)
        self.on_table().disturb().height = height
        self._clock.moved = self.put = True

    @property
    def climb(self) -> float:
        """Velocity upward, m/s.  Downward on the cloth, it bounces."""
        return float(risen(self._body, self._clock.now - self._body.since)[1])

    @climb.setter
    def climb(self, value: float) -> None:
        climb = finite(f"ball {self.name!r}: climb", value)
        self.on_table().disturb().climb = climb

    def _moved(self) -> Any:
        """Position, velocity, roll and side as they are now."""
        return moved(self._body, self._clock.now - self._body.since, self._clock.cloth.fade)

    def on_table(self) -> "Ball":
        """The ball; ValueError if it has left the table."""
        if self._body.height < 0.0:
            raise ValueError(f"{self!r} has left the table: give it a position first")
        return self

    @property
    def spin(self) -> tuple[float, float, float]:
        """(wx, wy, wz), rad/s."""
        r, (_, _, roll, side) = self._body.radius, self._moved()
        return 0.0 - roll.imag / r, 0.0 + roll.real / r, 0.0 + side / r  # no zero shows a sign

    @spin.setter
    def spin(self, value: Sequence[float]) -> None:
        wx, wy, wz = vector(f"ball {self.name!r}: spin", value, 3)
        body = self.on_table().disturb()
        body.roll, body.side = complex(wy, -wx) * body.radius, wz * body.radius
        if self._open is not None:
            self._open = _Open(*self._open[:2], (wx, wy, wz))

    @property
    def phase(self) -> str:
        """ "sliding", "rolling" or "resting"; a ball that only spins on the spot rests.

        In flight "airborne"; "off" when it has left the table over a cushion or through a gap.

        Assigning "rolling" gives the ball the spin of its velocity; "resting" stops it, but for its
        spin about the vertical; "sliding" is refused if its velocity and spin agree, and all three
        if the ball is not on the cloth.
        """
        return self._does().name

    @phase.setter
    def phase(self, value: str) -> None:
        if value not in ("resting", "rolling", "sliding"):
            known = "resting, rolling, sliding"
            raise ValueError(f"ball {self.name!r}: phase must be one of {known}, not {value!r}")
        if not self.on_cloth:
            raise ValueError(f"ball {self.name!r}: phase: it is {self.phase}, and not on the cloth")
        if value == "sliding":
            if self.phase != value:
                raise ValueError(f"ball {self.name!r}: phase: it has no slip, so it cannot slide")
        elif value == "rolling":
            body = self.disturb()
            body.roll = body.velocity
        else:
            body = self.disturb()
            body.velocity = body.roll = 0j

    @property
    def lies(self) -> bool:
        """Does it stay where it is until something meets it?  It may still spin on the spot."""
        return self._does().lies

    @property
    def on_cloth(self) -> bool:
        """Is it neither in the air nor gone?"""
        return not aloft(self._body)

    @property
    def gone(self) -> bool:
        """Has it left the table?"""
        return self._body.height < 0.0

    def _does(self) -> Phase:
        body = self._body
        if body.phase == DISTURBED:
            body = twin(body)
            begin(body, self._clock.cloth)
        return PHASES[body.phase]

    @property
    def energy(self) -> float:
        """Of moving and turning, J, and what gravity has stored in it; 0 for one that is gone."""
        _, v, roll, side = self._moved()
        lift = 0.5 * self.climb**2 + self._clock.cloth.gravity * self.height
        turning = 0.2 * (length(roll) ** 2 + side * side)
        return 0.0 if self.gone else float(self.mass * (0.5 * length(v) ** 2 + lift + turning))

    @property
    def placed(self) -> Placed:
        """How it lies or moves now; assigning restores it, and nothing is checked."""
        body = twin(self._body)
        if body.phase != DISTURBED:
            carry(body, self._clock.now, self._clock.cloth)
        return Placed(*_placed(body))

    @placed.setter
    def placed(self, value: Placed) -> None:
        body = self.disturb()
        for name, number in zip(Placed._fields, value, strict=True):
            setattr(body, name, number)

    def disturb(self) -> Body:
        """The record at this very moment, to be changed: the engine will plan it again."""
        body = self._body
        if body.phase != DISTURBED:
            carry(body, self._clock.now, self._clock.cloth)
            body.acceleration = 0j
            body.fall = 0.0
            body.phase = DISTURBED
            body.trapped = 0
            forget(body)
        self._clock.disturbed = True
        return body

    @property
    def body(self) -> Body:
        """The kernel's record."""
        return self._body

    def join(self, clock: Clock, table: Sized | None) -> Body:
        """Read a world's clock from now on, and take what is open of the size from its table.

        ValueError if it is in a world already.
        """
        if not isinstance(self._clock, Alone):
            raise ValueError(f"ball {self.name!r} is in a world already")
        if table is not None and self._open is not None:
            self._fit(table, self._open)
        self._open, self._clock = None, clock
        self._body.since = clock.now
        return self._body

    def leave(self) -> None:
        """Be in no world, with the motion that it has now."""
        body = self.disturb()
        self._clock, self.put = Alone(), True
        body.since, body.lift = 0.0, body.radius

    def _fit(self, table: Sized, given: _Open) -> None:
        """A spin in rad/s stays that, and a ball that was made to roll still rolls."""
        body, (wx, wy, wz), before = self._body, given.spin, self._body.radius
        if not given.mass:
            body.mass = table.mass
        if not given.radius:
            body.radius = body.lift = radius = table.radius
            if body.roll == complex(wy, -wx) * before:
                body.roll = complex(wy, -wx) * radius
            if body.side == wz * before:
                body.side = wz * radius

    def twin(self, clock: Clock) -> "Ball":
        """The same ball, on the same leg, in another world."""
        ball = Ball.__new__(Ball)
        ball._name, ball._clock, ball._body = self._name, clock, twin(self._body)
        ball.put, ball._open = self.put, None
        return ball
