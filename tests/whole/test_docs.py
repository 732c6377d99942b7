"""What the docs show runs."""

import doctest
import runpy
from pathlib import Path

DOCS = Path(__file__).parents[2] / "docs"


def test_the_tour_runs(capsys):
    runpy.run_path(str(DOCS / "tour.py"))
    out = capsys.readouterr().out
    assert "white red" in out
    assert "stepping is off by 0.26" in out
    assert "the white comes down after 0.204 s" in out


def test_the_example_of_the_tables_is_what_it_says():
    failed, tried = doctest.testfile(str(DOCS / "tables.md"), module_relative=False)
    assert (failed, tried) == (0, 5)


def test_the_readme_gives_the_two_commands_that_the_gate_uses():
    readme = (DOCS.parent / "README.md").read_text()
    assert "pip install . && danggu\n" in readme
    assert "pip install -e '.[test]' && python -m tests\n" in readme
    assert "grep -m1 -F \"pip install -e '.[test]'\" README.md" in (
        DOCS.parent / ".ci" / "run"
    ).read_text()


def test_pictures_that_pages_show_are_there():
    for page in [DOCS.parent / "README.md", *DOCS.glob("*.md")]:
        for part in page.read_text().split("](")[1:]:
            target = part.split(")")[0].split("#")[0]
            if target and "://" not in target:
                assert (page.parent / target).exists(), f"{page.name} links to {target}"
