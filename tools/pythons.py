"""Which Pythons there are on this machine: by their command, or where pyenv or uv put them."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

from tools.building import FailedError, run

MINORS = (11, 12, 13, 14)
"""Of Python 3: from the oldest that pyproject.toml allows on."""


def found() -> dict[str, Path | None]:
    """Version to interpreter, or None where there is no such Python."""
    return {f"3.{minor}": _found(f"3.{minor}") for minor in MINORS}


def _found(version: str) -> Path | None:
    return next((path for path in _candidates(version) if version_of(path) == version), None)


def _candidates(version: str) -> list[Path]:
    """The newest first; a command may be a shim that leads nowhere, so each is asked."""
    home = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"))
    kept = sorted((home / "versions").glob(f"{version}.*"), key=_newness, reverse=True)
    command = shutil.which(f"python{version}")
    return [*([Path(command)] if command else []), *(path / "bin" / "python" for path in kept),
            *_by_uv(version)]  # fmt: skip


def _newness(folder: Path) -> list[int]:
    return [int(part) for part in re.findall(r"\d+", folder.name)]


def _by_uv(version: str) -> list[Path]:
    if not shutil.which("uv"):
        return []
    try:
        said = run(["uv", "python", "find", "--no-python-downloads", version], Path.cwd(), 60.0)
    except FailedError:
        return []
    return [Path(said.strip())]


def version_of(python: Path) -> str | None:
    """Such as "3.11", or None if it does not run."""
    code = "import sys; print('%d.%d' % sys.version_info[:2])"
    try:
        return run([python, "-c", code], Path.cwd(), 60.0).strip()
    except FailedError:
        return None
