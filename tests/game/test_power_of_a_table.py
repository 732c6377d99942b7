"""How hard a ball can be struck by hand depends on the table: pool is broken harder than carom."""

import pytest

from game.aim.edit import STRONGEST, share, speed_at, strongest
from game.session.action import Action
from game.table import presets
from game.ui.pages.settings_rows import FREE_TABLES
from tests.support.players import an_app, click, press


@pytest.mark.parametrize("table", presets.TABLES)
def test_bar_and_keys_reach_a_hard_break_on_tables_where_it_is_needed(table):
    app = an_app(size=(1280, 720), table=table)
    most = strongest(app.session.world)
    assert most == (13.0 if table.startswith(("pool", "pyramid")) else STRONGEST)
    press(app, *["pageup"] * 28)
    assert app.session.aim.number("speed") == most
    app.perform(Action("power", "2"))
    bar = app.view.sight.layout.power
    click(app, (bar.centerx, bar.bottom - 30), (bar.right + 200, bar.bottom - 30))
    assert app.session.aim.number("speed") == most


@pytest.mark.parametrize("most", [8.0, 13.0])
def test_the_bar_gives_back_the_speed_that_it_shows(most):
    for speed in (0.1, 1.0, 7.3, most):
        assert speed_at(share(speed, most), most) == pytest.approx(speed, rel=1e-9)


def test_every_table_is_offered_by_the_settings():
    assert (*presets.TABLES,) == FREE_TABLES
