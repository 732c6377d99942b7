"""10-ball: as 9-ball, but every ball is called (WPA, section 9; section 6 since 2025)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from . import pool
from .nine_ball import Rotation
from .pocketed import NUMBERS
from .state import BREAK
from .stroke import Stroke
from .verdict import Turn, Verdict, Verdicts, facts

if TYPE_CHECKING:
    from physics import Outcomes



@dataclass(frozen=True, slots=True)
class TenBall(Rotation):
    """One rack.

    early: whether the 10 wins when it is called and drops before it is the last ball; under the
    WPA's rules it is spotted and the player goes on.
    warns: whether a player with two fouls in a row is warned at once.
    """

    early: bool = False
    warns: bool = True
    money: ClassVar[str] = "10"
    objects: ClassVar[tuple[str, ...]] = NUMBERS[:10]

    @property
    def key(self) -> str:
        return "ten_ball"

    def verdicts(self, outcomes: Outcomes, turn: Turn) -> Verdicts:
        from .pots import ten_ball_verdicts

        return ten_ball_verdicts(self, outcomes, turn)

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        foul = self.foul(done, turn)
        if foul:
            return self.fouled(done, turn, foul)
        if self.pushes(turn):
            return self.pushed(done, turn)
        down = pool.objects(done)
        made = bool(down) if turn.state.phase == BREAK else bool(pool.called(done, turn))
        won = made and self._wins(done, turn)
        spot = (self.money,) if self.money in down and not won else ()
        state = self.next_state(done, turn, spot, "")
        astray = bool(down) and not made
        return Verdict(
            self._reason(turn, made=made, won=won, astray=astray),
            made=made,
            passes=not made,
            won=won,
            facts=facts(done),
            down=tuple(ball for ball in down if ball not in spot),
            spot=spot,
            state=state,
            question=pool.shoot_or_return(state) if astray else None,
        )

    def _wins(self, done: Stroke, turn: Turn) -> bool:
        last = turn.state.left == (self.money,)
        return turn.state.phase != BREAK and (
            pool.called(done, turn) == self.money and (last or self.early)
        )

    def _reason(self, turn: Turn, *, made: bool, won: bool, astray: bool) -> str:
        if made:
            return pool.RACK_WON if won else pool.POTTED
        if astray:
            return pool.SLOP
        return pool.SAFE if turn.call.safety else pool.MISSED
