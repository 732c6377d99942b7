"""One meaning for each name, one way to describe fields, and words that a reader expects."""

import ast
import inspect
import re
from collections import defaultdict
from dataclasses import fields
from pathlib import Path

import pytest

import physics
from danggu import players, rules
from physics import laws, tables

ROOT = Path(__file__).parents[2]
ROOMS = ("physics", "danggu", "benchmarks", "tools", "tests/support")
SOURCES = sorted(path for room in ROOMS for path in (ROOT / room).rglob("*.py"))
# name: why it may stand for two things
TWICE = {
    "laws": "the kernel's have the equations, the public ones their coefficients; both are laws",
}


def test_no_class_and_no_module_is_called_like_another():
    homes = defaultdict(set)
    for path in SOURCES:
        if path.stem not in ("__init__", "__main__"):
            homes[path.stem].add(path)
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.ClassDef):
                homes[node.name].add(path)
    assert {name for name, paths in homes.items() if len(paths) > 1} == set(TWICE)


def public_records():
    """Every public class that is made of fields."""
    names = {name: getattr(physics, name) for name in physics.__all__}
    for module in (laws, tables, rules, players):
        names |= {name: thing for name, thing in vars(module).items() if name[0] != "_"}
    for path in sorted((ROOT / "danggu").glob("*/*.py")):
        module = __import__(".".join(path.relative_to(ROOT).with_suffix("").parts), fromlist=["_"])
        names |= {name: thing for name, thing in vars(module).items() if name[0] != "_"}
    return {
        thing
        for thing in names.values()
        if inspect.isclass(thing)
        and {"_fields", "__dataclass_fields__"} & {*vars(thing)}
        and re.match(r"(physics|danggu)\b(?!\.kernel)", thing.__module__)
    }


@pytest.mark.parametrize("record", sorted(public_records(), key=repr), ids=lambda r: r.__name__)
def test_every_field_has_a_line_of_its_own_in_the_docstring(record):
    """As `name: what, unit` or, for several of a kind, `name, name: what, unit`."""
    names = getattr(record, "_fields", None) or [field.name for field in fields(record)]
    heads = re.findall(r"(?m)^ *((?:\w+, )*\w+): ", inspect.getdoc(record) or "")
    described = {name for head in heads for name in head.split(", ")}
    assert {name for name in names if name[0] != "_"} <= described


def test_comments_docstrings_and_pages_keep_to_words_in_use():
    never = r"(?i)\b(till|anew|afresh|somebody|reckon\w*|laws? from outside|foreign\w*)\b"
    for path in [*SOURCES, *(ROOT / "docs").glob("*.md"), ROOT / "README.md"]:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            assert not re.search(never, line), f"{path.relative_to(ROOT)}:{number}: {line.strip()}"
