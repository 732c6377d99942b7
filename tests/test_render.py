"""The picture: rectangles that fit, colours that can be told apart, balls that turn."""

from __future__ import annotations

import os
from itertools import combinations
from math import atan2, cos, hypot, pi, sin

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")

import numpy as np
import pygame
import pytest

import assets
from game.render import (
    balls,
    cards,
    cue,
    fan,
    fields,
    gauges,
    lanes,
    lines,
    shapes,
    table,
    theme,
    turning,
)
from game.render.layout import BORDER, Layout
from game.render.text import Type

SIZES = [
    (960, 540),
    (1024, 768),
    (1280, 720),
    (1280, 1024),
    (1366, 768),
    (1920, 1080),
    (2560, 1080),
    (1200, 1920),
    (3440, 1440),
    (3840, 2160),
    (800, 450),
    (640, 360),
]
TABLES = {"thesis": (2.448, 1.270, 0.03275), "match": (2.844, 1.4224, 0.03075)}
LOOKS = list(theme.BALLS.values())


def layouts() -> list[Layout]:
    return [Layout(size, *shape[:2]) for size in SIZES for shape in TABLES.values()]


def pixels(surface: pygame.Surface) -> np.ndarray:
    return pygame.surfarray.array3d(surface)


def sprites(size: tuple[int, int] = (1280, 720)) -> balls.BallSprites:
    return balls.BallSprites(Layout(size, 2.448, 1.270), LOOKS)


def picture(ball: balls.BallSprites, index: int = 0) -> bytes:
    return pygame.image.tobytes(ball.sprite(index, (0.1, 0.1))[0], "RGBA")


def same(layout: Layout) -> str:
    return f"{layout.size[0]}x{layout.size[1]}-{layout.length}"


def aim_state(layout: Layout) -> list[pygame.Rect]:
    cards_ = [layout.engine, layout.tip, layout.power, layout.thickness, layout.readouts]
    rows = [*layout.score, layout.table, *layout.fields, layout.timeline]
    return [*rows, *cards_, layout.shoot, layout.hint]


def after_state(layout: Layout) -> list[pygame.Rect]:
    return [
        *aim_state(layout)[:10],
        layout.engine,
        layout.result,
        layout.log,
        layout.readouts_after,
    ]


@pytest.mark.parametrize("layout", layouts(), ids=same)
@pytest.mark.parametrize("state", [aim_state, after_state])
def test_no_two_rectangles_overlap_and_all_are_inside_the_window(layout, state):
    window = pygame.Rect((0, 0), layout.size)
    shown = [rect for rect in state(layout) if rect.h]
    assert all(window.contains(rect) for rect in shown)
    assert [pair for pair in combinations(shown, 2) if pair[0].colliderect(pair[1])] == []


@pytest.mark.parametrize("layout", layouts(), ids=same)
def test_the_bed_lies_inside_the_table_true_to_scale(layout):
    assert layout.table.contains(layout.bed)
    outline = layout.length + 2 * BORDER, layout.width + 2 * BORDER
    assert layout.table.w == pytest.approx(outline[0] * layout.scale, abs=1)
    assert layout.table.h == pytest.approx(outline[1] * layout.scale, abs=1)
    corner = layout.to_screen(layout.length / 2, -layout.width / 2)
    assert (layout.bed.right, layout.bed.bottom) == pytest.approx(corner, abs=1)


@pytest.mark.parametrize("layout", layouts(), ids=same)
def test_a_point_goes_to_the_screen_and_back(layout):
    there = layout.to_screen(0.3, -0.2)
    assert layout.to_table(*there) == pytest.approx((0.3, -0.2), abs=1e-12)
    assert layout.to_screen(0, 0.1)[1] < layout.to_screen(0, 0)[1]


