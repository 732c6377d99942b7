"""A shot to keep or to give to someone: a set-up, what it is played with, and perhaps its outcome.

One line of text: `danggu1-shot engine=exact law=rigid cloth=table cue=white end=HASH` and then the
line of the set-up with its shot (`lineup`). With `end` it is a replay: the shot is played at once,
and the balls must come to rest where they did, to the last digit; "end=?" where that is not known.
A line of a set-up alone is a shot too, on whatever is in use.
"""

from __future__ import annotations

import re
from collections.abc import Container
from dataclasses import dataclass

from . import lineup, presets
from .lineup import LineError, Lineup

MARK = f"{lineup.MARK}-shot"
UNKNOWN = "?"
END = re.compile(r"[0-9a-f]{8,64}|\?")
"""How the end of a replay is written: a digest of the balls, or that it is not known."""
CHOICES: dict[str, Container[str]] = {
    "engine": presets.ENGINES,
    "law": presets.LAWS,
    "cloth": presets.CLOTHS,
}
"""What is said of the equipment; what is not said stays as it is."""


@dataclass(frozen=True, slots=True)
class SharedShot:
    """A shot that is kept.

    lineup  how the balls lie, and the shot
    kit     engine, law and cloth by key, as far as they are said
    cue     name of the cue ball, "" for the usual one
    end     of a replay: a digest of how the balls come to rest, UNKNOWN, or "" for a shot to aim
    """

    lineup: Lineup
    kit: tuple[tuple[str, str], ...] = ()
    cue: str = ""
    end: str = ""

    @property
    def replay(self) -> bool:
        """Is it played as soon as it is opened?"""
        return bool(self.end)

    def line(self) -> str:
        """All of it in one line; `read` takes it back."""
        words = [f"{name}={key}" for name, key in self.kit]
        words += [f"cue={self.cue.replace(' ', '_')}"] * bool(self.cue)
        words += [f"end={self.end}"] * bool(self.end)
        return " ".join([MARK, *words, self.lineup.line()])


def read(text: str) -> SharedShot:
    """The shot in a line of text, or the set-up; LineError says what is wrong with it."""
    words = text.split()
    if words[:1] != [MARK]:
        return SharedShot(lineup.read(text))
    if lineup.MARK not in words:
        raise LineError("cut")
    begin = words.index(lineup.MARK)
    laid, said = lineup.read(" ".join(words[begin:])), words[1:begin]
    kit, cue, end = {}, "", ""
    for word in said:
        name, _, key = word.partition("=")
        if name == "cue" and key.replace("_", " ") in {ball for ball, _ in laid.balls}:
            cue = key.replace("_", " ")
        elif name == "end" and END.fullmatch(key) and laid.texts:
            end = key
        elif name in CHOICES and key in CHOICES[name]:
            kit[name] = key
        else:
            raise LineError("kit", word)
    return SharedShot(laid, (*kit.items(),), cue, end)
