"""From the command line: `sweep` says what ranges of shots are worth in a game, `lab` is a
worksheet."""

from __future__ import annotations

import argparse
import csv
import sys
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any

from physics import Ball, World, commandline, ranges, scenes, store, tables

from .labs import command
from .players.levels import LEVELS
from .players.positions import SAGU, THREE_CUSHION, opening
from .rules import GAMES, RACKS
from .rules.free import FREE

if TYPE_CHECKING:
    from .scores import Scores

NUMBERS = tuple(ranges.MEANING)  # of a shot
COPIES = 100  # of each shot, with the errors of a level
CAROM = {
    game: SAGU if game == "four-ball" else THREE_CUSHION
    for game in GAMES
    if game not in RACKS and game != FREE
}
"""The games whose opening position is known here, and which one it is."""


def main(argv: list[str] | None = None) -> int:
    """Exit code 0, or 2 with a message where something cannot be."""
    options = parser().parse_args(ranges.joined(sys.argv[1:] if argv is None else argv))
    try:
        if options.command == "lab":
            return command.run(options)
        print(sweep(options), file=sys.stderr)
    except (ValueError, ImportError, OSError, MemoryError, RuntimeError) as error:
        return refuse(str(error))
    except KeyboardInterrupt:
        return refuse("stopped")
    return 0


def refuse(message: str) -> int:
    print(f"python -m danggu: {message}", file=sys.stderr)
    return 2


def parser() -> argparse.ArgumentParser:
    """The options."""
    commands = commandline.Refusing(prog="python -m danggu", description="Billiards by its rules.")
    sub = commands.add_subparsers(dest="command", required=True, metavar="sweep, lab")
    one = sub.add_parser("sweep", help="what shots are worth in a game, each from one position")
    one.add_argument(
        "name", metavar="NAME", nargs="?", default="opening",
        help="a scene of `python -m physics`, the file of a saved world, or the opening",
    )  # fmt: skip
    one.add_argument("--game", choices=list(GAMES), required=True, help="whose rules judge")
    one.add_argument("--noise", choices=[level.key for level in LEVELS], help="a player's errors")
    one.add_argument("--copies", type=copies, help=f"of each shot, with --noise ({COPIES})")
    one.add_argument("--seed", type=int, help="of the errors (0)")
    one.add_argument("--ball", help="which ball is struck (the first)")
    ranges.add_ranges(one)
    ranges.add_workers(one)
    one.add_argument("--csv", metavar="FILE", help="write a line a shot (- for the terminal)")
    one.add_argument("--npz", metavar="FILE", help="write NumPy arrays")
    command.add_options(sub)
    return commands


def copies(text: str) -> int:
    """A number of copies."""
    return ranges.count(text, ranges.MOST)


def world_of(name: str, game: str) -> World:
    """The world of that name; ValueError if there is none."""
    if name in scenes.SCENES:
        return scenes.SCENES[name]()
    if name != "opening":
        world = store.load(name)
        if not isinstance(world, World):
            raise ValueError(f"{name} holds no world")
        return world
    if game not in CAROM:
        raise ValueError(f"no opening of {game} is known: give a scene or a world's file")
    world = tables.medium_carom() if CAROM[game] == SAGU else tables.match_carom()
    table = world.table
    for ball, place in opening(CAROM[game]).on(table.length, table.width).items():
        world.add(Ball(ball, at=place))
    return world


def sweep(options: argparse.Namespace) -> str:
    """Play all shots, judge them and write what was asked for; returns a line about it."""
    from .scores import scores

    if not options.noise and (options.copies or options.seed is not None):
        raise ValueError("--copies and --seed need --noise")
    world, shots = world_of(options.name, options.game), ranges.grid(options)
    level = next((level for level in LEVELS if level.key == options.noise), None)
    each = (options.copies or COPIES) if level else 1
    if len(shots) * each > ranges.MOST:
        raise ValueError(f"{len(shots) * each} shots are too many: at most {ranges.MOST}")
    ball, rules = options.ball or world.balls[0].name, GAMES[options.game]()
    files = ranges.writable(options.npz, options.csv)
    with ranges.pool(options) as executor, ranges.bar(len(shots) * each) as progress:
        found = scores(
            world, ball, shots, rules, level=level, copies=each, seed=options.seed or 0,
            executor=executor, progress=progress,
        )  # fmt: skip
    write(options, shots, found)
    said = f"{len(shots)} shots at {ball}, {100 * found.made.mean():.2f} % score"
    return "; written to ".join([said, " and ".join(files)] if files else [said])


def write(options: argparse.Namespace, shots: Any, found: Scores) -> None:
    """The files that were asked for: of each shot its numbers, points, made, fouls."""
    import numpy as np

    if options.npz:
        with open(options.npz, "wb") as out:
            np.savez_compressed(out, shots=shots, **found._asdict())
    if options.csv:
        to_terminal = options.csv == "-"
        with nullcontext(sys.stdout) if to_terminal else open(options.csv, "w", newline="") as text:
            rows = csv.writer(text)
            rows.writerow([*NUMBERS, *found._fields])
            rows.writerows(np.column_stack([shots, *found]).tolist())


if __name__ == "__main__":
    sys.exit(main())
