"""Is this commit fit to be released? Nothing is published, and nothing in the checkout changes.

python -m tools.release --check [--python 3.12 ...] [--static]      a minute for each Python

First what can be read: the same version everywhere, a changelog that has it, no changes that are
not committed. Then what can be run: an sdist and a wheel are built from a clean clone, and both are
installed and used in another folder, with each Python that is here and with pygame and pygame-ce.
"""

from __future__ import annotations

import argparse
import re
import sys
import zipfile
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from tools import pythons
from tools.building import ROOT, FailedError, Venv, clone, run

SEMANTIC = re.compile(r"(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)(-[0-9A-Za-z.-]+)?")
PLACES = {
    "physics/__init__.py": r'(?m)^__version__ = "([^"]+)"$',
    "CITATION.cff": r'(?m)^version: "?([^"\n]+?)"?$',
    "CHANGELOG.md": r"(?m)^## \[?([^\]\s]+)\]?",
}
"""Where the version is written, and how; the changelog's is that of its first section."""
NO_PYGAME_FROM = 14
"""The first Python 3 for which pygame has no wheel; pygame-ce has."""
NEEDED = (
    "assets/NotoSansKR-subset.otf", "assets/OFL.txt", "assets/icon-64.png", "assets/icon-256.png",
    "physics/py.typed", "danggu/py.typed", "game/py.typed",
)  # fmt: skip
"""What is no Python and has to be in the wheel."""
PHYSICS = """
from physics import Ball, Shot, simulate, tables
world = tables.medium_carom()
white = world.add(Ball("white", at=(-0.6, 0.0)))
red = world.add(Ball("red", at=(0.6, 0.01)))
after = simulate(world, white, Shot(speed=3.0, angle=1.0, follow=1.5, side=0.5))
assert [event.kind for event in after.log][:4] == ["roll", "ball", "cushion", "roll"]
import physics
print(physics.__file__)
"""
USES = (
    ("danggu", "--version"),
    ("danggu", "--frames", "3", "--screenshot", "frame.png"),
    ("danggu", "--frames", "120", "--game", "8-ball", "--lang", "ko", "--level", "human,club"),
    ("python", "-m", "physics", "scene", "thesis_2", "--csv", "-"),
    (
        "python",
        "-m",
        "danggu",
        "sweep",
        "--game",
        "four-ball",
        "--speed",
        "2",
        "--angle",
        "0:90:30",
    ),
    ("python", "-m", "game", "--frames", "2"),
)
"""Run in an empty folder; "python" and "danggu" are those of the environment."""


def main(arguments: list[str] | None = None) -> int:
    """Exit status: how many checks failed."""
    options = parser().parse_args(arguments)
    here = pythons.found()
    chosen = {version: here[version] for version in options.python or here}
    failed = sum(not tried(name, check) for name, check in static())
    if not options.static:
        with TemporaryDirectory() as folder:
            out = options.keep.resolve() if options.keep else Path(folder) / "dist"
            checks = built(Path(folder), out, chosen)
            failed += sum(not tried(name, check) for name, check in checks)
    print(f"{failed} failed" if failed else "fit for release")
    return failed


def parser() -> argparse.ArgumentParser:
    """The options."""
    made = argparse.ArgumentParser(prog="python -m tools.release", description=__doc__)
    made.add_argument("--check", action="store_true", required=True, help="check, nothing else")
    made.add_argument("--static", action="store_true", help="only what can be read, in a second")
    made.add_argument(
        "--python", action="append", choices=[f"3.{minor}" for minor in pythons.MINORS],
        help="try with this one; more than once for more (all that are here)",
    )  # fmt: skip
    made.add_argument("--keep", type=Path, help="a folder for sdist and wheel (not kept)")
    return made


def tried(name: str, check: Callable[[], str]) -> bool:
    """Run a check and print a line about it."""
    try:
        print(f"ok      {name}: {check()}", flush=True)
        return True
    except FailedError as error:
        print(f"FAILED  {name}: {error}", flush=True)
        return False


# -- what can be read -------------------------------------------------------------------------


def static() -> Iterator[tuple[str, Callable[[], str]]]:
    """(name, check) of what needs no build."""
    yield "version", same_version
    yield "changelog", changelog
    yield "working tree", clean_tree


def versions(root: Path = ROOT) -> dict[str, str]:
    """The version that each place has; FailedError where one has none."""
    found = {}
    for place, pattern in PLACES.items():
        match = re.search(pattern, (root / place).read_text(encoding="utf-8"))
        if match is None:
            raise FailedError(f"{place} has no version")
        found[place] = match[1]
    return found


