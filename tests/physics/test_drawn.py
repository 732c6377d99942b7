"""The inverse problem without times: a shot from the line that its ball is to run along."""

import numpy as np
import pytest

from physics import Shot, TimeStepping, recover_drawn, simulate
from physics.studies.paths import places
from tests.support import table_of_tracks as synthetic

SPOTS = (-0.6 - 0.3j, 0.5 + 0.4j, 0.9 - 0.5j)
SHOTS = {  # through two to five cushions, and the last off the red ball as well
    "a long diagonal": (Shot(3.5, 24.0, 1.5, 0.0, 1.0), 5, SPOTS),
    "reverse side": (Shot(2.5, 60.0, 0.8, 0.0, -0.9), 4, SPOTS),
    "draw": (Shot(4.0, 100.0, -1.0, 0.0, 0.3), 5, SPOTS),
    "off a ball": (Shot(3.0, 21.0, 1.2, 0.0, 0.6), 3, (-0.6 + 0j, 0.2 + 0.28j, 0.9 - 0.5j)),
}


def table(spots=SPOTS):
    return synthetic.table(0.212, 0.0045, 0.88, 0.25, *spots)


def line(world, shot, contacts=None):
    """(n,) complex: the path, up to that many contacts of the white ball or to its rest."""
    after = simulate(world, "white", shot)
    hits = [e.time for e in after.log if "white" in e.balls and e.kind in ("cushion", "ball")]
    until = after.log.legs("white")[-1].since if contacts is None else hits[contacts - 1]
    return places(after, np.arange(0.0, until, 0.005))[:, 0]


def by_hand(points, seed, noise=0.01, tremble=0.1):
    """As a hand draws it: errors that hang together over ten centimetres."""
    chance = np.random.default_rng(seed)
    along = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(points)))))
    knots = np.linspace(0.0, along[-1], int(along[-1] / tremble) + 2)
    x, y = (np.interp(along, knots, chance.normal(0.0, noise, len(knots))) for _ in "xy")
    return points + x + 1j * y


def rows(points):
    return np.stack((points.real, points.imag), axis=1)


def farthest(points, others):
    """The greatest distance of a point from the other line."""
    return float(np.abs(points[:, None] - others[None, :]).min(axis=1).max())


@pytest.mark.parametrize("name", SHOTS)
@pytest.mark.parametrize("seed", [1, 2])
def test_a_path_drawn_by_hand_is_run_along_within_two_centimetres(name, seed):
    shot, contacts, spots = SHOTS[name]
    world = table(spots)
    clean = line(world, shot, contacts)
    found = recover_drawn(world, "white", rows(by_hand(clean, seed)))
    assert found.share == 1.0
    assert found.misfit < 0.013
    assert farthest(clean, line(world, found.shot)) < 0.02
    assert abs(found.shot.angle - shot.angle) < 3.0
    assert found.shot.masse == pytest.approx(0.0, abs=1e-6)


def test_the_errors_hold_what_the_drawing_does_not_show():
    """A straight line to the first cushion shows the angle, and neither speed nor spin."""
    world = table()
    found = recover_drawn(world, "white", rows(by_hand(line(world, Shot(3.0, 3.0), 1), 4)))
    errors = found.errors
    assert abs(found.shot.angle - 3.0) < 3.0 * errors["angle"] < 3.0
    assert errors["speed"] > 1.0
    assert errors["side"] > 0.3 * found.shot.speed
    assert errors["masse"] < 1e-6


def test_numbers_that_are_given_stay_and_make_the_others_surer():
    shot, contacts, spots = SHOTS["a long diagonal"]
    world = table(spots)
    drawn = rows(by_hand(line(world, shot, contacts), 3))
    free = recover_drawn(world, "white", drawn)
    known = recover_drawn(world, "white", drawn, given={"speed": 3.5, "masse": 0.0, "follow": 1.5})
    assert known.shot.speed == pytest.approx(3.5, abs=1e-6)
    assert known.shot.follow == pytest.approx(1.5, abs=1e-6)
    assert abs(known.shot.side - 1.0) < 0.25
    assert known.errors["side"] <= free.errors["side"] + 1e-9


def test_a_ball_that_is_to_rest_at_the_end_has_its_speed_from_there():
    world = table()
    shot = Shot(1.2, 40.0, 1.2, 0.0, 0.0)
    clean = line(world, shot)
    found = recover_drawn(world, "white", rows(by_hand(clean, 1)), rests=True)
    end = simulate(world, "white", found.shot).ball("white").position
    assert abs(complex(*end) - clean[-1]) < 0.03
    rolls = (5.0 * found.shot.speed + 2.0 * found.shot.follow) / 7.0  # all that its rest shows
    assert rolls == pytest.approx(1.2, abs=0.03)
    among = np.array([5.0, 0.0, 2.0, 0.0, 0.0]) / 7.0
    assert among @ found.covariance @ among < 0.03**2


def test_a_few_points_joined_by_straight_lines_will_do():
    """As a mouse leaves them that is clicked at the corners."""
    world = table()
    after = simulate(world, "white", SHOTS["a long diagonal"][0])
    hits = [e for e in after.log if e.kind == "cushion" and e.balls == ("white",)][:3]
    corners = [world.ball("white").position, *(hit.before[0].position for hit in hits)]
    found = recover_drawn(world, "white", corners)
    assert farthest(np.array([complex(*c) for c in corners]), line(world, found.shot)) < 0.03


def test_what_no_shot_can_follow_is_followed_as_far_as_it_goes_and_says_so():
    world = table()
    clean = line(world, Shot(3.0, 24.0), 1)
    back = np.concatenate((clean, clean[-1] + 0.8 * np.exp(0.3j) * np.linspace(0.02, 1.0, 50)))
    found = recover_drawn(world, "white", rows(back))
    assert 0.4 < found.share < 0.9
    assert abs(found.shot.angle - 24.0) < 3.0


@pytest.mark.parametrize(
    ("path", "options", "message"),
    [
        ([(0.0, 0.0)], {}, "a path of 0 m is too short"),
        ([(0.0, 0.0), (0.01, 0.0)], {}, "a path of 0.01 m is too short"),
        ([(0.0, 0.0, 1.0)], {}, r"finite points \(n, 2\)"),
        ([(0.0, float("nan")), (1.0, 1.0)], {}, r"finite points \(n, 2\)"),
        ("line", {}, "path must be numbers"),
        ([(0.0, 0.0), (1.0, 0.0)], {"noise": 0.0}, "noise must be above zero"),
        ([(0.0, 0.0), (1.0, 0.0)], {"given": {"spin": 1.0}}, "given 'spin' is none of speed"),
        ([(0.0, 0.0), (1.0, 0.0)], {"given": {"speed": "x"}}, "given speed must be a number"),
    ],
)
def test_what_cannot_be_a_drawing_is_refused(path, options, message):
    with pytest.raises(ValueError, match=message):
        recover_drawn(table(), "white", path, **options)


def test_only_the_exact_engine_and_balls_of_the_world_will_do():
    world = table()
    with pytest.raises(ValueError, match="no ball 'pink'"):
        recover_drawn(world, "pink", [(0.0, 0.0), (1.0, 0.0)])
    world.engine = TimeStepping(1 / 180)
    with pytest.raises(ValueError, match="needs the engine EventDriven"):
        recover_drawn(world, "white", [(0.0, 0.0), (1.0, 0.0)])


def test_the_world_stays_as_it_is():
    world = table()
    before = world.layout()
    recover_drawn(world, "white", [(-0.6, -0.3), (0.4, -0.3)])
    assert world.layout() == before
