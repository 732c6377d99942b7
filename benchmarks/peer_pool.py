"""Pool beside pooltool: on its table, by the same laws, and against 50 digits.

Balls are smooth and lose nothing, and cushions are mirrors: of the laws that pooltool has, those
that this package knows too. Both then mean the same shot, and one of them is nearer to it.
"""

from collections.abc import Callable, Sequence
from functools import partial
from random import Random
from statistics import median
from typing import Any, NamedTuple

from physics import Ball, Cloth, EventDriven, Pocket, Post, Shot, Wall, World, laws, simulate_many

from .report import Report, duration, figure
from .timing import in_turns

RIGHT = 1e-3  # m: as far as a ball may be from where it rests in truth, with the same pocketed
MANY = 200  # shots of a compiled batch
Fates = list[complex | None]  # where each ball rests, or None: pocketed


class Geometry(NamedTuple):
    """Of the peer's table, m: ends of cushions, middles and radii of jaws and of holes; its balls'
    radius and mass, and its cloth."""

    walls: list[tuple[complex, complex]]
    jaws: list[tuple[complex, float]]
    holes: list[tuple[complex, float]]
    radius: float
    mass: float
    cloth: Cloth


Layout = list[tuple[str, complex]]


def world_of(geometry: Geometry, layout: Layout, shot: Shot) -> World:
    """The first ball is struck."""
    world = World(geometry.cloth, laws.SmoothBall(1.0), laws.RigidCushion(1.0, 0.0, nose=1.0))
    world.engine = EventDriven(vmin=1e-9)
    for p, q in geometry.walls:
        world.add(Wall.segment((p.real, p.imag), (q.real, q.imag), f"wall {len(world.walls)}"))
    for at, radius in geometry.jaws:
        world.add(Post((at.real, at.imag), radius, f"jaw {len(world.walls)}"))
    for at, radius in geometry.holes:
        world.add(Pocket((at.real, at.imag), radius, f"hole {len(world.walls)}"))
    for name, p in layout:
        world.add(Ball(name, (p.real, p.imag), radius=geometry.radius, mass=geometry.mass))
    world.strike(layout[0][0], shot)
    return world


def still(geometry: Geometry, layout: Layout) -> World:
    world = world_of(geometry, layout, Shot(1.0))
    world.stop()
    return world


def games(geometry: Geometry, count: int) -> list[tuple[Layout, Shot]]:
    """Six balls anywhere, as in the middle of a game; sliding or rolling, at 1 to 4 m/s."""
    dice, r = Random(5), geometry.radius
    bed = [p for ends in geometry.walls for p in ends]
    wide, high = max(p.real for p in bed), max(p.imag for p in bed)
    found = []
    for _ in range(count):
        spots: list[complex] = []
        while len(spots) < 6:
            p = complex(dice.uniform(0.12, 0.88) * wide, dice.uniform(0.06, 0.94) * high)
            if all(abs(p - q) > 2.1 * r for q in spots):
                spots.append(p)
        speed = dice.uniform(1.0, 4.0)
        shot = Shot(speed, dice.uniform(0.0, 360.0), follow=dice.choice((0.0, 0.5)) * speed)
        found.append(([(f"{k}", p) for k, p in enumerate(spots)], shot))
    return found


def breaks(geometry: Geometry, count: int) -> list[tuple[Layout, Shot]]:
    """A nine-ball diamond with gaps of a tenth of a millimetre, at 8 m/s, a little off."""
    dice, r = Random(6), geometry.radius
    bed = [p for ends in geometry.walls for p in ends]
    wide, high = max(p.real for p in bed), max(p.imag for p in bed)
    pitch, found = 2.0 * r + 1e-4, []
    for _ in range(count):
        layout: Layout = [("cue", complex((0.5 + dice.uniform(-0.1, 0.1)) * wide, 0.25 * high))]
        for row, balls in enumerate((1, 2, 3, 2, 1)):
            for k in range(balls):
                p = complex(0.5 * wide + pitch * (k - 0.5 * (balls - 1)),
                            0.72 * high + row * pitch * 0.75**0.5)  # fmt: skip
                layout.append((f"{len(layout)}", p))
        aim = layout[1][1] - layout[0][1]
        shot = Shot(8.0, 90.0 - 57.29577951308232 * aim.real / aim.imag)
        found.append((layout, shot))
    return found