def same_version(root: Path = ROOT) -> str:
    """The version, if all places have the same and it is one of SemVer."""
    found = versions(root)
    if len({*found.values()}) > 1:
        raise FailedError("; ".join(f"{place} has {version}" for place, version in found.items()))
    version = next(iter(found.values()))
    if not SEMANTIC.fullmatch(version):
        raise FailedError(f"{version} is not MAJOR.MINOR.PATCH")
    return version


def changelog(root: Path = ROOT) -> str:
    """The first section's heading, if it has a date: what is unreleased has none."""
    text = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    heading = next((line for line in text.splitlines() if line.startswith("## ")), "no section")
    if not re.fullmatch(r"## \[?[^\]\s]+\]? - \d{4}-\d\d-\d\d", heading):
        raise FailedError(f"{heading!r} should be '## [VERSION] - YYYY-MM-DD'")
    return heading.removeprefix("## ")


def clean_tree() -> str:
    """The commit, if nothing is changed or new beside it."""
    changed = run(["git", "status", "--porcelain"], ROOT).splitlines()
    if changed:
        raise FailedError(f"not committed: {', '.join(line[3:] for line in changed[:5])}")
    return run(["git", "rev-parse", "--short", "HEAD"], ROOT).strip()


# -- what can be run --------------------------------------------------------------------------


def built(
    work: Path, out: Path, chosen: dict[str, Path | None]
) -> Iterator[tuple[str, Callable[[], str]]]:
    """(name, check) of what is built in `out`; later ones need the first."""
    out.mkdir(parents=True, exist_ok=True)
    if old := [*out.glob("danggu-*")]:
        raise SystemExit(f"{old[0]} is from before: remove it")
    yield "sdist and wheel", partial(packed, work, out)
    if not [*out.glob("*.whl")]:
        return
    for version, python in chosen.items():
        if python is None:
            print(f"absent  Python {version}: not on this machine, so not tried", flush=True)
            continue
        for pygame in pygames(version):
            yield f"wheel, {version}, {pygame}", partial(used, work, out, python, pygame)
    first = next((python for python in chosen.values() if python), None)
    if first is not None:
        yield "sdist, pygame", partial(used, work, out, first, "pygame", "*.tar.gz")


def pygames(version: str) -> tuple[str, ...]:
    """Which of the two there are for that Python."""
    both = int(version.removeprefix("3.")) < NO_PYGAME_FROM
    return ("pygame", "pygame-ce") if both else ("pygame-ce",)


def packed(work: Path, out: Path) -> str:
    """Build an sdist, and a wheel from it, out of a clean clone; their sizes."""
    source, venv = clone(work / "clone"), Venv(work / "builder")
    venv.pip("build>=1")
    run([venv.command("python"), "-m", "build", "--outdir", out, source], work)
    (wheel,), (sdist,) = out.glob("*.whl"), out.glob("*.tar.gz")
    with zipfile.ZipFile(wheel) as file:
        absent = {*NEEDED} - {*file.namelist()}
    if absent:
        raise FailedError(f"{wheel.name} lacks {', '.join(sorted(absent))}")
    if same_version() not in wheel.name:
        raise FailedError(f"{wheel.name} is not of version {same_version()}")
    return ", ".join(f"{p.name} {p.stat().st_size / 1e6:.1f} MB" for p in (sdist, wheel))


def used(work: Path, out: Path, python: Path, pygame: str, kind: str = "*.whl") -> str:
    """Install it and do what a user would, elsewhere; what `danggu --version` says."""
    with TemporaryDirectory(dir=work) as folder:
        venv, empty = Venv(Path(folder) / "venv", python), Path(folder) / "elsewhere"
        empty.mkdir()
        venv.pip(next(out.glob(kind)))
        if pygame == "pygame-ce":  # both are the package `pygame`: the one has to go first
            run([venv.command("python"), "-m", "pip", "uninstall", "-q", "-y", "pygame"], empty)
            venv.pip("--force-reinstall", "--no-deps", "pygame-ce")
        home = run([venv.command("python"), "-c", PHYSICS], empty).strip()
        if not Path(home).is_relative_to(venv.folder):
            raise FailedError(f"{home} was imported, not what was installed")
        said = [run([venv.command(name), *words], empty) for name, *words in USES]
        if not (empty / "frame.png").stat().st_size > 10_000:
            raise FailedError("frame.png is empty")
        return said[0].strip()


if __name__ == "__main__":
    sys.exit(main())
