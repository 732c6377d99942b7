"""Set-ups: how balls lie on a table, perhaps with a shot, as one line of text."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from math import isfinite

from danggu.players.drills import DRILLS, POOL, PYRAMID, SNOOKER
from danggu.players.positions import SAGU, SHELF, Position, opening
from danggu.players.spotting import take
from game.aim.entry import BOXES, fault, value
from game.aim.tip import STEEPEST
from game.text import LANGUAGES
from physics import Ball, EventDriven, World

from . import placing, presets

Place = tuple[float, float]
MARK = "danggu1"
"""First word of a line: what it is, and the version of the format."""
LONGEST_LINE = 4000
DOWN = "down"
"""Written in place of a place for a ball that is off the table."""
TOUCHING = 5e-10
"""Metres by which balls that touch may seem to overlap, for their places are rounded: half of what
a world lets pass, so that it takes what is taken here."""

UNMADE = (ArithmeticError, AttributeError, LookupError, RuntimeError, TypeError, ValueError)
"""Raised by a set-up whose world cannot be made: no reason for a game to end."""


class LineError(ValueError):
    """A line that is no set-up: `reason` is a key of the texts, `word` what is wrong."""

    def __init__(self, reason: str, word: str = "") -> None:
        self.reason, self.word = reason, word[:24]
        super().__init__(LANGUAGES["en"][f"line.{reason}"].format(word=self.word))


@dataclass(frozen=True, slots=True)
class Lineup:
    """How balls lie, perhaps with a shot.

    table  a key of `presets.TABLES` or `presets.SCENES`
    balls  names and places, m
    texts  the five of a shot, and the elevation of a cue that makes it hop; or none
    down   names of the balls that are off the table
    """

    table: str
    balls: tuple[tuple[str, Place], ...]
    texts: tuple[str, ...] = ()
    down: tuple[str, ...] = ()

    def line(self) -> str:
        """The set-up in one line, to the last bit; `read` takes it back."""
        parts = [MARK, self.table]
        parts += [f"{name.replace(' ', '_')}={x!r},{y!r}" for name, (x, y) in self.balls]
        parts += [f"{name.replace(' ', '_')}={DOWN}" for name in self.down]
        texts = [text.strip() for text in self.texts]  # a space would end the word
        return " ".join(parts + ["shot=" + ",".join(texts)] * bool(texts))

    def world(self) -> World:
        """The table with these balls at rest."""
        world, places = _table(self.table), dict(self.balls)
        if self.table in presets.TABLES:
            for ball in _balls(self.table, [*places, *self.down]).values():
                world.add(ball)
        world.stop()
        for ball in world.balls:
            ball.spin = (0.0, 0.0, 0.0)
            ball.position = places.get(ball.name, ball.position)
        for name in self.down:
            take(world, name)
        return world


def read(line: str) -> Lineup:
    """The set-up in a line; LineError says what is wrong with it."""
    parts = line.split()
    if len(line) > LONGEST_LINE or not parts or parts[0] != MARK:
        raise LineError("mark", parts[0] if parts else "")
    known = len(parts) > 1 and (parts[1] in presets.TABLES or parts[1] in presets.SCENES)
    if not known:
        raise LineError("table", parts[1] if len(parts) > 1 else "")
    texts: tuple[str, ...] = ()
    if parts[-1].startswith("shot="):
        texts = _shot(parts.pop())
    gone = [word for word in parts[2:] if word.endswith(f"={DOWN}")]
    balls = tuple(_ball(word) for word in parts[2:] if word not in gone)
    down = tuple(word.partition("=")[0].replace("_", " ") for word in gone)
    found = Lineup(parts[1], balls, texts, down)
    _check(found)
    return found


def _ball(word: str) -> tuple[str, Place]:
    name, _, place = word.partition("=")
    try:
        x, y = map(float, place.split(","))
    except ValueError:
        raise LineError("ball", word) from None
    if not name or not (isfinite(x) and isfinite(y)):
        raise LineError("ball", word)
    return name.replace("_", " "), (x, y)


def _shot(word: str) -> tuple[str, ...]:
    texts = tuple(word.removeprefix("shot=").split(","))
    boxes, raised = texts[: len(BOXES)], texts[len(BOXES) :]
    if len(boxes) != len(BOXES) or any(fault(i, text) for i, text in enumerate(boxes)):
        raise LineError("shot", word)
    if len(raised) > 1 or any(not _elevation(text) for text in raised):
        raise LineError("shot", word)
    return texts


def _elevation(text: str) -> bool:
    """Is it an elevation that a cue can have?"""
    try:
        return 0.0 < value(text) <= STEEPEST
    except ValueError:
        return False


def _check(found: Lineup) -> None:
    """LineError for balls that are unknown, there twice, missing, outside or in each other."""
    names = [*(name for name, _ in found.balls), *found.down]
    if len({*names}) < len(names):
        raise LineError("twice", next(n for n in names if names.count(n) > 1))
    balls = _balls(found.table, names)
    for name in names:
        if name not in balls:
            raise LineError("name", name)
    lost = [ball.name for ball in _table(found.table).balls if ball.name not in names]
    if lost or not found.balls:
        raise LineError("missing", ", ".join(lost or [*presets.BALLS][:1]))
    if {"cue", "white"} & {*found.down}:
        raise LineError("down", ", ".join({"cue", "white"} & {*found.down}))
    table = _table(found.table)
    for i, (name, at) in enumerate(found.balls):
        if not placing.fits(table, at, balls[name].radius - TOUCHING):
            raise LineError("outside", name)
        for other, spot in found.balls[:i]:
            apart = abs(complex(*at) - complex(*spot))
            if apart < balls[name].touching_distance(balls[other]) - TOUCHING:
                raise LineError("overlap", f"{other}, {name}")


def _table(table: str) -> World:
    """A table without balls, or a scene with its own."""
    return presets.TABLES[table].world() if table in presets.TABLES else presets.scene_world(table)


def _balls(table: str, names: list[str]) -> dict[str, Ball]:
    """Those balls of a table that are called `names`, new and wherever they lie."""
    if table in presets.TABLES:
        kind = presets.TABLES[table]
        known = presets.known(table)
        return {
            name: Ball(name, (0.0, 0.0), radius=kind.radius, mass=kind.mass)
            for name in names
            if name in known
        }
    return {ball.name: ball for ball in presets.scene_world(table).balls if ball.name in names}


def of(world: World, table: str, texts: Sequence[str] = ()) -> Lineup:
    """How balls lie on a table, with the five texts of a shot if there are any.

    Balls that fixed steps have left in each other are parted: a line has to be read again.
    """
    world = world.copy()
    world.engine = EventDriven()
    world.part()
    balls = tuple((ball.name, ball.position) for ball in world.balls if not ball.gone)
    down = tuple(ball.name for ball in world.balls if ball.gone)
    return Lineup(table, balls, tuple(texts), down)


# -- the shelf -----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Ready:
    """A set-up that comes with the program: its group and the key of its name."""

    group: str
    key: str
    lineup: Lineup


def shelf() -> Iterator[Ready]:
    """Every ready set-up: the games' positions, openings first, then the physics scenes.

    One that cannot be made is left out with a RuntimeWarning: the others are still there.
    """
    for group, key, make in _makers():
        try:
            yield Ready(group, key, make())
        except UNMADE as error:
            said = f"set-up {key!r} is left out: {error!r}"
            warnings.warn(said, RuntimeWarning, stacklevel=2)


def _makers() -> Iterator[tuple[str, str, Callable[[], Lineup]]]:
    """Group and key of each ready set-up, and what makes it."""
    for group, table in (("sagu", "medium"), ("three_cushion", "match")):
        for position in [opening(group), *(p for p in SHELF if p.game == group)]:
            yield group, position.key, partial(_of_position, position, table)
    for group, key, table, rack in RACKS:
        yield group, key, partial(_of_rack, table, rack)
    for position in DRILLS:
        yield position.game, position.key, partial(_of_drill, position)
    for name in presets.SCENES:
        yield "scenes", name, partial(_of_scene, name)


RACKS = (
    ("pool", "rack_8", "pool-9", "8-ball"), ("pool", "rack_9", "pool-9", "9-ball"),
    ("snooker", "opening", "snooker", "snooker"), ("pyramid", "opening", "pyramid", "pyramid"),
)  # fmt: skip
TABLES = {POOL: "pool-9", SNOOKER: "snooker", PYRAMID: "pyramid"}


def _of_rack(table: str, rack: str) -> Lineup:
    """The opening of a game with a rack."""
    world = presets.table_world(table)
    cue = world.ball("cue").position
    balls = [(ball.name, ball.position) for ball in world.table.rack(rack)]
    return Lineup(table, (("cue", cue), *balls))


def _of_scene(name: str) -> Lineup:
    balls = presets.scene_world(name).balls
    return Lineup(name, tuple((ball.name, ball.position) for ball in balls))


def _of_drill(position: Position) -> Lineup:
    kind = presets.TABLES[TABLES[position.game]]
    angle, speed, right, up = position.answer
    spins = f"{2.5 * speed * up:.4g}", "0", f"{2.5 * speed * right:.4g}"
    places = position.on(kind.length, kind.width)
    return Lineup(TABLES[position.game], (*places.items(),), (f"{speed:g}", *spins, f"{angle:g}"))


def _of_position(position: Position, table: str) -> Lineup:
    kind = presets.TABLES[table]
    spots = position.on(kind.length, kind.width)
    reds = ("red1", "red2") if position.game == SAGU else ("red",)
    return Lineup(table, tuple((name, spots[name]) for name in ("white", "yellow", *reds)))
