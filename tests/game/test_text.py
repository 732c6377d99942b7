"""Colours that can be told apart, and text that fits where it is written."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

import assets
from game.render import theme
from game.render.font import Type
from game.render.layout import Layout
from game.render.parts import fields
from game.render.table import lines
from game.session.action import Action
from tests.support.contrast import contrast
from tests.support.pictures import layouts, pixels, same
from tests.support.players import FRAME, an_app

WHITE = theme.WHITE


@pytest.mark.parametrize("ground", [theme.BACKGROUND, theme.PANEL, theme.PANEL_RAISED])
@pytest.mark.parametrize(
    ("ink", "least"),
    [
        (theme.TEXT, 4.5),
        (theme.TEXT_SOFT, 4.5),
        (theme.TEXT_FAINT, 4.5),
        (theme.ERROR, 4.5),
        (theme.GOOD, 4.5),
        (theme.ACCENT, 4.5),
        (theme.LINE_INPUT, 3.0),
    ],
)
def test_text_and_input_borders_stand_out_as_wcag_asks(ink, ground, least):
    assert contrast(ink, ground) >= least


def test_contrast_has_the_value_wcag_gives_for_black_on_white():
    assert contrast((0, 0, 0), (255, 255, 255)) == pytest.approx(21.0)
    assert contrast(theme.WHITE, theme.PRIMARY) >= 4.5


@pytest.mark.parametrize("looks", [theme.BALLS, theme.SAFE_BALLS], ids=["usual", "safe"])
def test_every_trace_stands_out_from_its_halo_on_cloth(looks):
    halo = theme.mix(theme.CLOTHS["blue"], theme.HALO, lines.HALO_ALPHA)
    assert all(contrast(look.ui, halo) >= 4.0 for look in looks.values())


def test_the_safe_set_also_differs_in_letters_and_dashes():
    safe = theme.SAFE_BALLS.values()
    assert len({look.letter for look in safe}) == len({look.dashes for look in safe}) == 4


@pytest.mark.parametrize("colours", ["usual", "safe"])
def test_the_safe_set_says_with_letters_whose_a_trace_is_and_an_event(colours, monkeypatch):
    written, draw = [], Type.draw

    def noted(self, surface, string, *how):
        written.append(string)
        return draw(self, surface, string, *how)

    monkeypatch.setattr(Type, "draw", noted)
    app = an_app((1280, 720))
    for action in (Action("colours", colours), Action("shoot"), Action("skip")):
        app.perform(action)
    written.clear()
    app.frame(FRAME)
    letters = [string for string in written if string in ("W", "Y", "1", "2")]
    if colours == "usual":
        assert "W" not in letters
    else:
        assert set(letters) == {"W", "1", "2"}  # the yellow ball has not been touched
        assert letters.count("W") > 2


@pytest.mark.parametrize("s", [0.75, 1, 1.5, 3])
def test_digits_and_signs_are_equally_wide_so_numbers_do_not_jitter(s):
    type_ = Type(s)
    for size in (13, 20, 30):
        assert len({type_.width(digit * 8, size) for digit in "0123456789"}) == 1
        assert type_.width("\u2212", size) == type_.width("+", size)


@pytest.mark.parametrize("layout", layouts(), ids=same)
def test_a_value_of_eight_characters_fits_its_field(layout):
    room = layout.fields[0].w - (12 + 12 + fields.UNIT_COLUMN + 8) * layout.s
    assert Type(layout.s).width("\u2212123.456", 20) <= room + 1


@pytest.mark.parametrize(
    ("string", "width"),
    [
        ("Shoot", 37),
        ("Thickness", 60),
        ("elevation", 56),
        ("치기", 24),
        ("두께", 24),
        ("큐 각도", 40),
    ],
)
def test_words_are_as_wide_as_when_the_layout_was_designed(string, width):
    assert Type(1.0).width(string, 13) == pytest.approx(width, abs=1)


HINT = "Drag to aim  \u00b7  wheel 0.1\u00b0  \u00b7  Tab next box"


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (3840, 2160)])
def test_the_longest_hint_fits_the_narrowest_panel(size):
    layout = Layout(size, 2.844, 1.4224)
    assert Type(layout.s).width(HINT, 13) <= layout.hint.w - 24 * layout.s


def test_what_does_not_fit_loses_its_last_part_and_then_its_end():
    type_ = Type(1.0)
    whole = type_.width(HINT, 13)
    assert type_.fitted(HINT, 13, whole) == HINT
    assert type_.fitted(HINT, 13, whole - 1) == "Drag to aim  \u00b7  wheel 0.1\u00b0"
    assert type_.fitted(HINT, 13, type_.width("Drag to a\u2026", 13)) == "Drag to a\u2026"
    assert type_.fitted(HINT, 13, 3) == ""


def test_text_is_never_smaller_than_eleven_pixels_and_is_kept():
    type_ = Type(0.5)
    assert type_.px(13) == 11
    assert type_.render("0.00", 13, theme.TEXT) is type_.render("0.00", 13, theme.TEXT)


@pytest.mark.parametrize("size", [11, 13, 20, 30])
@pytest.mark.parametrize("s", [0.75, 1, 1.5, 3])
def test_text_stands_on_the_baseline_it_is_given(size, s):
    surface, type_ = pygame.Surface((300, 200)), Type(s)
    type_.draw(surface, "H", (20, 120), size, (255, 255, 255))
    rows = np.flatnonzero(pixels(surface)[..., 0].max(axis=0) > 120)
    assert rows[-1] == pytest.approx(119, abs=1)
    assert len(rows) == pytest.approx(type_.cap(size), abs=1.5)


def test_right_aligned_text_ends_at_its_point():
    surface, type_ = pygame.Surface((200, 60)), Type(1)
    assert type_.draw(surface, "3.60", (150, 40), 20, theme.TEXT, "right").right == 150


def test_the_font_has_every_common_hangul_syllable_and_sign():
    face = pygame.font.Font(assets.stream(assets.FONT), 20)
    common = [chr(c) for c in range(0xAC00, 0xD7A4) if len(chr(c).encode("euc_kr")) == 2]
    signs = "\u2212\u00d7\u00b1\u00b0\u00b7\u2190\u2191\u2192\u2193\u2026"
    signs += "\u2013\u03bc\u03c3\u03c9\u03c6\u00bd"

    def drawn(character: str) -> bytes:
        return pygame.image.tobytes(face.render(character, True, WHITE), "RGBA")

    missing = drawn("\u6f22")
    assert missing == drawn("\u5b57")
    assert len(common) == 2350
    assert [c for c in [*common, *signs] if drawn(c) == missing] == []


def test_icons_are_square_and_as_large_as_they_are_called():
    sizes = [pygame.image.load(assets.stream(name), name).get_size() for name in assets.ICONS]
    assert sizes == [(64, 64), (256, 256)]
