"""How the balls have turned at any moment of a shot, so that it can be shown back and forth."""

from __future__ import annotations

from game.render.table.balls import BallSprites
from game.render.table.rotation import Quaternion, rotated
from game.session.session import Session

STEP = 1 / 60
"""Seconds between the moments that are kept; from there it is a single turn."""


class Orientations:
    """The orientations since a shot began, worked out from its log as far as they are asked for."""

    def __init__(self, sprites: BallSprites) -> None:
        self._sprites = sprites
        self._shot: object = None
        self._kept: list[list[Quaternion]] = []

    def on(self, sprites: BallSprites) -> Orientations:
        """The same turns for sprites of another size."""
        self._sprites = sprites
        return self

    def begin(self, session: Session) -> bool:
        """Take the balls as they lie for the beginning of a new shot; returns whether it is one."""
        shot = session.began, session.shots
        if shot == self._shot:
            return False
        self._shot = shot
        count = len(self._sprites.looks)
        self._kept = [[self._sprites.orientation(i) for i in range(count)]]
        return True

    def show(self, session: Session, time: float) -> None:
        """Turn the balls as they were `time` seconds after the shot began."""
        index, names = max(0, int(time / STEP)), [ball.name for ball in session.world.balls]
        while len(self._kept) <= index:
            step = len(self._kept) - 1
            self._kept.append(self._after(session, names, step, STEP))
        rest = time - index * STEP
        for i, turn in enumerate(self._after(session, names, index, rest)):
            self._sprites.orient(i, turn)

    def _after(self, session: Session, names: list[str], step: int, dt: float) -> list[Quaternion]:
        """The orientations `dt` seconds after a kept moment."""
        middle = session.world.log.at(session.began + step * STEP + dt / 2)
        return [
            rotated(turn, middle[name].spin, dt)
            for name, turn in zip(names, self._kept[step], strict=True)
        ]
