"""What stands before a release: versions, changelog, and what is built, installed and tried."""

import json
import os
import re
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

from physics import binding
from tools import browser, building, pythons, release, standalone

ROOT = Path(__file__).parents[2]
VERSION = f"{sys.version_info.major}.{sys.version_info.minor}"


@pytest.fixture
def project(tmp_path):
    """A folder with a version in each place."""
    (tmp_path / "physics").mkdir()
    (tmp_path / "physics" / "__init__.py").write_text('x = 1\n__version__ = "1.2.3"\n')
    (tmp_path / "CITATION.cff").write_text("cff-version: 1.2.0\nversion: 1.2.3\n")
    (tmp_path / "CHANGELOG.md").write_text("# Changelog\n\n## [1.2.3] - 2027-03-14\n\n## [1.2.2]\n")
    return tmp_path


def test_the_version_of_this_project_is_the_same_in_all_places():
    assert re.fullmatch(release.SEMANTIC, release.same_version(ROOT))


def test_a_project_whose_places_agree_is_fit(project):
    assert release.same_version(project) == "1.2.3"
    assert release.changelog(project) == "[1.2.3] - 2027-03-14"


@pytest.mark.parametrize(
    ("place", "text", "said"),
    [
        ("CITATION.cff", "version: 1.2.4\n", "CITATION.cff has 1.2.4"),
        ("CITATION.cff", "cff-version: 1.2.0\n", "CITATION.cff has no version"),
        (
            "CHANGELOG.md",
            "# Changelog\n\n## [Unreleased]\n\n## [1.2.3]\n",
            "CHANGELOG.md has Unrel",
        ),
        ("physics/__init__.py", '__version__ = "1.2.3.dev1"\n', r"__init__.py has 1.2.3.dev1"),
    ],
)
def test_a_place_with_another_version_is_named(project, place, text, said):
    (project / place).write_text(text)
    with pytest.raises(building.FailedError, match=re.escape(said)):
        release.same_version(project)


@pytest.mark.parametrize("version", ["1.2", "01.2.3", "v1.2.3", "1.2.3.dev1"])
def test_a_version_that_is_none_of_semver_is_refused(project, version):
    for place, text in (
        ("physics/__init__.py", f'__version__ = "{version}"\n'),
        ("CITATION.cff", f"version: {version}\n"),
        ("CHANGELOG.md", f"## [{version}] - 2027-03-14\n"),
    ):
        (project / place).write_text(text)
    with pytest.raises(building.FailedError, match=r"is not MAJOR\.MINOR\.PATCH"):
        release.same_version(project)


@pytest.mark.parametrize("heading", ["## 1.2.3 (unreleased)", "## [1.2.3]", "# no section"])
def test_what_has_no_date_is_not_released(project, heading):
    (project / "CHANGELOG.md").write_text(f"# Changelog\n\n{heading}\n")
    with pytest.raises(building.FailedError, match="YYYY-MM-DD"):
        release.changelog(project)


def test_a_command_that_fails_says_what_it_was_and_what_it_said(tmp_path):
    code = "import sys; print('half done'); sys.exit('no room')"
    with pytest.raises(building.FailedError, match=r"(?s)exit status 1.*half done\nno room"):
        building.run([sys.executable, "-c", code], tmp_path)
    with pytest.raises(building.FailedError, match="not done after"):
        building.run([sys.executable, "-c", "import time; time.sleep(9)"], tmp_path, 0.2)
    with pytest.raises(building.FailedError, match="nothing: "):
        building.run([tmp_path / "nothing"], tmp_path)


