"""The words of a language with what is written on keys put into them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache

from game.text import KEY, LANGUAGES
from game.text.keycap import cap_name

from .bindings import Keys


def words(language: str, changed: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return the words of a language; KeyError if there is none of that name.

    `changed`: the keys that the player has chosen, action to key as in the settings.
    """
    return _words(language, tuple((changed or {}).items()))


@lru_cache(maxsize=16)
def _words(language: str, changed: tuple[tuple[str, str], ...]) -> dict[str, str]:
    found, names = LANGUAGES[language], Keys(dict(changed)).names

    def cap(match: re.Match[str]) -> str:
        return cap_name(names[match[1]], found)

    return {key: KEY.sub(cap, text) for key, text in found.items()}
