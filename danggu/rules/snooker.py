"""Snooker: reds and colours in turn; a foul gives the opponent points (WPBSA, section 3)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar, NamedTuple

from .pocketed import CUE, Pocketed, without
from .pool import WRONG_BALL, spoiled
from .state import AS_IT_LIES, PLAY, GameState, Option, Question
from .state import D as IN_D
from .stroke import Act, Stroke
from .verdict import NO_BALL, Turn, Verdict, facts

RED, COLOUR = "red", "colour"
COLOURS = ("yellow", "green", "brown", "blue", "pink", "black")
VALUES = {RED: 1, **{ball: value for value, ball in enumerate(COLOURS, 2)}}
LEAST, MOST = 4, 7
REDS = 15

POTTED, MISS, FRAME_WON, FRAME_LOST, TIED = (
    "potted", "miss", "frame_won", "frame_lost", "black_again",
)  # fmt: skip
NOT_ON, BEHIND_FREE, PUSHED = "ball_not_on", "behind_free", "touching_moved"
PLAY_ON, PUT_IN, REPLAY = "play_on", "put_in_again", "replay"

# seen by a referee; these cost the value of the ball on, whichever ball is concerned (3.11 a)
OF_THE_BALL_ON = {
    "moving", "double_hit", "feet", "out_of_turn", "played_from_outside_D", "outside_d", "jumps",
}  # fmt: skip
SEVEN = {"off_the_table", "struck_as_cue", "reds_in_succession"}


def kind(ball: str) -> str:
    """The name of a ball without its number: "red" for "red7"."""
    return ball.rstrip("0123456789")


def value(ball: str) -> int:
    """The points of a ball; 0 for the cue ball."""
    return VALUES.get(kind(ball), 0)


class On(NamedTuple):
    """The ball on.

    value: points.
    balls: names of the balls that are on.
    free: name of the free ball, or "".
    """

    value: int
    balls: tuple[str, ...]
    free: str = ""

    def holds(self, ball: str) -> bool:
        return ball in self.balls or (ball == self.free != "")


@dataclass(frozen=True, slots=True)
class Snooker(Pocketed):
    """One frame.

    miss: whether, after a stroke that missed the ball on, the opponent may have it replayed from
    where all balls lay (3.14), unless a player needs snookers.
    """

    miss: bool = True
    objects: ClassVar[tuple[str, ...]] = (
        *(f"{RED}{number}" for number in range(1, REDS + 1)),
        *COLOURS,
    )

    @property
    def key(self) -> str:
        return "snooker"

    def start(self, players: int) -> GameState:
        return replace(Pocketed.start(self, players), phase=PLAY, on=RED, region=IN_D)

    def on(self, done: Stroke | None, turn: Turn) -> On:
        """The ball on. If no colour is nominated, the one that is hit first counts as nominated.
        A red is none, whatever is said."""
        state, call = turn.state, turn.call
        free = call.ball if state.free else ""
        if state.on == COLOUR:
            named = call.ball if call.ball in COLOURS else ""
            if not named and done and len(done.first) == 1 and done.first[0] in COLOURS:
                named = done.first[0]
            return On(value(named), (named,) if named else ())
        balls = tuple(ball for ball in state.left if kind(ball) == (state.on or RED))
        return On(VALUES[state.on or RED], balls, "" if free in balls else free)

    def targets(self, turn: Turn) -> tuple[str, ...]:
        on = self.on(None, turn)
        if on.free:
            return (on.free,)
        if turn.state.free:
            return turn.state.left
        colours = tuple(ball for ball in turn.state.left if ball in COLOURS)
        return on.balls or colours

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        on = self.on(done, turn)
        penalty = self._penalty(done, turn, on)
        return self._fouled(done, turn, on, penalty) if penalty else self._fair(done, turn, on)

    # -- a fair stroke -------------------------------------------------------------------------

    def _fair(self, done: Stroke, turn: Turn, on: On) -> Verdict:
        down = done.down
        if turn.state.on == RED:
            points = len(down)
        else:
            points = on.value if down else 0
        # a colour stays down only when it was on in its order; any other is spotted
        stays = () if turn.state.on == COLOUR else on.balls
        spot = tuple(ball for ball in down if ball in COLOURS and ball not in stays)
        left = without(turn.state, set(down) - {*spot})
        state = replace(left, on=self._next(turn.state, left, points), free=False)
        state = replace(state, region=AS_IT_LIES, touching=_touching(done))
        verdict = Verdict(
            POTTED if points else "missed",
            points,
            made=points > 0,
            passes=not points,
            facts=facts(done),
            down=tuple(ball for ball in down if ball not in spot),
            spot=spot,
            state=state,
        )
        return self._decided(verdict, turn) if not state.left else verdict

    def _next(self, before: GameState, after: GameState, points: int) -> str:
        if points and before.on == RED:
            return COLOUR
        return lowest(after)

    # -- fouls (3.11) --------------------------------------------------------------------------

    def _penalty(self, done: Stroke, turn: Turn, on: On) -> int:
        """Points for the opponent, 0 after a fair stroke."""
        values = [*self._contacts(done, turn, on), *(self._act(act) for act in done.acts)]
        values += [0 if b == CUE else value(b) for b in done.down if not on.holds(b)]
        values += [value(ball) for ball in done.off]
        if done.rest.hidden and done.rest.hidden == on.free and not self._last_two(turn):
            values.append(0)
        if not values:
            return 0
        unnamed = turn.state.on == COLOUR and not on.balls
        return MOST if unnamed else max(LEAST, on.value, *values)

    def _contacts(self, done: Stroke, turn: Turn, on: On) -> list[int]:
        """Values of the balls that should not have been hit first, none if the hit was fair."""
        if touched := self._against(turn, on):
            # a touching ball that is on counts as hit, and moving it is a push (3.8)
            moved = bool(done.touches) and done.touches[0].what in touched
            return [value(done.touches[0].what)] if moved else []
        first = done.first
        if not first:
            return [0]
        if on.free:
            fair = on.free in first and all(on.holds(ball) for ball in first)
        else:
            reds = all(kind(ball) == RED for ball in first)
            fair = all(on.holds(ball) for ball in first) and (len(first) == 1 or reds)
        return [] if fair else [0 if on.holds(ball) else value(ball) for ball in first]

    def _against(self, turn: Turn, on: On) -> list[str]:
        """The balls that the cue ball touches, if one of them is on."""
        touched = [ball for pair in turn.state.touching if CUE in pair for ball in pair]
        return touched if any(on.holds(ball) for ball in touched) else []

    def _act(self, act: Act) -> int:
        if act.what in SEVEN:
            return MOST
        return 0 if act.what in OF_THE_BALL_ON else max(value(act.ball), value(act.about))

    def _last_two(self, turn: Turn) -> bool:
        return {*turn.state.left} <= {"pink", "black"}

    def _fouled(self, done: Stroke, turn: Turn, on: On, penalty: int) -> Verdict:
        gone = done.gone - {CUE}
        spot = tuple(ball for ball in COLOURS if ball in gone)
        left = without(turn.state, gone - {*spot})
        region = IN_D if done.lost else AS_IT_LIES
        state = replace(left, on=lowest(left), free=done.rest.snookered, region=region)
        state = replace(state, touching=_touching(done))
        missed = self.miss and not any(on.holds(ball) for ball in done.first)
        verdict = Verdict(
            self._reason(done, turn, on),
            foul=True,
            facts=facts(done),
            gift=penalty,
            down=tuple(ball for ball in done.down if ball in gone and ball not in spot),
            spot=spot,
            state=state,
        )
        if turn.state.left == ("black",):
            return self._decided(verdict, turn)
        if missed and not self._needs_snookers(turn, state, penalty):
            verdict = replace(verdict, reason=MISS if done.first else NO_BALL)
            return replace(verdict, question=self._asked(turn, state, miss=True))
        return replace(verdict, question=self._asked(turn, state, miss=False))

    def _reason(self, done: Stroke, turn: Turn, on: On) -> str:
        """Which foul it was: the first of several in the order in which a referee calls them."""
        if spoilt := spoiled(done):
            return spoilt
        if not done.first:
            return NO_BALL
        if self._contacts(done, turn, on):
            return PUSHED if self._against(turn, on) else WRONG_BALL
        return BEHIND_FREE if all(on.holds(ball) for ball in done.down) else NOT_ON

    def _asked(self, turn: Turn, state: GameState, *, miss: bool) -> Question:
        """Play on, have the offender play from here or, after a miss, replay from where all lay."""
        put_in = Option(PUT_IN, False, replace(state, free=False))
        replay = Option(REPLAY, False, turn.state, restore=True)
        plain = (Option(PLAY_ON, True, state), put_in)
        return Question((*plain, replay) if miss else plain, optional=True)

    def _needs_snookers(self, turn: Turn, after: GameState, penalty: int) -> bool:
        """Whether a player could not win by pots alone, before the stroke or after it."""
        lead = turn.score - turn.against
        return abs(lead) > remaining(turn.state) or abs(lead - penalty) > remaining(after)

    # -- the end (3.4) -------------------------------------------------------------------------

    def _decided(self, verdict: Verdict, turn: Turn) -> Verdict:
        """Only the black was left: a pot or a foul ends the frame, or a tie respots the black."""
        lead = turn.score + verdict.points - turn.against - verdict.gift
        if lead:
            reason = FRAME_WON if lead > 0 else FRAME_LOST
            return replace(verdict, reason=reason, won=lead > 0, lost=lead < 0)
        state = replace(turn.state, left=("black",), on="black", region=IN_D, free=False)
        options = (Option("shoot", True, state), Option(PUT_IN, False, state))
        return replace(
            verdict, reason=TIED, passes=True, down=(), spot=("black",), state=state,
            question=Question(options),
        )  # fmt: skip


def lowest(state: GameState) -> str:
    """What is on as an inning begins: a red, or the lowest colour left."""
    if any(kind(ball) == RED for ball in state.left):
        return RED
    return next((ball for ball in COLOURS if ball in state.left), "black")


def remaining(state: GameState) -> int:
    """Points still on the table, with a black for each red."""
    colours = sum(value(ball) for ball in state.left if ball in COLOURS)
    reds = sum(kind(ball) == RED for ball in state.left)
    return colours + reds * (1 + MOST) + (MOST if state.on == COLOUR else 0)


def _touching(done: Stroke) -> tuple[tuple[str, str], ...]:
    return tuple(pair for pair in done.rest.touching if CUE in pair)