@pytest.mark.parametrize("layout", layouts(), ids=same)
def test_rows_and_the_column_keep_common_edges(layout):
    assert {r.x for r in (layout.score[0], layout.table, layout.fields[0], layout.timeline)} == {
        layout.table.x
    }
    assert {r.right for r in (layout.score[2], layout.fields[4], layout.timeline)} == {
        layout.table.right
    }
    column = [layout.engine, layout.tip, layout.log, layout.shoot, layout.hint]
    assert len({(rect.x, rect.w) for rect in column}) == 1
    last = [rect for rect in aim_state(layout)[11:15] if rect.h][-1]
    assert last.bottom == layout.panel.bottom


def test_the_usual_windows_have_the_scales_of_the_design():
    design = {(960, 540): 251.6, (1280, 720): 335.5, (1920, 1080): 503.2}
    for size, scale in design.items():
        assert Layout(size, 2.448, 1.270).scale == pytest.approx(scale, abs=0.1)
    assert Layout((1920, 1080), 2.844, 1.422).scale == pytest.approx(456.9, abs=0.1)


def test_a_very_wide_window_widens_the_column_and_then_the_margins():
    layout = Layout((3440, 1440), 2.448, 1.270)
    assert layout.panel.w == 480 * layout.s
    assert layout.table.x == pytest.approx(3440 - layout.panel.right, abs=1)


def test_a_window_taller_than_wide_keeps_its_spare_height_above_and_below_equal():
    layout = Layout((1280, 1024), 2.448, 1.270)
    assert layout.score[0].y == pytest.approx(1024 - layout.timeline.bottom, abs=1)


def test_parts_are_dropped_in_order_and_the_fields_never():
    shown = [
        [part for part in ("averages", "bars", "readouts", "thickness") if layout.shows(part)]
        for layout in (Layout((round(16 * k), 9 * k), 2.448, 1.27) for k in (60, 58, 54, 50, 46))
    ]
    assert [len(parts) for parts in shown] == [4, 3, 2, 1, 0]
    tiny = Layout((640, 360), 2.448, 1.270)
    assert tiny.thickness.h == tiny.readouts.h == tiny.readouts_after.h == 0
    assert all(rect.w > 0 and rect.h > 0 for rect in tiny.fields)


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
    assert theme.contrast(ink, ground) >= least


def test_contrast_has_the_value_wcag_gives_for_black_on_white():
    assert theme.contrast((0, 0, 0), (255, 255, 255)) == pytest.approx(21.0)
    assert theme.contrast(theme.WHITE, theme.PRIMARY) >= 4.5


@pytest.mark.parametrize("looks", [theme.BALLS, theme.SAFE_BALLS], ids=["usual", "safe"])
def test_every_trace_stands_out_from_its_halo_on_cloth(looks):
    halo = theme.mix(theme.CLOTHS["blue"], theme.HALO, lines.HALO_ALPHA)
    assert all(theme.contrast(look.ui, halo) >= 4.0 for look in looks.values())


def test_the_safe_set_also_differs_in_letters_and_dashes():
    safe = theme.SAFE_BALLS.values()
    assert len({look.letter for look in safe}) == len({look.dashes for look in safe}) == 4


@pytest.mark.parametrize("s", [0.75, 1, 1.5, 3])
def test_digits_and_signs_are_equally_wide_so_numbers_do_not_jitter(s):
    type_ = Type(s)
    for size in (13, 20, 30):
        assert len({type_.width(digit * 8, size) for digit in "0123456789"}) == 1
        assert type_.width("\u2212", size) == type_.width("+", size)


@pytest.mark.parametrize("layout", layouts()[:20], ids=same)
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


@pytest.mark.parametrize("looks", [theme.BALLS, theme.SAFE_BALLS], ids=["usual", "safe"])
def test_a_ball_that_turns_changes_its_picture_and_one_that_rests_does_not(looks):
    ball = balls.BallSprites(Layout((1280, 720), 2.448, 1.270), list(looks.values()))
    before = [picture(ball, i) for i in range(4)]
    assert [picture(ball, i) for i in range(4)] == before
    for i in range(4):
        ball.turn(i, (8.0, 20.0, 3.0), 0.02)
    assert all(picture(ball, i) != before[i] for i in range(4))


def test_an_unturned_ball_is_not_painted_again():
    ball = sprites()
    assert ball.sprite(0, (0.1, 0.1))[0] is ball.sprite(0, (0.1, 0.1))[0]


