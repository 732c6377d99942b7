"""Fits: what is found on synthetic tables whose truth is known, and what is refused."""

from dataclasses import replace

import mpmath
import numpy as np
import pytest

from physics import Ball, Cloth, Shot, TimeStepping, Track, World, fit, laws, simulate, tables
from physics.studies.paths import Paths
from physics.studies.tracks import filmed
from tests.physics.test_sensitivity_by import inputs, wide
from tests.support import fifty
from tests.support import table_of_tracks as synthetic
from tests.support.sampling import mostly
from tests.support.table_of_tracks import UNKNOWN, case

SURE = 18.5  # squared distances of four numbers exceed this once in a thousand
RICH = {"cloth.slide": 0.2, "cloth.roll": 0.006, "cushion.e": 0.87, "cushion.mu": 0.2}


def distance(found, truth):
    """Mahalanobis' distance of the truth, squared: 4 on average, for four numbers."""
    off = found.values - truth
    return off @ np.linalg.solve(found.covariance, off)


@pytest.mark.parametrize("seed", mostly([8, 16], quick=(16,)))
def test_four_tracks_at_50_hz_with_half_a_millimetre_show_four_coefficients(seed):
    given = case(seed)
    found = fit(given.world, given.tracks, UNKNOWN)
    assert found.names == UNKNOWN
    assert (np.abs(found.values - given.truth) < 2.0 * found.errors).all()
    assert (found.errors < [2e-4, 3e-6, 2e-4, 2e-4]).all()  # measured half of that, or less
    assert found.misfit == pytest.approx(5e-4, rel=0.03)
    assert all(stroke.share == 1.0 and stroke.ball == "white" for stroke in found.strokes)
    assert found.world.cloth.slide == found.values[0]
    assert found.world.cushion_law.mu == found.values[3]
    assert given.world.cloth.slide != found.values[0]


@pytest.mark.stress
def test_48_of_50_tables_are_found_from_poor_values_and_the_errors_are_what_they_say():
    distances = []
    for seed in range(50):
        given = case(seed)
        distances.append(distance(fit(given.world, given.tracks, UNKNOWN), given.truth))
    assert sum(d < SURE for d in distances) >= 48  # measured 50, mean 4.2
    assert 3.0 < np.median(distances) < 5.5  # 3.4 for four numbers that are as sure as stated


@pytest.mark.parametrize(
    ("rate", "lost"), mostly([(25.0, 0.0), (240.0, 0.0), (50.0, 0.3)], quick=[(50.0, 0.3)])
)
def test_cameras_of_25_to_240_hz_and_gaps_will_do(rate, lost):
    given = case(16, strokes=3, rate=rate, lost=lost)
    found = fit(given.world, given.tracks, UNKNOWN)
    assert distance(found, given.truth) < SURE
    if lost:
        assert all(np.isnan(track.positions).any() for track in given.tracks)


def test_a_track_that_begins_in_mid_flight_is_fitted_from_there():
    given = case(8)
    tracks = [
        Track(track.times[late:], track.positions[late:], track.noise)
        for track, late in zip(given.tracks, (14, 16, 14, 16), strict=True)
    ]
    found = fit(given.world, tracks, UNKNOWN)
    assert distance(found, given.truth) < SURE
    assert "start" not in found.strokes[0].values


def test_mistaken_samples_do_not_move_the_outcome():
    given, chance = case(16), np.random.default_rng(0)
    clean = fit(given.world, given.tracks, UNKNOWN)
    for track in given.tracks:
        wrong = chance.random(len(track.times)) < 0.02
        wrong[:20] = False
        track.positions[wrong, 1] += chance.normal(0.0, 0.05, (wrong.sum(), 2))
    found = fit(given.world, given.tracks, UNKNOWN)
    assert (np.abs(found.values - clean.values) < 2.0 * clean.errors).all()
    assert found.misfit > 2.0 * clean.misfit


def test_coefficients_may_differ_from_track_to_track():
    given = case(16, strokes=3)
    found = fit(given.world, given.tracks, UNKNOWN, share=UNKNOWN[:2])
    assert found.names == UNKNOWN[:2]
    for stroke in found.strokes:
        for name, true in zip(UNKNOWN[2:], given.truth[2:], strict=True):
            assert abs(stroke.values[name] - true) < 4.0 * stroke.errors[name]


def test_strokes_kept_aside_test_what_was_found():
    given = case(8)
    found = fit(given.world, given.tracks[:3], UNKNOWN)
    tested = fit(found.world, given.tracks[3:], ())
    assert tested.names == ()
    assert tested.misfit == pytest.approx(5e-4, rel=0.06)
    poor = fit(given.world, given.tracks[3:], ())
    assert poor.misfit > 4.0 * tested.misfit or poor.strokes[0].share < 1.0


