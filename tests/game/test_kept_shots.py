"""Shots and replays that are kept in files and shared as a line of text, and keys with Ctrl."""

import pytest

from game.replay.game_record import digest
from game.session.action import Action
from game.session.ticks import TICKS
from game.settings.shot_folder import ShotFolder, fit
from game.table import shared
from game.table.lineup import LineError
from game.ui.pages import shots_view
from game.window import clipboard
from tests.support.players import FRAME, an_app, assert_same_as_anew, click, press, write


@pytest.fixture
def app(tmp_path):
    app = an_app()
    app.view.shots.path = tmp_path / "shots"
    return app


@pytest.fixture(autouse=True)
def board(monkeypatch):
    """A clipboard of our own: what is in it."""
    held = [""]
    monkeypatch.setattr(clipboard, "put", lambda text: bool(held.__setitem__(0, text) or True))
    monkeypatch.setattr(clipboard, "get", lambda: held[0])
    return held


def shoot(app):
    """Play what is in the boxes to its end; returns how the balls lie."""
    for name in ("shoot", "skip"):
        app.perform(Action(name))
    app.frame(FRAME)
    return digest(app.session)


def test_a_replay_copied_by_ctrl_c_comes_out_the_same_when_it_is_pasted_elsewhere(app, board):
    end = shoot(app)
    press(app, "ctrl+c")
    assert shared.read(board[0]).end == end
    other = an_app(table="match")
    other.perform(Action("engine", "thesis"))
    press(other, "ctrl+v")
    session = other.session
    assert (session.table, session.engine, session.moving) == ("medium", "exact", True)
    other.perform(Action("skip"))
    other.frame(FRAME)
    assert digest(session) == end
    assert other.view.toast.key == "toast.same"
    assert_same_as_anew(other)


@pytest.mark.parametrize("engine", ["exact", "thesis"])
@pytest.mark.parametrize("law", ["rigid", "thesis"])
def test_a_replay_is_kept_with_what_it_was_played_with(app, board, engine, law):
    for action in (Action("engine", engine), Action("law", law), Action("cloth", "humid")):
        app.perform(action)
    end = shoot(app)
    press(app, "ctrl+c")
    other = an_app()
    press(other, "ctrl+v")
    other.perform(Action("skip"))
    other.frame(FRAME)
    found = other.session
    assert (found.engine, found.law, found.cloth) == (engine, law, "humid")
    assert digest(found) == end


def test_a_replay_that_comes_out_differently_says_so(app, board):
    end = shoot(app)
    press(app, "ctrl+c")
    board[0] = board[0].replace(end, end[::-1])
    press(app, "ctrl+v")
    app.perform(Action("skip"))
    app.frame(FRAME)
    assert (app.view.toast.key, app.view.toast.bad) == ("toast.differs", True)


def test_a_shot_that_is_aimed_is_pasted_to_be_aimed(app, board):
    app.perform(Action("set", "speed 2 follow 0 masse 0 side 0 angle 77"))
    press(app, "ctrl+c")
    other = an_app()
    press(other, "ctrl+v")
    assert not other.session.moving
    assert other.session.aim.texts == ["2", "0", "0", "0", "77"]
    assert other.session.aim.complete


BAD = {
    "": "toast.empty",
    "hello": "line.mark",
    "danggu1 nowhere white=0,0": "line.table",
    "danggu1-shot engine=exact": "line.cut",
    "danggu1-shot engine=steam danggu1 medium white=0,0": "line.kit",
}


@pytest.mark.parametrize("text", BAD)
def test_a_text_that_is_no_shot_says_why_and_changes_nothing(app, board, text):
    board[0], before = text, app.session.world.layout()
    press(app, "ctrl+v")
    assert (app.view.toast.key, app.view.toast.bad) == (BAD[text], True)
    assert app.session.world.layout() == before
    app.frame(FRAME)
    assert_same_as_anew(app)


def test_equipment_that_is_not_known_is_named(app):
    line = app.view.last.aimed().line().replace("engine=exact", "engine=steam")
    with pytest.raises(LineError, match="engine=steam"):
        shared.read(line)


def test_in_a_box_numbers_are_copied_and_a_shot_is_pasted_all_the_same(app, board):
    press(app, "ctrl+c")
    line = board[0]
    press(app, "left", "ctrl+c")
    assert board[0] == app.session.aim.texts[0]
    press(app, "ctrl+v")
    assert app.session.aim.box == 0
    board[0] = line
    press(app, "ctrl+v")
    assert app.session.aim.box is None


@pytest.mark.parametrize("inside", [False, True])
def test_ctrl_z_takes_back_and_ctrl_y_does_again_in_play_and_in_a_box(app, inside):
    lay = app.session.world.layout()
    press(app, "down")
    assert app.view.toast.key == "toast.place"
    placed = app.session.world.layout()
    assert placed != lay
    press(app, *["left"] * inside, "ctrl+z")
    assert app.session.world.layout() == lay
    assert app.view.toast.key == ""
    press(app, *["left"] * inside, "ctrl+y")
    assert app.session.world.layout() == placed
    press(app, "ctrl+z", "ctrl+shift+z")
    assert app.session.world.layout() == placed