def test_a_command_does_not_find_the_checkout_by_its_path(tmp_path, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    code = "import os; print(os.environ.get('PYTHONPATH'), os.environ['SDL_VIDEODRIVER'])"
    assert building.run([sys.executable, "-c", code], tmp_path) == "None dummy\n"


def test_the_python_that_runs_is_known_by_its_version():
    assert pythons.version_of(Path(sys.executable)) == VERSION


def test_a_command_that_leads_nowhere_is_no_python(tmp_path):
    shim = tmp_path / "python3.12"
    shim.write_text("#!/bin/sh\nexit 127\n")
    shim.chmod(0o755)
    assert pythons.version_of(shim) is None


def test_every_python_that_is_tried_is_allowed_by_the_project():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["requires-python"] == f">=3.{pythons.MINORS[0]}"
    limit = f"python_version < '3.{release.NO_PYGAME_FROM}'"
    assert [line for line in project["dependencies"] if line.startswith("pygame>")] == [
        next(line for line in project["dependencies"] if limit in line)
    ]
    assert release.pygames("3.13") == ("pygame", "pygame-ce")
    assert release.pygames("3.14") == ("pygame-ce",)


def test_what_a_wheel_needs_is_in_the_repository():
    assert [name for name in release.NEEDED if not (ROOT / name).exists()] == []


def test_the_standalone_takes_along_what_is_loaded_by_name():
    """PyInstaller sees imports; `physics` and `danggu` also load modules by their names."""
    said = standalone.options(Path("out"), ROOT)
    collected = {said[k + 1] for k, word in enumerate(said) if word == "--collect-submodules"}
    assert {"physics", "game", "danggu.rules", "danggu.players"} <= collected
    assert "freeze_support()" in standalone.LAUNCHER


def test_the_standalone_has_the_source_of_the_kernel_which_fits_load_again():
    said = standalone.options(Path("out"), ROOT)
    there, _, inside = said[said.index("--add-data") + 1].rpartition(os.pathsep)
    assert Path(there, "calendar.py").exists()
    assert inside == binding.FOLDER.relative_to(ROOT).as_posix()


def test_no_workflow_has_a_secret_or_publishes():
    workflows = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
    assert len(workflows) == 2
    for path in workflows:
        text = path.read_text(encoding="utf-8")
        assert "secrets." not in text
        assert "publish" not in re.sub(r"(?m)#.*$", "", text)
        assert "permissions:\n  contents: read" in text


# -- the lab ----------------------------------------------------------------------------------


def keys(words, inside=()):
    """Every key of nested words; names are English as the engine has them."""
    for key, value in words.items():
        yield (*inside, key)
        if isinstance(value, dict) and key != "names":
            yield from keys(value, (*inside, key))


def test_every_word_of_the_lab_is_there_in_both_languages():
    words = json.loads((ROOT / "web" / "words.json").read_text(encoding="utf-8"))
    english, korean = ({*keys(words[language])} for language in ("en", "ko"))
    assert english == korean
    page = (ROOT / "web" / "index.html").read_text(encoding="utf-8")
    assert {(word,) for word in re.findall(r'data-word="(\w+)"', page)} <= english
    script = (ROOT / "web" / "page.mjs").read_text(encoding="utf-8")
    assert {(word,) for word in re.findall(r"words\(\)\.(\w+)", script)} <= english


def test_the_lab_names_its_set_ups_laws_and_numbers():
    lab = browser.lab()
    words = json.loads((ROOT / "web" / "words.json").read_text(encoding="utf-8"))["en"]
    assert [*words["setups"]] == [*lab.SET_UPS]
    assert [*words["laws"]] == [*lab.LAWS]
    assert [*words["numbers"]] == [*lab.NUMBERS]


@pytest.mark.parametrize("name", ["carom", "three-cushion", "break"])
def test_a_set_up_of_the_lab_plays_the_shot_that_it_begins_with(name):
    lab = browser.lab()
    laid = json.loads(lab.laid(name))
    played = json.loads(lab.played(name, "table", json.dumps(laid["shot"]), "null"))
    assert played["events"] > 10
    assert len(played["legs"]) == len(played["rest"]) == len(laid["balls"])
    for legs, rest, gone in zip(played["legs"], played["rest"], played["gone"], strict=True):
        assert gone or [repr(x) for x in legs[-1][1:3]] == rest


def test_the_lines_of_python_that_the_lab_shows_play_the_same_shot(capsys):
    shot = json.dumps({"speed": 3.0, "angle": 40.0, "follow": 0.5, "side": 1.5})
    played = json.loads(browser.lab().played("carom", "mathavan", shot, "null"))
    exec(played["code"], {})
    assert capsys.readouterr().out.strip() == str(
        [tuple(float(x) for x in place) for place in played["rest"]]
    )


@pytest.mark.parametrize(
    ("numbers", "places", "said"),
    [
        ({"speed": 0}, None, "Shot.speed must be above zero, not 0"),
        ({"speed": "fast"}, None, "Shot.speed"),
        ({"height": 1}, None, "height"),
        ({"speed": 1}, [[0, 0], [0, 0.01]], "overlap"),
        ({"speed": 1}, [[9, 0]], "outside the wall 'east'"),
    ],
)
def test_what_cannot_be_played_is_said_in_the_lab(numbers, places, said):
    told = browser.lab().played("carom", "table", json.dumps(numbers), json.dumps(places))
    assert said in json.loads(told)["error"]


def test_the_archive_for_the_browser_has_the_whole_physics_and_nothing_else(tmp_path):
    for name in ("one.zip", "two.zip"):
        browser.pack(tmp_path / name)
    assert (tmp_path / "one.zip").read_bytes() == (tmp_path / "two.zip").read_bytes()
    with zipfile.ZipFile(tmp_path / "one.zip") as file:
        names = {*file.namelist()}
    assert names == {p.relative_to(ROOT).as_posix() for p in (ROOT / "physics").rglob("*.py")}


def test_a_folder_with_something_else_in_it_is_not_overwritten(tmp_path):
    (tmp_path / "diary.txt").write_text("mine")
    with pytest.raises(building.FailedError, match="is not empty and no lab"):
        browser.build(tmp_path, tmp_path)
    assert (tmp_path / "diary.txt").exists()


def test_a_digit_that_differs_is_found():
    ours = ["[0.1]"] * len(browser.SHOTS)
    there = {"played": ["[0.1]"] * (len(ours) - 1) + ["[0.10000000000000002]"],
             "agent": "Chromium", "python": "3.14"}  # fmt: skip
    with pytest.raises(building.FailedError, match="other digits"):
        browser.compared(there, ours)
    assert "same digits" in browser.compared({**there, "played": ours}, ours)


@pytest.mark.stress
def test_the_packages_are_installed_and_used_elsewhere(tmp_path, capsys):
    here = pythons.found()
    checks = release.built(tmp_path, tmp_path / "dist", {VERSION: here[VERSION]})
    failed = [name for name, check in checks if not release.tried(name, check)]
    assert not failed, capsys.readouterr().out


@pytest.mark.stress
def test_the_browser_has_the_digits_of_the_desk(tmp_path):
    try:
        browser.browser()
    except building.FailedError as absent:
        pytest.skip(str(absent))
    assert browser.main(["--out", str(tmp_path / "lab"), "--check"]) == 0


@pytest.mark.stress
def test_the_standalone_is_built_and_starts(tmp_path):
    assert standalone.main(["--out", str(tmp_path)]) == 0
