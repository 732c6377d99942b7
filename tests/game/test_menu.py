"""The menu, where a match is put together, and the pages that it leads to."""

import pytest

from game.input.captions import words
from game.session.terms import GAMES
from game.table import lineup
from game.ui.pages import menu_tiles, menu_view, page_parts, shelf_view
from game.ui.pages.rules_page import RULES
from tests.support.matches import choose, menu_button
from tests.support.players import FRAME, an_app, assert_same_as_anew, click, places, press, write


def test_the_game_starts_at_a_table_and_not_in_a_menu():
    app = an_app()
    assert app.session.page == ""
    assert app.session.contest is None
    press(app, "return")
    assert app.session.moving


@pytest.mark.parametrize("key", ["f10", "escape"])
def test_the_menu_opens_and_closes_with_a_key_and_holds_the_balls(key):
    app = an_app()
    press(app, "return", key)
    held = places(app.session)
    app.frame(FRAME)
    assert app.session.page == "menu"
    assert places(app.session) == held
    press(app, "escape")
    assert app.session.page == ""
    app.frame(FRAME)
    assert places(app.session) != held


def test_a_match_is_put_together_by_keys_alone():
    app = an_app()
    press(app, "f10", "right", "right")
    assert app.view.page.terms.game == "three-cushion"
    assert app.view.page.terms.table == "match"
    press(app, "left")
    rows = [row.name for row in app.view.page.rows]
    press(app, *["down"] * rows.index("name"))
    write(app, "김 사구")
    press(app, "return", "return", "2", "5")
    press(app, "down", "down", "right", "right")
    press(app, *["down"] * (len(rows) - app.view.page.focus))
    press(app, "return")
    match = app.session.contest.match
    assert (match.players[0].name, match.players[0].target) == ("김 사구", 25)
    assert app.session.contest.terms.seats[1].level == "club"
    assert app.session.page == ""
    assert len(app.session.world.balls) == 4


def test_a_match_is_put_together_by_the_mouse_alone():
    app = an_app(size=(1280, 720))
    click(app, app.view.sight.layout.engine.move(-64, -11).midright)
    assert app.session.page == "menu"
    choose(app, "game", 1, GAMES.index("three-cushion"))
    assert app.view.page.terms.game == "three-cushion"
    choose(app, "bank")
    choose(app, "target", 1, 3)
    click(app, menu_button(app, "start"))
    assert app.session.contest.match.rules.bank == 2
    assert app.session.contest.match.players[0].target == 13
    assert app.session.table == "match"


def test_the_menu_gives_back_what_is_being_played():
    app = an_app(game="four-ball", players="Ann,Bo", handicap="7,9", level="human,expert")
    press(app, "f10")
    assert app.view.page.terms == app.session.contest.terms


def test_names_and_numbers_stay_within_what_a_match_takes():
    app = an_app(game="four-ball")
    press(app, "f10")
    rows = [row.name for row in app.view.page.rows]
    press(app, *["down"] * rows.index("name"))
    write(app, "x" * 40)
    press(app, "down", "down", "9", "9", "9", "9")
    seat = app.view.page.terms.seats[0]
    assert (len(seat.name), seat.target) == (16, 200)
    press(app, *["backspace"] * 5)
    assert app.view.page.terms.seats[0].target == 1


def test_closing_and_clicking_outside_change_nothing():
    app = an_app(game="four-ball")
    before = app.session.contest
    for at in ((3, 3), page_parts.close_rect(app.view.sight.layout).center):
        press(app, "f10", "right")
        click(app, at)
        assert app.session.page == ""
        assert app.session.contest is before


