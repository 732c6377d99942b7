"""Where the cue is: drawn back as far as the shot is hard, and through the ball after the stroke.

The balls wait for nothing: the stroke is shown from the contact on, while they already run.
"""

from __future__ import annotations

from math import atan2, hypot, radians
from typing import NamedTuple

from game.aim.tip import tip_of
from game.session.session import Session

from . import marks
from .drag_aim import pull

THROUGH = 0.07
"""Seconds for which the cue goes on after the contact."""
FOLLOW = 0.022
"""Metres that it goes on for each m/s of the ball."""
FARTHEST = 0.12
FADE = 0.25
"""Seconds in which it is put away then."""


class Pose(NamedTuple):
    """How the cue is held, as `cue_stick.draw` takes it.

    ball: that it points at, m.
    angle: radians.
    back: how far it is drawn back, m.
    alpha: of its picture.
    radius: of the ball, m.
    elevation: degrees.
    """

    ball: tuple[float, float]
    angle: float
    back: float
    alpha: float
    radius: float
    elevation: float = 0.0


def pose(session: Session, still: bool) -> Pose | None:
    """The cue as it is to be drawn, None while it is put away; `still` shows no stroke."""
    if marks.aiming(session):
        shot = None if session.arranging else session.aim.shot
        if shot is None:
            return None
        ball = session.world.ball(session.cue)
        steep = tip_of(shot).elevation or 0.0
        back = pull(session.aim.power or shot.speed, session.aim.strongest)
        along = radians(shot.angle - session.aim.squirt)
        return Pose(ball.position, along, back, 1.0, ball.radius, steep)
    if not (session.shown_shot and session.shots) or still:
        return None
    return _stroke(session, session.timeline.moment - session.began)


def _stroke(session: Session, time: float) -> Pose | None:
    if not 0.0 <= time < THROUGH + FADE:
        return None
    struck = session.world.log.at(session.began)[session.shooter]
    speed = hypot(*struck.velocity)
    if not speed:
        return None
    left = max(0.0, 1.0 - time / THROUGH)
    ahead = min(FOLLOW * speed, FARTHEST) * (1.0 - left**3)
    alpha = 1.0 - max(0.0, time - THROUGH) / FADE
    angle = atan2(struck.velocity[1], struck.velocity[0]) - radians(session.aim.squirt)
    radius = session.world.ball(session.shooter).radius
    return Pose(struck.position, angle, -ahead, round(alpha, 2), radius, session.aim.raised)
