"""The coach beside the table: it is asked, shows ways to score, and forgets them in time."""

import time
from dataclasses import replace

import pytest

from danggu.players.levels import EXPERT, Attempt
from danggu.players.solution import Solution, Thickness, Tip
from danggu.rules import GAMES
from danggu.rules.state import Call
from danggu.rules.verdict import Turn
from game.aim import advice
from game.computer import search
from game.computer.advised import Advised
from game.computer.aide import Aide
from game.computer.worker import News
from game.input.captions import words
from game.render.font import Type
from game.render.parts import fields
from game.session.action import Action
from game.session.commands import RECORDED, fault, perform
from game.session.match_commands import pockets
from game.session.session import Session
from game.session.terms import Contestant, Terms
from game.table import presets
from game.text import LANGUAGES
from game.ui.coach import LONG, played
from game.ui.panels import coach_words
from physics import simulate
from tests.support.pictures import layouts
from tests.support.players import an_app, press, run_to_rest


def way(angle, share=0.5, ball="red"):
    """A solution as the search has them."""
    aim, hit = Attempt(angle, 3.0, 0.2, 0.1), Thickness(ball, 4.3, "right")
    tip = Tip.of(0.2, 0.1, 0.03)
    return Solution((ball, "east"), aim, share, 100, share, None, share, hit, tip, None)


WAYS = [way(30.0, 0.8), way(-20.0, 0.4), way(100.0, 0.1)]


class Instant:
    """An aide that has answered already."""

    answers = WAYS

    def __init__(self):
        self.asked, self.closed = [], False

    def ask(self, *given):
        self.asked.append(given)
        return len(self.asked)

    def look(self, ticket):
        return News("done", self.answers)

    def forget(self):
        self.asked.append(None)

    def close(self):
        self.closed = True


class Never(Instant):
    """An aide that never answers."""

    def look(self, ticket):
        return None


def an_app_with(aide, **options):
    app = an_app(table="match", **options)
    app.view.coach.aide = aide
    return app


def frames(app, count=3):
    for _ in range(count):
        app.frame(0)


def boxes(app):
    return [float(text) for text in app.session.aim.texts]


def test_each_time_that_it_is_asked_the_coach_shows_the_next_way_and_then_the_first_again():
    app = an_app_with(Instant())
    seen = []
    for _ in range(4):
        press(app, "h")
        frames(app)
        seen.append(boxes(app)[-1])
    assert seen == [30.0, -20.0, 100.0, 30.0]
    assert len(app.view.coach.aide.asked) == 1
    press(app, "shift+h")
    frames(app)
    assert boxes(app)[-1] == 100.0


def test_its_button_does_what_its_key_does():
    app = an_app_with(Instant())
    engine = next(part for part in app.view.parts if part.name == "engine")
    from game.ui.panels.parts import TOOLS, _tools

    box = _tools(engine.rect, app.view.sight)["coach"]
    assert engine.touch(box.center, engine.rect, app.view.sight) == TOOLS["coach"]
    assert TOOLS["coach"] == Action("coach", 1)


def test_what_it_shows_is_struck_with_the_tip_and_at_the_speed_that_it_has():
    app = an_app_with(Instant())
    press(app, "h")
    frames(app)
    shot = WAYS[0].shot
    assert boxes(app) == pytest.approx(
        [shot.speed, shot.follow, shot.masse, shot.side, shot.angle], abs=0.005
    )
    assert app.session.aim.complete


def test_ways_are_forgotten_once_a_ball_lies_elsewhere():
    app = an_app_with(Instant())
    press(app, "h")
    frames(app)
    press(app, "down")
    press(app, "h")
    frames(app)
    assert len([asked for asked in app.view.coach.aide.asked if asked]) == 2


def test_a_search_goes_on_in_its_own_time_and_ends_with_the_window():
    app = an_app_with(Never())
    press(app, "h")
    assert app.frame(0)  # the next frame is looked for at once
    before = boxes(app)
    press(app, "h", "h")
    frames(app)
    assert app.view.coach.searching
    assert boxes(app) == before
    assert len(app.view.coach.aide.asked) == 1
    aide = app.view.coach.aide
    app.close()
    assert aide.closed


