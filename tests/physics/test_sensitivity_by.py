"""Derivatives by places and coefficients: against central differences in 50 digits."""

from dataclasses import replace

import mpmath
import numpy as np
import pytest

from physics import Ball, Shot, laws, scenes, sensitivity, simulate, tables
from tests.support import fifty

STEP = "1e-16"
NOSE = 0.037 / 0.03075
SHOT = Shot(3.0, 1.0, 1.0, 0.2, 0.5)
ALL = (
    "speed", "angle", "follow", "masse", "side", "positions", "cloth.slide", "cloth.roll",
    "cloth.spin_decay", "cloth.gravity", "cushion.e", "cushion.mu", "cushion.nose",
    "cushion.e_slope", "cushion.mu_slope", "ball.e", "ball.mu", "ball.e_slope", "ball.mu_slope",
)  # fmt: skip
SLOPING = (
    laws.RigidCushion(0.871, 0.269, NOSE, -0.051, -0.01), laws.RoughBall(0.95, 0.05, -0.02, -0.01)
)  # fmt: skip
CONSTANT = laws.RigidCushion(nose=NOSE), laws.RoughBall(0.95, 0.05)


def carom(cushion, ball):
    world = scenes.carom()
    world.cushion_law, world.ball_law = cushion, ball
    return world


def inputs(world, shot, by):
    """The numbers that those names have."""
    things = {"cloth": world.cloth, "cushion": world.cushion_law, "ball": world.ball_law}
    found = {}
    for name in by:
        part, _, key = name.rpartition(".")
        if not part:
            found[name] = getattr(shot, key)
        elif part in things:
            found[name] = getattr(things[part], key)
        else:
            found[name] = world.ball(part).position["xy".index(key)]
    return {name: mpmath.mpf(number) for name, number in found.items()}


def outcome(world, shot, given):
    """(balls, 2) at rest and how many events, in 50 digits; written out from the public numbers."""
    whole = inputs(world, shot, set(wide(world)) - set(given)) | given
    kernel, scene = fifty.kernel(), fifty.scene(world)
    g, slide = whole["cloth.gravity"], whole["cloth.slide"]
    cloth, cushion, ball = scene.cloth, scene.cushion_rule, scene.ball_rule
    cloth.slide, cloth.roll, cloth.grip = slide * g, whole["cloth.roll"] * g, slide
    cloth.fade, cloth.gravity = whole["cloth.spin_decay"], g
    cushion.height = whole["cushion.nose"] - 1
    cushion.level = mpmath.sqrt(1 - cushion.height * cushion.height)
    if isinstance(world.cushion_law, laws.MathavanCushion):
        cushion.slide = slide
    for rule, part in ((cushion, "cushion"), (ball, "ball")):
        e_slope, mu_slope = whole[f"{part}.e_slope"], whole[f"{part}.mu_slope"]
        rule.restitution = whole[f"{part}.e"] - e_slope
        rule.friction = whole[f"{part}.mu"] - mu_slope
        rule.restitution_slope, rule.friction_slope = e_slope / rule.level, mu_slope / rule.level
    for one, body in zip(world.balls, scene.balls, strict=True):
        body.position = mpmath.mpc(whole[f"{one.name}.x"], whole[f"{one.name}.y"])
    along = mpmath.expj(whole["angle"] * mpmath.pi / 180)
    white = scene.balls[0]
    white.velocity, white.side = whole["speed"] * along, whole["side"]
    white.roll = mpmath.mpc(whole["follow"], -whole["masse"]) * along
    kernel.calendar.plan(scene)
    events, _ = kernel.calendar.advance(mpmath.inf, 10**5, scene)
    return [(body.position.real, body.position.imag) for body in scene.balls], events


def wide(world):
    places = [f"{ball.name}.{axis}" for ball in world.balls for axis in "xy"]
    return [*ALL[:5], *places, *ALL[6:]]


def central_differences(world, shot, by):
    """(balls, 2, inputs)."""
    fifty.kernel()  # sets the digits
    at, step = inputs(world, shot, by), mpmath.mpf(STEP)
    columns = []
    for name in by:
        ends = [
            outcome(world, shot, at | {name: at[name] + sign * step}) for sign in (-1, 1)
        ]
        assert ends[0][1] == ends[1][1]
        columns.append(
            [
                [float((b - a) / (2 * step)) for a, b in zip(low, high, strict=True)]
                for low, high in zip(ends[0][0], ends[1][0], strict=True)
            ]
        )
    return np.moveaxis(np.array(columns), 0, -1)


@pytest.mark.parametrize(
    ("cushion", "ball", "shot"),
    [
        (*SLOPING, SHOT),
        (*SLOPING, Shot(5.0, 33.0, 0.5, 1.0, 1.5)),
        (*CONSTANT, SHOT),  # also by the slopes, which are 0
    ],
)
def test_every_input_of_a_carom_shot_has_eleven_digits_of_its_derivative(cushion, ball, shot):
    world = carom(cushion, ball)
    seen = sensitivity(world, "white", shot, ALL)
    assert seen.by == tuple(wide(world))
    exact = central_differences(world, shot, seen.by)
    size = np.abs(exact).max(axis=(0, 1))
    assert (size > 1e-3).sum() >= len(size) - 4  # few of them do not matter in this shot
    assert (np.abs(seen.rest - exact).max(axis=(0, 1)) < 1e-11 * np.maximum(size, 1e-3)).all()


