"""Two games at once: what one has saved the other does not lose."""

import os
import subprocess
import sys
import time

import pytest

from game.settings import user_files
from game.settings.settings import Settings, Store
from game.table.library import Library
from game.table.lineup import read as lineup
from tests.support.players import FREE, SPARE, an_app, press

LINE = lineup("danggu1 medium white=-0.5,0.0 red1=0.5,0.25")
OTHER = lineup("danggu1 medium white=0.1,0.0")


@pytest.fixture
def path(tmp_path):
    return tmp_path / "x.json"


# -- settings ------------------------------------------------------------------------------------


@pytest.mark.parametrize("there", [True, False])
def test_each_game_saves_what_it_has_changed_and_nothing_else(path, there):
    if there:
        Store(path).save(Settings(table="match", keys={"pause": FREE}))
    one, two = Store(path), Store(path)
    first, second = one.load(), two.load()
    first.volume, first.keys = 2, {**first.keys, "retry": SPARE}
    second.language, second.muted, second.keys = "ko", True, {}
    assert one.save(first)
    assert two.save(second)
    both = Store(path).load()
    assert (both.volume, both.language, both.muted) == (2, "ko", True)
    assert both.table == ("match" if there else "medium")
    assert both.keys == {"retry": SPARE}


def test_a_game_keeps_its_own_settings_when_another_one_saves(path):
    one, two = Store(path), Store(path)
    first, second = one.load(), two.load()
    first.volume = 2
    one.save(first)
    second.still = True
    two.save(second)
    assert second.volume == Settings().volume
    second.still = False
    two.save(second)
    assert Store(path).load() == Settings(volume=2)


def test_two_keys_that_two_games_have_given_to_two_actions_are_not_one(path):
    one, two = Store(path), Store(path)
    first, second = one.load(), two.load()
    first.keys = {"pause": FREE}
    second.keys = {"retry": FREE}
    one.save(first)
    two.save(second)
    last = Store(path)
    assert len(last.load().keys) == 1
    assert last.faults == []


def test_settings_that_were_broken_meanwhile_are_set_aside_and_written_whole(path):
    store = Store(path)
    store.save(Settings(language="ko"))
    path.write_text("broken")
    assert store.save(Settings(language="ko", volume=2))
    assert Store(path).load() == Settings(language="ko", volume=2)
    assert path.with_name("x.json.broken").read_text() == "broken"


# -- set-ups -------------------------------------------------------------------------------------


def test_set_ups_of_both_games_are_in_the_file(path):
    one, two = Library(path), Library(path)
    assert one.items == two.items == {}
    assert one.put("a", LINE)
    assert two.put("b", LINE)
    assert one.put("c", LINE)
    assert two.remove("b")
    assert list(Library(path).items) == ["a", "c"]


def test_a_name_that_another_game_has_taken_gets_a_number(path):
    one, two = Library(path), Library(path)
    assert one.items == two.items == {}
    one.put("mine", LINE)
    two.put("mine", OTHER)
    assert Library(path).items == {"mine": LINE, "mine (2)": OTHER}
    two.put("mine (2)", LINE)
    assert Library(path).items == {"mine": LINE, "mine (2)": LINE}


def test_what_another_game_has_put_under_a_name_is_not_removed(path):
    Library(path).put("a", LINE)
    one, two = Library(path), Library(path)
    assert list(one.items) == list(two.items) == ["a"]
    one.put("a", OTHER)
    two.remove("a")
    assert Library(path).items == {"a": OTHER}


@pytest.mark.parametrize("loss", ["broken", ""])
def test_set_ups_on_show_survive_the_loss_of_the_file(path, loss):
    library = Library(path)
    library.put("a", LINE)
    if loss:
        path.write_text(loss)
    else:
        path.unlink()
    assert library.put("b", OTHER)
    assert Library(path).items == {"a": LINE, "b": OTHER}


def test_many_games_that_save_at_the_same_time_lose_nothing(path):
    code = (
        "import sys; from pathlib import Path; from game.table.library import Library, read\n"
        "for k in range(15):\n"
        "    library = Library(Path(sys.argv[1])); library.items\n"
        "    assert library.put(f'{sys.argv[2]} {k}', read('danggu1 medium white=0.1,0.0'))\n"
    )
    games = [subprocess.Popen([sys.executable, "-c", code, str(path), name]) for name in "abc"]
    assert [session.wait(timeout=60) for session in games] == [0, 0, 0]
    assert set(Library(path).items) == {f"{name} {k}" for name in "abc" for k in range(15)}
    assert [p.name for p in path.parent.iterdir()] == ["x.json"]


@pytest.mark.skipif(os.name != "posix", reason="the lock of the folder")
def test_a_game_that_hangs_with_the_lock_holds_nobody_up_for_long(path, monkeypatch):
    monkeypatch.setattr(user_files, "PATIENCE", 0.05)
    with user_files.alone(path):
        begun = time.monotonic()
        assert Library(path).put("a", LINE)
        assert time.monotonic() - begun < 2.0


# -- names ---------------------------------------------------------------------------------------


def test_names_that_begin_alike_are_two_names(path):
    library, begin = Library(path), "x" * 24
    assert library.put(begin + " one", LINE)
    assert library.put(begin + " two", OTHER)
    assert Library(path).items == {begin + " one": LINE, begin + " two": OTHER}


def written(path, names):
    line = LINE.line()
    pairs = ",".join(f'"{name}": "{line}"' for name in names)
    path.write_text(f'{{"format":"danggu set-ups","version":1,"set-ups":{{{pairs}}}}}')
    return Library(path)


@pytest.mark.parametrize(
    ("names", "shown"),
    [
        ([r"a\u0000b", r"a\u0001b"], ["a\ufffdb", "a\ufffdb (2)"]),
        ([r"\ud800"], ["\ufffd"]),
        ([r"a\u2028b", r"a\nb", "a b"], ["a b", "a b (2)", "a b (3)"]),
        (["a", "a", "a"], ["a", "a (2)", "a (3)"]),
        (["b (2)", "b", "b"], ["b (2)", "b", "b (3)"]),
    ],
)
def test_a_name_that_cannot_be_shown_or_is_there_twice_is_mended_and_loses_nothing(
    path, names, shown
):
    library = written(path, names)
    assert list(library.items) == shown
    assert library.put("new", OTHER)
    assert list(Library(path).items) == [*shown, "new"]


def test_a_set_up_with_a_name_that_cannot_be_written_does_not_end_the_game(path):
    assert Library(path).put("a\ud800b\0c", LINE)
    assert list(Library(path).items) == ["a\ufffdb\ufffdc"]


def test_nothing_is_written_before_something_is_saved(path):
    path.write_text("broken")
    assert Library(path).items == {}
    assert [p.name for p in path.parent.iterdir()] == ["x.json"]


def test_set_ups_of_a_later_version_are_set_aside_before_they_are_written_as_this_one(path):
    library = written(path, ["a"])
    text = path.read_text().replace('"version":1', '"version":2')
    path.write_text(text)
    assert library.put("b", OTHER)
    assert path.with_name("x.json.broken").read_text() == text
    assert list(Library(path).items) == ["a", "b"]


def test_the_shelf_shows_set_ups_whatever_their_names_are(path):
    names = [r"a\u0000b", r"\ud800", r"c\u2028d", "x" * 3000]
    app = an_app()
    app.view.pages["shelf"].library = written(path, names)
    press(app, "f4", "pageup")
    assert [len(card.name) for card in app.view.pages["shelf"].cards] == [3, 1, 3, 3000]
