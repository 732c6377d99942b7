"""Event logs written by hand, one contact a beat: the rules are tested on these."""

from dataclasses import dataclass
from math import inf

BEAT = 0.1  # s between contacts, unless a test says otherwise


@dataclass(frozen=True)
class FakeEvent:
    time: float
    kind: str
    balls: tuple[str, ...]
    wall: str | None = None
    away: float = inf


def log(*steps: str) -> list[FakeEvent]:
    """One entry a beat: "A-B" two balls meet, "A|west" a ball and a wall, "A!" leaves the table.

    "=" before a step puts it at the instant of the step before; a bare ball name comes to rest.
    """
    entries: list[FakeEvent] = []
    time = 0.0
    for step in steps:
        time += 0.0 if step.startswith("=") else BEAT
        entries.append(entry(time, step.lstrip("=")))
    return entries


def entry(time: float, step: str, away: float = inf) -> FakeEvent:
    """One entry; `away` is how far, m, the ball had been from the cushion that it meets."""
    if "|" in step:
        ball, wall = step.split("|")
        return FakeEvent(time, "cushion", (ball,), wall, away)
    if step.endswith("!"):
        return FakeEvent(time, "off", (step[:-1],))
    balls = tuple(step.split("-"))
    return FakeEvent(time, "ball" if len(balls) == 2 else "rest", balls)


R1, R2, YELLOW, RED = "white-red1", "red2-white", "white-yellow", "red-white"
WEST, EAST, NORTH, SOUTH = "white|west", "white|east", "white|north", "white|south"
