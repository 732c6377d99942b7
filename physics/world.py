"""The world: balls, walls and laws on one cloth, and the moment they are at."""

from collections import deque
from collections.abc import Iterable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from itertools import repeat
from math import inf
from operator import attrgetter
from typing import Any

from . import laws
from .ball import DISTURBED, Ball, Clock, Placed, a_table
from .checks import finite, nonnegative, truth
from .cloth import Cloth, a_cloth
from .contents import Contents
from .engines.engine import Engine, an_engine
from .engines.exact import EventDriven
from .files.record import foresees
from .framing import framed
from .kernel.body import Scene, celled, no_grid, no_ties, twin_scene
from .kernel.kinds import PHASES
from .log import Log
from .openings import bounded
from .parting import part
from .pictured import Pictured
from .places import check_places, check_table
from .shot import Shot
from .wall import Obstacle

FEW = 30  # balls: for more than that, cells pay (benchmarks: scale)

OWN = "__weakref__", "_asking", "_balls", "_clock", "_index", "_walls", "log", "scene"
SHARED = (  # with a copy
    "_ball_law", "_checked", "_cloth", "_cluster_law", "_cushion_law", "_discs", "_engine",
    "_table", "_warned", "_watched", "allowed", "due", "planned",
)  # fmt: skip
_shared = attrgetter(*SHARED)


