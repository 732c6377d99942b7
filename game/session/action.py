"""Actions: what the player means, as small values that can be logged, written down and replayed."""

from __future__ import annotations

from typing import NamedTuple


class Action(NamedTuple):
    """One thing the player wants; `value` is its argument, if it has one.

    edit BOX · clear · type TEXT · erase · delete · caret WHERE · enter · leave · shoot · fire ·
    place · stop · retry ·
    pause · frame · back · event WAY · scrub TICKS · home · skip · faster STEPS · undo · redo ·
    turn DEGREES · power SPEED · push SPEED · tip "RIGHT UP" · nudge "RIGHT UP" · centre ·
    elevate DEGREES · tilt DEGREES · thick EIGHTHS · thicker WAY · set "BOX NUMBER ..." ·
    fan · help · settings · quit ·
    engine KEY · law KEY · cloth KEY · table KEY · language KEY (no key: the next one)
    """

    name: str
    value: str | int | None = None