def test_a_toast_goes_by_itself_and_leaves_nothing_behind(app):
    press(app, "down")
    app.frame(FRAME)
    with_it = app.view.toast.cards(app.view.sight)
    assert len(with_it) == 1
    for _ in range(9):
        app.frame(TICKS // 2)
    assert app.view.toast.cards(app.view.sight) == []
    assert_same_as_anew(app)


def test_a_shot_is_saved_under_a_name_by_ctrl_s_and_opened_by_ctrl_o(app):
    end = shoot(app)
    press(app, "ctrl+s")
    assert app.view.typing
    write(app, "뱅크 샷")
    press(app, "return")
    assert [shot.name for shot in app.view.shots.shots()] == ["뱅크 샷"]
    press(app, "escape", "down", "ctrl+o", "return")
    assert app.session.page == ""
    app.perform(Action("skip"))
    app.frame(FRAME)
    assert digest(app.session) == end


def test_two_games_that_save_the_same_name_keep_both(tmp_path, app):
    shot = app.view.last.aimed()
    names = [ShotFolder(tmp_path).save("one", shot) for _ in range(2)]
    names.append(ShotFolder(tmp_path).save("ONE", shot))
    assert len({name.casefold() for name in names}) == 3
    assert all(kept.shot == shot for kept in ShotFolder(tmp_path).shots())


def test_a_broken_file_is_listed_as_one_and_opens_nothing(tmp_path, app):
    folder = app.view.shots.path
    folder.mkdir()
    (folder / "bad.txt").write_bytes(b"\xff\xfe nothing")
    press(app, "ctrl+o", "return")
    assert app.session.page == "shots"
    assert app.view.page.said[0] == "shots.broken"
    press(app, "delete")
    assert not list(folder.iterdir())


def test_a_link_that_leads_nowhere_hides_no_other_shot_and_lets_none_be_overwritten(tmp_path, app):
    folder = app.view.shots
    first, second = (shared.read(f"danggu1 medium white=0,0 red1={x},0.1") for x in (0.1, 0.2))
    folder.save("mine", first)
    (tmp_path / "shots" / "gone.txt").symlink_to(tmp_path / "nowhere")
    assert folder.save("mine", second) == "mine (2)"
    assert {kept.name: kept.shot for kept in folder.shots()} == {
        "mine": first, "mine (2)": second, "gone": None,
    }  # fmt: skip


def test_a_file_far_longer_than_a_shot_is_a_broken_one_without_being_read_through(app):
    folder, line = app.view.shots, "danggu1 medium white=0,0"
    folder.path.mkdir()
    (folder.path / "long.txt").write_text(line + " " * (1 << 14))
    (folder.path / "short.txt").write_text(line + "\n")
    assert {kept.name: bool(kept.shot) for kept in folder.shots()} == {
        "long": False, "short": True,
    }  # fmt: skip


def test_without_a_folder_the_page_says_that_nothing_can_be_saved(app):
    app.view.shots.path = None
    press(app, "ctrl+s", "return")
    assert app.view.page.said[0] == "shots.unsaved"


@pytest.mark.parametrize("name", ["a/b", "..", "con:1", "x" * 300, "  "])
def test_a_name_is_made_fit_for_a_file(tmp_path, app, name):
    if fit(name):
        saved = ShotFolder(tmp_path / "in").save(name, app.view.last.aimed())
        assert [file.parent for file in (tmp_path / "in").iterdir()] == [tmp_path / "in"]
        assert len(saved) <= 60
    else:
        with pytest.raises(ValueError, match="name"):
            ShotFolder(tmp_path).save(name, app.view.last.aimed())


@pytest.mark.parametrize("language", ["en", "ko"])
@pytest.mark.parametrize("size", [(640, 360), (1280, 720)])
def test_the_page_of_shots_is_drawn_and_its_buttons_are_pressed(tmp_path, language, size):
    app = an_app(size, lang=language)
    app.view.shots.path = tmp_path
    press(app, "ctrl+s")
    app.frame(FRAME)
    click(app, shots_view.button_rects(app.view.sight.layout)[0].center)
    assert app.view.page.said[0] == "shots.saved"
    assert_same_as_anew(app)
    row = shots_view.row_rect(app.view.sight.layout, 0).center
    click(app, row)
    assert app.session.page == ""


def test_the_page_of_keys_has_a_second_sheet():
    app = an_app()
    press(app, "f1", "right")
    assert app.view.keys_sheet == 1
    app.frame(FRAME)
    assert_same_as_anew(app)
    press(app, "right")
    assert app.view.keys_sheet == 0
