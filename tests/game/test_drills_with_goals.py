"""Drills in the window: laid from the shelf, judged stroke by stroke, with a best that is kept."""

import json

import pytest

from danggu.players.goals import GOALS, POSITIONS, ZONE
from game.practice.book import Book, Reached
from game.practice.trainer import AWAY, OVER, READY
from game.session.action import Action
from game.table import drill_lies
from game.ui.pages import shelf_view
from game.ui.table import zone_marks
from tests.support.players import FRAME, an_app, assert_same_as_anew, press


def laid(drill, **options):
    app = an_app(**options)
    app.perform(Action("drill", drill))
    app.frame(FRAME)
    return app


def play(app, answer):
    """Play a stroke of (angle, speed, right, up) to its end."""
    angle, speed, right, up = answer
    spins = f"follow {2.5 * speed * up} masse 0 side {2.5 * speed * right}"
    app.perform(Action("set", f"speed {speed} {spins} angle {angle}"))
    # the boxes are written with two places: the answers have more
    texts = [f"{speed:g}", f"{2.5 * speed * up:.4g}", "0", f"{2.5 * speed * right:.4g}"]
    app.session.aim.texts[:] = [*texts, f"{angle:g}"]
    for name in ("fire", "skip"):
        app.perform(Action(name))
    app.frame(FRAME)


MISS = 200.0, 0.3, 0.0, 0.0


@pytest.mark.parametrize("drill", GOALS)
def test_every_drill_is_laid_with_a_cue_that_does_not_know_the_answer(drill):
    app = laid(drill)
    trainer = app.view.trainer
    assert (trainer.drill, trainer.state) == (drill, READY)
    assert app.session.aim.complete
    assert dict(drill_lies.laid(drill).balls) == {
        ball.name: ball.position for ball in app.session.world.balls
    }
    assert_same_as_anew(app)


def test_a_zone_is_drawn_and_worth_three_stars_in_its_middle():
    app = laid("pool.stop")
    assert zone_marks.key(app.view.trainer) == "pool.stop"
    play(app, POSITIONS["pool.stop"].answer)
    trainer = app.view.trainer
    assert (trainer.result.made, trainer.result.stars, trainer.state) == (True, 3, AWAY)
    assert trainer.reached == Reached(3, trainer.result.off, 1, 1)
    assert app.view.toast.stars == 3
    assert_same_as_anew(app)
    press(app, "r")
    assert trainer.state == READY
    play(app, MISS)
    assert (trainer.result.made, trainer.reached.stars, trainer.reached.tries) == (False, 3, 2)


def test_a_row_counts_on_from_the_same_lie_and_ends_with_a_miss():
    app = laid("pool.cut_45")
    trainer, counts = app.view.trainer, []
    for answer in (POSITIONS["pool.cut_45"].answer,) * 3 + (MISS,):
        play(app, answer)
        counts.append((trainer.count, trainer.result.stars))
        press(app, "r")
        assert trainer.state == READY
    assert counts == [(1, 1), (2, 1), (3, 2), (0, 0)]
    assert (trainer.reached.best, trainer.reached.stars) == (3, 2)


def test_a_stroke_from_another_lie_does_not_count():
    app = laid("pool.cut_45")
    trainer = app.view.trainer
    play(app, MISS)
    play(app, MISS)
    assert (trainer.state, trainer.reached.tries) == (AWAY, 1)
    press(app, "r")
    assert trainer.state == READY
    assert dict(drill_lies.laid("pool.cut_45").balls) == {
        ball.name: ball.position for ball in app.session.world.balls
    }
    press(app, "down")
    app.frame(FRAME)
    assert trainer.state == AWAY


def test_a_stroke_that_is_taken_back_begins_a_run_again():
    app = laid("sagu.gather")
    trainer = app.view.trainer
    play(app, POSITIONS["sagu.gather"].answer)
    assert (trainer.state, trainer.count, trainer.result.made) == (READY, 1, True)
    press(app, "ctrl+z")
    assert trainer.count == 0
    play(app, POSITIONS["sagu.gather"].answer)
    assert trainer.count == 1
    play(app, MISS)
    assert trainer.state == OVER
    assert (trainer.reached.best, trainer.reached.stars) == (1, 0)
    press(app, "r")
    assert (trainer.state, trainer.count) == (READY, 0)
    assert dict(drill_lies.laid("sagu.gather").balls) == {
        ball.name: ball.position for ball in app.session.world.balls
    }


def test_a_table_is_cleared_in_counted_strokes_and_a_miss_ends_it():
    app = laid("pool.position")
    trainer = app.view.trainer
    play(app, POSITIONS["pool.position"].answer)
    assert trainer.result.made
    assert (trainer.count, trainer.state) == (1, READY)
    play(app, (0.0, 0.05, 0.0, 0.0))
    assert trainer.state == OVER
    assert trainer.reached == Reached(0, None, 1, 0)


