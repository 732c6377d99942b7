"""The page to print, the data, and labs from the command line."""

import csv
import io
from xml.etree import ElementTree

import pytest

from danggu import labs
from danggu.__main__ import main
from danggu.labs import text


def tree(page):
    """The page as a tree: it is well-formed XML, too, but for what HTML leaves open."""
    return ElementTree.fromstring(
        page.removeprefix("<!DOCTYPE html>\n").replace('<meta charset="utf-8">', "")
    )


@pytest.mark.parametrize("language", text.LANGUAGES)
@pytest.mark.parametrize("name", labs.LABS)
def test_a_page_has_its_question_picture_table_and_a_blank_for_each_field(name, language):
    sheet = labs.lab(name, 4)
    page = labs.page(sheet, language)
    root = tree(page)
    said = "".join(root.itertext())
    assert root.get("lang") == language
    assert sheet.title(language) in said
    assert all(part in said for part in sheet.question(language).split("\n\n"))
    pictures = root.findall(".//{http://www.w3.org/2000/svg}svg")
    assert len(pictures) == 1 + bool(sheet.lab.axes)
    measured, answers = root.findall(".//table")
    assert len(measured.findall("tr")) == 1 + len(sheet.table().rows)
    assert len(answers.findall(".//td[@class='blank']")) == len(sheet.fields)
    assert f"lab {name} --seed 4" in said


@pytest.mark.parametrize("name", labs.LABS)
def test_a_page_needs_no_other_file_and_gives_no_answer_away(name):
    sheet = labs.lab(name)
    page = labs.page(sheet)
    assert "size: A4" in page
    outside = page.replace('xmlns="http://www.w3.org/2000/svg"', "")
    assert not [word for word in ("http", "src=", "<script", "url(", "@import") if word in outside]
    blanks = tree(page).findall(".//td[@class='blank']")
    assert [*map(ElementTree.tostring, blanks)] == [b'<td class="blank" />'] * len(sheet.fields)


def test_a_name_with_a_sign_of_html_in_it_is_shown_as_it_is():
    from danggu.labs.sheet_page import _row

    assert _row("td", ["a<b & c"]) == "<tr><td>a&lt;b &amp; c</td></tr>"


def test_balls_on_one_line_are_drawn_flash_beneath_flash_and_others_where_they_are():
    def heights(name):
        drawn = tree(labs.page(labs.lab(name)))
        circles = drawn.iter("{http://www.w3.org/2000/svg}circle")
        return {circle.get("cy") for circle in circles}

    assert len(heights("cradle")) == 11  # every 0.05 s, to 0.5 s
    assert len(heights("five-sevenths")) == 1


def rows(sheet):
    return [*csv.DictReader(io.StringIO(labs.samples(sheet.after)))]


def test_data_have_a_row_for_each_sixtieth_of_a_second_and_the_last_moment():
    found = rows(labs.lab("five-sevenths"))
    assert len(found) == 61
    assert [float(row["time"]) for row in found[:3]] == [0.0, 1 / 60, 2 / 60]
    assert float(found[-1]["time"]) == 1.0
    assert float(found[0]["white vx"]) == float(found[0]["white speed"]) == 1.5


def test_data_on_ice_keep_momentum_and_energy():
    found = rows(labs.lab("cradle"))
    assert {round(float(row["energy"]), 12) for row in found} == {0.25}
    assert {round(float(row["px"]), 12) for row in found} == {0.5}


def test_energy_in_data_is_that_of_the_balls_turning_included():
    sheet = labs.lab("cushion-side")
    last = rows(sheet)[-1]
    assert float(last["energy"]) == pytest.approx(sheet.after.ball("white").energy, rel=1e-12)


# -- from the command line -----------------------------------------------------------------------


def test_a_lab_is_asked_on_the_terminal(capsys):
    assert main(["lab", "cradle", "--language", "ko"]) == 0
    out = capsys.readouterr().out
    assert out.startswith("뉴턴의 요람")
    assert all(f"  {field.name} " in out for field in labs.lab("cradle").fields)


@pytest.mark.parametrize("language", text.LANGUAGES)
@pytest.mark.parametrize("name", labs.LABS)
def test_the_terminal_has_the_measured_table_that_the_question_speaks_of(name, language, capsys):
    assert main(["lab", name, "--seed", "7", "--language", language]) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    for row in labs.lab(name, 7).table().rows:
        assert " ".join(text.figure(cell, language) for cell in row).split() in lines


def test_the_columns_of_a_terminal_stand_under_each_other_in_both_languages():
    from danggu.labs.command import columns, width

    for language in text.LANGUAGES:
        lines = columns(labs.lab("right-angle").table(), language)
        assert len({width(line) for line in lines}) == 1
    assert width("공 1") == 4


def test_without_a_name_all_labs_are_listed(capsys):
    assert main(["lab"]) == 0
    out = capsys.readouterr().out
    assert all(name in out for name in labs.LABS)


def test_answers_are_checked_and_the_exit_code_says_whether_all_are_right(capsys):
    assert main(["lab", "cradle", "--answer", "leave=2", "speed=1.0"]) == 0
    assert capsys.readouterr().out == "leave: right\nspeed: right\n"
    assert main(["lab", "cradle", "--answer", "leave=3", "--answer", "speed=0.5"]) == 1
    assert capsys.readouterr().out == "leave: too large\nspeed: too small\n"


def test_the_solution_is_what_is_right(capsys):
    assert main(["lab", "unknown-mass", "--seed", "9", "--solution"]) == 0
    lines = [line.split(" = ") for line in capsys.readouterr().out.splitlines()]
    answers = [f"{name}={value.split()[0]}" for name, value in lines]
    assert main(["lab", "unknown-mass", "--seed", "9", "--answer", *answers]) == 0


def test_page_and_data_are_written_where_they_are_wanted(tmp_path, capsys):
    page, data = tmp_path / "sheet.html", tmp_path / "data.csv"
    assert main(["lab", "pi", "--seed", "3", "--page", str(page), "--csv", str(data)]) == 0
    assert page.read_text("utf-8") == labs.page(labs.lab("pi", 3))
    assert data.read_text("utf-8") == labs.samples(labs.lab("pi", 3).after)
    assert {*tmp_path.iterdir()} == {page, data}
    assert capsys.readouterr() == ("", f"{page}\n{data}\n")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["pie"], "no lab 'pie'"),
        (["pi", "--seed", "-3"], "the seed must be a whole number"),
        (["pi", "--answer", "count"], "must be FIELD=NUMBER, not 'count'"),
        (["pi", "--answer", "count=1", "count=2"], "count is there twice"),
        (["pi", "--answer", "cuont=31"], "no field 'cuont'"),
        (["pi", "--answer", "count=many"], "count: an answer is a number"),
        (["pi", "--page", "nowhere/sheet.html"], "nowhere"),
        (["pi", "--page", "same", "--csv", "same"], "one file for both"),
        (["--seed", "3"], "needs the name of a lab"),
        (["--page", "sheet.html"], "needs the name of a lab"),
    ],
)
def test_what_cannot_be_is_refused_in_a_line(arguments, said, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    try:
        code = main(["lab", *arguments])
    except SystemExit as left:
        code = left.code
    out, err = capsys.readouterr()
    assert (code, out) == (2, "")
    assert said in err
    assert err.count("\n") == 1
    assert not [*tmp_path.iterdir()]
