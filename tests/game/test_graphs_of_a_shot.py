"""Graphs of a shot in place of its log, and the shot by other laws drawn over it."""

from math import dist

import numpy as np
import pygame
import pytest

from game.aim.curves import curves
from game.render.parts.graph import Curve, bounds
from game.render.theme import WHITE
from game.session import compared
from game.session.action import Action
from game.session.commands import RECORDED, perform
from game.session.session import Session
from game.table import presets
from game.text import LANGUAGES
from game.ui.panels import graphs
from game.ui.table.rival_lines import DASHES, INKS
from physics import Shot, simulate
from tests.support.players import FRAME, an_app, assert_same_as_anew, press


def shot_at_rest(table="medium"):
    session = Session(presets.table_world(table), table=table)
    perform(session, Action("shoot"))
    perform(session, Action("skip"))
    assert not session.moving
    return session


def rivals_of(session):
    given = session.law, session.engine, session.edition, session.came_with
    return compared.rivals(session.world, session.shooter, session.began, *given)


def after_a_shot(*keys):
    app = an_app(size=(1280, 720))
    press(app, "return", "end", *keys)
    app.frame(FRAME)
    return app


# -- graphs --------------------------------------------------------------------------------------


def test_curves_are_what_the_log_says_at_each_moment():
    session = shot_at_rest()
    found = curves(session.world, session.began, 200)
    for k in (0, 50, 199):
        states = session.world.log.at(session.began + found.times[k])
        masses = {ball.name: ball.mass for ball in session.world.balls}
        for axis in (0, 1):
            momentum = sum(masses[name] * s.velocity[axis] for name, s in states.items())
            assert found.momentum[axis][k] == pytest.approx(momentum, abs=1e-12)
        assert found.speeds["white"][k] == pytest.approx(states["white"].speed, abs=1e-12)
        assert found.moving[k] <= found.energy[k]


def test_energy_begins_as_the_balls_have_it_and_never_grows():
    world = presets.table_world("medium")
    world.strike("white", Shot(3.0, 20.0, follow=1.0, side=2.0))
    found = curves(world, world.time, 300)
    assert found.energy[0] == pytest.approx(sum(ball.energy for ball in world.balls), rel=1e-12)
    assert np.diff(found.energy).max() <= 1e-12
    assert found.energy[-1] == pytest.approx(0.0, abs=1e-6)


def test_balls_that_lie_still_have_no_curve_and_a_table_at_rest_no_curves():
    session = shot_at_rest()
    assert "white" in curves(session.world, session.began, 50).speeds
    assert {*curves(session.world, session.began, 50).speeds} < {
        ball.name for ball in session.world.balls
    }
    assert curves(presets.table_world("medium"), 0.0, 50) is None


def test_a_graph_has_nought_in_it_and_is_never_flat():
    assert bounds([Curve(np.array([2.0, 3.0]), WHITE)]) == (0.0, 3.0)
    assert bounds([Curve(np.array([-2.0, -1.0]), WHITE)]) == (-2.0, 0.0)
    assert bounds([Curve(np.array([0.0, 0.0]), WHITE)]) == (0.0, 1.0)


def log_panel(app):
    return next(part for part in app.view.parts if part.name == "log")


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_key_puts_graphs_in_place_of_the_log_and_takes_them_away(language):
    app = after_a_shot()
    app.perform(Action("language", language))
    app.frame(FRAME)
    rect = log_panel(app).rect
    log = pygame.image.tobytes(app.canvas.surface.subsurface(rect), "RGB")
    press(app, "f8")
    assert app.preferences.settings.graphs
    graphed = pygame.image.tobytes(app.canvas.surface.subsurface(rect), "RGB")
    assert graphed != log
    assert_same_as_anew(app)
    press(app, "f8")
    assert pygame.image.tobytes(app.canvas.surface.subsurface(rect), "RGB") == log


def click(app, at):
    for kind in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
        app.handle(pygame.event.Event(kind, {"pos": (round(at[0]), round(at[1])), "button": 1}))


def test_the_head_of_the_log_has_a_button_for_graphs_and_theirs_one_for_the_log():
    app = after_a_shot()
    rect, sight = log_panel(app).rect, app.view.sight
    wide = sight.type.width(sight.words["events.both"], 12)
    click(app, (rect.right - 30 - wide, rect.y + 18))
    assert app.preferences.settings.graphs
    assert not app.preferences.settings.both
    click(app, (rect.right - 30, rect.y + 18))
    assert not app.preferences.settings.graphs
    click(app, (rect.right - 20, rect.y + 18))
    assert app.preferences.settings.both


