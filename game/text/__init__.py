"""Every word of the interface, in each language under the same keys."""

from __future__ import annotations

from . import en, ko

LANGUAGES = {"en": en.WORDS, "ko": ko.WORDS}


def words(language: str) -> dict[str, str]:
    """Return the words of a language; KeyError if there is none of that name."""
    return LANGUAGES[language]