def test_a_ball_rolled_a_full_turn_in_small_steps_comes_back_to_the_same_picture():
    ball = sprites()
    before = pygame.surfarray.array3d(ball.sprite(0, (0.1, 0.1))[0]).astype(int)
    for _ in range(600):
        ball.turn(0, (12.0, 16.0, 0.0), 2 * pi / 20 / 600)
    after = pygame.surfarray.array3d(ball.sprite(0, (0.1, 0.1))[0]).astype(int)
    assert np.abs(after - before).max() <= 2


def test_a_ball_rolling_to_the_right_carries_its_dot_to_the_right():
    ball = balls.BallSprites(Layout((3840, 2160), 2.448, 1.270), LOOKS)
    ball.orient(0, (1.0, 0.0, 0.0, 0.0))

    def dot() -> float:
        shown = pixels(ball.sprite(0, (0.0, 0.0))[0]).astype(int)
        middle = shown.shape[0] // 2
        red = shown[..., 0] - shown[..., 1] > 90
        near = red & (np.hypot(*(np.indices(red.shape) - middle)) < ball.px * 0.75)
        return float(np.flatnonzero(near.any(axis=1)).mean() - middle)

    assert dot() == pytest.approx(0, abs=1)
    ball.turn(0, (0.0, 1.0, 0.0), 0.4)
    assert dot() == pytest.approx(ball.px * sin(0.4), abs=2)


def test_thousands_of_turns_leave_a_rotation():
    q = turning.RACKED
    for i in range(5000):
        q = turning.turned(q, (sin(i), cos(i), 0.3), 0.01)
    m = turning.matrix(q)
    assert m @ m.T == pytest.approx(np.eye(3), abs=1e-5)


def test_a_turn_is_undone_by_the_opposite_turn():
    q = turning.unit(turning.RACKED)
    there = turning.turned(q, (3.0, -2.0, 1.0), 0.2)
    assert turning.turned(there, (-3.0, 2.0, -1.0), 0.2) == pytest.approx(q, abs=1e-12)


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (3840, 2160)])
def test_a_ball_covers_a_disc_of_its_true_area_centred_on_its_place(size):
    ball = sprites(size)
    for at in ((0.0, 0.0), (0.1234, -0.2345), (-1.1, 0.5)):
        sprite, corner = ball.sprite(1, at)
        alpha = pygame.surfarray.array_alpha(sprite) / 255
        assert alpha.sum() == pytest.approx(pi * ball.px**2, rel=0.02)
        i, j = np.indices(alpha.shape) + 0.5
        middle = ((alpha * k).sum() / alpha.sum() for k in (i, j))
        shown = [m + c for m, c in zip(middle, corner, strict=True)]
        assert shown == pytest.approx(ball.layout.to_screen(*at), abs=0.3)


def black(layout: Layout) -> pygame.Surface:
    return pygame.Surface(layout.size, 0, 32)


def changed(before: np.ndarray, surface: pygame.Surface) -> pygame.Rect:
    i, j = np.nonzero((pixels(surface) != before).any(axis=-1))
    if not len(i):
        return pygame.Rect(0, 0, 0, 0)
    return pygame.Rect(i.min(), j.min(), i.max() - i.min() + 1, j.max() - j.min() + 1)


