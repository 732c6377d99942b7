"""Where to aim: the angle that cuts a ball, sends it to a place, or finds it by the cushions.

All of it is geometry, as players do it in the head: the ghost ball (where the struck ball is when
they meet; for unequal radii r and R its centre is 2 √(r R) away, over the table), straight lines,
mirrored cushions, and an object ball that leaves along the line of centres. Throw, squirt, swerve
and what cushions do to angles are left out, and other balls are not looked at: `Aim.refined` plays
the shot and corrects the angle, or says that there is none.
"""

from collections.abc import Iterable, Sequence
from math import sqrt
from typing import NamedTuple

from physics.ball import Ball
from physics.checks import finite, vector
from physics.kernel.motion import length
from physics.room import called
from physics.shot import Shot, direction, heading
from physics.world import World

from .refining import Wanted, refined

__all__ = ["Aim", "at", "bank", "kick", "to"]

Point = tuple[float, float]
Line = tuple[complex, float]  # (conj(n) * p).real = d
RAILS = ("line", "segment")
NEAR = 1e-9  # m: how far a path may cut into a cushion that it passes, by rounding


class Aim(NamedTuple):
    """Where to aim a ball at another.

    ball, other: their names.
    angle: to shoot at, degrees, as in a Shot.
    cut: from the course at the hit to the line of centres, degrees; + sends the other ball to the
    left as the player sees it, by hitting it on the right; 0 is full, 90 just grazes.
    line: the direction of the line of centres, in which the other ball should leave, degrees.
    ghost: (x, y) of the ball when they meet, m.
    spots: (x, y) of the ball's centre, and then of the other's, at each cushion, m.
    walls, rails: which those are, for the ball and for the other ball.
    place: (x, y) where the other ball is sent, m, or None.
    """

    ball: str
    other: str
    angle: float
    cut: float
    line: float
    ghost: Point
    spots: tuple[Point, ...] = ()
    walls: tuple[str, ...] = ()
    rails: tuple[str, ...] = ()
    place: Point | None = None

    @property
    def eighths(self) -> float:
        """How thick the hit is: 8 is full, 4 a half ball, 0 grazes.

        8 (1 - |sin cut|): of balls of one size, so many eighths of the other's width are covered.
        """
        return 8.0 * (1.0 - abs(direction(self.cut).imag))

    def shot(
        self, speed: float, follow: float = 0.0, masse: float = 0.0, side: float = 0.0
    ) -> Shot:
        """The Shot there, of that speed and these spins, m/s."""
        return Shot(speed, self.angle, follow, masse, side)

    def refined(self, world: World, shot: Shot) -> Shot:
        """This shot with the angle at which the engine does what was meant: the other ball leaves
        along `line`, or, if it was sent to a place, comes over it.

        That has throw, swerve and the laws of the cushions in it, for this speed and spin. Within
        1e-6°, or 1e-9 m. ValueError if no angle within 12° does so: a ball is in the way, say, or
        the shot too soft.
        """
        return refined(
            world, shot, self.angle,
            Wanted(self.ball, self.other, self.line, self.walls, self.rails, self.place),
        )  # fmt: skip

    def __repr__(self) -> str:
        side = "right" if self.cut < 0.0 else "left"
        cut = f"cut {abs(self.cut):.4g}° to the {side}" if self.cut else "full"
        return f"<Aim of {self.ball} at {self.other}: {self.angle:.6g}°, {cut}>"


def at(
    world: World, ball: Ball | str, other: Ball | str, cut: float = 0.0,
    eighths: float | None = None,
) -> Aim:  # fmt: skip
    """Straight at the other ball.

    cut: degrees, + sends it to the player's left; see Aim.
    eighths: instead of a cut, how thick; below zero, it goes to the right.
    ValueError for what is not from -90 to 90 degrees or from -8 to 8 eighths, and for balls that
    touch.

    >>> from physics import Ball, simulate, tables
    >>> world = tables.pool_9ft()
    >>> white, red = world.add(Ball("white", at=(0, 0))), world.add(Ball("red", at=(0.5, 0)))
    >>> half = at(world, "white", "red", cut=30)
    >>> half
    <Aim of white at red: -3.27624°, cut 30° to the left>
    >>> round(half.eighths, 12)
    4.0
    >>> hit = simulate(world, white, half.shot(2.0, follow=2.0)).log.first("ball", "white", "red")
    >>> f"{hit.after['red'].heading - half.angle:.1f}°"  # balls are rough, and throw
    '29.4°'
    """
    return kick(world, ball, other, cut=cut, eighths=eighths)


def to(world: World, ball: Ball | str, other: Ball | str, place: Sequence[float] | str) -> Aim:
    """At the other ball, so that it goes to a place: (x, y) in m, or the name of a pocket.

    ValueError if it would have to be cut by 90° or more.
    """
    return bank(world, ball, other, place)


def kick(
    world: World, ball: Ball | str, other: Ball | str, *walls: str, cut: float = 0.0,
    eighths: float | None = None,
) -> Aim:  # fmt: skip
    """By these cushions, in their order, at the other ball; each is taken for a mirror.

    cut, eighths: as in `at`. ValueError, too, if that is no way on this table.
    """
    white, red = world.ball(ball), world.ball(other)
    lines = [_rail(world, name, white) for name in walls]
    turn = _thickness(eighths) if eighths is not None else finite("cut", cut)
    if not -90.0 < turn < 90.0:
        raise ValueError(f"cut must be between -90 and 90 degrees, not {cut!r}")
    centre = _mirrored(complex(*red.position), reversed(lines))
    flips = -1.0 if len(lines) % 2 else 1.0
    start, reach = complex(*white.position), white.touching_distance(red)
    course = _course(start, centre, reach, direction(flips * turn))
    image = centre - reach * course * direction(flips * turn)
    ghost, spots = _unfolded(world, white, start, image, lines, walls)
    last = ghost - (spots[-1] if spots else start)
    line = heading(last) + turn
    return Aim(
        white.name, red.name, heading(course), turn, line, _point(ghost),
        tuple(map(_point, spots)), tuple(walls),
    )  # fmt: skip


