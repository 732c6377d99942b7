"""A simple opponent for games with pockets: the easiest pot, straight into the easiest pocket."""

from __future__ import annotations

from cmath import phase
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import degrees, dist
from random import Random
from time import perf_counter

from danggu.rules.match import Match
from danggu.rules.snooker import COLOUR
from danggu.rules.state import BREAK, Call
from physics import Pocket, World, heading, simulate

from .hand import hindrance, usual
from .levels import Attempt, Level
from .plan import Plan, Point

TRIED = 24  # pots that are simulated, the easiest first
FAST, SOFT = 8.0, 1.2  # m/s: of a break, and of a stroke that pots nothing
SPEEDS = (1.5, 2.5)  # m/s: of pots
STEEPEST = 75.0  # degrees: no thinner cut is tried
BEHIND = 0.25  # m: how far behind the ghost ball a ball in hand is placed


@dataclass(frozen=True, slots=True)
class Pot:
    """A pot to be tried.

    ease: the smaller the easier.
    ball, pocket: names.
    aim: of the cue ball.
    place: where the cue ball lies, m, or None if it is not in hand.
    cue: name of the ball that is played.
    """

    ease: float
    ball: str
    pocket: str
    aim: Attempt
    place: Point | None
    cue: str


class Potter:
    """Thinks as `plan.Mind` says: pots as they come, or else a plain hit on a ball that is on."""

    def __init__(
        self, world: World, match: Match, level: Level, seed: int = 0, effort: int = TRIED
    ) -> None:
        self.level, self.match, self.done = level, match, False
        self.share: float | None = None
        self._world, self._rng = world.copy(), Random(seed)
        self._balls = {ball.name: ball for ball in self._world.balls if not ball.gone}
        self._pockets = {w.name or "": w.at for w in world.walls if isinstance(w, Pocket)}
        self._place = self._usual_place()
        targets = [ball for ball in match.rules.targets(match.turn) if ball in self._balls]
        self.aim, self._call, self._at = self._plain(targets), self._declared(targets), self._place
        breaks = match.state.phase == BREAK
        pots = [] if breaks else sorted(self._pots(targets), key=lambda pot: pot.ease)
        self._left = pots[: min(effort, TRIED)]

    @property
    def plan(self) -> Plan:
        return Plan(self.aim.shot(), self._call, self._at)

    def played(self, rng: Random) -> Plan:
        radius = self._balls[self.match.cue].radius if self.match.cue in self._balls else 0.03
        return Plan(self.level.missed(self.aim, rng, radius).shot(), self._call, self._at)

    def think(self, budget: float, clock: Callable[[], float] = perf_counter) -> bool:
        end = clock() + budget
        while not self.done:
            self.done = not self._left or self._try(self._left.pop(0))
            if clock() >= end:
                break
        return self.done

    def _usual_place(self) -> Point | None:
        region, cue = self.match.state.region, self.match.cue
        if not region:
            return None
        at = self._world.ball(cue).position
        gone = self._world.ball(cue).gone
        return usual(self._world, cue, region) if gone or self._barred(at) else at

    def _barred(self, at: Point) -> bool:
        return hindrance(self._world, self.match.cue, at, self.match.state.region) is not None

    def _start(self) -> Point:
        return self._place or self._world.ball(self.match.cue).position

    def _plain(self, targets: list[str]) -> Attempt:
        """Full on the nearest ball that may be hit first."""
        x, y = self._start()
        spots = [self._balls[name].position for name in targets] or [(0.0, 0.0)]
        a, b = min(spots, key=lambda at: dist(at, (x, y)))
        fast = FAST if self.match.state.phase == BREAK else SOFT
        return Attempt(heading(complex(a - x, b - y)), fast)

    def _declared(self, targets: list[str]) -> Call:
        """Snooker wants a colour to be named, and a free ball."""
        state, start = self.match.state, self._start()
        if targets and (state.free or state.on == COLOUR):
            return Call(min(targets, key=lambda name: dist(self._balls[name].position, start)))
        return Call()

    def _pots(self, targets: list[str]) -> Iterator[Pot]:
        for name in targets:
            ball = self._balls[name]
            for pocket, hole in self._pockets.items():
                to = complex(*hole) - complex(*ball.position)
                ghost = complex(*ball.position) - 2 * ball.radius * to / abs(to)
                place = self._behind(ghost, to)
                run = ghost - complex(*(place or self._start()))
                cut = abs(degrees(_angle(run, to)))
                if cut > STEEPEST or not run:
                    continue
                for speed in SPEEDS:
                    ease = abs(to) * (1 + (cut / 30) ** 2) + 0.5 * abs(run) + 0.1 * speed
                    aim = Attempt(heading(run), speed)
                    yield Pot(ease, name, pocket, aim, place, self.match.cue)

    def _behind(self, ghost: complex, to: complex) -> Point | None:
        """For a ball in hand, a place straight behind the ghost ball, if it may be there."""
        if self._place is None:
            return None
        at = ghost - BEHIND * to / abs(to)
        return self._place if self._barred((at.real, at.imag)) else (at.real, at.imag)

    def _try(self, pot: Pot) -> bool:
        """Play it on a copy; whether it scores, which is then the plan."""
        world = self._world.copy()
        if pot.place is not None:
            world.ball(pot.cue).position = pot.place
        call = Call(pot.ball, pot.pocket)
        try:
            after = simulate(world, pot.cue, pot.aim.shot())
            verdict = self.match.called(call).judged(after.log.contacts())
        except (ValueError, RuntimeError):  # what the engine cannot follow is not played
            return False
        if not verdict.made or verdict.lost:
            return False
        self.aim, self._call, self._at, self.share = pot.aim, call, pot.place, None
        return True


def _angle(a: complex, b: complex) -> float:
    """The angle between two directions, radians."""
    return abs(phase(a.conjugate() * b))


def first_option(world: World, match: Match, level: Level, seed: int = 0) -> str:
    """The answer that needs no thought: the first one."""
    if match.asked is None:
        raise ValueError("there is no question to answer")
    return match.asked.options[0].key
