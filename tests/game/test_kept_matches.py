"""What is kept in the user's folder: a match after each stroke, and figures at its end."""

import json
from dataclasses import replace

import pytest

from game.__main__ import new_game
from game.app import App
from game.options import Options
from game.session.action import Action
from game.session.scorecard import Totals
from game.settings.kept_matches import KeptMatches
from game.settings.statistics import Figures, Statistics
from game.ui.pages import menu_view, score_page
from tests.support.players import an_app, assert_same_as_anew, click, press, run_to_rest
from tests.support.racked_games import playing


def an_app_in(folder, **options):
    chosen = replace(Options(), size=(1280, 720), frames=1, **options)
    app = App(new_game(chosen), chosen, folder=folder)
    app.frame(0)
    return app


def play_one(app, shot="3 0 0 0 10"):
    app.perform(Action("play", shot))
    run_to_rest(app)
    app.frame(1000)


def test_after_a_stroke_another_game_is_offered_the_match_and_goes_on_with_it(tmp_path):
    first = an_app_in(tmp_path, game="8-ball", table="pool-9", players="Ann,Bo")
    assert first.keeper.offered() == ()
    play_one(first)
    second = an_app_in(tmp_path)
    press(second, "f10")
    menu = second.view.page
    menu.offer()
    second.redraw()
    assert_same_as_anew(second)
    press(second, "return")
    assert second.session.contest.match == first.session.contest.match
    assert second.session.world.layout() == first.session.world.layout()


def test_two_games_at_once_keep_two_matches(tmp_path):
    apps = [
        an_app_in(tmp_path, game="9-ball", table="pool-9"),
        an_app_in(tmp_path, game="snooker", table="snooker"),
    ]
    for app in apps:
        play_one(app)
    kept = json.loads((tmp_path / "matches.json").read_text())["matches"]
    assert len(kept) == 2
    play_one(apps[0], "2 0 0 0 40")
    assert len(json.loads((tmp_path / "matches.json").read_text())["matches"]) == 2
    assert '"9-ball"' in apps[0].keeper.offered()[0]


def test_a_match_that_is_over_is_offered_no_more_and_counts_in_the_figures(tmp_path):
    app = an_app_in(tmp_path, game="straight-rail", table="match", players="Ann,Bo", handicap="1")
    app.perform(Action("play", "0.5 0 0 0 200"))
    run_to_rest(app)
    assert app.keeper.offered()
    contest = app.session.contest
    contest.match = replace(contest.match, winner=1)
    app.update(1)
    assert app.keeper.offered() == ()
    assert app.keeper.statistics.of("Ann", "straight-rail").matches == 1
    assert app.keeper.statistics.of("Bo", "straight-rail").won == 1


def test_of_several_kept_matches_any_can_be_gone_on_with_by_keys_and_by_the_mouse(tmp_path):
    for game, table in (("9-ball", "pool-9"), ("snooker", "snooker"), ("8-ball", "pool-9")):
        play_one(an_app_in(tmp_path, game=game, table=table))
    app = an_app_in(tmp_path)
    press(app, "f10")
    menu = app.view.page
    menu.offer()
    said = []
    for _ in range(4):
        said.append(menu_view._foot(app.view.sight.words, menu._look))
        press(app, "pagedown")
    assert [line.split(",")[0] for line in said] == [
        "Go on with: 8-ball", "Go on with: Snooker", "Go on with: 9-ball", "Go on with: 8-ball",
    ]  # fmt: skip
    assert said[1].endswith("2 of 3: PgUp PgDn")
    press(app, "pageup")
    assert_same_as_anew(app)
    button = menu_view.button_rects(app.view.sight.layout)[menu_view.BUTTONS.index("resume")]
    click(app, button.move(-4, 0).midright)
    assert app.session.page == "menu"
    assert_same_as_anew(app)
    click(app, button.center)
    assert app.session.contest.terms.game == "snooker"


