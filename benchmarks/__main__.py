"""`python -m benchmarks COMMAND`: each command is one module, imported when it is asked for."""

import argparse
import sys
from importlib import import_module

COMMANDS = {
    "stress": "invariants at every event over scenes made to break the engine",
    "golden": "rest positions of every scene against tests/golden.json",
    "speed": "the targets: time of a shot, a break, an import, a compilation",
    "work-precision": "error against CPU time, for the exact engine and for fixed steps",
    "scale": "cost of an event and of a shot among 1 to 10 000 balls",
    "peers": "pymunk, the thesis's program and pooltool on the same scenes",
    "skips": "every shortcut switched off in turn: time, work, and that no bit changes",
    "batch": "shots a second, by threads and by executor",
    "cuda": "a graphics card: every bit the CPU's, and shots a second",
    "envs": "environments: steps a second, and what plain players score",
    "coach": "the coach: whether its shares hold, and what it scores at each level",
    "frame": "the game: update and drawing, moving and idle, and its start",
    "influence": "what moves a stroke: coefficients, laws and the player's hand, in centimetres",
    "all": "speed, work-precision, scale, peers, skips, batch, envs and frame, one after the other",
}


def main(arguments: list[str] | None = None) -> int:
    """Exit status: 0 if what was asked for holds."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    for name, purpose in COMMANDS.items():
        commands.add_parser(name, help=purpose, add_help=False)
    chosen, rest = parser.parse_known_args(arguments)
    module = import_module(f"benchmarks.{chosen.command.replace('-', '_')}")
    status: int = module.main(rest)
    return status


if __name__ == "__main__":
    sys.exit(main())
