"""A way to score that the coach has shown: five numbers, and what there is to say about it."""

from __future__ import annotations

from typing import NamedTuple

from danggu.players.levels import LEVELS
from danggu.players.solution import Solution

from .entry import BOXES, fault, plain

SIDES = ("left", "right", "full")
KEYS = tuple(level.key for level in LEVELS)
NONE = "-"
"""Instead of the ball where none is hit first."""
MOST, FARTHEST = 99, 10.0
"""Ways, and tips off the middle: more than there are."""


class Advice(NamedTuple):
    """One of the ways.

    texts   of the five boxes
    place   its number, from 1, of `ways`
    share   of such strokes of the level that score, %
    level   key of the level
    ball    that is hit first, or NONE
    eighths  of it that are covered, and the `side` of it that is hit
    hour    of the tip on a clock's face, 0 in the middle
    tips    by which it is off the middle
    """

    texts: tuple[str, ...]
    place: int
    ways: int
    share: int
    level: str
    ball: str
    eighths: int
    side: str
    hour: int
    tips: str

    def line(self) -> str:
        """Everything in one line of text, which `read` takes back."""
        return " ".join(map(str, (*self.texts, *self[1:])))


def of(way: Solution, place: int, ways: int, level: str) -> Advice:
    """What there is to say about a solution."""
    texts = tuple(plain(getattr(way.shot, box), 2) for box in BOXES)
    hit = way.thickness
    ball = NONE if hit is None else hit.ball.replace(" ", "")
    covered, side = (0, "full") if hit is None else (round(hit.eighths), hit.side)
    share, tip = round(100.0 * way.share), way.tip
    about = ball, covered, side, tip.hour, plain(tip.tips, 1)
    return Advice(texts, place, ways, share, level, *about)


def read(line: str) -> Advice:
    """What `Advice.line` has written; ValueError for anything else."""
    words = line.split()
    if len(words) != len(BOXES) + len(Advice._fields) - 1:
        raise ValueError("a shot and nine words about it")
    texts, said = words[: len(BOXES)], words[len(BOXES) :]
    place, ways, share, level, ball, eighths, side, hour, tips = said
    if any(fault(k, text) for k, text in enumerate(texts)):
        raise ValueError("no such shot")
    if level not in KEYS or side not in SIDES or not ball.isprintable():
        raise ValueError("no such level, side or ball")
    if not 0.0 <= float(tips) < FARTHEST:
        raise ValueError("the tip is off the ball")
    counts = _count(place, MOST), _count(ways, MOST), _count(share, 100)
    hit = ball, _count(eighths, 8), side
    return Advice((*texts,), *counts, level, *hit, _count(hour, 12), tips)


def _count(word: str, most: int) -> int:
    number = int(word)
    if not 0 <= number <= most:
        raise ValueError(f"{number} is not 0 to {most}")
    return number