LAYOUT = Layout((1280, 720), 2.448, 1.270)
TYPE = Type(1.0)
ROWS = [cards.LogRow("0.21", ((theme.ACCENT, "W"),), "white", "흰 공")] * 20
LANES = [lanes.Lane(theme.ACCENT, ((0.0, 1.0, 2.0),), (0.4,), ((0.5, 1),), (1.0,))] * 2
WHITE = theme.WHITE
DRAWN = {
    "polyline": lambda s: lines.polyline(s, [(100, 90), (400.5, 200.2), (380, 500)], WHITE, 1.7),
    "dashes": lambda s: lines.polyline(s, [(100, 90), (400, 200)], WHITE, 2, dashes=(9, 6)),
    "trace": lambda s: lines.trace(s, [(100, 90), (400, 200), (900, 700)], WHITE, 1.0),
    "ghost": lambda s: lines.ghost(s, (300.3, 200.8), 11, 1.0),
    "departure": lambda s: lines.departure(s, (300.3, 200.8), 0.7, 11, WHITE, 1.0),
    "bounce": lambda s: lines.bounce(s, (300.3, 200.8), (0, -1), 11, WHITE, 1.0),
    "collision": lambda s: lines.collision(s, (300.3, 200.8), 1.0),
    "cue": lambda s: cue.draw(s, LAYOUT, (-0.5, -0.3), 0.6, 0.05),
    "ball": lambda s: sprites().draw(s, 0, (0.2, 0.3)),
    "score": lambda s: cards.score(
        s, LAYOUT.score[0], TYPE, "선수 1", "평균 1.42", "12", "20", True, None, 0.6
    ),
    "inning": lambda s: cards.inning(s, LAYOUT.score[1], TYPE, "Inning", "9"),
    "engine": lambda s: cards.engine(s, LAYOUT.engine, TYPE, "Exact events", "Table", "EN"),
    "result": lambda s: cards.result(s, LAYOUT.result, TYPE, "+1", "Both reds", "run 3"),
    "readouts": lambda s: cards.readouts(s, LAYOUT.readouts, TYPE, [("|v|", "0.15", "m/s")] * 3),
    "log": lambda s: cards.log(s, LAYOUT.log, TYPE, "Events", ROWS, 12, True),
    "tip": lambda s: gauges.tip(s, LAYOUT.tip, TYPE, "Tip", (0.3, 0.1), [("side", "+0.30 R")] * 3),
    "power": lambda s: gauges.power(
        s, LAYOUT.power, TYPE, "Power", "3.60", "m/s", 0.45, [(0.0, "0"), (1.0, "8")]
    ),
    "thickness": lambda s: gauges.thickness(
        s, LAYOUT.thickness, TYPE, "Thickness", [("1/8", "cut")], 0.2, theme.ACCENT
    ),
    "timeline": lambda s: lanes.timeline(s, LAYOUT.timeline, TYPE, LANES, 1.0, "0.5 s", time=0.5),
    "button": lambda s: fields.button(s, LAYOUT.shoot, TYPE, "Shoot", "Enter"),
    "hint": lambda s: fields.hint(s, LAYOUT.hint, TYPE, "not a number", error=True),
    **{
        f"field {state}": lambda s, state=state: fields.field(
            s, LAYOUT.fields[2], TYPE, "V", "3.60", "m/s", state, caret=2, selected=True
        )
        for state in fields.STATES
    },
}


@pytest.mark.parametrize("name", DRAWN)
def test_what_is_drawn_lies_inside_the_rectangle_it_returns(name):
    surface = black(LAYOUT)
    before = pixels(surface)
    dirty = DRAWN[name](surface)
    assert changed(before, surface).size > (4, 4)
    assert dirty.contains(changed(before, surface))


@pytest.mark.parametrize("name", DRAWN)
def test_drawing_twice_gives_the_same_picture_so_it_changes_no_state(name):
    first, second = black(LAYOUT), black(LAYOUT)
    DRAWN[name](first)
    DRAWN[name](second)
    assert np.array_equal(pixels(first), pixels(second))


@pytest.mark.parametrize("name", DRAWN)
def test_drawing_respects_the_clip_of_the_surface(name):
    surface = black(LAYOUT)
    clip = pygame.Rect(0, 0, 330, 230)
    surface.set_clip(clip)
    before = pixels(surface)
    DRAWN[name](surface)
    assert surface.get_clip() == clip
    assert clip.contains(changed(before, surface))


def test_every_state_of_a_field_looks_different():
    shown = set()
    for state in fields.STATES:
        surface = black(LAYOUT)
        fields.field(surface, LAYOUT.fields[0], TYPE, "V", "3.60", "m/s", state)
        shown.add(pygame.image.tobytes(surface, "RGB"))
    assert len(shown) == len(fields.STATES)


