"""Labs from the command line: the question, a page to print, data, and answers checked."""

from __future__ import annotations

import argparse
import sys
from typing import Any
from unicodedata import east_asian_width

from physics import whole_files

from . import LABS, lab, page, samples, text
from .shape import Rows
from .worksheet import Checked, Worksheet

SAID = {0: "said.right", 1: "said.large", -1: "said.small"}


class Pairs(argparse.Action):
    """Keeps answers FIELD=NUMBER; refuses two for one field, and what is no such pair."""

    def __call__(
        self, parser: argparse.ArgumentParser, found: argparse.Namespace, value: Any, *_: object
    ) -> None:
        answers = {**(getattr(found, self.dest) or {})}
        for pair in value:
            name, sign, number = pair.partition("=")
            if not (name and sign and number):
                raise argparse.ArgumentError(self, f"must be FIELD=NUMBER, not {pair!r:.60}")
            if name in answers:
                raise argparse.ArgumentError(self, f"{name} is there twice")
            answers[name] = number
        setattr(found, self.dest, answers)


def add_options(sub: argparse._SubParsersAction[Any]) -> None:
    """The command `lab` with its options."""
    one = sub.add_parser("lab", help="a worksheet: its question, a page to print, answers checked")
    one.add_argument("name", metavar="NAME", nargs="?", help=", ".join(LABS))
    one.add_argument("--seed", type=int, metavar="N", help="numbers of one's own, for each student")
    one.add_argument("--language", choices=[*text.LANGUAGES], default="en", help="of all texts")
    one.add_argument("--page", metavar="FILE", help="write a page to print (HTML, A4)")
    one.add_argument("--csv", metavar="FILE", help="write the data (- for the terminal)")
    one.add_argument("--answer", nargs="+", action=Pairs, metavar="FIELD=NUMBER", help="to check")
    one.add_argument("--solution", action="store_true", help="print the engine's values")


def run(options: argparse.Namespace) -> int:
    """Do what was asked for; 1 if an answer is wrong. ValueError and OSError for what cannot be."""
    if options.name is None:
        if wrote(options) or options.answer or options.solution or options.seed is not None:
            raise ValueError("a worksheet needs the name of a lab")
        print(listed(options.language))
        return 0
    if options.page and options.page == options.csv:
        raise ValueError(f"--page {options.page} and --csv {options.csv}: one file for both")
    sheet = lab(options.name, options.seed)
    checked = sheet.check(options.answer)
    if options.page:
        write(options.page, page(sheet, options.language))
    if options.csv == "-":
        sys.stdout.write(samples(sheet.after))
    elif options.csv:
        write(options.csv, samples(sheet.after))
    for line in said(sheet, checked, options):
        print(line)
    return 0 if all(checked.values()) else 1


def wrote(options: argparse.Namespace) -> bool:
    """Has something been written, so that the question need not be?"""
    return bool(options.page or options.csv)


def write(file: str, content: str) -> None:
    """A whole file."""
    whole_files.replace(file, content.encode())
    print(file, file=sys.stderr)


def listed(language: str) -> str:
    """All labs and their titles."""
    say = text.of(language)
    return "\n".join([say["said.labs"], *(f"  {n:20} {say[f'{n}.title']}" for n in LABS)])


def said(sheet: Worksheet, checked: dict[str, Checked], options: argparse.Namespace) -> list[str]:
    """What is printed: verdicts, the engine's values, or else the question."""
    say = text.of(options.language)
    lines = [f"{name}: {say[SAID[one.way]]}" for name, one in checked.items()]
    if options.solution:
        lines += [f"{f.name} = {sheet.truth[f.name]:.6g} {f.unit}".rstrip() for f in sheet.fields]
    if lines or wrote(options):
        return lines
    fields = [
        f"  {field.name:12} {sheet.label(field.name, options.language)}"
        + (f" ({field.unit})" if field.unit else "")
        for field in sheet.fields
    ]
    question = sheet.question(options.language)
    table = [f"{say['page.measured']}:", *columns(sheet.table(), options.language)]
    title = sheet.title(options.language)
    return [title, "", question, "", *table, "", say["said.fields"], *fields]


def columns(rows: Rows, language: str) -> list[str]:
    """A table as lines, in columns."""
    lines = [[text.word(head, language) for head in rows.heads]]
    lines += [[text.figure(cell, language) for cell in row] for row in rows.rows]
    rooms = [max(map(width, column)) for column in zip(*lines, strict=True)]
    return ["  " + "  ".join(map(flush_right, line, rooms)) for line in lines]


def flush_right(word: str, room: int) -> str:
    """With spaces before it, as many as the room leaves."""
    return " " * (room - width(word)) + word


def width(word: str) -> int:
    """How many places of a terminal it takes: Korean letters take two."""
    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in word)
