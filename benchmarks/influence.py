"""What moves a stroke, and by how much: coefficients, laws and the player's hand, one at a time."""

from collections.abc import Callable
from dataclasses import astuple, replace
from functools import partial
from math import cos, radians, sin
from random import Random
from typing import Any, NamedTuple

import numpy as np

from physics import Ball, Shot, World, laws, sensitivity, simulate, tables

from .report import FULL, QUICK, Report, options

STROKES = {FULL: 79, QUICK: 20}  # of less: 2
SECONDS = 6.0
SAMPLES = 61
NUDGE = 1e-6  # m/s or degrees, of a number of the shot: for the slopes of a path
ROUNDS, GAINED = 10, 1e-3  # of a fit, and of the misfit's square: a gain below it ends the fit
FARTHEST = 10.0  # m/s or degrees, that a fit may go from the shot
TABLE = tables.MATCH_CAROM_2
FELT = TABLE.cloth
RAIL: Any = TABLE.cushion_law
HIT: Any = TABLE.ball_law
OFF = 0.5e-3  # m
ROOM = 0.05  # m, between balls that are placed by lot
HEADS = ("changed", "same shot, cm", "refitted, cm", "90 %", "at rest, cm")

Stroke = tuple[World, Shot]
Change = Callable[[World, Shot], Stroke]


class Moved(NamedTuple):
    """By how much a change moves a stroke, m.

    same: rms over balls and time, of the same shot.
    fitted: the same of the shot that comes nearest to the path before the change.
    rest: of the ball that lies farthest from where it lay.
    """

    same: float
    fitted: float
    rest: float


def stroke(dice: Random) -> Stroke:
    """Three balls anywhere, and a shot of 2 to 5 m/s that meets one of them."""
    while True:
        world = TABLE.world()
        half = 0.5 * TABLE.length - TABLE.radius, 0.5 * TABLE.width - TABLE.radius
        spots = [complex(*(dice.uniform(-1.0, 1.0) * side for side in half)) for _ in range(3)]
        pairs = (spots[0] - spots[1], spots[1] - spots[2], spots[2] - spots[0])
        if min(map(abs, pairs)) < 2.0 * TABLE.radius + ROOM:
            continue
        for name, p in zip(("white", "yellow", "red"), spots, strict=True):
            world.add(Ball(name, (p.real, p.imag)))
        speed = dice.uniform(2.0, 5.0)
        spins = (dice.uniform(-0.6, 0.6) * speed for _ in range(2))
        shot = Shot(speed, dice.uniform(0.0, 360.0), next(spins), 0.0, next(spins))
        if simulate(world, "white", shot).log.first("ball"):
            return world, shot


# -- what is changed ---------------------------------------------------------------------------


def cloth(world: World, shot: Shot, **changes: Any) -> Stroke:
    """Other coefficients of the cloth."""
    world = world.copy()
    world.cloth = replace(FELT, **changes)
    return world, shot


def band(world: World, shot: Shot) -> Stroke:
    """Rolling resistance that depends on the speed, as measured."""
    world = world.copy()
    world.cloth = FELT.rolling(lambda v: 0.0402 + 0.0125 * v)
    return world, shot


def cushion(world: World, shot: Shot, **changes: Any) -> Stroke:
    """The rigid law with other coefficients."""
    world = world.copy()
    world.cushion_law = replace(RAIL, **changes)
    return world, shot


def mathavan(world: World, shot: Shot) -> Stroke:
    """Mathavan's law, with the nose that the table has."""
    world = world.copy()
    world.cushion_law = laws.MathavanCushion(nose=RAIL.nose)
    return world, shot


def balls(world: World, shot: Shot, **changes: Any) -> Stroke:
    """The law of two balls with other coefficients."""
    world = world.copy()
    world.ball_law = replace(HIT, **changes)
    return world, shot


def hand(world: World, shot: Shot, **more: float) -> Stroke:
    """Numbers of the shot that are off by so much."""
    return world, replace(shot, **{name: getattr(shot, name) + d for name, d in more.items()})


def faster(world: World, shot: Shot) -> Stroke:
    """One per cent of the speed."""
    return hand(world, shot, speed=0.01 * shot.speed)


def elsewhere(world: World, shot: Shot) -> Stroke:
    """The ball that is met first half a millimetre off, any way."""
    met = simulate(world, "white", shot).log.first("ball", "white")
    world = world.copy()
    ball = world.ball(met.balls[1] if met else "red")
    x, y = ball.position
    turn = 7.0 * shot.angle  # degrees: any
    ball.position = x + OFF * cos(radians(turn)), y + OFF * sin(radians(turn))
    return world, shot


CHANGES: dict[str, Change] = {
    "cushions: e and μ one for all speeds (.891, .242) for e(v)":
        partial(cushion, e=0.891, mu=0.242, e_slope=0.0),
    "Mathavan's cushion (.901, .222) for the rigid one": mathavan,
    "decay of side: 10 for 4.3 rad/s²": partial(cloth, spin_decay=10.0),
    "nose 1 mm higher": partial(cushion, nose=RAIL.nose + 1e-3 / TABLE.radius),
    "e(v) of cushions + .01": partial(cushion, e=RAIL.e + 0.01),
    "friction of balls × 3": partial(balls, mu=3.0 * HIT.mu),
    "sliding friction + .01": partial(cloth, slide=FELT.slide + 0.01),
    "rolling: a + b v for one number": band,
    "friction of cushions + .01": partial(cushion, mu=RAIL.mu + 0.01),
    "friction of balls .03 for .05": partial(balls, mu=0.03),
    "friction of balls: Alciatore's fit for .05": partial(balls, mu="alciatore"),
    "rolling + 5 %": partial(cloth, roll=1.05 * FELT.roll),
    "decay of side + .25 rad/s²": partial(cloth, spin_decay=FELT.spin_decay + 0.25),
    "e of balls − .01": partial(balls, e=HIT.e - 0.01),
    "e of balls falling by .02 for each m/s": partial(balls, e_slope=-0.02),
}  # fmt: skip
HANDS: dict[str, Change] = {
    "angle by .1°": partial(hand, angle=0.1),
    "speed by 1 %": faster,
    "side by .1 m/s": partial(hand, side=0.1),
    "one of the balls .5 mm elsewhere": elsewhere,
}

