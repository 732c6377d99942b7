"""After a break no marks lie where the rack was: they would hide the balls that are there now."""

import pytest

from game.render.parts import lanes
from game.render.table import lines
from game.session.action import Action
from game.ui.table.racked import racked
from tests.support.players import an_app, press, run_to_rest


def rings_and_dots(monkeypatch, app):
    """How many start marks and dots of hits the picture of the last shot has."""
    drawn = {"ring": 0, "collision": 0}

    def counting(name):
        own = getattr(lines, name)

        def draw(*args, **more):
            drawn[name] += 1
            return own(*args, **more)

        return draw

    for name in drawn:
        monkeypatch.setattr(lines, name, counting(name))
    app.view.expose()
    app.redraw()
    app.frame(0)
    return drawn


@pytest.mark.parametrize(("game", "count"), [("9-ball", 9), ("8-ball", 15)])
def test_after_a_break_only_the_cue_ball_has_a_start_mark(monkeypatch, game, count):
    app = an_app(size=(1280, 720), game=game, table="pool-9")
    press(app, "return")
    app.perform(Action("play", "8 0 0 0 0"))
    run_to_rest(app)
    assert len(racked(app.session)) == count
    assert rings_and_dots(monkeypatch, app)["ring"] <= 1


def test_balls_of_carom_keep_their_start_marks(monkeypatch):
    app = an_app(size=(1280, 720))
    press(app, "return")
    run_to_rest(app)
    assert not racked(app.session)
    assert rings_and_dots(monkeypatch, app)["ring"] >= 1


def test_a_lane_has_the_colour_of_its_ball_also_where_not_every_ball_has_one(monkeypatch):
    app = an_app(size=(1280, 720))
    app.perform(Action("scene", "rack15"))
    for stroke in ("8 0 0 0 0", "5 0 0 0 30"):  # the second one at a ball of the pack's end
        app.perform(Action("play", stroke))
        run_to_rest(app)
    drawn = []
    monkeypatch.setattr(
        lanes, "timeline", lambda surface, rect, kind, found, *more: drawn.extend(found) or rect
    )
    app.view.expose()
    app.redraw()
    app.frame(0)
    names = [ball.name for ball in app.session.world.balls if ball.name in app.session.traced]
    assert names == ["cue", "15"]
    assert [lane.colour for lane in drawn] == [app.view.sight.look(name).ui for name in names]
