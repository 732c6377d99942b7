"""Aiming without typing: what the mouse, the wheel and the keys write into the five boxes.

Every function writes numbers into the boxes, as a player could: there is no aim but theirs. Power
keeps the tip point, and so moves the spins along with the speed; the tip keeps the speed.
"""

from __future__ import annotations

from collections.abc import Callable
from math import degrees
from typing import TYPE_CHECKING

from physics import heading

from . import thickness
from .entry import BOXES, MOST
from .tip import LIMIT, STEEPEST, Tip

if TYPE_CHECKING:
    from game.session.session import Game

WEAKEST, STRONGEST = 0.05, 8.0
"""Ends of what can be set by hand, m/s: a ball that hardly moves, and a hard break."""
CENTRE = Tip(0.0, 0.0)
"""In the middle, with a level cue; also where a tip point begins that is not known yet."""
BEND = 1.6
"""Power of the power bar: half of it is for speeds below 2.6 m/s, where touch matters."""


def share(speed: float) -> float:
    """How much of the power bar a speed fills: 1 at STRONGEST."""
    return float((speed / STRONGEST) ** (1.0 / BEND))


def speed_at(part: float) -> float:
    """The speed at a part of the power bar, m/s."""
    return max(WEAKEST, STRONGEST * float(min(max(part, 0.0), 1.0) ** BEND))


def ready(game: Game) -> bool:
    """Turn to the next shot; False while balls move."""
    if game.moving:
        return False
    game.show_aim()
    game.aim.leave()
    return True


def written(game: Game) -> None:
    """The boxes have been written: the entry is complete if it can be read."""
    game.aim.leave()
    if not game.aim.faults:
        game.aim.finish()


def put(game: Game, value: str) -> None:
    """Write numbers into boxes by their names ("side 1.5 follow 0.5")."""
    words = value.split()
    if ready(game):
        game.aim.put(**{n: float(v) for n, v in zip(words[::2], words[1::2], strict=True)})
        written(game)


def turn(game: Game, value: str) -> None:
    """Turn the aim by some degrees, anticlockwise."""
    if ready(game):
        angle = (game.aim.angle or 0.0) + float(value)
        game.aim.put(4, angle=angle if abs(angle) <= MOST["angle"] else angle % 360.0)
        written(game)


def power(game: Game, value: str) -> None:
    """Set the ball's speed, m/s; the tip stays where it is, so the spins follow the speed."""
    if ready(game):
        game.aim.speed(min(max(float(value), WEAKEST), STRONGEST))
        written(game)


def push(game: Game, value: str) -> None:
    """Change the speed by so much, m/s."""
    power(game, str((game.aim.number("speed") or 0.0) + float(value)))


def tip(game: Game, value: str) -> None:
    """Set the tip point (right and up, radii); beyond the ring it is held there, and said so."""
    if ready(game):
        right, up = map(float, value.split())
        _strike_at(game, Tip(right, up, _elevation(game)))


def nudge(game: Game, value: str) -> None:
    """Move the tip point by so much."""
    now = game.aim.tip or CENTRE
    if ready(game):
        right, up = map(float, value.split())
        _strike_at(game, Tip(now.right + right, now.up + up, _elevation(game)))


def centre(game: Game) -> None:
    """Strike in the middle with a level cue."""
    if ready(game):
        _strike_at(game, CENTRE)


def tilt(game: Game, value: str) -> None:
    """Raise the butt of the cue by so many degrees."""
    elevate(game, str(_elevation(game) + float(value)))


def elevate(game: Game, value: str) -> None:
    """Set the cue's elevation, degrees; the tip meets the same spot as seen along the cue."""
    now = game.aim.tip or CENTRE
    if ready(game):
        _strike_at(game, Tip(now.right, now.up, min(max(float(value), 0.0), STEEPEST)))


def _elevation(game: Game) -> float:
    return (game.aim.tip or CENTRE).elevation or 0.0


def _strike_at(game: Game, wanted: Tip) -> None:
    if not game.aim.hold(wanted.within()):
        game.warn("power")
    elif wanted.away > LIMIT:
        game.warn("miscue", error=False)
    written(game)


def thick(game: Game, eighths: int) -> None:
    """Aim past the first ball by an exact number of eighths: 0 is full, + passes on its right."""
    _past(game, lambda now: eighths)


def thicker(game: Game, way: int) -> None:
    """Aim at the next exact eighth to the left (1) or to the right (-1)."""
    _past(game, lambda now: thickness.neighbour(now, -way))


def _past(game: Game, wanted: Callable[[float], int]) -> None:
    seen, shot = game.preview, game.aim.shot
    if game.moving or shot is None:
        return
    if seen is None or seen.contact is None:
        game.warn("thickness.none")
        return
    eighths = wanted(thickness.aside(seen.contact))
    angle = thickness.angle(game.world, game.cue, shot, seen, eighths)
    if angle is None:
        game.warn("thickness.blocked")
    elif ready(game):
        game.aim.put(4, angle=degrees(angle))
        written(game)


def take_over(game: Game) -> None:
    """Write into the boxes what a scene has already given to the cue ball."""
    ball = game.world.ball(game.cue)
    v = complex(*ball.velocity)
    if v:
        wx, wy, wz = (w * ball.radius for w in ball.spin)
        spin = complex(wx, wy) * abs(v) / v
        numbers = (abs(v), spin.imag, spin.real, wz, heading(v))
        game.aim.put(3, **dict(zip(BOXES, numbers, strict=True)))
    game.aim.spent()
    game.shown_shot = True
    game.began = game.world.time


def erase(game: Game) -> None:
    """Delete the character before the caret, or what is selected."""
    game.aim.erase()


def delete(game: Game) -> None:
    """Delete the character after the caret, or what is selected."""
    game.aim.delete()


def caret(game: Game, to: str | int) -> None:
    """Move the caret in the box being edited, as `TextField.go` does."""
    game.aim.go(to)


HANDLERS: dict[str, Callable[..., None]] = {
    "set": put, "turn": turn, "power": power, "push": push, "tip": tip, "nudge": nudge,
    "centre": centre, "tilt": tilt, "elevate": elevate, "thick": thick, "thicker": thicker,
    "erase": erase, "delete": delete, "caret": caret,
}  # fmt: skip
