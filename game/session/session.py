"""The game without a window: what there is to play with, and what a stretch of time does to it.

Only this file and `commands` write to a session. The parts that it is made of do not know it: they
change themselves or their world, and return what the session is to set.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from math import hypot

from danggu.rules.stroke import stroke
from danggu.rules.verdict import Verdict
from game.aim import edit
from game.aim.entry import Aim
from game.aim.preview import NO_STORY, Preview, Story, forecast, preview
from game.table import presets
from physics import Placed, State, World

from . import equipment, moves
from .equipment import Equipment
from .history import History, Moment
from .notice import Notice
from .running_match import Contest
from .ticks import TICKS, seconds, shares
from .timeline import Timeline

READING = TICKS // 8
"""How often the read-outs change while balls move: faster cannot be read."""

MOST_TRACED = 6


class Session:
    """World, aim and everything else that commands change.  It never looks at a clock.

    page      laid over the table: "settings" "menu" "shelf" "rules" "ask", or none ("")
    help      does the page of keys lie over everything?
    version   goes up with every change: equal versions look the same
    news      goes up when more than the balls' places has changed, or is due to be read again
    lies      how the balls lay before the last shot
    did       the last action's name; squirt: "on" or "off"
    coaching  which of the coach's ways is asked for
    match_engine  what a match from the menu is played with, whatever is in use before it
    """

    def __init__(
        self,
        world: World,
        substeps: int = 6,
        seed: int = 0,
        table: str = "medium",
        language: str = "en",
        edition: int = presets.EDITION,
        match_engine: str = "exact",
    ) -> None:
        self.substeps, self.language, self.edition = substeps, language, edition
        self.engine, self.match_engine = "exact", match_engine
        self.help = self.over = False
        self.page, self.did, self.squirt = "", "", "off"
        self.tick = self.calls = self.events = self.version = self.news = self.coaching = 0
        self.rng = random.Random(seed)
        self.history = History()
        self.timeline = Timeline(world, world.time)
        self.begin(world, table)

    def begin(self, world: World, table: str) -> None:
        """Play on another table."""
        presets.as_of(world, table, self.edition)
        self.world, self.table = world, table
        self.history.clear()
        self.cue = self.shooter = self.held_ball = presets.cue_ball(world)
        self.contest: Contest | None = None
        self.arranging = self.sketching = False
        """Are balls placed by hand, `held_ball` the next?  Is the cue ball's path drawn?"""
        self.aim = Aim(strongest=edit.strongest(world), squirts=self.squirt == "on")
        self.law, self.cloth = presets.law_of(world), "table"
        self.timeline = Timeline(world, world.time, stamp=self.timeline.stamp)
        self.notice: Notice | None = None
        self.shots = 0
        self.came_with = Equipment.of(world)
        self.lies = world.layout()
        self._seen: tuple[object, dict[str, State]] = (None, {})
        self._previewed: tuple[object, Preview | None] = (None, None)
        self._forecast: tuple[object, Story] = (None, NO_STORY)
        self._counts: tuple[object, tuple[int, int]] = (None, (0, 0))
        self.changed()
        self.timeline.moving = moves.moves(world)
        if self.moving:
            edit.take_over(self.aim, world.ball(self.cue))
            self.timeline.shown, self.timeline.began = True, world.time
        self.read()

    # -- what it tells -------------------------------------------------------------------------

    def say(self, key: str, *, error: bool = False, about: str = "") -> None:
        """Tell the player something at once, whatever else is being done."""
        self.notice = Notice(key, error, about)
        self.news += 1
        self.version += 1

    def warn(self, key: str, error: bool = True, about: str = "") -> None:
        """Say what cannot be, or what has been done instead of it."""
        self.notice = Notice(key, error, about)

    def refuse(self, why: str) -> None:
        """Say why something cannot be done now."""
        self.warn(f"refused.{why}")

    def muse(self, thinking: bool, share: float | None) -> None:
        """Show how far the computer has thought, and the share of its strokes that come off."""
        if self.contest is not None:
            self.contest.thinking = thinking
            self.contest.share = self.contest.share if share is None else share

    def leave(self) -> None:
        """The game is over."""
        self.over = True

    # -- the next shot -------------------------------------------------------------------------

    def show_aim(self) -> None:
        """Show the next shot rather than the last one, unless that still runs or ended a match."""
        if self.moving or (self.shown_shot and self.contest is not None and self.contest.over):
            return
        self.timeline.shown = False
        self.timeline.live()
        self.give_boxes()

    def give_boxes(self) -> None:
        """Let the player at the table of a match have the boxes, once in a turn."""
        if self.contest is None or self.contest.match.asked is not None:
            return
        texts = self.contest.boxes(self.world)
        if texts is not None:
            self.aim.texts, self.held_ball = texts, self.cue
            self.arranging = bool(self.contest.in_hand)

    def ready(self) -> bool:
        """Turn to the next shot; False while balls move."""
        if self.moving:
            return False
        self.show_aim()
        self.aim.leave()
        return True

    def strike(self) -> None:
        """Play the shot in the boxes, if they hold one and the cue ball may be struck."""
        shot = self.aim.shot
        if shot is None:
            return
        if why := self._refusal(flies=bool(shot.climb)):
            self.refuse(why)
            return
        self.arranging = self.sketching = False
        if not self.moving:
            self.lies = self.world.layout()
        self.timeline.restart()
        self.world.strike(self.cue, shot)
        self.changed()
        self.shooter = self.cue
        if self.contest is not None:
            self.contest.struck(self.aim.texts, self.lies)
        self.aim.spent()
        self.shots += 1
        self.timeline.moving = self.timeline.shown = True
        self.read()

    def _refusal(self, *, flies: bool) -> str:
        """Why the cue ball cannot be struck now, or ""."""
        if self.contest is not None and (why := self.contest.refusal(moving=self.moving)):
            return why
        if self.world.ball(self.cue).gone:
            return "off"
        return "flight" if flies and self.engine != "exact" else ""

    # -- balls put back ------------------------------------------------------------------------

    def put(self, layout: Sequence[Placed]) -> None:
        """Put all balls back; those of a scene that had begun in motion move again."""
        if self.engine != "exact" and any(ball.height or ball.climb for ball in layout):
            self.use_engine("exact")  # no other knows balls in the air
        self.world.recall(layout)
        self.timeline.restart()
        self.changed()
        self.timeline.moving = self.timeline.shown = moves.moves(self.world)
        self.read()

    def lay(self, places: Sequence[presets.Place]) -> None:
        """Lay all balls down at rest, in their order, metres."""
        self.put(presets.lying(places))
        self.lies = self.world.layout()

    def use_engine(self, key: str) -> None:
        """Continue with another engine; only the exact one knows balls in the air."""
        if not equipment.with_engine(self.world, key):
            self.refuse("flight")
            self.engine = "exact"
            return
        self.engine = key
        self.timeline.stamp += 1

    def snapshot(self) -> Moment:
        """The game as it is now, to be kept."""
        aim, world = self.aim, self.world
        standing = self.contest.snapshot() if self.contest is not None else None
        shown = self.shown_shot and not self.moving
        table = world, world.layout(), (*aim.texts,), aim.complete, self.moving, shown
        return Moment(*table, self.shots, self.cue, standing)

    def restore(self, kept: Moment) -> None:
        """Be as a moment was."""
        self.put(kept.layout)
        self.shots = kept.shots
        if self.contest is not None and kept.standing is not None:
            self.contest.restore(kept.standing)
        self.cue = kept.cue
        self.aim.texts = list(kept.texts)
        self.aim.leave()
        self.aim.complete = kept.complete and not self.aim.faults
        self.aim.wrong = False
        if self.contest is not None and kept.shown:
            self.contest.given = False
            self.give_boxes()

    # -- what time does ------------------------------------------------------------------------

    @property
    def held(self) -> bool:
        """Does a page over the table hold the game?"""
        return self.help or bool(self.page)

    def advance(self, ticks: int) -> None:
        """Let time pass: at most `substeps` calls of `world.step`, none while nothing moves."""
        if not self.held:
            again = self.timeline.at is not None and self.timeline.playing
            rolling = self.timeline.advance(ticks)
            if rolling is not None:
                self.run(rolling)
            if again:
                self.version += 1
                self.read()
        self.tick += ticks

    def run(self, ticks: int) -> None:
        """Let the balls roll for `ticks` of the shot's own time."""
        if not self.moving:
            return
        before, events = self.tick // READING, len(self.world.log)
        for share in shares(ticks, self.substeps):
            if not self.moving:
                break
            self._roll(seconds(share))
        self.version += 1
        due = (self.tick + ticks) // READING != before
        if due or not self.moving or self.paused or len(self.world.log) != events:
            self.read()

    def _roll(self, dt: float) -> None:
        """Let the balls roll for `dt` seconds; an engine that fails stops them, and says so."""
        before = len(self.world.log)
        self.calls += 1
        if trouble := moves.step(self.world, dt):
            if trouble == "failed":
                self.put(self.lies)
            self.world.stop()
            self.warn(trouble)
        self.events += max(len(self.world.log) - before, 0)
        if not moves.moves(self.world):
            self.rest()

    def changed(self) -> None:
        """Balls have been put or pushed: let the world plan, so that its log knows of it."""
        self.timeline.stamp += 1
        self.timeline.part = 0  # how much of a tick is left over tells how long the last frame was
        self.world.plan()

    def rest(self) -> None:
        """All balls lie still: an entry begun meanwhile comes on show."""
        self.timeline.moving = False
        self.timeline.stamp += 1
        self.timeline.paused = False  # there is nothing to hold: the next shot goes on
        if self.contest is not None and self.contest.pending:
            self.notice = None
            if self.contest.judge(self.world):
                self.changed()
            self.seat()
        if self.aim.box is not None or self.aim.complete:
            self.timeline.shown = False

    def seat(self) -> None:
        """Give the cue ball to the player at the table of the match."""
        if self.contest is not None:
            busy = self.aim.box is not None or self.aim.complete
            self.cue = self.contest.seat(self.world, busy=busy)

    # -- what there is to see ------------------------------------------------------------------

    @property
    def moving(self) -> bool:
        """Do the balls move?"""
        return self.timeline.moving

    @property
    def shown_shot(self) -> bool:
        """Is the last shot on show, rather than the next one?"""
        return self.timeline.shown

    @property
    def paused(self) -> bool:
        """Is time held while the balls move?"""
        return self.timeline.paused

    @property
    def began(self) -> float:
        """World time at which the last shot began, s."""
        return self.timeline.began

    @property
    def stamp(self) -> int:
        """Goes up whenever something other than time has changed what will happen."""
        return self.timeline.stamp

    @property
    def preview(self) -> Preview | None:
        """What the shot in the boxes would do, by the engine itself; None while there is none."""
        key = self.preview_key
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
        key = (self.stamp, self.began, len(self.world.log), self.timeline.at)
        if key != self._counts[0]:
            done = stroke(self.world.log.brief(), self.shooter).until(self.timeline.moment)
            self._counts = key, (len(done.hits()), done.cushions())
        return self._counts[1]

    @property
    def settled(self) -> Verdict | None:
        """The verdict on the stroke at the moment on show, if nothing can change it any more."""
        if self.contest is None or not self.shown_shot:
            return None
        return self.contest.settled(self.world.log, self.timeline.moment)

    @property
    def traced(self) -> tuple[str, ...]:
        """The balls whose traces are shown: all, unless there are too many to tell apart."""
        if len(self.world.balls) <= MOST_TRACED:
            return tuple(ball.name for ball in self.world.balls)
        ran, seen = self.shown_shot or self.moving, NO_STORY
        if ran or self.preview is not None:
            seen = self.forecast if ran or self.preview is None else self.preview.story
        return moves.of_note(seen, self.shooter if ran else self.cue, MOST_TRACED)

    @property
    def seen(self) -> dict[str, State]:
        """Every ball at the moment on show: now, or the one that the timeline has been put to."""
        if self.timeline.at is None:
            return {
                b.name: State(b.position, b.velocity, b.spin, b.height, b.climb)
                for b in self.world.balls
            }
        key = self.stamp, self.began, self.timeline.at
        if key != self._seen[0]:
            self._seen = key, self.world.log.at(self.timeline.moment)
        return self._seen[1]

    def read(self) -> None:
        """Take |v|, |ω|R and |ωz|R of the cue ball, m/s, and how long the shot has lasted, s."""
        self.news += 1
        name = self.shooter if self.shown_shot else self.cue
        ball, state = self.world.ball(name), self.seen[name]
        wx, wy, wz = (w * ball.radius for w in state.spin)
        self.readout = hypot(*state.velocity), hypot(wx, wy, wz), abs(wz)
        log, timeline = self.world.log, self.timeline
        rested = not self.moving and len(log) and log[-1].kind in ("rest", "pocket", "off")
        now = log[-1].time if rested else self.world.time
        if timeline.at is not None:
            now = timeline.moment
        self.readout_time = now - self.began if self.shown_shot else 0.0
