"""Labs in the game: chosen, opened, played, answered, printed, in both languages."""

import pygame
import pytest

from danggu import labs
from game.__main__ import main
from game.render.font import type_at
from game.render.layout import Layout
from game.session.action import Action
from game.session.commands import fault, perform
from game.session.session import Session
from game.table import lineup, presets
from game.table.lab_scenes import key_of, sheet
from game.text import LANGUAGES
from game.ui.pages import labs_text, labs_view, page_parts
from game.ui.panels.parts import badge
from physics import whole_files
from tests.support.players import FRAME, an_app, press, write

KEYS = [key_of(name, seed) for name in labs.LABS for seed in (None, 7)]


def opened(tmp_path=None):
    app = an_app()
    if tmp_path is not None:
        app.view.labs.folder = tmp_path
    press(app, "f7")
    return app, app.view.labs


@pytest.mark.parametrize("key", KEYS)
def test_the_scene_of_a_lab_is_begun_by_its_name_and_is_what_the_worksheet_plays(key):
    assert fault(Action("scene", key)) == ""
    session = Session(presets.table_world("medium"))
    perform(session, Action("scene", key))
    world = sheet(key).world()
    assert session.table == key
    assert session.moving
    assert {b.name: b.placed for b in session.world.balls} == {
        b.name: b.placed for b in world.balls
    }
    assert session.world.ball_law == world.ball_law
    session.advance(60)


@pytest.mark.parametrize("key", KEYS[::3])
def test_how_the_balls_of_a_lab_lie_is_a_line_that_comes_back(key):
    found = lineup.of(presets.scene_world(key), key)
    assert lineup.read(found.line()) == found
    assert found.world().at_rest


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("key", KEYS)
def test_the_card_of_the_table_says_which_lab_it_is(key, language):
    session = Session(presets.scene_world(key), table=key, language=language)
    assert badge(session, LANGUAGES[language])[1].endswith(sheet(key).title(language))


@pytest.mark.parametrize("key", ["lab:", "lab:pie", "lab:pi:x", "lab:pi:-1", "lab:pi:07", "pi"])
def test_a_lab_that_there_is_not_is_no_scene(key):
    assert key not in presets.SCENES
    assert fault(Action("scene", key)).startswith("scene takes one of")
    with pytest.raises(KeyError):
        presets.SCENES[key]


def test_labs_are_known_and_not_listed_among_the_scenes():
    assert "lab:pi" in presets.SCENES
    assert not any(name.startswith("lab:") for name in presets.SCENES)


def test_a_scene_that_has_run_is_run_again_as_it_began():
    app = an_app()
    app.perform(Action("scene", "lab:momentum-energy:3"))
    begun = app.session.world.layout()
    for _ in range(30):
        app.frame(FRAME)
    press(app, "r", frames=False)
    app.frame(0)
    assert app.session.world.layout() == begun
    assert app.session.moving


def test_a_lab_is_chosen_with_numbers_of_ones_own_and_opened():
    app, page = opened()
    press(app, "down", "down", "pageup", "pageup", "pagedown", "return")
    assert (page.place, page.seed) == (2, 1)
    assert app.session.table == "lab:thirty-degrees:1"
    assert app.session.page == ""


def test_answers_are_typed_checked_and_kept_until_they_change():
    app, page = opened()
    right = page.sheet.truth["speed"]
    press(app, "tab")
    write(app, f"{right:.3f}")
    press(app, "return")
    assert page.focus == 1
    write(app, "0")
    press(app, "return")
    assert page.said == ("labs.checked", "1 2")
    look = page.look(app.view.sight)
    assert look.ways[:3] == (0, -1, None)
    press(app, "f7", "f7")
    assert page.look(app.view.sight).ways == look.ways
    press(app, "tab")  # from the third field to the fourth
    page.focus = 1
    write(app, "5")
    assert page.look(app.view.sight).ways[:2] == (0, None)


def test_answers_to_one_worksheet_are_not_those_to_another():
    app, page = opened()
    press(app, "tab")
    write(app, "1")
    press(app, "pageup")
    assert page.fields[0].text == ""
    press(app, "pagedown")
    assert page.fields[0].text == "1"


