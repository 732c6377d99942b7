"""What a lie is worth to the player whose turn it is, and so what a stroke is worth.

All is in strokes that score: 1 is a ball potted, and what is good for one player is as bad for the
other.  A lie is judged by the best pot that it offers, as a player of the same level sees it.
"""

from __future__ import annotations

from danggu.rules.match import Match
from danggu.rules.snooker import MOST, value
from danggu.rules.state import ANYWHERE, AS_IT_LIES, Option
from danggu.rules.verdict import Verdict
from physics import World

from .chances import Eye, Lie
from .declaring import FREE_PYRAMID
from .lies import lying

GAME = 4.0  # of winning
TURN = 1.0  # of staying at the table, on top of what is potted
DEFENDED = 0.3  # of what a turn is usually worth is lost in a lie where one can only play safe
HIDDEN = 0.3  # and so much on top where no ball can be hit straight
NEAR, FAR = 0.2, 0.8  # m between cue ball and ghost, when it is in hand and otherwise
REPLAYED = 0.5  # of the usual chance, in a lie in which a player has failed before
BY_BALLS = {"eight_ball", "nine_ball", "ten_ball"}
"""Games in which a pot brings no points."""
IN_ORDER = {"nine_ball", "ten_ball"}


class Worth:
    """Judges strokes of a match for the player at the table, as that player sees a table."""

    def __init__(self, eye: Eye, match: Match, position: float = 1.0) -> None:
        self.eye, self.match, self.position = eye, match, position
        self._known: tuple[float, float] | None = None
        self._unit = 1.0 / MOST if match.rules.key == "snooker" else 1.0

    def after(self, match: Match, verdict: Verdict, world: World) -> float:
        """Of a stroke with that verdict, after which balls lie as in `world`; `match` is the one
        before, with the call."""
        gain = self._unit * (verdict.points - verdict.gift)
        if match.rules.key in BY_BALLS:
            gain = float(verdict.made)
        then = match.after(verdict)
        lie = lying(world, then, verdict.spot)
        return gain + self.coming(then, lie, match.at, verdict.rack)

    def coming(self, match: Match, lie: Lie, me: int, rack: int = 0) -> float:
        """Of what comes, to player `me`."""
        if match.winner is not None:
            return GAME if match.winner == me else -GAME
        if match.over:
            return 0.0
        if match.asked is not None:
            best = max(self.option(match, option, lie) for option in match.asked.options)
            return best if match.at == me else -best
        worth = self.position * self.turn(match, lie, rack)
        return worth if match.at == me else -worth

    def option(self, match: Match, option: Option, lie: Lie) -> float:
        """Of an answer, to the player who gives it."""
        then = match.answered(option.key)
        if option.restore:
            worth = (REPLAYED - 1.0) * self._chances[0] * (TURN + self._unit)
        else:
            there = {
                name: at
                for name, at in lie.items()
                if name == match.cue or name in option.state.left
            }
            worth = self.turn(then, there, option.rack)
        return worth if then.at == match.at else -worth

    def turn(self, match: Match, lie: Lie, rack: int = 0) -> float:
        """Of a turn, to the player who has it."""
        chance, placed = self._chances
        usual = chance * (TURN + self._unit)
        if rack:
            return 0.2 * usual
        state, cue = match.state, match.cue
        balls = {name: at for name, at in lie.items() if name != cue}
        targets = [name for name in match.rules.targets(match.turn) if name in balls]
        if not targets or match.rules.key == FREE_PYRAMID:
            return 0.0
        if state.region or cue not in lie:
            in_part = state.region not in (ANYWHERE, AS_IT_LIES)
            free = 0.5 * (chance + placed) if in_part else placed
            return free * max(self._prize(match, name) for name in targets) - usual
        ways = self.eye.ways(lie[cue], balls, targets)
        best = max((way.chance * self._prize(match, way.ball) for way in ways), default=0.0)
        least = -DEFENDED * usual  # a player without a pot plays safe
        if best - usual < least and not self.eye.hittable(lie[cue], balls, targets):
            return least - HIDDEN
        return max(best - usual, least)

    @property
    def _chances(self) -> tuple[float, float]:
        """Of a pot as it comes, and of one from a place that is chosen."""
        if self._known is None:
            self._known = self.eye.usual(FAR), self.eye.usual(NEAR)
        return self._known

    def _prize(self, match: Match, ball: str) -> float:
        """Of potting that ball."""
        left = match.state.left
        if match.rules.key == "snooker":
            return TURN + self._unit * value(ball)
        wins = match.rules.key in IN_ORDER and len(left) == 1
        wins |= match.rules.key == "eight_ball" and ball == "8"
        return GAME if wins else TURN + 1.0
