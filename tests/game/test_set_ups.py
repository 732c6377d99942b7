"""Set-ups: balls placed by hand, lines of text, files that may be broken."""

from itertools import combinations
from math import dist, nextafter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.aim.entry import START
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.table import presets
from game.table.library import Library
from game.table.lineup import LineError, Lineup, read, shelf
from game.table.placing import GAP, slid
from game.ui.pages.shelf import laid
from physics import Ball, tables

LINE = "danggu1 medium white=-0.5,0.0 red1=0.5,0.25 shot=3,0.5,0,-1,12.5"
SPOT = st.tuples(st.floats(-1.5, 1.5), st.floats(-0.9, 0.9))


def assert_all_lie_free(world):
    for ball in world.balls:
        assert min(wall.distance(ball.position) for wall in world.walls) >= ball.radius
    for a, b in combinations(world.balls, 2):
        assert dist(a.position, b.position) >= a.radius + b.radius - 1e-12  # racks touch


# -- placing -------------------------------------------------------------------------------------


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(st.sampled_from(["white", "yellow", "red1", "red2"]), SPOT), max_size=12))
def test_balls_dragged_anywhere_never_overlap_and_never_leave_the_table(moves):
    session = Session(presets.table_world("medium"))
    perform(session, Action("arrange"))
    for name, (x, y) in moves:
        perform(session, Action("hold", name))
        perform(session, Action("move", f"{x!r} {y!r}"))
        assert_all_lie_free(session.world)


def test_a_ball_is_laid_down_beside_a_smaller_one_where_they_touch():
    world = tables.medium_carom()
    big = world.add(Ball("big", (-0.5, 0.0), radius=0.04))
    small = world.add(Ball("small", (0.0, 0.0), radius=0.02))
    big.position = slid(world, "big", (-0.01, 0.0))
    assert dist(big.position, small.position) == pytest.approx(0.0565685 + GAP, abs=1e-7)
    world.run()  # it lies there


@settings(max_examples=60, deadline=None)
@given(SPOT)
def test_a_ball_goes_where_it_is_dragged_if_there_is_room_and_else_no_farther_away_than_needed(to):
    world = presets.table_world("medium")
    white, found = world.ball("white"), complex(*slid(world, "white", to))
    others = [ball for ball in world.balls if ball is not white]
    gaps = [dist(to, ball.position) - ball.radius - white.radius for ball in others]
    gaps += [wall.distance(to) - white.radius for wall in world.walls]
    away = abs(found - complex(*to))
    if min(gaps) > GAP:
        assert away == 0.0
    else:
        # in a corner, or between a wall and a ball, the way is longer than each gap alone
        assert away >= -min(gaps)
        assert away <= 3 * 0.07 + sum(max(0.0, -gap) for gap in gaps)


def test_a_ball_that_is_dragged_along_a_cushion_slides_on_it():
    world = presets.table_world("medium")
    x, y = slid(world, "white", (0.3, 2.0))
    assert x == 0.3
    assert y == pytest.approx(tables.MEDIUM_CAROM.width / 2 - 0.03275 - GAP, abs=1e-9)


def test_a_ball_dragged_onto_another_slides_around_it():
    world = presets.table_world("medium")
    x, y = world.ball("red1").position
    found = slid(world, "white", (x + 0.01, y + 0.01))
    assert dist(found, (x, y)) == pytest.approx(2 * 0.03275 + GAP, abs=1e-9)
    assert found[0] - x == pytest.approx(found[1] - y)


def test_one_drag_is_one_step_to_undo():
    session = Session(presets.table_world("medium"))
    before = [ball.position for ball in session.world.balls]
    perform(session, Action("arrange"))
    perform(session, Action("hold", "red1"))
    for k in range(20):
        perform(session, Action("move", f"{0.02 * k} 0.1"))
    perform(session, Action("arrange"))
    perform(session, Action("undo"))
    assert [ball.position for ball in session.world.balls] == before


# -- lines ---------------------------------------------------------------------------------------


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 10**6), st.sampled_from(["thesis", "medium", "match"]))
def test_a_line_brings_back_every_ball_to_the_last_bit(seed, table):
    session = Session(presets.table_world(table), seed=seed, table=table)
    perform(session, Action("place"))
    before = laid(session, shot=True)
    again = Session(presets.table_world("medium"))
    perform(again, Action("line", before.line()))
    assert laid(again, shot=True) == before
    assert again.table == table


def test_a_line_with_a_shot_plays_the_same_shot():
    ends = []
    for line in (LINE, read(LINE).line()):
        session = Session(presets.table_world("match"), table="match")
        perform(session, Action("line", line))
        assert session.aim.texts == ["3", "0.5", "0", "-1", "12.5"]
        perform(session, Action("fire"))
        perform(session, Action("skip"))
        ends.append([ball.position for ball in session.world.balls])
    assert ends[0] == ends[1]