def test_the_mouse_on_a_graph_shows_that_moment_and_follows_while_it_is_held():
    app = after_a_shot("f8")
    room = graphs.rects(log_panel(app).rect, app.view.sight.layout.s)[1]
    length = app.session.forecast.duration
    middle = {"pos": (room.x + room.w // 2, room.centery), "button": 1}
    app.handle(pygame.event.Event(pygame.MOUSEBUTTONDOWN, middle))
    assert app.session.readout_time == pytest.approx(0.5 * length, rel=0.02)
    quarter = {"pos": (room.x + room.w // 4, room.centery), "buttons": (1, 0, 0), "rel": (0, 0)}
    app.handle(pygame.event.Event(pygame.MOUSEMOTION, quarter))
    assert app.session.readout_time == pytest.approx(0.25 * length, rel=0.04)


@pytest.mark.parametrize("scene", ["lab:pi", "lab:cradle", "sinai", "lab:thesis-swap"])
def test_graphs_of_a_shot_without_an_end_go_on_with_it(scene):
    app = an_app(size=(1280, 720))
    press(app, "f8")
    app.perform(Action("scene", scene))
    for _ in range(400):
        app.frame(FRAME)
    assert not app.session.over
    assert graphs._SEEN.get(app.session).duration >= app.session.readout_time


def test_graphs_and_rivals_are_the_players_own_and_in_no_record():
    assert not {"graphs", "compare", "export"} & {*RECORDED}


# -- laws compared -------------------------------------------------------------------------------


@pytest.mark.parametrize("table", ["medium", "match", "pool-9"])
def test_a_shot_laid_again_as_it_began_ends_where_it_did_to_the_bit(table):
    session = shot_at_rest(table)
    again = session.world.fork(session.world.log.fresh())
    again.recall(compared.lay(session.world, session.began))
    again.run()
    assert [b.position for b in again.balls] == [b.position for b in session.world.balls]


def test_each_other_law_and_engine_is_a_rival_that_plays_the_same_shot():
    session = shot_at_rest()
    found = rivals_of(session)
    assert [(r.kind, r.key) for r in found] == [
        ("law", "thesis"), ("law", "mathavan"), ("engine", "thesis"),
    ]  # fmt: skip
    before = presets.table_world("medium")
    shot = Session(presets.table_world("medium")).aim.shot
    perform_law = Session(before)
    perform(perform_law, Action("law", "mathavan"))
    by_hand = simulate(perform_law.world, "white", shot)
    mathavan = found[1]
    assert mathavan.ends == {ball.name: ball.position for ball in by_hand.balls}
    off = dist(mathavan.ends["white"], session.world.ball("white").position)
    assert mathavan.cue == pytest.approx(off)
    assert mathavan.most >= mathavan.cue > 0.01


def test_the_shot_itself_is_not_changed_by_being_compared():
    session = shot_at_rest()
    before = session.world.layout(), len(session.world.log), session.world.engine
    rivals_of(session)
    assert (session.world.layout(), len(session.world.log), session.world.engine) == before


def test_a_table_with_laws_of_its_own_is_compared_with_all_sets():
    session = Session(presets.scene_world("lab:unknown-mass"), table="lab:unknown-mass")
    perform(session, Action("skip"))
    found = rivals_of(session)
    assert [r.key for r in found] == ["rigid", "thesis", "mathavan", "thesis"]
    assert len(found) <= len(INKS) == len(DASHES)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_key_draws_rivals_over_the_shot_once_it_is_at_rest(language):
    app = after_a_shot()
    app.perform(Action("language", language))
    app.frame(FRAME)
    bed = app.view.sight.layout.bed
    plain = pygame.image.tobytes(app.canvas.surface.subsurface(bed), "RGB")
    press(app, "x")
    assert app.preferences.settings.compare
    assert pygame.image.tobytes(app.canvas.surface.subsurface(bed), "RGB") != plain
    assert_same_as_anew(app)
    press(app, "x")
    assert pygame.image.tobytes(app.canvas.surface.subsurface(bed), "RGB") == plain


def test_nothing_is_compared_while_balls_move_or_before_a_shot(monkeypatch):
    def refuse(*_):
        raise AssertionError("nothing is to be compared")

    monkeypatch.setattr("game.ui.table.rival_lines.rivals", refuse)
    app = an_app()
    press(app, "x", "return")
    app.frame(FRAME)
    assert app.session.moving
