"""Each lab solved as a student does: from the numbers of its page, to the digits printed there."""

from math import atan2, degrees, hypot, log, pi, sqrt

import pytest

from danggu import labs
from danggu.labs import text
from danggu.labs.pi_by_collisions import LIGHT, RADIUS
from danggu.labs.readings import slope

SEEDS = (None, 1, 2, 3, 2026)


def printed(sheet):
    """The table of the page, as its numbers are written."""
    rows = sheet.table().rows
    cells = [[text.figure(cell, "en") for cell in row] for row in rows]
    return [[_number(cell) for cell in row] for row in cells]


def _number(cell):
    try:
        return float(cell.replace("−", "-"))
    except ValueError:
        return cell


def angle(x, y):
    return degrees(atan2(y, x))


def five_sevenths(sheet, rows):
    (times, ways, speeds) = zip(*rows, strict=True)
    brake = -slope(times[:8], speeds[:8])
    begin, end = speeds[0], speeds[8]
    return {
        "speed": end, "time": (begin - end) / brake, "length": ways[8],
        "friction": brake / 9.81, "lost": 100.0 * (1.0 - 1.4 * end**2 / begin**2),
        "draw": 2.5 * begin,
    }  # fmt: skip


def right_angle(sheet, rows):
    hits = {row[0]: row[1:] for row in rows}
    white, red = hits["white"][3:], hits["red"][3:]
    line = red[0] / hypot(*red), red[1] / hypot(*red)
    before = hits["white"][1] * line[0]
    after = white[0] * line[0] + white[1] * line[1]
    turned = angle(*red) - angle(*white)
    return {
        "angle": turned, "white": hypot(*white), "red": hypot(*red),
        "e": (hypot(*red) - after) / before,
    }  # fmt: skip


def thirty_degrees(sheet, rows):
    _, wx, wy, rx, ry = zip(*rows, strict=True)
    cut = angle(rx[-1] - rx[0], ry[-1] - ry[0])
    return {
        "red": cut, "first": 90.0 - cut, "last": -angle(wx[-1] - wx[-3], wy[-1] - wy[-3]),
        "greatest": degrees(atan2(1.0, sqrt(0.4) * sqrt(1.4) * 2.0)),
    }  # fmt: skip


def momentum_energy(sheet, rows):
    masses = [row[1] for row in rows]
    before, after = [row[2:4] for row in rows], [row[4:6] for row in rows]
    push = [after[0][k] - before[0][k] for k in (0, 1)]
    closing, parting = (
        sum((side[1][k] - side[0][k]) * push[k] for k in (0, 1)) for side in (before, after)
    )
    return {
        "px": sum(m * v[0] for m, v in zip(masses, before, strict=True)),
        "py": sum(m * v[1] for m, v in zip(masses, after, strict=True)),
        "before": sum(0.5 * m * hypot(*v) ** 2 for m, v in zip(masses, before, strict=True)),
        "after": sum(0.5 * m * hypot(*v) ** 2 for m, v in zip(masses, after, strict=True)),
        "e": -parting / closing,
    }


def unknown_mass(sheet, rows):
    hits, known = {row[0]: row[1:] for row in rows}, sheet.numbers["known"]
    (ux, _, vx, vy), (_, _, rx, ry) = hits["white"], hits["red"]
    mass = known * (ux - vx) / rx
    lost = 1.0 - (known * (vx**2 + vy**2) + mass * (rx**2 + ry**2)) / (known * ux**2)
    far = hypot(rx, ry)
    e = (far - (vx * rx + vy * ry) / far) / (ux * rx / far)
    return {"mass": mass, "e": e, "lost": 100.0 * lost}


def cushion_side(sheet, rows):
    sides = [row[0] for row in rows]
    angles = [angle(-row[3], row[4]) for row in rows]
    k = next(k for k in range(5) if angles[k] < 0.0)
    share = angles[k - 1] / (angles[k - 1] - angles[k])
    straight = sides[k - 1] + share * (sides[k] - sides[k - 1])
    return {"none": angles[2], "right": angles[4], "left": angles[0], "straight": straight}


def rolling_resistance(sheet, rows):
    brake = -slope(*zip(*rows, strict=True))
    time = rows[0][1] / brake
    return {
        "brake": brake, "roll": brake / 9.81, "time": time, "length": 0.5 * rows[0][1] * time
    }  # fmt: skip


