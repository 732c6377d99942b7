"""What a player may mean by a number: digits, signs and decimal points as keyboards give them."""

from __future__ import annotations

import re
import unicodedata

MINUS = "\u2212"
POINTS = ",\u060c\u066b\u3001\u3002\ufe50\ufe52\uff61\uff64"
"""A comma is a decimal point: the Arabic one too, and what the keys give in Japanese or Chinese."""
DASHES = "\u2010\u2011\u2012\u2013\u2014\u2015\u2212\u207b\ufe58\ufe63\u30fc\uff70"
"""A dash of any length is a minus."""
SAME = {**dict.fromkeys(POINTS, "."), **dict.fromkeys(DASHES, "-"), "E": "e"}
BEGINNING = re.compile(r"[+-]?(\d*\.?\d*|(\d+\.?\d*|\.\d+)e[+-]?\d*)")
FULL_WIDTH = range(0xFF01, 0xFF5F)
INVISIBLE = ("Cc", "Cf", "Cs")
"""Unicode's categories of controls, of marks such as a direction's, and of half characters."""


def plain_character(c: str) -> str:
    """Return a character as a number has it: a digit of any script, a sign, a point; or itself.

    What cannot be seen becomes nothing, a blank of any kind a space.
    """
    if ord(c) in FULL_WIDTH:
        c = chr(ord(c) - 0xFEE0)
    if (digit := unicodedata.decimal(c, None)) is not None:
        return str(digit)
    if c.isspace():
        return " "
    return SAME.get(c, "" if unicodedata.category(c) in INVISIBLE else c)


def typed(text: str) -> str:
    """Return a text as a box of numbers keeps it: nothing that can be seen is left out."""
    return unicodedata.normalize("NFC", "".join(map(plain_character, text)))


def shown(text: str) -> str:
    """Return a text as it is drawn: the true minus is as wide as plus."""
    return text.replace("-", MINUS)


def plain(number: float, places: int = 2) -> str:
    """Return a number as text for a box: rounded, without zeros that say nothing."""
    text = f"{number:.{places}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def value(text: str) -> float:
    """Return the number that a text means; ValueError if it means none."""
    if "_" in text:
        raise ValueError("an underscore is no digit")
    return float(typed(text))


def hopeless(text: str) -> bool:
    """Is a text no number, and the beginning of none either?"""
    return BEGINNING.fullmatch(text.strip()) is None
