"""A path drawn with the mouse becomes the shot in the boxes, without holding the frames up."""

import time

import pygame
import pytest

from game.aim import drawn_path
from game.computer.worker import News
from game.session.action import Action
from game.session.commands import RECORDED, fault, perform
from game.session.session import Session
from game.table import presets
from physics import simulate
from tests.support.players import FRAME, an_app, press, run_to_rest

FOUND = "2.5 0.5 0 0.25 30 0.8 0.3 0.1 0.4 100"
BUTTON = {pygame.MOUSEBUTTONDOWN: 1, pygame.MOUSEBUTTONUP: 1, pygame.MOUSEMOTION: 0}


class Instant:
    """A worker that is done at once, in this process."""

    def __init__(self, work, *given):
        self.news, self.cancelled = News("done", work(lambda value: None, *given)), False

    def look(self):
        return self.news

    def cancel(self):
        self.cancelled = True


class Never(Instant):
    """A worker that is never done."""

    def __init__(self, work, *given):
        self.news, self.cancelled = None, False


def draw(app, places, release=True):
    """Draw a path through places of the table, m, with the left button held."""
    layout = app.view.sight.layout
    kinds = [pygame.MOUSEBUTTONDOWN, *[pygame.MOUSEMOTION] * (len(places) - 1)]
    last = places[-1]
    events = [*zip(kinds, places, strict=True), *[(pygame.MOUSEBUTTONUP, last)] * release]
    for kind, place in [(pygame.MOUSEMOTION, places[0]), *events]:
        at = tuple(round(x) for x in layout.to_screen(*place))
        app.handle(pygame.event.Event(kind, pos=at, button=BUTTON[kind], buttons=(1, 0, 0)))
    app.frame(0)


def path_of(session, until=1.0):
    """Where the cue ball runs with the shot in the boxes."""
    after = simulate(session.world, session.cue, session.aim.shot)
    times = [until * k / 60 for k in range(61)]
    return [after.log.at(t)[session.cue].position for t in times]


@pytest.fixture
def app():
    app = an_app(table="match")
    app.perform(Action("set", "speed 3 follow 1 side 0 angle 25"))
    return app


def test_a_drawn_path_gives_its_shot_and_undo_gives_the_boxes_back(app, monkeypatch):
    monkeypatch.setattr("game.ui.table.sketch.Worker", Instant)
    session = app.session
    path = path_of(session)
    app.perform(Action("set", "speed 1 follow 0 side 0 angle 200"))
    before = list(session.aim.texts)
    press(app, "g")
    draw(app, path)
    assert session.notice.key == "sketch.found"
    assert float(session.notice.about.split()[0]) < 1.5
    assert session.aim.complete
    assert session.aim.shot.angle == pytest.approx(25.0, abs=0.5)
    assert app.view.sketch.points  # the preview lies beside it
    press(app, "z")
    assert session.aim.texts == before
    press(app, "y")
    assert session.aim.shot.angle == pytest.approx(25.0, abs=0.5)


def test_the_search_runs_beside_the_frames_in_another_process(app):
    session = app.session
    path = path_of(session, 0.4)
    app.perform(Action("set", "angle 200"))
    press(app, "g")
    draw(app, path)
    assert session.notice.key == "sketch.searching"
    end, frames = time.monotonic() + 30.0, 0
    while app.view.sketch.searching and time.monotonic() < end:
        app.frame(FRAME)
        time.sleep(0.01)
        frames += 1
    assert frames > 10
    assert session.aim.shot.angle == pytest.approx(25.0, abs=0.5)


def test_escape_stops_the_search_and_the_next_one_ends_drawing(app, monkeypatch):
    monkeypatch.setattr("game.ui.table.sketch.Worker", Never)
    texts = list(app.session.aim.texts)
    press(app, "g")
    draw(app, path_of(app.session))
    worker = app.view.sketch._worker
    press(app, "escape")
    assert worker.cancelled
    assert app.session.notice.key == "sketch.cancelled"
    assert app.session.sketching
    press(app, "escape")
    assert not app.session.sketching
    assert app.session.page == ""
    assert app.session.aim.texts == texts


def test_what_cannot_be_found_says_so_and_leaves_the_boxes(app, monkeypatch):
    monkeypatch.setattr(
        drawn_path, "recover_drawn", lambda *given: drawn_by_nobody(misfit=0.16, share=0.9)
    )
    monkeypatch.setattr("game.ui.table.sketch.Worker", Instant)
    texts = list(app.session.aim.texts)
    press(app, "g")
    draw(app, path_of(app.session))
    assert (app.session.notice.key, app.session.notice.about) == ("sketch.none", "16")
    assert app.session.notice.error
    assert app.session.aim.texts == texts
    assert not app.session.history.past


def drawn_by_nobody(misfit, share):
    from physics import Drawn, Shot

    return Drawn(Shot(1.0), None, misfit, share)


@pytest.mark.parametrize(
    ("places", "said"),
    [([(0.5, 0.3), (0.9, 0.3)], "sketch.start"), ([None, None], "sketch.short")],
)
def test_a_path_that_is_none_is_not_looked_for(app, places, said):
    ball = app.session.world.ball(app.session.cue).position
    press(app, "g")
    draw(app, [at or ball for at in places])
    assert app.session.notice.key == said
    assert not app.view.sketch.searching


def test_a_stroke_ends_drawing_and_forgets_the_path(app, monkeypatch):
    monkeypatch.setattr("game.ui.table.sketch.Worker", Never)
    press(app, "g")
    draw(app, path_of(app.session))
    worker = app.view.sketch._worker
    press(app, "return")
    assert app.session.moving
    assert not app.session.sketching
    assert worker.cancelled
    assert not app.view.sketch.points
    run_to_rest(app)


def test_a_button_let_go_outside_the_window_ends_the_path(app, monkeypatch):
    monkeypatch.setattr("game.ui.table.sketch.Worker", Never)
    press(app, "g")
    draw(app, path_of(app.session), release=False)
    assert app.view.sketch.drawing
    app.handle(pygame.event.Event(pygame.MOUSEMOTION, pos=(300, 200), buttons=(0, 0, 0)))
    assert not app.view.sketch.drawing
    assert app.view.sketch.searching


def test_a_record_has_the_shot_that_was_found_and_not_the_search():
    session = Session(presets.table_world("medium"))
    for action in (Action("sketch"), Action("recover", FOUND)):
        assert action.name in RECORDED
        assert not fault(action)
        perform(session, action)
    assert session.aim.texts == FOUND.split()[:5]
    assert (session.notice.key, session.notice.error) == ("sketch.found", False)
    assert fault(Action("recover", "2.5 0.5 0 0.25 30"))


def test_a_shot_found_while_balls_move_is_not_written():
    session = Session(presets.table_world("medium"))
    perform(session, Action("shoot"))
    texts = list(session.aim.texts)
    perform(session, Action("recover", FOUND))
    perform(session, Action("sketch"))
    assert session.aim.texts == texts
    assert not session.sketching
