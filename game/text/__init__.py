"""Every word of the interface, in each language under the same keys.

A key of the keyboard that a player may change is written @[action]: `input.captions` puts its cap
there. Beside the words are numbers as they are typed (`numerals`), and a text while it is edited
(`text_field`).
"""

from __future__ import annotations

import re

from . import (
    en,
    en_coach,
    en_first,
    en_inverse,
    en_labs,
    en_match,
    en_play,
    en_pool,
    en_rules,
    ko,
    ko_coach,
    ko_first,
    ko_inverse,
    ko_labs,
    ko_match,
    ko_play,
    ko_pool,
    ko_rules,
)

LANGUAGES = {
    "en": en.WORDS | en_match.WORDS | en_play.WORDS | en_pool.WORDS | en_rules.WORDS
    | en_inverse.WORDS | en_coach.WORDS | en_first.WORDS | en_labs.WORDS,
    "ko": ko.WORDS | ko_match.WORDS | ko_play.WORDS | ko_pool.WORDS | ko_rules.WORDS
    | ko_inverse.WORDS | ko_coach.WORDS | ko_first.WORDS | ko_labs.WORDS,
}
KEY = re.compile(r"@\[([^]]+)\]")
