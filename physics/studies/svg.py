"""A picture of a world as SVG text, for notebooks: a leg is a parabola, and so is a path of SVG."""

from collections.abc import Iterator
from html import escape

from physics.engines.engine import Movable
from physics.log import Leg
from physics.wall import Obstacle

from .grounds import FILLED, INK, NOSE, layers
from .plot import colours, extent

WIDTH = 720  # pixels
MILLI = 1000.0  # units of the picture in a metre


def picture(world: Movable) -> str:
    """The whole picture."""
    world.plan()
    return frame(world, "".join([*_drawn(world), *_discs(world)]))


def frame(world: Movable, inside: str) -> str:
    """An SVG of the table, with something on it."""
    west, east, south, north = extent(world)
    box = f"{_x(west)} {_y(north)} {_x(east - west)} {_x(north - south)}"
    height = round(WIDTH * (north - south) / (east - west))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}" width="{WIDTH}"'
        f' height="{height}" style="max-width:100%;height:auto">{_table(world)}{inside}</svg>'
    )


def _x(value: float) -> str:
    return f"{MILLI * value:.1f}".removesuffix(".0")


def _y(value: float) -> str:
    return _x(0.0 - value)  # down


def _points(corners: list[complex] | tuple[complex, ...]) -> str:
    return " ".join(f"{_x(p.real)},{_y(p.imag)}" for p in corners)


def _table(world: Movable) -> str:
    """Rails, cloth, and what stands on it."""
    polygons = "".join(
        f'<polygon points="{_points(corners)}" fill="{colour}" stroke="{edge}" stroke-width="4"/>'
        for colour, edge, corners in layers(world)
    )
    return polygons + "".join(map(_obstacle, world.walls))


def _obstacle(wall: Obstacle) -> str:
    """Of a line, nothing: the edge of the cloth shows it."""
    curve = wall.curve()
    if not curve:
        return ""
    fill = FILLED.get(wall.kind, "none")
    name = escape(wall.name or "")
    return (
        f'<polyline points="{_points(curve)}" fill="{fill}" stroke="{NOSE}" stroke-width="4">'
        f"<title>{name}</title></polyline>"
    )


def _drawn(world: Movable) -> Iterator[str]:
    """The ways that balls have gone."""
    for ball in world.balls:
        legs = world.log.legs(ball.name)
        ends = [*(leg.time for leg in legs[1:]), world.time]
        way = [_parabola(leg, end - leg.time) for leg, end in zip(legs, ends, strict=True)
               if leg.velocity]  # fmt: skip
        if way:
            body, dark = colours(world, ball.name)
            yield _path("".join(way), body if dark == INK else dark)


def _parabola(leg: Leg, t: float) -> str:
    """What the ball has gone on that leg in t seconds: the tangents at both ends meet halfway."""
    begin, bend, end = leg.position, leg.position + 0.5 * t * leg.velocity, leg.place(max(0.0, t))
    return "M{} {}Q{} {} {} {}".format(
        *(f(v) for p in (begin, bend, end) for f, v in ((_x, p.real), (_y, p.imag)))
    )


def _path(way: str, ink: str) -> str:
    return f'<path d="{way}" fill="none" stroke="{ink}" stroke-width="5" stroke-opacity="0.75"/>'


def _discs(world: Movable) -> list[str]:
    """Rings where balls began, and the balls where they are."""
    begun, here = [], []
    for ball in world.balls:
        body, dark = colours(world, ball.name)
        first = world.log.legs(ball.name)[0].position
        ring = f'r="{_x(ball.radius)}" stroke="{dark}" stroke-width="5"'
        if (first.real, first.imag) != ball.position:
            spot = f'cx="{_x(first.real)}" cy="{_y(first.imag)}"'
            begun.append(f'<circle {spot} {ring} fill="none"/>')
        if not ball.gone:
            x, y = ball.position
            here.append(
                f'<circle cx="{_x(x)}" cy="{_y(y)}" {ring} fill="{body}">'
                f"<title>{escape(str(ball.name))}</title></circle>"
            )
    return [*begun, *here]
