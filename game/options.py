"""The command line."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable
from dataclasses import dataclass

from . import setup
from .scriptformat import FORMAT
from .text import LANGUAGES

SMALLEST = (640, 360)
LARGEST = 16384


@dataclass(frozen=True, slots=True)
class Options:
    """What the command line asks for; `virtual` time does not wait for the clock on the wall."""

    seed: int = 0
    substeps: int = 6
    table: str = "medium"
    scene: str | None = None
    engine: str = "exact"
    law: str | None = None
    lang: str = "en"
    size: tuple[int, int] = (1280, 720)
    fps: int = 60
    frames: int | None = None
    script: str | None = None
    screenshot: str | None = None
    stats: bool = False
    version: bool = False

    @property
    def virtual(self) -> bool:
        """With a fixed number of frames time is counted in frames: fast, the same every time."""
        return self.frames is not None


def read(arguments: list[str] | None = None) -> Options:
    """Read the command line; on anything unknown say so on stderr and exit with 2."""
    return Options(**vars(_parser().parse_args(arguments)))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="danggu",
        description="Billiards with exact physics: type V, three spins and an angle, and watch.",
        epilog=FORMAT,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("--seed", type=int, default=0, metavar="N", help="for placing balls at random")
    add("--substeps", type=_count(1, 1000), default=6, metavar="N", help="physics calls a frame")
    add("--table", choices=[*setup.TABLES], default="medium", help="table and its balls")
    add("--scene", choices=[*setup.SCENES], help="begin with a scene of the physics package")
    add("--engine", choices=[*setup.ENGINES], default="exact", help="exact events, or time steps")
    add("--law", choices=[*setup.LAWS], help="laws of collision (default: the table's)")
    add("--lang", choices=[*LANGUAGES], default="en", help="language")
    add("--size", type=_size, default=(1280, 720), metavar="WxH", help="window, pixels")
    add("--fps", type=_count(1, 1000), default=60, metavar="N", help="frames a second")
    add(
        "--frames",
        type=_count(1, 10**9),
        metavar="N",
        help="stop after N frames; time is then counted in frames, as fast as they can be drawn",
    )
    add("--script", metavar="FILE", help="keys and text to play, see below")
    add("--screenshot", metavar="FILE", help="save the last picture (.png)")
    add("--stats", action="store_true", help="print counts: frames, physics calls, events")
    add("--version", action="store_true", help="print which pygame is in use")
    return parser


def _count(least: int, most: int) -> Callable[[str], int]:
    def number(text: str) -> int:
        if not re.fullmatch(r"[+-]?\d{1,12}", text) or not least <= int(text) <= most:
            wanted = f"must be a whole number from {least} to {most}"
            raise argparse.ArgumentTypeError(f"{wanted}: {text!r}")
        return int(text)

    return number


def _size(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d{1,5})[xX×](\d{1,5})", text)
    if not found:
        raise argparse.ArgumentTypeError(f"must be written like 1280x720: {text!r}")
    width, height = int(found[1]), int(found[2])
    if width < SMALLEST[0] or height < SMALLEST[1] or max(width, height) > LARGEST:
        least = "x".join(map(str, SMALLEST))
        raise argparse.ArgumentTypeError(f"must be from {least} to {LARGEST} a side: {text!r}")
    return width, height