def test_a_search_that_takes_long_says_once_that_the_first_does():
    app = an_app_with(Never())
    coach, now = app.view.coach, [0.0]
    coach._clock = lambda: now[0]
    said = []
    press(app, "h")
    for now[0] in (1.0, LONG + 1.0, LONG + 2.0):
        frames(app)
        said.append((app.session.notice.key, app.session.news))
    assert [key for key, _ in said] == ["coach.searching", "coach.long", "coach.long"]
    assert said[1] == said[2]


def test_a_match_may_be_played_without_the_coach():
    for hints, asked in ((True, 1), (False, 0)):
        app = an_app_with(Instant())
        terms = Terms("three-cushion", (Contestant("Ada"), Contestant("Bo")), "match", hints=hints)
        perform(app.session, Action("match", terms.line()))
        press(app, "h")
        frames(app)
        assert len(app.view.coach.aide.asked) == asked
        if not hints:
            assert app.session.notice.key == "refused.coach"


def test_in_a_game_of_calls_it_calls_what_its_way_needs_and_steps_on_as_ever():
    aide = Instant()
    app = an_app_with(aide)
    seats = Contestant("Ada"), Contestant("Bo")
    app.perform(Action("match", Terms("14.1", seats, "pool-9").line()), sure=True)
    places = sorted(pockets(app.session.world))[:3]
    named = [Call(ball, place) for ball, place in zip(("3", "5", "3"), places, strict=True)]
    aide.answers = [replace(one, call=call) for one, call in zip(WAYS, named, strict=True)]
    frames(app)
    for call in (*named, named[0]):
        press(app, "h")
        frames(app)
        assert app.session.contest.match.call == call
        assert app.session.notice.key == "coach.found"
    assert len(aide.asked) == 1


def test_a_player_who_knows_no_way_and_a_table_without_a_game_are_told_so():
    nothing = Instant()
    nothing.answers = []
    app = an_app_with(nothing)
    press(app, "h")
    frames(app)
    assert app.session.notice.key == "coach.none"
    perform(app.session, Action("scene", "single"))
    press(app, "space")
    press(app, "h")
    frames(app)
    assert app.session.notice.key == "coach.game"


@pytest.mark.parametrize("table", ["medium", "match"])
def test_on_the_free_table_the_game_is_the_one_of_its_balls(table):
    session = Session(presets.table_world(table), table=table)
    rules, turn = played(session)
    assert {ball.name for ball in session.world.balls} == {*rules.balls}
    assert turn == Turn(session.cue)


def test_what_it_says_can_be_kept_and_read_again_and_nothing_else_can():
    told = advice.of(WAYS[0], 1, 3, "expert")
    assert advice.read(told.line()) == told
    command = RECORDED["suggest"]
    assert command.fault(told.line()) == ""
    words = told.line().split()
    for place in range(len(words)):
        for wrong in ("nan", "-7", "1e9", "x\x00"):
            bad = " ".join([*words[:place], wrong, *words[place + 1 :]])
            try:
                assert advice.read(bad).line() == bad  # a side, a name or a number may be that
            except ValueError:
                assert fault(Action("suggest", bad))
    assert fault(Action("suggest", told.line() + " 1"))
    assert fault(Action("suggest", ""))


@pytest.mark.parametrize("language", LANGUAGES)
def test_it_says_which_way_how_sure_and_how_to_hit(language):
    w = LANGUAGES[language]
    said = coach_words.said(advice.of(WAYS[0], 1, 3, "expert"), w)
    for part in ("1/3", "80 %", w["ball.red"], "4/8", w["coach.right"], "2"):
        assert part in said
    bank = replace(WAYS[0], thickness=None, tip=Tip(0, 0.0))
    said = coach_words.said(advice.of(bank, 1, 3, "expert"), w)
    assert w["coach.hit.none"] in said
    assert w["coach.tip.centre"] in said


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_ball_hit_thinner_than_an_eighth_is_hit_all_the_same(language):
    thin = replace(WAYS[0], thickness=Thickness("ball 9", 0.3, "right"))
    said = coach_words.said(advice.of(thin, 1, 3, "expert"), LANGUAGES[language])
    assert "<1/8" in said
    assert "9 <" not in said  # not nine and something eighths


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("layout", layouts(), ids=lambda v: f"{v.size[0]}-{v.length}")
def test_the_longest_that_it_says_fits_into_two_lines(language, layout):
    w, letters = words(language), Type(layout.s)
    room = layout.hint.w - round(18 * layout.s)
    far, ball = Tip(12, 1.4), max(w, key=lambda k: k.startswith("ball.") * letters.width(w[k], 11))
    hit = Thickness(ball.removeprefix("ball."), 7.0, "right")
    way = replace(WAYS[0], share=1.0, thickness=hit, tip=far)
    lines = fields._halves(coach_words.said(advice.of(way, 10, 12, "expert"), w), letters, room)
    assert not any("…" in line for line in lines), lines