def here(world: World) -> Fates:
    world.run()
    return [None if b.phase == "pocketed" else complex(*b.position) for b in world.balls]


def truth(world: World) -> Fates:
    """By the same kernel in 50 digits."""
    from tests.support import fifty

    world.plan()
    scene, package = fifty.scene(world), fifty.kernel()
    package.calendar.advance(float("inf"), 10**5, scene)
    return [None if ball.height < 0 else complex(ball.position) for ball in scene.balls]


def error(found: Fates, true: Fates) -> float:
    """m: the worst of the balls; inf if others were pocketed."""
    if [p is None for p in found] != [q is None for q in true]:
        return float("inf")
    pairs = zip(found, true, strict=True)
    return max((abs(p - q) for p, q in pairs if p is not None and q is not None), default=0.0)


class Rival(NamedTuple):
    """Its table; and a function that plays a layout and a shot, and says where the balls rest."""

    name: str
    geometry: Geometry
    play: Callable[[Layout, Shot], Fates]


def compare(page: Report, peer: Rival, effort: int) -> list[list[Any]]:
    """The section of the page; its numbers."""
    page.say(
        "Pool on that engine's own 7-foot table with its round jaws, by the same laws: smooth balls"
        " that lose nothing, mirrors as cushions, sliding and rolling as here. Errors are distances"
        " at rest from where the same kernel has the balls in 50 digits, of the worst ball of each"
        f" shot; right is within {1000 * RIGHT:g} mm, with the same balls pocketed."
    )
    rows, costs = [], []
    kinds = (("shot in mid-game", games, (2, 10, 40)), ("break", breaks, (0, 2, 5)))
    for name, make, counts in kinds:
        strokes = make(peer.geometry, counts[effort])
        if strokes:
            said, numbers = section(name, peer, strokes, (1, 2, 3)[effort])
            rows, costs = rows + said, costs + numbers
    page.table(["", "engine", "time", "right", "median error", "worst error"], rows)
    return costs


def section(
    name: str, peer: Rival, strokes: Sequence[tuple[Layout, Shot]], rounds: int
) -> tuple[list[list[Any]], list[list[Any]]]:
    """(lines of the table, numbers)."""
    worlds = [partial(world_of, peer.geometry, *stroke) for stroke in strokes]
    true = [truth(world()) for world in worlds]
    engines: dict[str, Callable[[], list[Fates]]] = {
        "exact, interpreted": lambda: [here(world()) for world in worlds],
        peer.name: lambda: [peer.play(*stroke) for stroke in strokes],
    }
    off = {who: [error(*p) for p in zip(run(), true, strict=True)] for who, run in engines.items()}
    batches = [(still(peer.geometry, stroke[0]), stroke) for stroke in strokes]
    runs: dict[str, Callable[[], Any]] = {**engines, "exact, compiled": lambda: many(batches)}
    many(batches)  # so that compiling is not timed
    costs = in_turns(runs, rounds)
    rows, numbers = [], []
    for who in ("exact, interpreted", "exact, compiled", peer.name):
        errors = sorted(off[who if who in off else "exact, interpreted"])
        shots = len(strokes) * (MANY if who == "exact, compiled" else 1)
        right = sum(e < RIGHT for e in errors)
        rows.append([name, who, duration(costs[who].least / shots), f"{right} of {len(errors)}",
                     _length(median(errors)), _length(errors[-1])])  # fmt: skip
        numbers.append([who, f"pool, {name}", *costs[who].per(shots)])
    return rows, numbers


def many(batches: list[Any]) -> None:
    for world, (layout, shot) in batches:
        simulate_many(world, layout[0][0], [shot] * MANY, compiled=True)


def _length(metres: float) -> str:
    return "others pocketed" if metres == float("inf") else f"{figure(metres, 2)} m"
