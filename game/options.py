"""The command line."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from typing import NoReturn

from physics import commandline

from .contradictions import VIEW, contradiction
from .replay.script_format import FORMAT
from .session import terms
from .table import presets
from .text import LANGUAGES
from .text.quoting import shortly

PICTURES = (".png", ".jpg", ".jpeg", ".bmp", ".tga")
"""How the name of a picture ends: pygame writes these, and anything else as a TGA."""
SIGNS = """\
the five numbers:
  V      speed of the cue ball, m/s
  WxR    follow, - draw, m/s
  WyR    masse: curves to the right, - to the left, m/s
  WzR    right english (tip right of the centre, anticlockwise from above), - left, m/s
  angle  degrees, anticlockwise: 0 to the right, 90 away from you

without the game, each with --help:
  danggu lab    worksheets for a course of mechanics
  danggu sweep  what shots are worth by the rules"""
SMALLEST = (640, 360)
LARGEST = 16384


@dataclass(frozen=True, slots=True)
class Options:
    """What the command line asks for; `virtual` time does not wait for the clock on the wall.

    edition  of the presets: that of the record which is played
    given    the options that the command line has named
    """

    seed: int = 0
    substeps: int = 6
    table: str = "medium"
    scene: str | None = None
    engine: str = "exact"
    law: str | None = None
    lang: str = "en"
    size: tuple[int, int] = (1280, 720)
    fps: int = 60
    frames: int | None = None
    script: str | None = None
    screenshot: str | None = None
    stats: bool = False
    version: bool = False
    cloth: str = "table"
    game: str = "free"
    players: str | None = None
    level: str | None = None
    handicap: str | None = None
    finish: str | None = None
    edition: int = presets.EDITION
    setup: str | None = None
    settings: str | None = None
    record: str | None = None
    replay: str | None = None
    headless: bool = False
    given: frozenset[str] = frozenset()

    @property
    def virtual(self) -> bool:
        """With a fixed number of frames time is counted in frames: fast, the same every time."""
        return self.frames is not None


def read(arguments: list[str] | None = None) -> Options:
    """Read the command line; on anything unknown say so on stderr and exit with 2."""
    parser = _parser()
    found = vars(parser.parse_args(arguments))
    if wrong := contradiction(found):
        parser.error(wrong)
    if found.get("game", terms.FREE) != terms.FREE:
        found.setdefault("table", terms.DISCIPLINES[found["game"]].table)
    return Options(**found, given=frozenset(found))


def of_setup(begun: Mapping[str, object], options: Options) -> Options:
    """Return the options with those of a game that was recorded; ValueError if there are none such.

    They are read as the command line is: what it refuses is refused here.
    """
    usual = {f.name: f.default for f in fields(Options) if f.name not in VIEW}
    said = {name: value for name, value in begun.items() if value is not None}
    for name, value in said.items():
        if name not in usual:
            raise ValueError(f"unknown setup: {shortly(name)}")
        if type(value) not in (str, int):
            raise ValueError(f"{name} is {shortly(value)}: text or a whole number was expected")
    words = [f"--{name}={value}" for name, value in said.items()]
    return replace(options, **{**usual, **vars(_parser(_Raising).parse_args(words))})


def asked(options: Options) -> terms.Terms:
    """The match that the command line asks for; ValueError names what is wrong with it."""
    said = (options.players or "2").split(",")
    names = said
    if len(said) == 1 and said[0].strip("+-").isdecimal():
        if said[0] not in ("1", "2"):
            raise ValueError(f"players must be 1 or 2, not {said[0]:.20}")
        names = [""] * int(said[0])
    levels = (options.level or terms.HUMAN).split(",")
    if len(levels) < len(names):
        levels = [terms.HUMAN] * (len(names) - len(levels)) + levels
    goals = (options.handicap or "10").split(",")
    goals += goals[-1:] * (len(names) - len(goals))
    for said, whole in ((levels, options.level), (goals, options.handicap)):
        if len(said) > len(names):
            raise ValueError(f"{whole!r:.60} is for {len(said)} players: there are {len(names)}")
    if not all(re.fullmatch(r"\d{1,9}", goal) for goal in goals):
        raise ValueError(f"a handicap is a whole number, not {options.handicap!r:.60}")
    seats = tuple(
        terms.Contestant(n.strip(), v, int(g)) for n, v, g in zip(names, levels, goals, strict=True)
    )
    law, finish = options.law or "table", options.finish or terms.EXTRA_3C
    played_on = options.table, options.cloth, law, options.engine
    return terms.Terms(options.game, seats, *played_on, finish, seed=options.seed % (1 << 32))


class _Raising(commandline.Parser):
    """Says what is wrong to the program instead of to the terminal."""

    def error(self, message: str) -> NoReturn:
        raise ValueError(message)


def _parser(
    kind: type[commandline.Parser] = commandline.Parser,
) -> argparse.ArgumentParser:
    parser = kind(
        prog="danggu",
        description="Billiards with exact physics: type V, three spins and an angle, and watch.",
        epilog=f"{SIGNS}\n\n{FORMAT}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
        argument_default=argparse.SUPPRESS,
    )
    add = parser.add_argument
    add("--seed", type=_count(-(2**64), 2**64), metavar="N", help="for placing balls at random")
    add("--substeps", type=_count(1, 1000), metavar="N", help="physics calls a frame (6)")
    add("--table", choices=presets.TABLES, help="table and its balls (medium)")
    add("--scene", choices=[*presets.SCENES], help="begin with a scene of the physics package")
    _add_match(parser)
    add("--setup", metavar="LINE", help="balls as a copied line says, perhaps with a shot")
    add("--cloth", choices=[*presets.CLOTHS], help="condition of the cloth (the table's)")
    add("--engine", choices=[*presets.ENGINES], help="exact events (exact), or time steps")
    add("--law", choices=[*presets.LAWS], help="laws of collision (the table's)")
    add("--lang", choices=[*LANGUAGES], help="language")
    add("--size", type=_size, metavar="WxH", help="window, pixels (1280x720)")
    add("--fps", type=_count(1, 1000), metavar="N", help="frames a second (60)")
    add(
        "--frames",
        type=_count(1, 10**9),
        metavar="N",
        help="stop after N frames, shown or not where there is no display; time is then counted "
        "in frames, as fast as they can be drawn",
    )
    add("--script", metavar="FILE", help="keys and text to play, see below")
    add("--record", metavar="FILE", help="write down what is done, so that it can be replayed")
    add("--replay", metavar="FILE", help="play a record; 3 if it comes out differently")
    add("--headless", action="store_true", help="replay without a window, as fast as it goes")
    add("--settings", metavar="FILE", help="keep settings there; else in the user's folder")
    add("--screenshot", type=_picture, metavar="FILE", help="save the last picture (.png)")
    add("--stats", action="store_true", help="print counts: frames, physics calls, events")
    add("--version", action="store_true", help="print which pygame is in use")
    return parser


def _add_match(parser: argparse.ArgumentParser) -> None:
    """Add the options that begin a match."""
    add = parser.add_argument
    add("--game", choices=terms.GAMES, help="what to play (free)")
    add("--players", metavar="N|NAMES", help="1 or 2, or their names: Ann,Bo (2)")
    add(
        "--level",
        metavar="LEVELS",
        help=f"who plays: {', '.join(terms.SEATS)}; for each, or last",
    )
    goals = "points to reach, for each player or for all (10); not in games won by racks"
    add("--handicap", metavar="POINTS", help=goals)
    add("--finish", choices=terms.FINISHES, help="how a game of 4-ball ends (extra_3c)")


def _count(least: int, most: int) -> Callable[[str], int]:
    def number(text: str) -> int:
        if not re.fullmatch(r"[+-]?\d{1,20}", text) or not least <= int(text) <= most:
            wanted = f"must be a whole number from {least} to {most}"
            raise argparse.ArgumentTypeError(f"{wanted}: {text!r:.60}")
        return int(text)

    return number


def _picture(text: str) -> str:
    if not text.lower().endswith(PICTURES):
        raise argparse.ArgumentTypeError(f"must end in {', '.join(PICTURES)}: {text!r:.60}")
    return text


def _size(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d{1,5})[xX×](\d{1,5})", text)
    if not found:
        raise argparse.ArgumentTypeError(f"must be written like 1280x720: {text!r:.60}")
    width, height = int(found[1]), int(found[2])
    if width < SMALLEST[0] or height < SMALLEST[1] or max(width, height) > LARGEST:
        least = "x".join(map(str, SMALLEST))
        raise argparse.ArgumentTypeError(f"must be from {least} to {LARGEST} a side: {text!r:.60}")
    return width, height
