"""Aiming without typing: what the mouse, the wheel and the keys write into the five boxes.

Every function writes numbers into the boxes, as a player could: there is no aim but theirs. Power
keeps the tip point, and so moves the spins along with the speed; the tip keeps the speed. Those
that may have to tell the player something return a key of the texts, or "".
"""

from __future__ import annotations

from math import degrees

from physics import Ball, World, heading

from . import cue_room, thickness
from .entry import BOXES, MOST, Aim
from .preview import Preview
from .tip import LIMIT, STEEPEST, Tip

WEAKEST, STRONGEST = 0.05, 8.0
"""Ends of what can be set by hand, m/s: a ball that hardly moves, and a hard shot of carom."""
BREAKS = {"pool": 13.0, "pyramid": 13.0}
"""What can be set by hand on tables of these kinds instead: a hard break."""
CENTRE = Tip(0.0, 0.0)
"""In the middle, with a level cue; also where a tip point begins that is not known yet."""
BEND = 1.6
"""Power of the power bar: half of it is for speeds below 2.6 m/s, where touch matters."""
MISCUE = "miscue"
"""Said where a tip point has been brought back to the ring: all the same it can be played."""


def strongest(world: World) -> float:
    """The speed at the end of the power bar of a world's table, m/s."""
    return BREAKS.get(getattr(world.table, "kind", ""), STRONGEST)


def share(speed: float, most: float = STRONGEST) -> float:
    """How much of the power bar a speed fills: 1 at `most`."""
    return float((speed / most) ** (1.0 / BEND))


def speed_at(part: float, most: float = STRONGEST) -> float:
    """The speed at a part of the power bar that ends at `most`, m/s."""
    return max(WEAKEST, most * float(min(max(part, 0.0), 1.0) ** BEND))


def put(aim: Aim, value: str) -> None:
    """Write numbers into boxes by their names ("side 1.5 follow 0.5")."""
    words = value.split()
    if {*words[::2]} != {"angle"}:
        aim.lower()
    aim.put(**{n: float(v) for n, v in zip(words[::2], words[1::2], strict=True)})


def turn(aim: Aim, value: str) -> None:
    """Turn the aim by some degrees, anticlockwise."""
    angle = (aim.angle or 0.0) + float(value)
    aim.put(4, angle=angle if abs(angle) <= MOST["angle"] else angle % 360.0)


def power(aim: Aim, value: str) -> None:
    """Set the speed along the cue, m/s: with a level one the ball's. The tip stays where it is, so
    the spins follow the speed."""
    aim.speed(min(max(float(value), WEAKEST), aim.strongest))


def push(aim: Aim, value: str) -> None:
    """Change the speed by so much, m/s."""
    power(aim, str((aim.power or 0.0) + float(value)))


def tip(aim: Aim, value: str) -> str:
    """Set the tip point (right and up, radii); beyond the ring it is held there, and said so."""
    right, up = map(float, value.split())
    return _strike_at(aim, Tip(right, up, _elevation(aim)))


def nudge(aim: Aim, value: str) -> str:
    """Move the tip point by so much."""
    now = aim.tip or CENTRE
    right, up = map(float, value.split())
    return _strike_at(aim, Tip(now.right + right, now.up + up, _elevation(aim)))


def centre(aim: Aim) -> str:
    """Strike in the middle with a level cue."""
    return _strike_at(aim, CENTRE)


def tilt(aim: Aim, value: str) -> str:
    """Raise the butt of the cue by so many degrees."""
    return elevate(aim, str(_elevation(aim) + float(value)))


def elevate(aim: Aim, value: str) -> str:
    """Set the cue's elevation, degrees; the tip meets the same spot as seen along the cue.

    The cue keeps its speed: the ball leaves the slower, and hops the higher, the steeper it is.
    """
    now = aim.tip or CENTRE
    return _strike_at(aim, Tip(now.right, now.up, min(max(float(value), 0.0), STEEPEST)))


def _elevation(aim: Aim) -> float:
    return (aim.tip or CENTRE).elevation or 0.0


def _strike_at(aim: Aim, wanted: Tip) -> str:
    if not aim.hold(wanted.within()):
        return "power"
    return MISCUE if wanted.away > LIMIT else ""


def make_room(aim: Aim, world: World, cue: str) -> None:
    """Raise the cue as far as the balls and the cushion behind the cue ball ask for, and no more
    than the player has if they ask for less."""
    tip = aim.tip
    if tip is None or tip.elevation is None or aim.cue_angle is None:
        return
    forced = aim.forced is not None and aim.texts[len(BOXES) :] == [aim.forced[0]]
    wanted = aim.forced[1] if aim.forced is not None and forced else tip.elevation
    steep = max(wanted, cue_room.needed(world, cue, aim.cue_angle, tip.up))
    if steep != tip.elevation and aim.hold(Tip(tip.right, tip.up, steep)):
        aim.forced = None if steep == wanted else (aim.texts[-1], wanted)


def past(aim: Aim, world: World, cue: str, seen: Preview | None, eighths: int) -> float | None:
    """The angle, degrees, at which the first ball is met at so many eighths; None without one."""
    shot = aim.shot
    if shot is None or seen is None:
        return None
    angle = thickness.angle(world, cue, shot, seen, eighths)
    return None if angle is None else degrees(angle)


def take_over(aim: Aim, ball: Ball) -> None:
    """Write into the boxes what a scene has already given to the cue ball."""
    v = complex(*ball.velocity)
    if v:
        wx, wy, wz = (w * ball.radius for w in ball.spin)
        spin = complex(wx, wy) * abs(v) / v
        numbers = (abs(v), spin.imag, spin.real, wz, heading(v))
        aim.lower()
        aim.put(3, **dict(zip(BOXES, numbers, strict=True)))
    aim.spent()
