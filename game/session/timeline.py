"""Which moment of a shot is on show, and how fast time passes: pause, slow motion, scrubbing.

The head is live, at the world's own moment, unless it has been put somewhere into the past: then
the picture shows what the log knows of that moment, and the world waits.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import ceil, isfinite
from typing import TYPE_CHECKING

from danggu.rules.stroke import counts
from game.aim.preview import GLIMPSE, rests
from physics import Event

from .ticks import TICKS, seconds

if TYPE_CHECKING:
    from .session import Game

RATES = (1, 2, 4, 8, 16, 32, 64)
"""Speeds of time in eighths: from an eighth to eight times."""
USUAL = 8
HEEDED = ("ball", "cushion", "rest")
"""Kinds of events that a player is told of; any other is passed over."""
FRAME = TICKS // 60
"""What a single frame is while time stands."""
LONGEST_SHOT = 300
"""Seconds after which a shot that is to be skipped, or scrubbed on, is left running."""


@dataclass(slots=True)
class Playhead:
    """`at`: ticks since the shot began that are on show, None while live; `playing`: it runs."""

    rate: int = USUAL
    at: int | None = None
    playing: bool = False
    part: int = 0
    """Eighths of a tick that have not passed yet: no frame rate loses any."""
    told: tuple[object, list[Event]] = (None, [])
    """The events of the log as far as they have been asked for, and of which shot they are."""

    def passed(self, ticks: int) -> int:
        """The ticks that pass in the shot while `ticks` pass on the clock."""
        whole, self.part = divmod(ticks * self.rate + self.part, USUAL)
        return whole

    def live(self) -> None:
        """Show the world as it is."""
        self.at, self.playing = None, False

    @property
    def label(self) -> str:
        """The speed as it is written: ×1/8 ... ×8."""
        return f"×{self.rate // 8}" if self.rate >= USUAL else f"×1/{USUAL // self.rate}"


def length(game: Game) -> int:
    """Ticks from the shot's beginning to the world's present."""
    return max(0, ceil((game.world.time - game.began) * TICKS))


def end(game: Game) -> int:
    """Ticks from the shot's beginning to the last thing that happened, or the present."""
    log = game.world.log
    if game.moving or not len(log):
        return length(game)
    return max(0, ceil((log[-1].time - game.began) * TICKS))


def reviewed(game: Game) -> bool:
    """Show the last shot, if there is one to be shown; returns whether there is."""
    if not game.shown_shot and not game.moving and len(game.world.log) and game.aim.box is None:
        game.shown_shot = True
    return game.shown_shot


def put(game: Game, ticks: int) -> None:
    """Show the moment `ticks` after the shot began; what has not happened yet happens now.

    A shot without an end goes on by LONGEST_SHOT at most.
    """
    if not reviewed(game):
        return
    head, last = game.head, end(game)
    head.playing = False
    game.paused = game.paused or game.moving
    if ticks > last and game.moving:
        game.run(min(ticks - last, LONGEST_SHOT * TICKS))
        last = ticks
    head.at = max(0, ticks) if ticks < last else None
    game.read()


def now(game: Game) -> int:
    """The ticks on show."""
    return end(game) if game.head.at is None else game.head.at


def pause(game: Game) -> None:
    """Hold or go on; after the shot, show it once more."""
    head = game.head
    if game.moving and head.at is None:
        game.paused = not game.paused
    elif reviewed(game):
        if head.at is None:
            head.at = 0
            head.playing = False
        head.playing = not head.playing
        game.read()
    else:
        game.paused = not game.paused


def frame(game: Game) -> None:
    """One frame on."""
    if game.moving or game.head.at is not None:
        put(game, now(game) + FRAME)


def back(game: Game) -> None:
    """One frame back."""
    put(game, now(game) - FRAME)


def event(game: Game, way: int) -> None:
    """Go to the next event (1) or the one before (-1)."""
    if not reviewed(game):
        return
    at = now(game)
    times = (e.time for e in notable(game))
    marks = sorted({max(0, ceil((time - game.began) * TICKS)) for time in times})
    if way < 0:
        put(game, max((mark for mark in marks if mark < at), default=0))
    elif ahead := [mark for mark in marks if mark > at]:
        put(game, ahead[0])
    elif game.moving and isfinite(game.world.next_event):  # a ball that only spins has none
        put(game, max(at + 1, ceil((game.world.next_event - game.began) * TICKS)))


def home(game: Game) -> None:
    """The beginning of the shot."""
    put(game, 0)


def skip(game: Game) -> None:
    """Go on to the end of the shot at once; where it has none, as far as is foretold of it."""
    game.head.live()
    for _ in range(LONGEST_SHOT if rests(game.world) else int(GLIMPSE)):
        game.run(TICKS)
    game.read()


def faster(game: Game, steps: int) -> None:
    """Let time pass faster by so many steps, or slower."""
    head = game.head
    at = RATES.index(head.rate) + steps
    head.rate = RATES[min(max(at, 0), len(RATES) - 1)]


def advance(game: Game, ticks: int) -> None:
    """Let the clock run on: the balls roll, or the shot is shown once more."""
    head = game.head
    if head.at is not None:
        if head.playing:
            _replay(game, head.passed(ticks))
    elif game.moving and not game.paused:
        game.run(head.passed(ticks))


def _replay(game: Game, ticks: int) -> None:
    head = game.head
    assert head.at is not None, "only what has been put back is replayed"
    head.at += ticks
    beyond = head.at - end(game)
    if beyond >= 0:
        head.live()
        game.paused = False
        game.run(beyond)  # what is left of the frame is not lost: frames differ in length
    game.version += 1
    game.read()


def events(game: Game) -> Sequence[Event]:
    """The shot's events, worked out of the log once, which takes some 25 µs each."""
    shot, log = (game.stamp, game.began), game.world.log
    if game.head.told[0] != shot or len(game.head.told[1]) > len(log):
        game.head.told = shot, []
    told = game.head.told[1]
    told += log[len(told) :]
    return told


def notable(game: Game) -> list[Event]:
    """The events that a player heeds, but for cushions that were not left."""
    return [event for event in events(game) if event.kind in HEEDED and counts(event)]


def passed(game: Game) -> int:
    """How many events have passed at the moment on show."""
    if game.head.at is None:
        return len(game.world.log)
    return bisect_right(events(game), moment(game), key=lambda event: event.time)


def runs(game: Game) -> bool:
    """Do the balls run before the player's eyes, for the first time or once more?"""
    if game.head.at is not None:
        return game.head.playing
    return game.shown_shot and game.moving


def known(game: Game) -> float:
    """World time up to which traces stand: while the balls run, the last event's."""
    if not runs(game):
        return moment(game)
    count = passed(game)
    return events(game)[count - 1].time if count else game.began


def moment(game: Game) -> float:
    """World time on show, seconds."""
    at = game.head.at
    return game.world.time if at is None else game.began + seconds(at)


HANDLERS: dict[str, Callable[..., None]] = {
    "pause": pause, "frame": frame, "back": back, "event": event, "home": home, "scrub": put,
    "faster": faster, "skip": skip,
}  # fmt: skip