def test_what_is_no_number_is_said_to_be_none():
    app, page = opened()
    press(app, "tab")
    write(app, "fast")
    press(app, "return")
    assert page.said == ("labs.unread", "fast")
    page.focus = 0
    press(app, *["backspace"] * 4)
    press(app, "return")
    assert page.said[0] == "labs.unanswered"


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_to_print_is_written_whole_and_where_is_said(language, tmp_path):
    app, page = opened(tmp_path)
    app.perform(Action("language", language))
    press(app, "pageup", "p")
    file = tmp_path / "labs" / f"five-sevenths-1.{language}.html"
    assert file.read_text("utf-8") == labs.page(labs.lab("five-sevenths", 1), language)
    assert page.said == ("labs.printed", str(file))
    assert [*file.parent.iterdir()] == [file]
    app.frame(FRAME)


def test_a_page_that_cannot_be_written_says_why_and_the_game_goes_on(tmp_path, monkeypatch):
    app, page = opened(tmp_path)

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(whole_files, "replace", full)
    press(app, "p")
    assert page.said == ("labs.unprinted", "No space left on device")
    app.frame(FRAME)
    assert not app.session.over


def test_all_of_it_is_done_with_the_mouse_too(tmp_path):
    app, page = opened(tmp_path)
    sight = app.view.sight

    def click(rect):
        args = {"pos": rect.center, "button": 1}
        app.handle(pygame.event.Event(pygame.MOUSEBUTTONDOWN, args))
        app.handle(pygame.event.Event(pygame.MOUSEBUTTONUP, args))

    click(labs_view.lab_rects(sight.layout, len(labs.LABS))[7])
    assert page.sheet.name == "cradle"
    click(labs_view.field_rects(sight.layout, 5)[1])
    write(app, "1")
    click(labs_view.button_rects(sight.layout)["check"])
    assert page.look(sight).ways == (None, 0, None, None, None)
    click(labs_view.button_rects(sight.layout)["more"])
    click(labs_view.button_rects(sight.layout)["print"])
    assert page.said[0] == "labs.printed"
    click(labs_view.button_rects(sight.layout)["open"])
    assert app.session.table == "lab:cradle:1"


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (2560, 1440), (1024, 768)])
@pytest.mark.parametrize("language", LANGUAGES)
def test_every_question_has_room_above_its_answers(size, language):
    app = an_app()
    sight = app.view.sight
    sight.layout, sight.type = Layout(size, 2.54, 1.27), type_at(Layout(size, 2.54, 1.27).s)
    app.session.language = language
    for name in labs.LABS:
        one = labs.lab(name)
        boxes = labs_view.field_rects(sight.layout, len(one.fields))
        room = labs_view._reading(sight.layout, boxes)
        _, high = labs_text.question(sight, one, room.w)
        assert high <= room.h + labs_text.PARAGRAPH * sight.layout.s, name
        assert page_parts.inside(sight.layout).contains(boxes[-1])
    rows = labs_view.lab_rects(sight.layout, len(labs.LABS))
    assert page_parts.inside(sight.layout).inflate(2, 8).contains(rows[-1])


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_table_is_beside_or_beneath_every_question_in_a_usual_window(language, monkeypatch):
    app, _ = opened()
    app.session.language, drawn = language, []
    monkeypatch.setattr(labs_text, "table", lambda *args: drawn.append(args[-1]))
    for name in labs.LABS:
        one = labs.lab(name)
        boxes = labs_view.field_rects(app.view.sight.layout, len(one.fields))
        room = labs_view._reading(app.view.sight.layout, boxes)
        labs_text.draw(app.canvas.surface, app.view.sight, one, room)
        assert len(drawn) == 1, name
        assert room.inflate(2, 2).contains(drawn.pop()), name


def test_labs_and_sweeps_need_no_game_and_no_other_command(capsys):
    assert main(["lab", "cradle", "--answer", "leave=2"]) == 0
    assert capsys.readouterr().out == "leave: right\n"
    assert main(["lab", "cradle", "--answer", "leave=3"]) == 1
    assert main(["sweep", "--game", "three-cushion", "--speed", "4", "--angle", "0,180"]) == 0
    assert "2 shots at white" in capsys.readouterr().err
    for command in ("lab", "sweep"):
        with pytest.raises(SystemExit) as left:
            main([command, "--help"])
        assert left.value.code == 0
        assert f"danggu {command}" in capsys.readouterr().out