def test_a_record_of_it_needs_no_search():
    app = an_app_with(Instant())
    press(app, "h")
    frames(app)
    told = [action for _, action in app.actions if action.name in ("coach", "suggest")]
    again = Session(presets.table_world("match"), table="match")
    for action in told:
        assert not fault(action)
        perform(again, action)
    assert again.aim.texts == app.session.aim.texts
    assert [a.name for a in told] == ["coach", "suggest"]


def test_it_can_be_undone():
    app = an_app_with(Instant())
    before = boxes(app)
    press(app, "h")
    frames(app)
    press(app, "z")
    assert boxes(app) == before


def test_while_balls_move_it_waits():
    app = an_app_with(Instant())
    press(app, "return")
    app.frame(10)
    press(app, "h")
    frames(app)
    assert not app.view.coach.aide.asked
    run_to_rest(app)


def test_the_search_of_the_game_finds_shots_that_score():
    world = presets.table_world("match")
    rules, turn = GAMES["three-cushion"](), Turn("white")
    ways = search.ways(world, rules, turn, EXPERT, budget=600, compiled=False)
    assert ways
    for found in ways:
        after = simulate(world, "white", found.shot)
        assert rules.verdict(after.log.contacts(), turn).made


# -- the computer, which plays by the same search -----------------------------------------------


class Own:
    """A mind of the game's own process."""

    def __init__(self):
        self.done, self.share, self.steps = False, 0.25, 0
        self.plan = "own"

    def think(self, budget, clock):
        self.steps += 1
        self.done = self.steps >= 3
        return self.done

    def played(self, rng):
        return "own, played"


def advised(aide):
    match = Terms("three-cushion", table="match").match()
    world = presets.table_world("match")
    return Advised(Own(), aide, world, match, EXPERT)


def test_the_computer_plays_what_the_coach_would():
    mind = advised(Instant())
    assert mind.think(0.0, lambda: 0.0)
    assert mind.plan.shot == WAYS[0].shot
    assert mind.share == 0.8


def test_while_no_answer_comes_the_computer_thinks_itself_and_waits_no_longer_than_its_patience():
    mind, now = advised(Never()), 0.0
    for _ in range(3):
        assert not mind.think(0.0, lambda: now)
        assert mind.plan == "own"
    while not mind.done:
        now += 0.5
        assert now < 5.0
        mind.think(0.0, lambda: now)  # noqa: B023
    assert mind.plan == "own"
    assert mind.share == 0.25


# -- the process --------------------------------------------------------------------------------


def twice(x):
    return 2 * x if x != "fail" else 1 / 0


def answer(aide, ticket):
    end = time.monotonic() + 60.0
    while (news := aide.look(ticket)) is None:
        assert time.monotonic() < end
        time.sleep(0.005)
    return news


def test_one_process_answers_question_after_question_and_only_the_last_counts():
    aide = Aide(twice)
    assert answer(aide, aide.ask(4)) == News("done", 8)
    old, new = aide.ask(5), aide.ask(6)
    assert answer(aide, old).kind == "failed"
    assert answer(aide, new) == News("done", 12)
    assert answer(aide, aide.ask("fail")) == News("failed", "ZeroDivisionError: division by zero")
    aide._process.kill()
    aide._process.join()
    assert answer(aide, aide.ask(1)).kind == "failed"
    assert answer(aide, aide.ask(2)) == News("done", 4)
    aide.forget()
    aide.close()