@pytest.mark.stress
def test_slopes_and_balls_are_found_too():
    chance, tracks = np.random.default_rng(7), []
    for _ in range(6):
        world = synthetic.table(0.2, 0.005, 0.87, 0.2, *synthetic.spots(chance))
        world.cushion_law = replace(world.cushion_law, e_slope=-0.05)
        tracks.append(filmed(world, "white", synthetic.stroke(chance), chance))
    start = synthetic.table(0.2, 0.005, 0.8, 0.2, -0.5 + 0j, 0.3 + 0.2j, 0.6 - 0.2j)
    start.ball_law = laws.RoughBall(0.9, 0.05)
    names = ("cushion.e", "cushion.e_slope", "ball.e")
    found = fit(start, tracks, names)
    assert distance(found, [0.87, -0.05, 0.946]) < SURE


def path(world, shot, given, moments):
    """(T, balls) mpc: where balls are at those times, in 50 digits."""
    kernel, scene = fifty.kernel(), fifty.scene(world)
    whole = inputs(world, shot, wide(world)[:5]) | given
    scene.cloth.slide = whole["cloth.slide"] * mpmath.mpf(world.cloth.gravity)
    scene.cushion_rule.restitution = whole["cushion.e"]
    along = mpmath.expj(whole["angle"] * mpmath.pi / 180)
    white = scene.balls[0]
    white.position = mpmath.mpc(whole["white.x"], white.position.imag)
    white.velocity, white.side = whole["speed"] * along, whole["side"]
    white.roll = mpmath.mpc(whole["follow"], -whole["masse"]) * along
    kernel.calendar.plan(scene)
    found = []
    for moment in moments:
        kernel.calendar.advance(moment, 10**5, scene)
        found.append([kernel.leg.place(ball, moment - ball.since) for ball in scene.balls])
    return found


def test_slopes_of_a_path_at_given_moments_agree_with_fifty_digits():
    by = ("angle", "speed", "follow", "side", "white.x", "cloth.slide", "cushion.e")
    world = synthetic.table(0.2, 0.005, 0.87, 0.2, -0.5 + 0j, 0.3 + 0.01j, 0.6 - 0.2j)
    shot = Shot(3.0, 1.5, 1.0, 0.0, 0.7)
    times = np.arange(-0.1, 3.0, 0.1)
    seen = np.zeros((len(times), 3, 2))
    after = simulate(world, "white", shot)
    paths = Paths(after, "white", shot, by)
    fifty.kernel()
    step, moments = mpmath.mpf("1e-16"), [mpmath.mpf(max(t, 0.0)) for t in times]
    at = inputs(world, shot, by)
    for k, name in enumerate(by):
        low, high = (path(world, shot, at | {name: at[name] + s * step}, moments) for s in (-1, 1))
        for ball in range(3):
            rows = zip(low, high, strict=True)
            exact = [complex((b[ball] - a[ball]) / (2 * step)) for a, b in rows]
            places, slopes, _ = paths.slopes(ball, times)
            assert np.abs(slopes[:, k] - exact).max() < 1e-11 * max(np.abs(exact).max(), 1.0)
            seen[:, ball] = np.stack((places.real, places.imag), axis=-1)
    assert np.ptp(seen[:, 1], axis=0).max() > 0.1  # the yellow ball was hit


# -- what is refused ---------------------------------------------------------------------------


def lone(shot=None, seconds=1.2, places=(-0.5 + 0j, 0.3 + 0.4j, 0.6 - 0.4j)):
    """A world, and a track of a stroke in it."""
    world = synthetic.table(0.2, 0.005, 0.87, 0.2, *places)
    shot = shot or Shot(2.0, 0.0, 1.0)
    return world, filmed(world, "white", shot, np.random.default_rng(1), until=seconds)


def test_a_coefficient_that_nothing_depends_on_is_named():
    world, track = lone(seconds=0.6)
    with pytest.raises(ValueError, match=r"do not show 'cushion.e': that takes a ball that meets"):
        fit(world, [track], ("cloth.slide", "cushion.e"))
    with pytest.raises(ValueError, match=r"do not show 'ball.mu': that takes two balls that meet"):
        fit(world, [track], ("ball.mu",))


def test_coefficients_that_only_act_together_are_named():
    given = case(16, strokes=2)
    world = synthetic.table(*given.truth, -0.5 + 0j, 0.3 + 0.2j, 0.6 - 0.2j)
    with pytest.raises(ValueError, match=r"do not tell 'cloth.gravity' from .*'cloth.slide'"):
        fit(world, given.tracks, ("cloth.slide", "cloth.roll", "cloth.gravity"))