class World(Contents, Pictured):
    """Balls inside walls on a cloth, laws for what happens when they touch, an engine and a log.

    ball_law and cushion_law: a law of `physics.laws`, its name, or any callable (see there). All
    can be read and assigned at any moment. What cannot be raises ValueError and changes nothing.
    discs: are its balls flat?  table: whose balls those are that have no size (see `Table.world`).
    balls, walls: what is in it from the start; `add` puts in more.
    """

    __slots__ = (*OWN, *SHARED)  # a misspelt name is an error, not an attribute that nothing reads

    def __init__(
        self,
        cloth: Cloth | None = None,
        ball_law: str | laws.BallLaw = "rough",
        cushion_law: str | laws.CushionLaw = "rigid",
        engine: Engine | None = None,
        discs: bool = False,
        table: Any = None,
        balls: Iterable[Ball] = (),
        walls: Iterable[Obstacle] = (),
    ) -> None:
        self._discs, self._table = truth("a world's discs", discs), a_table(table)
        self._cloth = Cloth() if cloth is None else a_cloth(cloth)
        self._engine: Engine = EventDriven() if engine is None else an_engine(engine)
        self._ball_law = laws.ball_law(ball_law)
        self._cushion_law = laws.cushion_law(cushion_law)
        self._cluster_law: laws.HertzCluster | None = None
        self._clock = Clock(self._cloth.felt())
        self._balls: list[Ball] = []
        self._watched = False  # is a custom law in use?  Then a run that fails is undone
        self._asking: list[str] = []  # the custom law that is being asked
        self._warned: list[object] = []  # the custom laws that were found to gain energy
        self._index: dict[str, int] = {}
        self._walls: list[Obstacle] = []
        self._checked = 0  # how many of the walls all balls are known to be inside of
        self.log = Log(self._walls)
        felt = self._clock.cloth
        self.scene = Scene([], [], [], felt, None, None, no_ties(0), False, no_grid(0))
        self._renew_rules()
        # for the engine: when the next event is due, from the epoch on; when it planned; its budget
        self.due, self.planned, self.allowed = inf, 0.0, 0
        for wall in walls:
            self.add(wall)
        for ball in balls:
            self.add(ball)

    def _enlist(self, ball: Ball) -> None:
        n, body = len(self._balls) + 1, ball.body
        if self._discs:
            body.lift = 0.0
        self._index[ball.name] = n - 1
        self._balls.append(ball)
        self.scene.balls.append(body)
        self.log.register(ball.name, ball.mass)
        table = [inf] * (n * n) if n <= FEW else []
        self._clock.settle(ball.radius, first=n == 1)
        self.scene = self.scene._replace(
            cloth=self._clock.cloth, meetings=table, ties=no_ties(n), celled=False, grid=no_grid(n)
        )

    # -- how it works --------------------------------------------------------------------------

    @property
    def cloth(self) -> Cloth:
        return self._cloth

    @cloth.setter
    def cloth(self, cloth: Cloth) -> None:
        self._refuse_laws("cloth")
        for law in (self._cushion_law, *(wall.own_law for wall in self._walls if wall.own_law)):
            laws.on_cloth(law, a_cloth(cloth).slide)
        self._cloth = cloth
        self._give_table(cloth=cloth)
        self._disturb()
        self._clock.cloth = replace(cloth.felt(), still=self._clock.cloth.still)
        self._renew_rules()

    @property
    def ball_law(self) -> laws.BallLaw:
        return self._ball_law

    @ball_law.setter
    def ball_law(self, law: str | laws.BallLaw) -> None:
        self._refuse_laws("ball_law")
        self._ball_law = laws.ball_law(law)
        self._give_table(ball_law=self._ball_law)
        self._renew_rules()

    @property
    def cushion_law(self) -> laws.CushionLaw:
        return self._cushion_law

    @cushion_law.setter
    def cushion_law(self, law: str | laws.CushionLaw) -> None:
        self._refuse_laws("cushion_law")
        law = laws.cushion_law(law, self._cushion_law)
        laws.on_cloth(law, self._cloth.slide)
        self._cushion_law = law
        self._give_table(cushion_law=law)
        self._renew_rules()
        for ball in self._balls:
            if ball.phase == "airborne":  # where the nose is has been planned with
                ball.disturb()

    @property
    def cluster_law(self) -> laws.HertzCluster | None:
        """What happens when three balls or more touch.

        None: the ball law, contact by contact, those that close equally fast together.
        laws.HertzCluster(), or "hertz", is the accurate way.
        """
        return self._cluster_law

    @cluster_law.setter
    def cluster_law(self, law: str | laws.HertzCluster | None) -> None:
        self._refuse_laws("cluster_law")
        self._cluster_law = laws.cluster_law(law)

    @property
    def engine(self) -> Engine:
        return self._engine

    @engine.setter
    def engine(self, engine: Engine) -> None:
        self._refuse_laws("engine")
        engine = an_engine(engine)
        self._clock.loose |= not foresees(self)
        self._engine = engine
        self._disturb()
        self._renew_rules()

    def _renew_rules(self) -> None:
        vmin, slide, before = self._engine.vmin, self._cloth.slide, self.scene.cushion_rule
        ball = laws.ball_rule(self._ball_law, vmin)
        own = [wall.own_law for wall in self._walls]
        cushion, *walls = laws.cushion_rules([self._cushion_law, *own], slide, vmin, before)
        rules = ball, cushion, *walls
        self._watched = any(isinstance(rule, laws.CustomRule) for rule in rules)
        if self._watched:
            from .watch import watch

            watch(rules, self._balls, self._asking, self._warned)
        self.scene = self.scene._replace(
            cloth=self._clock.cloth, bands=self._cloth.strips(), ball_rule=ball,
            cushion_rule=cushion, rules=walls,
        )  # fmt: skip

    def _refuse_laws(self, call: str) -> None:
        """RuntimeError if a custom law, while it is asked, uses this."""
        if self._asking:
            raise RuntimeError(f"{self._asking[-1]} used World.{call}: a law only answers")

    # -- the moment it is at -------------------------------------------------------------------

    @property
    def time(self) -> float:
        """Seconds since the world began."""
        return self._clock.epoch + self._clock.now

    @property
    def clock(self) -> Clock:
        """What the balls read the time from."""
        return self._clock

    @property
    def epoch(self) -> float:
        """When balls that all lay still were last set in motion, s; events count from then."""
        return self._clock.epoch

    @property
    def now(self) -> float:
        """Seconds since the epoch."""
        return self._clock.now

    @property
    def at_rest(self) -> bool:
        """Does nothing move or roll any more?  (A ball may still spin on the spot.)"""
        return all(ball.lies for ball in self._balls)

    @property
    def next_event(self) -> float:
        """When something will happen next, seconds, or inf."""
        self.plan()
        return self._clock.epoch + self.due

    # -- what is done with it ------------------------------------------------------------------

    def strike(self, ball: Ball | str, shot: Shot) -> None:
        """Give a ball the velocity and spin of the shot, and forget how it moved before."""
        if not isinstance(shot, Shot):
            raise ValueError(f"World.strike takes a Shot, not {shot!r}")
        self._refuse_laws("strike")
        body = self.ball(ball).on_table().disturb()
        (body.velocity, body.roll), body.side, body.climb = shot.motion(), shot.side, shot.climb

    def stop(self) -> None:
        """All balls stop where they are; from the air they fall."""
        self._refuse_laws("stop")
        for ball in self._balls:
            body = ball.disturb()
            body.velocity, body.roll, body.side, body.climb = 0j, 0j, 0.0, 0.0

    def layout(self) -> tuple[Placed, ...]:
        """How all balls lie or move at this moment, in their order, to the last digit."""
        return tuple(ball.placed for ball in self._balls)

    def recall(self, layout: Sequence[Placed]) -> None:
        """Put all balls back as a `layout` had them; ValueError if it has another number of them.

        They may overlap, as fixed steps leave them: an exact engine parts them before time passes.
        """
        self._refuse_laws("recall")
        if len(layout) != len(self._balls):
            raise ValueError(f"the layout is of {len(layout)} balls, not of {len(self._balls)}")
        for ball, placed in zip(self._balls, layout, strict=True):
            ball.placed = placed
        self._clock.moved = self._clock.loose = True
        self.trust()

    def trust(self) -> None:
        """Accept that balls overlap as they lie now: it is not the caller's fault."""
        self._checked = len(self._walls)
        for ball in self._balls:
            ball.put = False

    def part(self) -> None:
        """Part balls that fixed steps have left overlapping, unless fixed steps move them on."""
        if self._clock.loose and foresees(self):
            part(self._balls, self._walls)
            self._clock.loose = False

    def step(self, dt: float) -> None:
        """Let dt seconds pass; n steps of dt / n lead to the same rest, bit for bit, for any n."""
        nonnegative("World.step dt", dt)
        self._refuse_laws("step")
        if self._watched:
            with self._guard():
                self._step(dt)
        else:  # a game steps often
            self._step(dt)

    def _guard(self) -> AbstractContextManager[None]:
        """A run that a custom law makes fail is undone."""
        if not self._watched:
            return nullcontext()
        from .watch import undone

        return undone(self)

    def _step(self, dt: float) -> None:
        clock = self._clock
        if clock.loose and dt > 0.0 and not self.at_rest:
            self.part()
        if clock.disturbed:
            self.plan()
        now = clock.now + dt
        if clock.epoch + self.due <= clock.epoch + now:
            self._engine.advance(self, clock.epoch + now)
        clock.now = now

    def run(self, until: float = inf) -> None:
        """Let time pass until all balls rest, or until world time `until`, s, that included."""
        self._refuse_laws("run")
        until = until if until == inf else finite("World.run until", until)
        if until < self.time:
            raise ValueError(f"World.run until is {until!r}, before now, {self.time!r}")
        with self._guard():
            if self._clock.loose and not self.at_rest:
                self.part()
            self.plan()
            reached = self._engine.advance(self, until)
            self._clock.now = reached if until == inf else max(reached, until - self._clock.epoch)

    def reached(self, now: float) -> None:
        """For an engine that must stop early: how far it came, seconds since the epoch."""
        self._clock.now = now

    def copy(self) -> "World":
        """The same world again, on the same legs, to be continued apart."""
        return self.fork(self.log.copy())

    def fork(self, log: Log) -> "World":
        """The same, with another log."""
        world = World.__new__(World)
        clock = self._clock.copy()
        balls = [ball.twin(clock) for ball in self._balls]
        deque(map(setattr, repeat(world), SHARED, _shared(self)), 0)  # for each preview: quickly
        world._clock, world._balls, world.log = clock, balls, log
        world._index, world._walls, world._asking = self._index.copy(), self._walls[:], []
        log.watch(world._walls)
        world.scene = twin_scene(self.scene, [ball.body for ball in balls])
        if world._watched:
            world._renew_rules()  # so that it watches its own balls
        return world

    def _disturb(self) -> None:
        self._clock.disturbed = True
        for ball in self._balls:
            ball.disturb()

    def plan(self) -> None:
        """Plan what has been placed or pushed; ValueError if it does not fit."""
        clock, bodies = self._clock, self.scene.balls
        if not clock.disturbed:
            return
        if clock.moved:
            fresh, dt = self._walls[self._checked :], getattr(self._engine, "dt", 0.0)
            check_places(self._balls, self._walls, fresh, self.scene.cushion_rule, dt)
            check_table(self._balls, self._walls, self._table)
            self.trust()
            scene = framed(self.scene)
            self.scene = bounded(scene, self._table is not None)
            if len(self._balls) > FEW:
                self._disturb()
                self.scene = celled(self.scene)
        if all(body.phase == DISTURBED or PHASES[body.phase].lies for body in bodies):
            clock.begin_epoch(bodies)
        self.planned = self.time
        self._engine.plan(self, [i for i, body in enumerate(bodies) if body.phase == DISTURBED])
        clock.disturbed = clock.moved = False
        self.log.begin_rest(clock.epoch, bodies, clock.cloth.fade)
