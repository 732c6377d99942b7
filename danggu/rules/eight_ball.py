"""8-ball: seven balls of one group, then the 8 (WPA, section 3; section 4 since 2025)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from . import pool
from .pocketed import NUMBERS, Pocketed, without
from .reasons import EIGHT, EIGHT_ON_BREAK, ILLEGAL_BREAK
from .state import AS_IT_LIES, BREAK, KITCHEN, PLAY, GameState, Option, Question
from .stroke import Stroke
from .verdict import Turn, Verdict, Verdicts, facts

if TYPE_CHECKING:
    from physics import Outcomes


SOLIDS, STRIPES = "solids", "stripes"
GROUPS = {SOLIDS: NUMBERS[:7], STRIPES: NUMBERS[8:]}
SPOT_AND_ACCEPT, SPOT_IN_HAND, REBREAK = "spot_and_accept", "spot_in_hand", "rebreak"
RERACK, RERACK_OFFENDER, IN_HAND_HEAD = "rerack", "rerack_offender", "in_hand_head"


def group_of(ball: str) -> str:
    """The group of a ball, "" for the 8."""
    return next((group for group, balls in GROUPS.items() if ball in balls), "")


@dataclass(frozen=True, slots=True)
class EightBall(Pocketed):
    """One rack; a call names a ball and a pocket, or a safety."""

    @property
    def key(self) -> str:
        return "eight_ball"

    def targets(self, turn: Turn) -> tuple[str, ...]:
        left, group = turn.state.left, turn.state.group(turn.player)
        if turn.state.phase == BREAK:
            return left
        # while the table is open any ball but the 8, unless only the 8 is left
        own = tuple(b for b in left if (b in GROUPS[group] if group else b != EIGHT))
        return own or (EIGHT,)

    def verdicts(self, outcomes: Outcomes, turn: Turn) -> Verdicts:
        from .pots import eight_ball_verdicts

        return eight_ball_verdicts(self, outcomes, turn)

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        if turn.state.phase == BREAK:
            return self._broken(done, turn)
        legal = self.targets(turn)
        foul = pool.fault(done, legal)
        if EIGHT in done.gone:
            return self._eight(done, turn, foul)
        state = replace(without(turn.state, done.gone), phase=PLAY, region=AS_IT_LIES)
        down, seen = pool.objects(done), facts(done)
        if foul:
            return Verdict(foul, foul=True, facts=seen, down=down, state=pool.handed(state))
        ball = pool.called(done, turn)
        if ball not in legal:
            reason = pool.SAFE if turn.call.safety else pool.MISSED
            return Verdict(reason, facts=seen, down=down, state=state)
        state = self._grouped(state, turn, ball)
        return Verdict(pool.POTTED, made=True, passes=False, facts=seen, down=down, state=state)

    def _eight(self, done: Stroke, turn: Turn, foul: str) -> Verdict:
        """The 8 is gone: if called, last and without a foul it wins, otherwise it loses (3.8)."""
        won = not foul and self.targets(turn) == (EIGHT,) and pool.called(done, turn) == EIGHT
        return Verdict(
            pool.RACK_WON if won else foul or pool.RACK_LOST,
            made=won,
            foul=bool(foul),
            won=won,
            lost=not won,
            facts=facts(done),
            down=pool.objects(done),
            state=without(turn.state, done.gone),
        )

    def _grouped(self, state: GameState, turn: Turn, ball: str) -> GameState:
        """The first ball that drops as called settles the groups (3.4)."""
        own = group_of(ball)
        if state.groups or not own:
            return state
        other = STRIPES if own == SOLIDS else SOLIDS
        # of more than two players, every second one is on the same side
        sides = ((i - turn.player) % 2 for i in range(turn.players))
        return replace(state, groups=tuple(other if side else own for side in sides))

    # -- the break (3.3) -----------------------------------------------------------------------

    def _broken(self, done: Stroke, turn: Turn) -> Verdict:
        foul = pool.fault(done)
        state = replace(without(turn.state, done.gone), phase=PLAY, region=AS_IT_LIES)
        if EIGHT in done.gone:
            return self._eight_on_break(done, turn, foul, state)
        down, seen = pool.objects(done), facts(done)
        if not down and pool.driven(done) < pool.TO_BREAK:
            asked = self._illegal(turn, replace(state, region=KITCHEN if done.lost else AS_IT_LIES))
            first = asked.options[0].state
            return Verdict(ILLEGAL_BREAK, foul=bool(foul), facts=seen, state=first, question=asked)
        if foul:
            asked = self._fouled(state, lost=done.lost)
            first = asked.options[0].state
            return Verdict(foul, foul=True, facts=seen, down=down, state=first, question=asked)
        if not down:
            return Verdict(pool.MISSED, facts=seen, state=state)
        return Verdict(pool.POTTED, made=True, passes=False, facts=seen, down=down, state=state)

    def _illegal(self, turn: Turn, state: GameState) -> Question:
        again, racked = self.start(turn.players), len(self.objects)
        return Question((
            Option(pool.ACCEPT, True, state),
            Option(RERACK, True, again, racked),
            Option(RERACK_OFFENDER, False, again, racked),
        ))  # fmt: skip

    def _fouled(self, state: GameState, *, lost: bool) -> Question:
        """In hand behind the head string, or as the balls lie if the cue ball is still there."""
        in_hand = replace(state, region=KITCHEN)
        accepted = in_hand if lost else state
        options = (Option(IN_HAND_HEAD, True, in_hand), Option(pool.ACCEPT, True, accepted))
        return Question(options, optional=True)

    def _eight_on_break(self, done: Stroke, turn: Turn, foul: str, state: GameState) -> Verdict:
        """Neither a win nor a loss: the breaker or, after a foul, the opponent chooses between
        spotting the 8 and racking again."""
        spotted = replace(state, left=(*state.left, EIGHT), region=KITCHEN if foul else AS_IT_LIES)
        first = SPOT_IN_HAND if foul else SPOT_AND_ACCEPT
        options = (
            Option(first, True, spotted, spot=(EIGHT,)),
            Option(REBREAK, True, self.start(turn.players), len(self.objects)),
        )
        return Verdict(
            foul or EIGHT_ON_BREAK,
            foul=bool(foul),
            passes=bool(foul),
            facts=facts(done),
            down=tuple(ball for ball in pool.objects(done) if ball != EIGHT),
            state=spotted,
            question=Question(options, shooter=not foul),
        )