def test_a_coefficient_behind_an_unknown_start_is_named():
    world, track = lone(Shot(2.0, 0.0, 2.0), seconds=0.7)  # it rolls from the beginning
    with pytest.raises(ValueError, match=r"'cloth.slide'"):
        fit(world, [track], ("cloth.slide",))


def changed(track, **fields):
    return replace(track, **fields)


def swapped(track, at):
    places = track.positions.copy()
    places[at:, [0, 1]] = places[at:, [1, 0]]
    return places


def test_tracks_that_cannot_be_are_refused_with_what_is_wrong():
    world, track = lone()
    whole = track.positions
    for tracks, message in (
        ([], "at least one track"),
        ([changed(track, positions=1000.0 * whole)], "inside the cushion .* wrong scale"),
        ([changed(track, positions=whole[:, :2])], "is of 2 balls, the world has"),
        ([changed(track, positions=0.01 * whole)], "m apart, but touch at .*: wrong scale"),
        ([changed(track, positions=swapped(track, 40))], "change places at 10.61. s: swapped?"),
        ([changed(track, ball="yellow")], "'yellow' is said to be struck, but 'white' moves first"),
        ([changed(track, ball="pink")], "track 0: there is no ball 'pink'"),
        ([changed(track, times=1000.0 * track.times)], "samples a second: too few"),
        ([changed(track, positions=whole * [[[1.0], [np.nan], [1.0]]])], "'yellow' is never seen"),
        ([changed(track, positions=np.tile(whole[:1], (len(whole), 1, 1)))], "does not move"),
        ([Track(track.times[10:12], whole[10:12])], "numbers in 1 tracks are too few for"),
    ):
        with pytest.raises(ValueError, match=message):
            fit(world, tracks, UNKNOWN)


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"times": [0.0, 1.0]}, r"times \(T,\) and positions \(T, balls, 2\), not \(2,\) and"),
        ({"times": [0.0, 0.0, 1.0]}, "grow"),
        ({"noise": 0.0}, "Track.noise must be above zero"),
        ({"positions": np.full((3, 1, 2), np.inf)}, "finite, or NaN"),
        ({"positions": [["a"]]}, "Track.positions must be numbers"),
    ],
)
def test_numbers_that_are_no_track_are_refused(fields, message):
    good = {"times": [0.0, 0.1, 0.2], "positions": np.zeros((3, 1, 2))}
    with pytest.raises(ValueError, match=message):
        Track(**(good | fields))


@pytest.mark.parametrize(
    ("unknown", "options", "message"),
    [
        (("cushion.ee",), {}, "'cushion.ee' is no input of this world"),
        (("angle",), {}, "unknown 'angle' is no coefficient: there are cloth.slide"),
        (UNKNOWN, {"share": ("ball.e",)}, "share: 'ball.e' is none of the unknown cloth.slide"),
        (UNKNOWN, {"start": ("speed", "ball.e")}, "start: 'ball.e' is a coefficient"),
    ],
)
def test_names_that_cannot_be_are_refused(unknown, options, message):
    world, track = lone()
    with pytest.raises(ValueError, match=message):
        fit(world, [track], unknown, **options)


def test_only_the_exact_engine_is_fitted():
    world, track = lone()
    world.engine = TimeStepping(1 / 180)
    with pytest.raises(ValueError, match="needs the engine EventDriven"):
        fit(world, [track], UNKNOWN)


def test_a_world_without_walls_shows_its_cloth():
    world = World(Cloth(0.25, 0.01, 4.0))
    world.add(Ball("white", (0.0, 0.0)))
    track = filmed(world, "white", Shot(2.0, 30.0, 0.2), np.random.default_rng(2))
    world.cloth = Cloth(0.2, 0.02, 4.0)
    found = fit(world, [track], ("cloth.slide", "cloth.roll"))
    assert (np.abs(found.values - [0.25, 0.01]) < 4.0 * found.errors).all()
    assert found.strokes[0].errors["side"] == np.inf


@pytest.mark.parametrize(("angle", "speed"), [(24.7, 3.0), (24.7, 1.15)])
def test_a_ball_that_is_seen_at_a_pocket_is_inside_no_cushion(angle, speed):
    """It lies at the rim of the hole, or has dropped, and is seen there as long as others move."""
    world = tables.pool_9ft()
    world.add(Ball("white", (0.0, 0.0)))
    shot = Shot(speed, angle)
    assert simulate(world, "white", shot).ball("white").gone
    track = filmed(world, "white", shot, np.random.default_rng(1), until=3.0)
    (stroke,) = fit(world, [track], ()).strokes
    assert stroke.share == 1.0
    assert stroke.shot.speed == pytest.approx(speed, abs=4.0 * stroke.errors["speed"])
