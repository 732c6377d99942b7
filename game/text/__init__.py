"""Every word of the interface, in each language under the same keys.

A key of the keyboard that a player may change is written @[action]: `input.captions` puts its cap
there. Beside the words are numbers as they are typed (`numerals`), and a text while it is edited
(`text_field`).
"""

from __future__ import annotations

import re

from . import en, en_match, en_play, ko, ko_match, ko_play

LANGUAGES = {
    "en": en.WORDS | en_match.WORDS | en_play.WORDS,
    "ko": ko.WORDS | ko_match.WORDS | ko_play.WORDS,
}
KEY = re.compile(r"@\[([^]]+)\]")
