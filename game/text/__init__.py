"""Every word of the interface, in each language under the same keys."""

from __future__ import annotations

from . import en, en_match, en_play, ko, ko_match, ko_play

LANGUAGES = {
    "en": en.WORDS | en_match.WORDS | en_play.WORDS,
    "ko": ko.WORDS | ko_match.WORDS | ko_play.WORDS,
}


def words(language: str) -> dict[str, str]:
    """Return the words of a language; KeyError if there is none of that name."""
    return LANGUAGES[language]
