"""Settings: a file that may be broken, keys to choose, and the sheet in which it is all done."""

import json
import os
from dataclasses import asdict, fields
from itertools import pairwise

import pygame
import pytest
from players import FRAME, an_app, click, pixels, press, write

from game import __main__ as entry
from game import keys, options, settings, setup
from game.actions import Action
from game.app import App
from game.keys import DEFAULTS, Keys
from game.play import Notice
from game.settings import CHOICES, FORMAT, VERSION, Settings, Store
from game.text import LANGUAGES, words
from game.ui import sheetview
from game.ui.choices import CHOSEN, ROWS

LETTERS = [chr(c) for c in range(ord("a"), ord("z") + 1)]
FREE, SPARE = [c for c in LETTERS if c not in {b.key for b in DEFAULTS.values()}][:2]
"""Keys that nothing has by default."""
SWITCHES = [f.name for f in fields(Settings) if f.default is False]
CHOSEN_ONES = Settings(
    language="ko", table="match", cloth="humid", law="thesis", engine="thesis", aids="short",
    colours="safe", volume=3, keys={"pause": FREE}, size=(1000, 600),
    **dict.fromkeys(SWITCHES, True),
)  # fmt: skip


@pytest.fixture(autouse=True)
def folders(tmp_path, monkeypatch):
    """A home of our own, whose language is English."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("LC_ALL", "C")


@pytest.fixture
def path(tmp_path):
    return tmp_path / "settings.json"


def document(**changes):
    return {
        "format": FORMAT,
        "version": VERSION,
        **asdict(CHOSEN_ONES),
        "size": [1000, 600],
    } | changes


def written(path, content):
    path.write_text(json.dumps(content), encoding="utf-8")
    return Store(path)


# -- the file ------------------------------------------------------------------------------------


def test_what_is_saved_is_what_is_loaded(path):
    assert Store(path).save(CHOSEN_ONES)
    store = Store(path)
    assert store.load() == CHOSEN_ONES
    assert store.faults == []
    assert list(path.parent.iterdir()) == [path]


def test_without_a_file_everything_is_as_usual_and_no_file_appears(path):
    store = Store(path)
    assert store.load() == Settings()
    assert store.faults == []
    assert not path.exists()


def test_somebody_whose_system_is_korean_begins_in_korean(monkeypatch):
    monkeypatch.setenv("LC_ALL", "ko_KR.UTF-8")
    assert settings.start().language == "ko"


BAD = [
    ("language", "fr"), ("table", 7), ("cloth", None), ("law", ["rigid"]), ("engine", "Exact"),
    ("aids", ""), ("colours", {}), ("volume", 11), ("volume", -1), ("volume", True),
    ("volume", 3.5), ("muted", 1), ("still", "yes"), ("fan", 0), ("keys", []), ("size", [1280]),
    ("size", [0, 720]), ("size", ["1280", "720"]), ("size", 1280), ("size", [1e9, 720]),
]  # fmt: skip


@pytest.mark.parametrize(("name", "value"), BAD)
def test_a_bad_value_falls_back_alone_and_the_file_is_kept_beside(path, name, value):
    store = written(path, document(**{name: value}))
    before = path.read_bytes()
    loaded = store.load()
    usual = Settings()
    for field in fields(Settings):
        wanted = usual if field.name == name else CHOSEN_ONES
        assert getattr(loaded, field.name) == getattr(wanted, field.name)
    assert store.faults == [name]
    assert path.with_name("settings.json.broken").read_bytes() == before
    mended = Store(path)
    assert mended.load() == loaded
    assert mended.faults == []


NO_SETTINGS = [b"", b"{", b"[]", b"null", b"\xff\xfe\x00", b"[" * 99999, b'{"language": "ko"}']


@pytest.mark.parametrize("content", NO_SETTINGS)
def test_a_file_that_is_none_is_kept_beside_and_replaced(path, content):
    path.write_bytes(content)
    store = Store(path)
    assert store.load() == Settings()
    assert store.faults == ["format"]
    assert path.with_name("settings.json.broken").read_bytes() == content
    assert Store(path).load() == Settings()


def test_settings_of_a_later_version_are_read_as_far_as_they_are_understood(path):
    store = written(path, document(version=VERSION + 1, weather="fine"))
    assert store.load() == CHOSEN_ONES
    assert store.faults == ["version"]


def test_a_folder_in_place_of_the_file_is_left_alone(path):
    path.mkdir()
    store = Store(path)
    assert store.load() == Settings()
    assert not store.save(Settings(volume=1))
    assert path.is_dir()


def test_saving_that_fails_half_way_leaves_the_old_file_and_nothing_else(path, monkeypatch):
    store = Store(path)
    store.save(CHOSEN_ONES)

    def fails(source, target):
        raise OSError("the disk is full")

    monkeypatch.setattr(os, "replace", fails)
    assert not store.save(Settings())
    assert Store(path).load() == CHOSEN_ONES
    assert list(path.parent.iterdir()) == [path]


def test_nothing_is_written_when_nothing_has_changed(path):
    store = Store(path)
    store.save(CHOSEN_ONES)
    path.unlink()
    assert store.save(CHOSEN_ONES)
    assert not path.exists()


# -- the command line ----------------------------------------------------------------------------


def test_settings_fill_in_what_the_command_line_leaves_open():
    said = options.read(["--lang", "en", "--size", "640x360"])
    merged = CHOSEN_ONES.applied(said)
    assert (merged.lang, merged.size) == ("en", (640, 360))
    assert (merged.table, merged.cloth, merged.law, merged.engine) == (
        "match", "humid", "thesis", "thesis",
    )  # fmt: skip


def test_cloth_and_laws_of_another_table_are_not_those_that_were_chosen():
    merged = CHOSEN_ONES.applied(options.read(["--table", "thesis"]))
    assert (merged.table, merged.cloth, merged.law) == ("thesis", "table", None)


def played(tmp_path, lines, *more):
    script = tmp_path / "script.txt"
    script.write_text(lines, encoding="utf-8")
    said = ["--script", str(script), "--frames", "40", "--size", "640x360", *more]
    assert entry.main(said) == 0


def test_what_the_command_line_says_is_not_saved_and_what_the_player_does_is(tmp_path, path):
    written(path, document(keys={})).load()
    played(tmp_path, "0.1 key m\n", "--settings", str(path), "--lang", "en", "--table", "thesis")
    loaded = Store(path).load()
    assert (loaded.language, loaded.table, loaded.law) == ("ko", "match", "thesis")
    assert not loaded.muted
    played(tmp_path, "0.1 key f2\n0.2 key e\n", "--settings", str(path), "--lang", "ko")
    loaded = Store(path).load()
    assert (loaded.language, loaded.engine, loaded.table) == ("en", "exact", "match")


def test_runs_that_nobody_watches_neither_read_nor_write(tmp_path):
    home = settings.folder()
    assert home == tmp_path / "config" / "danggu"
    played(tmp_path, "0.1 key f2\n0.2 key m\n")
    assert not home.exists()
    home.mkdir(parents=True)
    (home / "settings.json").write_text("broken")
    played(tmp_path, "0.1 key f2\n")
    assert [p.name for p in home.iterdir()] == ["settings.json"]


def test_that_the_file_was_broken_is_said_once(path, monkeypatch):
    said = []
    path.write_text("broken")
    monkeypatch.setattr(App, "run", lambda app: said.append(app.game.notice))
    for _ in range(2):
        assert entry.main(["--settings", str(path), "--frames", "1"]) == 0
    assert said == [Notice("settings.broken"), None]


# -- keys ----------------------------------------------------------------------------------------


def test_no_two_actions_have_the_same_key_and_none_types_into_boxes_from_play():
    names = [binding.key for binding in DEFAULTS.values()]
    assert len(set(names)) == len(names)
    assert not [name for name, b in DEFAULTS.items() if keys.refused(name, b.key)]


@pytest.mark.parametrize(
    ("key", "why"),
    [("r", "taken"), ("3", "types"), ("minus", "types"), ("kp_plus", "types"), ("kp5", "types"),
     ("return", "fixed"), ("tab", "fixed"), ("lshift", "fixed"), ("moon", "unknown")],
)  # fmt: skip
def test_a_key_that_cannot_be_had_says_why(key, why):
    with pytest.raises(ValueError, match=why):
        Keys().with_key("pause", key)


def test_letters_that_type_are_free_in_play_but_not_for_keys_that_work_in_boxes():
    assert Keys({"engine": FREE}).with_key("pause", "e").names["pause"] == "e"
    with pytest.raises(ValueError, match="types"):
        Keys({"engine": FREE}).with_key("help", "e")


def test_keys_in_a_file_may_be_swapped_but_not_doubled():
    swapped = {"pause": "space", "stop": "p"}
    assert keys.sound(swapped) == (swapped, [])
    assert keys.sound({"pause": "r"}) == ({}, ["pause"])
    good, bad = keys.sound({"pause": FREE, "stop": FREE})
    assert len(good) == len(bad) == 1
    assert keys.sound({"pause": "3", "dance": FREE, "stop": 5, "retry": SPARE}) == (
        {"retry": SPARE},
        ["pause", "dance", "stop"],
    )


def test_bad_keys_in_the_file_are_named(path):
    store = written(path, document(keys={"pause": "3", "retry": FREE}))
    assert store.load().keys == {"retry": FREE}
    assert store.faults == ["keys.pause"]


def test_a_changed_key_does_what_the_old_one_did():
    app = an_app()
    app.perform(Action("bind", f"pause {FREE}"))
    press(app, "p")
    assert not app.game.paused
    press(app, FREE)
    assert app.game.paused
    app.perform(Action("unbind", "pause"))
    press(app, FREE)
    assert app.game.paused
    press(app, "p")
    assert not app.game.paused


def test_a_key_that_has_been_taken_meanwhile_cannot_come_back():
    app = an_app()
    app.perform(Action("bind", f"pause {FREE}"))
    app.perform(Action("bind", "stop p"))
    app.perform(Action("unbind", "pause"))
    assert app.preferences.keys.names["pause"] == FREE
    assert app.preferences.refused == ("taken", "pause", "p")


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
@pytest.mark.parametrize("size", [(640, 360), (960, 540), (1280, 720), (1920, 1080)])
@pytest.mark.parametrize("table", setup.TABLES)
def test_choices_stay_in_their_rows_and_rows_in_the_sheet(language, size, table):
    sight = an_app(size=size, lang=language, table=table).view.sight
    rect = sheetview.panel(sight.layout)
    boxes = [sheetview.row_rect(i, sight.layout, 0) for i in range(len(ROWS))]
    shown = [box for box in boxes if box]
    assert len(shown) == len(CHOSEN) + sheetview.keys_shown(sight.layout)
    assert all(rect.contains(box) for box in shown)
    assert rect.size <= size
    for index, row in enumerate(CHOSEN):
        spots = [cell.rect for cell in sheetview.cells(index, sight)]
        assert all(boxes[index].contains(spot) for spot in spots)
        label = boxes[index].x + sight.type.width(sight.words[f"set.{row.name}"], 13)
        assert all(label < spot.x for spot in spots)
        assert all(a.right <= b.x for a, b in pairwise(spots))


# -- the sheet -----------------------------------------------------------------------------------


@pytest.fixture
def app():
    """A game whose settings are open."""
    app = an_app()
    press(app, "f3")
    assert app.game.sheet
    return app


def row(name):
    return next(i for i, r in enumerate(ROWS) if r.name == name)


def to(app, name):
    """Go to a row with the keys."""
    press(app, *["down"] * ((row(name) - app.view.sheet.focus) % len(ROWS)))


def spot(app, name, key=""):
    sight = app.view.sight
    for cell in sheetview.cells(row(name), sight):
        if cell.key == key:
            return cell.rect.center
    return sheetview.row_rect(row(name), sight.layout, 0).center


def test_time_stands_still_while_settings_are_open():
    app = an_app()
    press(app, "return", "f3")
    time = app.game.world.time
    for _ in range(10):
        app.frame(FRAME)
    assert app.game.world.time == time
    press(app, "escape")
    assert not app.game.sheet
    app.frame(FRAME)
    assert app.game.world.time > time


OTHER = {
    "language": "ko", "table": "match", "cloth": "new", "law": "thesis", "engine": "thesis",
    "aids": "off", "colours": "safe",
}  # fmt: skip


def what(app, name):
    """What has been chosen, where it counts and where it is kept."""
    now = getattr(app.game, name, None) or getattr(app.preferences.settings, name)
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
    assert app.game.sheet


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
    track = sheetview.track(row("volume"), app.view.sight)
    click(app, track.midleft, to=(track.right + 300, track.centery + 99))
    assert app.preferences.settings.volume == 10
    click(app, track.midright, to=(track.x - 99, track.y))
    assert app.preferences.settings.volume == 0
    assert app.game.sheet


def test_a_key_is_given_by_keys(app):
    to(app, "retry")
    press(app, "return", FREE)
    assert app.preferences.settings.keys == {"retry": FREE}
    press(app, "return", "escape")
    assert app.game.sheet
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
        lambda: click(app, sheetview.close_rect(app.view.sight.layout).center),
        lambda: click(app, (2, 2)),
    )
    for close in ways:
        press(app, "f3")
        assert app.game.sheet
        close()
        assert not app.game.sheet


def test_nothing_that_is_typed_in_the_sheet_gets_into_the_boxes(app):
    texts = app.game.aim.texts[:]
    write(app, "12")
    press(app, "1", "ctrl+return")
    assert app.game.aim.texts == texts
    assert not app.game.moving


def test_the_wheel_scrolls_the_keys_no_further_than_they_go(app, monkeypatch):
    monkeypatch.setattr(sheetview, "keys_shown", lambda layout: 5)
    for turns, first in ((-3, 3), (-99, len(DEFAULTS) - 5), (99, 0)):
        pygame.event.post(pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=turns))
        app.frame(FRAME)
        assert app.view.sheet.first == first
    press(app, "tab", "up")
    assert app.view.sheet.focus == len(CHOSEN) - 1
    for name in ("settings", "edit 0", "retry"):
        to(app, name)
        place = row(name) - len(CHOSEN)
        assert app.view.sheet.first <= place < app.view.sheet.first + 5


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
    assert app.game.sheet
    press(app, "escape")
    before = pixels(app)
    click(app, (right - 42 * s, top + 17 * s))
    assert app.preferences.settings.muted
    assert pixels(app) != before


# -- what is seen of it --------------------------------------------------------------------------


def test_aids_take_lines_away_level_by_level():
    pictures = []
    for level in ("full", "short", "off"):
        app = an_app()
        app.perform(Action("aids", level))
        app.frame(FRAME)
        pictures.append(pixels(app))
    full, short, off = pictures

    def changed(a, b):
        return sum(p != q for p, q in zip(a, b, strict=True))

    assert changed(off, short) > 0
    assert changed(off, full) > changed(off, short)


def test_the_key_for_aids_goes_round_its_levels():
    app = an_app()
    levels = []
    for _ in range(4):
        levels.append(app.preferences.settings.aids)
        press(app, "a")
    assert levels == ["full", "off", "short", "full"]


def test_safe_colours_show_at_once_and_on_every_ball():
    app = an_app()
    before = [look.body for look in app.view.stage.looks]
    app.perform(Action("colours", "safe"))
    app.frame(FRAME)
    after = [look.body for look in app.view.stage.looks]
    assert all(a != b for a, b in zip(before, after, strict=True))


def test_another_table_is_laid_with_its_own_cloth_and_laws():
    app = an_app()
    app.perform(Action("cloth", "new"))
    app.perform(Action("law", "mathavan"))
    app.perform(Action("engine", "thesis"))
    app.perform(Action("table", "match"))
    app.frame(FRAME)
    assert [ball.name for ball in app.game.world.balls] == ["white", "yellow", "red"]
    assert (app.game.cloth, app.game.law, app.game.engine) == ("table", "rigid", "thesis")
    assert app.game.world.engine == setup.ENGINES["thesis"]()
    assert app.preferences.settings.law == "table"
    assert app.view.sight.layout.length == setup.TABLES["match"].length


def test_a_cloth_is_the_one_that_was_chosen_and_the_tables_own_comes_back():
    app = an_app()
    own = app.game.world.cloth
    app.perform(Action("cloth", "humid"))
    assert app.game.world.cloth.slide == 0.4
    app.perform(Action("cloth", "table"))
    assert app.game.world.cloth == own
