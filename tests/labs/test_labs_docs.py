"""What the pages of docs about labs say is so."""

import doctest
import importlib
import re
from pathlib import Path

import pytest

from danggu import labs

DOCS = Path(__file__).parents[2] / "docs"
PAGES = [DOCS / "labs.md", DOCS / "ko" / "labs.md"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name)
def test_the_examples_of_the_page_are_what_they_say(page):
    failed, tried = doctest.testfile(str(page), module_relative=False, encoding="utf-8")
    assert failed == 0
    assert tried >= 5


def test_the_example_of_the_package_is_what_it_says():
    failed, tried = doctest.testmod(importlib.import_module("danggu.labs"))
    assert (failed, tried) == (0, 3)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name)
def test_every_lab_is_in_the_table_of_the_page_and_none_that_is_not(page):
    rows = re.findall(r"(?m)^\| (`.*?) \|", page.read_text("utf-8"))
    assert re.findall(r"`([\w-]+)`", " ".join(rows)) == [*labs.LABS]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name)
def test_every_picture_of_the_page_is_there(page):
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", page.read_text("utf-8"))
    assert pictures
    assert all((page.parent / name).exists() for name in pictures)