def test_mathavan_s_cushion_has_the_cloth_s_friction_also_in_its_derivatives():
    world = tables.match_carom()
    world.cushion_law = laws.MathavanCushion(0.9, 0.22, None, NOSE, -0.05, -0.01)
    world.ball_law = CONSTANT[1]
    world.add(Ball("white", (-0.6, 0.0), radius=0.03075, mass=0.21))
    by = ("cloth.slide", "cushion.e", "cushion.mu", "cushion.nose", "cushion.e_slope")
    shot = Shot(2.0, 40.0, 1.0, 0.0, 1.0)
    seen, exact = sensitivity(world, "white", shot, by), central_differences(world, shot, by)
    assert np.abs(seen.rest - exact).max() < 1e-6 * np.abs(exact).max()


def test_the_scatter_of_cue_places_and_table_is_that_of_worlds_that_differ_by_a_little():
    world, shot = carom(*CONSTANT), Shot(2.0, 1.0, 2.0, 0.0, 0.3)
    errors = {"angle": 1e-6, "positions": 1e-8, "cushion.e": 2e-6, "cloth.roll": 1e-7}
    seen = sensitivity(world, "white", shot, ALL)
    wanted = np.zeros((4, 2, 2))
    for change in changes(world, shot, errors):
        ends = [np.array([b.position for b in simulate(w, "white", s).balls]) for w, s in change]
        moved = (ends[1] - ends[0]) / 2
        wanted += moved[:, :, None] * moved[:, None, :]
    covariance = seen.covariance(errors)
    assert covariance == pytest.approx(wanted, rel=1e-4, abs=1e-5 * wanted.max())
    k = [seen.by.index(name) for name in ("angle", "cushion.e")]
    both = np.zeros((len(seen.by),) * 2)
    both[np.ix_(k, k)] = [[1e-6, 5e-7], [5e-7, 1e-6]]
    rest = seen.rest[:, :, k]
    joint = rest @ both[np.ix_(k, k)] @ rest.transpose(0, 2, 1)
    assert seen.covariance(both) == pytest.approx(joint, rel=1e-12)


def changes(world, shot, errors):
    """Pairs of (world, shot) on both sides of the nominal ones, one for each input."""
    for name, error in errors.items():
        sides = (-error, error)
        if name == "angle":
            yield [(world, Shot(2.0, 1.0 + d, 2.0, 0.0, 0.3)) for d in sides]
        elif name == "positions":
            for k in range(len(world.balls)):
                for axis in range(2):
                    yield [(moved(world, k, axis, d), shot) for d in sides]
        elif name == "cushion.e":
            yield [(with_cushion(world, 0.891 + d), shot) for d in sides]
        else:
            yield [(with_roll(world, world.cloth.roll + d), shot) for d in sides]


def moved(world, k, axis, d):
    other = world.copy()
    place = list(other.balls[k].position)
    place[axis] += d
    other.balls[k].position = place
    return other


def with_cushion(world, e):
    other = world.copy()
    other.cushion_law = laws.RigidCushion(e, nose=NOSE)
    return other


def with_roll(world, roll):
    other = world.copy()
    other.cloth = replace(other.cloth, roll=roll)
    return other


def test_a_law_from_outside_has_no_inputs_but_lets_the_others_through():
    own = laws.RigidCushion(nose=NOSE)
    world = carom(lambda *hit: own(*hit), CONSTANT[1])
    by = ("angle", "cloth.slide", "ball.e", "white.x")
    named = sensitivity(carom(*CONSTANT), "white", SHOT, by).rest
    assert sensitivity(world, "white", SHOT, by).rest == pytest.approx(named, rel=1e-8, abs=1e-8)
    with pytest.raises(ValueError, match=r"'cushion.e' is no input of this world: there are speed"):
        sensitivity(world, "white", SHOT, ("cushion.e",))


@pytest.mark.parametrize(
    ("by", "message"),
    [
        (("angle", "angle"), "'angle' is there twice"),
        (("positions", "white.x"), "'white.x' is there twice"),
        (("pink.x",), "'pink.x' is no input of this world"),
        (("cushion.slide",), "'cushion.slide' is the cloth's friction here: name 'cloth.slide'"),
        (("ball.mu",), "'ball.mu' is no number of RoughBall"),
        ((3,), "3 is no input"),
    ],
)
def test_inputs_that_are_none_are_refused_by_name(by, message):
    world = scenes.carom()
    world.cushion_law = laws.MathavanCushion()
    with pytest.raises(ValueError, match=message):
        sensitivity(world, "white", SHOT, by)


def test_one_name_needs_no_list():
    assert sensitivity(scenes.carom(), "white", SHOT, "cloth.slide").by == ("cloth.slide",)


@pytest.mark.parametrize(
    ("errors", "message"),
    [
        ({"cloth.roll": 1.0}, "'cloth.roll' is none of the inputs angle, white.x"),
        ({"angle": -1.0}, "errors must not be negative"),
        ([[1.0, 0.0]], "symmetric and finite, 2 x 2"),
        ([[1.0, 0.2], [0.0, 1.0]], "symmetric"),
    ],
)
def test_errors_that_fit_no_input_are_refused(errors, message):
    seen = sensitivity(scenes.carom(), "white", SHOT, ("angle", "white.x"))
    with pytest.raises(ValueError, match=message):
        seen.covariance(errors)