@pytest.mark.parametrize("lang", ["en", "ko"])
@pytest.mark.parametrize("size", [(640, 360), (960, 540), (1280, 720)])
def test_every_page_is_the_same_drawn_in_part_and_anew(lang, size):
    app = an_app(size=size, lang=lang, game="four-ball", level="club")
    for key in ("f10", "f4", "f5"):
        press(app, key)
        for more in ("down", "right", "tab", "tab", "tab"):
            press(app, more)
            assert_same_as_anew(app)
        click(app, (size[0] // 2, size[1] // 2))
        if app.session.page:
            assert_same_as_anew(app)
            press(app, "escape")
        assert_same_as_anew(app)


@pytest.mark.parametrize("lang", ["en", "ko"])
@pytest.mark.parametrize("width", [960, 1280, 1920])
def test_every_word_of_the_pages_fits_into_its_place(lang, width):
    app = an_app(size=(width, width * 9 // 16), lang=lang)
    w, sight = words(lang), app.view.sight
    s, type_ = sight.layout.s, sight.type
    room = page_parts.inside(sight.layout).w
    for rect, name in zip(menu_view.button_rects(sight.layout), menu_view.BUTTONS, strict=True):
        assert type_.width(w[f"menu.{name}"], 15) <= rect.w - 8 * s
    for key in (k for k in w if k.startswith("row.")):
        assert type_.width(w[key], 13) <= menu_view.LABEL * s - 8, w[key]
    for rect, name in zip(shelf_view.button_rects(sight.layout), shelf_view.BUTTONS, strict=True):
        assert type_.width(w[f"shelf.{name}"], 15) <= rect.w - 8 * s
    card = shelf_view.card_rect(0, sight.layout).w - 12 * s
    for ready in lineup.shelf():
        assert type_.width(w[f"position.{ready.key}"], 13) <= card
    assert type_.width(w["shelf.hint"], 13) <= room
    box = (room - sight.layout.px(32)) / 2 - (menu_view.LABEL + 2 * menu_view.ARROW + 8) * s
    for key in (k for k in w if k.startswith(("level.", "finish.", "cloth.", "table.", "game."))):
        if key != "level.error":
            assert type_.width(w[key], 15) <= box, w[key]
    for game, count in RULES.items():
        texts = [w[f"rule.{game}.{n}"] for n in range(1, count + 1)]
        lines = [list(page_parts.wrapped(text, type_, 15, room - 24 * s)) for text in texts]
        height = (34 + 36 + sum(25 * len(one) + 9 for one in lines)) * s
        assert height <= page_parts.inside(sight.layout).h


@pytest.mark.parametrize("lang", ["en", "ko"])
@pytest.mark.parametrize("width", [960, 1280])
def test_every_verdict_fits_into_the_result_card(lang, width):
    app = an_app(size=(width, width * 9 // 16), lang=lang, game="three-cushion")
    layout, type_, w = app.view.sight.layout, app.view.sight.type, words(lang)
    room = layout.result.w - 12 * layout.s - 58 * layout.s
    for key in (k for k in w if k.startswith("reason.")):
        assert type_.width(w[key].format(n=12), 15) <= room, w[key]


def test_the_families_of_games_are_chosen_by_keys_and_by_the_mouse():
    app = an_app(size=(1280, 720))
    press(app, "f10", "up")
    page = app.view.page
    seen = [page.terms.game]
    for _ in menu_tiles.FAMILIES:
        press(app, "right")
        seen.append(page.terms.game)
    assert seen == ["free", "four-ball", "8-ball", "snooker", "free-pyramid", "free"]
    press(app, "left", "return")
    assert (page.terms.game, page.terms.table) == ("free-pyramid", "pyramid")
    assert page.row.name == "game"
    click(app, menu_tiles.rects(app.view.sight.layout)["pool"].center)
    assert (page.terms.game, page.terms.table) == ("8-ball", "pool-9")
    press(app, "down", "right")
    click(app, menu_tiles.rects(app.view.sight.layout)["pool"].center)
    assert page.terms.game == "9-ball"  # it belongs there already
    assert_same_as_anew(app)


def test_every_game_has_a_family_and_no_two():
    assert sorted(sum(menu_tiles.FAMILIES.values(), ())) == sorted(GAMES)