def bank(
    world: World, ball: Ball | str, other: Ball | str, place: Sequence[float] | str, *walls: str
) -> Aim:
    """At the other ball, so that it goes to a place by these cushions, in their order.

    Each cushion is taken for a mirror. place: (x, y) in m, or the name of a pocket. ValueError if
    that is no way on this table, or if the ball would have to be cut by 90° or more.
    """
    white, red = world.ball(ball), world.ball(other)
    lines = [_rail(world, name, red) for name in walls]
    end, start, red_at = _place(world, place), complex(*white.position), complex(*red.position)
    image = _mirrored(end, reversed(lines))
    way = _unit(image - red_at, f"{red.name!r} lies at {place!r} already")
    ghost = red_at - white.touching_distance(red) * way
    course = _unit(ghost - start, f"{white.name!r} and {red.name!r} touch")
    cut = heading(way * course.conjugate())
    if not -90.0 < cut < 90.0:
        raise ValueError(f"{red.name!r} would have to be cut by {cut:.4g}° to go there")
    _, spots = _unfolded(world, red, red_at, image, lines, walls)
    return Aim(
        white.name, red.name, heading(course), cut, heading(way), _point(ghost),
        tuple(map(_point, spots)), (), tuple(walls), _point(end),
    )  # fmt: skip


def _thickness(eighths: float) -> float:
    """The cut in degrees."""
    if not -8.0 <= finite("eighths", eighths) <= 8.0:
        raise ValueError(f"eighths must be from -8 to 8, not {eighths!r}")
    sine = 1.0 - abs(eighths) / 8.0
    cut = heading(complex(sqrt(1.0 - sine * sine), sine))
    return -cut if eighths < 0.0 else cut


def _course(start: complex, centre: complex, reach: float, cut: complex) -> complex:
    """The direction from the start in which a ball meets one at the centre with that cut."""
    line = centre - start
    far = float(length(line))
    if far <= reach:
        raise ValueError("the balls touch: there is no way between them to aim along")
    aside = reach * cut.imag / far  # of the centre, to the left of the course
    return line / far * complex(sqrt(1.0 - aside * aside), -aside)


def _rail(world: World, name: str, ball: Ball) -> Line:
    """The line on which the ball's centre is when it touches that cushion."""
    for wall in world.walls:
        if wall.name == name and wall.kind in RAILS:
            return wall.lines(ball.radius, 0.0)[0]
    known = ", ".join(f"{wall.name}" for wall in world.walls if wall.kind in RAILS)
    raise ValueError(f"there is no straight cushion {name!r} in this world, only {known}")


def _mirror(p: complex, line: Line) -> complex:
    normal, offset = line
    return p - 2.0 * ((normal.conjugate() * p).real - offset) * normal


def _mirrored(p: complex, lines: Iterable[Line]) -> complex:
    for line in lines:
        p = _mirror(p, line)
    return p


def _unfolded(
    world: World, ball: Ball, start: complex, image: complex, lines: Sequence[Line],
    names: Sequence[str],
) -> tuple[complex, list[complex]]:  # fmt: skip
    """Where the way to the image really ends, and where it turns; ValueError if it does not."""
    spots = []
    for (normal, offset), name in zip(lines, names, strict=True):
        ahead = (normal.conjugate() * start).real - offset
        behind = (normal.conjugate() * image).real - offset
        if ahead < 0.0 or behind >= 0.0:
            raise ValueError(f"mirrored, there is no way by the cushion {name!r} there")
        start += ahead / (ahead - behind) * (image - start)
        image = _mirror(image, (normal, offset))
        _insist_on_table(world, ball, start, name)
        spots.append(start)
    return image, spots


def _insist_on_table(world: World, ball: Ball, spot: complex, name: str) -> None:
    """ValueError if the ball cannot be there, touching that cushion."""
    for wall in world.walls:
        if wall.pushes and wall.distance(_point(spot)) < ball.radius - NEAR:
            raise ValueError(
                f"mirrored, the way meets the cushion {name!r} at {_short(spot)}, where"
                f" {called(wall)} is in the way"
            )
    rail = min(wall.distance(_point(spot)) for wall in world.walls if wall.name == name)
    if rail > ball.radius + NEAR:
        raise ValueError(f"mirrored, the way passes {name!r} at {_short(spot)}, beyond its end")


def _place(world: World, place: Sequence[float] | str) -> complex:
    if not isinstance(place, str):
        return complex(*vector("place", place, 2))
    pockets = {wall.name: wall.shape.centre for wall in world.walls if wall.kind == "pocket"}
    if place not in pockets:
        raise ValueError(f"there is no pocket {place!r}: there are {[*pockets] or 'none'}")
    return complex(pockets[place])


def _unit(way: complex, otherwise: str) -> complex:
    far = float(length(way))
    if far == 0.0:
        raise ValueError(otherwise)
    return way / far


def _point(p: complex) -> Point:
    return p.real, p.imag


def _short(p: complex) -> str:
    return f"({p.real:.4g}, {p.imag:.4g})"


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]
