"""Rebuild assets/NotoSansKR-subset.otf from the full font: the same input gives the same bytes.

    pip install pylopdf-fonts-ko fonttools
    python tools/subset_font.py

Hinting goes, because text is drawn unhinted at double size; so do vertical and alternate forms,
which SDL_ttf never asks for.  The source date is the font's own, not the clock's.
"""

from __future__ import annotations

from pathlib import Path

import pylopdf_fonts_ko
from fontTools import subset

TARGET = Path(__file__).parent.parent / "assets" / "NotoSansKR-subset.otf"
ASCII_AND_LATIN_1 = [*range(0x20, 0x7F), *range(0xA0, 0x100)]
PUNCTUATION = [*range(0x2010, 0x2016), *range(0x2018, 0x2020), 0x2022, 0x2026, 0x2030, 0x2032]
GREEK = [*range(0x391, 0x3AA), *range(0x3B1, 0x3CA)]
ARROWS_AND_MATHS = [*range(0x2190, 0x219A), 0x21BA, 0x21BB, *range(0x2200, 0x2266)]
SIGNS = [*range(0x2150, 0x215F), *range(0x2080, 0x208A), *range(0x25A0, 0x25D0), 0x2605, 0x2606]
JAMO = [*range(0x3131, 0x3164)]
CJK_PUNCTUATION = [*range(0x3001, 0x3012)]


def common_syllables() -> list[int]:
    """Return the 2350 Hangul syllables of KS X 1001: those EUC-KR writes in two bytes."""
    return [code for code in range(0xAC00, 0xD7A4) if len(chr(code).encode("euc_kr")) == 2]


def characters() -> list[int]:
    """Return every code point the subset keeps."""
    signs = PUNCTUATION + GREEK + ARROWS_AND_MATHS + SIGNS + CJK_PUNCTUATION
    return sorted({*ASCII_AND_LATIN_1, *signs, *JAMO, *common_syllables()})


def options() -> subset.Options:
    """Return fontTools' settings: outlines and kerning kept, everything else dropped."""
    chosen = subset.Options()
    chosen.hinting = False
    chosen.desubroutinize = False
    chosen.layout_features = ["kern", "ccmp"]
    chosen.drop_tables += ["vhea", "vmtx", "VORG", "BASE", "DSIG"]
    chosen.notdef_outline = True
    chosen.recalc_timestamp = False
    return chosen


def main() -> None:
    """Write the subset beside the other assets and say what it weighs."""
    chosen = options()
    font = subset.load_font(str(pylopdf_fonts_ko.sans_path()), chosen)
    subsetter = subset.Subsetter(chosen)
    subsetter.populate(unicodes=characters())
    subsetter.subset(font)
    subset.save_font(font, str(TARGET), chosen)
    print(f"{TARGET.name}: {TARGET.stat().st_size} bytes, {len(font.getBestCmap())} characters")


if __name__ == "__main__":
    main()
