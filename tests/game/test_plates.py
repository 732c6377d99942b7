"""What the score plates show beside the points: groups, breaks and zones."""

from dataclasses import replace

import numpy as np
import pygame
import pytest

from danggu.rules.balkline import ASTRIDE, COME_IN, IN_THERE
from danggu.rules.match import Sheet
from danggu.rules.race import Race
from game.input.captions import words
from game.render import theme
from game.render.parts import cards
from game.session.scorecard import Visit
from game.ui.panels import plate_balls, rack_words, score_plates
from physics import Placed
from tests.support.players import an_app, assert_same_as_anew, press
from tests.support.racked_games import leave, playing, stroke

SIZES = [(640, 360), (960, 540), (1280, 720), (1920, 1080)]
PLACES = {"b1": (0.3, 0.2), "b3": (0.0, -0.4), "b8": (0.9, 0.0), "b9": (0.6, 0.1)}
BREAK = ("red1", "black", "red2", "black", "red3", "blue", "red4", "pink", "red5", "brown", "red6")


def shown(app):
    """The app with what the test has changed on show."""
    app.session.news += 1
    app.redraw()
    app.render()
    return app


def eight_ball(size=(960, 540), groups=("stripes", "solids"), **more):
    """A rack of 8-ball with a few balls left, drawn."""
    app = an_app(size=size, game="8-ball", table="pool-9", **more)
    press(app, "return")
    contest = app.session.contest
    state = replace(contest.match.state, groups=groups)
    contest.match, contest.race = replace(contest.match, state=state), Race(11, (10, 10))
    leave(app.session, cue=(-0.5, 0.0), **PLACES)
    return shown(app)


def snooker(balls=BREAK, size=(960, 540), **more):
    """A frame with a running break, drawn."""
    app = an_app(size=size, game="snooker", table="snooker", **more)
    press(app, "return")
    contest = app.session.contest
    sheets = Sheet(141, 3, 12, 8, 1, 134), Sheet(53, 3, 10, 5, 2, 28)
    contest.match = replace(contest.match, visit=len(balls), run=134, sheets=sheets)
    contest.card = (Visit(0, 1, 134, len(balls), len(balls), False, balls=balls),)
    leave(app.session, cue=(-0.5, 0.0), red7=(0.3, 0.2), black=(0.9, 0.0))
    return shown(app)


def plates_of(app):
    """Names and room of the balls on each plate, as they are drawn."""
    found = []
    draw = plate_balls.draw

    def noted(surface, room, sight, names):
        found.append((names, room))
        return draw(surface, room, sight, names)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(plate_balls, "draw", noted)
        score_plates.match_draw(app.session.contest, app.canvas.surface, app.view.sight)
    return found


def test_each_plate_has_its_players_group_and_the_8():
    (first, _), (second, _) = plates_of(eight_ball())
    assert first == ("9", "10", "11", "12", "13", "14", "15", "8")
    assert second == ("1", "2", "3", "4", "5", "6", "7", "8")


def test_no_plate_has_balls_while_the_table_is_open():
    app = eight_ball(groups=())
    assert plates_of(app) == []
    assert_same_as_anew(app)


def middles(app, names, room):
    """The colour in the upper half of each ball of a plate, clear of its number."""
    r = plate_balls.radius(names, room.w, app.view.sight.layout.s)
    start = room.right - (plate_balls.PITCH * (len(names) - 0.5) + plate_balls.APART) * r
    xs = (round(start + plate_balls.PITCH * r * place) for place in range(len(names) - 1))
    return {
        name: app.canvas.surface.get_at((x, round(room.centery - 0.7 * r)))[:3]
        for name, x in zip(names, xs, strict=False)
    }


def test_a_ball_that_is_down_is_a_ring_and_one_on_the_table_is_not():
    app = eight_ball((1280, 720))
    names, room = plates_of(app)[1]
    empty = {name for name, colour in middles(app, names, room).items() if colour == theme.PANEL}
    assert empty == {"2", "4", "5", "6", "7"}


def test_the_8_is_dim_until_it_is_on():
    def brightest(app):
        room = plates_of(app)[0][1]
        r = round(plate_balls.GROUP)
        last = app.canvas.surface.subsurface((room.right - 2 * r, room.y + 4, 2 * r, room.h - 8))
        return pygame.surfarray.array3d(last).max()

    app = eight_ball((1280, 720))
    dim = brightest(app)
    leave(app.session, cue=(-0.5, 0.0), b1=(0.3, 0.2), b8=(0.9, 0.0))
    assert brightest(app) > 1.5 * dim


@pytest.mark.parametrize("lang", ["en", "ko"])
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("level", ["human", "club"])
@pytest.mark.parametrize("game", [eight_ball, snooker])
def test_words_and_balls_of_a_plate_keep_apart(lang, size, level, game):
    app = game(size=size, lang=lang, level=level)
    assert_same_as_anew(app)
    s, t, contest = app.view.sight.layout.s, app.view.sight.type, app.session.contest
    for names, room in plates_of(app):
        gap = round(plate_balls.GAP * s) - 1
        strip = app.canvas.surface.subsurface((room.x - gap, room.y + 3, gap, room.h - 6))
        assert len(np.unique(pygame.surfarray.array2d(strip))) == 1
        assert plate_balls.radius(names, room.w, s) >= 9 * s
        plate = next(rect for rect in app.view.sight.layout.score if rect.contains(room))
        said, _ = score_plates._line(app.view.sight, contest, 0 if plate.x < 100 else 1)
        assert t.width(said.partition(" · ")[0], 12) <= room.x - gap - plate.x - 10 * s


