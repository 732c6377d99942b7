"""Goals of the drills: the rules and the engine judge them, and each can be reached."""

import pytest

from danggu.players.goals import CLEAR, GOALS, POSITIONS, ROW, RUN, STARS, ZONE, outcome
from danggu.players.levels import Attempt
from danggu.rules.stroke import Drop, Stroke, Touch, stroke
from physics import Ball, simulate, tables

TABLES = {
    "pool": tables.pool(9), "snooker": tables.SNOOKER_12FT, "pyramid": tables.PYRAMID_12FT,
    "sagu": tables.MEDIUM_CAROM, "three_cushion": tables.MATCH_CAROM_2,
}  # fmt: skip


def played(name, answer=None):
    """The outcome of a stroke at a drill, and its table."""
    position = POSITIONS[name]
    table = TABLES[position.game]
    world = table.world()
    for ball, at in position.on(table.length, table.width).items():
        world.add(Ball(ball, at, radius=table.radius, mass=table.mass))
    after = simulate(world, position.cue, Attempt(*(answer or position.answer)).shot())
    lies = {ball.name: ball.position for ball in after.balls if not ball.gone}
    done = stroke(after.log.contacts(), position.cue)
    return outcome(name, done, lies, (table.length, table.width)), table


def test_every_family_has_a_dozen_drills_or_more():
    families = [name.partition(".")[0] for name in GOALS]
    assert all(families.count(game) >= 12 for game in TABLES)
    assert {goal.kind for goal in GOALS.values()} == {ZONE, ROW, RUN, CLEAR}


@pytest.mark.parametrize("name", GOALS)
def test_the_answer_of_a_drill_is_made_and_rests_in_the_inner_ring_of_a_zone(name):
    found, table = played(name)
    assert found.made
    if GOALS[name].kind == ZONE:
        assert GOALS[name].ringed(found.off, table.length) == STARS


@pytest.mark.parametrize("name", GOALS)
def test_a_stroke_that_misses_everything_is_not_made(name):
    angle = POSITIONS[name].answer[0] + 180.0
    assert not played(name, (angle, 0.3, 0.0, 0.0))[0].made


@pytest.mark.parametrize("name", [name for name, goal in GOALS.items() if goal.steps])
def test_more_is_asked_for_more_stars(name):
    goal = GOALS[name]
    assert len(goal.steps) == STARS
    assert [goal.stars(step) for step in goal.steps] == [1, 2, 3]
    assert list(goal.steps) == sorted(goal.steps, reverse=goal.kind == CLEAR)
    assert goal.better(goal.steps[2], goal.steps[0])


@pytest.mark.parametrize("name", [name for name, goal in GOALS.items() if goal.kind == ZONE])
def test_the_inner_ring_lies_on_the_table(name):
    table, goal = TABLES[name.partition(".")[0]], GOALS[name]
    inner = goal.rings(table.length)[1]
    x = (goal.zone[0] / 8 - 0.5) * table.length
    y = (goal.zone[1] / 4 - 0.5) * table.width
    assert abs(x) + 0.3 * inner < table.length / 2
    assert abs(y) + 0.3 * inner < table.width / 2


def touching(*balls, down=(), lost=False):
    """A stroke that hits balls one after the other and drops some."""
    touches = tuple(Touch(0.1 * k, ball, cushion=False) for k, ball in enumerate(balls, 1))
    drops = [Drop(1.0, ball, "north pocket") for ball in (*down, *["cue"] * lost)]
    return Stroke(touches, cue="cue", pocketed=tuple(drops))


def test_a_table_is_cleared_in_the_order_of_its_balls():
    lies = {"1": (0.0, 0.0), "2": (0.1, 0.0), "3": (0.2, 0.0)}
    size = (2.54, 1.27)

    def left(*names):
        return {name: lies[name] for name in names}

    assert outcome("pool.position", touching("1", down=("1",)), left("2", "3"), size) == (
        True, None, False
    )  # fmt: skip
    assert not outcome("pool.position", touching("2", down=("2",)), left("1", "3"), size).made
    assert not outcome("pool.position", touching("1", lost=True), left("1", "2", "3"), size).made
    assert outcome("pool.position", touching("3", down=("3",)), {}, size).done


def test_a_pot_with_the_cue_ball_down_is_none():
    lies = {"cue": (0.0, 0.0)}
    good = Stroke(
        (Touch(0.1, "1", cushion=False),), cue="cue",
        pocketed=(Drop(1.0, "1", "north-east pocket"),),
    )  # fmt: skip
    lost = Stroke(good.touches, cue="cue", pocketed=(*good.pocketed, Drop(1.1, "cue", "x")))
    wrong = Stroke(good.touches, cue="cue", pocketed=(Drop(1.0, "1", "north pocket"),))
    made = [outcome("pool.cut_45", done, lies, (2.54, 1.27)).made for done in (good, lost, wrong)]
    assert made == [True, False, False]
