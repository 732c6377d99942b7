"""An opponent for games with pockets: pots, what they leave, safeties and breaks, tried with the
engine, and the best is what bears the level's error best."""

from __future__ import annotations

from collections.abc import Generator, Iterable
from random import Random

from danggu.rules.match import Match
from danggu.rules.state import BREAK, SECOND
from physics import World, heading

from .banks import banks, kicks
from .breaks import breaks, places
from .chances import STEADIEST, Eye, Route
from .craft import craft
from .declaring import declared
from .levels import Attempt, Level
from .lies import lie_and_targets
from .mouths import measured
from .plan import Plan, Searching, Work
from .potting import aimed, pots, variants
from .safeties import safeties
from .starts import Start, starts
from .trying import Candidate, Trials
from .worth import Worth

DOUBTFUL = 0.3  # chance below which a cushion is thought of
# New copies of the chosen stroke: its share without the luck of having been chosen.
FRESH, FEWEST = 30, 8
SOFT = 1.2  # m/s: of the stroke that it has before it thinks


class Potter(Searching):
    """Thinks about the coming stroke as `plan.Mind` says; the outcome depends on no budget.

    effort: strokes tried at most.
    """

    def __init__(
        self, world: World, match: Match, level: Level, seed: int = 0, effort: int = 4000
    ) -> None:
        self.level, self.match = level, match
        self.share: float | None = None
        self._world, self._rng = world.copy(), Random(seed)
        self._craft, self._effort = craft(level), effort
        if world.table is None:
            raise ValueError(f"a table is needed for {match.rules.key}, not only walls")
        self._eye = Eye(world.table, level)
        self._trials = Trials(
            self._world, Worth(self._eye, match, self._craft.position), world.table.radius
        )
        self.chosen = self._plain()
        self._work = self._search()

    @property
    def tried(self) -> int:
        """Strokes tried up to now."""
        return self._trials.tried

    @property
    def plan(self) -> Plan:
        one = self.chosen
        return Plan(one.aim.shot(), one.call, one.start.place)

    def played(self, rng: Random) -> Plan:
        one = self.chosen
        missed = self.level.missed(one.aim, rng, self._trials.radius)
        return Plan(missed.shot(), one.call, one.start.place)

    # -- the search: each of these stops after every stroke that is tried -----------------------

    def _plain(self) -> Candidate:
        """What it would play without a thought: full on the nearest ball that is on."""
        start = next(iter(starts(self._world, self.match, self._eye)))
        match = start.match
        lie, targets = lie_and_targets(self._world, match)
        seen = self._eye.hittable(start.at, lie, targets) or targets or [*lie]
        name = min(seen, key=lambda ball: abs(lie[ball] - start.at), default="")
        line = lie[name] - start.at if name else 1.0 + 0j
        return Candidate(start, declared(match, name), Attempt(heading(line), SOFT), False, -9.0)

    def _search(self) -> Work:
        yield from _each(measured(self._world.table))
        froms = [*starts(self._world, self.match, self._eye)]
        if self._breaks():
            found = yield from breaks(self._trials, places(froms, self._trials.radius))
        else:
            found = yield from self._found(froms)
        if not found:
            return
        yield from self._race(found)
        yield from self._measure()

    def _breaks(self) -> bool:
        """Is it a break with power, and not a careful one?"""
        key = self.match.rules.key
        return self.match.state.phase == BREAK and key != "straight_pool"

    def _found(self, froms: list[Start]) -> Generator[None, None, list[Candidate]]:
        """Strokes that may be worth playing."""
        found: list[Candidate] = []
        ways = yield from self._ways(froms)
        for start, way in ways[: self._craft.ways]:
            if self._spent(0.5):
                break
            found += yield from pots(self._trials, start, way, self._craft)
            self._choose(found)
        found += yield from self._refined(found)
        likely = ways[0][1].chance if ways else 0.0
        if likely < DOUBTFUL and self._craft.banks and not self.match.opening:
            found += yield from banks(self._trials, froms[0], self._craft.banks)
        if likely < self._craft.defends or not found:
            found += yield from self._safe(froms)
        self._choose(found)
        return found

    def _refined(self, found: list[Candidate]) -> Generator[None, None, list[Candidate]]:
        """The most promising strokes, varied a little."""
        more: list[Candidate] = []
        for one in sorted(found, key=lambda one: -one.worth)[: self._craft.refined]:
            for aim in variants(one):
                if one.way is not None and not self._spent(0.5):
                    other = yield from aimed(self._trials, one.start, one.way, aim)
                    more += [other] if other else []
        return more

    def _safe(self, froms: list[Start]) -> Generator[None, None, list[Candidate]]:
        left = max(1, int(0.6 * self._effort) - self.tried)
        times = 2 if self.match.opening else 1 if self._sees(froms[0]) else 3
        count = min(self._craft.safeties * times, left)
        found = yield from safeties(self._trials, froms, count, self._rng)
        if self._craft.banks and all(one.worth < 0.0 for one in found):
            found += yield from kicks(self._trials, froms[0], 2 * self._craft.banks)
        if self.match.state.phase == SECOND and self._craft.banks:
            found += yield from safeties(self._trials, froms, count // 2, self._rng, push=True)
        return found

    def _sees(self, start: Start) -> bool:
        """Can any ball that is on be hit straight?"""
        lie, targets = lie_and_targets(self._world, start.match)
        return bool(self._eye.hittable(start.at, lie, targets))

    def _ways(self, froms: list[Start]) -> Generator[None, None, list[tuple[Start, Route]]]:
        """The pots from all starts, the likeliest first."""
        ways: list[tuple[Start, Route]] = []
        for start in froms:
            lie, targets = lie_and_targets(self._world, start.match)
            ways += [(start, way) for way in self._eye.ways(start.at, lie, targets)]
            yield
        return sorted(ways, key=lambda one: -one[1].chance)

    def _race(self, found: list[Candidate]) -> Work:
        """Copies with the level's error of those that promise the most."""
        error = self.level.or_more(STEADIEST)
        first, keep = self._craft.copies[0]
        room = (self._effort - self.tried) // (2 * first)  # half for the rounds after the first
        field = sorted(found, key=lambda one: -one.worth)[: max(2, min(2 * keep, room))]
        for copies, keep in self._craft.copies:
            for one in field:
                for _ in range(0 if self._spent(1.0) else copies):
                    self._trials.copy(one, error, self._rng)
                    yield
            field = sorted(field, key=lambda one: -one.merit)[:keep]
            self.chosen = field[0]

    def _measure(self) -> Work:
        """How many strokes like the chosen one would succeed."""
        one = self.chosen
        fresh = Candidate(one.start, one.call, one.aim, one.pots, one.worth)
        for _ in range(min(FRESH, max(FEWEST, self._effort // 4))):
            self._trials.copy(fresh, self.level, self._rng)
            self.share = fresh.good / fresh.copies
            yield

    def _spent(self, share: float) -> bool:
        return self.tried >= share * self._effort

    def _choose(self, found: list[Candidate]) -> None:
        if found:
            self.chosen = max(found, key=lambda one: one.worth)


def _each(things: Iterable[object]) -> Work:
    for _ in things:
        yield
