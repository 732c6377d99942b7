"""`python -m benchmarks COMMAND`: each command is one module, imported when it is asked for."""

import argparse
import sys
from importlib import import_module

COMMANDS = {
    "stress": "invariants at every event over scenes made to break the engine",
    "golden": "rest positions of every scene against tests/golden.json",
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
