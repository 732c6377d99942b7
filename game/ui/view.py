"""The whole window: the table and the parts around it; draws and tells what changed."""

from __future__ import annotations

from collections.abc import Hashable

import pygame

from game.actions import Action
from game.play import Game
from game.preferences import Preferences
from game.render.layout import Layout
from game.render.text import Type

from . import help as page
from .panels import shot_parts
from .parts import Part, Sight, fixed_parts
from .sheet import Sheet
from .stage import Stage
from .touch import Pointer

LEAST = (640, 360)
"""A window smaller than this shows its contents cut off rather than unreadably small."""


class View:
    """Everything in the window, for one game."""

    def __init__(
        self,
        game: Game,
        size: tuple[int, int],
        length: float,
        width: float,
        preferences: Preferences | None = None,
    ) -> None:
        self.game, self.pointer, self.sheet = game, Pointer(), Sheet()
        self.preferences = preferences or Preferences()
        self._table = length, width
        self._fit(size)

    def renew(self, length: float, width: float) -> None:
        """Show another table, or the same one with other balls."""
        self._table = length, width
        self._fit(self.sight.layout.size)

    def resize(self, size: tuple[int, int]) -> None:
        """Lay everything out anew."""
        turns = [self.stage.sprites.orientation(i) for i in range(len(self.stage.looks))]
        trail = self.stage.trail
        self._fit(size)
        self.stage.trail = trail
        for i, turn in enumerate(turns):
            self.stage.sprites.orient(i, turn)

    def _fit(self, size: tuple[int, int]) -> None:
        size = max(size[0], LEAST[0]), max(size[1], LEAST[1])
        layout = Layout(size, *self._table)
        self.sight = Sight(self.game, layout, Type(layout.s), self.pointer, self.preferences)
        self.stage = Stage(layout, self.game, self.preferences.settings)
        self.parts = [p for p in fixed_parts(layout) + shot_parts(layout) if p.rect.w and p.rect.h]
        self._drawn: dict[str, Hashable] = {}
        self._mode = ""
        self._news: tuple[int, str, str] | None = None
        self._overlay: Hashable = None
        self._sheet_look: Hashable = None
        self._behind: pygame.Surface | None = None
        self._whole = True

    def expose(self) -> None:
        """Draw everything the next time: the window may have been covered."""
        self._whole = True

    # -- the picture ---------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> list[pygame.Rect]:
        """Bring the surface up to date; returns the rectangles that changed."""
        overlay = self._wanted()
        if overlay != self._overlay:
            self._overlay, self._whole = overlay, True
        if self._whole:
            return self._draw_whole(surface)
        if self.game.help:
            return []
        if self.game.sheet:
            return self._draw_sheet(surface)
        return self.stage.draw(surface, self.game) + self._draw_parts(surface)

    def _wanted(self) -> Hashable:
        """What lies over the window: the page of keys, the settings, or None."""
        shown = "help" if self.game.help else "sheet" if self.game.sheet else ""
        return (shown, self.game.language) if shown else None

    def _draw_sheet(self, surface: pygame.Surface) -> list[pygame.Rect]:
        look = self.sheet.look(self.sight)
        if look == self._sheet_look:
            return []
        if self._sheet_look is None or self._behind is None:
            self._behind = surface.copy()
        else:
            surface.blit(self._behind, (0, 0))  # round corners must not be drawn over themselves
        self._sheet_look = look
        return [self.sheet.draw(surface, self.sight)]

    def _draw_whole(self, surface: pygame.Surface) -> list[pygame.Rect]:
        self._whole = False
        self.stage.everything(surface, self.game)
        self._drawn, self._mode, self._news = {}, "", None
        self._draw_parts(surface)
        self._sheet_look = None
        if self.game.help:
            layout = self.sight.layout
            page.draw(surface, layout, self.sight.type, self.game.language)
        elif self.game.sheet:
            page.darken(surface)
            self._draw_sheet(surface)
        return [surface.get_rect()]

    def _draw_parts(self, surface: pygame.Surface) -> list[pygame.Rect]:
        news = (self.game.news, self.pointer.over, self.pointer.held)
        if news == self._news:
            return []
        self._news = news
        dirty = self._switch(surface)
        for part in self._shown():
            key = self.game.language, part.key(self.sight)
            if part.name not in self._drawn or self._drawn[part.name] != key:
                self._drawn[part.name] = key
                spill = 2 * round(part.spill * self.sight.layout.s)
                surface.set_clip(part.rect.inflate(spill, spill))
                rect = part.draw(surface, part.rect, self.sight)
                if rect.w and rect.h:
                    dirty.append(rect)
        surface.set_clip(None)
        return dirty

    def _switch(self, surface: pygame.Surface) -> list[pygame.Rect]:
        """Clear the column when it is to show the other shot."""
        mode = "after" if self.game.shown_shot else "aim"
        if mode == self._mode:
            return []
        self._mode = self.sight.mode = mode
        for part in self.parts:
            if part.mode:
                self._drawn.pop(part.name, None)
        column = self.sight.layout.panel
        surface.blit(self.stage.base, column, column)
        return [column]

    def _shown(self) -> list[Part]:
        return [p for p in self.parts if p.mode in ("", self._mode)]

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
        self.pointer.held = part.name if part else ""
        return part.touch(at, part.rect, self.sight) if part else None

    def drag(self, at: tuple[int, int]) -> Action | None:
        """Return what moving the mouse with the button held means."""
        for part in self._shown():
            if part.name == self.pointer.held and part.drags:
                return part.touch(at, part.rect, self.sight)
        return None

    def release(self) -> None:
        """The button is up."""
        self.pointer.held = ""

    def _at(self, at: tuple[int, int]) -> Part | None:
        return next((p for p in self._shown() if p.rect.collidepoint(at)), None)