def test_something_else_on_the_table_is_no_drill_any_more():
    for action in (Action("table", "match"), Action("scene", "thesis_1")):
        app = laid("sagu.follow")
        app.perform(action)
        assert app.view.trainer.drill == ""
        app.frame(FRAME)
        assert_same_as_anew(app)


def test_the_shelf_shows_the_stars_and_lays_a_drill():
    app = an_app()
    app.view.trainer.book.add("sagu.follow", 2, 3.0, made=True)
    press(app, "f4")
    page = app.view.page
    cards = page.cards
    assert [card.stars for card in cards if card.drill == "sagu.follow"] == [2]
    assert all(card.drill for card in cards)
    app.frame(FRAME)
    assert_same_as_anew(app)
    press(app, "return")
    assert app.view.trainer.drill == "sagu.opening"
    press(app, "f4", "right", "right", "return", "f4")
    page = app.view.page
    assert page.cards[page.focus].drill == app.view.trainer.drill != "sagu.opening"


@pytest.mark.parametrize("language", ["en", "ko"])
@pytest.mark.parametrize("size", [(640, 360), (1280, 720)])
def test_the_goal_fits_the_row_above_the_table_and_the_foot_of_the_shelf(size, language):
    from game.ui.panels import drill_words

    app = laid("pool.stop", size=size, lang=language)
    sight, w = app.view.sight, app.view.sight.words
    layout = sight.layout
    head = layout.score[0].union(layout.score[2])
    room = head.w - (16 + 16 + 8 + 3 * drill_words.NUMBER) * layout.s
    for drill in GOALS:
        assert sight.type.width(drill_words.goal(drill, w), 12) <= room, drill
    assert shelf_view.GROUPS


# -- the best that is kept -----------------------------------------------------------------------


def test_what_is_reached_is_kept_and_two_games_add_up(tmp_path):
    path = tmp_path / "drills.json"
    one, two = Book(path), Book(path)
    assert one.of("pool.stop") == two.of("pool.stop") == Reached()
    one.add("pool.stop", 2, 0.12, made=True)
    two.add("pool.stop", 1, 0.3, made=True)
    two.add("pool.draw", 0, None, made=False)
    assert Book(path).of("pool.stop") == Reached(2, 0.12, 2, 2)
    assert Book(path).of("pool.draw") == Reached(0, None, 1, 0)
    assert [file.name for file in tmp_path.iterdir()] == ["drills.json"]


def test_a_broken_book_is_kept_beside_and_a_drill_of_a_later_game_stays(tmp_path):
    path = tmp_path / "drills.json"
    later = {"stars": 3, "best": 5.0, "tries": 9, "made": 8}
    document = {"format": "danggu drills", "version": 1, "drills": {"new.one": later, "x": 7}}
    path.write_text(json.dumps(document))
    Book(path).add("pool.stop", 1, 0.2, made=True)
    assert path.with_name("drills.json.broken").exists()
    assert {*json.loads(path.read_text())["drills"]} == {"new.one", "pool.stop"}


@pytest.mark.parametrize(
    "best", [10**400, -1, True, "0.1", float("nan"), float("inf")], ids=lambda best: str(best)[:5]
)
def test_a_best_that_is_no_number_of_a_drill_is_not_taken(tmp_path, best):
    path = tmp_path / "drills.json"
    drills = {"pool.stop": {"stars": 1, "best": best, "tries": 1, "made": 1}}
    path.write_text(json.dumps({"format": "danggu drills", "version": 1, "drills": drills}))
    book = Book(path)
    assert book.of("pool.stop") == Reached()
    assert book.faulty


def test_without_room_the_best_is_known_until_the_game_ends(tmp_path):
    (tmp_path / "file").write_text("")
    book = Book(tmp_path / "file" / "drills.json")
    book.add("pool.stop", 3, 0.01, made=True)
    assert book.trouble
    assert book.of("pool.stop") == Reached(3, 0.01, 1, 1)


def test_nearer_and_fewer_and_more_are_better():
    zone = next(name for name, goal in GOALS.items() if goal.kind == ZONE)
    assert Reached(1, 0.2).plus(zone, 2, 0.1, made=True).best == 0.1
    assert Reached(1, 0.1).plus(zone, 2, 0.2, made=True).best == 0.1
    assert Reached(1, 4).plus("pool.position", 2, 3, made=True).best == 3
    assert Reached(1, 4).plus("pool.cut_45", 2, 3, made=True).best == 4
