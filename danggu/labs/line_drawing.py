"""Pictures for paper, as SVG: the ways of balls over a grid of 10 cm, and paper for a graph."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape
from math import ceil, floor, log10

from physics import Leg, World

from .shape import Figure
from .text import word

SPACE = 0.06  # m around what is drawn
SHAPE = (2.0, 4.5)  # width over height: at least, at most
GRID = 0.1  # m
SEEN = 12  # moments at which balls are drawn, at most
ALONG = 16  # points of a leg that bends
DASHES = ("", "24 12", "6 10")  # of the first world, the second and the third
INKS = {"white": "#333", "red": "#c1121f", "yellow": "#b8860b"}
FILLS = {"white": "#fff", "red": "#f28b82", "yellow": "#ffe08a"}
Box = tuple[float, float, float, float]


def picture(figure: Figure, language: str) -> str:
    """The ways of all balls, in all worlds; the balls as a lamp sees them that flashes.

    Balls that move on one line are drawn flash beneath flash: they would hide each other.
    """
    down = _down(figure)
    west, south, east, north = _box(figure, down)
    lines = "" if down else "".join(
        _way(world, name, dash) for world, dash in zip(figure, DASHES, strict=False)
        for name in world.log.names
    )  # fmt: skip
    grid, balls = _grid((west, south, east, north)), _balls(figure[0], down, language)
    inside = grid + _walls(figure[0]) + lines + balls
    view = f"{_mm(west)} {_mm(-north)} {_mm(east - west)} {_mm(north - south)}"
    return f'<svg xmlns="http://www.w3.org/2000/svg" class="ways" viewBox="{view}">{inside}</svg>'


def flash(world: World) -> float:
    """Seconds between the balls of a picture: a round number."""
    least = max(world.time - world.log.start, 1e-9) / SEEN
    power = 10.0 ** floor(log10(least))
    return next(round(k * power, 9) for k in (1, 2, 5, 10) if k * power >= least)


def paper(across: str, up: str) -> str:
    """Paper in millimetres with two axes, 16 by 8 cm."""
    lines = "".join(
        f'<path d="{_ruled(step)}" stroke="#8aa" stroke-width="{width}"/>'
        for step, width in ((1, 0.06), (5, 0.1), (10, 0.2))
    )
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" class="paper" viewBox="-6 -3 170 90">'
        f'{lines}<path d="M0 -2V80H163" stroke="#000" stroke-width="0.5" fill="none"/>'
        f'<text x="162" y="85.5" text-anchor="end" font-size="4">{across} →</text>'
        f'<text x="-2" y="0" transform="rotate(-90 -2 0)" text-anchor="end" font-size="4">{up} →'
        "</text></svg>"
    )


def _ruled(step: int) -> str:
    across = "".join(f"M0 {y}H160" for y in range(0, 81, step))
    return across + "".join(f"M{x} 0V80" for x in range(0, 161, step))


def _mm(metres: float) -> str:
    return f"{1000.0 * metres:.1f}"


def _spot(p: complex) -> str:
    return f"{_mm(p.real)} {_mm(-p.imag)}"


def _legs(world: World, name: str) -> Iterator[tuple[Leg, float]]:
    """Each leg, and how long it lasted."""
    legs = world.log.legs(name)
    ends = [*(leg.time for leg in legs[1:]), world.time]
    for leg, end in zip(legs, ends, strict=True):
        yield leg, max(0.0, end - leg.time)


def _points(world: World, name: str) -> list[complex]:
    """Along the way of a ball."""
    found: list[complex] = []
    for leg, lasts in _legs(world, name):
        count = ALONG if leg.acceleration else 1
        found += [leg.place(lasts * k / count) for k in range(count + 1)]
    return found


def _down(figure: Figure) -> float:
    """By how much each flash is drawn beneath the one before, m; 0 for balls in the plane."""
    world = figure[0]
    ways = [_points(world, ball.name) for ball in world.balls]
    on_a_line = len(ways) > 1 and all(p.imag == 0.0 for way in ways for p in way)
    return 2.6 * max(ball.radius for ball in world.balls) if on_a_line else 0.0


def _box(figure: Figure, down: float) -> Box:
    """Around all that balls have touched, no longer and no higher than a picture may be."""
    spots, space = [], SPACE
    for world in figure:
        for ball in world.balls:
            spots += _points(world, ball.name)
            space = max(space, 3.0 * ball.radius)  # for its name
    for wall in figure[0].walls:
        spots += wall.curve()
    spots.append(spots[0] - 1j * down * (len(_flashes(figure[0])) - 1))
    xs, ys = [p.real for p in spots], [p.imag for p in spots]
    west, east, south, north = min(xs), max(xs), min(ys), max(ys)
    wide, high = east - west + 2.0 * space, north - south + 2.0 * space
    least, most = SHAPE
    width, height = max(wide, least * high), max(high, wide / most)
    x, y = 0.5 * (west + east - width), 0.5 * (south + north - height)
    return x, y, x + width, y + height


def _grid(box: Box) -> str:
    west, south, east, north = box
    way = "".join(
        f"M{_mm(GRID * k)} {_mm(-north)}V{_mm(-south)}"
        for k in range(ceil(west / GRID), floor(east / GRID) + 1)
    )
    way += "".join(
        f"M{_mm(west)} {_mm(-GRID * k)}H{_mm(east)}"
        for k in range(ceil(south / GRID), floor(north / GRID) + 1)
    )
    return f'<path d="{way}" stroke="#bbb" stroke-width="1"/>'


def _walls(world: World) -> str:
    """Lines run on to the picture's edge; posts and segments as they are."""
    found = ""
    for wall in world.walls:
        curve = wall.curve()
        if not curve:
            foot = wall.shape.normal * wall.shape.offset
            curve = foot - 10j * wall.shape.normal, foot + 10j * wall.shape.normal
        way = "M" + "L".join(map(_spot, curve))
        found += f'<path d="{way}" stroke="#000" stroke-width="5" fill="none"/>'
    return found


def _way(world: World, name: str, dash: str) -> str:
    points = _points(world, name)
    if max(abs(p - points[0]) for p in points) == 0.0:
        return ""
    way, ink = "M" + "L".join(map(_spot, points)), INKS.get(name, "#333")
    return (
        f'<path d="{way}" fill="none" stroke="{ink}" stroke-width="3" stroke-dasharray="{dash}"/>'
    )


def _flashes(world: World) -> list[float]:
    """The times, s."""
    step, start = flash(world), world.log.start
    return [start + step * k for k in range(floor((world.time - start) / step) + 1)]


def _balls(world: World, down: float, language: str) -> str:
    """Those of a world at the flashes; where they begin they are filled, and named."""
    found = ""
    for ball in world.balls:
        ink, fill = INKS.get(ball.name, "#333"), FILLS.get(ball.name, "#ddd")
        spots = [complex(*world.log.at(t)[ball.name].position) for t in _flashes(world)]
        spots = [p - 1j * down * k for k, p in enumerate(spots)]
        for k, p in enumerate(dict.fromkeys(spots)):
            inside = fill if k == 0 or down else "none"
            found += (
                f'<circle cx="{_mm(p.real)}" cy="{_mm(-p.imag)}" r="{_mm(ball.radius)}"'
                f' fill="{inside}" stroke="{ink}" stroke-width="2.5"/>'
            )
        x, y = _mm(spots[0].real), _mm(-spots[0].imag - 1.3 * ball.radius)
        name = escape(word(ball.name, language))
        found += f'<text x="{x}" y="{y}" text-anchor="middle" font-size="30">{name}</text>'
    return found
