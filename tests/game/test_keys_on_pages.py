"""Keys that always work do so on every page, and the page of keys lies over all of them."""

import pytest

from game.input.key_tables import ALWAYS, NAMES
from tests.support.players import FRAME, an_app, assert_same_as_anew, press, write

LEADS = {
    NAMES[code]: action.value or action.name
    for code, action in ALWAYS.items()
    if action.name in ("sheet", "settings")
}
OPENS = {page: key for key, page in LEADS.items()}


@pytest.fixture(params=OPENS)
def opened(request):
    app = an_app()
    press(app, OPENS[request.param])
    app.frame(FRAME)
    return app


@pytest.mark.parametrize("key", ["escape", "return", "f1"])
def test_closing_the_page_of_keys_uncovers_the_page_below(opened, key):
    page = opened.session.page
    press(opened, "f1")
    opened.frame(FRAME)
    assert opened.session.help
    press(opened, key)
    opened.frame(FRAME)
    assert not opened.session.help
    assert opened.session.page == page
    assert_same_as_anew(opened)


def test_keys_do_not_reach_a_page_below_the_page_of_keys(opened):
    before = opened.view.page.look(opened.view.sight)
    press(opened, "f1", "down", "right", "tab", "backspace")
    write(opened, "x")
    assert opened.session.help
    assert opened.view.page.look(opened.view.sight) == before


def test_a_text_below_the_page_of_keys_is_not_typed_into():
    app = an_app()
    press(app, "f4", "tab")
    assert app.view.typing
    press(app, "f1")
    assert not app.view.typing
    press(app, "f1")
    assert app.view.typing


@pytest.mark.parametrize("key", sorted(NAMES[code] for code in ALWAYS))
def test_a_key_that_always_works_does_so_on_every_page(opened, key):
    page, language = opened.session.page, opened.session.language
    press(opened, key)
    shown = LEADS.get(key, page)
    assert opened.session.page == ("" if key == OPENS[page] else shown)
    assert opened.session.help == (key == "f1")
    assert (opened.session.language != language) == (key == "f2")
    opened.frame(FRAME)
    assert_same_as_anew(opened)


def test_a_key_that_always_works_is_taken_by_the_setting_that_waits_for_one():
    app = an_app()
    press(app, "f3", "tab", "return")
    assert app.view.page.waiting
    press(app, "f4")
    assert app.session.page == "settings"
    assert not app.view.page.waiting