def test_figures_of_people_without_a_name_are_kept_by_their_seats_and_shown(tmp_path):
    app = an_app_in(tmp_path, game="straight-rail", table="match", handicap="1", level="club")
    contest = app.session.contest
    app.perform(Action("play", "0.5 0 0 0 200"))
    run_to_rest(app)
    contest.match = replace(contest.match, winner=0)
    app.update(1)
    assert {*app.keeper.statistics.load()} == {"Player 1"}  # and none of the computer
    career = app.view.pages["score"].career
    assert score_page._ever(contest, 0, career).won == 1
    assert score_page._ever(contest, 1, career).matches == 0


@pytest.mark.parametrize(
    "text", ["", "{", "[]", '{"format": "danggu matches", "matches": {"a": "b"}}']
)
def test_a_broken_file_of_matches_is_set_aside_and_nothing_is_lost(tmp_path, text):
    path = tmp_path / "matches.json"
    path.write_text(text)
    app = an_app_in(tmp_path, game="9-ball", table="pool-9")
    assert app.keeper.offered() == ()
    play_one(app)
    assert app.keeper.offered()
    assert path.with_name("matches.json.broken").read_text() == text


def test_a_good_match_beside_a_broken_one_is_still_offered(tmp_path):
    app = an_app_in(tmp_path, game="9-ball", table="pool-9")
    play_one(app)
    path = tmp_path / "matches.json"
    document = json.loads(path.read_text())
    document["matches"]["broken"] = "{}"
    path.write_text(json.dumps(document))
    assert KeptMatches(path).lines()


def test_figures_add_up_over_games_and_a_broken_file_is_set_aside(tmp_path):
    path = tmp_path / "statistics.json"
    one = Statistics(path)
    assert one.add("8-ball", {"Ann": (Totals(2, 9, 6, 1, 6, 4), True)})
    assert Statistics(path).add("8-ball", {"Ann": (Totals(1, 3, 0, 0, 0, 0), False)})
    found = one.of("Ann", "8-ball")
    assert found == Figures(2, 1, 3, 12, 6, 1, 6, 4)
    assert found.share == 0.5
    assert found.average == 2.0
    path.write_text(path.read_text().replace('"won": 1', '"won": "x"'))
    assert one.of("Ann", "8-ball") == Figures()
    assert one.faulty
    assert one.add("9-ball", {"Bo": (Totals(1, 1, 1, 0, 1, 1), True)})
    assert path.with_name("statistics.json.broken").exists()


def test_without_a_folder_nothing_is_kept_and_nothing_offered(tmp_path):
    app = an_app(game="9-ball", table="pool-9")
    play_one(app)
    assert app.keeper.offered() == ()
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_written_is_said_once_and_the_match_goes_on(tmp_path):
    (tmp_path / "blocked").write_text("")
    app = an_app_in(tmp_path / "blocked", game="9-ball", table="pool-9")
    play_one(app)
    assert app.session.notice.key == "match.unsaved"
    play_one(app, "2 0 0 0 50")
    assert app.session.shots == 2


@pytest.mark.parametrize("lang", ["en", "ko"])
def test_the_sheet_of_the_match_shows_each_visit(tmp_path, lang):
    app = an_app_in(tmp_path, game="snooker", table="snooker", players="Ann,Bo", lang=lang)
    press(app, "f6", "escape")
    for _ in range(3):
        play_one(app)
        asked = app.session.contest.match.asked
        if asked is not None:
            app.perform(Action("answer", asked.options[0].key))
    press(app, "f6")
    assert app.session.page == "score"
    assert_same_as_anew(app)
    press(app, "up", "pagedown", "escape")
    assert app.session.page == ""


def test_a_rack_begun_from_the_menu_has_a_seed_of_its_own():
    app = an_app(game="8-ball", table="pool-9")
    assert app.session.contest.terms == playing("8-ball").contest.terms
    press(app, "f10")
    action = app.view.page._do("start")
    app.perform(action, sure=True)
    assert app.session.contest.terms.seed != 0
