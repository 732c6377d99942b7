"""How much an outcome depends on the shot and its world: exact derivatives through every event.

The shot is played once with plain numbers; then its events are gone through again with numbers that
carry derivatives (`physics.studies.dual`), by the same kernel. Between events that is the tangent
of a polynomial; the moment of a contact moves by the implicit function theorem, and a collision is
differentiated as it is written, on the branch (sticking or slipping) that it took.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from math import inf, nan
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.ball import Ball
from physics.checks import array, nonnegative, vector
from physics.engines.exact import EventDriven
from physics.kernel.impulses import WALL
from physics.kernel.kinds import AIRBORNE, CUSHION, KINDS, PAIR, REST, RESTING, ROLL, ROLLING
from physics.kernel.lasting import FEW
from physics.kernel.obstacle import NOBODY
from physics.log import Event
from physics.markup import table
from physics.shot import Shot
from physics.simulation import simulate
from physics.world import World

from .dual import Dual, kernel, slope, value
from .parameters import NUMBERS, Seeds, names

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]
    Errors = Sequence[float] | Mapping[str, float] | npt.NDArray[np.float64]


class EventSlope(NamedTuple):
    """An event and its derivatives by the N inputs that were asked for, in their order.

    event: as in the log.
    time: (N,) s.
    before, after: (balls, 7, N), rows x, y m, vx, vy m/s, wx, wy, wz rad/s, of each of the event's
    balls just before and just after it.
    All are per unit of the input, which for "angle" is a degree. They follow the event to its new
    time; at a fixed time the position of a ball changes by
    `after[k, :2] - outer(event.after[k].velocity, time)`.
    """

    event: Event
    time: Array
    before: Array
    after: Array

    def __repr__(self) -> str:
        return f"<EventSlope of {self.event!r} by {len(self.time)} inputs>"

    def headings(self, after: bool = True) -> Array:
        """(balls, N): how the direction of each ball turns, radians; 0 for one that rests."""
        import numpy as np

        states, slopes = (
            (self.event.after, self.after) if after else (self.event.before, self.before)
        )
        turns = np.zeros((len(states), len(self.time)))
        for k, state in enumerate(states):
            (vx, vy), (dx, dy) = state.velocity, slopes[k, 2:4]
            if vx or vy:
                turns[k] = (vx * dy - vy * dx) / (vx * vx + vy * vy)
        return turns


class Sensitivity(NamedTuple):
    """What `sensitivity` returns.

    world: after the shot; the events are those of its log.
    events: one EventSlope for each.
    rest: (balls, 2, N) derivatives of where each of the world's balls comes to rest, m per unit of
    the input; NaN for a ball that never rests.
    by: the names of the N inputs.
    """

    world: World
    events: tuple[EventSlope, ...]
    rest: Array
    by: tuple[str, ...] = NUMBERS

    def __repr__(self) -> str:
        return f"<Sensitivity of {len(self.events)} events by {', '.join(self.by)}>"

    def _repr_html_(self) -> str:
        rows = [
            (f"{ball.name} {axis}", *map(float, slopes))
            for ball, both in zip(self.world.balls, self.rest, strict=True)
            for axis, slopes in zip("xy", both, strict=True)
        ]
        return table(("at rest, m, by", *self.by), rows)

    def covariance(self, errors: Errors) -> Array:
        """(balls, 2, 2) m²: scatter at rest, for errors of the inputs.

        errors: standard deviations of the N inputs, independent, in their units; or of some of
        them by name ("positions" for all places), the others being exact; or (N, N), their
        covariance. To first order: meant for errors so small that the events keep their order.
        """
        result: Array = self.rest @ self._spread(errors) @ self.rest.transpose(0, 2, 1)
        return result

    def _spread(self, errors: Errors) -> Array:
        """(N, N): the covariance of the inputs."""
        import numpy as np

        if not isinstance(errors, Mapping) and np.ndim(errors) == 2:
            wide, n = array("errors", errors), len(self.by)
            if wide.shape != (n, n) or not (wide == wide.T).all() or not np.isfinite(wide).all():
                raise ValueError(f"errors must be symmetric and finite, {n} x {n}, not {errors!r}")
            return wide
        return np.diag(_errors(errors, self.by, self.world) ** 2)

    def amplification(self, errors: Errors | None = None) -> Array:
        """(hits,): by how much each hit of two balls multiplies an error of direction.

        That is the rms error of heading just after it over that just before it, of whichever ball
        has the larger one, for standard deviations `errors` of the inputs, as in `covariance`;
        without them, of the aim alone. A straight hit at distance D gives D/2R - 1
        (docs/physics.md). Infinite where no error came in, NaN where none came out either.
        """
        import numpy as np

        weights = _errors({"angle": 1.0} if errors is None else errors, self.by, self.world)
        hits = [slopes for slopes in self.events if slopes.event.kind == "ball"]
        before, after = (
            np.array([_spread(hit.headings(side) * weights) for hit in hits])
            for side in (False, True)
        )
        with np.errstate(divide="ignore", invalid="ignore"):
            factors: Array = after / before
        return factors


def _errors(errors: Errors, by: tuple[str, ...], world: World) -> Array:
    """(N,): standard deviations of the inputs."""
    import numpy as np

    if isinstance(errors, Mapping):
        found = dict.fromkeys(by, 0.0)
        for name, error in errors.items():
            for one in names(world, [name]):
                if one not in found:
                    raise ValueError(f"errors: {one!r} is none of the inputs {', '.join(by)}")
                found[one] = error
        errors = [*found.values()]
    numbers = vector("errors", tuple(errors), len(by))
    return np.array([nonnegative("errors", number) for number in numbers])


def _spread(headings: Array) -> Any:
    return (headings**2).sum(axis=1).max() ** 0.5


def sensitivity(
    world: World, ball: Ball | str, shot: Shot, by: Iterable[str] = NUMBERS
) -> Sensitivity:
    """Derivatives of all that follows from a shot, by the inputs named in `by`.

    They are "speed", "angle", "follow", "masse" and "side" of the shot; where balls lie before it,
    "white.x" and "white.y" for one named white, m, or "positions" for all; and coefficients, such
    as "cloth.slide", "cushion.e" or "ball.mu", by the names they have in `Cloth` and `laws`.

    ball is one of the world's, or its name; the world stays as it is. Exact up to rounding, which
    every hit magnifies; a custom law is probed by differences, to about 1e-11. See
    docs/physics.md, "How much depends on the shot".

    They hold as long as the same events happen in the same order. There is no derivative where that
    is about to change: a ball just grazed or just missed, two events at one instant (a cluster is
    differentiated as if its contacts stayed together), friction just between sticking and slipping,
    a parting speed at the engine's `vmin`. On both sides the numbers are right, and different. A
    contact that begins without speed gives NaN.

    ValueError for inputs that the world has not, if the engine is not EventDriven, if the world
    has no such ball, if one flies, or if three balls meet under a HertzCluster.
    """
    if not isinstance(world.engine, EventDriven):
        raise ValueError(f"sensitivity needs the engine EventDriven, not {world.engine!r}")
    by = names(world, by)
    after = simulate(world, ball, shot)
    if any(leg.phase == AIRBORNE for name in after.log.names for leg in after.log.legs(name)):
        raise ValueError("sensitivity knows no derivatives of balls in the air")
    replay = Replay(after, after.ball(ball).name, shot, by)
    return Sensitivity(after, tuple(replay.events()), replay.rest(), by)


class Replay:
    """The balls of a finished shot once more, on dual numbers."""

    def __init__(
        self, world: World, struck: str, shot: Shot, by: tuple[str, ...] = NUMBERS
    ) -> None:
        self.seeds, self.log, self.kernel = Seeds(world, by), world.log, kernel()
        self.scene = world.scene._replace(
            cloth=self.seeds.cloth,
            cushion_rule=self.seeds.cushion_rule,
            ball_rule=self.seeds.ball_rule,
        )
        self.cluster_law = world.cluster_law
        self.balls = [self._body(ball, shot, ball.name == struck) for ball in world.balls]

    def _body(self, ball: Ball, shot: Shot, struck: bool) -> Any:
        """The ball as its first leg began: only the struck one depends on the shot."""
        leg = self.log.legs(ball.name)[0]
        motion = (leg.velocity, leg.roll, leg.side)
        slopes = self.seeds.push(shot) if struck else (self.seeds.zeros(),) * 3
        body = self.kernel.body.Body(ball.radius, ball.mass, ball.body.lift)
        body.since, body.height = leg.since, leg.height
        body.position = Dual(leg.position, self.seeds.place(ball.name))
        body.velocity, body.roll, body.side = map(Dual, motion, slopes)
        self.plan(body)
        return body

    def plan(self, body: Any) -> None:
        slip, cloth = body.velocity - body.roll, self.scene.cloth
        if abs(value(slip)) <= cloth.still and slip != 0.0 and cloth.slide > 0.0:
            # it rolls, but would slip after another shot, for a moment that leaves 5/7 v + 2/7 w
            rolling = (5.0 * self.slope(body.velocity) + 2.0 * self.slope(body.roll)) / 7.0
            body.velocity = body.roll = Dual(value(body.velocity), rolling)
        lasts = self.kernel.leg.begin(body, cloth)
        if body.phase == ROLLING and self.scene.bands:
            lasts = self.kernel.leg.brake(body, cloth, self.scene.bands)
        body.leg_end = body.since + lasts

    def events(self) -> Iterator[EventSlope]:
        """Go through them in their order; a cluster, which is many of them, once."""
        log = zip(self.log, self.log._events, strict=True)
        for _, group in groupby(enumerate(log), _instant):
            blows = [event for _, event in group]
            _, (_, time, kind, other, i, _, _, _, shared) = blows[0]
            pairs = [[raw[4], raw[3]] if raw[2] == PAIR else [raw[4]] for _, raw in blows]
            pairs = pairs if shared or kind == PAIR else []
            involved = [m for m, _ in shared[2]] if shared else pairs[0] if pairs else [i]
            moment = self._moment(time, kind, i, other)
            before = self._carry(involved, moment)
            if shared and shared[3]:
                self._press_apart(moment, shared[3])
            else:
                self._collide(kind, i, other, pairs)
            for m in involved:
                self._count_hops(self.balls[m], kind, bool(shared and shared[3]))
                self.plan(self.balls[m])
            after = {m: self._rows(self.balls[m]) for m in involved}
            for (event, _), pair in zip(blows, pairs or [[i]], strict=True):
                slopes = _stack(before, pair), _stack(after, pair)
                yield EventSlope(event, self.slope(moment), *slopes)

    def _moment(self, time: float, kind: int, i: int, other: int) -> Dual:
        """When it happens: a contact when the gap, which depends on the shot, has closed, and a
        fall into a pocket when the centre has come to its rim."""
        ball = self.balls[i]
        if not KINDS[kind].other:
            end: Dual = ball.leg_end
            return end
        p, v = self._at(ball, time)
        if KINDS[kind].other == "wall":
            toward = self._facing(other, value(p)).conjugate()
        else:
            q, w = self._at(self.balls[other], time)
            p, v = p - q, v - w
            toward = value(p).conjugate()
        closing = value((toward * v).real)
        return Dual(time, -self.slope((toward * p).real) / (closing or nan))

    def _at(self, ball: Any, time: float) -> tuple[Any, Any]:
        """Position and velocity on its leg, at a time that does not depend on the shot."""
        t = time - ball.since
        return self.kernel.leg.place(ball, t), ball.velocity + t * ball.acceleration

    def _carry(self, involved: list[int], moment: Dual) -> dict[int, Array]:
        for m in involved:
            self.kernel.leg.carry(self.balls[m], moment, self.scene.cloth)
        return {m: self._rows(self.balls[m]) for m in involved}

    def _collide(self, kind: int, i: int, other: int, pairs: list[list[int]]) -> None:
        scene, laws, balls = self.scene, self.kernel.laws, self.balls
        if not KINDS[kind].contact:
            self.kernel.leg.end(balls[i], ROLL if kind == REST else kind)
        elif kind == CUSHION:
            normal = self._facing(other, balls[i].position)
            laws.hit_wall(balls[i], normal, self._law(other))
        elif len(pairs) == 1:
            laws.hit_ball(balls[i], balls[other], scene.ball_rule)
        else:
            if self.cluster_law is not None:
                raise ValueError(f"sensitivity knows no derivatives of {self.cluster_law!r}")
            ties = self.kernel.body.ties(len(balls))
            for tie, pair in zip(ties.contacts, pairs, strict=False):
                tie.first, tie.second = pair
            self.kernel.cluster.collide(len(pairs), balls, scene.ball_rule, ties)

    def _press_apart(self, moment: Dual, asked: list[tuple[int, int, float]]) -> None:
        """Contacts that last part as fast as they did; what they are asked depends on the shot."""
        lasting, balls, walls = self.kernel.lasting, self.balls, self.scene.walls
        ties = self.kernel.body.ties(len(balls))
        group = ties.contacts[: len(asked)]
        for tie, (first, second, _) in zip(group, asked, strict=True):
            tie.first, tie.second, tie.total = first, second, 0.0
        most, lasts = lasting.pressure(len(asked), moment, balls, ties, walls, self.scene.cloth)
        chosen = 0
        for c, (tie, (_, _, target)) in enumerate(zip(group, asked, strict=True)):
            if target > -inf:
                tie.target = self._target(tie, moment, most, lasts, target)
                ties.chosen[chosen] = c
                chosen += 1
        rules = self.scene.ball_rule, self.scene.rules, self.scene.cushion_rule
        self.kernel.apart.press_apart(chosen, balls, ties, *rules)

    def _count_hops(self, ball: Any, kind: int, lasting: bool) -> None:
        """As the kernel does: contacts that have lasted for long hop higher."""
        if lasting:
            ball.hops = max(ball.hops, FEW) + 1
        elif KINDS[kind].contact:
            ball.hops = 0

    def _target(self, tie: Any, moment: Dual, most: Any, lasts: Any, target: float) -> Any:
        """What the contact was asked, with its slope: of the branch that gives the same value."""
        rule = self.scene.ball_rule if tie.second > WALL else self._law(WALL - tie.second)
        for held in (False, True):  # whether they rebounded shows in the value alone
            at = self.balls, self.scene.walls, rule
            self.kernel.lasting.aim(tie, moment, most, lasts, 0.0, held, *at)
            if value(tie.target) == target:
                return tie.target
        return target

    def _law(self, k: int) -> Any:
        """Of wall k."""
        return self.kernel.laws.law_at(k, self.scene.rules, self.scene.cushion_rule)

    def _facing(self, k: int, p: Any) -> Any:
        """The direction in which wall k pushes a ball at p, or opening NOBODY - k faces it."""
        sides = self.scene.walls if k > NOBODY else self.scene.openings
        return self.kernel.obstacle.facing(sides[k if k > NOBODY else NOBODY - k], p)

    def rest(self) -> Array:
        """(balls, 2, N): of the positions, once there are no more events."""
        import numpy as np

        never = np.full((2, len(self.seeds.by)), nan)
        return np.array([self._rows(b)[:2] if b.phase == RESTING else never for b in self.balls])

    def slope(self, x: Any) -> Any:
        return slope(x, len(self.seeds.by))

    def _rows(self, ball: Any) -> Array:
        """(7, N): x, y, vx, vy, wx, wy, wz."""
        import numpy as np

        p, v = self.slope(ball.position), self.slope(ball.velocity)
        w, side = self.slope(ball.roll) / ball.radius, self.slope(ball.side) / ball.radius
        return np.stack((p.real, p.imag, v.real, v.imag, -w.imag, w.real, side))


def _instant(numbered: Any) -> tuple[int, int]:
    """A key that the blows of a cluster share, as they share its record, and nothing else does."""
    number, (_, raw) = numbered
    return (-1, id(raw[-1][2])) if raw[-1] else (number, 0)


def _stack(rows: dict[int, Array], of: Iterable[int]) -> Array:
    import numpy as np

    return np.stack([rows[m] for m in of])
