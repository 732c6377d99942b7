"""A match of pool in the window: by keys alone, and by the mouse alone."""

from dataclasses import replace

import pytest

from danggu.rules.state import ANYWHERE
from game.session import terms
from game.session.action import Action
from game.ui.panels import asked_card, rack_words, tray
from game.ui.panels.parts import hint
from tests.support.players import (
    an_app,
    assert_same_as_anew,
    click,
    pixels,
    press,
    run_to_rest,
    write,
)
from tests.support.racked_games import leave
from tests.support.sampling import mostly

GAMES = [name for name, one in terms.DISCIPLINES.items() if one.rules and not one.position]


def app_of(game, **more):
    return an_app(size=(1280, 720), game=game, table=terms.DISCIPLINES[game].table, **more)


def test_the_break_is_placed_aimed_and_shot_by_keys():
    app = app_of("8-ball")
    session = app.session
    assert session.arranging
    before = session.world.ball("cue").position
    press(app, "up", "left", "shift+up")
    after = session.world.ball("cue").position
    assert after == pytest.approx((before[0] - 0.02, before[1] + 0.021))
    press(app, *["right"] * 9)  # the head string is in the way
    assert session.world.ball("cue").position[0] < session.world.table.head_string
    assert "head string" in hint(session, app.view.sight.words)[0]
    press(app, "return")
    assert not session.arranging
    press(app, "return")
    assert session.moving
    run_to_rest(app)
    assert session.contest.verdict is not None
    assert_same_as_anew(app)


def test_a_question_is_answered_by_a_key_and_nothing_is_typed_meanwhile():
    app = app_of("8-ball")
    press(app, "return")
    app.perform(Action("play", "0.2 0 0 0 0"))
    run_to_rest(app)
    session = app.session
    assert len(asked_card.options(session)) == 3
    assert_same_as_anew(app)
    texts = list(session.aim.texts)
    write(app, "7")
    press(app, "down", "right")
    assert app.view.sight.choice == 0
    assert session.aim.texts == texts
    press(app, "3")
    assert session.contest.match.asked is None
    assert session.contest.match.at == 0  # the offender breaks again
    assert_same_as_anew(app)


def test_a_question_is_not_answered_by_enter_or_the_button_before_a_row_is_chosen():
    app = app_of("8-ball")
    press(app, "return")
    app.perform(Action("play", "0.2 0 0 0 0"))
    press(app, "end", "return", "return")
    session = app.session
    click(app, app.view.sight.layout.shoot.center)
    click(app, app.view.sight.layout.shoot.center)
    assert len(asked_card.options(session)) == 3
    assert_same_as_anew(app)
    press(app, "up", "return")  # the last row
    assert session.contest.match.asked is None
    assert session.contest.match.at == 0


def test_escape_does_not_place_the_ball_in_hand_and_b_takes_it_again():
    app = app_of("9-ball")
    session = app.session
    press(app, "escape")
    assert session.arranging
    assert session.page == "menu"
    press(app, "escape", "return")
    assert not session.arranging
    assert "B: ball" in hint(session, app.view.sight.words)[0]
    press(app, "b")
    assert session.arranging


def test_a_question_is_answered_by_a_click():
    app = app_of("8-ball")
    press(app, "return")
    app.perform(Action("play", "0.2 0 0 0 0"))
    run_to_rest(app)
    app.frame(0)
    click(app, asked_card.row_rect(app.view.sight.layout, 1).center)
    assert app.session.contest.match.asked is None
    assert app.session.arranging


def test_ball_and_pocket_are_called_by_keys_and_by_clicks():
    app = app_of("8-ball")
    session, layout = app.session, app.view.sight.layout
    leave(session, cue=(-0.5, 0.0), b1=(0.3, 0.2), b2=(0.0, -0.4), b9=(0.6, 0.1), b8=(0.9, 0.0))
    session.arranging = False
    app.perform(Action("next"))
    press(app, "k", "o")
    assert session.contest.match.call.ball == "1"
    assert session.contest.match.call.pocket
    click(app, layout.to_screen(0.0, -0.4))
    assert session.contest.match.call.ball == "2"
    click(app, layout.to_screen(1.28, 0.645))
    assert session.contest.match.call.pocket == "north-east pocket"
    press(app, "s")
    assert session.contest.match.call.safety
    assert not session.contest.match.call.ball


