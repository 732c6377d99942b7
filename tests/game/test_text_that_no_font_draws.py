"""Text from anywhere is drawn, with a sign for what no font can draw."""

import ast
from pathlib import Path

import pygame
import pytest

import game
from game.render.font import Type
from game.session.action import Action
from tests.support.players import FRAME, an_app

ROOT = Path(game.__file__).parent
OWN = [*ROOT.glob("ui/**/*.py"), *ROOT.glob("text/en*.py"), *ROOT.glob("text/ko*.py")]
UNDRAWABLE = ["\0", "\ud800", "a\nb", "\x7f", "\x85", "\u2028", "가\udfff나"]


@pytest.mark.parametrize("text", UNDRAWABLE)
@pytest.mark.parametrize("size", [9, 30])
def test_a_text_that_no_font_can_draw_is_drawn_with_a_sign(text, size):
    type_ = Type(1.0)
    signs = "".join(c if c.isprintable() else "\ufffd" for c in text)
    assert type_.width(text, size) == type_.width(signs, size) > 0
    drawn, wanted = (type_.render(each, size, (9, 9, 9)) for each in (text, signs))
    assert pygame.image.tobytes(drawn, "RGBA") == pygame.image.tobytes(wanted, "RGBA")


@pytest.mark.parametrize("text", ["\0", "\ud800"])
def test_text_being_composed_that_cannot_be_drawn_does_not_end_the_game(text):
    app = an_app()
    app.perform(Action("edit", 0))
    app.handle(pygame.event.Event(pygame.TEXTEDITING, text=text, start=0, length=0))
    app.frame(FRAME)


@pytest.mark.parametrize("path", OWN, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_the_font_has_every_character_that_the_game_itself_writes(path):
    type_ = Type(1.0)

    def drawn(character):
        return pygame.image.tobytes(type_.render(character, 30, (9, 9, 9)), "RGBA")

    nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
    texts = [n.value for n in nodes if isinstance(n, ast.Constant) and isinstance(n.value, str)]
    box = drawn("\u0e01")  # a Thai letter, which the font does not have
    assert [c for c in {*"".join(texts)} if c.isprintable() and c > "~" and drawn(c) == box] == []
