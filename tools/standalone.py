"""Build the game as a folder that needs no Python, by PyInstaller, and try it.

python -m tools.standalone [--out FOLDER]      about two minutes; writes FOLDER/danggu (dist)

It is built in a virtual environment of its own from the last commit, so that nothing gets in that
happens to be installed. The system it runs on is the one it is built on.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, sleep

from tools.building import HIDDEN, ROOT, FailedError, Venv, clone, run

LAUNCHER = """\
import sys
from multiprocessing import freeze_support

from game.__main__ import main

freeze_support()  # what takes seconds runs in a process of its own: without this, a second game
sys.exit(main())
"""
UNUSED = (
    "_bz2", "_hashlib", "_lzma", "_ssl", "asyncio", "curses", "doctest", "ftplib", "http",
    "numpy.f2py", "numpy.testing", "pip", "pkg_resources", "pydoc", "pyexpat", "readline",
    "setuptools", "sqlite3", "ssl", "tkinter", "unittest", "xml",
)  # fmt: skip
"""What pygame, numpy and the standard library would bring along; hashlib has its own sums."""
WHOLE = ("game", "physics", "danggu.rules", "danggu.players")
"""Packages that load parts of themselves by name, which PyInstaller does not see."""
THEIRS = (
    "libX11*", "libXau*", "libXdmcp*", "libbsd*", "libgcc_s*", "libmd*", "libstdc++*", "libxcb*",
)  # fmt: skip
"""What belongs to a desktop: graphics drivers may need newer ones, and would load ours instead."""
HEAVIEST, LATEST = 80.0, 0.8
"""MB, and seconds to the end of the first frame."""
TRIES = 5
PATIENCE, SAVE = 240, "811 580"
"""Seconds for a fit on a busy machine; and the button "Save as my table", px."""


def main(arguments: list[str] | None = None) -> int:
    """Exit status 0 if it was built and is as it should be."""
    parser = argparse.ArgumentParser(prog="python -m tools.standalone", description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "dist", help="where it goes (dist)")
    out = parser.parse_args(arguments).out.resolve()
    try:
        with TemporaryDirectory() as work:
            folder = built(Path(work), out)
        return report(folder)
    except FailedError as error:
        print(error, file=sys.stderr)
        return 1


def built(work: Path, out: Path) -> Path:
    """The folder of the game, made in `out`."""
    source, venv = clone(work / "danggu"), Venv(work / "venv")
    venv.pip(source, "pyinstaller>=6")
    (work / "launcher.py").write_text(LAUNCHER, encoding="utf-8")
    run([venv.command("pyinstaller"), *options(out, source)], work)
    folder = out / "danggu"
    slim(folder)
    return folder


def options(out: Path, source: Path) -> list[str]:
    """For PyInstaller."""
    said = ["--noconfirm", "--onedir", "--windowed", "--name", "danggu", "--distpath", str(out)]
    said += ["--icon", str(source / "assets" / "icon-256.png")] if sys.platform == "linux" else []
    said += ["--collect-data", "assets", "--copy-metadata", "danggu"]
    kernel = source / "physics" / "kernel"  # fits load its source again, with other numbers in it
    said += ["--add-data", f"{kernel}{os.pathsep}physics/kernel"]
    said += [word for name in WHOLE for word in ("--collect-submodules", name)]
    said += [word for name in UNUSED for word in ("--exclude-module", name)]
    return [*said, "launcher.py"]


def slim(folder: Path) -> None:
    """On Linux, leave out what is the desktop's, and debugging symbols of Python's own libraries:
    often 20 MB. Libraries from a wheel have been patched, and would not load without theirs."""
    if sys.platform != "linux":
        return
    inside, strip = folder / "_internal", shutil.which("strip")
    for path in [path for pattern in THEIRS for path in inside.glob(pattern)]:
        path.unlink()
    if strip:
        for path in (*inside.glob("libpython*"), *inside.glob("python3*/lib-dynload/*.so")):
            run([strip, "--strip-unneeded", path], folder)


def program(folder: Path) -> Path:
    """What is started."""
    return folder / ("danggu.exe" if os.name == "nt" else "danggu")


def weight(folder: Path) -> float:
    """MB, links not counted."""
    files = (path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    return sum(path.stat().st_size for path in files) / 1e6


def first_frame(folder: Path) -> tuple[float, float]:
    """(on the wall, CPU) seconds from the command to the end of the first frame, the least."""
    wall, cpu = [], []
    for _ in range(TRIES):
        start, used = perf_counter(), os.times()
        run([program(folder), "--frames", "1"], folder, 60.0)
        now = os.times()
        wall.append(perf_counter() - start)
        cpu.append(sum(now[2:4]) - sum(used[2:4]))  # of ended children
    return min(wall), min(cpu)


def fits(folder: Path, tracks: Path) -> None:
    """Fit a table in the window and save it: that takes another process, and the kernel's source.
    FailedError if nothing is saved in time. Where else than on Linux it would be saved, is the
    system's affair, so there it isn't tried."""
    if sys.platform != "linux":
        return
    with TemporaryDirectory() as home:
        asked = f"0.2 key f9\n0.4 key pagedown\n0.6 text {tracks}\n0.8 key return\n"
        saves = "".join(f"{second} click {SAVE}\n" for second in range(2, PATIENCE))
        script, saved = Path(home) / "script.txt", Path(home) / "danggu" / "my-table.json"
        script.write_text(f"{asked}{saves}{PATIENCE} quit\n", encoding="utf-8")
        known = {**os.environ, **HIDDEN, "XDG_DATA_HOME": home, "XDG_CONFIG_HOME": home}
        game = subprocess.Popen([program(folder), "--script", script], cwd=home, env=known)
        try:
            while not saved.exists():
                if game.poll() is not None:
                    raise FailedError(f"{program(folder)}: no table was found from {tracks}")
                sleep(0.2)
        finally:
            game.kill()
            game.wait()


def report(folder: Path) -> int:
    """Try it, print what it weighs and takes; 1 if it weighs too much.

    Seconds are printed, not judged: a machine that is busy with other things would fail.
    """
    heavy, (wall, cpu) = weight(folder), first_frame(folder)
    for game in ("three-cushion", "8-ball", "snooker"):
        run([program(folder), "--game", game, "--level", "master", "--frames", "240"], folder)
    fits(folder, ROOT / "tests" / "data" / "tracks_of_known_table.csv")
    print(f"{folder}: {heavy:.1f} MB, at most {HEAVIEST:g};"
          f" first frame after {wall:.2f} s, {cpu:.2f} of them CPU, meant {LATEST:g}")  # fmt: skip
    return int(heavy > HEAVIEST)


if __name__ == "__main__":
    sys.exit(main())
