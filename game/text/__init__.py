"""Every word of the interface, in each language under the same keys.

A key of the keyboard that a player may change is written @[action], and stands here as its cap.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache

from . import en, en_match, en_play, ko, ko_match, ko_play
from .keycap import cap_name

LANGUAGES = {
    "en": en.WORDS | en_match.WORDS | en_play.WORDS,
    "ko": ko.WORDS | ko_match.WORDS | ko_play.WORDS,
}
KEY = re.compile(r"@\[([^]]+)\]")


def words(language: str, changed: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return the words of a language; KeyError if there is none of that name.

    `changed`: the keys that the player has chosen, action to key as in the settings.
    """
    return _words(language, tuple((changed or {}).items()))


@lru_cache(maxsize=16)
def _words(language: str, changed: tuple[tuple[str, str], ...]) -> dict[str, str]:
    from game.input.bindings import Keys  # which needs pygame: not to print --help

    found, names = LANGUAGES[language], Keys(dict(changed)).names

    def cap(match: re.Match[str]) -> str:
        return cap_name(names[match[1]], found)

    return {key: KEY.sub(cap, text) for key, text in found.items()}
