"""What every benchmark prints and keeps: tables as Markdown and CSV, and their provenance."""

import argparse
import csv
import os
import platform
import subprocess
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from physics import commandline

ROOT = Path(__file__).parent.parent
RESULTS = Path(__file__).parent / "results"
SMALLEST, QUICK, FULL = 0, 1, 2  # how much is measured: a second or two, half a minute, minutes


def options(name: str, purpose: str | None, arguments: list[str] | None) -> argparse.Namespace:
    """`effort` (SMALLEST, QUICK or FULL) and `out`, the folder that results go to."""
    parser = commandline.Parser(prog=f"python -m benchmarks {name}", description=purpose)
    effort = parser.add_mutually_exclusive_group()
    add = effort.add_argument
    add("--quick", dest="effort", action="store_const", const=QUICK, help="less of it, in seconds")
    add("--smallest", dest="effort", action="store_const", const=SMALLEST, help="to see it work")
    parser.add_argument("--out", type=place, help="folder for results (benchmarks/results)")
    parser.set_defaults(effort=FULL)
    chosen = parser.parse_args(arguments)
    if chosen.out is not None and chosen.out.exists() and not chosen.out.is_dir():
        parser.error(f"--out {chosen.out}: not a folder")
    if chosen.out is None:
        chosen.out = RESULTS if chosen.effort == FULL else RESULTS / "quick"
    return chosen


def place(text: str) -> Path:
    """A path that is not empty: Path takes "" for the current folder."""
    if not text.strip():
        raise argparse.ArgumentTypeError(f"must not be empty: {text!r}")
    return Path(text)


def _version(package: str) -> str:
    try:
        return f"{package} {version(package)}"
    except PackageNotFoundError:
        return f"no {package}"


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return models[0] if models else platform.processor() or platform.machine()


def _git(*words: str) -> str:
    try:
        done = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True)
    except OSError:
        return ""
    return done.stdout.strip() if done.returncode == 0 else ""


def provenance() -> str:
    """The machine, the versions and the commit, in a line."""
    commit = _git("rev-parse", "--short", "HEAD") or "no commit known"
    changed = " with changes" if _git("status", "--porcelain", "--", "physics", "game") else ""
    load = f"load {os.getloadavg()[0]:.1f} at the end" if hasattr(os, "getloadavg") else ""
    parts = (
        f"{_processor()}, {os.cpu_count()} cores", platform.system(),
        f"Python {platform.python_version()}", _version("numpy"), _version("numba"),
        f"commit {commit}{changed}", load,
    )  # fmt: skip
    return "; ".join(part for part in parts if part)


def figure(value: float, digits: int = 3) -> str:
    """A number with so many significant digits, short."""
    if value != value:
        return "–"
    text = f"{value:.{digits}g}"
    if "e" in text:
        mantissa, _, power = text.partition("e")
        return f"{mantissa}e{int(power)}"
    return text


def duration(seconds: float) -> str:
    """Seconds in the unit that suits them."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}" if seconds / size < 1e3 else f"{seconds:.0f} s"
    return f"{seconds * 1e9:.3g} ns" if seconds == seconds else "–"


class Report:
    """A page of results under a name: printed as it grows, then written as NAME.md."""

    def __init__(self, name: str, title: str, out: Path) -> None:
        self.name, self.out = name, out
        self.lines = [f"# {title}", ""]
        print(title)

    def say(self, *paragraphs: str) -> None:
        """Sentences."""
        for paragraph in paragraphs:
            print(paragraph)
            self.lines += [paragraph, ""]

    def table(self, heads: Sequence[str], rows: Sequence[Sequence[Any]]) -> None:
        """A table: texts as they are, numbers to three digits."""
        cells = [[_cell(value) for value in row] for row in rows]
        widths = [max(len(row[k]) for row in [list(heads), *cells]) for k in range(len(heads))]
        rule = ["-" * width for width in widths]
        lines = [
            "| " + " | ".join(map(str.ljust, row, widths)) + " |"
            for row in [list(heads), rule, *cells]
        ]
        print(*lines, sep="\n", flush=True)
        self.lines += [*lines, ""]

    def data(self, heads: Sequence[str], rows: Sequence[Sequence[Any]]) -> None:
        """All numbers behind the page, as NAME.csv."""
        self.out.mkdir(parents=True, exist_ok=True)
        with (self.out / f"{self.name}.csv").open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(heads)
            writer.writerows(
                [f"{value:.6g}" if isinstance(value, float) else value for value in row]
                for row in rows
            )

    def save(self) -> None:
        """Write the page; it ends with where it was measured."""
        self.out.mkdir(parents=True, exist_ok=True)
        text = "\n".join([*self.lines, f"Measured on {provenance()}.", ""])
        (self.out / f"{self.name}.md").write_text(text, encoding="utf-8")


def _cell(value: Any) -> str:
    return figure(value) if isinstance(value, float) else str(value)
