"""A table of the player's own: from tracks to a key that carries its coefficients everywhere."""

from dataclasses import replace

import pygame
import pytest

from game.app import App
from game.computer.worker import News
from game.options import Options
from game.replay import game_record
from game.replay.recorder import Recorder
from game.replay.replay import headless
from game.session import terms
from game.session.action import Action
from game.session.commands import fault, perform
from game.session.session import Session
from game.settings import settings
from game.settings.own_table_file import OwnTableFile, read
from game.table import lineup, own_table, presets, table_fit
from game.table.table_fit import FitReport, FitRow, fitted
from game.text import LANGUAGES
from game.ui.pages import menu_rows, menu_view
from physics import tables
from tests.support.players import an_app, press, write

MATCH = presets.TABLES["match"]
FOUND = {"cloth.slide": 0.19, "cushion.e": 0.85}
MINE = own_table.key_of(own_table.with_numbers(MATCH, FOUND), presets.TABLES)
REPORT = FitReport(MINE, 4, 0.5, (FitRow("cloth.slide", 0.212, 0.19, 0.001),),
                   (("cushion.mu", "the tracks do not show 'cushion.mu'"),))  # fmt: skip


class Instant:
    """A worker that is done at once, with the report."""

    def __init__(self, work, *given):
        assert work is fitted
        self.given, self.ended = given, False

    def look(self):
        return News("done", REPORT)

    def cancel(self):
        self.ended = True


@pytest.mark.parametrize("name", presets.TABLES)
def test_a_table_comes_back_from_its_key_to_the_last_bit(name):
    key = own_table.key_of(presets.TABLES[name], presets.TABLES)
    assert own_table.base(key) == name
    assert key in presets.TABLES
    assert presets.TABLES[key] == presets.TABLES[name]
    assert key not in list(presets.TABLES)


@pytest.mark.parametrize(
    ("key", "said"),
    [
        ("nowhere+cloth.slide=1", "nowhere"),
        ("match+", "no coefficient"),
        (MINE.replace("0.19", "fast"), "cloth.slide=fast"),
        (MINE.replace("0.19", "inf"), "cloth.slide must be finite"),
        (MINE.replace("0.19", "-1"), "-1"),
        (MINE.replace("cloth.slide=0.19,", ""), "cloth.slide is missing"),
        (MINE + ",cloth.colour=1", "cloth.colour"),
    ],
)
def test_a_key_that_is_none_says_what_is_wrong(key, said):
    assert key not in presets.TABLES
    with pytest.raises(KeyError, match=said.replace(".", r"\.")):
        presets.TABLES[key]
    assert fault(Action("table", key))


def test_a_table_of_another_size_is_refused_by_its_size():
    with pytest.raises(ValueError, match=r"2.5 × 1.42 m"):
        own_table.key_of(replace(MATCH, length=2.5), presets.TABLES)


def test_a_set_up_on_it_is_one_line_that_comes_back():
    world = presets.table_world(MINE)
    assert [ball.name for ball in world.balls] == ["white", "yellow", "red"]
    found = lineup.read(lineup.of(world, MINE).line())
    assert found.table == MINE
    assert found.world().cloth.slide == 0.19


def test_a_record_on_it_replays_where_nobody_has_its_file(tmp_path):
    path = str(tmp_path / "record.jsonl")
    session = Session(presets.table_world("medium"))
    recorder = Recorder(path, Options(), session)
    for action in (Action("table", MINE), Action("shoot"), Action("skip")):
        recorder.before(action)
        perform(session, action)
        recorder.after()
        recorder.passed()
    recorder.close()
    record = game_record.read(path, Options())
    replay = headless(record, Session(presets.table_world("medium")))
    assert replay.verdict().startswith("the same, shots: 1")
    assert replay.session.world.cushion_law.e == 0.85


def test_a_game_that_begins_on_it_has_it_in_the_head_of_its_record(tmp_path):
    path = str(tmp_path / "record.jsonl")
    options = replace(Options(), table=MINE)
    session = Session(presets.table_world(MINE), table=MINE)
    recorder = Recorder(path, options, session)
    recorder.before(Action("undo"))
    recorder.close()
    assert game_record.read(path, Options()).setup.table == MINE


def test_a_match_is_played_on_it_and_the_menu_offers_it():
    wanted = terms.Terms("three-cushion", table=MINE)
    assert terms.read(wanted.line()).world().cloth.slide == 0.19
    with pytest.raises(ValueError, match="table must be"):
        terms.Terms("8-ball", table=MINE)
    at = replace(wanted, table="match")
    assert menu_rows.stepped(at, menu_rows.MenuRow("table"), 1, MINE).table == MINE
    assert menu_rows.stepped(wanted, menu_rows.MenuRow("table"), 1).table == "thesis"
    words = LANGUAGES["en"]
    assert menu_view.value_word(menu_rows.MenuRow("table"), wanted, words) == "My table"


def test_settings_remember_it_and_pass_over_a_broken_one():
    def kept(table):
        return settings.read({"format": settings.FORMAT, "version": 1, "table": table})

    assert kept(MINE)[0].table == MINE
    broken, bad = kept(MINE + "x")
    assert (broken.table, bad) == ("medium", ["table"])


