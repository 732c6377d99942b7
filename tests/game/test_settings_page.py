"""The sheet in which settings are chosen: by keys, by mouse, and at every size of the window."""

from itertools import pairwise

import pygame
import pytest

from game.input.bindings import DEFAULTS
from game.input.captions import words
from game.session.action import Action
from game.settings.settings import CHOICES
from game.table import presets
from game.text import LANGUAGES
from game.ui.pages import settings_view
from game.ui.pages.settings_rows import CHOSEN, ROWS
from tests.support.players import FRAME, FREE, an_app, click, pixels, press, write

# -- words ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_action_and_every_choice_has_its_words(language):
    w = words(language)
    assert [name for name in DEFAULTS if not w.get(f"key.{name}")] == []
    for row in CHOSEN:
        assert w[f"set.{row.name}"]
        if row.kind == "choice":
            assert all(w[f"set.{row.name}.{key}"] for key in row.keys)
    assert {"set.refused." + why for why in ("taken", "types", "fixed", "unknown")} <= w.keys()


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080)])
@pytest.mark.parametrize("table", presets.TABLES)
def test_choices_stay_in_their_rows_and_rows_in_the_sheet(language, size, table):
    sight = an_app(size=size, lang=language, table=table).view.sight
    rect = settings_view.panel(sight.layout)
    boxes = [settings_view.row_rect(i, sight.layout, 0) for i in range(len(ROWS))]
    shown = [box for box in boxes if box]
    assert len(shown) == len(CHOSEN) + settings_view.keys_shown(sight.layout)
    assert all(rect.contains(box) for box in shown)
    hint = rect.bottom - round(settings_view.FOOT * sight.layout.s)
    assert all(box.bottom <= hint for box in shown)
    assert rect.size <= size
    for index, row in enumerate(CHOSEN):
        spots = [cell.rect for cell in settings_view.cells(index, sight)]
        assert all(boxes[index].contains(spot) for spot in spots)
        label = boxes[index].x + sight.type.width(sight.words[f"set.{row.name}"], 13)
        assert all(label < spot.x for spot in spots)
        assert all(a.right <= b.x for a, b in pairwise(spots))


# -- the page ------------------------------------------------------------------------------------


@pytest.fixture
def app():
    """A game whose settings are open."""
    app = an_app()
    press(app, "f3")
    assert app.session.page
    return app


def row(name):
    return next(i for i, r in enumerate(ROWS) if r.name == name)


def to(app, name):
    """Go to a row with the keys."""
    press(app, *["down"] * ((row(name) - app.view.page.focus) % len(ROWS)))


def spot(app, name, key=""):
    sight = app.view.sight
    for cell in settings_view.cells(row(name), sight):
        if cell.key == key:
            return cell.rect.center
    return settings_view.row_rect(row(name), sight.layout, 0).center


def test_time_stands_still_while_settings_are_open():
    app = an_app()
    press(app, "return", "f3")
    time = app.session.world.time
    for _ in range(10):
        app.frame(FRAME)
    assert app.session.world.time == time
    press(app, "escape")
    assert not app.session.page
    app.frame(FRAME)
    assert app.session.world.time > time


OTHER = {
    "language": "ko", "table": "match", "cloth": "new", "law": "thesis", "engine": "thesis",
    "aids": "off", "colours": "safe",
}  # fmt: skip


def what(app, name):
    """What has been chosen, where it counts and where it is kept."""
    now = getattr(app.session, name, None) or getattr(app.preferences.settings, name)
    assert now == getattr(app.preferences.settings, name)
    return now


@pytest.mark.parametrize("name", CHOICES)
def test_the_keys_change_every_choice_at_once_and_back_again(app, name):
    to(app, name)
    before = what(app, name) if name != "law" else "rigid"
    press(app, "right")
    assert what(app, name) != before
    press(app, "left")
    assert what(app, name) == before


@pytest.mark.parametrize("name", OTHER)
def test_the_mouse_changes_every_choice_at_once(app, name):
    click(app, spot(app, name, OTHER[name]))
    assert what(app, name) == OTHER[name]
    assert app.session.page


def test_switches_and_the_volume_by_keys(app):
    to(app, "still")
    press(app, "space")
    assert app.preferences.settings.still
    to(app, "sound")
    press(app, "left")
    assert app.preferences.audio.muted
    to(app, "volume")
    press(app, *["right"] * 5)
    assert app.preferences.settings.volume == 10
    press(app, *["left"] * 12)
    assert app.preferences.audio.volume == 0.0


def test_the_volume_by_dragging_ends_where_the_mouse_does(app):
    track = settings_view.track(row("volume"), app.view.sight)
    click(app, track.midleft, to=(track.right + 300, track.centery + 99))
    assert app.preferences.settings.volume == 10
    click(app, track.midright, to=(track.x - 99, track.y))
    assert app.preferences.settings.volume == 0
    assert app.session.page


def test_a_key_is_given_by_keys(app):
    to(app, "retry")
    press(app, "return", FREE)
    assert app.preferences.settings.keys == {"retry": FREE}
    press(app, "return", "escape")
    assert app.session.page
    press(app, "backspace")
    assert app.preferences.settings.keys == {}


def test_a_key_is_given_by_mouse_and_a_refusal_is_shown(app):
    click(app, spot(app, "retry"))
    before = pixels(app)
    press(app, "p")
    assert app.preferences.refused == ("taken", "retry", "p")
    assert pixels(app) != before
    assert app.preferences.settings.keys == {}


def test_the_sheet_closes_by_its_cross_its_key_and_a_click_beside_it():
    app = an_app()
    ways = (
        lambda: press(app, "f3"),
        lambda: click(app, settings_view.close_rect(app.view.sight.layout).center),
        lambda: click(app, (2, 2)),
    )
    for close in ways:
        press(app, "f3")
        assert app.session.page
        close()
        assert not app.session.page


def test_nothing_that_is_typed_in_the_sheet_gets_into_the_boxes(app):
    texts = app.session.aim.texts[:]
    write(app, "12")
    press(app, "1", "ctrl+return")
    assert app.session.aim.texts == texts
    assert not app.session.moving


def test_the_wheel_scrolls_the_keys_no_further_than_they_go(app, monkeypatch):
    monkeypatch.setattr(settings_view, "keys_shown", lambda layout: 5)
    for turns, first in ((-3, 3), (-99, len(DEFAULTS) - 5), (99, 0)):
        pygame.event.post(pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=turns))
        app.frame(FRAME)
        assert app.view.page.first == first
    press(app, "tab", "up")
    assert app.view.page.focus == len(CHOSEN) - 1
    for name in ("settings", "edit 0", "retry"):
        to(app, name)
        place = row(name) - len(CHOSEN)
        assert app.view.page.first <= place < app.view.page.first + 5


def test_the_sheet_drawn_bit_by_bit_is_the_sheet_drawn_whole(app):
    press(app, "down", "right", "tab", "down", "return", FREE)
    click(app, spot(app, "cloth", "worn"))
    bit_by_bit = pixels(app)
    app.view.expose()
    app.perform(Action("still"))
    app.perform(Action("still"))
    app.frame(FRAME)
    assert pixels(app) == bit_by_bit


def test_the_buttons_on_the_engine_card_open_settings_and_mute():
    app = an_app()
    right, top = app.view.sight.layout.engine.topright
    s = app.view.sight.layout.s
    click(app, (right - 18 * s, top + 17 * s))
    assert app.session.page
    press(app, "escape")
    before = pixels(app)
    click(app, (right - 42 * s, top + 17 * s))
    assert app.preferences.settings.muted
    assert pixels(app) != before
