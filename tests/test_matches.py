"""Matches in the window: by keyboard alone, by mouse alone, and against the computer."""

import random
from itertools import product
from math import cos, radians, sin

import pygame
import pytest
from players import (
    FRAME,
    an_app,
    assert_same_as_anew,
    click,
    enter,
    places,
    press,
    run_to_rest,
    write,
)

from game import clipboard, lineup, thinker
from game.actions import Action
from game.match import opponent
from game.match.positions import opening
from game.render.gauges import tip_circle
from game.text import words
from game.ui import menuview, pages, plates, prompts, shelfview
from game.ui.parts import hint
from game.ui.rules import RULES

R = 0.03275


@pytest.fixture
def quick(monkeypatch):
    """A computer that does not think for long."""
    monkeypatch.setattr(thinker, "EFFORT", 30)
    monkeypatch.setattr(opponent, "ROUNDS", ((2, 4), (4, 1)))
    monkeypatch.setattr(opponent, "FRESH", 4)


def told(app):
    """What the result card says."""
    contest = app.game.contest
    return plates.result(contest, contest.verdict, app.view.sight)[:3]


def scores(app):
    return [sheet.score for sheet in app.game.contest.match.sheets]


def opening_numbers():
    angle, speed, right, up = opening("sagu").answer
    return [f"{n:.4f}" for n in (speed, 2.5 * speed * up, 0.0, 2.5 * speed * right, angle)]


# -- the menu ------------------------------------------------------------------------------------


def choose(app, name, step=1, times=1):
    """Click the arrow of a row in the open menu."""
    sheet, layout = app.view.sheet, app.view.sight.layout
    place = next(i for i, row in enumerate(sheet.rows) if row.name == name)
    arrow = menuview.arrows(menuview.row_rect(sheet.rows, place, layout), layout)[step > 0]
    for _ in range(times):
        click(app, arrow.center)


def menu_button(app, name):
    place = menuview.BUTTONS.index(name)
    return menuview.button_rects(app.view.sight.layout)[place].center


def test_the_game_starts_at_a_table_and_not_in_a_menu():
    app = an_app()
    assert app.game.sheet == ""
    assert app.game.contest is None
    press(app, "return")
    assert app.game.moving


@pytest.mark.parametrize("key", ["f10", "escape"])
def test_the_menu_opens_and_closes_with_a_key_and_holds_the_balls(key):
    app = an_app()
    press(app, "return", key)
    held = places(app.game)
    app.frame(FRAME)
    assert app.game.sheet == "menu"
    assert places(app.game) == held
    press(app, "escape")
    assert app.game.sheet == ""
    app.frame(FRAME)
    assert places(app.game) != held


def test_a_match_is_put_together_by_keys_alone():
    app = an_app()
    press(app, "f10", "right", "right")
    assert app.view.sheet.fixture.game == "three-cushion"
    assert app.view.sheet.fixture.table == "match"
    press(app, "left")
    rows = [row.name for row in app.view.sheet.rows]
    press(app, *["down"] * rows.index("name"))
    write(app, "김 사구")
    press(app, "return", "return", "2", "5")
    press(app, "down", "down", "right", "right")
    press(app, *["down"] * (len(rows) - app.view.sheet.focus))
    press(app, "return")
    match = app.game.contest.match
    assert (match.players[0].name, match.players[0].target) == ("김 사구", 25)
    assert app.game.contest.fixture.seats[1].level == "club"
    assert app.game.sheet == ""
    assert len(app.game.world.balls) == 4


def test_a_match_is_put_together_by_the_mouse_alone():
    app = an_app(size=(1280, 720))
    click(app, app.view.sight.layout.engine.move(-64, -11).midright)
    assert app.game.sheet == "menu"
    choose(app, "game", -1)
    assert app.view.sheet.fixture.game == "three-cushion"
    choose(app, "bank")
    choose(app, "target", 1, 3)
    click(app, menu_button(app, "start"))
    assert app.game.contest.match.rules.bank == 2
    assert app.game.contest.match.players[0].target == 13
    assert app.game.table == "match"


def test_the_menu_gives_back_what_is_being_played():
    app = an_app(game="four-ball", players="Ann,Bo", handicap="7,9", level="human,expert")
    press(app, "f10")
    assert app.view.sheet.fixture == app.game.contest.fixture


