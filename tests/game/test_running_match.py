"""What a match keeps to itself: its engine, the stroke that is on show, and what it says of it."""

import json

import pytest

from game import options
from game.__main__ import main, new_game
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.session.terms import FOUR_BALL, Terms, read
from game.session.ticks import TICKS
from game.settings.settings import Settings, Store
from game.table.presets import table_world
from game.ui.panels import score_plates, shot_panels
from physics import EventDriven, TimeStepping
from tests.support.matches import opening_numbers
from tests.support.players import FRAME, an_app, enter, press, run_to_rest, write

MISS = ("0.5", "0.25", "0", "0", "90")


@pytest.fixture
def app():
    return an_app(game="four-ball", handicap="5")


def result(app):
    """What the card of the last stroke says."""
    return shot_panels._result_look(app.view.sight)


# -- the boxes


def test_the_boxes_hold_the_stroke_while_it_is_on_show(app):
    enter(app, *MISS)
    press(app, "return", "end")
    session = app.session
    assert session.shown_shot
    assert session.aim.texts == [*MISS]
    assert session.contest.match.at == 1
    press(app, "return")
    assert not session.shown_shot
    assert session.aim.texts[:4] == ["2.5", "0", "0", "0"]
    assert session.preview.contact.ball in ("red1", "red2")
    assert session.aim.complete


TURNS = {
    "the next one is shown": ("next", None),
    "the aim is turned": ("turn", "1"),
    "the power is set": ("push", "0.5"),
    "the tip is moved": ("nudge", "0.1 0"),
    "the cue is raised": ("tilt", "5"),
    "a box is edited": ("edit", 1),
    "it is struck": ("fire", None),
}


@pytest.mark.parametrize("how", TURNS)
def test_the_next_player_begins_with_own_numbers_however_it_goes_on(app, how):
    enter(app, *MISS)
    press(app, "return", "end", "return")
    ready = list(app.session.aim.texts)
    again = an_app(game="four-ball", handicap="5")
    enter(again, *MISS)
    press(again, "return", "end")
    for one in (app, again):
        one.perform(Action(*TURNS[how]))
    assert again.session.aim.texts == app.session.aim.texts
    assert again.session.cue == "yellow"
    if how == "it is struck":
        assert again.session.aim.texts == ready
        assert again.session.shooter == "yellow"
        press(again, "end", "z")  # to before that stroke
        assert again.session.aim.texts == ready


def test_what_is_typed_while_balls_roll_stays(app):
    enter(app, *MISS)
    press(app, "return")
    enter(app, "1.25", "0", "0", "0", "200")
    press(app, "end")
    assert app.session.aim.texts == ["1.25", "0", "0", "0", "200"]
    press(app, "return")
    assert app.session.moving
    assert app.session.shooter == "yellow"


def test_a_box_that_is_edited_when_the_balls_come_to_rest_stays_so(app):
    enter(app, *MISS)
    press(app, "return", "left")
    write(app, "7")
    run_to_rest(app)
    assert app.session.aim.texts == ["7", *MISS[1:]]
    press(app, "tab")
    assert app.session.aim.texts == ["7", *MISS[1:]]


def test_in_practice_the_boxes_hold_the_shot_too():
    app = an_app()
    enter(app, *MISS)
    press(app, "return", "end")
    assert app.session.aim.texts == [*MISS]
    press(app, "left", "escape")
    assert app.session.aim.texts == [*MISS]


# -- the card of a stroke that is looked at again


def test_a_verdict_is_not_told_before_it_is_known(app):
    enter(app, *opening_numbers())
    press(app, "return", "end")
    assert result(app)[0] == "+1"
    shot = app.session.contest.verdict.facts.decided - app.session.began
    for time in (0.0, 0.5 * shot, shot + 0.01):
        app.perform(Action("scrub", int(time * TICKS)))
        badge, first, second, _ = result(app)
        assert badge != "+1"  # the opponent's ball may yet be hit
        assert "run" not in first + second
    press(app, "end")
    assert result(app)[0] == "+1"


def test_a_foul_is_told_from_the_moment_it_happens(app):
    session = app.session
    session.lay([(0.0, 0.0), (0.5, 0.0), (0.9, 0.4), (-0.9, 0.4)])
    enter(app, "2", "0", "0", "0", "0")
    press(app, "return", "end")
    said = result(app)
    assert session.contest.verdict.reason == "opponent_ball"
    when = session.contest.verdict.facts.decided - session.began
    for time, told in ((0.9 * when, False), (1.01 * when, True), (2 * when, True)):
        app.perform(Action("scrub", int(time * TICKS)))
        assert (
            result(app)[:2] == (said[0], score_plates.reason(session.contest.verdict, words(app)))
        ) is told


def words(app):
    return app.view.sight.words


# -- the engine


