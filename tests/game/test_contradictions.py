"""Options that cannot be meant together: every pair of them is played, or refused by name."""

from itertools import combinations

import pytest

from game import options
from game.__main__ import new_game
from game.contradictions import contradiction
from game.options import Options
from game.settings.settings import Settings

LINE = "danggu1 medium white=-0.5,0.0 red1=0.5,0.25"
VALUES = {
    "seed": "1", "substeps": "3", "table": "match", "scene": "carom", "game": "four-ball",
    "players": "2", "level": "club", "handicap": "5", "finish": "none", "setup": LINE,
    "cloth": "new", "engine": "thesis", "law": "rigid", "lang": "ko", "size": "640x360",
    "fps": "30", "frames": "9", "script": "s", "record": "r", "replay": "p", "headless": None,
    "settings": "t", "screenshot": "x.png", "stats": None, "version": None,
}  # fmt: skip
LAID = {("setup", "scene"), ("setup", "table"), ("setup", "game"), ("scene", "table")}
LAID |= {("scene", "game")}
MATCH = {"players", "level", "handicap", "finish"}
SAID_BY_RECORDS = {
    "seed", "substeps", "table", "scene", "game", "setup", "cloth", "engine", "law", *MATCH,
}  # fmt: skip
SHOWN = {"lang", "size", "fps", "frames", "script", "screenshot", "stats", "settings"}


def words(*names):
    return [word for n in names for word in (f"--{n}", VALUES[n]) if word is not None]


def refused(*said):
    try:
        options.read([*said])
    except SystemExit as left:
        return left.code == 2
    return False


def is_contradiction(one, other):
    """What must be refused, said once more: no match without a game, no two ways to lay balls."""
    pair = {one, other}
    return (
        any(pair == {*two} for two in LAID)
        or bool(pair & MATCH and "game" not in pair)
        or pair == {"record", "replay"}
        or ("replay" in pair and bool(pair & SAID_BY_RECORDS))
        or ("headless" in pair and "replay" not in pair)
    )


def test_every_option_is_in_the_table():
    said_by_records = {"given", "edition"}  # no options of the command line
    assert VALUES.keys() == {*Options.__dataclass_fields__} - said_by_records


@pytest.mark.parametrize(("one", "other"), [*combinations(VALUES, 2)])
def test_a_pair_of_options_is_refused_by_both_names_if_one_would_be_ignored(one, other, capsys):
    assert refused(*words(one, other)) == is_contradiction(one, other)
    err = capsys.readouterr().err
    if is_contradiction(one, other):
        last = err.splitlines()[-1]
        named = {one, other} & MATCH if {one, other} & MATCH else {one, other}
        named = {"headless"} if "headless" in named else named
        assert any(f"--{name}" in last for name in named)


@pytest.mark.parametrize("name", sorted(SHOWN))
def test_a_replay_without_a_window_takes_no_options_of_a_window(name, capsys):
    assert refused(*words("replay", "headless", name))
    assert f"--headless and --{name}" in capsys.readouterr().err


def test_a_match_takes_its_options_and_a_table():
    assert not refused(*words("game", "table", "players", "level", "handicap", "finish"))
    assert refused("--game", "three-cushion", "--finish", "none")


def test_no_game_is_no_reason_not_to_lay_the_balls():
    for name in ("setup", "scene", "table"):
        assert not refused("--game", "free", *words(name))


@pytest.mark.parametrize("name", [n for n, value in VALUES.items() if value is not None])
def test_an_option_that_is_empty_or_there_twice_is_refused(name, capsys):
    value = VALUES[name]
    game = words("game") if name in MATCH else []
    assert refused(*game, f"--{name}", "")
    assert f"--{name}" in capsys.readouterr().err.splitlines()[-1]
    assert refused(*game, f"--{name}", value, f"--{name}", value)
    assert "is there twice" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("one", "other"),
    [("record", "script"), ("record", "settings"), ("record", "screenshot"), ("replay", "script")],
)
def test_one_file_is_not_two_things(one, other, tmp_path, capsys):
    a, b = tmp_path / "x.png", tmp_path / ".." / tmp_path.name / "x.png"
    assert refused(f"--{one}", str(a), f"--{other}", str(b))
    assert "one file for both" in capsys.readouterr().err


@pytest.mark.parametrize(
    "said",
    ["--frames 0", "--frames -1", "--frames 1e3", "--fps 0", "--fps 1001", "--substeps 0",
     "--size 639x360", "--size 640", "--size 99999x99999", "--seed 1.5", "--seed x",
     f"--seed {'9' * 30}", "--lang fr", "--table moon", "--scene moon", "--engine x", "--law x",
     "--cloth x", "--game golf", "--screenshot x.gif", "--nonsense"],
)  # fmt: skip
def test_a_value_that_cannot_be_is_refused_by_name(said, capsys):
    assert refused(*said.split())
    last = capsys.readouterr().err.splitlines()[-1]
    assert said.split()[0] in last
    assert said.split()[-1][:20] in last


@pytest.mark.parametrize(
    ("said", "why"),
    [
        ("--players a,b,c", "players must be 1 or 2, not 3"),
        ("--level club,club,club", "'club,club,club' is for 3 players: there are 2"),
        ("--players 1 --handicap 5,5", "'5,5' is for 2 players: there are 1"),
        ("--handicap 0", "1 to 200, not 0"),
        ("--handicap 201", "1 to 200, not 201"),
        ("--handicap x", "not 'x'"),
        ("--handicap " + "9" * 5000, "not '9999"),
        ("--level queen", "not 'queen'"),
        ("--players a\udcff", "not 'a\\udcff'"),
    ],
)
def test_a_match_that_cannot_be_says_why(said, why):
    with pytest.raises(ValueError, match=r"^.{1,400}$") as caught:
        new_game(options.read(["--game", "four-ball", *said.split()]))
    assert why in str(caught.value)


# -- nothing is ignored --------------------------------------------------------------------------


@pytest.mark.parametrize("line", [LINE, "danggu1 match white=0.5,0.0", "danggu1 thesis white=0,0"])
def test_laws_and_cloth_are_those_that_were_asked_for_wherever_the_balls_lie(line):
    game = new_game(options.read(["--setup", line, *words("law", "cloth", "engine")]))
    plain = new_game(options.read(["--setup", line]))
    assert (game.law, game.cloth, game.engine) == ("rigid", "new", "thesis")
    assert game.world.cloth != plain.world.cloth
    assert [b.position for b in game.world.balls] == [b.position for b in plain.world.balls]


@pytest.mark.parametrize("name", ["setup", "scene", "game", "table"])
def test_what_was_chosen_for_one_table_is_not_taken_to_another(name):
    chosen = Settings(table="thesis", cloth="new", law="mathavan")
    merged = chosen.applied(options.read(words(name)))
    assert (merged.cloth, merged.law) == ("table", None)
    assert merged.table == {"table": "match"}.get(name, "medium")


def test_the_free_table_is_the_one_that_was_chosen():
    assert Settings(table="match").applied(options.read(["--game", "free"])).table == "match"


@pytest.mark.parametrize("game", ["8-ball", "9-ball", "10-ball", "snooker", "free-pyramid"])
def test_a_handicap_is_refused_by_games_that_are_won_by_racks(game):
    assert "is won by racks or frames" in contradiction({"game": game, "handicap": "5"})
    for other in ("14.1", "four-ball", "three-cushion"):
        assert not contradiction({"game": other, "handicap": "5"})
