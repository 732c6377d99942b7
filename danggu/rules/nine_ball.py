"""9-ball: the lowest ball first, and the 9 wins (WPA, section 2; section 5 since 2025)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from . import pool
from .pocketed import NUMBERS, Pocketed, without
from .state import AS_IT_LIES, BREAK, PLAY, SECOND, GameState
from .stroke import Stroke
from .verdict import Turn, Verdict, Verdicts, facts

if TYPE_CHECKING:
    from physics import Outcomes


EDITIONS = (2016, 2025)


class Rotation(Pocketed):
    """What 9-ball and 10-ball share: the lowest ball is hit first, a third foul loses the rack.

    warns: whether a player with two fouls in a row is warned at once.
    money: the ball that wins.
    """

    warns: bool
    money: ClassVar[str]

    def targets(self, turn: Turn) -> tuple[str, ...]:
        return (min(turn.state.left, key=int),) if turn.state.left else ()

    def foul(self, done: Stroke, turn: Turn) -> str:
        """Which foul the stroke was, "" for none."""
        if self.pushes(turn):
            return pool.fault(done, rail=False)
        foul = pool.fault(done, self.targets(turn))
        if foul or turn.state.phase != BREAK or done.down:
            return foul
        return "" if pool.driven(done) >= pool.TO_BREAK else pool.FEW_RAILS

    def pushes(self, turn: Turn) -> bool:
        """Whether the stroke is a push out, which only the one after the break may be."""
        return turn.call.push and turn.state.phase == SECOND

    def next_state(self, done: Stroke, turn: Turn, spot: tuple[str, ...], foul: str) -> GameState:
        """The state of the game after the stroke."""
        state = pool.counted(turn.state, turn, foul=bool(foul), warns=self.warns)
        state = without(state, done.gone - {*spot})
        second = turn.state.phase == BREAK and not foul
        state = replace(state, phase=SECOND if second else PLAY, region=AS_IT_LIES)
        return pool.handed(state) if foul else state

    def fouled(self, done: Stroke, turn: Turn, foul: str) -> Verdict:
        """The verdict on a foul: the cue ball in hand, or the rack lost after three."""
        spot = (self.money,) if self.money in done.gone else ()
        state = self.next_state(done, turn, spot, foul)
        lost = state.fouls[turn.player] >= 3
        down = tuple(ball for ball in pool.objects(done) if ball not in spot)
        reason = pool.THREE_FOULS if lost else foul
        return Verdict(
            reason, foul=True, facts=facts(done), lost=lost, down=down, spot=spot, state=state
        )

    def pushed(self, done: Stroke, turn: Turn) -> Verdict:
        """The verdict on a push out: all balls that dropped stay down except the 9 or 10."""
        spot = (self.money,) if self.money in done.down else ()
        state = self.next_state(done, turn, spot, "")
        down = tuple(ball for ball in pool.objects(done) if ball not in spot)
        asked = pool.shoot_or_return(state)
        return Verdict(
            pool.PUSHED, facts=facts(done), down=down, spot=spot, state=state, question=asked
        )


@dataclass(frozen=True, slots=True)
class NineBall(Rotation):
    """One rack.

    edition: 2016 or 2025, which racks the 9 on the foot spot instead of the 1.
    warns: whether a player with two fouls in a row is warned at once.
    """

    edition: int = 2025
    warns: bool = True
    money: ClassVar[str] = "9"
    objects: ClassVar[tuple[str, ...]] = NUMBERS[:9]

    def __post_init__(self) -> None:
        if self.edition not in EDITIONS:
            raise ValueError(f"edition must be one of {EDITIONS}, not {self.edition!r}")

    @property
    def key(self) -> str:
        return "nine_ball"

    @property
    def on_foot_spot(self) -> str:
        """The ball that is racked on the foot spot."""
        return self.money if self.edition >= 2025 else "1"

    def verdicts(self, outcomes: Outcomes, turn: Turn) -> Verdicts:
        from .pots import nine_ball_verdicts

        return nine_ball_verdicts(self, outcomes, turn)

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        foul = self.foul(done, turn)
        if foul:
            return self.fouled(done, turn, foul)
        if self.pushes(turn):
            return self.pushed(done, turn)
        down, won = pool.objects(done), self.money in done.down
        reason = pool.RACK_WON if won else pool.POTTED if down else pool.MISSED
        state = self.next_state(done, turn, (), "")
        made = bool(down)
        return Verdict(
            reason, made=made, passes=not made, won=won, facts=facts(done), down=down, state=state
        )
