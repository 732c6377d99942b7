"""Presets change from edition to edition; a record is played with those of its time."""

from dataclasses import replace

import pytest

from game.__main__ import new_game
from game.replay.game_record import RecordError, digest, read
from game.replay.recorder import Recorder
from game.replay.replay import headless
from game.session.action import Action
from game.session.commands import perform
from game.table import presets
from physics import Cloth, Shot, laws, simulate, tables
from tests.support.records import OPTIONS, lines, rewritten

BEFORE = Cloth(slide=0.15, roll=0.005, spin_decay=5.0, gravity=9.81)


@pytest.fixture
def record(tmp_path):
    """A shot on new cloth, and one with Mathavan's cushion on humid cloth."""
    path, session = tmp_path / "game.rec", new_game(OPTIONS)
    recorder = Recorder(str(path), OPTIONS, session)
    steps = (("cloth", "new"), ("set", "speed 3"), ("fire",), ("skip",), ("law", "mathavan"),
             ("cloth", "humid"), ("fire",), ("skip",))  # fmt: skip
    for step in steps:
        action = Action(*step)
        recorder.before(action)
        perform(session, action)
        recorder.after()
        session.advance(1)
        recorder.passed()
    recorder.close()
    return path


def of_the_first(found):
    del found[0]["edition"]


def test_a_record_says_its_edition_and_comes_out_the_same(record):
    assert lines(record)[0]["edition"] == presets.EDITION == 4
    played = read(str(record), OPTIONS)
    assert headless(played, new_game(played.setup)).state == "same"


def test_a_record_without_an_edition_is_played_with_the_presets_of_the_first(record, tmp_path):
    played = read(str(rewritten(record, tmp_path, of_the_first)), OPTIONS)
    session = new_game(played.setup)
    for at, (cloth, cushion) in enumerate((
        (BEFORE, session.came_with.cushion_law),
        (presets.CLOTHS["humid"], laws.MathavanCushion(slide=0.212, nose=0.039 / 0.03275)),
    )):  # fmt: skip
        for _, action in played.actions[4 * at : 4 * at + 3]:
            perform(session, action)
            assert session.world.cloth == cloth or action.name in ("law", "set")
        expected = _end(session, cloth, cushion)
        perform(session, Action("skip"))
        assert session.world.cushion_law == cushion
        assert [ball.position for ball in session.world.balls] == expected


def _end(session, cloth, cushion):
    """Where the balls rest if the shot that has just begun is played with these."""
    world = presets.table_world("medium")
    world.recall(session.lies)
    world.cloth, world.cushion_law = cloth, cushion
    speed, follow, masse, side, angle = map(float, session.aim.texts)
    after = simulate(world, "white", Shot(speed, angle, follow, masse, side))
    return [ball.position for ball in after.balls]


def test_the_two_editions_differ_where_they_should(record, tmp_path):
    games = []
    for path in (record, rewritten(record, tmp_path, of_the_first)):
        played = read(str(path), OPTIONS)
        games.append(new_game(played.setup))
        headless(played, games[-1])
    assert digest(games[0]) != digest(games[1])
    assert [session.edition for session in games] == [4, 1]


def test_an_edition_that_is_not_known_is_refused_by_its_number(record, tmp_path):
    for strange in (5, "2", [1]):

        def change(found, strange=strange):
            found[0]["edition"] = strange

        with pytest.raises(RecordError, match="edition"):
            read(str(rewritten(record, tmp_path, change)), OPTIONS)


def test_the_command_line_s_cloth_and_law_are_of_the_record_s_edition():
    old = new_game(replace(OPTIONS, edition=1, cloth="new", law="mathavan"))
    assert old.world.cloth == BEFORE
    assert old.world.cushion_law.slide == 0.212
    now = new_game(replace(OPTIONS, cloth="new", law="mathavan"))
    assert now.world.cloth.roll < old.came_with.cloth.roll
    assert now.world.cushion_law.slide is None


def on_the_match_table(edition):
    return new_game(replace(OPTIONS, edition=edition, table="match"))


@pytest.mark.parametrize("edition", [1, 2])
def test_a_record_of_before_has_the_match_table_of_before(edition):
    for session in (on_the_match_table(edition), new_game(replace(OPTIONS, edition=edition))):
        perform(session, Action("table", "match"))
        world = session.world
        assert (world.cloth, world.ball_law, world.cushion_law) == (
            tables.MATCH_CAROM.cloth, tables.MATCH_CAROM.ball_law, tables.MATCH_CAROM.cushion_law
        )  # fmt: skip
        perform(session, Action("cloth", "worn"))
        assert world.cloth == tables.CLOTH_EDITIONS[1]["worn"]
        perform(session, Action("law", "thesis"))
        perform(session, Action("law", "rigid"))
        assert world.cushion_law == tables.MATCH_CAROM.cushion_law


def test_a_new_game_has_the_match_table_that_is_nearest_to_real_strokes():
    session = on_the_match_table(presets.EDITION)
    assert session.world.cloth == tables.MATCH_CAROM_2.cloth
    assert session.world.cushion_law == tables.MATCH_CAROM_2.cushion_law
    perform(session, Action("cloth", "hall"))
    assert session.world.cloth == tables.CLOTHS["hall"]
    perform(session, Action("law", "thesis"))
    perform(session, Action("law", "rigid"))
    assert session.world.cushion_law == tables.MATCH_CAROM_2.cushion_law
