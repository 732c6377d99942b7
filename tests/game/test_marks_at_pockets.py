"""Marks of the games with pockets: lit pockets, labels, regions of a ball in hand, number tags."""

from __future__ import annotations

from math import atan2, degrees, hypot
from types import SimpleNamespace

import numpy as np
import pygame
import pytest

from danggu.rules.state import Call
from game.aim.spread import SAMPLES, Sample, Spread
from game.render import theme
from game.render.font import Type
from game.render.layout import Layout
from game.render.parts import lanes
from game.render.table import hand, plan, pocket_marks, tags
from game.render.table.background import background
from game.ui.table import preview_lines
from game.ui.table.furniture import holes
from game.ui.table.labels import wanted
from game.ui.table.looks import look
from physics import Ball, Shot, World, simulate, tables
from tests.support.pictures import black, changed, pixels
from tests.support.stages import TABLES, a_stage, layout_of, shown

POOL = tables.pool(9)
LAYOUT = layout_of(POOL)
TYPE = Type(1.0)
(WHOLE,) = (name for name, region in POOL.regions.items() if region.contains((1.0, 0.0)))
CORNER, *_, SIDE = (plan.holes(POOL)[k] for k in (0, 1, 4))
BALLS = [tags.Tag((300.0, 250.0), 9.6, "1"), tags.Tag((500.0, 260.0), 9.6, "12")]
DRAWN = {
    "corner lit": lambda s: pocket_marks.lit(s, LAYOUT, CORNER, theme.ACCENT),
    "side lit": lambda s: pocket_marks.lit(s, LAYOUT, SIDE, theme.ACCENT),
    "called": lambda s: pocket_marks.called(s, LAYOUT, CORNER, theme.ACCENT),
    "pill": lambda s: pocket_marks.pill(s, TYPE, "84 %", (400.3, 90.0), theme.ACCENT),
    "kitchen": lambda s: hand.region(s, LAYOUT, POOL, "kitchen"),
    "bed": lambda s: hand.region(s, LAYOUT, POOL, WHOLE),
    "held": lambda s: hand.held(s, (300.3, 200.8), 9.6, 1.0),
    "tags": lambda s: pygame.Rect.unionall(*(r := tags.draw(s, LAYOUT, TYPE, BALLS))[:1], r[1:]),
}


@pytest.mark.parametrize("name", DRAWN)
def test_a_mark_lies_inside_the_rectangle_it_returns_and_respects_the_clip(name):
    surface = black(LAYOUT)
    surface.fill((90, 90, 90))
    before = pixels(surface)
    dirty = DRAWN[name](surface)
    seen = changed(before, surface)
    assert seen.w > 4
    assert dirty.contains(seen)
    clipped = black(LAYOUT)
    clipped.fill((90, 90, 90))
    clip = pygame.Rect(0, 0, 330, 230)
    clipped.set_clip(clip)
    DRAWN[name](clipped)
    assert clipped.get_clip() == clip
    assert clip.contains(changed(before, clipped))


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
@pytest.mark.parametrize("size", [(960, 540), (1920, 1080)])
def test_a_label_stands_on_the_wood_and_beside_its_pocket(table, size):
    layout = layout_of(table, size)
    for hole in plan.holes(table):
        x, y = pocket_marks.pill_spot(layout, hole)
        surface = black(layout)
        box = pocket_marks.pill(surface, Type(layout.s), "100 %", (x, y))
        cloth = layout.bed.inflate(2 * 0.046 * layout.scale, 2 * 0.046 * layout.scale)
        assert layout.table.contains(box)
        assert not box.colliderect(cloth.inflate(-4, -4))
        rim = layout.to_screen(hole.rim.real, hole.rim.imag)
        near = (max(box.left, min(rim[0], box.right)), max(box.top, min(rim[1], box.bottom)))
        assert hypot(near[0] - rim[0], near[1] - rim[1]) > hole.width * layout.scale


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_a_regions_border_runs_where_a_ball_may_just_be(table):
    for name, region in table.regions.items():
        for x, y in hand.outline(table, name):
            assert region.contains((x - 1e-7, y)) or region.contains((x + 1e-7, y))
        if name != WHOLE:
            surface = background(layout_of(table), table=table)
            before = pixels(surface).astype(int)
            hand.region(surface, layout_of(table), table, name)
            after = pixels(surface).astype(int)
            x, y = map(int, layout_of(table).to_screen(0.3 * table.length, 0.1))
            assert (after[x, y] < before[x, y]).all()


