"""The site is whole: every public name is on a page, and nothing is fetched from elsewhere."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

import physics
from danggu import envs, labs, players, rules, scores
from physics import aim, laws, scenes, store, tables, tracks

ROOT = Path(__file__).parents[2]
MODULES = {
    "physics": physics, "danggu.players": players, "danggu.rules": rules, "danggu.envs": envs,
    "danggu.labs": labs, "danggu.scores": scores,
    "physics.aim": aim, "physics.laws": laws, "physics.scenes": scenes, "physics.store": store,
    "physics.tables": tables, "physics.tracks": tracks,
}  # fmt: skip
REFERENCE = "".join(page.read_text("utf-8") for page in (ROOT / "docs" / "api").glob("*.md"))


def test_every_public_name_is_in_the_reference_and_none_is_there_twice():
    found = re.findall(r"(?m)^::: (\S+)$", REFERENCE)
    public = {f"{home}.{name}" for home, module in MODULES.items() for name in module.__all__}
    public -= {*MODULES, "physics.Track"}  # a module of its own has that
    assert {*found} == public
    assert len(found) == len({*found})


def test_the_members_that_the_reference_chooses_are_there():
    chosen = re.findall(r"^::: physics\.(\w+)\n +options:\n +members: \[([^]]*)\]", REFERENCE, re.M)
    assert {name for name, _ in chosen} == {"World", "Cloth", "Ball", "Log"}
    for name, members in chosen:
        missing = {*re.split(r",\s+", members)} - {*dir(getattr(physics, name))}
        assert missing == set(), name


def test_a_docstring_becomes_a_list_of_names_and_a_session():
    pytest.importorskip("griffe")
    from tools.docstrings import as_markdown

    assert as_markdown("Hit it.\n\nat, to: m.\nangle: of it,\ndegrees.\n\n>>> 1\n1") == (
        "Hit it.\n\n- **at, to**: m.\n- **angle**: of it,\n  degrees.\n\n```pycon\n>>> 1\n1\n```"
    )
    assert as_markdown("A: b is no name.\nSo it goes.") != ""
    assert as_markdown("ValueError: said so.") == "ValueError: said so."


def test_what_is_raised_does_not_belong_to_the_last_name_of_the_list():
    pytest.importorskip("griffe")
    from tools.docstrings import as_markdown

    assert as_markdown("at: m.\nof: kg.\nValueError for\nnone.") == (
        "- **at**: m.\n- **of**: kg.\n\nValueError for\nnone."
    )
    assert as_markdown("at: it raises\nValueError.") == "- **at**: it raises\n  ValueError."


def test_links_of_the_repository_become_links_of_the_site():
    pytest.importorskip("mkdocs")
    from tools.site import relinked

    for path, link, there in (
        ("docs/laws.md", "physics.md#cloth", "physics.md#cloth"),
        ("docs/howto/aim.md", "../gallery/throw.py", "../gallery/throw.md"),
        ("docs/gallery/learning.py", "../learning.py", "../source/docs/learning.py.md"),
        ("docs/physics.md", "../physics/wall.py", "source/physics/wall.py.md"),
        ("docs/index.md", "../CHANGELOG.md", "changelog.md"),
        ("CHANGELOG.md", "docs/rules.md", "rules.md"),
        ("docs/benchmarks.md", "../benchmarks/results", "source/benchmarks/results/index.md"),
        ("docs/laws.md", "https://example.org/x.md", "https://example.org/x.md"),
    ):
        assert relinked(f"[words]({link})", path) == f"[words]({there})"


@pytest.mark.docs
def test_the_site_is_built_without_a_warning_and_without_the_network(tmp_path):
    pytest.importorskip("mkdocs")
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(tmp_path)],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    pages = [*tmp_path.rglob("*.html")]
    assert len(pages) > 60
    for page in pages:
        text = page.read_text(encoding="utf-8")
        loads = re.findall(r"<(?:script|link|img|iframe)[^>]*(?:src|href)=\"(https?:[^\"]*)", text)
        assert loads == [], page
    assert '<html lang="ko"' in (tmp_path / "ko" / "index.html").read_text(encoding="utf-8")
