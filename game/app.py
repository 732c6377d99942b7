"""The window and its loop: handle (events to actions), update (physics), render (what changed)."""

from __future__ import annotations

import os
import sys

import pygame

from .computer.thinker import Thinker
from .input import editing
from .input.key_tables import of_key, of_text
from .input.pointer import lets_go
from .input.repeat import Repeat
from .options import Options
from .replay import watching
from .replay.recorder import Recorder
from .replay.replay import Replay
from .replay.script import Script
from .session.action import Action
from .session.session import Game, Notice
from .session.ticks import seconds
from .session.timeline import moment
from .settings.preferences import Preferences
from .sound.hearing import SILENCE, Ear
from .table.presets import size as table_size
from .ui.pages import question
from .ui.panels import prompts
from .ui.table import place_balls
from .ui.view import View
from .window.canvas import Canvas
from .window.clock import RealClock, VirtualClock
from .window.stats import Stats

TITLE = "danggu"
WM_CLASS = "billiards"
MOUSE = (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP)
OVERLAID = (pygame.KEYDOWN, pygame.TEXTINPUT, pygame.MOUSEWHEEL, *MOUSE)
NOWHERE = (-1, -1)
TOLD = ("law", "engine")
"""Actions whose outcome is said: a narrow window has no room for it elsewhere."""
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
        game: Game,
        options: Options,
        script: Script | None = None,
        preferences: Preferences | None = None,
        journal: Recorder | Replay | None = None,
    ) -> None:
        prepare_environment()
        pygame.display.init()
        pygame.font.init()
        self.game, self.options = game, options
        self.script = script or Script([])
        self.screen = pygame.display.set_mode(options.size, pygame.RESIZABLE)
        pygame.display.set_caption(TITLE)
        self.canvas = Canvas(self.screen)
        self.stats = Stats()
        self.preferences = preferences or Preferences()
        length, width = table_size(game.world)
        self.view = View(game, self.canvas.surface.get_size(), length, width, self.preferences)
        self.ear = Ear(length / 2)
        self._world = game.world
        self.journal = journal
        self.replay = journal if isinstance(journal, Replay) else None
        self.clock = (VirtualClock if options.virtual else RealClock)(options.fps)
        self.actions: list[tuple[int, Action]] = []
        self._shown_version = -1
        self._typing: bool | None = None
        self.thinker = Thinker(game, options.seed, options.virtual)
        self._shots = game.shots
        self.repeat = Repeat()
        self._texts = False
        """Was text input on when SDL made the events of this frame?"""
        self._sync_typing()

    def run(self) -> None:
        """Play until the window is closed, or for the number of frames asked for."""
        frames = 0
        busy = True
        while not self.game.over and frames != self.options.frames:
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
        end = self.game.tick + ticks
        if self.replay is not None:
            end = watching.advance(self, self.replay, end)
        for line in self.script.due(end):
            self.update(line.tick - self.game.tick)
            for event in line.events:
                self.handle(event)
        self.update(end - self.game.tick)
        if self.replay is None:
            self.perform(self.thinker.think(), human=False)
        if not (self.options.virtual or self.preferences.audio.silent):
            self._sound()
        changed, thinking = self.view.think(seconds(ticks))
        self._shown_version -= changed
        busy = thinking or self.thinker.on
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
        elif self.replay is not None and event.type in OVERLAID:
            watching.take(self, self.replay, event)
        elif self.game.sheet and event.type in OVERLAID:
            if event.type == pygame.KEYDOWN:
                self.repeat.press(event.key, editing.of_key(event), event)
            self._sheet(event)
        elif event.type == pygame.KEYDOWN:
            self._key(event)
        elif event.type == pygame.TEXTINPUT:
            self._text(event)
        elif event.type in MOUSE:
            self._mouse(event)
        elif event.type == pygame.MOUSEWHEEL and not self.game.help:
            self.perform(self.view.wheel(event.y))
        elif event.type == pygame.WINDOWLEAVE:
            self.redraw(self.view.hover(NOWHERE))
        elif event.type in RESIZED:
            self._resize()
        elif event.type in EXPOSED:
            self.view.expose()
            self._shown_version = -1

    def perform(self, action: Action | None, human: bool = True, sure: bool = False) -> None:
        """Do an action and note it with its tick; the computer's turn leaves a person few.

        What a person wants that ends or changes a running match is asked about first, unless that
        is `sure`.
        """
        if action is None or (human and self.thinker.takes(action)):
            return
        if human and not sure and self.replay is None and question.due(action, self.game):
            self._ask(action)
            return
        if self.preferences.perform(action):
            self._restyle(action)
            return
        sheet = self.game.sheet
        self.actions.append((self.game.tick, action))
        self._act(action)
        if action.name in TOLD and self.game.notice is None:
            self.game.notice = Notice(action.name)
        if self.game.sheet and self.game.sheet != sheet:
            self.view.open()
        if self.game.held:
            self.view.release()
            self.view.expose()  # it may have been closed and opened between two frames
        self.preferences.note(action, self.game)
        if self.game.world is not self._world:
            self._relay()
        self._sync_typing()
        if sheet == "settings" != self.game.sheet or action.name == "quit":
            self._save()

    def _quit(self, event: pygame.event.Event) -> None:
        """Leave; a second time without being asked, and on a signal at once."""
        asked = self.view.question
        twice = asked is not None and asked.action == Action("quit")
        self.perform(Action("quit"), sure=twice or getattr(event, "sure", False))

    def _ask(self, action: Action) -> None:
        """Ask over the page that is open, or over the table."""
        if self.game.help:
            self.perform(Action("help"))
        if not self.game.sheet:
            self.perform(Action("sheet", "ask"))
        self.view.ask(action)
        self._shown_version = -1
        self._sync_typing()

    def _act(self, action: Action) -> None:
        """Let the game do it, with what keeps or compares its record looking on."""
        if self.journal is None:
            self.game.perform(action)
            return
        self.journal.before(action)
        (self.replay or self.game).perform(action)
        self.journal.after()

    def redraw(self, changed: bool = True) -> None:
        """Draw in this frame even if nothing of the game has changed."""
        self._shown_version -= changed

    def _restyle(self, action: Action) -> None:
        """Show what has been chosen for seeing and hearing."""
        if action.name == "colours":
            self.view.renew(*table_size(self.game.world))
        self.view.expose()
        self._shown_version = -1

    def _relay(self) -> None:
        """The game has moved to another table."""
        self._world = self.game.world
        length, width = table_size(self._world)
        self.view.renew(length, width)
        self.ear = Ear(length / 2)

    def _save(self) -> None:
        if not self.preferences.save():
            self.game.notice = Notice("settings.unsaved", error=True)

    def _key(self, event: pygame.event.Event) -> None:
        keys = self.preferences.keys
        if self.game.help:
            always = keys.always.get(event.key)
            if event.key in place_balls.DONE or always == Action("help"):
                self.perform(Action("help"))
            elif always == Action("language"):
                self.perform(always)
            return
        if self.game.arranging and (action := place_balls.key(event, self.game)):
            self.perform(action)
            return
        action = of_key(event, self.game.aim.box, self._texts, keys.play, keys.always)
        edited = self.game.aim.edited
        if edited is not None and event.key not in keys.always:
            action = editing.with_clipboard(editing.of_key(event), edited) or action
        elif action == Action("shoot"):
            action = prompts.entered(self.game)
        self.repeat.press(event.key, action)
        self.perform(action)

    def _again(self) -> None:
        """Do again what the held key does: in the field of a page, or in a box or in play."""
        if self.game.sheet:
            if self.view.field is not None:
                self._sheet(self.repeat.event)
        elif not self.game.help:
            self.perform(self.repeat.action)

    def _sheet(self, event: pygame.event.Event) -> None:
        """Take an event that is meant for the page over the table."""
        self._shown_version = -1
        asked = self.view.question
        action = self.view.pass_on(event)
        if self.view.question is None and self.game.sheet == "ask":
            self.perform(Action("sheet", ""))
        if action is not None:
            self.view.expose()  # what it changes shows behind the page too
            self.perform(action, sure=asked is not None and action == asked.action)
        self._sync_typing()

    def _text(self, event: pygame.event.Event) -> None:
        if not self.game.help:
            self.perform(of_text(event, self.game.aim.box))

    def _mouse(self, event: pygame.event.Event) -> None:
        if self.game.help:
            if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
                self.perform(Action("help"))
        elif event.type == pygame.MOUSEMOTION:
            self.redraw(self.view.hover(event.pos))
            self.perform(self.view.drag(event.pos))
        elif event.button == 1:
            self._shown_version -= 1
            if event.type == pygame.MOUSEBUTTONDOWN:
                self.perform(self.view.press(event.pos))

    def _resize(self) -> None:
        if pygame.display.get_window_size() != self.canvas.size:
            self.screen = pygame.display.get_surface() or self.screen
            self.canvas = Canvas(self.screen)
            self.view.resize(self.canvas.surface.get_size())
            self.preferences.settings.size = self.screen.get_size()
            self._shown_version = -1

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
        self.game.advance(ticks)
        if self.journal is not None:
            self.journal.passed()
        self.view.stage.follow(self.game)

    def _sound(self) -> None:
        """Let what has happened since the last frame be heard."""
        game, audio = self.game, self.preferences.audio
        struck = None
        if game.shots > self._shots and game.aim.shot:
            struck = game.world.ball(game.shooter), game.aim.shot.speed
        self._shots = game.shots
        past = None if game.head.at is None else moment(game)
        heard = self.ear.listen(game.world, (game.shots, game.began), struck, past)
        if past is not None and not game.head.playing:
            heard = SILENCE  # who drags the timeline wants to look
        audio.play(heard, pygame.time.get_ticks())

    # -- render --------------------------------------------------------------------------------

    def render(self) -> bool:
        """Draw what changed, if anything did; returns whether something was drawn."""
        if self._shown_version == self.game.version:
            self.stats.skipped += 1
            return False
        self._shown_version = self.game.version
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
        self.preferences.audio.close()
        pygame.display.quit()

    def save(self, path: str) -> None:
        """Write the picture to a file; pygame.error or OSError if that cannot be."""
        pygame.image.save(self.screen, path)

    def report(self) -> str:
        """The counts of frames, calls and events, and how long the game has run."""
        return f"{self.stats.line(self.game)}, game time {seconds(self.game.tick):.2f} s"