def cradle(sheet, rows):
    leave = [row[2] for row in rows if row[2]]
    speed = leave[0]
    momentum, energy = 0.25 * sum(leave), 0.125 * sum(v**2 for v in leave)
    return {
        "leave": len(leave), "speed": speed, "momentum": momentum, "energy": energy,
        "factor": 0.125 * (momentum / 0.25) ** 2 / energy,
    }  # fmt: skip


def pi_by_collisions(sheet, rows):
    ratio = sheet.numbers["ratio"]
    theta = atan2(1.0, sqrt(ratio))
    # with √M x and √m x of the two as axes, their way unfolded passes the corner at √m times this
    apart = LIGHT - RADIUS
    return {
        "angle": degrees(theta), "count": int(pi / theta - 1e-12), "digits": 3141, "speed": 1.0,
        "nearest": 3.0 * RADIUS + apart / sqrt(ratio),
    }  # fmt: skip


def growth_of_error(sheet, rows):
    times, apart = zip(*rows, strict=True)
    rate = slope(times, [log(d) for d in apart])
    ends = zip(times[-2:], apart[-2:], strict=True)
    (begin, near), (end, far) = ((time, log(d / 0.01)) for time, d in ends)
    last = begin + (end - begin) * near / (near - far)
    return {
        "rate": rate, "doubling": log(2.0) / rate, "centimetre": last, "more": log(10.0) / rate
    }  # fmt: skip


def thesis_masse(sheet, rows):
    times, _, _, vx, vy = zip(*rows, strict=True)
    ax, ay = slope(times, vx), slope(times, vy)
    turn = -vx[0] / ax
    n = sheet.numbers
    rolls = (5 * n["speed"] + 2 * n["follow"]) / 7, -2 * n["masse"] / 7
    return {
        "turn": turn, "farthest": 0.5 * vx[0] * turn, "push": abs(angle(ax, ay)),
        "friction": hypot(ax, ay) / 9.8, "speed": hypot(*rolls), "angle": abs(angle(*rolls)),
    }  # fmt: skip


def thesis_cushion(sheet, rows):
    (_, ux, uy, *before), (_, vx, vy, *after) = rows
    energies = [
        0.5 * 0.25 * (x**2 + y**2 + 0.4 * sum(w**2 for w in spin))
        for x, y, spin in ((ux, uy, before), (vx, vy, after))
    ]
    return {
        "angle": abs(angle(-vx, vy)), "ratio": -vx / ux, "side": after[2],
        "lost": 1000.0 * (energies[0] - energies[1]),
    }  # fmt: skip


def thesis_hit(sheet, rows):
    (red, yellow) = sorted(rows)
    gone = [0.25 * (red[4 + k] + yellow[4 + k] - red[2 + k] - yellow[2 + k]) for k in (0, 1)]
    before, after = (
        sum(row[k] ** 2 + row[k + 1] ** 2 for row in (red, yellow)) for k in (2, 4)
    )  # fmt: skip
    return {
        "red": hypot(*red[4:]), "yellow": hypot(*yellow[4:]), "momentum": hypot(*gone),
        "lost": 100.0 * (1.0 - after / before),
    }  # fmt: skip


SOLVED = {
    "five-sevenths": five_sevenths, "right-angle": right_angle, "thirty-degrees": thirty_degrees,
    "momentum-energy": momentum_energy, "unknown-mass": unknown_mass,
    "cushion-side": cushion_side, "rolling-resistance": rolling_resistance, "cradle": cradle,
    "pi": pi_by_collisions, "growth-of-error": growth_of_error, "thesis-masse": thesis_masse,
    "thesis-cushion": thesis_cushion, "thesis-swap": thesis_hit, "thesis-oblique": thesis_hit,
}  # fmt: skip


def test_every_lab_is_solved_here():
    assert {*SOLVED} == {*labs.LABS}


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", labs.LABS)
def test_what_follows_from_the_printed_numbers_is_right(name, seed):
    sheet = labs.lab(name, seed)
    answers = SOLVED[name](sheet, printed(sheet))
    wrong = {
        field: (answer, sheet.truth[field])
        for field, answer in answers.items()
        if not sheet.check({field: answer})[field]
    }
    assert wrong == {}
    assert {*answers} == {field.name for field in sheet.fields}
