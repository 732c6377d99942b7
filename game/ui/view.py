"""The whole window: the table and the parts around it; draws what changed, and says where."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from math import dist

import pygame

from game.aim.spread import Spread
from game.input.composing import Composition
from game.input.pointer import SLACK, Pointer
from game.practice.trainer import Trainer
from game.render.font import Type
from game.render.layout import Layout
from game.replay.last_stroke import LastStroke
from game.session.action import Action
from game.session.session import Session
from game.settings.preferences import Preferences
from game.settings.shot_folder import ShotFolder
from game.text.text_field import TextField
from game.ui.sight import Sight

from .coach import Coach
from .pages import help as keys_page
from .pages import question
from .pages.labs_page import LabsPage
from .pages.menu import MenuPage
from .pages.page_parts import Page
from .pages.question import Question
from .pages.rules_page import RulesPage
from .pages.score_page import ScorePage
from .pages.settings_page import SettingsPage
from .pages.shelf import ShelfPage
from .pages.shots_page import ShotsPage
from .pages.tracks_page import TracksPage
from .panels import caption, drill_words
from .panels.asked_card import options
from .panels.guide import Guide
from .panels.parts import Panel, fixed_parts
from .panels.shot_panels import shot_parts
from .panels.toast import Toast
from .table.marks import aiming
from .table.over import LaidCard, outlined
from .table.sketch import Sketch
from .table.stage import Stage

STILL = 0.15
"""Seconds after which an aim counts as still."""
LAYS = ("line", "scene", "open", "table", "match", "resume")
"""Actions that lay something else than a drill."""
BATCH = 2
"""Samples of the spread taken in a frame."""


class View:
    """Everything in the window, for one game."""

    def __init__(
        self,
        session: Session,
        size: tuple[int, int],
        length: float,
        width: float,
        preferences: Preferences | None = None,
    ) -> None:
        self.session, self.pointer, self.spread = session, Pointer(), Spread()
        self.sketch, self.tracks, self.coach = Sketch(), TracksPage(), Coach()
        self.toast, self.last, self.shots = Toast(), LastStroke(session), ShotFolder()
        self.guide, self.trainer, self.labs = Guide(), Trainer(session), LabsPage()
        self.pages: dict[str, Page] = {
            "settings": SettingsPage(), "menu": MenuPage(), "shelf": ShelfPage(self.trainer),
            "rules": RulesPage(), "score": ScorePage(), "ask": question.QuestionPage(),
            "tracks": self.tracks, "save": ShotsPage(self.last, self.shots, saving=True),
            "shots": ShotsPage(self.last, self.shots, saving=False), "labs": self.labs,
        }  # fmt: skip
        self.composition = Composition()
        self.keys_sheet = 0
        """Which sheet of the page of keys is on show."""
        self.question: Question | None = None
        """What is asked over the page before it is done."""
        self.preferences = preferences or Preferences()
        self._table = length, width
        self._fit(size)

    @property
    def page(self) -> Page:
        """The page that lies over the table."""
        return self.pages[self.session.page]

    def open(self) -> None:
        """A page has been laid over the table."""
        self.question = None
        self.page.open(self.session)

    @property
    def typing(self) -> bool:
        """Do characters go into a box, or into the page over the table?"""
        if self.session.help:
            return False
        if self.session.page:
            return self.question is None and self.page.typing
        return self.session.aim.box is not None

    @property
    def field(self) -> TextField | None:
        """The text that keys edit: of a box, or of the page over the table if it has one."""
        if not self.session.page:
            return self.session.aim.edited
        found = None if self.question is not None else getattr(self.page, "field", None)
        return found if isinstance(found, TextField) else None

    @property
    def searching(self) -> bool:
        """Does a process beside the window look for a shot?"""
        return self.sketch.searching or self.coach.searching

    def found(self) -> list[Action]:
        """What the processes beside the window have found since the last frame."""
        session, level = self.session, self.preferences.settings.level
        drawn = self.sketch.look(session)
        return [*([] if drawn is None else [drawn]), *self.coach.look(session, level)]

    def end(self) -> None:
        """End all that goes on beside the window."""
        self.sketch.clear()
        self.tracks.stop()
        self.coach.close()

    def done(self, action: Action, *, step: bool) -> None:
        """An action of the game has been done; was it a step that can be taken back?"""
        self.toast.note(action, step=step)
        if action.name == "drill":
            self.trainer.begin(str(action.value))
        elif action.name in LAYS:
            self.trainer.end()
        self.note()

    def note(self) -> None:
        """Something has happened in the game."""
        self.guide.note(self.session)
        if self.trainer.note():
            drill_words.tell(self.trainer, self.toast, self.sight.words)
        if self.last.note():
            same = self.last.came
            self.toast.say("toast.same" if same else "toast.differs", bad=not same)

    def turn_keys(self, step: int) -> None:
        """Turn to another sheet of the page of keys."""
        self.keys_sheet = (self.keys_sheet + step) % keys_page.sheets()
        self.expose()

    def ask(self, action: Action) -> None:
        """Ask over the page whether an action is to be done."""
        self.question = Question(action)

    def answer(self, event: pygame.event.Event) -> Action | None:
        """Return what an event means for the question, which goes when it is answered."""
        asked = self.question
        if asked is None:
            return None
        if event.type == pygame.KEYDOWN:
            always = self.preferences.keys.always.get(event.key)
            if always == Action("language"):
                return always
        said = asked.answer(event, self.sight)
        if said is not None:
            self.question = None
        return asked.action if said else None

    def meant(self, event: pygame.event.Event) -> list[pygame.event.Event]:
        """Return an event, or those that take its place around what is being composed."""
        if self.typing or event.type == pygame.TEXTINPUT:
            return self.composition.take(event)
        return [] if event.type == pygame.TEXTEDITING else [event]

    def renew(self, length: float, width: float) -> None:
        """Show another table, or the same one with other balls."""
        self._table = length, width
        self._fit(self.sight.layout.size)

    def resize(self, size: tuple[int, int]) -> None:
        """Lay everything out again."""
        before = self.stage
        self._fit(size)
        self.stage.take_over(before)

    def _fit(self, size: tuple[int, int]) -> None:
        layout = Layout(size, *self._table)
        given = self.pointer, self.preferences, self.spread
        self.sight = Sight(self.session, layout, Type(layout.s), *given)
        self.sight.composition = self.composition
        self.stage = Stage(layout, self.session, self.preferences.settings, self.spread)
        self.stage.sketch, self.stage.trainer = self.sketch, self.trainer
        self.sight.trainer = self.trainer
        self.sight.portrait, self.sight.looks = self.stage.sprites.portrait, self.stage.looks
        self.parts = fixed_parts(layout) + shot_parts(layout)
        self._drawn: dict[str, Hashable] = {}
        self._mode = ""
        self._news: Hashable = None
        self._overlay: Hashable = None
        self._page_look: Hashable = None
        self._behind: pygame.Surface | None = None
        self._whole = True

    def expose(self) -> None:
        """Draw everything the next time: the window may have been covered."""
        self._whole = True

    def think(self, seconds: float) -> tuple[bool, bool]:
        """Work on what takes more than a frame: has anything changed, is it going on?

        `seconds` have passed since the last time.
        """
        gone = self.toast.passed(seconds) | self.guide.passed(seconds, self.session)
        changed, going = self._work(seconds)
        return changed or gone, going

    def _work(self, seconds: float) -> tuple[bool, bool]:
        """Work on a fit, a ball that falls, or the spread."""
        session, spread = self.session, self.spread
        if self.tracks.running:
            return self.tracks.think(seconds), True
        if self.stage.dropped.falls(session):
            return True, True
        if not (self.preferences.settings.fan and aiming(session)) or session.preview is None:
            return spread.clear(), False
        changed = spread.follow(session.preview_key, seconds)
        shot, contest = session.aim.shot, session.contest
        if shot is not None and spread.still >= STILL and not spread.done:
            scores = contest.scores if contest is not None else None
            spread.take(session.world, session.cue, shot, BATCH, scores)
            changed = True
        if changed:
            self._news = None
        return changed, not spread.done

    # -- the picture ---------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> list[pygame.Rect]:
        """Bring the surface up to date; returns the rectangles that changed."""
        self.stage.over.cards = (*self._cards(),)
        overlay = self._wanted()
        if overlay != self._overlay:
            self._overlay, self._whole = overlay, True
        if self._whole:
            return self._draw_whole(surface)
        if self.session.help:
            return []
        if self.session.page:
            return self._draw_page(surface)
        return self.stage.draw(surface, self.session) + self._draw_parts(surface)

    def _cards(self) -> Iterator[LaidCard]:
        """What lies over the table."""
        self.stage.diamonds.key(self.session, self.preferences.settings.diamonds)
        toast = self.toast.cards(self.sight)
        for card in caption.cards(self.sight, self.stage.diamonds):
            if card.rect.collidelist([over.rect for over in toast]) < 0:
                yield card
        yield from self.guide.cards(self.sight)
        yield from toast

    def _wanted(self) -> Hashable:
        """What lies over the window: the page of keys, the settings, or None."""
        shown = "help" if self.session.help else self.session.page
        return (shown, self.session.language) if shown else None

    def _draw_page(self, surface: pygame.Surface) -> list[pygame.Rect]:
        look = self.page.look(self.sight), self.question and self.question.look()
        if look == self._page_look:
            return []
        if self._page_look is None or self._behind is None:
            self._behind = surface.copy()
        else:
            surface.blit(self._behind, (0, 0))  # round corners must not be drawn over themselves
        self._page_look = look
        rect = self.page.draw(surface, self.sight)
        if self.question is not None:
            self.question.draw(surface, rect, self.sight)
        return [rect]

    def _draw_whole(self, surface: pygame.Surface) -> list[pygame.Rect]:
        self._whole = False
        self.stage.everything(surface, self.session)
        self._drawn, self._mode, self._news = {}, "", None
        self._draw_parts(surface)
        self._page_look = None
        if self.session.help:
            layout = self.sight.layout
            names = self.preferences.keys.names
            given = self.session.language, names, self.keys_sheet
            keys_page.draw(surface, layout, self.sight.type, *given)
        elif self.session.page:
            keys_page.darken(surface)
            self._draw_page(surface)
        return [surface.get_rect()]

    def _draw_parts(self, surface: pygame.Surface) -> list[pygame.Rect]:
        lit = self.guide.points
        news = self.session.news, self.pointer.over, self.pointer.held, self.composition.text, lit
        if news == self._news:
            return []
        self._news = news
        dirty = self._switch(surface)
        for part in self._shown():
            key = self.session.language, part.key(self.sight), part.name == lit
            if part.name not in self._drawn or self._drawn[part.name] != key:
                self._drawn[part.name] = key
                spill = 2 * round(part.spill * self.sight.layout.s)
                surface.set_clip(part.rect.inflate(spill, spill))
                rect = part.draw(surface, part.rect, self.sight)
                if part.name == lit:
                    outlined(surface, part.rect, self.sight.layout.s)
                if rect.w and rect.h:
                    dirty.append(rect)
        surface.set_clip(None)
        return dirty

    def _switch(self, surface: pygame.Surface) -> list[pygame.Rect]:
        """Clear the column when it is to show the other shot."""
        mode = "after" if self.session.shown_shot else "aim"
        if options(self.session):
            mode = "asked"
        if mode == self._mode:
            return []
        self._mode = self.sight.mode = mode
        self.sight.choice = -1
        for part in self.parts:
            if part.mode:
                self._drawn.pop(part.name, None)
        column = self.sight.layout.panel
        surface.blit(self.stage.base, column, column)
        return [column]

    def _shown(self) -> list[Panel]:
        return [p for p in self.parts if not p.mode or self._mode in p.mode.split()]

    # -- the mouse -----------------------------------------------------------------------------

    def hover(self, at: tuple[int, int]) -> bool:
        """Note what the mouse is over; returns whether that changed."""
        part = self._at(at)
        over = part.name if part else ""
        changed = over != self.pointer.over
        self.pointer.over = over
        return changed

    def press(self, at: tuple[int, int]) -> Action | None:
        """Return what a press of the left button at a point means."""
        self.hover(at)
        part = self._at(at)
        self.pointer.held, self.pointer.grip = part.name if part else "", None
        self.pointer.began, self.pointer.stirred = at, False
        self.pointer.pressing = True
        action = part.touch(at, part.rect, self.sight) if part else None
        self.pointer.pressing = False
        return action

    def drag(self, at: tuple[int, int]) -> Action | None:
        """Return what moving the mouse with the button held means."""
        pointer = self.pointer
        pointer.stirred |= dist(at, pointer.began) > SLACK * self.sight.layout.s
        for part in self._shown():
            if part.name == self.pointer.held and part.drags:
                return part.touch(at, part.rect, self.sight)
        return None

    def release(self) -> bool:
        """The button is up, or what it held is covered; returns whether anything was held."""
        held = bool(self.pointer.held) or self.pointer.grip is not None
        self.pointer.held, self.pointer.grip = "", None
        return held

    def wheel(self, steps: int) -> Action | None:
        """Return what turning the wheel up means where the mouse is."""
        for part in self._shown():
            if part.name == self.pointer.over and steps:
                return part.wheel(steps, self.sight)
        return None

    def _at(self, at: tuple[int, int]) -> Panel | None:
        return next((p for p in self._shown() if p.rect.collidepoint(at)), None)
