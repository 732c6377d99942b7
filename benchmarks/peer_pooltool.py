"""The scenes in pooltool, which is exact in time too, with its own laws for cloth and cushion; and
pool on its table, by the laws that it shares with this package."""

from collections.abc import Callable
from functools import cache
from importlib.metadata import version
from typing import Any

import pooltool

from physics import Cloth, Shot, World

from .peer_pool import Fates, Geometry, Layout, Rival
from .peers import MASS, RADIUS, Cut, Peer

ROLLING, RESTING, POCKETED = 3, 0, 4
CENTRE = 1.5  # m: its table begins at the corner; for cuts it is made large


def ball(
    name: str, at: complex, v: complex, spin: tuple[float, float, float], **kind: float
) -> Any:
    made = pooltool.Ball.create(name, xy=(at.real, at.imag), **kind)
    made.state.rvw[1] = v.real, v.imag, 0.0
    made.state.rvw[2] = spin
    moves = v != 0j
    rolls = abs(complex(-spin[1], spin[0]) * kind["R"] + v) < 1e-9
    made.state.s = (ROLLING if rolls else 2) if moves else RESTING
    return made


def system(balls: dict[str, Any], length: float, width: float) -> Any:
    from pooltool.objects.table.specs import BilliardTableSpecs

    # its y axis is the long one, ours is x: a table as wide as ours is long
    table = pooltool.Table.from_table_specs(BilliardTableSpecs(l=width, w=length))
    return pooltool.System(
        table=table, balls=balls, cue=pooltool.Cue(cue_ball_id=next(iter(balls)))
    )


def system_of(world: World) -> Any:
    sides = {wall.name: -wall.offset for wall in world.walls}
    corner = complex(sides["west"], sides["south"])
    cloth = world.cloth
    balls = {
        b.name: ball(
            b.name, complex(*b.position) + corner, complex(*b.velocity), b.spin,
            R=b.radius, m=b.mass, u_s=cloth.slide, u_r=cloth.roll, g=cloth.gravity, e_c=0.9,
        )
        for b in world.balls
    }  # fmt: skip
    return system(balls, sides["west"] + sides["east"], sides["south"] + sides["north"])


def play(make: Callable[[], World], rests: float) -> Callable[[], None]:
    def run() -> None:
        pooltool.simulate(system_of(make()), inplace=True)

    return run


def cut(shot: Cut) -> complex:
    v, middle = shot.velocity, complex(CENTRE, CENTRE)
    spin = (-v.imag / RADIUS, v.real / RADIUS, 0.0)
    kind = {"R": RADIUS, "m": MASS}
    balls = {
        "cue": ball("cue", middle + shot.start, v, spin, **kind),
        "object": ball("object", middle, 0j, (0.0, 0.0, 0.0), **kind),
    }
    table = system(balls, 2 * CENTRE, 2 * CENTRE)
    pooltool.simulate(table, engine=_plain_engine(), inplace=True, max_events=3)
    for event in table.events:
        if event.event_type == pooltool.EventType.BALL_BALL:
            after = next(agent for agent in event.agents if agent.id == "object").final
            return complex(*after.state.rvw[1][:2])
    return 0j


def peers() -> list[Peer]:
    return [Peer(f"pooltool {version('pooltool-billiards')}", play, cut)]


def pool() -> Rival:
    """Its own 7-foot table."""
    table = pooltool.Table.from_table_specs(pooltool.objects.PocketTableSpecs())
    params = pooltool.BallParams.default()
    cushions, name = table.cushion_segments, f"pooltool {version('pooltool-billiards')}"
    geometry = Geometry(
        [(_flat(c.p1), _flat(c.p2)) for c in cushions.linear.values()],
        [(_flat(c.center), float(c.radius)) for c in cushions.circular.values()],
        [(_flat(p.center), float(p.radius)) for p in table.pockets.values()],
        params.R, params.m, Cloth(params.u_s, params.u_r, 10.0, params.g),
    )  # fmt: skip
    engine = _plain_engine()

    def play(layout: Layout, shot: Shot) -> Fates:
        struck, v = layout[0][0], shot.velocity()
        roll = shot.follow / shot.speed * v / params.R
        spins = {struck: (-roll.imag, roll.real, 0.0)}
        balls = {
            name: ball(name, p, v if name == struck else 0j, spins.get(name, (0.0, 0.0, 0.0)),
                       R=params.R, m=params.m, u_s=params.u_s, u_r=params.u_r, g=params.g, e_c=1.0)
            for name, p in layout
        }  # fmt: skip
        system = pooltool.System(
            table=table.copy(), balls=balls, cue=pooltool.Cue(cue_ball_id=struck)
        )
        pooltool.simulate(system, engine=engine, inplace=True)
        states = [b.state for b in system.balls.values()]
        return [None if s.s == POCKETED else _flat(s.rvw[0]) for s in states]

    return Rival(name, geometry, play)


def _flat(p: Any) -> complex:
    return complex(float(p[0]), float(p[1]))


@cache
def _plain_engine() -> Any:
    """Its engine with smooth balls, and mirrors as cushions."""
    from pooltool.physics.engine import PhysicsEngine
    from pooltool.physics.resolve.ball_ball.frictionless_elastic import FrictionlessElastic
    from pooltool.physics.resolve.ball_cushion import unrealistic
    from pooltool.physics.resolve.resolver import Resolver

    resolver = Resolver.default()
    resolver.ball_ball = FrictionlessElastic()
    resolver.ball_linear_cushion = unrealistic.UnrealisticLinear(restitution=False)
    resolver.ball_circular_cushion = unrealistic.UnrealisticCircular(restitution=False)
    return PhysicsEngine(resolver=resolver)
