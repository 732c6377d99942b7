"""The layers that an input event goes down: each answers with what it means, or passes it on.

From the top: a record that is watched, the question, the page of keys, the page over the table, the
guide, what a match asks, drawing a path, placing balls, sharing, the box that is edited, and the
table with what is around it.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

import pygame

from game.input import editing
from game.input.key_tables import of_key, of_text
from game.session.action import Action
from game.session.commands import COMMANDS

from .panels import asked_card, nominate, prompts, sharing
from .table import place_balls
from .view import View

MOUSE = (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP)
INPUT = (pygame.KEYDOWN, pygame.TEXTINPUT, pygame.MOUSEWHEEL, *MOUSE)
"""The events that go down the layers."""
SHEETS = {
    pygame.K_LEFT: -1, pygame.K_RIGHT: 1, pygame.K_PAGEUP: -1, pygame.K_PAGEDOWN: 1,
    pygame.K_TAB: 1,
}  # fmt: skip
"""Keys that turn the sheets of the page of keys."""


class Answer(NamedTuple):
    """What an event means to the layer that takes it.

    actions  to be done, one after the other
    held     what its key may go on doing while it is held
    redraw   has something changed that only the picture depends on?
    sure     has the player been asked already?
    """

    actions: tuple[Action, ...] = ()
    held: Action | None = None
    redraw: bool = False
    sure: bool = False


def answer(action: Action | None, *, held: Action | None = None, redraw: bool = False) -> Answer:
    """An answer of one action, or of none."""
    return Answer(() if action is None else (action,), held, redraw)


class Layer(Protocol):
    """Something that takes events."""

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Return what an event of INPUT means, or None to pass it on.

        `texts` says that a TEXTINPUT follows for each character that a KEYDOWN gives.
        """
        ...


class QuestionLayer:
    """The question, whatever it lies over."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Say what was asked about, or close the page that held nothing but the question."""
        view, asked = self.view, self.view.question
        alone = view.session.page == "ask"
        if asked is None and not alone:
            return None
        action = view.answer(event)
        closing = (Action("sheet", ""),) if alone and view.question is None else ()
        if action is not None:
            view.expose()  # what it changes shows behind the page too
        sure = asked is not None and action == asked.action
        return Answer((*closing, *answer(action).actions), _edits(event), True, sure)


class KeysLayer:
    """The page of keys: a few keys and a click close it; keys that always work go on from it."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Close it, change its language, or go on to another page."""
        session = self.view.session
        if not session.help:
            return None
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            return answer(Action("help"))
        if event.type != pygame.KEYDOWN:
            return Answer()
        if event.key in SHEETS:
            self.view.turn_keys(SHEETS[event.key])
            return Answer(redraw=True)
        always = self.view.preferences.keys.always.get(event.key)
        if event.key in place_balls.DONE or always == Action("help"):
            return answer(Action("help"))
        if always is None or always.name not in ("sheet", "settings"):
            return answer(always)
        # the page that it lies over is uncovered, not closed
        below = (always.value or always.name) == session.page
        return Answer((Action("help"), *(() if below else (always,))))


class PageLayer:
    """The page over the table."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Let the page take it, if there is one."""
        if not self.view.session.page:
            return None
        action = self.view.page.handle(event, self.view.sight)
        if action is not None:
            self.view.expose()  # what it changes shows behind the page too
        return answer(action, held=_edits(event), redraw=True)


def _edits(event: pygame.event.Event) -> Action | None:
    """What a key does in a field of text."""
    return editing.of_key(event) if event.type == pygame.KEYDOWN else None


class PlacingLayer:
    """Balls that are placed by hand: a few keys move them."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Move a ball, or take another one."""
        if event.type != pygame.KEYDOWN or not self.view.session.arranging:
            return None
        action = place_balls.key(event, self.view.session)
        return None if action is None else answer(action)


class GuideLayer:
    """The guide through a first shot: Esc skips it, a press on its card goes on."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Go on or skip; whatever else is done reaches the game, and the guide follows it."""
        view = self.view
        if not view.guide.step:
            return None
        editing_ = view.session.aim.box is not None
        if event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE and not editing_:
            view.guide.skip()
            return Answer(redraw=True)
        pressed = event.type == pygame.MOUSEBUTTONDOWN and event.button == 1
        if pressed and view.guide.press(event.pos, view.sight):
            return Answer(redraw=True)
        return None


class AskedLayer:
    """The question of a match: its keys answer it, and nothing is typed before that."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Take an answer, or go to another one; the table can be looked at all the while."""
        sight, contest = self.view.sight, self.view.session.contest
        asked = asked_card.options(self.view.session)
        if not asked or contest is None or contest.level is not None:
            return None
        if event.type == pygame.TEXTINPUT:
            return Answer()
        if event.type != pygame.KEYDOWN:
            return None
        own, action = asked_card.key(event, sight)
        return Answer(() if action is None else (action,), redraw=True) if own else None


