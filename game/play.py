"""The game without a window: what an action does, and what a stretch of time does."""

from __future__ import annotations

import random
from cmath import phase
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import degrees, hypot
from typing import ClassVar, NamedTuple

from physics import Cloth, EventBudgetError, State, World, laws

from . import choices, setup
from .actions import Action
from .aim import Aim, plain
from .clock import TICKS, seconds, shares
from .preview import NO_STORY, Preview, Story, forecast, preview

FRAME = TICKS // 60
"""What a single frame is while the game is paused."""
READING = TICKS // 8
"""How often the read-outs change while balls move: faster cannot be read."""

MOST_TRACED = 6
LONGEST_SHOT = 300
"""Seconds after which a shot that is to be skipped is left running."""


@dataclass(frozen=True, slots=True)
class Notice:
    """Something to tell the player: a key of the texts, and whether it is an error."""

    key: str
    error: bool = False


class Terms(NamedTuple):
    """Laws and cloth that a table came with."""

    ball_law: laws.BallLaw
    cushion_law: laws.CushionLaw
    cloth: Cloth


class Game:
    """World, aim and everything else that actions change.  It never looks at a clock."""

    def __init__(
        self, world: World, substeps: int = 6, seed: int = 0, table: str = "medium"
    ) -> None:
        self.substeps = substeps
        self.engine, self.language = "exact", "en"
        self.help = self.sheet = self.over = False
        self.tick = self.calls = self.events = self.stamp = 0
        """`stamp` goes up whenever somebody, and not time, has changed what will happen."""
        self.version = 0
        """Goes up with every change: equal versions look the same."""
        self.news = 0
        """Goes up when anything but the balls' places has changed, or is due to be read again."""
        self._rng = random.Random(seed)
        self.begin(world, table)

    def begin(self, world: World, table: str) -> None:
        """Play on another table."""
        self.world, self.table = world, table
        self.cue = setup.cue_ball(world)
        self.aim = Aim()
        self.law, self.cloth = setup.law_of(world), "table"
        self.paused = False
        self.notice: Notice | None = None
        self.shots = 0
        self.began = world.time
        self.shown_shot = False
        """Is the last shot on show, rather than the next one?"""
        self.came_with = Terms(world.ball_law, world.cushion_law, world.cloth)
        self._lay = self._layout()
        self._previewed: tuple[object, Preview | None] = (None, None)
        self._forecast: tuple[object, Story] = (None, NO_STORY)
        self._counts: tuple[object, tuple[int, int]] = (None, (0, 0))
        self._changed()
        self.moving = self._moves()
        if self.moving:
            self._take_over_launch()
        self._read()

    # -- what an action does -------------------------------------------------------------------

    def perform(self, action: Action) -> None:
        """Do what the player wants; anything unknown raises KeyError."""
        handler = self._handlers[action.name]
        if action.name not in ("language", "help", "settings"):
            self.notice = None
        if action.value is None:
            handler(self)
        else:
            handler(self, action.value)
        self.version += 1
        self.news += 1

    def _edit(self, box: int = 0) -> None:
        self.shown_shot = self.shown_shot and self.moving
        self.aim.edit(box)

    def _clear(self) -> None:
        self._edit()
        self.aim.edit(clear=True)

    def _type(self, text: str) -> None:
        if self.aim.box is None:
            self._edit()
        self.aim.type(text)

    def _erase(self) -> None:
        self.aim.erase()

    def _enter(self) -> None:
        self.aim.enter()
        if self.aim.complete:
            self.notice = Notice("complete")

    def _leave(self) -> None:
        self.aim.leave()

    def _shoot(self) -> None:
        """RETURN in play: one shot for each completed entry."""
        if self.aim.complete:
            self._strike()
        elif not self.aim.wrong:
            self.shown_shot = self.shown_shot and self.moving
            self.notice = Notice("spent")

    def _fire(self) -> None:
        """Complete the entry as it stands, and shoot."""
        self.aim.leave()
        if self.aim.finish():
            self._strike()

    def _strike(self) -> None:
        shot = self.aim.shot
        assert shot is not None, "a complete entry can be read"
        if not self.moving:
            self._lay = self._layout()
        self.world.log.clear()
        self.began = self.world.time
        self.world.strike(self.cue, shot)
        self._changed()
        self.aim.spent()
        self.shots += 1
        self.moving = self.shown_shot = True
        self._read()

    def _place(self) -> None:
        spots = setup.places(self.world, self._rng)
        self._put([State(at, (0.0, 0.0), (0.0, 0.0, 0.0)) for at in spots])

    def _stop(self) -> None:
        self.world.stop()
        self._rest()
        self._read()

    def _retry(self) -> None:
        """The balls go back to where they lay before the last shot; the same entry may be shot."""
        self._put(self._lay)
        self.aim.leave()
        if not self.moving:
            self.aim.finish()

    def _pause(self) -> None:
        self.paused = not self.paused

    def _frame(self) -> None:
        self.paused = True
        self._run(FRAME)

    def _skip(self) -> None:
        """Go on to the end of the shot at once, unless it has none."""
        for _ in range(LONGEST_SHOT):
            if self.moving:
                self._step(1.0)
        self._read()

    def _help(self) -> None:
        self.help = not self.help

    def _settings(self) -> None:
        self.sheet = not self.sheet

    def _quit(self) -> None:
        self.over = True

    def _set(self, value: str) -> None:
        """Write numbers into boxes by their names ("side 1.5 follow 0.5"), as the mouse does."""
        words = value.split()
        if self.moving:
            return
        self.shown_shot = False
        self.aim.put(**{n: float(v) for n, v in zip(words[::2], words[1::2], strict=True)})
        self.aim.leave()
        if not self.aim.faults:
            self.aim.finish()

    # -- what time does ------------------------------------------------------------------------

    def advance(self, ticks: int) -> None:
        """Let time pass: at most `substeps` calls of `world.step`, none while nothing moves."""
        if self.moving and not (self.paused or self.help or self.sheet):
            self._run(ticks)
        self.tick += ticks

    def _run(self, ticks: int) -> None:
        if not self.moving:
            return
        before, events = self.tick // READING, len(self.world.log)
        for share in shares(ticks, self.substeps):
            if not self.moving:
                break
            self._step(seconds(share))
        self.version += 1
        due = (self.tick + ticks) // READING != before
        if due or not self.moving or self.paused or len(self.world.log) != events:
            self._read()

    def _step(self, dt: float) -> None:
        before = len(self.world.log)
        self.calls += 1
        try:
            self.world.step(dt)
        except EventBudgetError:
            self.world.stop()
            self.notice = Notice("budget", error=True)
        self.events += max(len(self.world.log) - before, 0)
        if not self._moves():
            self._rest()

    def _changed(self) -> None:
        """Somebody has put or pushed balls: let the world plan, so that its log knows of it."""
        self.stamp += 1
        self.world.step(0.0)

    def _rest(self) -> None:
        """All balls lie still: an entry begun meanwhile comes on show."""
        self.moving = False
        self.stamp += 1
        if self.aim.box is not None or self.aim.complete:
            self.shown_shot = False

    # -- what there is to see ------------------------------------------------------------------

    @property
    def preview(self) -> Preview | None:
        """What the shot in the boxes would do, by the engine itself; None while there is none."""
        key = (self.stamp, *self.aim.texts)
        if key != self._previewed[0]:
            shot = None if self.moving else self.aim.shot
            seen = preview(self.world, self.cue, shot) if shot else None
            self._previewed = key, seen
        return self._previewed[1]

    @property
    def preview_key(self) -> tuple[object, ...]:
        """What the preview depends on: equal keys, equal previews."""
        return (self.stamp, *self.aim.texts)

    @property
    def forecast(self) -> Story:
        """The whole shot, what is still to come included, as things are now."""
        key = self.stamp
        if key != self._forecast[0]:
            self._forecast = key, forecast(self.world, self.began)
        return self._forecast[1]

    @property
    def counts(self) -> tuple[int, int]:
        """How many balls the cue ball has met in this shot, and how often it has met a cushion."""
        key = (self.stamp, len(self.world.log))
        if key != self._counts[0]:
            own = [event for event in self.world.log if self.cue in event.balls]
            met = {name for e in own if e.kind == "ball" for name in e.balls} - {self.cue}
            self._counts = key, (len(met), sum(e.kind == "cushion" for e in own))
        return self._counts[1]

    @property
    def traced(self) -> tuple[str, ...]:
        """The balls whose traces are shown: all, unless there are too many to tell apart."""
        names = tuple(ball.name for ball in self.world.balls)
        return names if len(names) <= MOST_TRACED else (self.cue,)

    def _moves(self) -> bool:
        """Does anything move, roll or spin on the spot?"""
        return any(ball.phase != "resting" or ball.spin[2] != 0.0 for ball in self.world.balls)

    def _layout(self) -> list[State]:
        return [State(b.position, b.velocity, b.spin) for b in self.world.balls]

    def _put(self, states: Sequence[State]) -> None:
        """Put all balls back; those of a scene that had begun in motion move again."""
        self.world.stop()
        for ball, state in zip(self.world.balls, states, strict=True):
            ball.position, ball.velocity, ball.spin = state
        self.world.log.clear()
        self._changed()
        self.began = self.world.time
        self.moving = self.shown_shot = self._moves()
        self._read()

    def _read(self) -> None:
        """Take |v|, |ω|R and |ωz|R of the cue ball, m/s, and how long the shot has lasted, s."""
        self.news += 1
        ball = self.world.ball(self.cue)
        wx, wy, wz = ball.spin
        self.readout = hypot(*ball.velocity), hypot(wx, wy, wz) * ball.radius, abs(wz) * ball.radius
        log = self.world.log
        rested = not self.moving and len(log) and log[-1].kind == "rest"
        now = log[-1].time if rested else self.world.time
        self.readout_time = now - self.began if self.shown_shot else 0.0

    def _take_over_launch(self) -> None:
        """Write into the boxes what a scene has already given to the cue ball."""
        ball = self.world.ball(self.cue)
        v = complex(*ball.velocity)
        if v:
            ahead = v / abs(v)
            wx, wy, wz = (w * ball.radius for w in ball.spin)
            spin = complex(wx, wy) / ahead
            angle = degrees(phase(v))
            numbers = (abs(v), spin.imag, spin.real, wz, angle)
            self.aim.texts = [plain(n, 3) for n in numbers]
        self.aim.spent()
        self.shown_shot = True
        self.began = self.world.time

    _handlers: ClassVar[dict[str, Callable[..., None]]] = {
        "edit": _edit, "clear": _clear, "type": _type, "erase": _erase, "enter": _enter,
        "leave": _leave, "shoot": _shoot, "fire": _fire, "place": _place, "stop": _stop,
        "retry": _retry, "pause": _pause, "frame": _frame, "skip": _skip, "help": _help,
        "settings": _settings, "quit": _quit, "set": _set, "engine": choices.engine,
        "law": choices.law, "cloth": choices.cloth, "table": choices.table,
        "language": choices.language,
    }  # fmt: skip

