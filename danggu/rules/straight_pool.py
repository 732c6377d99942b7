"""14.1: every called ball is a point, and the rack goes on (WPA, section 4)."""

from __future__ import annotations

from dataclasses import dataclass, replace

from . import pool
from .pocketed import CUE, Pocketed, without
from .spots import CENTRE, FOOT, HEAD
from .state import AS_IT_LIES, BREAK, KITCHEN, PLAY, GameState, Option, Question
from .stroke import Stroke
from .verdict import Turn, Verdict, facts

BREAKING_FOUL, SERIOUS_FOUL, GAME_WON = "breaking_foul", "serious_foul", "game_won"
BREAK_AGAIN = "break_again"
TWO = 2  # object balls that the opening break must drive to rails, and points lost otherwise
FIFTEEN = 15  # points that a third foul costs on top of its own, and balls in a full rack


@dataclass(frozen=True, slots=True)
class StraightPool(Pocketed):
    """A game to a number of points, which is each player's target; scores may be negative.

    warns: whether a player with two fouls in a row is warned at once.
    """

    warns: bool = True

    @property
    def key(self) -> str:
        return "straight_pool"

    def targets(self, turn: Turn) -> tuple[str, ...]:
        return turn.state.left

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        ball = pool.called(done, turn)
        breaks = turn.state.phase == BREAK
        if breaks and not ball and not self._opened(done):
            return self._breaking_foul(done, turn)
        foul = pool.fault(done)
        if foul:
            return self._fouled(done, turn, foul)
        down = pool.objects(done)
        if not ball:
            reason = pool.SAFE if turn.call.safety else pool.MISSED
            state = replace(self._counted(turn, foul=False), phase=PLAY, region=AS_IT_LIES)
            return Verdict(reason, facts=facts(done), spot=down, state=state)
        return self._potted(done, turn, down)

    def _opened(self, done: Stroke) -> bool:
        rails = {rail.ball for rail in done.rails}
        return (CUE in rails or done.lost) and pool.driven(done) >= TWO

    def _counted(self, turn: Turn, *, foul: bool) -> GameState:
        return pool.counted(turn.state, turn, foul=foul, warns=self.warns)

    def _potted(self, done: Stroke, turn: Turn, down: tuple[str, ...]) -> Verdict:
        state = without(self._counted(turn, foul=False), down)
        won = turn.reached(len(down))
        left = len(state.left)
        rack = FIFTEEN if not left else FIFTEEN - 1 if left == 1 else 0
        if rack:
            state = replace(state, left=self.objects)
        return Verdict(
            GAME_WON if won else pool.POTTED,
            len(down),
            made=True,
            passes=False,
            won=won,
            facts=facts(done),
            down=down,
            rack=rack,
            state=replace(state, phase=PLAY, region=AS_IT_LIES),
        )

    def _fouled(self, done: Stroke, turn: Turn, foul: str) -> Verdict:
        """One point is lost; a third foul in a row costs fifteen more and calls for a new break."""
        state = self._counted(turn, foul=True)
        seen, spot = facts(done), (*pool.objects(done), *(b for b in done.off if b != CUE))
        if state.fouls[turn.player] < 3:
            region = KITCHEN if done.lost else AS_IT_LIES
            state = replace(state, phase=PLAY, region=region)
            return Verdict(foul, -1, foul=True, facts=seen, spot=spot, state=state)
        again = self.start(turn.players)
        fouls = tuple(0 if i == turn.player else n for i, n in enumerate(state.fouls))
        warned = tuple(i != turn.player and said for i, said in enumerate(state.warned))
        return Verdict(
            SERIOUS_FOUL,
            -1 - FIFTEEN,
            foul=True,
            passes=False,
            facts=seen,
            rack=FIFTEEN,
            state=replace(again, fouls=fouls, warned=warned),
        )

    def _breaking_foul(self, done: Stroke, turn: Turn) -> Verdict:
        """Two points are lost; it does not count as one of three fouls in a row (4.10, 4.11)."""
        region = KITCHEN if done.lost else AS_IT_LIES
        accepted = replace(turn.state, phase=PLAY, region=region)
        again = replace(self.start(turn.players), fouls=turn.state.fouls, warned=turn.state.warned)
        asked = Question((
            Option(pool.ACCEPT, True, accepted),
            Option(BREAK_AGAIN, False, again, FIFTEEN),
        ))  # fmt: skip
        spot = (*pool.objects(done), *(ball for ball in done.off if ball != CUE))
        return Verdict(
            BREAKING_FOUL,
            -TWO,
            foul=True,
            facts=facts(done),
            spot=spot,
            state=accepted,
            question=asked,
        )


# -- where the last ball and the cue ball go when fourteen are racked (4.8) ------------------------

RACK, DOWN, ELSEWHERE, STAYS = "rack", "down", "elsewhere", "as_is"


def racked(last: str, cue: str) -> tuple[str, str]:
    """Where the last object ball and the cue ball go before fourteen balls are racked.

    last, cue: where they lie: RACK (in the way of the rack), HEAD (in the way of that spot),
    KITCHEN (behind the head string) or ELSEWHERE; for the last ball also DOWN.
    ValueError for any other place.
    """
    for name, place in (("last", last), ("cue", cue)):
        if place not in (RACK, HEAD, KITCHEN, ELSEWHERE) and (name, place) != ("last", DOWN):
            raise ValueError(f"no such place of the {name} ball: {place!r:.60}")
    both = cue == RACK
    if last == DOWN or (last == RACK and both):
        return FOOT, KITCHEN if both else STAYS
    if last == RACK:
        return CENTRE if cue == HEAD else HEAD, STAYS
    if not both:
        return STAYS, STAYS
    return STAYS, {HEAD: CENTRE, KITCHEN: HEAD}.get(last, KITCHEN)