def test_a_long_value_scrolls_so_that_its_caret_stays_in_the_box():
    box = LAYOUT.fields[0]
    for caret in (0, 15, 30):
        surface = black(LAYOUT)
        fields.field(surface, box, TYPE, "V", "1" * 30, "m/s", "idle", caret=caret)
        line = (pixels(surface) == theme.ACCENT).all(axis=-1)
        assert line[box.x : box.right].any()
        assert line.sum() == line[box.x : box.right].sum()


def test_a_click_into_a_field_finds_the_nearest_gap_between_characters():
    box = LAYOUT.fields[0]
    assert fields.caret_at(box, TYPE, "3.60", box.x) == 0
    assert fields.caret_at(box, TYPE, "3.60", box.right) == 4
    end = box.right - 48
    assert fields.caret_at(box, TYPE, "3.60", end - TYPE.width("60", 20)) == 2


def test_a_stroke_has_the_area_of_its_length_times_its_width():
    for angle in (0.0, 0.3, pi / 4, 1.2, pi / 2, 2.5):
        surface = pygame.Surface((400, 400), 0, 32)
        ends = [(200 - 120 * cos(angle), 200 - 120 * sin(angle))]
        ends.append((200 + 120 * cos(angle), 200 + 120 * sin(angle)))
        lines.polyline(surface, ends, WHITE, 3.0)
        area = pixels(surface)[..., 0].sum() / 255
        assert area == pytest.approx(240 * 3 + pi * 1.5**2, rel=0.02)


def test_a_joint_is_not_painted_twice():
    surface = pygame.Surface((200, 200), 0, 32)
    path = [(20 + i * 2.0, 100.0) for i in range(60)]
    lines.polyline(surface, path, WHITE, 4.0, 0.5)
    assert pixels(surface).max() <= 128


def test_a_fading_path_is_paler_at_its_end():
    surface = pygame.Surface((400, 60), 0, 32)
    lines.polyline(surface, [(20, 30), (380, 30)], WHITE, 4.0, 0.9, fade=(1.0, 0.3))
    row = pixels(surface)[:, 30, 0].astype(int)
    assert row[30] == pytest.approx(0.9 * 255, abs=6)
    assert row[370] == pytest.approx(0.9 * 0.3 * 255, abs=6)


def test_dropping_points_moves_a_path_by_less_than_the_tolerance():
    path = [(10 + i, 200 + 80 * sin(i / 40)) for i in range(400)]
    kept = lines.decimated(path, 0.25)
    assert len(kept) < len(path) / 4
    x, y = np.array(kept).T
    off = np.interp([p[0] for p in path], x, y) - np.array([p[1] for p in path])
    assert np.abs(off).max() <= 0.25 * hypot(1, 2)


def test_empty_and_single_point_paths_draw_nothing():
    surface = black(LAYOUT)
    for path in ([], [(5.0, 5.0)], [(5.0, 5.0), (5.0, 5.0)]):
        assert lines.polyline(surface, path, WHITE, 2).size == (0, 0)
    assert pixels(surface).max() == 0


def test_a_screen_angle_mirrors_the_angle_on_the_table():
    here, there = LAYOUT.to_screen(0, 0), LAYOUT.to_screen(cos(0.7), sin(0.7))
    seen = atan2(there[1] - here[1], there[0] - here[0])
    assert lines.turned(0.7) % (2 * pi) == pytest.approx(seen % (2 * pi))


def test_the_fan_is_brighter_where_more_paths_meet_and_stays_below_its_limit():
    mist, surface = fan.Fan(LAYOUT), black(LAYOUT)
    middle = LAYOUT.to_screen(0, 0)
    for k in range(40):
        mist.add([middle, (middle[0] + 300, middle[1] + (k - 19.5) * 4)])
    mist.draw(surface)
    near, far = (pixels(surface)[int(middle[0]) + d, int(middle[1]), 0] for d in (20, 280))
    assert far < near <= 255 * fan.MOST + 1


def test_a_cleared_fan_draws_nothing():
    mist, surface = fan.Fan(LAYOUT), black(LAYOUT)
    mist.add([(200, 200), (300, 300)])
    mist.clear()
    assert mist.draw(surface).size == (0, 0)


