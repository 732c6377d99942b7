"""Phases and kinds of events stand in tables; what stands on a table, in one file."""

import ast
from pathlib import Path

import pytest

from benchmarks import golden
from physics import Ball, Pocket, Shot, Wall, World, scenes, simulate, tables
from physics.kernel.kinds import KINDS, PHASES
from physics.kernel.obstacle import clearance, facing, farthest

ROOT = Path(__file__).parents[2]
BY_NAME = {kind.name: kind for kind in KINDS}


def over_the_cushion():
    world = tables.match_carom()
    world.add(Ball("white", at=(0.0, 0.5)))
    world.add(Ball("red", at=(0.4, 0.1)))
    return simulate(world, "white", Shot(3.0, angle=90.0, climb=1.5))


def a_hop():
    world = scenes.carom()
    return simulate(world, "white", Shot(2.0, angle=10.0, climb=1.0))


def into_a_pocket():
    world = scenes.carom()
    world.add(Pocket((-1.0, 0.0), 0.06, "hole"))
    return simulate(world, "white", Shot(2.0, angle=180.0))


def slower_and_slower():
    world = scenes.carom()
    world.cloth = world.cloth.rolling(lambda speed: 0.04 + 0.0125 * speed)
    return simulate(world, "white", Shot(2.0, angle=10.0, follow=2.0))


LOGS = {**{name: lambda name=name: golden.play(name) for name in scenes.SCENES},
        "over the cushion": over_the_cushion, "a hop": a_hop,
        "into a pocket": into_a_pocket, "slower and slower": slower_and_slower}  # fmt: skip


@pytest.mark.parametrize("name", LOGS)
def test_an_event_has_what_its_row_in_the_table_says(name):
    for event in LOGS[name]().log:
        kind = BY_NAME[event.kind]
        assert len(event.balls) == (2 if kind.other == "ball" else 1)
        assert (event.wall is not None) == (kind.other == "wall")
        assert kind.closes or event.closing == 0.0
        assert kind.contact or event.impulse == event.push == 0.0


def test_every_kind_of_event_happens_in_these_logs():
    assert {event.kind for make in LOGS.values() for event in make().log} == set(BY_NAME)


@pytest.mark.parametrize("name", LOGS)
def test_contacts_are_the_events_with_something_else_than_the_cloth(name):
    log = LOGS[name]().log
    met = [e for e in log if BY_NAME[e.kind].other in ("ball", "wall")]
    told = [(e.time, e.kind, e.balls, e.wall, e.away) for e in met]
    assert [tuple(contact) for contact in log.contacts()] == told


def test_a_ball_says_what_its_phase_is():
    after = over_the_cushion()
    rows = {phase.name: phase for phase in PHASES}
    for world in (after, into_a_pocket(), golden.play("carom"), scenes.carom()):
        for ball in world.balls:
            row = rows[ball.phase]
            assert (ball.lies, ball.gone) == (row.lies, row.gone)
            assert ball.on_cloth == (ball.phase not in ("airborne", "off", "pocketed"))
    assert after.ball("white").gone
    assert after.at_rest


def test_a_ball_that_has_been_put_into_the_air_is_not_on_the_cloth_before_time_passes():
    world = World()
    ball = world.add(Ball("white", at=(0.0, 0.0)))
    ball.climb = 1.0
    assert (ball.phase, ball.on_cloth, ball.lies, ball.gone) == ("airborne", False, False, False)


def test_a_wall_and_its_shape_in_the_kernel_give_the_same_answers():
    wall = Wall.line(3.0, 4.0, 1.0)
    for p, v, a in ((0.2 + 0.1j, -1 + 2j, 0.3 - 1j), (-1j, 0.5 + 0j, -0.5 + 0j)):
        spot = p.real, p.imag
        assert wall.distance(spot) == clearance(wall.shape, p, 0.0)
        assert wall.facing(spot) == facing(wall.shape, p) == wall.normal
        assert wall.farthest(p, v, a, 0.7) == farthest(wall.shape, p, v, a, 0.7)


def test_a_ball_laid_along_a_wall_is_as_far_from_it_as_was_asked():
    wall = Wall.through((0.0, 0.0), (1.0, 0.3))
    ((normal, offset),) = wall.lines(0.03, 0.002)
    for along in (-1.0, 0.0, 2.5):
        p = (offset + 1j * along) * normal
        assert wall.distance((p.real, p.imag)) == pytest.approx(0.032, abs=1e-15)
    assert wall.circles(0.03, 0.002) == ()


KNOW_LINES = {
    "physics/farthest.py", "physics/framing.py", "physics/kernel/obstacle.py",
    "physics/kernel/opening.py", "physics/wall.py",  # an opening is a segment where no wall is
}  # fmt: skip
OTHER_MEANINGS = {
    "physics/cue.py", "physics/studies/search.py", "physics/studies/tracks.py",
    "game/render/table/balls.py", "game/render/table/painter.py", "game/render/table/shadows.py",
    "game/render/parts/gauges.py",
}  # fmt: skip


def test_no_other_file_knows_what_a_wall_looks_like():
    """`inward`, `normal` and `offset` are numbers of a line: a post has none."""
    found = set()
    for path in [*(ROOT / "physics").rglob("*.py"), *(ROOT / "game").rglob("*.py")]:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Attribute) and node.attr in ("inward", "normal", "offset"):
                found.add(path.relative_to(ROOT).as_posix())
    assert found - OTHER_MEANINGS == KNOW_LINES