@pytest.mark.parametrize("lang", ["en", "ko"])
@pytest.mark.parametrize("size", SIZES)
def test_the_plate_of_a_group_says_whole_that_its_player_wins_and_the_8_is_a_ring(lang, size):
    app = eight_ball(size, lang=lang)
    contest, t = app.session.contest, app.view.sight.type
    contest.match = replace(contest.match, winner=0)
    leave(app.session, cue=(-0.5, 0.0), b1=(0.3, 0.2))
    assert_same_as_anew(shown(app))
    _, room = plates_of(app)[0]
    gap, plate = round(plate_balls.GAP * t.s), app.view.sight.layout.score[0]
    left, _ = cards.score_room(plate, t, "10", "11", ball=False)
    assert t.width(app.view.sight.words["score.rack.won"], 12) <= room.x - gap - left
    at = room.right - round(plate_balls.GROUP * t.s), room.centery
    assert app.canvas.surface.get_at(at)[:3] == theme.PANEL


def test_of_a_long_break_the_last_balls_are_shown():
    app = snooker()
    names, room = plates_of(app)[0]
    assert names == BREAK
    assert plate_balls.PITCH * plate_balls.BREAK * app.view.sight.layout.s * len(BREAK) > room.w
    short = snooker(BREAK[:3])
    assert plates_of(short)[0][0] == BREAK[:3]


def test_only_the_player_at_the_table_has_a_break():
    app = snooker()
    app.session.contest.match = app.session.contest.match.passed()
    assert plates_of(app) == []


@pytest.mark.parametrize(("lang", "left", "behind", "ahead"), [
    ("en", "147 left", "behind 12", "ahead 12"), ("ko", "147점 남음", "12점 뒤짐", "12점 앞섬"),
])  # fmt: skip
def test_a_frame_says_what_is_left_and_how_far_a_player_is_behind(lang, left, behind, ahead):
    contest, w = playing("snooker").contest, words(lang)
    assert rack_words.middle(contest, w)[1] == left
    assert rack_words.lead(contest.match, w) == []
    for scores, said in (((41, 53), behind), ((53, 41), ahead)):
        sheets = tuple(Sheet(score) for score in scores)
        contest.match = replace(contest.match, sheets=sheets)
        assert said in rack_words.line(contest, 0, w)
        assert said not in rack_words.line(contest, 1, w)
        assert rack_words.lead(contest.match, w) == [said]


@pytest.mark.parametrize("lang", ["en", "ko"])
@pytest.mark.parametrize("size", SIZES)
def test_what_is_left_in_a_frame_fits_between_the_plates(lang, size):
    app = an_app(size=size, lang=lang, game="snooker", table="snooker")
    rect, t = app.view.sight.layout.score[1], app.view.sight.type
    label, number = rack_words.middle(app.session.contest, app.view.sight.words)
    surface = pygame.Surface(app.canvas.surface.get_size())
    cards.inning(surface, rect, t, label, number)
    cards.card(blank := surface.copy(), rect, t.s)
    changed = pygame.surfarray.array2d(surface) != pygame.surfarray.array2d(blank)
    xs, ys = np.nonzero(changed)
    inner = rect.inflate(-6, -6)
    assert inner.contains((xs.min(), ys.min(), np.ptp(xs) + 1, np.ptp(ys) + 1))


@pytest.mark.parametrize(("zone", "anchor", "said"), [
    ("", "", []), (ASTRIDE, "", []), (COME_IN, "", ["zone: leave in 2"]),
    (IN_THERE, "", ["zone: leave now"]),
    (COME_IN, IN_THERE, ["anchor: leave now", "zone: leave in 2"]),
])  # fmt: skip
def test_a_plate_says_by_which_stroke_a_ball_must_leave_the_zone(zone, anchor, said):
    app = an_app(size=(1280, 720), game="balkline-47/2", table="match")
    contest, sight = app.session.contest, app.view.sight
    state = replace(contest.match.state, zone=zone, anchor=anchor)
    contest.match = replace(contest.match, state=state, run=4, visit=4)
    assert rack_words.zones(contest.match, words("en")) == said
    line, _ = score_plates._line(sight, contest, 0)
    assert line.startswith(" · ".join([*said, "run 4"]))
    assert "leave" not in score_plates._line(sight, contest, 1)[0]


@pytest.mark.parametrize("game", ["snooker", "9-ball"])
def test_the_cue_ball_on_a_plate_is_as_large_in_snooker_as_in_pool(game):
    table = "snooker" if game == "snooker" else "pool-9"
    app = an_app(size=(960, 540), game=game, table=table)
    plate = app.view.sight.layout.score[0].inflate(-8, -4)
    strip = pygame.surfarray.array3d(app.canvas.surface.subsurface(plate))[: round(40 * 0.75)]
    across = np.count_nonzero((strip.min(axis=2) > 100).any(axis=1))
    assert across == pytest.approx(2 * score_plates.CUE_BALL * 0.75, abs=3)


def test_after_a_stroke_that_leaves_both_balls_in_a_zone_the_plate_says_so():
    session = playing("balkline-47/1")
    places = {"white": (-1.0, 0.0), "yellow": (1.2, 0.5), "red": (1.2, 0.6)}
    session.put([Placed(complex(*places[ball.name])) for ball in session.world.balls])
    stroke(session, "0.3 0 0 0 180")
    assert session.contest.match.at == 1
    assert "zone: leave now" in rack_words.zones(session.contest.match, words("en"))