def test_the_cue_never_leaves_the_table():
    for angle in np.linspace(0, 2 * pi, 16):
        surface = black(LAYOUT)
        surface.fill((90, 90, 90))
        before = pixels(surface)
        cue.draw(surface, LAYOUT, (-1.1, -0.5), float(angle), 0.1)
        assert LAYOUT.table.contains(changed(before, surface))


def test_the_log_keeps_the_current_row_third_from_the_bottom():
    shown = cards.log_rows(LAYOUT.log, 1.0)
    assert cards.log_scroll(40, 20, shown) + shown - 3 == 20
    assert cards.log_scroll(40, 0, shown) == 0
    assert cards.log_scroll(40, 39, shown) == 40 - shown


@pytest.mark.parametrize("s", [0.75, 1.0, 3.0])
def test_the_timelines_parts_do_not_overlap(s):
    layout = Layout((round(1280 * s), round(720 * s)), 2.448, 1.270)
    strip = layout.timeline
    parts = [*lanes.buttons(strip, s), lanes.speed(strip, s), lanes.track(strip, s)]
    assert all(strip.contains(part) for part in parts)
    assert [p for p in combinations(parts, 2) if p[0].colliderect(p[1])] == []


def test_the_tip_ball_and_its_values_do_not_overlap_on_the_narrowest_panel():
    for layout in layouts():
        (x, _), radius = gauges.tip_circle(layout.tip, layout.s)
        assert layout.tip.x < x - radius
        assert x + radius < layout.tip.right - 12 * layout.s - Type(layout.s).width("+0.30 R", 17)


@pytest.mark.parametrize("cloth", ["blue", "green"])
@pytest.mark.parametrize("shape", TABLES.values(), ids=TABLES)
def test_the_background_is_the_same_every_time_and_brightest_under_the_lamps(shape, cloth):
    layout = Layout((960, 540), *shape[:2])
    first, second = table.background(layout, cloth), table.background(layout, cloth)
    assert np.array_equal(pixels(first), pixels(second))
    seen = pixels(first).astype(float).sum(axis=-1)

    def light(x: float, y: float) -> float:
        i, j = map(int, layout.to_screen(x, y))
        return float(seen[i - 8 : i + 8, j - 8 : j + 8].mean())

    lamp = light(0.27 * layout.length, 0.08)
    assert lamp > light(0.45 * layout.length, 0.4 * layout.width) > 0.5 * lamp
    assert tuple(first.get_at((2, 2)))[:3] != (0, 0, 0)


@pytest.mark.parametrize("layout", layouts()[:20], ids=same)
def test_the_floor_is_plain_wherever_a_card_or_a_focus_ring_wipes_it(layout):
    floor = pixels(table.background(layout))
    for rect in (*layout.score, *layout.fields, layout.panel, layout.engine, layout.shoot):
        room = rect.inflate(2 * round(4 * layout.s), 2 * round(4 * layout.s))
        room = room.clip((0, 0, *layout.size))
        part = floor[room.x : room.right, room.y : room.bottom]
        assert (part == theme.BACKGROUND).all()


def test_walls_inside_the_bed_are_drawn_where_they_stand():
    plain = pixels(table.background(LAYOUT))
    walled = table.background(LAYOUT, walls=[[(0.0, -0.2), (0.0, 0.2)]])
    area = changed(plain, walled)
    assert area.collidepoint(LAYOUT.to_screen(0, 0))
    assert area.h == pytest.approx(0.4 * LAYOUT.scale, rel=0.2)


def test_a_box_keeps_its_corners_clear_and_its_middle_full():
    surface = black(LAYOUT)
    rect = pygame.Rect(100, 100, 60, 40)
    shapes.box(surface, rect, 1.0, WHITE, WHITE)
    assert tuple(surface.get_at((100, 100)))[:3] == (0, 0, 0)
    assert tuple(surface.get_at(rect.center))[:3] == WHITE
    assert changed(np.zeros((1280, 720, 3), np.uint8), surface) == rect
