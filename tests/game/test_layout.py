"""The rectangles of the window: they fit, they never overlap, they are true to scale."""

from __future__ import annotations

from itertools import combinations

import pygame
import pytest

from game.render.layout import BORDER, Layout
from tests.support.pictures import layouts, same


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
    shown = state(layout)
    assert all(rect.w > 0 and rect.h > 0 for rect in shown)
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
    assert layout.readouts.bottom == layout.readouts_after.bottom == layout.panel.bottom


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
