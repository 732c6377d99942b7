"""Whatever a player does to the balls, in any state and with any engine, the game goes on."""

from itertools import combinations
from math import dist
from pathlib import Path

import pytest

from game import __main__ as entry
from game.aim.preview import rests
from game.input.captions import words
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Notice, Session
from game.session.terms import FOUR_BALL, Contestant, Terms
from game.session.ticks import TICKS
from game.session.timeline import HEEDED
from game.table import presets
from game.table.presets import scene_world, table_world
from game.ui.pages.shelf import laid
from game.ui.panels.shot_panels import log_rows
from physics import EventDriven, Placed, Shot
from physics.engines.stepping import SCHEMES
from tests.support.anything import engines
from tests.support.players import FRAME, an_app, assert_same_as_anew, places, press, run_to_rest

SCRIPT = Path(__file__).parents[1] / "data" / "rack_stop_undo.txt"


def rack(scheme="thesis"):
    """A rack that has just been broken by fixed steps, stopped while its balls overlap."""
    session = Session(scene_world("rack15"), table="rack15")
    perform(session, Action("engine", "thesis"))
    perform(session, Action("stop"))
    while not overlap(session.world):
        perform(session, Action("retry"))
        session.advance(session.rng.randrange(TICKS // 5, TICKS // 2))
        perform(session, Action("stop"))
    return session


def overlap(world):
    return any(
        dist(a.position, b.position) < a.radius + b.radius - 1e-9
        for a, b in combinations(world.balls, 2)
    )


def do(session, *names):
    for name in names:
        perform(session, Action(*name) if isinstance(name, tuple) else Action(name))


def test_a_stopped_rack_can_be_undone_after_placing():
    said = ["--scene", "rack15", "--engine", "thesis", "--script", str(SCRIPT), "--frames", "300"]
    assert entry.main(said) == 0


# what locates contacts within a step takes longest, and undoes alike in test_anything.py
@pytest.mark.parametrize(
    "scheme",
    [pytest.param(s, marks=[pytest.mark.stress] * (s == "rk4-located")) for s in SCHEMES],
)
def test_twenty_stops_retries_and_undos_of_a_rack_give_back_the_digits(scheme):
    with engines(scheme):
        session = Session(scene_world("rack15"), table="rack15")
        do(session, ("engine", "thesis"), "stop")
        for k in range(0, 60, 3):
            before = session.world.layout()
            do(session, ("set", f"speed {6 + 0.05 * k} angle {-3 + 0.1 * k}"), "shoot")
            session.advance(TICKS // 8 + 97 * k)
            do(session, "stop")
            after = session.world.layout()
            do(session, "place", "undo")
            assert session.world.layout() == after
            do(session, "retry")
            assert session.world.layout() == before
            do(session, "undo")
            assert session.world.layout() == after
            if k % 7 == 0:
                do(session, "undo", "undo", "redo", "redo")


def test_another_engine_plays_on_from_balls_that_overlap_and_leaves_none():
    session = rack()
    do(session, ("engine", "exact"), "fire")
    session.advance(TICKS // 4)
    assert not overlap(session.world)
    do(session, "skip", ("engine", "thesis"), "undo", "redo", "retry")


def test_a_ball_is_placed_by_hand_among_balls_that_overlap():
    session = rack()
    for engine in ("thesis", "exact"):
        do(session, ("engine", engine), "arrange", ("hold", "cue"), ("move", "-0.9 0.5"))
        assert session.world.ball("cue").position == (-0.9, 0.5)
        do(session, "arrange", "undo")


def test_a_set_up_of_balls_that_overlap_is_copied_as_one_that_can_be_read():
    session = rack()
    line = laid(session, shot=True).line()
    do(session, ("line", line))
    assert not overlap(session.world)


def test_a_match_begun_while_balls_roll_leaves_nothing_to_undo():
    app = an_app(game="four-ball")
    press(app, "ctrl+return", "end", "return", "ctrl+return")
    app.frame(10 * FRAME)
    assert app.session.moving
    assert app.session.history.past
    app.perform(Action("match", Terms("three-cushion", table="match").line()), sure=True)
    press(app, "z", "y", "r")
    assert len(app.session.world.balls) == 3


def test_balls_are_placed_at_random_where_a_wall_takes_half_the_table_or_not_at_all():
    for seed in range(8):
        session = Session(scene_world("pi_collisions"), seed=seed)
        do(session, "place")
        assert session.notice is None
        assert all(ball.position[0] > 0.0 for ball in session.world.balls)


def test_without_room_no_ball_is_placed(monkeypatch):
    session = Session(table_world("medium"))
    monkeypatch.setattr(presets, "_fits", lambda *_: False)
    before = session.world.layout()
    do(session, "place")
    assert session.notice == Notice("refused.room", error=True)
    assert session.world.layout() == before


def test_an_engine_that_fails_puts_the_balls_back_and_says_so(monkeypatch):
    session = Session(table_world("medium"))
    before = session.world.layout()
    do(session, "fire")

    def fails(self, world, until):
        raise ZeroDivisionError("of a law")

    monkeypatch.setattr(EventDriven, "advance", fails)
    with pytest.warns(RuntimeWarning, match="of a law"):
        session.advance(TICKS)
    assert not session.moving
    assert session.world.layout() == before
    assert session.notice == Notice("failed", error=True)
    assert session.preview is None
    monkeypatch.undo()
    do(session, "undo", "retry", "shoot")
    assert session.moving


def test_what_never_ends_has_no_preview_and_is_not_skipped_for_ever():
    with engines("literal"):
        session = Session(table_world("medium"))
        do(session, ("engine", "thesis"))
        assert not rests(session.world)
        assert session.preview is None
        do(session, "fire", "skip")
        assert session.world.time == pytest.approx(5.0)
        do(session, "stop")
        assert not session.moving


def test_what_the_computer_struck_is_done_again_though_the_boxes_could_not_be_read():
    session = Session(table_world("medium"))
    do(session, ("match", Terms(FOUR_BALL, (Contestant(), Contestant())).line()))
    do(session, "edit", ("type", "-"), ("play", "2 0 0 0 10"), "skip")
    lies = session.world.layout()
    do(session, "undo", "redo")
    assert session.world.layout() == lies


# -- what waits for shots that leave the cloth


@pytest.fixture
def jumping():
    with engines("exact", jumps=True):
        yield Session(table_world("medium"))


def off_the_table(session):
    """Shoot the cue ball over a cushion."""
    do(session, ("set", "speed 8 follow 0 masse 0 side 0 angle 200"), "shoot", "skip")
    assert session.world.ball("white").phase == "off"


def test_a_ball_off_the_table_does_not_move_and_cannot_be_struck(jumping):
    off_the_table(jumping)
    assert not jumping.moving
    do(jumping, "fire")
    assert jumping.notice == Notice("refused.off", error=True)
    assert jumping.preview is None
    do(jumping, "retry", "shoot")
    assert jumping.moving


def test_an_event_that_the_log_has_no_words_for_is_passed_over(jumping):
    """A ball that left the table was told of as one that comes to rest."""
    off_the_table(jumping)
    kinds = [event.kind for event in jumping.world.log]
    assert "off" in kinds
    said = [row.first for row in log_rows(jumping, words("en"))]
    rests = [row for row in said if row.endswith(words("en")["event.rest"])]
    assert len(rests) == kinds.count("rest")
    assert len(said) == 1 + sum(kind in HEEDED for kind in kinds)


def test_fixed_steps_are_refused_while_a_ball_flies_or_is_off_the_table(jumping):
    do(jumping, "fire")
    jumping.advance(TICKS // 20)
    assert "airborne" in {ball.phase for ball in jumping.world.balls}
    for _ in range(2):
        do(jumping, "engine")
        assert (jumping.engine, jumping.notice) == ("exact", Notice("refused.flight", error=True))
        do(jumping, "retry")
        off_the_table(jumping)


def test_under_fixed_steps_no_shot_leaves_the_cloth_and_undo_takes_the_exact_engine(jumping):
    do(jumping, "fire")
    jumping.advance(TICKS // 20)
    flying = jumping.world.layout()
    do(jumping, "stop", "skip", ("engine", "thesis"), "fire")
    assert jumping.notice == Notice("refused.flight", error=True)
    do(jumping, "undo")
    assert jumping.world.layout() == flying
    assert jumping.engine == "exact"


def test_in_a_match_a_ball_off_the_table_is_spotted(jumping):
    do(jumping, ("match", Terms(FOUR_BALL).line()))
    spot = jumping.world.ball("white").position
    do(jumping, ("set", "speed 8 follow 0 masse 0 side 0 angle 170"), "shoot", "skip")
    assert jumping.contest.verdict.reason == "off_table"
    assert jumping.world.ball("white").position == spot
    assert not jumping.moving
    do(jumping, "next", "fire")
    assert jumping.moving


# -- pictures that random input found wrong


def test_a_trace_is_whole_when_a_replay_has_caught_up_with_the_balls():
    app = an_app()
    press(app, "return")
    for _ in range(75):
        app.frame(FRAME)
    app.perform(Action("back"))
    press(app, "p")
    for _ in range(8):
        app.frame(FRAME)
    assert app.session.timeline.at is None
    assert app.session.moving
    assert_same_as_anew(app)


@pytest.mark.parametrize("page", [Action("help"), Action("sheet", "rules")])
def test_a_page_closed_and_opened_again_within_a_frame_shows_what_is_behind_it_now(page):
    app = an_app()
    app.perform(page)
    app.frame(FRAME)
    app.perform(page)
    app.perform(Action("set", "angle 200 speed 1"))
    app.perform(page)
    app.frame(FRAME)
    assert_same_as_anew(app)


def test_a_layout_with_a_ball_beyond_every_cushion_is_shown_and_mended():
    app = an_app()
    layout = app.session.world.layout()
    app.session.put([Placed(100.0 - 70.0j), *layout[1:]])
    app.session.version += 1
    app.frame(FRAME)
    assert_same_as_anew(app)
    app.perform(Action("set", "angle 90"))
    app.session.world.strike("yellow", Shot(1.0))
    app.session.world.run()
    assert max(map(abs, places(app.session)[0])) < 1.27
    run_to_rest(app)
