"""Every command of the game: one table, and what each does to the session.

To add one: a line in TABLE, and its words in both languages ("key." and its name, if it has a key).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from game.aim import advice, edit, thickness
from game.aim.entry import BOXES, Aim
from game.table import drill_lies, lineup, presets, shared
from game.text import LANGUAGES
from game.text.quoting import shortly

from . import match_commands as match
from . import play_commands as play
from . import saved, terms
from . import table_commands as table
from .action import Action
from .command import Command, HelpRow, Key
from .session import Session
from .values import (
    BOX_NUMBERS,
    FARTHEST,
    MOST_STEPS,
    PLACE,
    key_in,
    line,
    numbers,
    one_of,
    text,
    whole,
)

LAST = 99
"""Place of a row that has not been given any."""
PAGES = (
    "", "settings", "menu", "shelf", "rules", "score", "tracks", "save", "shots", "labs", "ask",
)  # fmt: skip
"""What may lie over the table: "ask" is a question alone."""


def perform(session: Session, action: Action, player: object = None) -> None:
    """Do an action, to the session or to the player's settings; KeyError if there is none like it.

    Without `player` there are no commands that only a player has.
    """
    command = COMMANDS[action.name]
    if command.own:
        if player is None:
            raise KeyError(action.name)
        command.do(player, *action.arguments)
        return
    if not command.keeps_notice:
        session.notice = None
    before = session.snapshot()
    command.do(session, *action.arguments)
    if _is_step(command, session, before.moving) or session.world is not before.world:
        session.history.note(before, session.snapshot(), writes=command.writes)
    session.did = action.name
    session.version += 1
    session.news += 1


def _is_step(command: Command, session: Session, moving: bool) -> bool:
    """Is what was done a step to undo?  In a match nothing is while balls move."""
    if not command.step or (command.drags and command.name == session.did):
        return False
    return session.contest is None or not moving


def fault(action: Action) -> str:
    """Say what is wrong with an action that a record says was done, or ""."""
    command = RECORDED.get(action.name) if isinstance(action.name, str) else None
    if command is None:
        return f"there is no action {shortly(list(action))}"
    wanted = command.fault(action.value)
    said = "nothing" if action.value is None else shortly(action.value)
    return f"{action.name} takes {wanted}, not {said}" if wanted else ""


def _own(name: str) -> Callable[..., None]:
    """A method of the player's settings as a command."""

    def do(player: object, *value: object) -> None:
        getattr(player, name)(*value)

    return do


def _aims(name: str, change: Callable[..., str | None], *how: Any, **more: Any) -> Command:
    """A command that writes the coming stroke."""
    return Command(name, play.aimed(change), *how, **more)._replace(aims=True)