UNSURE = {
    "cloth.spin_decay": 0.25, "cloth.slide": 0.01, "cloth.roll": 0.0002, "cushion.e": 0.01,
    "cushion.mu": 0.01, "ball.e": 0.01, "ball.mu": 0.02, "cushion.nose": 1e-3 / TABLE.radius,
}  # fmt: skip
"""By how much nobody knows a coefficient, in its unit; of the nose a millimetre."""


# -- how far it moves --------------------------------------------------------------------------


def path(world: World, shot: Shot) -> Any:
    """(balls, samples) complex, m: how the shot goes on in a copy of the world."""
    world = world.copy()
    world.strike("white", shot)
    world.run(SECONDS)
    seen = world.log.at(np.linspace(0.0, SECONDS, SAMPLES))
    return np.array([motion.position @ (1.0, 1j) for motion in seen.values()])


def rms(miss: Any) -> float:
    return float(np.sqrt(np.mean(np.abs(miss) ** 2)))


def moved(world: World, shot: Shot, change: Change, fitted: bool) -> Moved:
    """What the change does to that stroke."""
    other, same = change(world, shot)
    there = path(world, shot)
    rests = (
        np.array([complex(*ball.position) for ball in simulate(w, "white", s).balls])
        for w, s in ((world, shot), (other, same))
    )
    left = fit(other, same, there) if fitted else np.nan
    far = np.abs(next(rests) - next(rests)).max()
    return Moved(rms(path(other, same) - there), left, float(far))


def fit(world: World, shot: Shot, there: Any) -> float:
    """How far the path of the shot that comes nearest to that path is from it, rms in m: damped
    least squares in the five numbers of the shot on the cloth."""

    def missed(x: Any) -> Any:
        if np.abs(x - start).max() > FARTHEST or x[0] <= 0.0:
            return np.full(2 * there.size, np.inf)
        miss = (path(world, Shot(*x)) - there).ravel()
        return np.concatenate((miss.real, miss.imag))

    start = x = np.array(astuple(shot)[:5])
    miss, damping = missed(x), 1e-3
    for _ in range(ROUNDS):
        slopes = np.array([missed(x + step) - miss for step in NUDGE * np.eye(5)]).T / NUDGE
        before = miss @ miss
        while damping < 1e6 and miss @ miss >= before:
            curve = slopes.T @ slopes
            curve += damping * np.diag(curve.diagonal() + 1e-12)
            nearer = x - np.linalg.solve(curve, slopes.T @ miss)
            trial = missed(nearer)
            damping *= 5.0
            if trial @ trial < before:
                x, miss, damping = nearer, trial, damping / 50.0
        if miss @ miss > (1.0 - GAINED) * before:
            break
    return rms(miss[: there.size] + 1j * miss[there.size :])


def row(name: str, strokes: list[Stroke], change: Change, fitted: bool) -> list[Any]:
    """The medians of a change over the strokes, and what nine of ten fits stay below, cm."""
    seen = 100.0 * np.array([moved(*each, change, fitted) for each in strokes])
    same, left, rest = np.median(seen, axis=0)
    return [name, float(same), float(left), float(np.quantile(seen[:, 1], 0.9)), float(rest)]


def scatter(strokes: list[Stroke]) -> list[list[Any]]:
    """To first order: the median over the strokes of how far the ball at rest is off that is off
    most, cm, for each coefficient that is not known."""
    errors = np.array([*UNSURE.values()])
    slopes = [sensitivity(world, "white", shot, by=[*UNSURE]).rest for world, shot in strokes]
    far = [np.hypot(each[:, 0], each[:, 1]).max(axis=0) for each in slopes]
    cm = 100.0 * errors * np.median(far, axis=0)
    return [[name, size, float(x)] for (name, size), x in zip(UNSURE.items(), cm, strict=True)]


def main(arguments: list[str] | None = None) -> int:
    chosen = options("influence", __doc__, arguments)
    page = Report("influence", "What moves a stroke", chosen.out)
    dice = Random("influence")
    strokes = [stroke(dice) for _ in range(STROKES.get(chosen.effort, 2))]
    page.say(
        f"{len(strokes)} random strokes on the match table, edition 2; medians. Same shot: rms over"
        f" three balls and {SECONDS:.0f} s. Refitted: the same of the shot that comes nearest to"
        " the path before the change. At rest: the ball that is off most."
    )
    rows = [row(name, strokes, change, True) for name, change in CHANGES.items()]
    rows += [row(f"player: {name}", strokes, change, False) for name, change in HANDS.items()]
    page.table(HEADS, rows)
    page.data(HEADS, rows)
    page.say("To first order, by `sensitivity(by=…)`: the ball at rest that is off most.")
    page.table(("coefficient", "off by", "at rest, cm"), scatter(strokes))
    page.save()
    return 0
