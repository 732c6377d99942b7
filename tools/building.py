"""What the tools that build share: a clean clone, a virtual environment, commands in them."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).parent.parent
HIDDEN = {"SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy", "PYTHONNOUSERSITE": "1"}
"""For what runs without a screen, apart from whatever the user has installed."""
DROPPED = ("PYTHONPATH", "PYTHONHOME", "VIRTUAL_ENV")
"""Variables that would let a command find this checkout instead of what was installed."""


class FailedError(RuntimeError):
    """A command failed; the message has what it was and the end of what it said."""


def run(command: Sequence[str | Path], where: Path, limit: float = 600.0) -> str:
    """What a command prints, run in that folder; FailedError if it fails or takes too long, s."""
    said = " ".join(map(str, command))
    kept = {name: value for name, value in os.environ.items() if name not in DROPPED}
    try:
        done = subprocess.run(
            [*map(str, command)], cwd=where, env={**kept, **HIDDEN}, capture_output=True,
            text=True, encoding="utf-8", errors="replace", timeout=limit,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise FailedError(f"{said}: not done after {limit:g} s") from None
    except OSError as error:
        raise FailedError(f"{said}: {error.strerror or error}") from None
    if done.returncode:
        last = "\n".join((done.stdout + done.stderr).splitlines()[-12:])
        raise FailedError(f"{said}: exit status {done.returncode}\n{last}")
    return done.stdout


def clone(folder: Path) -> Path:
    """The last commit, in a new folder: nothing that is not kept comes along."""
    run(["git", "clone", "--quiet", "--no-hardlinks", ROOT, folder], folder.parent)
    return folder


class Venv:
    """A virtual environment of a Python of its own."""

    def __init__(self, folder: Path, python: str | Path = sys.executable) -> None:
        self.folder = folder
        run([python, "-m", "venv", folder], folder.parent)

    def command(self, name: str) -> Path:
        """A program of the environment; Windows has other names for them."""
        if os.name == "nt":
            return self.folder / "Scripts" / f"{name}.exe"
        return self.folder / "bin" / name

    def pip(self, *words: str | Path) -> None:
        """Install something."""
        quiet = ("-q", "--disable-pip-version-check")
        run([self.command("python"), "-m", "pip", "install", *quiet, *words], self.folder)
