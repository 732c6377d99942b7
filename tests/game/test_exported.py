"""A shot as CSV and picture: whole, in the user's folder, and said where."""

import csv
from io import BytesIO
from pathlib import Path

import pygame
import pytest

from game.settings import shot_files
from game.table import presets
from game.text import LANGUAGES
from game.ui.panels.parts import hint
from physics import whole_files
from tests.support.players import FRAME, an_app, press


@pytest.fixture
def app(tmp_path):
    app = an_app()
    app.exports = tmp_path
    press(app, "return", "end")
    return app


def files(folder):
    return sorted(p.name for p in (folder / "exports").iterdir() if p.suffix in (".csv", ".png"))


def test_the_shot_on_show_is_written_as_data_and_as_the_picture_of_the_window(app, tmp_path):
    press(app, "f12")
    assert files(tmp_path) == ["shot-001.csv", "shot-001.png"]
    with open(tmp_path / "exports" / "shot-001.csv", newline="") as file:
        rows = [*csv.DictReader(file)]
    world, began = app.session.world, app.session.began
    assert float(rows[0]["time"]) == 0.0
    assert float(rows[-1]["time"]) == pytest.approx(world.time - began, abs=1e-12)
    for ball in world.balls:
        end = float(rows[-1][f"{ball.name} x"]), float(rows[-1][f"{ball.name} y"])
        assert end == pytest.approx(ball.position, abs=1e-9)
    data = (tmp_path / "exports" / "shot-001.png").read_bytes()
    picture = pygame.image.load(BytesIO(data), "shot.png")
    assert picture.get_size() == app.canvas.surface.get_size()


def test_a_second_one_has_another_name_and_no_file_is_written_over(app, tmp_path):
    press(app, "f12")
    first = (tmp_path / "exports" / "shot-001.csv").read_bytes()
    press(app, "f12", "f12")
    assert files(tmp_path)[-1] == "shot-003.png"
    assert (tmp_path / "exports" / "shot-001.csv").read_bytes() == first


@pytest.mark.parametrize("language", LANGUAGES)
def test_where_it_is_is_said(app, tmp_path, language):
    app.session.language = language
    press(app, "f12")
    said, wrong = hint(app.session, app.view.sight.words)
    assert str(tmp_path / "exports" / "shot-001.csv") in said
    assert not wrong
    app.frame(FRAME)


def test_before_a_shot_the_places_of_the_balls_are_written(tmp_path):
    app = an_app()
    app.exports = tmp_path
    press(app, "f12")
    with open(tmp_path / "exports" / "shot-001.csv", newline="") as file:
        (row,) = csv.DictReader(file)
    assert float(row["white x"]) == pytest.approx(app.session.world.ball("white").position[0])


def test_of_a_scene_that_never_ends_the_last_minutes_are_written(tmp_path):
    world = presets.SCENES["cradle"]()
    world.run(shot_files.LONGEST + 10.0)
    path = shot_files.write(tmp_path, world, 0.0, b"")
    with open(path, newline="") as file:
        rows = [*csv.DictReader(file)]
    assert float(rows[0]["time"]) == 0.0
    assert float(rows[-1]["time"]) == shot_files.LONGEST


def test_where_the_picture_cannot_be_written_no_data_stay_and_the_reason_is_said(
    app, tmp_path, monkeypatch
):
    replace = whole_files.replace

    def full(path, data):
        if Path(path).suffix == ".png":
            raise OSError(28, "No space left on device")
        replace(path, data)

    monkeypatch.setattr(whole_files, "replace", full)
    press(app, "f12")
    assert files(tmp_path) == []
    said, wrong = hint(app.session, app.view.sight.words)
    assert said.endswith("No space left on device")
    assert wrong
    assert not app.session.over


def test_a_user_without_a_home_learns_why_there_is_no_file(app, monkeypatch):
    app.exports = None
    monkeypatch.setattr("game.settings.shot_files.library.folder", lambda: None)
    press(app, "f12")
    said, wrong = hint(app.session, app.view.sight.words)
    assert "no home folder" in said
    assert wrong


def test_a_path_below_the_home_is_short(monkeypatch, tmp_path):
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    assert shot_files.shortly(tmp_path / "a" / "b.csv") == str(Path("~/a/b.csv"))
    assert shot_files.shortly(Path("/elsewhere/b.csv")) == str(Path("/elsewhere/b.csv"))
