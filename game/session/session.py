"""The game without a window: what an action does, and what a stretch of time does."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from math import hypot
from typing import ClassVar, NamedTuple

from danggu.rules.stroke import stroke
from game.aim import edit
from game.aim.entry import Aim
from game.aim.preview import NO_STORY, Preview, Story, forecast, preview
from game.table import presets
from physics import Cloth, Placed, State, World, laws

from . import commands, equipment, moves, running_match, timeline
from .action import Action
from .history import History, moment
from .ticks import TICKS, seconds, shares
from .timeline import Playhead

READING = TICKS // 8
"""How often the read-outs change while balls move: faster cannot be read."""

MOST_TRACED = 6


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
        self.engine, self.language, self.edition = "exact", "en", presets.EDITION
        self.match_engine = "exact"
        """What a match from the menu is played with, whatever is in use before it."""
        self.help = self.over = False
        self.sheet = ""
        """The page laid over the table: "settings" "menu" "shelf" "rules", or none."""
        self.tick = self.calls = self.events = self.stamp = 0
        """`stamp` goes up whenever somebody, and not time, has changed what will happen."""
        self.version = 0
        """Goes up with every change: equal versions look the same."""
        self.news = 0
        """Goes up when anything but the balls' places has changed, or is due to be read again."""
        self.rng = random.Random(seed)
        self._did = ""
        self.history = History()
        take, give = partial(running_match.kept, self), partial(running_match.give_back, self)
        self.history.keepers.append((take, give))
        self.begin(world, table)

    def begin(self, world: World, table: str) -> None:
        """Play on another table."""
        self.world, self.table = world, table
        self.history.clear()
        self.cue = self.shooter = self.held_ball = presets.cue_ball(world)
        self.contest: running_match.Contest | None = None
        self.arranging = False
        """Are balls being placed by hand?  `held_ball` is the one that moves."""
        self.aim = Aim()
        self.law, self.cloth = presets.law_of(world), "table"
        self.paused, self.head = False, Playhead()
        self.notice: Notice | None = None
        self.shots = 0
        self.began = world.time
        self.shown_shot = False
        """Is the last shot on show, rather than the next one?"""
        self.came_with = Terms(world.ball_law, world.cushion_law, world.cloth)
        self.lies = world.layout()
        """Where the balls lay before the last shot."""
        self._seen: tuple[object, dict[str, State]] = (None, {})
        self._previewed: tuple[object, Preview | None] = (None, None)
        self._forecast: tuple[object, Story] = (None, NO_STORY)
        self._counts: tuple[object, tuple[int, int]] = (None, (0, 0))
        self.changed()
        self.moving = moves.moves(world)
        if self.moving:
            edit.take_over(self)
        self.read()

    # -- what an action does -------------------------------------------------------------------

    def perform(self, action: Action) -> None:
        """Do what the player wants; anything unknown raises KeyError."""
        handler = self._handlers[action.name]
        if action.name not in ("language", "help", "settings", "sheet", "next", "intend"):
            self.notice = None
        before = moment(self)
        if self.contest is not None and action.name in edit.HANDLERS:
            self.show_aim()  # they begin with the numbers of who is at the table
        if action.value is None:
            handler(self)
        else:
            handler(self, action.value)
        if self._is_step(action.name, before.moving) or self.world is not before.world:
            self.history.note(before, self)
        self._did = action.name
        self.version += 1
        self.news += 1

    def _is_step(self, name: str, moving: bool) -> bool:
        """Is what was done a step of its own to undo?  Time is none, nor is a drag's every move."""
        if name in ("undo", "redo", *timeline.HANDLERS) or name == self._did == "move":
            return False
        return self.contest is None or not moving

    def show_aim(self) -> None:
        """Show the next shot rather than the last one, unless that is still running."""
        if self.moving:
            return
        self.shown_shot = False
        self.head.live()
        if self.contest is not None:
            self.contest.give_boxes(self)

    def _edit(self, box: int = 0) -> None:
        self.show_aim()
        self.arranging = False
        self.aim.edit(box)

    def _clear(self) -> None:
        self._edit()
        self.aim.edit(clear=True)

    def _type(self, text: str) -> None:
        if self.aim.box is None:
            self._edit()
        if not self.aim.type(text):
            self.warn("full")

    def _enter(self) -> None:
        self.aim.enter()
        if self.aim.complete:
            self.notice = Notice("complete")

    def _leave(self) -> None:
        self.aim.leave()

    def _shoot(self) -> None:
        """RETURN in play: one shot for each completed entry; in a match first the next turn."""
        if self.contest is not None and self.moving:
            self.refuse("moving")
        elif self.contest is not None and self.shown_shot:
            commands.show_next(self)
        elif self.aim.complete:
            self.strike()
        elif not self.aim.wrong:
            self.show_aim()
            self.notice = Notice("spent")

    def _fire(self) -> None:
        """Complete the entry as it stands, and shoot; in a match that is the coming stroke."""
        if self.contest is not None:
            self.show_aim()
        self.aim.leave()
        if self.aim.finish():
            self.strike()

    def strike(self) -> None:
        """Play the shot in the boxes, if they hold one; in a match only if one may."""
        moves.strike(self)

    def refuse(self, why: str) -> None:
        """Say why something cannot be done now."""
        self.warn(f"refused.{why}")

    def lay(self, places: Sequence[presets.Place]) -> None:
        """Lay all balls down at rest, in their order, metres."""
        moves.lay(self, places)

    def _help(self) -> None:
        self.help = not self.help

    def _settings(self) -> None:
        commands.sheet(self, "settings")

    def _quit(self) -> None:
        self.over = True

    def warn(self, key: str, error: bool = True) -> None:
        """Say what cannot be, or what has been done instead of it."""
        self.notice = Notice(key, error)

    def _undo(self) -> None:
        """Take the last step back; in a match with the computer as far as a person's turn."""
        if not self.history.undo(self):
            self.notice = Notice("undo")
        while self.contest is not None and self.contest.waits and self.history.undo(self):
            pass

    def _redo(self) -> None:
        if not self.history.redo(self):
            self.notice = Notice("redo")

    # -- what time does ------------------------------------------------------------------------

    @property
    def held(self) -> bool:
        """Does a page over the table hold the game?"""
        return self.help or bool(self.sheet)

    def advance(self, ticks: int) -> None:
        """Let time pass: at most `substeps` calls of `world.step`, none while nothing moves."""
        if not self.held:
            timeline.advance(self, ticks)
        self.tick += ticks

    def run(self, ticks: int) -> None:
        """Let the balls roll for `ticks` of the shot's own time."""
        if not self.moving:
            return
        before, events = self.tick // READING, len(self.world.log)
        for share in shares(ticks, self.substeps):
            if not self.moving:
                break
            moves.roll(self, seconds(share))
        self.version += 1
        due = (self.tick + ticks) // READING != before
        if due or not self.moving or self.paused or len(self.world.log) != events:
            self.read()

    def changed(self) -> None:
        """Somebody has put or pushed balls: let the world plan, so that its log knows of it."""
        self.stamp += 1
        self.head.part = 0  # how much of a tick is left over tells how long the last frame was
        self.world.plan()

    def rest(self) -> None:
        """All balls lie still: an entry begun meanwhile comes on show."""
        self.moving = False
        self.stamp += 1
        self.paused = False  # there is nothing to hold: the next shot, or the computer, goes on
        if self.contest is not None:
            self.contest.rested(self)
        if self.aim.box is not None or self.aim.complete:
            self.shown_shot = False

    # -- what there is to see ------------------------------------------------------------------

    @property
    def preview(self) -> Preview | None:
        """What the shot in the boxes would do, by the engine itself; None while there is none."""
        key = (self.stamp, *self.aim.texts)
        if key != self._previewed[0]:
            shot = None if self.moving else self.aim.shot
            judge = self.contest.outcome if self.contest is not None else None
            seen = preview(self.world, self.cue, shot, judge) if shot else None
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
        """How many balls and cushions the cue ball has met by the moment on show, as rules do."""
        key = (self.stamp, self.began, len(self.world.log), self.head.at)
        if key != self._counts[0]:
            done = stroke(self.world.log.contacts(), self.shooter).until(timeline.moment(self))
            self._counts = key, (len(done.hits()), done.cushions())
        return self._counts[1]

    @property
    def traced(self) -> tuple[str, ...]:
        """The balls whose traces are shown: all, unless there are too many to tell apart."""
        names = tuple(ball.name for ball in self.world.balls)
        return names if len(names) <= MOST_TRACED else (self.cue,)

    def put(self, layout: Sequence[Placed]) -> None:
        """Put all balls back; those of a scene that had begun in motion move again."""
        moves.put(self, layout)

    @property
    def seen(self) -> dict[str, State]:
        """Every ball at the moment on show: now, or the one that the timeline has been put to."""
        if self.head.at is None:
            return {
                b.name: State(b.position, b.velocity, b.spin, b.height, b.climb)
                for b in self.world.balls
            }
        key = self.stamp, self.began, self.head.at
        if key != self._seen[0]:
            self._seen = key, self.world.log.at(timeline.moment(self))
        return self._seen[1]

    def read(self) -> None:
        """Take |v|, |ω|R and |ωz|R of the cue ball, m/s, and how long the shot has lasted, s."""
        self.news += 1
        name = self.shooter if self.shown_shot else self.cue
        ball, state = self.world.ball(name), self.seen[name]
        wx, wy, wz = (w * ball.radius for w in state.spin)
        self.readout = hypot(*state.velocity), hypot(wx, wy, wz), abs(wz)
        log = self.world.log
        rested = not self.moving and len(log) and log[-1].kind == "rest"
        now = log[-1].time if rested else self.world.time
        if self.head.at is not None:
            now = timeline.moment(self)
        self.readout_time = now - self.began if self.shown_shot else 0.0

    _handlers: ClassVar[dict[str, Callable[..., None]]] = {
        "edit": _edit, "clear": _clear, "type": _type, "enter": _enter,
        "leave": _leave, "shoot": _shoot, "fire": _fire, "place": moves.place, "stop": moves.stop,
        "retry": moves.retry, "undo": _undo, "redo": _redo, "help": _help,
        "settings": _settings, "quit": _quit, **edit.HANDLERS, **timeline.HANDLERS,
        "engine": equipment.engine,
        "law": equipment.law, "cloth": equipment.cloth, "table": equipment.table,
        "language": equipment.language,
        "sheet": commands.sheet, "match": commands.match, "next": commands.show_next,
        "intend": commands.intend, "play": commands.play, "arrange": commands.arrange,
        "hold": commands.hold, "move": commands.move, "line": commands.line,
        "scene": commands.scene,
    }  # fmt: skip