class SketchLayer:
    """A path that is drawn with the mouse."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Draw on; or end the search, or else drawing."""
        view = self.view
        if not view.session.sketching:
            return None
        if event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE:
            cancelled = view.sketch.cancel(view.session)
            return answer(None if cancelled else Action("sketch"), redraw=True)
        if event.type in MOUSE:
            changed = view.hover(event.pos)
            if view.sketch.mouse(event, view.sight):
                return Answer(redraw=True)
            return Answer(redraw=True) if changed and event.type == pygame.MOUSEMOTION else None
        return None


class ShareLayer:
    """Ctrl+C and Ctrl+V where no text is meant: a shot goes into the clipboard or comes out."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Copy the shot on show, or open the one that has been copied."""
        ctrl = getattr(event, "mod", 0) & editing.COMMAND
        if event.type != pygame.KEYDOWN or not ctrl or event.mod & pygame.KMOD_ALT:
            return None
        view, edited = self.view, self.view.session.aim.edited
        if event.key == pygame.K_c and not (edited and edited.selected):
            sharing.copy(view.last, view.toast)
            return Answer(redraw=True)
        if event.key == pygame.K_v and (edited is None or sharing.offered()):
            return answer(sharing.paste(view.toast), redraw=True)
        return None


class BoxLayer:
    """The box that is edited: keys and characters go into it."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Edit the text of the box, or go to another one."""
        aim, keys = self.view.session.aim, self.view.preferences.keys
        if aim.edited is None:
            return None
        if event.type == pygame.TEXTINPUT:
            return answer(of_text(event, aim.box))
        if event.type != pygame.KEYDOWN:
            return None
        action = of_key(event, aim.box, texts, keys.play, keys.always)
        if event.key not in keys.always:
            action = editing.with_clipboard(editing.of_key(event), aim.edited) or action
        return answer(action, held=action)


class TableLayer:
    """The table and the panels around it, which take what nothing above them has taken."""

    def __init__(self, view: View) -> None:
        self.view = view

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Return what a shortcut, a digit or the mouse means."""
        view = self.view
        match event.type:
            case pygame.KEYDOWN:
                return self._key(event, texts)
            case pygame.TEXTINPUT:
                return answer(of_text(event, None))
            case pygame.MOUSEMOTION:
                changed = view.hover(event.pos)
                return answer(view.drag(event.pos), redraw=changed)
            case pygame.MOUSEBUTTONDOWN if event.button == 1:
                pressed = answer(view.press(event.pos), redraw=True)
                called = nominate.ball_at(event.pos, view.sight)
                return pressed._replace(actions=(*called, *pressed.actions))
            case pygame.MOUSEBUTTONDOWN if event.button == 3:
                return answer(nominate.cue_at(event.pos, view.sight))
            case pygame.MOUSEBUTTONUP if event.button == 1:
                return Answer(redraw=True)
            case pygame.MOUSEWHEEL:
                return answer(view.wheel(event.y))
        return None

    def _key(self, event: pygame.event.Event, texts: bool) -> Answer:
        keys = self.view.preferences.keys
        action = of_key(event, None, texts, keys.play, keys.always)
        if action == Action("shoot"):
            action = prompts.entered(self.view.session)
        return answer(action, held=action)


class Layers:
    """All of them, from the top; `first` lie above those of every game."""

    def __init__(self, view: View, *first: Layer) -> None:
        self.view = view
        self.stack: tuple[Layer, ...] = (
            *first, QuestionLayer(view), KeysLayer(view), PageLayer(view), GuideLayer(view),
            AskedLayer(view), SketchLayer(view), PlacingLayer(view), ShareLayer(view),
            BoxLayer(view), TableLayer(view),
        )  # fmt: skip

    def _again(self, action: Action) -> Action:
        """What puts balls back lays a drill again where the last lie is not its beginning."""
        trainer = self.view.trainer
        restarts = action.name == "retry" and trainer.restarts
        return Action("drill", trainer.drill) if restarts else action

    def ask(self, event: pygame.event.Event, texts: bool) -> Answer:
        """Return what the first layer says that does not pass an event of INPUT on."""
        answers = (layer.answer(event, texts) for layer in self.stack)
        found = next((found for found in answers if found is not None), Answer())
        found = found._replace(actions=(*map(self._again, found.actions),))
        if not prompts.asking(self.view.session):
            return found
        # before the question of a match is answered nothing is aimed
        left = (a for a in found.actions if a.name == "answer" or not COMMANDS[a.name].aims)
        return found._replace(actions=(*left,), held=None)
