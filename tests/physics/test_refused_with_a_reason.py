"""Calls and commands that went on with what cannot be, or refused it without saying why."""

import pytest

from physics import Ball, Cloth, Shot, Wall, World, laws, recover_drawn, store, tables
from physics.__main__ import main

MADE = (tables.pool_9ft, tables.pool_8ft, tables.pool_7ft, tables.snooker_12ft, tables.pyramid_12ft)


@pytest.mark.parametrize("made", MADE, ids=lambda made: made.__name__)
def test_a_size_that_pockets_do_not_have_is_refused_with_those_they_have(made):
    with pytest.raises(TypeError, match=r"no size 'hole': there are corner_mouth, side_mouth, sh"):
        made(hole=0.05)


@pytest.mark.parametrize("made", MADE, ids=lambda made: made.__name__)
def test_every_table_with_pockets_takes_their_sizes(made):
    before = made().table.pockets
    after = made(corner_mouth=before.corner.width + 1e-3, side_mouth=before.side.width + 2e-3)
    assert after.table.pockets.corner.width == before.corner.width + 1e-3
    assert after.table.pockets.side.width == before.side.width + 2e-3
    assert after.table.pockets.corner.hole == before.corner.hole
    assert made().table.pockets == before


def test_a_rolling_law_that_is_a_number_is_refused_by_its_value():
    with pytest.raises(ValueError, match=r"rolling: law is called .* not 3"):
        Cloth().rolling(3)


def test_a_drawing_that_begins_elsewhere_is_refused_with_how_far():
    world = tables.match_carom()
    world.add(Ball("white", at=(-0.5, 0.0)))
    with pytest.raises(ValueError, match=r"path begins 7 m from ball 'white'"):
        recover_drawn(world, "white", [(6.5, 0.0), (7.5, 0.0)])


@pytest.mark.parametrize("name", ["sinai", "stadium"])
def test_a_scene_without_an_end_is_played_for_twenty_seconds(name, tmp_path, capsys):
    pytest.importorskip("matplotlib")
    file = tmp_path / "x.png"
    assert main(["scene", name, "--png", str(file)]) == 0
    assert "events in 20.0000 s" in capsys.readouterr().out
    assert file.exists()


def test_a_scene_of_ones_own_without_an_end_asks_for_until(tmp_path, capsys):
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0), laws.RigidCushion(1.0, 0.0, 1.0))
    for wall in ((1, 0, 1), (-1, 0, 1)):
        world.add(Wall.line(*wall))
    world.add(Ball("white", at=(0.0, 0.0)))
    world.strike("white", Shot(1.0))
    store.save(world, tmp_path / "ice.json")
    assert main(["scene", str(tmp_path / "ice.json")]) == 2
    said = capsys.readouterr().err
    assert "--until T" in said
    assert ".scene" not in said


def test_a_fit_takes_tables_with_pockets_and_files_and_names_all_for_another(tmp_path, capsys):
    world = tables.pool_9ft()
    world.cloth = Cloth(slide=0.19, roll=0.006)
    tables.save(world, tmp_path / "mine.json")
    tracks = tmp_path / "none.csv"
    for table in ("pool_9ft", "snooker_12ft", "match", str(tmp_path / "mine.json")):
        assert main(["fit", str(tracks), "--table", table]) == 2
        assert "none.csv" in capsys.readouterr().err  # the table is found, the tracks are not
    assert main(["fit", str(tracks), "--table", "pool"]) == 2
    assert "no table 'pool': there are thesis, medium, match" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--preset", "--png"])
def test_a_fit_that_could_not_be_written_is_not_begun(option, tmp_path, capsys):
    path = tmp_path / "nowhere" / "x.json"
    assert main(["fit", str(tmp_path / "none.csv"), option, str(path)]) == 2
    said = capsys.readouterr().err
    assert str(path) in said
    assert "none.csv" not in said