def test_names_and_numbers_stay_within_what_a_match_takes():
    app = an_app(game="four-ball")
    press(app, "f10")
    rows = [row.name for row in app.view.sheet.rows]
    press(app, *["down"] * rows.index("name"))
    write(app, "x" * 40)
    press(app, "down", "down", "9", "9", "9", "9")
    seat = app.view.sheet.fixture.seats[0]
    assert (len(seat.name), seat.target) == (16, 200)
    press(app, *["backspace"] * 5)
    assert app.view.sheet.fixture.seats[0].target == 1


def test_closing_and_clicking_outside_change_nothing():
    app = an_app(game="four-ball")
    before = app.game.contest
    for at in ((3, 3), pages.close_rect(app.view.sight.layout).center):
        press(app, "f10", "right")
        click(app, at)
        assert app.game.sheet == ""
        assert app.game.contest is before


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
        if app.game.sheet:
            assert_same_as_anew(app)
            press(app, "escape")
        assert_same_as_anew(app)


@pytest.mark.parametrize("lang", ["en", "ko"])
@pytest.mark.parametrize("width", [960, 1280, 1920])
def test_every_word_of_the_pages_fits_into_its_place(lang, width):
    app = an_app(size=(width, width * 9 // 16), lang=lang)
    w, sight = words(lang), app.view.sight
    s, type_ = sight.layout.s, sight.type
    room = pages.inside(sight.layout).w
    for rect, name in zip(menuview.button_rects(sight.layout), menuview.BUTTONS, strict=True):
        assert type_.width(w[f"menu.{name}"], 15) <= rect.w - 8 * s
    for key in (k for k in w if k.startswith("row.")):
        assert type_.width(w[key], 13) <= menuview.LABEL * s - 8, w[key]
    for rect, name in zip(shelfview.button_rects(sight.layout), shelfview.BUTTONS, strict=True):
        assert type_.width(w[f"shelf.{name}"], 15) <= rect.w - 8 * s
    card = shelfview.card_rect(0, sight.layout).w - 12 * s
    for ready in lineup.shelf():
        assert type_.width(w[f"position.{ready.key}"], 13) <= card
    assert type_.width(w["shelf.hint"], 13) <= room
    box = (room - sight.layout.px(32)) / 2 - (menuview.LABEL + 2 * menuview.ARROW + 8) * s
    for key in (k for k in w if k.startswith(("level.", "finish.", "cloth.", "table.", "game."))):
        if key not in ("level.error", "table.scene"):
            assert type_.width(w[key], 15) <= box, w[key]
    for game, count in RULES.items():
        texts = [w[f"rule.{game}.{n}"] for n in range(1, count + 1)]
        lines = [list(pages.wrapped(text, type_, 15, room - 24 * s)) for text in texts]
        height = (34 + 36 + sum(25 * len(one) + 9 for one in lines)) * s
        assert height <= pages.inside(sight.layout).h


@pytest.mark.parametrize("lang", ["en", "ko"])
@pytest.mark.parametrize("width", [960, 1280])
def test_every_verdict_fits_into_the_result_card(lang, width):
    app = an_app(size=(width, width * 9 // 16), lang=lang, game="three-cushion")
    layout, type_, w = app.view.sight.layout, app.view.sight.type, words(lang)
    room = layout.result.w - 12 * layout.s - 58 * layout.s
    for key in (k for k in w if k.startswith("reason.")):
        assert type_.width(w[key].format(n=12), 15) <= room, w[key]


# -- an inning -----------------------------------------------------------------------------------


def test_an_inning_of_4_ball_by_keyboard_alone():
    app = an_app()
    press(app, "f10", "right", *["tab"] * len(app.view.sheets["menu"].rows))
    while app.view.sheet.row is not None:
        press(app, "down")
    press(app, "return")
    assert app.game.contest is not None
    enter(app, *opening_numbers())
    press(app, "return")
    assert prompts.hint(app.game) == "hint.rolling"
    run_to_rest(app)
    assert scores(app) == [1, 0]
    assert told(app) == ("+1", "Both reds, 2 cushions", "count 1 of 10 · run 1")
    assert_same_as_anew(app)
    press(app, "return")
    assert not app.game.shown_shot
    enter(app, "0.4", "0", "0", "0", "180")
    press(app, "return")
    run_to_rest(app)
    assert told(app) == ("−1", "Foul: no red", "turn passes")
    match = app.game.contest.match
    assert (match.at, match.cue, app.game.cue) == (1, "yellow", "yellow")
    assert match.sheets[0].innings == 1
    assert match.sheets[0].best == 1
    press(app, "return", "return")
    assert app.game.moving
    assert app.game.shooter == "yellow"


def test_an_inning_of_4_ball_by_mouse_alone():
    app = an_app(size=(1280, 720))
    layout = app.view.sight.layout
    click(app, layout.engine.move(-64, -11).midright)
    choose(app, "game")
    click(app, menu_button(app, "start"))
    layout, game = app.view.sight.layout, app.game
    (x, y), radius = tip_circle(layout.tip, layout.s)
    click(app, (x, y - 0.34 * radius))
    white = game.world.ball("white").position
    for off in range(12):  # as a person does: turn the aim until the preview shows the point
        angle = radians(5.0 + 0.12 * off)
        far = layout.to_screen(white[0] + 1.6 * cos(angle), white[1] + 1.6 * sin(angle))
        click(app, far)
        story = game.preview.story
        met = [b for e in story.events if e.kind == "ball" and "white" in e.balls for b in e.balls]
        if {"red1", "red2"} <= {*met} and "yellow" not in met:
            break
    click(app, layout.shoot.center)
    assert game.moving
    click(app, layout.shoot.center)  # to the end
    assert not game.moving
    assert game.contest.match.sheets[0].score == 1
    assert told(app)[0] == "+1"
    click(app, layout.shoot.center)  # the next turn
    assert not game.shown_shot
    at = layout.to_screen(*game.world.ball("white").position)
    click(app, (at[0] - 60, at[1]))
    click(app, layout.power.midleft)
    click(app, layout.shoot.center)
    click(app, layout.shoot.center)
    assert game.contest.match.at == 1
    assert game.cue == "yellow"


def test_the_plates_show_turn_score_and_the_last_point():
    app = an_app(game="four-ball", handicap="1", finish="last_point_3c")
    contest, sight = app.game.contest, app.view.sight
    assert plates._line(sight, contest, 0)[0] == "Last point: three cushions"
    before = app.screen.subsurface(sight.layout.score[0]).copy()
    enter(app, *opening_numbers())
    press(app, "return", "end")
    assert told(app)[1] == "Only 2 of 3 cushions"
    assert contest.match.at == 1
    after = app.screen.subsurface(sight.layout.score[0])
    assert pygame.image.tobytes(before, "RGB") != pygame.image.tobytes(after, "RGB")


def test_a_handicap_reached_wins_and_the_window_says_so():
    app = an_app(game="four-ball", players="Ann,Bo", handicap="1", finish="none")
    enter(app, *opening_numbers())
    press(app, "return", "end")
    assert told(app) == ("+1", "Ann wins", "1 inning · avg 1.00 · Both reds, 2 cushions")
    assert plates._line(app.view.sight, app.game.contest, 0)[0] == "wins after 1 inning"
    press(app, "ctrl+return")
    assert hint(app.game, words("en")) == ("the match is over · F10 new game", True)
    click(app, app.view.sight.layout.shoot.center)
    assert app.game.sheet == "menu"


def test_somebody_may_play_alone():
    app = an_app(game="three-cushion", players="1")
    press(app, "ctrl+return", "end")
    match = app.game.contest.match
    assert match.at == 0
    assert match.sheets[0].innings == 1 or match.run
    assert_same_as_anew(app)


def test_events_are_told_in_both_languages_when_asked_for():
    app = an_app(game="four-ball")
    press(app, "return", "end")
    one = app.screen.subsurface(app.view.sight.layout.log).copy()
    press(app, "n")
    two = app.screen.subsurface(app.view.sight.layout.log)
    assert pygame.image.tobytes(one, "RGB") != pygame.image.tobytes(two, "RGB")
    assert_same_as_anew(app)


# -- the computer --------------------------------------------------------------------------------


def a_duel(**more):
    app = an_app(game="four-ball", level="club", seed=3, **more)
    press(app, "ctrl+return", "end")
    while app.game.contest.level is None:
        press(app, "return")
        enter(app, "0.3", "0", "0", "0", "180")
        press(app, "return", "end")
    return app


def until(app, happened, frames=2000):
    for _ in range(frames):
        if happened():
            return
        app.frame(FRAME)
    raise AssertionError("it never happened")


def test_the_computer_shows_what_it_intends_and_plays_it(quick):
    app = a_duel()
    game, shots = app.game, app.game.shots
    assert game.shown_shot  # the last stroke can still be looked at
    until(app, lambda: not game.shown_shot)
    until(app, lambda: game.contest.share is not None and not game.contest.thinking)
    intended = list(game.aim.texts)
    assert "expected" in plates._line(app.view.sight, game.contest, 1)[0]
    assert_same_as_anew(app)
    until(app, lambda: game.shots > shots)
    assert game.shooter == "yellow"
    assert game.aim.texts != intended  # it errs
    assert game.moving


@pytest.mark.parametrize("key", ["return", "end", "space"])
def test_the_computers_thinking_can_be_cut_short(key):
    app = a_duel()
    shots = app.game.shots
    app.frame(FRAME)
    press(app, key)
    app.frame(FRAME)
    assert app.game.shots == shots + 1


def test_the_button_cuts_the_computers_thinking_short():
    app = a_duel()
    shots = app.game.shots
    app.frame(FRAME)
    click(app, app.view.sight.layout.shoot.center)
    app.frame(FRAME)
    assert app.game.shots == shots + 1


def test_while_the_computer_thinks_the_window_answers(quick):
    app = a_duel()
    app.frame(FRAME)
    shots = app.game.shots
    press(app, "left", "4", "right")
    assert app.game.aim.box is None
    press(app, "f2")
    assert app.game.language == "ko"
    for key, held in (("f1", "help"), ("f10", "sheet"), ("f3", "sheet")):
        press(app, key)
        assert getattr(app.game, held)
        for _ in range(100):
            app.frame(FRAME)
        assert app.game.shots == shots
        press(app, "escape")
    pygame.event.post(pygame.event.Event(pygame.QUIT))
    app.frame(FRAME)
    assert app.game.over


def test_a_frame_of_thinking_is_at_most_one_simulation_longer_than_its_budget(monkeypatch):
    now = [0.0]
    whole = opponent.simulate
    longest = 0.0

    def slow(*args):
        now[0] += 0.0031
        return whole(*args)

    monkeypatch.setattr(opponent, "simulate", slow)
    monkeypatch.setattr(thinker, "perf_counter", lambda: now[0])
    app = a_duel()
    app.thinker.virtual = False
    for _ in range(60):
        begun = now[0]
        app.frame(FRAME)
        longest = max(longest, now[0] - begun)
    assert thinker.BUDGET <= longest < thinker.BUDGET + 0.0031


def test_two_computers_play_each_other_to_the_end(quick):
    app = an_app(game="four-ball", level="expert,novice", handicap="1", finish="none", seed=5)
    game = app.game
    for _ in range(3000):
        if game.contest.match.finished:
            break
        app.frame(10 * FRAME)
    match = game.contest.match
    assert match.finished
    assert match.sheets[match.winner].score == 1


def test_a_match_with_the_computer_replays_from_its_actions_alone(quick):
    app = a_duel()
    game = app.game
    until(app, lambda: game.contest.level is None or game.shots > 2)
    run_to_rest(app)
    again = an_app(game="four-ball", level="club", seed=3).game
    for tick, action in app.actions:
        again.advance(tick - again.tick)
        again.perform(action)
    again.advance(game.tick - again.tick)
    assert places(again) == places(game)
    assert again.contest.match == game.contest.match


def test_undo_goes_back_to_a_persons_turn(quick):
    app = a_duel()
    game = app.game
    strokes = game.contest.match.sheets[0].strokes
    until(app, lambda: game.shots > strokes)
    press(app, "end")
    press(app, "z")
    assert game.contest.level is None
    assert game.contest.match.sheets[1].strokes == 0
    assert game.contest.match.sheets[0].strokes == strokes - 1


# -- the shelf -----------------------------------------------------------------------------------


def test_a_set_up_is_taken_from_the_shelf_by_keys_and_by_mouse():
    app = an_app()
    press(app, "f4", "right", "right", "return")
    assert lineup.of(app.game).balls == list(lineup.shelf())[2].lineup.balls
    press(app, "f4")
    layout = app.view.sight.layout
    click(app, shelfview.tab_rects(layout)[1].center)
    click(app, shelfview.card_rect(1, layout).center)
    assert app.game.table == "match"
    assert app.game.sheet == ""
    press(app, "f4", "pagedown", "return")
    assert app.game.table == "thesis_1"
    assert app.game.moving


def test_a_set_up_is_saved_by_name_and_loaded_again(tmp_path):
    app = an_app()
    app.view.sheets["shelf"].library.path = tmp_path / "set-ups.json"
    press(app, "down", "f4")
    wanted = places(app.game)
    box = shelfview.box_rect(app.view.sight.layout)
    click(app, box.center)
    write(app, "나의 공")
    press(app, "return")
    assert app.view.sheet.said == ("shelf.saved", "나의 공")
    press(app, "escape", "down")
    assert places(app.game) != wanted
    press(app, "f4", "return")
    assert places(app.game) == wanted


def test_a_line_is_copied_and_pasted_even_without_a_clipboard(monkeypatch):
    app = an_app()
    press(app, "f4", "ctrl+c")
    line = app.view.sheet.text
    assert line.startswith("danggu1 medium white=")
    wanted = places(app.game)
    press(app, "escape", "down", "f4")
    monkeypatch.setattr("game.clipboard.get", lambda: "")
    press(app, "ctrl+v")
    assert app.game.sheet == ""
    assert places(app.game) == wanted


def test_what_is_copied_can_be_pasted():
    an_app()
    assert clipboard.put("danggu1 사구")
    assert clipboard.get() == "danggu1 사구"


def test_without_any_clipboard_nothing_is_copied_and_nothing_breaks(monkeypatch):
    def none():
        raise pygame.error("no clipboard")

    for name in ("_scrap", "_sdl", "_ready"):
        monkeypatch.setattr(clipboard, name, none)
    assert not clipboard.put("x")
    assert clipboard.get() == ""


def test_a_broken_line_in_the_box_says_what_is_wrong_and_changes_nothing():
    app = an_app()
    before = places(app.game)
    press(app, "f4", "tab")
    write(app, "danggu1 medium white=5,0")
    press(app, "return")
    assert app.view.sheet.said == ("line.outside", "white")
    assert app.game.sheet == "shelf"
    assert places(app.game) == before


def test_balls_are_placed_by_keys_alone_and_by_mouse_alone():
    app = an_app()
    white = app.game.world.ball("white").position
    press(app, "b", "right", "shift+up")
    found = app.game.world.ball("white").position
    assert found == pytest.approx((white[0] + 0.02, white[1] + 0.001))
    press(app, "tab")
    assert app.game.held_ball == "yellow"
    press(app, "return")
    assert not app.game.arranging
    press(app, "b")
    layout = app.view.sight.layout
    red = app.game.world.ball("red1").position
    to = (0.8, -0.3)
    click(app, layout.to_screen(*red), layout.to_screen(*to))
    assert app.game.world.ball("red1").position == pytest.approx(to, abs=1.5 / layout.scale)
    click(app, layout.shoot.center)
    assert not app.game.arranging
    assert_same_as_anew(app)


def test_a_ball_dragged_around_the_table_never_overlaps_anything():
    rng, app = random.Random(6), an_app(size=(640, 360))
    layout, balls = app.view.sight.layout, app.game.world.balls
    press(app, "b")
    for _ in range(40):
        start = layout.to_screen(*rng.choice(balls).position)
        click(app, start, (rng.randrange(640), rng.randrange(360)))
        for a, b in product(balls, balls):
            gap = abs(complex(*a.position) - complex(*b.position))
            assert a is b or gap >= 2 * R
        walls = app.game.world.walls
        assert min(w.distance(b.position) for w in walls for b in balls) >= R


def test_random_events_in_a_match_neither_crash_nor_spoil_the_picture(quick):
    rng, app = random.Random(8), an_app(size=(640, 360), game="four-ball", level="novice")
    keys = ["f10", "f4", "f5", "f3", "escape", "return", "tab", "up", "down", "left", "right", "b",
            "end", "space", "r", "z", "y", "n", "pageup", "delete", "backspace", "5", "ctrl+return",
            "ctrl+c", "f2", "f1", "p"]  # fmt: skip
    for k in range(500):
        if k % 25 == 0:
            assert_same_as_anew(app)
        match rng.randrange(4):
            case 0:
                write(app, rng.choice("0123가a.-"))
            case 1:
                click(app, (rng.randrange(640), rng.randrange(360)))
            case _:
                press(app, rng.choice(keys))
        if app.game.over:
            app.game.over = False
    assert {"sheet", "fire", "edit", "line"} <= {action.name for _, action in app.actions}


def test_the_action_of_a_fixture_that_is_none_is_an_error():
    with pytest.raises(ValueError, match="JSON"):
        an_app().game.perform(Action("match", "{"))
