"""What the docs show runs, and what they link to is there."""

import doctest
import importlib
import re
import runpy
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = [ROOT / "README.md", *sorted(DOCS.glob("*.md"))]
ROOMS = "physics|danggu|game|benchmarks|tests|tools|docs|assets"
SOURCES = [p for room in ROOMS.split("|") for p in sorted((ROOT / room).rglob("*.py"))]


def anchors(page):
    """The headings of a page as a browser's address has them."""
    heads = re.findall(r"(?m)^#+ (.*)$", page.read_text(encoding="utf-8"))
    return {re.sub(r"[^\w\- ]", "", head).strip().lower().replace(" ", "-") for head in heads}


def test_the_tour_runs(capsys):
    runpy.run_path(str(DOCS / "tour.py"))
    out = capsys.readouterr().out
    assert "white red" in out
    assert "stepping is off by 0.26" in out
    assert "the white comes down after 0.204 s" in out


def test_the_examples_of_the_tables_are_what_they_say():
    failed, tried = doctest.testfile(str(DOCS / "tables.md"), module_relative=False)
    assert (failed, tried) == (0, 18)


def test_the_examples_of_the_physics_are_what_they_say():
    failed, tried = doctest.testfile(str(DOCS / "physics.md"), module_relative=False)
    assert (failed, tried) == (0, 24)


def test_the_examples_of_the_players_are_what_they_say():
    failed, tried = doctest.testfile(str(DOCS / "players.md"), module_relative=False)
    assert (failed, tried) == (0, 12)


SHOWING = [p for p in SOURCES if "physics" in p.parts and ">>> " in p.read_text("utf-8")]


@pytest.mark.parametrize("path", SHOWING, ids=lambda path: path.stem)
def test_the_examples_in_a_docstring_are_what_they_say(path):
    name = ".".join(path.relative_to(ROOT).with_suffix("").parts)
    failed, tried = doctest.testmod(importlib.import_module(name))
    assert failed == 0
    assert tried > 0


def test_the_readme_gives_the_two_commands_that_the_gate_uses():
    readme = (ROOT / "README.md").read_text()
    assert "pip install . && danggu\n" in readme
    assert "pip install -e '.[test]' && python -m tests\n" in readme
    assert "grep -m1 -F \"pip install -e '.[test]'\" README.md" in (
        ROOT / ".ci" / "run"
    ).read_text()


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_link_of_a_page_leads_to_a_file_and_a_heading_that_are_there(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8")):
        if "://" in target:
            continue
        file, _, heading = target.partition("#")
        there = (page.parent / file) if file else page
        assert there.exists(), f"{page.name} links to {target}"
        assert not heading or heading in anchors(there), f"{page.name} links to {target}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_file_that_a_page_names_is_there(page):
    text = page.read_text(encoding="utf-8")
    named = re.findall(rf"(?<![\w./-])((?:{ROOMS})/[\w/-]+\.[a-z]\w+)", text)
    named += re.findall(rf"`((?:{ROOMS})/[\w/-]+)`", text)
    assert [name for name in named if not (ROOT / name).exists()] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_a_page_is_wrapped_but_for_tables_and_what_is_shown(page):
    text = re.sub(r"(?ms)^```.*?^```", "", page.read_text(encoding="utf-8"))
    lines = [line for line in text.splitlines() if not line.startswith(("|", "    ", "!"))]
    assert [line for line in lines if len(line) > 125] == []


def test_every_section_of_the_docs_that_the_code_names_is_there():
    for path in [*SOURCES, ROOT / "pyproject.toml"]:
        text = re.sub(r"\n\s*#? ?", " ", path.read_text(encoding="utf-8"))
        for page, section in re.findall(r'docs/(\w+\.md), "([^"]+)"', text):
            heads = re.findall(r"(?m)^#+ (.*)$", (DOCS / page).read_text(encoding="utf-8"))
            assert any(head.startswith(section) for head in heads), f"{path}: {page}, {section}"