@pytest.mark.parametrize("region", ["kitchen", WHOLE, "as it lies"])
def test_a_ball_in_hand_shows_the_region_that_the_rules_give_it(region):
    world = POOL.world()
    world.add(Ball("cue", at=(-0.9, 0.0)))
    session, stage = a_stage(world, (1280, 720))
    session.arranging, session.held_ball = True, "cue"
    session.contest = SimpleNamespace(in_hand=region, level=None)
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    seen, plain = pixels(surface).astype(int), pixels(stage.base).astype(int)
    x, y = map(int, stage.layout.to_screen(0.5, 0.3))
    dimmed = seen[x, y].sum() < 0.8 * plain[x, y].sum()
    assert dimmed == (region == "kitchen")
    x, y = map(int, stage.layout.to_screen(-0.8, 0.4))
    assert (seen[x, y].sum() > plain[x, y].sum()) == (region == "kitchen")


def test_the_ball_and_the_pocket_that_are_called_have_rings():
    world, _ = straight()
    session, stage = a_stage(world, (1280, 720))
    stage.settings.aids = "off"
    plain = shown(session, stage)
    call = Call("4", "south pocket")
    session.contest = SimpleNamespace(match=SimpleNamespace(call=call), level=None, in_hand="")
    stage.settings.aids = "off"
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    new = (pixels(surface) != pixels(plain)).any(axis=-1)
    ball = world.ball("4")
    x, y = stage.layout.to_screen(*ball.position)
    reach = ball.radius * stage.layout.scale + 2.6
    assert new[int(x + reach), int(y)]
    hole = holes(world)["south pocket"]
    x, y = stage.layout.to_screen(hole.rim.real, hole.rim.imag)
    assert new[int(x + (hole.width + 0.5 * plan.LINER) * stage.layout.scale), int(y)]
    assert not new[: stage.layout.table.centerx - 60].any()


# -- numbers beside balls ------------------------------------------------------------------------


