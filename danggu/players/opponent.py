"""An opponent that looks for a stroke with the engine itself, a few simulations at a time."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field
from random import Random

from danggu.rules.match import Match
from danggu.rules.verdict import NO_BALL, Verdict
from physics import Shot, World, simulate

from .candidates import CUSHIONS, DIRECT, aims
from .levels import Attempt, Level
from .plan import Plan, Searching, Work

EFFORT = 4000  # aims tried at most before it plays the best it has
ENOUGH = 60  # scoring aims after which it stops looking and starts comparing
# Copies of each remaining aim with the level's error, and how many aims are kept after them.
ROUNDS = ((4, 24), (8, 10), (16, 5), (40, 1))
FRESH = 60  # new copies of the chosen aim: its share without the luck of having been chosen
# A comparison needs some error, or all that score are equal: degrees, share of speed, mm.
LEAST = Level("least", 0.02, 0.005, 0.2)


@dataclass(frozen=True, slots=True)
class Intent:
    """What the opponent means to play, and how sure it is.

    aim: without error.
    verdict: of the stroke as it is meant, or None while nothing has been tried.
    share: of `copies` strokes with the level's error, how many scored; 0 of 0 while unknown.
    copies: how many of those there were.
    tried: simulations up to now.
    """

    aim: Attempt
    verdict: Verdict | None = None
    share: float = 0.0
    copies: int = 0
    tried: int = 0

    @property
    def shot(self) -> Shot:
        """The stroke as it is meant."""
        return self.aim.shot()


@dataclass(slots=True)
class Contender:
    """An aim in the running.

    aim: without error.
    verdict: of the stroke as it is meant.
    copies: strokes with the level's error that were tried.
    gain: what they brought in all.
    made: those that scored.
    """

    aim: Attempt
    verdict: Verdict
    copies: int = 0
    gain: int = 0
    made: list[Attempt] = field(default_factory=list)

    @property
    def worth(self) -> float:
        """Points that a stroke may be expected to bring, as if one more copy had brought none."""
        return self.gain / (self.copies + 1)

    @property
    def merit(self) -> tuple[bool, int, int]:
        """How near it comes to a point: no foul first, then balls hit, then cushions."""
        facts = self.verdict.facts
        return not self.verdict.foul, len(facts.hits), facts.cushions

    def centre(self) -> Attempt:
        """The middle of the copies that scored: farther from where it fails than the aim itself."""
        n = len(self.made)
        return Attempt(
            sum(aim.angle for aim in self.made) / n,
            sum(aim.speed for aim in self.made) / n,
            sum(aim.right for aim in self.made) / n,
            sum(aim.up for aim in self.made) / n,
        )


def value(verdict: Verdict) -> int:
    """Points, and 1 for the stroke that wins without any."""
    return max(verdict.points, 1) if verdict.made else verdict.points


class Opponent(Searching):
    """Thinks about the coming stroke of `match`, with the balls as they lie in `world`.

    Call `think(budget)` between frames until it returns True, or stop at any time; `intent` is
    always the best so far.  The outcome depends on the arguments alone, not on the budgets.
    The world is copied: it may go on moving.
    """

    def __init__(
        self, world: World, match: Match, level: Level, seed: int = 0, effort: int = EFFORT
    ) -> None:
        self.level = level
        self.tried = 0
        self._world = world.copy()
        self._turn, self._rules = match.turn, match.rules
        self._rng = Random(seed)
        self._effort = effort
        balls = {ball.name: ball for ball in self._world.balls}
        if match.cue not in balls:
            raise ValueError(f"there is no ball {match.cue!r} to play with")
        cue = balls[match.cue]
        self._radius = cue.radius
        targets = [balls[b].position for b in match.rules.targets(self._turn) if b in balls]
        style = CUSHIONS if self._rules.needs(self._turn) else DIRECT
        self._aims = aims(cue.position, targets, self._radius, style, self._rng)
        self.intent = Intent(next(self._aims))
        self._work = self._search()

    @property
    def plan(self) -> Plan:
        """What it means to do, as `plan.Mind` has it."""
        return Plan(self.intent.shot)

    @property
    def share(self) -> float | None:
        """The part of its strokes like this one that would score; None while unknown."""
        return self.intent.share if self.intent.copies else None

    def execute(self, rng: Random) -> Shot:
        """The intended stroke with the level's error drawn from `rng`."""
        return self.level.missed(self.intent.aim, rng, self._radius).shot()

    def played(self, rng: Random) -> Plan:
        """The plan with the level's error drawn from `rng`."""
        return Plan(self.execute(rng))

    def _search(self) -> Work:
        """Everything there is to do; stops after each simulation."""
        found: list[Contender] = []
        nearest: Contender | None = None
        while self.tried < self._effort and len(found) < ENOUGH:
            aim = next(self._aims)
            tried = Contender(aim, self._outcome(aim))
            if tried.verdict.made:
                found.append(tried)
            if nearest is None or (not found and tried.merit > nearest.merit):
                nearest = tried
            self._intend(found[0] if found else nearest)
            yield
        chosen = found[0] if found else nearest
        if len(found) > 1:
            chosen = yield from self._race(found)
        if chosen is not None:
            yield from self._measure(chosen)

    def _race(self, field: list[Contender]) -> Generator[None, None, Contender]:
        """The aim that bears the level's error best."""
        error = self.level.or_more(LEAST)
        for copies, keep in ROUNDS:
            for contender in field:
                yield from self._copy(contender, copies, error)
            field = sorted(field, key=lambda one: one.worth, reverse=True)[:keep]
            self._intend(field[0])
            if keep > 1:
                yield from self._centre(field)
        return field[0]

    def _centre(self, field: list[Contender]) -> Work:
        """To the better half of the field, add the middle of what scored around each."""
        for contender in field[: len(field) // 2]:
            if len(contender.made) > 1:
                aim = contender.centre()
                middle = Contender(aim, self._outcome(aim))
                if middle.verdict.made:  # what it shows to intend has to be a point
                    field.append(middle)
                yield

    def _copy(self, contender: Contender, copies: int, error: Level) -> Work:
        for _ in range(copies):
            aim = error.missed(contender.aim, self._rng, self._radius)
            verdict = self._outcome(aim)
            contender.copies += 1
            contender.gain += value(verdict)
            if verdict.made:
                contender.made.append(aim)
            yield

    def _measure(self, chosen: Contender) -> Work:
        """Its share on new copies: those that it was chosen by flatter it."""
        fresh = Contender(chosen.aim, chosen.verdict)
        yield from self._copy(fresh, FRESH, self.level)
        self._intend(fresh)

    def _intend(self, one: Contender) -> None:
        share = len(one.made) / one.copies if one.copies else 0.0
        self.intent = Intent(one.aim, one.verdict, share, one.copies, self.tried)

    def _outcome(self, aim: Attempt) -> Verdict:
        self.tried += 1
        try:
            after = simulate(self._world, self._turn.cue, aim.shot())
        except RuntimeError:  # a stroke that the engine cannot follow is not played
            return Verdict(NO_BALL, foul=True)
        return self._rules.verdict(after.log.brief(), self._turn)
