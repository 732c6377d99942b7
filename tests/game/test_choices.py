"""What can be chosen and what comes of it: keys, aids, colours, another table, a cloth."""

import pytest

from game.input import bindings
from game.input.bindings import DEFAULTS, Keys
from game.session.action import Action
from game.table import presets
from tests.support.players import FRAME, FREE, SPARE, an_app, pixels, press

# -- keys ----------------------------------------------------------------------------------------


def test_no_two_actions_have_the_same_key_and_none_types_into_boxes_from_play():
    names = [binding.key for binding in DEFAULTS.values()]
    assert len(set(names)) == len(names)
    assert not [name for name, b in DEFAULTS.items() if bindings.refused(name, b.key)]


@pytest.mark.parametrize(
    ("key", "why"),
    [("r", "taken"), ("3", "types"), ("minus", "types"), ("kp_plus", "types"), ("kp5", "types"),
     ("return", "fixed"), ("tab", "fixed"), ("lshift", "fixed"), ("moon", "unknown")],
)  # fmt: skip
def test_a_key_that_cannot_be_had_says_why(key, why):
    with pytest.raises(ValueError, match=why):
        Keys().with_key("pause", key)


def test_letters_that_type_are_free_in_play_but_not_for_keys_that_work_in_boxes():
    assert Keys({"engine": FREE}).with_key("pause", "e").names["pause"] == "e"
    with pytest.raises(ValueError, match="types"):
        Keys({"engine": FREE}).with_key("help", "e")


def test_keys_in_a_file_may_be_swapped_but_not_doubled():
    swapped = {"pause": "space", "stop": "p"}
    assert bindings.sound(swapped) == (swapped, [])
    assert bindings.sound({"pause": "r"}) == ({}, ["pause"])
    good, bad = bindings.sound({"pause": FREE, "stop": FREE})
    assert len(good) == len(bad) == 1
    assert bindings.sound({"pause": "3", "dance": FREE, "stop": 5, "retry": SPARE}) == (
        {"retry": SPARE},
        ["pause", "dance", "stop"],
    )


def test_a_changed_key_does_what_the_old_one_did():
    app = an_app()
    app.perform(Action("bind", f"pause {FREE}"))
    press(app, "p")
    assert not app.session.paused
    press(app, FREE)
    assert app.session.paused
    app.perform(Action("unbind", "pause"))
    press(app, FREE)
    assert app.session.paused
    press(app, "p")
    assert not app.session.paused


def test_a_key_that_has_been_taken_meanwhile_cannot_come_back():
    app = an_app()
    app.perform(Action("bind", f"pause {FREE}"))
    app.perform(Action("bind", "stop p"))
    app.perform(Action("unbind", "pause"))
    assert app.preferences.keys.names["pause"] == FREE
    assert app.preferences.refused == ("taken", "pause", "p")


# -- what is seen of it --------------------------------------------------------------------------


def test_aids_take_lines_away_level_by_level():
    pictures = []
    for level in ("full", "short", "off"):
        app = an_app()
        app.perform(Action("aids", level))
        app.frame(FRAME)
        pictures.append(pixels(app))
    full, short, off = pictures

    def changed(a, b):
        return sum(p != q for p, q in zip(a, b, strict=True))

    assert changed(off, short) > 0
    assert changed(off, full) > changed(off, short)


def test_the_key_for_aids_goes_round_its_levels():
    app = an_app()
    levels = []
    for _ in range(4):
        levels.append(app.preferences.settings.aids)
        press(app, "a")
    assert levels == ["full", "off", "short", "full"]


def test_safe_colours_show_at_once_and_on_every_ball():
    app = an_app()
    before = [look.body for look in app.view.stage.looks]
    app.perform(Action("colours", "safe"))
    app.frame(FRAME)
    after = [look.body for look in app.view.stage.looks]
    assert all(a != b for a, b in zip(before, after, strict=True))


def test_another_table_is_laid_with_its_own_cloth_and_laws():
    app = an_app()
    app.perform(Action("cloth", "new"))
    app.perform(Action("law", "mathavan"))
    app.perform(Action("engine", "thesis"))
    app.perform(Action("table", "match"))
    app.frame(FRAME)
    assert [ball.name for ball in app.session.world.balls] == ["white", "yellow", "red"]
    assert (app.session.cloth, app.session.law, app.session.engine) == ("table", "rigid", "thesis")
    assert app.session.world.engine == presets.ENGINES["thesis"]()
    assert app.preferences.settings.law == "table"
    assert app.view.sight.layout.length == presets.TABLES["match"].length


def test_a_cloth_is_the_one_that_was_chosen_and_the_tables_own_comes_back():
    app = an_app()
    own = app.session.world.cloth
    app.perform(Action("cloth", "humid"))
    assert app.session.world.cloth.slide == 0.4
    app.perform(Action("cloth", "table"))
    assert app.session.world.cloth == own
