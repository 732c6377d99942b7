"""Held keys: what is a step goes on, what is not does not."""

import pygame
import pytest

from game.input.repeat import FIRST, NEXT, Repeat
from game.session.action import Action
from game.session.ticks import TICKS


@pytest.fixture
def held(monkeypatch):
    down = {pygame.K_q: True}
    monkeypatch.setattr(pygame.key, "get_pressed", lambda: down)
    return down


def test_a_held_step_goes_on_after_a_while_and_then_at_its_rate(held):
    repeat = Repeat()
    repeat.press(pygame.K_q, Action("turn", "1"))
    assert repeat.due(FIRST - 1) == 0
    assert repeat.due(1 + NEXT) == 1
    assert sum(repeat.due(NEXT // 3) for _ in range(90)) == pytest.approx(30, abs=1)
    assert repeat.due(TICKS) == pytest.approx(TICKS / NEXT, abs=1)


def test_a_key_that_is_let_go_does_nothing_more(held):
    repeat = Repeat()
    repeat.press(pygame.K_q, Action("turn", "1"))
    held[pygame.K_q] = False
    assert repeat.due(TICKS) == 0
    held[pygame.K_q] = True
    assert repeat.due(TICKS) == 0


def test_a_held_key_shoots_only_once(held):
    repeat = Repeat()
    repeat.press(pygame.K_q, Action("shoot"))
    assert repeat.due(TICKS) == 0