def test_what_the_tracks_do_not_show_is_left_as_it_was_and_said(monkeypatch, tmp_path):
    class Fit:
        strokes, misfit, errors = (1, 2), 5e-4, (0.01, 0.02, 0.03)

        def __init__(self, names):
            self.names, self.values = names, [0.2] * len(names)

    def fit(world, seen, unknown):
        if "cloth.roll" in unknown:
            raise ValueError("the tracks do not show 'cloth.roll': that takes a ball that rolls")
        return Fit(tuple(unknown))

    monkeypatch.setattr(table_fit, "fit", fit)
    path, told = tmp_path / "tracks.csv", []
    path.write_text("time,white x,white y\n0,0,0\n0.02,0.1,0\n")
    report = fitted(told.append, str(path), "match")
    assert [row.name for row in report.rows] == ["cloth.slide", "cushion.e", "cushion.mu"]
    assert report.unseen[0][0] == "cloth.roll"
    assert presets.TABLES[report.key].cloth.roll == MATCH.cloth.roll
    assert presets.TABLES[report.key].cloth.slide == 0.2
    assert [len(names) for _, names in told] == [4, 3]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (None, "there is no such file"),
        ("", "no columns such as"),
        ("time,white x,white y\n0,0,0\n0.02,zero,0\n", "line 3: 'zero' is no number"),
        ("time,white x,white y\n0,0,0\n0,0,0\n", "must be finite and grow"),
    ],
)
def test_a_file_that_is_no_tracks_says_what_is_wrong_and_where(tmp_path, text, said):
    path = tmp_path / "tracks.csv"
    if text is not None:
        path.write_text(text)
    with pytest.raises(ValueError, match=said):
        fitted(lambda value: None, str(path), "match")


# -- the page ------------------------------------------------------------------------------------


@pytest.fixture
def app(tmp_path, monkeypatch) -> App:
    monkeypatch.setattr("game.ui.pages.tracks_page.Worker", Instant)
    (tmp_path / "tracks").mkdir()
    (tmp_path / "tracks" / "monday.csv").write_text("")
    app = an_app()
    app.view.tracks.file = OwnTableFile(tmp_path)
    return app


def test_tracks_become_a_table_that_is_saved_and_played_on(app, tmp_path):
    press(app, "f9", "down", "return")
    page = app.view.tracks
    assert page.field.text.endswith("monday.csv")
    app.frame(0)
    assert (page.said, page.report) == ("tracks.fitted", REPORT)
    press(app, "return")
    assert page.said == "tracks.saved"
    assert tables.load(tmp_path / "my-table.json").name == "my table"
    assert OwnTableFile(tmp_path).key == MINE
    press(app, "return")
    assert (app.session.table, app.session.page) == (MINE, "")
    assert app.session.world.cloth.slide == 0.19
    assert app.preferences.settings.table == MINE


def test_another_path_forgets_what_was_found_for_the_last_one(app):
    press(app, "f9", "down", "return")
    app.frame(0)
    write(app, "/somewhere/else.csv")
    assert app.view.tracks.report is None
    assert app.view.tracks.primary == "fit"


def test_a_preset_of_the_command_line_is_read_as_it_is(app, tmp_path):
    preset = tmp_path / "preset.json"
    tables.save(presets.TABLES[MINE], preset)
    press(app, "f9")
    write(app, str(preset))
    press(app, "return", "return")
    assert OwnTableFile(tmp_path).key == MINE


def test_escape_stops_a_fit_and_the_next_one_closes_the_page(app, monkeypatch):
    monkeypatch.setattr(Instant, "look", lambda self: None)
    press(app, "f9", "down", "return")
    worker = app.view.tracks._worker
    press(app, "escape")
    assert worker.ended
    assert app.view.tracks.said == "tracks.stopped"
    press(app, "escape")
    assert app.session.page == ""


def test_a_broken_saved_table_is_said_to_be_and_kept_beside(app, tmp_path):
    own = tmp_path / "my-table.json"
    own.write_text('{"radius": ')
    page = app.view.tracks
    press(app, "f9")
    assert page.said == "tracks.broken"
    assert "my-table.json" in page.trouble
    press(app, "down", "return")
    app.frame(0)
    press(app, "return")
    assert page.said == "tracks.saved"
    assert (tmp_path / "my-table.json.broken").read_text() == '{"radius": '
    assert read(own) == MINE


def test_a_fit_that_fails_says_why(app, monkeypatch):
    why = "tracks.csv: line 3: 'zero' is no number"
    monkeypatch.setattr(Instant, "look", lambda self: News("failed", why))
    press(app, "f9", "down", "return")
    app.frame(0)
    assert (app.view.tracks.said, app.view.tracks.trouble) == ("tracks.failed", why)
    assert not app.view.tracks.running


@pytest.mark.parametrize("language", ["en", "ko"])
def test_the_page_is_drawn_in_every_state(app, language, monkeypatch):
    app.perform(Action("language", language))
    monkeypatch.setattr(Instant, "look", lambda self: News("told", (4, ("cloth.slide",))))
    press(app, "f9", "down", "return")
    app.render()
    monkeypatch.undo()
    app.view.tracks._worker = None
    app.view.tracks.trouble = "x" * 500 + " " + "word " * 100
    app.redraw()
    app.render()
    app.handle(pygame.event.Event(pygame.MOUSEMOTION, pos=(400, 300), buttons=(0, 0, 0)))
