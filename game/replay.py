"""Playing a record again, and saying whether it comes out the same."""

from __future__ import annotations

from collections.abc import Iterator

from .actions import Action
from .play import Game
from .record import Record, RecordError, Witness, built_with, digest


class Replay:
    """A record that is being played into a game that began as the record says."""

    def __init__(self, record: Record, game: Game) -> None:
        self.record, self.game = record, game
        self.paused = self.done = False
        self.shots = 0
        """How many shots are over."""
        self.differs: int | None = None
        """The first shot that came out differently, from 1, or one more than the last: the end."""
        self._next = 0
        self.witness = Witness(game, self._shot)

    @property
    def end(self) -> int:
        """The tick at which it is over."""
        return self.record.last

    def due(self, tick: int) -> Iterator[tuple[int, Action]]:
        """Take the actions up to and including `tick`, in their order."""
        actions = self.record.actions
        while self._next < len(actions) and actions[self._next][0] <= tick:
            self._next += 1
            yield actions[self._next - 1]

    def before(self, action: Action) -> None:
        """An action is about to be done."""
        self.witness.before()

    def after(self) -> None:
        """The action has been done."""
        self.witness.after()

    def passed(self) -> None:
        """Time has passed."""
        self.witness.passed()
        if not self.done and self.game.tick >= self.end and self._next == len(self.record.actions):
            self._conclude()

    def close(self) -> None:
        """It was left."""

    def perform(self, action: Action) -> None:
        """Do an action of the record; RecordError if there is none like it."""
        try:
            self.game.perform(action)
        except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
            what = f"{self.record.name}: cannot do {list(action)!r} at tick {self.game.tick}"
            raise RecordError(f"{what} ({error})") from None

    def _shot(self, tick: int, found: str) -> None:
        recorded = self.record.shots
        self.shots += 1
        same = self.shots <= len(recorded) and recorded[self.shots - 1] == found
        if not same and self.differs is None and not self._cut:
            self.differs = self.shots

    @property
    def _cut(self) -> bool:
        """Was the record cut off before this shot was over?"""
        return self.record.end is None and self.shots > len(self.record.shots)

    def _conclude(self) -> None:
        self.done = True
        end = self.record.end
        missing = self.shots < len(self.record.shots)
        if self.differs is None and (missing or (end and end[1] != digest(self.game))):
            self.differs = self.shots + 1

    @property
    def state(self) -> str:
        """How it stands: "playing" "paused" "same" "differs"."""
        if self.differs is not None:
            return "differs"
        return "same" if self.done else "paused" if self.paused else "playing"

    def verdict(self) -> str:
        """Say how it came out, in a sentence."""
        of = len(self.record.shots)
        if self.differs is not None:
            what = f"shot {self.differs} of {of} came out differently"
            if self.differs > of:
                what = f"all {of} shots came out the same, but the balls' end did not"
            return f"{what}\n  recorded with {self.record.built}\n  replayed with {built_with()}"
        if not self.done:
            return f"left after {self.shots} of {of} shots, the same so far"
        cut = " (the record was cut off)" if self.record.end is None else ""
        return f"the same, shots: {self.shots}{cut}"


def headless(record: Record, game: Game) -> Replay:
    """Play a record without a window, as fast as it goes."""
    replay = Replay(record, game)
    for tick, action in replay.due(record.last):
        game.advance(tick - game.tick)
        replay.passed()
        replay.before(action)
        replay.perform(action)
        replay.after()
    game.advance(record.last - game.tick)
    replay.passed()
    return replay