def test_the_ball_in_hand_is_dragged_and_stays_where_it_may_not_go():
    app = app_of("9-ball")
    session, layout = app.session, app.view.sight.layout
    click(app, layout.to_screen(-1.0, 0.3))
    assert session.world.ball("cue").position == pytest.approx((-1.0, 0.3), abs=0.01)
    before = session.world.ball("cue").position
    click(app, layout.to_screen(0.5, 0.3))
    assert session.world.ball("cue").position == before
    assert hint(session, app.view.sight.words)[1]


def test_a_place_that_is_forbidden_is_ringed_with_the_ball_that_is_in_the_way():
    app = app_of("9-ball")
    session = app.session
    leave(session, cue=(-0.5, 0.0), b1=(0.3, 0.2), b9=(0.6, 0.1))
    state = replace(session.contest.match.state, region=ANYWHERE)
    session.contest.match = replace(session.contest.match, state=state)
    app.frame(0)
    for at, about in ((0.31, 0.21), "1"), ((-5.0, 0.0), ""):
        before = pixels(app)
        app.perform(Action("move", f"{at[0]} {at[1]}"))
        app.frame(0)
        assert (session.notice.at, session.notice.about) == (at, about)
        assert pixels(app) != before
        assert_same_as_anew(app)
    app.perform(Action("move", "-0.6 0"))
    assert session.notice is None
    assert_same_as_anew(app)


def test_a_ball_in_hand_that_was_put_down_is_dragged_on_and_a_click_on_it_leaves_it():
    app = app_of("9-ball")
    session, layout = app.session, app.view.sight.layout
    press(app, "return")
    at, away = session.world.ball("cue").position, (-0.9, 0.1)
    click(app, layout.to_screen(*at))
    assert session.world.ball("cue").position == at
    texts = list(session.aim.texts)
    click(app, layout.to_screen(*at), layout.to_screen(*away))
    assert session.world.ball("cue").position == pytest.approx(away, abs=0.01)
    assert (session.arranging, session.aim.texts) == (False, texts)
    click(app, layout.to_screen(*away), layout.to_screen(0.2, 0.1))
    assert session.world.ball("cue").position == pytest.approx(away, abs=0.01)
    assert session.notice.at == pytest.approx((0.2, 0.1), abs=0.01)
    assert_same_as_anew(app)
    click(app, layout.to_screen(-0.9, 0.3), layout.to_screen(-0.8, 0.4))
    assert session.aim.texts != texts  # beside the ball a drag aims
    assert session.world.ball("cue").position == pytest.approx(away, abs=0.01)
    press(app, "return")
    assert session.moving


def test_the_tray_has_a_slot_for_each_ball_and_the_plates_say_the_groups():
    app = app_of("8-ball")
    assert tray.slots(app.session) == [str(n) for n in range(1, 16)]
    words = app.view.sight.words
    assert rack_words.line(app.session.contest, 0, words)[0] == "open table"
    assert rack_words.middle(app.session.contest, words) == ("Rack", "1")
    assert tray.slots(app_of("snooker").session)[0] == "red"


def test_the_tray_follows_the_ball_that_is_played_with():
    app = app_of("free-pyramid")
    press(app, "return", "k", "k", "k")
    assert app.session.cue not in tray.slots(app.session)
    assert_same_as_anew(app)


@pytest.mark.parametrize("game", mostly(GAMES, quick=("9-ball", "snooker")))
@pytest.mark.parametrize("lang", ["en", "ko"])
def test_a_few_strokes_of_each_game_by_keys_look_the_same_in_part_and_anew(game, lang):
    app = app_of(game, lang=lang)
    for _ in range(3):
        for _ in range(7):
            if app.session.moving:
                break
            press(app, "1" if asked_card.options(app.session) else "return")
        run_to_rest(app)
        assert_same_as_anew(app)
    assert app.session.shots == 3
