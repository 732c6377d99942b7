"""The guide through a first shot: three steps on a card over the table, and what comes after."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from game.render.theme import ACCENT, TEXT, TEXT_SOFT
from game.session.session import Session
from game.ui.sight import Sight
from game.ui.table.over import LaidCard, written

AIM, POWER, SHOOT, DONE = 1, 2, 3, 4
"""The steps; 0 is no guide at all."""
STAYS = 12.0
"""Seconds for which the last card stays after the balls have come to rest."""
POINTS = {POWER: "power", SHOOT: "shoot"}
"""The part of the window that a step is about."""


class Guide:
    """Which step is on show; it goes on when the player has done what it asks for.

    over  called once it is done or has been skipped: there is never another one
    """

    def __init__(self) -> None:
        self.step = 0
        self.over: Callable[[], object] = lambda: None
        self._begun: tuple[object, ...] = ()
        self._left = STAYS

    @property
    def points(self) -> str:
        """The part of the window that is to be lit, or ""."""
        return POINTS.get(self.step, "")

    def begin(self, session: Session) -> None:
        """Show the first step."""
        self.step, self._left = AIM, STAYS
        self._begun = session.aim.angle, session.aim.power, session.aim.tip, session.shots

    def note(self, session: Session) -> None:
        """Something has happened: has the step been done?"""
        if not self.step:
            return
        angle, power, tip, shots = self._begun
        aim = session.aim
        if session.shots != shots or session.contest is not None:
            self.step = DONE
        elif self.step == AIM and aim.angle not in (angle, None) and aim.box is None:
            self.step = POWER
        elif self.step == POWER and (aim.power, aim.tip) != (power, tip) and aim.box is None:
            self.step = SHOOT

    def go_on(self) -> None:
        """Turn to the next step, or away after the last one."""
        if self.step in (SHOOT, DONE):
            self.skip()
        else:
            self.step += 1

    def skip(self) -> None:
        """Show no more of it."""
        self.step = 0
        self.over()

    def passed(self, seconds: float, session: Session) -> bool:
        """Let time pass; returns whether it has ended by that."""
        if self.step != DONE or session.moving or session.held:
            return False
        self._left -= seconds
        if self._left > 0.0:
            return False
        self.skip()
        return True

    def cards(self, sight: Sight) -> list[LaidCard]:
        """The card, at the top of the table."""
        if not self.step:
            return []
        w, bed = sight.words, sight.layout.bed
        rows = [(w[f"guide.{self.step}"], 15, ACCENT)]
        rows += [(w[f"guide.{self.step}.{n}"], 13, TEXT) for n in (1, 2)]
        rows.append((w["guide.end" if self.step == DONE else "guide.foot"], 12, TEXT_SOFT))
        picture = written(sight.type, rows, ACCENT, 0.94 * bed.w, 22)
        rect = picture.get_rect(midtop=(bed.centerx, bed.y + sight.layout.px(12)))
        return [LaidCard(("guide", self.step, sight.session.language, rows[0][0]), rect, picture)]

    def press(self, at: tuple[int, int], sight: Sight) -> bool:
        """A press of the mouse: the card goes on, its foot ends the guide; was it there?"""
        for card in self.cards(sight):
            if card.rect.collidepoint(at):
                foot = pygame.Rect(card.rect)
                foot.h = card.rect.h // 4
                foot.bottom = card.rect.bottom
                (self.skip if foot.collidepoint(at) else self.go_on)()
                return True
        return False