def test_a_tag_covers_no_ball_and_no_path():
    balls = [tags.Tag((300.0 + 22 * (k % 4), 250.0 + 30 * (k // 4)), 9.6, f"{k}") for k in range(8)]
    path = [(270.0, 245.0), (600.0, 245.0)]
    for ball in balls:
        at = tags.place(LAYOUT, ball, balls, [path])
        assert at is not None
        gaps = [hypot(at[0] - b.at[0], at[1] - b.at[1]) - b.radius for b in balls]
        assert min(gaps) > tags.ROOM
        assert abs(at[1] - 245.0) > tags.ROOM


def test_a_ball_in_the_middle_of_a_rack_goes_without_a_tag():
    around = [
        tags.Tag((300.0 + 19.2 * x, 250.0 + 17 * y), 9.6, "1") for x, y in
        ((0, 0), (1, 0), (-1, 0), (0.5, 1), (-0.5, 1), (0.5, -1), (-0.5, -1))
    ]  # fmt: skip
    assert tags.place(LAYOUT, around[0], around) is None
    assert tags.place(LAYOUT, around[0], around[:1]) is not None


def test_a_tag_at_the_cushion_stays_on_the_cloth():
    for corner in (LAYOUT.bed.topleft, LAYOUT.bed.bottomright, LAYOUT.bed.topright):
        x, y = corner
        middle = LAYOUT.bed.center
        at = (x + (12 if x < middle[0] else -12), y + (12 if y < middle[1] else -12))
        spot = tags.place(LAYOUT, tags.Tag(at, 9.6, "15"), [])
        assert spot is not None
        assert LAYOUT.bed.collidepoint(spot)


def test_numbers_stand_beside_balls_that_are_too_small_and_in_the_safe_set():
    nine, cue = look("9", 0, "usual", "pool"), look("cue", 0, "usual", "pool")
    assert wanted(nine, 7.2, "usual")
    assert not wanted(nine, 9.6, "usual")
    assert wanted(look("9", 0, "safe", "pool"), 9.6, "safe")
    assert not wanted(cue, 7.2, "usual")
    assert not wanted(look("cue", 0, "safe", "pool"), 7.2, "safe")
    assert not wanted(look("pink", 0, "usual", "snooker"), 6.0, "usual")
    assert wanted(look("pink", 0, "safe", "snooker"), 6.0, "safe")
    assert not wanted(look("red 1", 0, "usual"), 8.0, "usual")


# -- what the preview shows ----------------------------------------------------------------------


def straight() -> tuple[World, float]:
    """Cue ball and 4 in line with the north-eastern pocket, and the angle that pots."""
    world = POOL.world()
    hole = complex(1.29, 0.655)
    for name, far in (("cue", 0.9), ("4", 0.4)):
        at = hole - far * hole / abs(hole)
        world.add(Ball(name, at=(at.real, at.imag)))
    angle = degrees(atan2(hole.imag, hole.real))
    assert simulate(world, "cue", Shot(1.5, angle)).log[-1].kind in ("pocket", "rest")
    return world, angle


def aimed(speed: float = 1.5):
    world, angle = straight()
    session, stage = a_stage(world, (1280, 720))
    session.aim.texts = [f"{speed}", "-1.0", "0", "0", f"{angle:.3f}"]
    stage.settings.aids = "full"
    return session, stage


def test_the_pocket_that_the_preview_goes_to_is_lit_in_the_balls_colour():
    session, stage = aimed()
    assert session.preview is not None
    found = preview_lines.dropped(session.preview, "cue", holes(session.world))
    assert list(found) == ["4"]
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    rim = found["4"].rim
    x, y = stage.layout.to_screen(rim.real, rim.imag)
    radius = int(found["4"].width * stage.layout.scale) - 2
    lit = pixels(surface)[int(x), int(y) - radius].astype(int)
    plain = pixels(stage.base)[int(x), int(y) - radius].astype(int)
    assert lit.sum() > plain.sum() + 150


def test_a_cue_ball_that_is_going_to_fall_lights_its_pocket_red():
    world = POOL.world()
    world.add(Ball("cue", at=(0.9, 0.3)))
    world.add(Ball("9", at=(-0.9, 0.3)))
    session, _ = a_stage(world)
    session.aim.texts = ["2", "0", "0", "0", "42.5"]
    assert session.preview is not None
    assert list(preview_lines.dropped(session.preview, "cue", holes(world))) == ["cue"]


@pytest.mark.parametrize("share", [None, 0.84])
def test_the_share_that_is_made_stands_beside_the_pocket(share, monkeypatch):
    session, stage = aimed()
    stage.spread = Spread()
    stage.spread.samples = [Sample(((0.0, 0.0), (0.5, 0.2)), True)] * SAMPLES
    monkeypatch.setattr(Spread, "share", property(lambda self: share))
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    hole = holes(session.world)["north-east pocket"]
    x, y = map(int, pocket_marks.pill_spot(stage.layout, hole))
    dark = tuple(surface.get_at((x, y - 8)))[:3] == pocket_marks.DARK
    assert dark == (share is not None)


def test_aiming_at_pockets_drawn_in_part_is_the_same_as_drawn_again():
    session, stage = aimed()
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    for angle in ("27", "27.4", "26.9", "60", "27.1"):
        session.aim.texts[4] = angle
        stage.draw(surface, session)
        assert np.array_equal(pixels(surface), pixels(shown(session, stage)))


def test_a_lane_that_ends_in_a_pocket_ends_in_an_open_circle():
    rect = Layout((1280, 720), 2.54, 1.27).timeline
    drop = [lanes.Lane(theme.ACCENT, ((0.0, 0.5, 2.0),), drops=(0.5,))]
    rest = [lanes.Lane(theme.ACCENT, ((0.0, 0.5, 2.0),), rests=(0.5,))]
    shots = []
    for found in (drop, rest):
        surface = black(LAYOUT)
        lanes.timeline(surface, rect, TYPE, found, 1.0, "0.5 s", time=1.0)
        shots.append(pixels(surface))
    x = lanes.track(rect, 1.0).x + round(0.5 * lanes.track(rect, 1.0).w)
    middle, full = (tuple(shot[x, rect.centery]) for shot in shots)
    assert middle == theme.PANEL
    assert full != theme.PANEL
