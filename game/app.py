"""The window and its loop: handle (events to actions), update (physics), render (what changed)."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pygame

from .computer.thinker import Thinker
from .input.pointer import lets_go
from .input.repeat import Repeat
from .options import Options
from .replay.recorder import Recorder
from .replay.replay import Replay
from .replay.script import Script
from .session.action import Action
from .session.commands import COMMANDS
from .session.commands import perform as perform_command
from .session.session import Session
from .session.ticks import seconds
from .settings import shot_files
from .settings.keeper import Keeper
from .settings.own_table_file import OwnTableFile
from .settings.preferences import Preferences
from .sound.hearing import SILENCE, Ear
from .table.presets import size as table_size
from .ui.layers import INPUT, MOUSE, Layers
from .ui.pages import question
from .ui.pages.menu import MenuPage
from .ui.pages.score_page import ScorePage
from .ui.view import View
from .ui.watching import WatchingLayer
from .window import screen
from .window.canvas import Canvas
from .window.clock import RealClock, VirtualClock
from .window.stats import Stats

TITLE = "danggu"
WM_CLASS = "billiards"
NOWHERE = (-1, -1)
RESIZED = (pygame.VIDEORESIZE, pygame.WINDOWSIZECHANGED)
EXPOSED = (pygame.VIDEOEXPOSE, pygame.WINDOWEXPOSED)


def prepare_environment() -> None:
    """Tell SDL how to open the window; what the user has set stays."""
    os.environ.setdefault("SDL_VIDEO_X11_WMCLASS", WM_CLASS)
    if sys.platform.startswith("linux"):
        # with software GL a flip takes 8 to 19 ms, without it 0.2, and dirty rectangles become real
        os.environ.setdefault("SDL_FRAMEBUFFER_ACCELERATION", "0")


class App:
    """A game in a window."""

    def __init__(
        self,
        session: Session,
        options: Options,
        script: Script | None = None,
        preferences: Preferences | None = None,
        journal: Recorder | Replay | None = None,
        folder: Path | None = None,
    ) -> None:
        prepare_environment()
        pygame.display.init()
        pygame.font.init()
        self.session, self.options = session, options
        self.script = script or Script([])
        self.preferences = preferences or Preferences()
        self._open(options)
        self.stats = Stats()
        length, width = table_size(session.world)
        self.view = View(session, self.canvas.surface.get_size(), length, width, self.preferences)
        self.ear = Ear(length / 2)
        self.keeper = Keeper(session, folder)
        self.folder = self.exports = folder
        self._offer()
        self._world = session.world
        self.journal = journal
        self.replay = journal if isinstance(journal, Replay) else None
        self.watching = WatchingLayer(self.view, self.replay) if self.replay is not None else None
        self.layers = Layers(self.view, *([] if self.watching is None else [self.watching]))
        self.clock = (VirtualClock if options.virtual else RealClock)(options.fps)
        self.actions: list[tuple[int, Action]] = []
        self._shown_version = -1
        self._typing: bool | None = None
        self.thinker = Thinker(session, options.seed, options.virtual, self.view.coach.aide)
        self._shots = session.shots
        self.repeat = Repeat()
        self._texts = False
        """Was text input on when SDL made the events of this frame?"""
        self._sync_typing()

    def _open(self, options: Options) -> None:
        """Open the window; one of a size that was asked for does not fill the screen."""
        self._full = self.preferences.settings.full and "size" not in options.given
        self.screen = screen.opened(options.size, full=self._full)
        self._window = options.size
        """The size of the window that a full screen goes back to."""
        pygame.display.set_caption(TITLE)
        self.canvas = Canvas(self.screen)

    def run(self) -> None:
        """Play until the window is closed, or for the number of frames asked for."""
        frames = 0
        busy = True
        while not self.session.over and frames != self.options.frames:
            busy = self.frame(self.clock.frame(busy))
            frames += 1

    def frame(self, ticks: int) -> bool:
        """One frame that lasts `ticks`; returns whether anything happened in it."""
        before = self.stats.inputs
        self._texts = bool(self._typing)
        for event in pygame.event.get():
            self.handle(event)
        for _ in range(self.repeat.due(ticks)):
            self._again()
        end = self.session.tick + ticks
        if self.replay is not None:
            end = self._watch(self.replay, end)
        for line in self.script.due(end):
            self.update(line.tick - self.session.tick)
            for event in line.events:
                self.handle(event)
        self.update(end - self.session.tick)
        if self.replay is None:
            self.perform(self.thinker.think(), human=False)
            for found in self.view.found():
                self.perform(found)
        if not (self.options.virtual or self.preferences.audio.silent):
            self._sound()
        changed, thinking = self.view.think(seconds(ticks))
        self.redraw(changed)
        busy = thinking or self.thinker.on or self.view.searching
        return self.render() or self.stats.inputs != before or busy

    # -- handle --------------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event) -> None:
        """Turn one event into what it means."""
        self.stats.inputs += 1
        if event.type in MOUSE:
            event = self.canvas.translated(event)
        if lets_go(event):
            self.redraw(self.view.release())
        composing = self.view.composition.text
        for meant in self.view.meant(event):
            self._take(meant)
        self.redraw(self.view.composition.text != composing)

    def _take(self, event: pygame.event.Event) -> None:
        if event.type == pygame.QUIT:
            self._quit(event)
        elif event.type in INPUT:
            held = self._answer(event)
            if event.type == pygame.KEYDOWN:
                self.repeat.press(event.key, held, event)
        elif event.type == pygame.WINDOWLEAVE:
            self.redraw(self.view.hover(NOWHERE))
        elif event.type in RESIZED:
            self._resize()
        elif event.type in EXPOSED:
            self.view.expose()
            self.redraw()

    def _answer(self, event: pygame.event.Event) -> Action | None:
        """Do what the layers say that an event means; returns what its key may go on doing."""
        found = self.layers.ask(event, self._texts)
        self.redraw(found.redraw)
        for action in found.actions:
            self.perform(action, sure=found.sure)
        self._sync_typing()
        return found.held

    def _again(self) -> None:
        """Do again what the held key does: in the field of a page, or in a box or in play."""
        if self.session.help:
            return
        if self.session.page:
            if self.view.field is not None:
                self._answer(self.repeat.event)
        else:
            self.perform(self.repeat.action)

    def perform(self, action: Action | None, human: bool = True, sure: bool = False) -> None:
        """Do an action and note it with its tick; the computer's turn leaves a person few.

        What a person wants that ends or changes a running match is asked about first, unless that
        is `sure`.
        """
        if action is None or (human and self.thinker.takes(action)):
            return
        if human and not sure and self.replay is None and question.due(action, self.session):
            self._ask(action)
            return
        if action.name == "export":
            self._export()
            return
        if COMMANDS[action.name].own:
            self.preferences.refused = None
            perform_command(self.session, action, self.preferences)
            self._restyle(action)
            return
        page = self.session.page
        self.actions.append((self.session.tick, action))
        steps = len(self.session.history.past)
        if action.name == "open":
            self.view.last.opened(str(action.value))
        self._act(action)
        self.view.done(action, step=len(self.session.history.past) > steps)
        if self.session.page and self.session.page != page:
            self.view.open()
        if self.session.held:
            self.view.release()
            self.view.expose()  # it may have been closed and opened between two frames
        self.preferences.note(action, self.session)
        if self.session.world is not self._world:
            self._relay()
        self._sync_typing()
        if page == "settings" != self.session.page or action.name == "quit":
            self._save()

    def _quit(self, event: pygame.event.Event) -> None:
        """Leave; a second time without being asked, and on a signal at once."""
        asked = self.view.question
        twice = asked is not None and asked.action == Action("quit")
        self.perform(Action("quit"), sure=twice or getattr(event, "sure", False))

    def _ask(self, action: Action) -> None:
        """Ask over the page that is open, or over the table."""
        if self.session.help:
            self.perform(Action("help"))
        if not self.session.page:
            self.perform(Action("sheet", "ask"))
        self.view.ask(action)
        self.redraw()
        self._sync_typing()

    def _act(self, action: Action) -> None:
        """Let the game do it, with what keeps or compares its record looking on."""
        if self.journal is None:
            perform_command(self.session, action)
            return
        self.journal.before(action)
        if self.replay is not None:
            self.replay.perform(action)
        else:
            perform_command(self.session, action)
        self.journal.after()

    def _offer(self) -> None:
        """Let the pages know what is kept of matches."""
        menu, score = self.view.pages["menu"], self.view.pages["score"]
        if isinstance(menu, MenuPage) and isinstance(score, ScorePage):
            menu.offers, score.career = self.keeper.offered, self.keeper.statistics.of
            if self.folder is not None:
                self.view.labs.folder = self.folder
                self.view.tracks.file = OwnTableFile(self.folder)
                self.view.shots.path = self.folder / "shots"
                self.view.trainer.book.path = self.folder / "drills.json"
                menu.own = lambda: self.view.tracks.file.key

    def _export(self) -> None:
        """Write the shot on show as data and as a picture, and say where."""
        self.redraw()
        self.render()
        shot_files.export(self.session, self.canvas.surface, self.exports)
        self.view.expose()  # what is said shows behind a page too

    def redraw(self, changed: bool = True) -> None:
        """Draw in this frame even if nothing of the game has changed."""
        self._shown_version = -1 if changed else self._shown_version

    def _restyle(self, action: Action) -> None:
        """Show what has been chosen for seeing and hearing."""
        if action.name == "colours":
            self.view.renew(*table_size(self.session.world))
        elif action.name == "full":
            self._fill()
        self.view.expose()
        self.redraw()

    def _fill(self) -> None:
        """Fill the screen, or go back to a window as large as before."""
        self.preferences.settings.full = self._full = not self._full
        if self._full:
            self._window = self.screen.get_size()
        self.screen = screen.opened(self._window, full=self._full)
        self._resize()
        self._save()

    def _relay(self) -> None:
        """The game has moved to another table."""
        self._world = self.session.world
        length, width = table_size(self._world)
        self.view.renew(length, width)
        self.ear = Ear(length / 2)

    def _save(self) -> None:
        if not self.preferences.save():
            self.session.say("settings.unsaved", error=True)

    def _resize(self) -> None:
        if pygame.display.get_window_size() != self.canvas.size:
            self.screen = pygame.display.get_surface() or self.screen
            self.canvas = Canvas(self.screen)
            self.view.resize(self.canvas.surface.get_size())
            if not self._full:
                self.preferences.settings.size = self.screen.get_size()
            self.redraw()

    def _sync_typing(self) -> None:
        """Take text only while a box is edited: an input method must not swallow shortcuts."""
        typing = self.view.typing
        if typing != self._typing:
            self._typing = typing
            self.view.composition.text = ""
            (pygame.key.start_text_input if typing else pygame.key.stop_text_input)()

    # -- update --------------------------------------------------------------------------------

    def update(self, ticks: int) -> None:
        """Let time pass in the game and roll the balls in the picture."""
        self.session.advance(ticks)
        if self.journal is not None:
            self.journal.passed()
        self.keeper.note()
        self.view.note()
        self.view.stage.follow(self.session)

    def _watch(self, replay: Replay, end: int) -> int:
        """Play a record on to a tick, or to its end; returns the tick reached."""
        if replay.paused or replay.done:
            return self.session.tick
        end = min(end, replay.end)
        for tick, action in replay.due(end):
            self.update(tick - self.session.tick)
            self.perform(action, human=False)
        self.update(end - self.session.tick)
        if self.watching is not None:
            self.watching.tell()
        if replay.done and self.options.virtual:
            self.session.leave()
        return end

    def _sound(self) -> None:
        """Let what has happened since the last frame be heard."""
        session, audio = self.session, self.preferences.audio
        struck = None
        if session.shots > self._shots and session.aim.shot:
            struck = session.world.ball(session.shooter), session.aim.shot.speed
        self._shots = session.shots
        past = None if session.timeline.at is None else session.timeline.moment
        heard = self.ear.listen(session.world, (session.shots, session.began), struck, past)
        if past is not None and not session.timeline.playing:
            heard = SILENCE  # dragging the timeline is looking
        audio.play(heard, pygame.time.get_ticks())

    # -- render --------------------------------------------------------------------------------

    def render(self) -> bool:
        """Draw what changed, if anything did; returns whether something was drawn."""
        if self._shown_version == self.session.version:
            self.stats.skipped += 1
            return False
        self._shown_version = self.session.version
        dirty = self.canvas.show(self.view.draw(self.canvas.surface))
        if not dirty:
            self.stats.skipped += 1
            return False
        pygame.display.update(dirty)
        self.stats.drawn += 1
        return True

    def close(self) -> None:
        """Keep what is to be kept, and give the devices back."""
        self.preferences.save()
        if self.journal is not None:
            self.journal.close()
        self.view.end()
        self.preferences.audio.close()
        pygame.display.quit()

    def save(self, path: str) -> None:
        """Write the picture to a file; pygame.error or OSError if that cannot be."""
        pygame.image.save(self.screen, path)

    def report(self) -> str:
        """The counts of frames, calls and events, and how long the game has run."""
        return f"{self.stats.line(self.session)}, game time {seconds(self.session.tick):.2f} s"