_SHOT = numbers('"V FOLLOW MASSE SIDE ANGLE"', len(BOXES))
RECOVERED = 10
"""Numbers of the command `recover`, as `aim.drawn_path.Found` has them."""
_KEY = text("KEY")
_WAY = whole("WAY", -1, 1)
_TABLE = key_in("KEY", presets.TABLES)
TABLE = (
    Command("edit", play.edit_box, whole("BOX", 0, len(BOXES) - 1), (Key("left", 0), Key("tab", 0)),
            (HelpRow("play", 1, "@edit 0", "help.left"),
             HelpRow("box", 5, "Tab, Shift", "help.tab")), aims=True),
    Command("clear", play.clear, keys=(Key("right"),),
            rows=(HelpRow("play", 2, "@clear", "help.right"),), aims=True),
    Command("place", table.place, keys=(Key("down"),),
            rows=(HelpRow("play", 6, "@place", "help.down"),)),
    Command("stop", play.stop, keys=(Key("space"),),
            rows=(HelpRow("play", 7, "@stop", "help.space"),), hurries=True),
    Command("shoot", play.shoot, keys=(Key("return"), Key("kp_enter")),
            rows=(HelpRow("play", 4, "name.enter", "help.return"),), hurries=True),
    Command("pause", play.pause, keys=(Key("p"),), step=False,
            rows=(HelpRow("time", 1, "@pause", "help.pause"),)),
    Command("frame", play.frame, keys=(Key("period", shift=Action("event", 1)),),
            rows=(HelpRow("time", 3, "@back @frame", "help.frame"),), step=False, repeats=True),
    Command("engine", table.said(table.use_engine, "engine"), one_of("KEY", presets.ENGINES),
            (Key("e"),), (HelpRow("play", 9, "@engine", "help.engine"),), kept=True,
            ends_match="terms"),
    Command("law", table.said(table.use_law, "law"), one_of("KEY", presets.LAWS), (Key("l"),),
            (HelpRow("play", 10, "@law @compare", "help.laws"),), kept=True, ends_match="terms"),
    Command("retry", play.retry, keys=(Key("r"),),
            rows=(HelpRow("play", 8, "@retry", "help.retry"),)),
    Command("aids", _own("aids"), _KEY, (Key("a"),), (HelpRow("aim", 8, "@aids", "help.aids"),),
            own=True),
    Command("mute", _own("mute"), keys=(Key("m"),), own=True,
            rows=(HelpRow("always", 7, "@mute", "key.mute"),)),
    Command("skip", play.skip, keys=(Key("end"),), step=False, hurries=True,
            rows=(HelpRow("time", 5, "@home @skip", "help.skip"),)),
    Command("home", play.home, keys=(Key("home"),), rows=(), step=False),
    Command("back", play.back, keys=(Key("comma", shift=Action("event", -1)),), rows=(), step=False,
            repeats=True),
    Command("faster", play.faster, whole("STEPS", -MOST_STEPS, MOST_STEPS),
            (Key("leftbracket", -1), Key("rightbracket", 1)),
            (HelpRow("time", 2, "@faster -1 @faster 1", "help.rate"),), step=False),
    Command("undo", play.undo, keys=(Key("z", shift=Action("redo")),),
            rows=(HelpRow("time", 6, "@undo @redo", "help.undo"),), step=False),
    Command("redo", play.redo, keys=(Key("y"),), rows=(), step=False),
    _aims("turn", edit.turn, numbers("DEGREES", 1), (Key("q", "1"), Key("w", "-1")),
          (HelpRow("aim", 1, "@turn 1 @turn -1", "help.turn"),
           HelpRow("aim", 2, "Shift Ctrl+← →", "help.finer")), repeats=True, finer=("0.1", "0.01")),
    _aims("push", edit.push, numbers("SPEED", 1), (Key("pageup", "0.5"), Key("pagedown", "-0.5")),
          (HelpRow("aim", 3, "@push 0.5 @push -0.5", "help.push"),), repeats=True,
          finer=("0.1", "0.01")),
    Command("thicker", play.past(lambda now, way: thickness.neighbour(now, -way)), _WAY,
            (Key("t", 1, shift=Action("thicker", -1)),),
            (HelpRow("aim", 7, "@thicker 1", "help.thick"),), aims=True),
    _aims("centre", edit.centre, keys=(Key("c"),),
          rows=(HelpRow("aim", 6, "@centre @squirt", "help.centre"),)),
    Command("fan", _own("fan"), keys=(Key("f"),), own=True,
            rows=(HelpRow("aim", 9, "@fan", "help.fan"),)),
    Command("both", _own("both"), keys=(Key("n"),), own=True,
            rows=(HelpRow("always", 8, "@both @graphs @export", "help.log"),)),
    Command("graphs", _own("graphs"), keys=(Key("f8", always=True),), own=True, rows=()),
    Command("compare", _own("compare"), keys=(Key("x"),), own=True, rows=()),
    Command("export", _own("export"), keys=(Key("f12", always=True),), own=True, rows=()),
    Command("full", _own("full"), keys=(Key("f11", always=True),), own=True,
            rows=(HelpRow("always", 6.5, "@full", "key.full"),)),
    Command("diamonds", _own("diamonds"), _KEY, (Key("d"),), own=True,
            rows=(HelpRow("practice", 1, "@diamonds", "key.diamonds"),
                  HelpRow("practice", 2, "@sheet shelf", "help.drills"),
                  HelpRow("practice", 3, "@retry", "help.drill.again"))),
    Command("arrange", table.arrange, keys=(Key("b"),),
            rows=(HelpRow("play", 11, "@arrange", "key.arrange"),), aims=True),
    Command("squirt", table.squirt, one_of("KEY", table.SQUIRTS), (Key("j"),), (), kept=True,
            step=False, keeps_notice=True),
    Command("sketch", play.sketch, keys=(Key("g"),),
            rows=(HelpRow("aim", 9.5, "@sketch @coach 1", "help.sketch"),), step=False, aims=True),
    Command("recover", play.recover, numbers('"V FOLLOW MASSE SIDE ANGLE HOW WELL"', RECOVERED),
            aims=True, writes=True),
    Command("coach", play.coach, _WAY, (Key("h", 1, shift=Action("coach", -1)),), (),
            step=False, aims=True),
    Command("suggest", play.suggest, line("ADVICE", advice.read, "advice"), aims=True,
            writes=True),
    Command("ball", match.next_ball, _WAY, (Key("k", 1, shift=Action("ball", -1)),),
            (HelpRow("aim", 10, "@ball 1 @pocket 1", "help.call"),), aims=True),
    Command("pocket", match.next_pocket, _WAY, (Key("o", 1, shift=Action("pocket", -1)),), (),
            aims=True),
    Command("call", match.call, text("WHAT"), (Key("s", "safety"), Key("u", "push")),
            (HelpRow("aim", 11, "@call safety @call push", "help.safety"),), aims=True),
    Command("put", match.put, numbers('"X Y"', 2), drags=True),
    Command("answer", match.answer, text("OPTION"), aims=True),
    Command("help", table.keys, keys=(Key("f1", always=True),),
            rows=(HelpRow("always", 1, "@help", "help.help"),), keeps_notice=True),
    Command("language", table.language, one_of("KEY", LANGUAGES), (Key("f2", always=True),),
            (HelpRow("always", 2, "@language", "help.language"),), kept=True, keeps_notice=True),
    Command("settings", table.settings, keys=(Key("f3", always=True),),
            rows=(HelpRow("always", 3, "@settings", "key.settings"),), keeps_notice=True),
    Command("sheet", table.page, one_of("PAGE", PAGES),
            (Key("f4", "shelf", always=True), Key("f5", "rules", always=True),
             Key("f6", "score", always=True), Key("f7", "labs", always=True),
             Key("f9", "tracks", always=True),
             Key("f10", "menu", always=True),
             Key("escape", "menu")),
            (HelpRow("always", 4, "@sheet shelf @sheet labs", "help.shelf"),
             HelpRow("always", 5, "@sheet rules", "key.sheet rules"),
             HelpRow("always", 5.5, "@sheet score", "key.sheet score"),
             HelpRow("always", 5.7, "@sheet tracks", "key.sheet tracks"),
             HelpRow("always", 6, "@sheet menu", "key.sheet menu"),
             HelpRow("shots", 1, "Ctrl+S", "help.save"),
             HelpRow("shots", 2, "Ctrl+O", "help.open"),
             HelpRow("shots", 3, "Ctrl+C Ctrl+V", "help.copy"),
             HelpRow("shots", 4, "Ctrl+Z Ctrl+Y", "help.ctrl.undo")), keeps_notice=True),
    # what no key does that a player could choose
    Command("type", play.type_into, text("TEXT"),
            rows=(HelpRow("play", 3, "name.digits", "help.digit"),), aims=True),
    Command("enter", play.enter, rows=(HelpRow("box", 1, "name.enter", "help.next"),), aims=True),
    Command("erase", play.in_box(Aim.erase), rows=(HelpRow("box", 2, "name.back", "help.back"),),
            aims=True, repeats=True),
    Command("delete", play.in_box(Aim.delete), aims=True, repeats=True),
    Command("caret", play.in_box(Aim.go), PLACE,
            rows=(HelpRow("box", 3, "← → Home End", "help.caret"),
                  HelpRow("box", 4, "Ctrl+A C X V", "help.paste")), aims=True, repeats=True),
    Command("leave", play.in_box(Aim.leave), aims=True,
            rows=(HelpRow("box", 6, "Esc", "help.esc"),)),
    Command("fire", play.fire, hurries=True,
            rows=(HelpRow("play", 5, "Ctrl+Enter", "help.ctrl"),)),
    Command("event", play.event, _WAY, step=False,
            rows=(HelpRow("time", 4, "Shift+@back @frame", "help.event"),)),
    Command("scrub", play.seek, whole("TICKS", 0, FARTHEST), step=False),
    _aims("set", edit.put, BOX_NUMBERS),
    _aims("power", edit.power, numbers("SPEED", 1)),
    _aims("tip", edit.tip, numbers('"RIGHT UP"', 2), repeats=True),
    _aims("nudge", edit.nudge, numbers('"RIGHT UP"', 2), repeats=True,
          rows=(HelpRow("aim", 4, "Alt+← → ↑ ↓", "help.tip"),)),
    _aims("tilt", edit.tilt, numbers("DEGREES", 1), repeats=True,
          rows=(HelpRow("aim", 5, "Alt+PgUp PgDn", "help.tilt"),)),
    _aims("elevate", edit.elevate, numbers("DEGREES", 1)),
    Command("thick", play.past(lambda now, eighths: eighths), whole("EIGHTHS", -7, 7), aims=True),
    Command("next", play.show_next, keeps_notice=True, hurries=True),
    Command("intend", play.intend, _SHOT, keeps_notice=True),
    Command("play", play.play, _SHOT),
    Command("hold", table.hold, text("BALL"), aims=True),
    Command("move", table.move, numbers('"X Y"', 2), drags=True, aims=True),
    Command("match", table.match, line("TERMS", terms.read, "the terms of a match"),
            ends_match="begun"),
    Command("resume", table.resume, line("SAVED", saved.read, "a saved match"),
            ends_match="begun"),
    Command("line", table.line, line("LINE", lineup.read, "a set-up"), ends_match="always"),
    Command("open", table.open_shot, line("SHOT", shared.read, "a shot"), ends_match="always"),
    Command("drill", table.drill, one_of("NAME", drill_lies.NAMES, needed=True),
            ends_match="always"),
    Command("scene", table.scene, key_in("NAME", presets.SCENES, needed=True),
            ends_match="always"),
    Command("cloth", table.use_cloth, one_of("KEY", presets.CLOTHS), kept=True, ends_match="terms"),
    Command("table", table.table, _TABLE, kept=True, ends_match="always"),
    Command("still", _own("still"), own=True),
    Command("volume", _own("volume"), whole("0..10", 0, 10), own=True),
    Command("colours", _own("colours"), _KEY, own=True),
    Command("level", _own("level"), _KEY, own=True),
    Command("bind", _own("bind"), text('"COMMAND KEY"'), own=True),
    Command("unbind", _own("unbind"), text("COMMAND"), own=True),
    Command("quit", table.quit_game, ends_match="begun"),
)  # fmt: skip
"""In the order in which the settings page lists their keys."""
COMMANDS = {command.name: command for command in TABLE}
RECORDED = {name: one for name, one in COMMANDS.items() if not one.own and name != "quit"}
"""What a record may hold: not the player's own settings, and its end is written otherwise."""
Action.__doc__ = "\n    ".join((f"{Action.__doc__}\n", *(command.written() for command in TABLE)))


def rows() -> dict[str, list[HelpRow]]:
    """The rows of the page of keys by their sections, in their order."""
    found: dict[str, list[HelpRow]] = {}
    for row in sorted(_rows(), key=lambda row: row.place):
        found.setdefault(row.section, []).append(row)
    return found


def _rows() -> Iterator[HelpRow]:
    for command in TABLE:
        if command.rows is not None:
            yield from command.rows
            continue
        for key in command.keys:
            ident = Action(command.name, key.value).ident
            section = "aim" if command.aims else "always"  # there is room for more
            yield HelpRow(section, LAST, f"@{ident}", f"key.{ident}")
