"""After the end of a match its result stays on show, and a rematch is offered."""

from dataclasses import replace

from game.render.parts import lanes
from game.session.action import Action
from game.ui.panels import prompts
from game.ui.panels.parts import hint
from tests.support.players import an_app, press, run_to_rest


def over(game, table):
    """An app whose match has just ended by a stroke."""
    app = an_app(size=(1280, 720), game=game, table=table)
    press(app, "return")
    app.perform(Action("play", "0.5 0 0 0 0"))
    run_to_rest(app)
    contest = app.session.contest
    contest.match = replace(contest.match, winner=0, asked=None)
    contest.race = contest.race.after(0)
    app.session.read()
    app.redraw()
    app.frame(0)
    return app


def test_enter_and_aiming_leave_the_result_of_a_match_that_is_over():
    for game, table in (("9-ball", "pool-9"), ("three-cushion", "match"), ("snooker", "snooker")):
        app = over(game, table)
        session = app.session
        assert session.contest.over
        assert session.shown_shot
        assert app.view.sight.mode == "after"
        press(app, "return", "return", "q", "ctrl+return", "c")
        assert session.shown_shot
        assert app.view.sight.mode == "after"
        assert not session.moving
        app.session.notice = None
        press(app, "return")
        assert "rematch" in hint(session, app.view.sight.words)[0]
        assert prompts.button(session)[:2] == ("again", "key.f10")


def test_after_a_match_it_is_still_taken_back_and_the_next_shot_is_shown():
    app = over("three-cushion", "match")
    press(app, "r")
    assert not app.session.contest.over
    press(app, "return")
    assert app.session.moving


def test_the_clock_of_a_shot_does_not_pass_its_end(monkeypatch):
    said = []
    app = an_app(size=(1280, 720))
    monkeypatch.setattr(lanes, "timeline", lambda *args: said.append(args) or args[1])
    app.perform(Action("fire"))
    run_to_rest(app)
    app.session.readout_time += 8 / 60  # what is left of a frame at eight times the speed
    app.view.expose()
    app.redraw()
    app.frame(0)
    *_, length, label, _, now = said[-1]
    assert now == length
    assert label.count(f"{length:.2f}") == 2
