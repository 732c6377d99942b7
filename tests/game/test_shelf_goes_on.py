"""The shelf opens on every table and in every group, and one bad set-up ends nothing."""

import pytest

from game.session.action import Action
from game.session.session import Session
from game.table import lineup, presets
from game.ui.pages import shelf_view
from tests.support.players import FRAME, an_app, places, press


def fails(*_):
    raise RuntimeError("no such world")


@pytest.mark.parametrize("table", presets.TABLES)
def test_the_shelf_shows_every_group_on_every_table(table):
    app = an_app(table=table)
    press(app, "f4")
    for _ in shelf_view.GROUPS:
        press(app, "pagedown")
        assert app.session.page == "shelf"
        assert app.view.page.cards or shelf_view.GROUPS[app.view.page.group] == "own"


@pytest.mark.parametrize("maker", ["_of_position", "_of_rack", "_of_drill", "_of_scene"])
def test_a_set_up_that_cannot_be_made_is_left_out_and_the_others_are_there(monkeypatch, maker):
    whole = len(list(lineup.shelf()))
    monkeypatch.setattr(lineup, maker, fails)
    with pytest.warns(RuntimeWarning, match="is left out: RuntimeError"):
        assert 0 < len(list(lineup.shelf())) < whole


def test_a_miniature_that_cannot_be_drawn_leaves_its_card_empty(monkeypatch):
    app = an_app()
    shelf_view.thumbnail.cache_clear()
    monkeypatch.setattr(shelf_view, "_miniature", fails)
    with pytest.warns(RuntimeWarning, match="no picture of set-up 'medium'"):
        press(app, "f4")
    assert app.session.page == "shelf"
    shelf_view.thumbnail.cache_clear()


def test_a_set_up_that_cannot_be_laid_is_refused_and_the_balls_stay(monkeypatch):
    app = an_app()
    before = places(app.session)
    session: Session = app.session
    monkeypatch.setattr(presets, "scene_world", fails)
    with pytest.warns(RuntimeWarning, match="cannot be laid"):
        app.perform(Action("scene", "single"))
    app.frame(FRAME)
    assert session.notice.key == "refused.unmade"
    assert (session.table, places(session)) == ("medium", before)
