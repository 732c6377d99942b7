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
PUNCTUATION = "‐‑–—―‘’“”•…‰′″‹›⁄"
ARROWS_AND_MATHS = "←↑→↓↔↕↺↻∂∆∑−√∞∫≈≠≤≥⋅"
LETTERS = "αβγδεθκλμνπρστφψωΔΣΩ"
SIGNS = "⅓⅔⅛⅜⅝⅞₀₁₂₃₄⁰⁴■□▲△▶▷▼▽◀◁◆◇○●★☆♪✓①②③④⑤"
JAMO = [*range(0x3131, 0x3164)]
CJK_PUNCTUATION = "、。「」『』《》〈〉【】·~"


def common_syllables() -> list[int]:
    """Return the 2350 Hangul syllables of KS X 1001: those EUC-KR writes in two bytes."""
    return [code for code in range(0xAC00, 0xD7A4) if len(chr(code).encode("euc_kr")) == 2]


def characters() -> list[int]:
    """Return every code point the subset keeps."""
    signs = PUNCTUATION + ARROWS_AND_MATHS + LETTERS + SIGNS + CJK_PUNCTUATION
    return sorted({*ASCII_AND_LATIN_1, *map(ord, signs), *JAMO, *common_syllables()})


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
