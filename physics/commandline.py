"""What every command line here refuses: an option given twice, and one with an empty value."""

from __future__ import annotations

import argparse
from typing import Any, NoReturn


class Once(argparse.Action):
    """Keeps an option's value; a second one, an empty one and one with a NUL are refused."""

    given = False

    def __call__(
        self, parser: argparse.ArgumentParser, found: argparse.Namespace, value: Any, *_: object
    ) -> None:
        if self.given:
            raise argparse.ArgumentError(self, f"is there twice, the second time as {value!r:.60}")
        if isinstance(value, str) and not value.strip():
            raise argparse.ArgumentError(self, f"must not be empty: {value!r:.60}")
        if isinstance(value, str) and "\0" in value:
            raise argparse.ArgumentError(self, f"must not contain a NUL: {value!r:.60}")
        self.given = True
        setattr(found, self.dest, value)


class Parser(argparse.ArgumentParser):
    """A command line on which each option with a value appears once, and is not empty."""

    def __init__(self, *arguments: Any, **more: Any) -> None:
        super().__init__(*arguments, **more)
        self.register("action", None, Once)  # the action of an option that names none


class Refusing(Parser):
    """One that says in a line what is wrong, and no more."""

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{' '.join(self.prog.split()[:3])}: {message}\n")