def test_a_line_without_a_shot_leaves_the_boxes_alone():
    session = Session(presets.table_world("medium"))
    perform(session, Action("line", laid(session, shot=False).line()))
    assert session.aim.texts == list(START)


@pytest.mark.parametrize("ready", list(shelf()), ids=lambda r: f"{r.group}-{r.key}")
def test_every_set_up_of_the_shelf_is_a_good_line(ready):
    if ready.group == "scenes":
        session = Session(presets.table_world("medium"))
        perform(session, Action("scene", ready.key))
        assert {ball.name for ball in session.world.balls} == {
            name for name, _ in ready.lineup.balls
        }
    else:
        assert read(ready.lineup.line()) == ready.lineup
        assert_all_lie_free(ready.lineup.world())


R = 0.03275
BROKEN = [
    ("", "mark", ""),
    ("hello", "mark", "hello"),
    ("danggu2 medium white=0,0", "mark", "danggu2"),
    ("danggu1", "table", ""),
    ("danggu1 moon white=0,0", "table", "moon"),
    ("danggu1 medium", "missing", "white"),
    ("danggu1 medium white=0", "ball", "white=0"),
    ("danggu1 medium white=0,nan", "ball", "white=0,nan"),
    ("danggu1 medium white=0,x", "ball", "white=0,x"),
    ("danggu1 medium =0,0", "ball", "=0,0"),
    ("danggu1 medium purple=0,0", "name", "purple"),
    ("danggu1 medium white=0,0 white=0.5,0", "twice", "white"),
    ("danggu1 medium white=1.27,0", "outside", "white"),
    (f"danggu1 medium white=0,0 red1={nextafter(2 * R - 1e-8, 0)!r},0", "overlap", "white, red1"),
    ("danggu1 medium white=0,0 shot=1,2,3", "shot", "shot=1,2,3"),
    ("danggu1 medium white=0,0 shot=0,0,0,0,0", "shot", "shot=0,0,0,0,0"),
    ("danggu1 thesis_3a red=0,0", "missing", "yellow"),
    ("danggu1 medium " + "white=0,0 " * 1000, "mark", "danggu1"),
]


@pytest.mark.parametrize(("line", "reason", "word"), BROKEN)
def test_a_broken_line_says_what_is_wrong_and_changes_nothing(line, reason, word):
    with pytest.raises(LineError) as caught:
        read(line)
    assert (caught.value.reason, caught.value.word) == (reason, word)
    session = Session(presets.table_world("medium"))
    world, before = session.world, laid(session, shot=False)
    with pytest.raises(LineError):
        perform(session, Action("line", line))
    assert session.world is world
    assert laid(session, shot=False) == before


# -- files ---------------------------------------------------------------------------------------


def test_set_ups_saved_by_name_are_there_the_next_time(tmp_path):
    path = tmp_path / "deep" / "set-ups.json"
    lineup = read(LINE)
    assert Library(path).put("  내  배치 ", lineup)
    found = Library(path)
    assert found.items == {"내 배치": lineup}
    assert found.put("other", lineup)
    assert found.remove("내 배치")
    assert list(Library(path).items) == ["other"]
    assert [p.name for p in path.parent.iterdir()] == ["set-ups.json"]


@pytest.mark.parametrize("text", ["", "{", "[]", '{"format": "danggu set-ups"}', "\0", "[" * 9999])
def test_a_broken_file_is_kept_beside_and_does_not_stop_anybody(tmp_path, text):
    path = tmp_path / "set-ups.json"
    path.write_text(text, encoding="utf-8")
    library = Library(path)
    assert library.items == {}
    assert library.faulty
    assert library.put("new", read(LINE))
    assert (tmp_path / "set-ups.json.broken").read_text(encoding="utf-8") == text
    assert list(Library(path).items) == ["new"]


def test_one_broken_set_up_does_not_lose_the_others(tmp_path):
    path = tmp_path / "set-ups.json"
    Library(path).put("good", read(LINE))
    text = path.read_text(encoding="utf-8").replace('"good"', '"bad": "danggu1 x", "good"')
    path.write_text(text, encoding="utf-8")
    library = Library(path)
    assert list(library.items) == ["good"]
    assert library.faulty == 1


def test_where_nothing_can_be_written_saving_says_so(tmp_path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    library = Library(tmp_path / "file" / "set-ups.json")
    assert not library.put("name", read(LINE))
    assert not library.put("   ", read(LINE))


def test_a_set_up_is_a_value():
    assert read(LINE) == Lineup(
        "medium", (("white", (-0.5, 0.0)), ("red1", (0.5, 0.25))), ("3", "0.5", "0", "-1", "12.5")
    )
