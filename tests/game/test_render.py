"""Drawing: strokes, marks, cards and the table, each inside the rectangle it returns."""

from __future__ import annotations

from itertools import combinations
from math import atan2, cos, hypot, pi, sin

import numpy as np
import pygame
import pytest

from game.render import theme
from game.render.font import Type
from game.render.layout import Layout
from game.render.parts import cards, fields, gauges, lanes, shapes
from game.render.table import background, cue_stick, fan, lines
from game.render.table.balls import Spot
from game.render.table.obstacles import Thing
from tests.support.pictures import TABLES, black, changed, layouts, pixels, same, sprites

LAYOUT = Layout((1280, 720), 2.448, 1.270)
TYPE = Type(1.0)
ROWS = [cards.LogRow("0.21", ((theme.ACCENT, "W"),), "white", "흰 공")] * 20
LANES = [lanes.Lane(theme.ACCENT, ((0.0, 1.0, 2.0),), (0.4,), ((0.5, 1),), (1.0,))] * 2
MANY = [lanes.Lane(theme.ACCENT, (), (0.4,), ((0.5, 0),), (1.0,), (0.7,))] * 9
WHITE = theme.WHITE


def ball(surface, balls, spot):
    """A ball and its shadow, as `draw_all` draws them; the rectangle around both."""
    return balls.shadow(surface, spot).union(balls._put(surface, spot))


DRAWN = {
    "polyline": lambda s: lines.polyline(s, [(100, 90), (400.5, 200.2), (380, 500)], WHITE, 1.7),
    "dashes": lambda s: lines.polyline(s, [(100, 90), (400, 200)], WHITE, 2, dashes=(9, 6)),
    "trace": lambda s: lines.trace(s, [(100, 90), (400, 200), (900, 700)], WHITE, 1.0),
    "ghost": lambda s: lines.ghost(s, (300.3, 200.8), 11, 1.0),
    "departure": lambda s: lines.departure(s, (300.3, 200.8), 0.7, 11, WHITE, 1.0),
    "bounce": lambda s: lines.bounce(s, (300.3, 200.8), (0, -1), 11, WHITE, 1.0),
    "collision": lambda s: lines.collision(s, (300.3, 200.8), 1.0),
    "cue": lambda s: cue_stick.draw(s, LAYOUT, (-0.5, -0.3), 0.6, 0.05),
    "ball": lambda s: ball(s, sprites(), Spot(0, (0.2, 0.3))),
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
    **{
        f"timeline of {n}": lambda s, n=n: lanes.timeline(
            s, LAYOUT.timeline, TYPE, MANY[:n], 1.0, "0.5 s", time=0.5
        )
        for n in (6, 9)
    },
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
    seen = changed(before, surface)
    assert seen.w > 4
    assert seen.h > 4
    assert dirty.contains(seen)


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
        cue_stick.draw(surface, LAYOUT, (-1.1, -0.5), float(angle), 0.1)
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
    first, second = background.background(layout, cloth), background.background(layout, cloth)
    assert np.array_equal(pixels(first), pixels(second))
    seen = pixels(first).astype(float).sum(axis=-1)

    def light(x: float, y: float) -> float:
        i, j = map(int, layout.to_screen(x, y))
        return float(seen[i - 8 : i + 8, j - 8 : j + 8].mean())

    lamp = light(0.27 * layout.length, 0.08)
    assert lamp > light(0.45 * layout.length, 0.4 * layout.width) > 0.5 * lamp
    assert tuple(first.get_at((2, 2)))[:3] != (0, 0, 0)


@pytest.mark.parametrize("layout", layouts(), ids=same)
def test_the_floor_is_plain_wherever_a_card_or_a_focus_ring_wipes_it(layout):
    floor = pixels(background.background(layout))
    for rect in (*layout.score, *layout.fields, layout.panel, layout.engine, layout.shoot):
        room = rect.inflate(2 * round(4 * layout.s), 2 * round(4 * layout.s))
        room = room.clip((0, 0, *layout.size))
        part = floor[room.x : room.right, room.y : room.bottom]
        assert (part == theme.BACKGROUND).all()


def test_walls_inside_the_bed_are_drawn_where_they_stand():
    plain = pixels(background.background(LAYOUT))
    walled = background.background(LAYOUT, things=[Thing("wall", [(0.0, -0.2), (0.0, 0.2)])])
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
