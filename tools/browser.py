"""Build the lab, a static page with the physics in it, and see that it has the same digits.

python -m tools.browser [--out FOLDER] [--check [--pictures FOLDER]] [--serve PORT]     (dist/lab)

Python for browsers is the npm package pyodide, which is fetched at each build and kept out of the
repository; the folder that is written needs no server but one for files. --check opens it in
Chromium without a window (the npm package playwright-core, and Chromium or Chrome as installed, or
where CHROMIUM says), plays shots there and here, and compares every digit. Needs Node 18 or newer.
"""

from __future__ import annotations

import argparse
import json
import mimetypes
import os
import shutil
import sys
import threading
import zipfile
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from tools.building import ROOT, FailedError, run

PYODIDE, PLAYWRIGHT = "pyodide@314.0.7", "playwright-core@1"
CORE = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip",
        "pyodide-lock.json")  # fmt: skip
"""What a page needs of the package."""
WEB = ROOT / "web"
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
SHOTS: tuple[tuple[str, str, dict[str, float]], ...] = (
    ("carom", "table", {"speed": 3.0, "angle": 40.0, "follow": 0.5, "masse": 0.0, "side": 1.5}),
    ("carom", "mathavan", {"speed": 4.7, "angle": 81.3, "follow": -2.0, "masse": 1.0, "side": 3.0}),
    ("three-cushion", "table", {"speed": 4.5, "angle": 8.6, "follow": 2.0, "side": 2.0}),
    ("break", "table", {"speed": 9.0, "angle": 2.4}),
)
"""Set-up, cushion law and numbers of the shots that are compared."""


def main(arguments: list[str] | None = None) -> int:
    """Exit status 0 if it was built, and if it was checked, has the same digits."""
    parser = argparse.ArgumentParser(prog="python -m tools.browser", description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "dist" / "lab", help="(dist/lab)")
    parser.add_argument("--check", action="store_true", help="compare digits in Chromium")
    parser.add_argument("--pictures", type=Path, help="with --check, where pictures of it go")
    parser.add_argument("--serve", type=int, metavar="PORT", help="show it on this machine")
    options = parser.parse_args(arguments)
    out = options.out.resolve()
    try:
        with TemporaryDirectory() as folder:
            npm(Path(folder), PYODIDE, *([PLAYWRIGHT] if options.check else []))
            build(Path(folder) / "node_modules" / "pyodide", out)
            print(f"{out}: {weight(out):.1f} MB")
            if options.check:
                print(check(Path(folder), out, options.pictures))
        if options.serve is not None:
            serve(out, options.serve)
    except FailedError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        pass
    return 0


def npm(folder: Path, *packages: str) -> None:
    """Install packages there; FailedError where there is no npm."""
    command = shutil.which("npm")
    if command is None:
        raise FailedError("npm is not there: Node 18 or newer has it")
    (folder / "package.json").write_text('{"private": true}', encoding="utf-8")
    run([command, "install", "--no-audit", "--no-fund", "--ignore-scripts", *packages], folder)


def build(pyodide: Path, out: Path) -> None:
    """Write the page, Python and the physics into a folder, which is emptied of an older build."""
    if out.exists() and any(out.iterdir()) and not (out / "lab.py").exists():
        raise FailedError(f"{out} is not empty and no lab: name another folder")
    shutil.rmtree(out, ignore_errors=True)
    (out / "pyodide").mkdir(parents=True)
    for page in sorted(WEB.iterdir()):
        if page.is_file():
            shutil.copy(page, out)
    shutil.copy(ROOT / "assets" / "icon-64.png", out)
    for name in CORE:
        shutil.copy(pyodide / name, out / "pyodide")
    pack(out / "physics.zip")


def pack(path: Path) -> None:
    """The sources of the physics, in an archive that is the same for the same sources."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for source in sorted((ROOT / "physics").rglob("*.py")):
            entry = zipfile.ZipInfo(source.relative_to(ROOT).as_posix())
            file.writestr(entry, source.read_bytes(), zipfile.ZIP_DEFLATED)


def weight(out: Path) -> float:
    """MB."""
    return sum(path.stat().st_size for path in out.rglob("*") if path.is_file()) / 1e6


class Quiet(SimpleHTTPRequestHandler):
    """Files alone, and no line about each."""

    def log_message(self, *said: object) -> None:
        """Say nothing."""


def server(out: Path, port: int = 0) -> ThreadingHTTPServer:
    """For this machine only; port 0 is any that is free."""
    mimetypes.add_type("text/javascript", ".mjs")  # some systems know neither
    mimetypes.add_type("application/wasm", ".wasm")
    return ThreadingHTTPServer(("127.0.0.1", port), partial(Quiet, directory=str(out)))


def serve(out: Path, port: int) -> None:
    """Until Ctrl+C."""
    with server(out, port) as running:
        print(f"http://127.0.0.1:{running.server_port}/", flush=True)
        running.serve_forever()


def lab() -> Any:
    """web/lab.py under this Python."""
    sys.path.insert(0, str(WEB))
    try:
        return import_module("lab")
    finally:
        sys.path.remove(str(WEB))


def here() -> list[str]:
    """The shots as this Python plays them."""
    play = lab().played
    return [play(name, law, json.dumps(numbers), "null") for name, law, numbers in SHOTS]


def check(folder: Path, out: Path, pictures: Path | None = None) -> str:
    """What the browser says is equal; FailedError if a digit differs or the page has a fault."""
    asked = [[name, law, json.dumps(numbers), "null"] for name, law, numbers in SHOTS]
    with server(out) as running:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        told = {
            "address": f"http://127.0.0.1:{running.server_port}/", "browser": browser(),
            "shots": asked, "pictures": str(pictures.resolve()) if pictures else None,
        }  # fmt: skip
        if pictures:
            pictures.mkdir(parents=True, exist_ok=True)
        (folder / "told.json").write_text(json.dumps(told), encoding="utf-8")
        shutil.copy(ROOT / "tools" / "browser_check.mjs", folder)
        said = run(["node", "browser_check.mjs", "told.json"], folder, 300.0)
        running.shutdown()
    return compared(json.loads(said), here())


def compared(there: dict[str, Any], ours: list[str]) -> str:
    """A line about both; FailedError names the first shot that differs."""
    for (name, law, _), a, b in zip(SHOTS, there["played"], ours, strict=True):
        if a != b:
            raise FailedError(f"{name}, {law}: other digits in the browser: {a:.200} not {b:.200}")
    numbers = sum(len(text) for text in ours)
    agent = f"{there['agent']}, Python {there['python']}"
    return f"{len(ours)} shots with the same digits in {agent}: {numbers} characters in all"


def browser() -> str:
    """Chromium's command."""
    named = os.environ.get("CHROMIUM")
    found = named or next((path for name in BROWSERS if (path := shutil.which(name))), None)
    if found is None:
        raise FailedError("no Chromium found: install it, or name it by CHROMIUM")
    return found


if __name__ == "__main__":
    sys.exit(main())
