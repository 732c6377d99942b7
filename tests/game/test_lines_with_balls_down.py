"""Set-up lines of tables with pockets: balls that are down stay down, wrong lines say why."""

import pytest

from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.table import presets
from game.table.lineup import LineError, Lineup, of, read
from tests.support.racked_games import leave, playing

LINE = "danggu1 pool-9 cue=-0.6,0.1 9=0.5,0.2 4=down 5=down"


def test_balls_that_are_down_are_written_and_read_again_to_the_digit():
    session = Session(presets.table_world("medium"))
    perform(session, Action("line", LINE))
    assert [b.name for b in session.world.balls if b.gone] == ["4", "5"]
    assert session.cue == "cue"
    assert read(of(session.world, session.table).line()) == read(LINE)
    perform(session, Action("line", of(session.world, session.table).line()))
    assert [b.name for b in session.world.balls if b.gone] == ["4", "5"]


def test_a_position_of_a_match_can_be_copied_with_its_balls_down():
    session = playing("8-ball")
    leave(session, cue=(0.1, 0.1), b8=(0.5, 0.3))
    line = of(session.world, session.table).line()
    assert len(read(line).down) == 14


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("danggu1 pool-9 cue=down 1=0,0", "down"),
        ("danggu1 pool-9 cue=0,0 1=down 1=0.4,0", "twice"),
        ("danggu1 pool-9 cue=0,0 16=down", "name"),
        ("danggu1 pool-9 1=down", "missing"),
        ("danggu1 pool-9 cue=1.3,0", "outside"),
        ("danggu1 snooker cue=0,0 9=0.2,0", "name"),
        ("danggu1 medium white=0,0 1=0.2,0.2", "name"),
    ],
)
def test_a_wrong_line_says_what_is_wrong(line, reason):
    with pytest.raises(LineError) as found:
        read(line)
    assert found.value.reason == reason


def test_a_number_with_a_space_behind_it_makes_a_line_that_can_be_read():
    lineup = read(LINE)
    spaced = Lineup(lineup.table, lineup.balls, ("3 ", "0", " 1", "0", "90"), lineup.down)
    assert read(spaced.line()).texts == ("3", "0", "1", "0", "90")
