"""The guide through a first shot: once, in a real window, and never in the way."""

from types import SimpleNamespace

import pytest

from game import start
from game.options import Options
from game.session.action import Action
from game.settings.preferences import Preferences
from game.settings.settings import Settings, Store
from game.ui.panels.guide import AIM, DONE, POWER, SHOOT, STAYS
from tests.support.players import FRAME, an_app, assert_same_as_anew, click, press, run_to_rest

LANGUAGES = pytest.mark.parametrize("language", ["en", "ko"])


def guided(size=(960, 540), **options):
    app = an_app(size, **options)
    app.over = []
    app.view.guide.over = lambda: app.over.append(True)
    app.view.guide.begin(app.session)
    app.redraw()
    app.frame(FRAME)
    return app


@LANGUAGES
@pytest.mark.parametrize("size", [(640, 360), (1280, 720)])
def test_a_first_shot_is_aimed_given_power_and_shot(size, language):
    app = guided(size, lang=language)
    guide, seen = app.view.guide, [app.view.guide.step]
    for key in ("q", "pageup", "return"):
        press(app, key)
        assert_same_as_anew(app)
        seen.append(guide.step)
    assert seen == [AIM, POWER, SHOOT, DONE]
    run_to_rest(app)
    for _ in range(int(STAYS) + 2):
        app.frame(60 * FRAME)
    assert (guide.step, app.over) == (0, [True])
    assert_same_as_anew(app)


@pytest.mark.parametrize("before", [(), ("q",), ("q", "pageup"), ("return",)])
def test_escape_skips_the_guide_and_opens_no_menu(before):
    app = guided()
    press(app, *before, "escape")
    assert (app.view.guide.step, app.over, app.session.page) == (0, [True], "")
    assert_same_as_anew(app)
    press(app, "escape")
    assert app.session.page == "menu"


def test_a_shot_without_the_steps_before_it_ends_them():
    app = guided()
    press(app, "return")
    assert app.session.moving
    assert app.view.guide.step == DONE


def test_a_press_on_the_card_goes_on_and_on_its_foot_skips():
    app = guided()
    card = app.view.guide.cards(app.view.sight)[0].rect
    angle = app.session.aim.angle
    click(app, card.midtop)
    assert (app.view.guide.step, app.session.aim.angle) == (POWER, angle)
    card = app.view.guide.cards(app.view.sight)[0].rect
    click(app, (card.centerx, card.bottom - 3))
    assert (app.view.guide.step, app.over) == (0, [True])


def test_every_card_fits_on_the_table_with_all_its_words(monkeypatch):
    for language in ("en", "ko"):
        app = guided((640, 360), lang=language)
        type_, w = app.view.sight.type, app.view.sight.words
        for app.view.guide.step in (AIM, POWER, SHOOT, DONE):
            card = app.view.guide.cards(app.view.sight)[0]
            assert app.view.sight.layout.bed.contains(card.rect)
            for line in ("1", "2"):
                room = card.rect.w - type_.width("m", 13)
                assert type_.width(w[f"guide.{app.view.guide.step}.{line}"], 13) < room


def first_game(path, **options):
    store = Store(path)
    own = Preferences(store.load(), store)
    return SimpleNamespace(preferences=own, options=Options(**options))


def test_the_guide_begins_in_a_first_game_in_a_real_window_alone(tmp_path, monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "x11")
    path = tmp_path / "settings.json"
    assert start.newcomer(first_game(path))
    assert not start.newcomer(first_game(path, frames=10))
    assert not start.newcomer(first_game(path, replay="game.jsonl"))
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    assert not start.newcomer(first_game(path))
    assert not start.newcomer(SimpleNamespace(preferences=Preferences(), options=Options()))


def test_the_guide_is_never_shown_again_once_it_is_over(tmp_path, monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "x11")
    path = tmp_path / "settings.json"
    begun = first_game(path)
    begun.preferences.guided()
    assert Store(path).load().guided
    assert not start.newcomer(first_game(path))


def test_the_guide_is_not_for_somebody_with_settings_of_an_older_game(tmp_path, monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "x11")
    path = tmp_path / "settings.json"
    assert Store(path).save(Settings(volume=3))
    assert not start.newcomer(first_game(path))


def test_a_match_from_the_menu_ends_the_steps():
    app = guided()
    app.perform(Action("match", '{"game":"four-ball"}'))
    assert app.view.guide.step == DONE