def test_the_key_of_the_engine_is_not_remembered_and_the_settings_page_is():
    app = an_app()
    press(app, "e")
    assert app.session.engine == "thesis"
    assert app.preferences.settings.engine == "exact"
    app.perform(Action("engine", "thesis"))
    assert app.preferences.settings.engine == "thesis"
    press(app, "e")
    assert app.preferences.settings.engine == "exact"


def test_the_engine_of_practice_does_not_follow_into_a_match():
    app = an_app()
    press(app, "e")
    app.perform(Action("match", Terms(FOUR_BALL).line()))
    assert app.session.engine == "exact"
    assert isinstance(app.session.world.engine, EventDriven)
    assert app.session.contest.terms.engine == "exact"


def test_free_practice_keeps_the_engine_on_another_table():
    session = Session(table_world("medium"))
    perform(session, Action("engine"))
    for action in (
        Action("table", "match"), Action("scene", "carom"), Action("match", Terms().line())
    ):  # fmt: skip
        perform(session, action)
        assert session.engine == "thesis"
        assert isinstance(session.world.engine, TimeStepping)


def begun(*said, settings=None):
    found = options.read([*said])
    return new_game(settings.applied(found) if settings else found)


def test_a_match_is_played_in_steps_if_the_command_line_says_so():
    session = begun("--game", "four-ball", "--engine", "thesis")
    assert (session.engine, session.contest.terms.engine) == ("thesis", "thesis")
    session = begun("--engine", "thesis")
    assert session.engine == session.match_engine == "thesis"


def test_a_match_is_exact_whatever_was_chosen_for_practice():
    chosen = Settings(engine="thesis")
    session = begun("--game", "three-cushion", settings=chosen)
    assert (session.engine, session.contest.terms.engine) == ("exact", "exact")
    session = begun(settings=chosen)
    assert (session.engine, session.match_engine) == ("thesis", "exact")


def test_the_menu_begins_the_match_that_the_command_line_asked_for():
    app = an_app(engine="thesis", given=frozenset({"engine"}))
    press(app, "f10", "right")
    assert app.view.page.terms.engine == "thesis"
    app = an_app(engine="thesis")
    press(app, "f10", "right")
    assert app.view.page.terms.engine == "exact"


def test_terms_name_their_engine_and_a_line_without_one_is_exact():
    line = Terms(FOUR_BALL, engine="thesis").line()
    assert read(line).engine == "thesis"
    old = {key: value for key, value in json.loads(line).items() if key != "engine"}
    assert read(json.dumps(old)).engine == "exact"
    with pytest.raises(ValueError, match="engine must be one of exact, thesis, not 'steam'"):
        Terms(engine="steam")


def test_what_the_key_chose_is_not_in_the_file(tmp_path):
    path, script = tmp_path / "settings.json", tmp_path / "script.txt"
    script.write_text("0.1 key e\n0.2 key m\n", encoding="utf-8")
    said = ["--settings", str(path), "--script", str(script), "--frames", "30"]
    assert main([*said, "--size", "640x360"]) == 0
    loaded = Store(path).load()
    assert loaded.muted
    assert loaded.engine == "exact"


def test_a_recorded_match_comes_out_the_same(tmp_path):
    path, script = tmp_path / "match.rec", tmp_path / "script.txt"
    lines = (
        "0.1 key ctrl+return\n0.5 key e\n0.9 key right\n1 key return\n1.2 key l\n1.3 key escape\n"
    )
    script.write_text(lines + "2 quit\n2.1 quit\n", encoding="utf-8")
    said = ["--game", "four-ball", "--record", str(path), "--script", str(script)]
    assert main([*said, "--frames", "300", "--size", "640x360"]) == 0
    done = [json.loads(line).get("do", [""]) for line in path.read_text().splitlines()]
    assert [d for d in done if d[0] in ("engine", "law", "sheet")] == [
        ["sheet", "ask"], ["sheet", ""], ["engine"], ["sheet", "ask"], ["sheet", ""],
        ["sheet", "ask"],
    ]  # fmt: skip
    assert main(["--replay", str(path), "--headless"]) == 0


def test_watching_a_record_is_left_without_a_question(tmp_path):
    path, script = tmp_path / "match.rec", tmp_path / "script.txt"
    script.write_text("0.1 key ctrl+return\n", encoding="utf-8")
    said = ["--game", "four-ball", "--record", str(path), "--script", str(script)]
    assert main([*said, "--frames", "300", "--size", "640x360"]) == 0
    script.write_text("1 quit\n", encoding="utf-8")
    again = ["--replay", str(path), "--script", str(script), "--stats"]
    assert main([*again, "--frames", "300", "--size", "640x360"]) == 0


def test_time_stands_while_a_question_is_asked(app):
    press(app, "ctrl+return")
    for _ in range(10):
        app.frame(FRAME)
    press(app, "e")
    before, tick = app.session.world.time, app.session.tick
    app.frame(FRAME)
    assert app.session.world.time == before
    assert app.session.tick > tick
