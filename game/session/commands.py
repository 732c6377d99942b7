"""What menu, shelf and computer do to a game: actions like a player's, each a function of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.aim.entry import BOXES
from game.table import lineup, placing, presets
from physics import World

from . import equipment, terms
from .running_match import Contest

if TYPE_CHECKING:
    from .session import Game


def sheet(game: Game, name: str = "") -> None:
    """Lay a page over the table ("menu" "shelf" "rules" "settings"), or take it away ("")."""
    game.sheet = "" if game.sheet == name else name
    game.aim.leave()


def match(game: Game, line: str) -> None:
    """Begin what a fixture says; ValueError for a line that is none."""
    wanted = terms.read(line)
    game.sheet = ""
    if wanted.game != terms.FREE:
        game.engine = wanted.engine
    _begin(game, wanted.world(), wanted.table)
    if wanted.law != "table":
        equipment.law(game, wanted.law)
    if wanted.cloth != "table":
        equipment.cloth(game, wanted.cloth)
    game.contest = Contest.of(wanted)
    if game.contest is not None:
        game.contest.seat(game)
        game.contest.given = False
        game.contest.give_boxes(game)
        game.aim.finish()


def _begin(game: Game, world: World, table: str) -> None:
    """Play on another table with the engine that was in use."""
    game.begin(world, table)
    equipment.engine(game, game.engine)


def show_next(game: Game) -> None:
    """Show the coming stroke in place of the last one."""
    game.show_aim()
    game.aim.leave()
    game.aim.finish()


def intend(game: Game, numbers: str) -> None:
    """Write five numbers into the boxes: the stroke that the computer means to play."""
    words = numbers.split()
    if len(words) == len(BOXES) and not game.moving:
        game.shown_shot = False
        game.aim.leave()
        game.aim.texts = words
        game.aim.finish()


def play(game: Game, numbers: str) -> None:
    """Strike with five numbers: the stroke as the computer carries it out."""
    intend(game, numbers)
    if game.aim.shot is not None:
        game.strike()


# -- practice ------------------------------------------------------------------------------------


def arrange(game: Game) -> None:
    """Begin or end placing balls by hand; the balls of a match are not touched."""
    if game.contest is not None and not game.contest.match.finished:
        game.refuse("match")
    elif game.moving:
        game.refuse("moving")
    else:
        game.arranging = not game.arranging
        game.shown_shot = False
        game.aim.leave()


def hold(game: Game, name: str) -> None:
    """Take the ball that keys and mouse move."""
    if name in {ball.name for ball in game.world.balls}:
        game.held_ball = name


def move(game: Game, to: str) -> None:
    """Move the ball in hand to "X Y" metres, or as near as there is room."""
    if not game.arranging:
        return
    x, y = map(float, to.split())
    place = placing.slid(game.world, game.held_ball, (x, y))
    if place != game.world.ball(game.held_ball).position:
        held = game.held_ball
        game.lay([place if b.name == held else b.position for b in game.world.balls])


def line(game: Game, text: str) -> None:
    """Lay the balls as a line of text says, with its shot in the boxes; LineError if it is none."""
    found = lineup.read(text)
    game.sheet = ""
    names = [name for name, _ in found.balls]
    if game.contest or found.table != game.table or names != [b.name for b in game.world.balls]:
        _begin(game, found.world(), found.table)
    else:
        game.lay([place for _, place in found.balls])
    game.shown_shot = False
    if found.texts:
        game.aim.texts = list(found.texts)
    game.aim.leave()
    game.aim.finish()


def scene(game: Game, name: str) -> None:
    """Begin with a scene of the physics package; KeyError if there is none of that name."""
    game.sheet = ""
    _begin(game, presets.scene_world(name), name)
