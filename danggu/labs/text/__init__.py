"""What labs say, in each language: one file a language, and nowhere else."""

from __future__ import annotations

from . import en, ko

LANGUAGES = {"en": en.TEXT, "ko": ko.TEXT}


def of(language: str) -> dict[str, str]:
    """The texts of a language; ValueError for one that there is not."""
    if language not in LANGUAGES:
        raise ValueError(f"no language {language!r}: there are {', '.join(LANGUAGES)}")
    return LANGUAGES[language]


def word(key: str, language: str) -> str:
    """A word of a table, with its unit if it has one: "time (s)"; as it is, if it is none."""
    name, space, sign = key.partition(" (")
    return of(language).get(f"word.{name}", name) + space + sign


def figure(value: float | int | str, language: str) -> str:
    """A cell of a table: a word, a whole number, or four digits."""
    if isinstance(value, str):
        return word(value, language)
    if isinstance(value, int):
        return f"{value}"
    shown = f"{value:.4g}" if abs(value) >= 1e-3 or not value else f"{value:.3g}"
    return "0" if abs(value) < 1e-12 else shown.replace("-", "−")
