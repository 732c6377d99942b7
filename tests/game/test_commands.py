"""The table of commands: whatever shows or asks about a command finds it there."""

import re

import pytest

from game.input.bindings import DEFAULTS
from game.input.key_tables import CODES
from game.replay.replay import Replay
from game.session.action import Action
from game.session.command import Command, HelpRow, Key
from game.session.commands import COMMANDS, TABLE, perform, rows
from game.session.session import Session
from game.settings.preferences import Preferences
from game.table.presets import table_world
from game.text import LANGUAGES
from game.ui.pages import help as keys_page
from tests.support.players import an_app, press

BY_NAME = pytest.mark.parametrize("command", TABLE, ids=lambda command: command.name)


def test_no_two_commands_have_one_name():
    assert len(COMMANDS) == len(TABLE)


def test_the_docstring_of_actions_names_every_command_and_what_it_takes():
    told = [line.strip() for line in Action.__doc__.splitlines()]
    assert told[2:] == [command.written() for command in TABLE]


@BY_NAME
def test_the_keys_of_a_command_exist_and_give_it_a_value_that_it_takes(command: Command):
    for key in command.keys:
        assert key.name in CODES
        assert command.fault(key.value) == "" or (command.own and key.value is None)
        if key.shift is not None:
            assert COMMANDS[key.shift.name].fault(key.shift.value) == ""


@BY_NAME
def test_a_command_of_the_players_settings_is_a_method_of_theirs(command: Command):
    assert callable(getattr(Preferences, command.name, None)) or not command.own


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_key_that_can_be_chosen_and_every_row_has_its_words(language):
    known = LANGUAGES[language]
    assert {f"key.{name}" for name in DEFAULTS} <= known.keys()
    for section, found in rows().items():
        assert f"help.{section}" in known
        assert {row.text for row in found} <= known.keys()


def test_the_page_of_keys_shows_every_row_of_the_table_once():
    shown = [row for column in keys_page.COLUMNS for name in column for row in keys_page.rows(name)]
    told = [row for command in TABLE for row in command.rows or ()]
    assert [row for row in shown if row.section != "numbers"] != []
    assert {*told} <= {*shown}
    assert len({(row.section, row.text) for row in shown}) == len(shown)


def test_a_command_with_a_key_and_no_rows_gets_a_row_for_the_key(monkeypatch):
    added = Command("dance", lambda session: None, keys=(Key("d"),))
    monkeypatch.setattr("game.session.commands.TABLE", (*TABLE, added))
    assert rows()["always"][-1] == HelpRow("always", 99, "@dance", "key.dance")
    aims = added._replace(name="jump", aims=True)
    monkeypatch.setattr("game.session.commands.TABLE", (*TABLE, aims))
    assert rows()["aim"][-1] == HelpRow("aim", 99, "@jump", "key.jump")


@pytest.mark.parametrize("name", DEFAULTS)
def test_every_key_that_can_be_chosen_stands_on_the_page_of_keys(name):
    written = [row.keys for found in rows().values() for row in found]
    assert any(re.search(rf"@{re.escape(name)}(?= |$)", keys) for keys in written)


@pytest.mark.parametrize("sections", keys_page.COLUMNS, ids=" ".join)
def test_the_rows_of_the_page_of_keys_end_above_what_it_says_of_the_mouse(sections):
    count = sum(len(keys_page.rows(name)) for name in sections)
    end = 70 + keys_page.ROW * count + (8 + 24) * len(sections) - 24  # px at s = 1
    assert end + 13 <= 584 - (16 + 20 * (len(keys_page.MOUSE) - 1))


def test_a_session_has_no_commands_that_only_a_player_has():
    session = Session(table_world("medium"))
    with pytest.raises(KeyError, match="mute"):
        perform(session, Action("mute"))


def test_nothing_outside_the_table_can_be_done():
    with pytest.raises(KeyError, match="dance"):
        perform(Session(table_world("medium")), Action("dance"))
    assert not hasattr(Session, "perform")
    assert not hasattr(Preferences, "perform")
    assert Replay.perform.__doc__


def test_one_event_is_asked_about_once(monkeypatch):
    app, asked = an_app(), []
    monkeypatch.setattr(
        app.layers,
        "ask",
        lambda *event: asked.append(event) or type(app.layers).ask(app.layers, *event),
    )
    press(app, "f1", "escape", "f10", "escape", "left", "4", "tab")
    assert len(asked) == 7
