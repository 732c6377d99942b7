"""Which balls lay in a rack before the last shot: marks of where they were would lie on a heap."""

from __future__ import annotations

from itertools import combinations

from game.session.session import Session

CLOSE = 1e-3
"""Metres between the balls of a rack at most."""
RACK = 6
"""Balls that touch another from which on they are a rack: fewer lie frozen by chance."""


def racked(session: Session) -> frozenset[str]:
    """The names of the balls of a rack; none where no rack was broken."""
    lies = zip(session.world.balls, session.lies, strict=False)
    balls = [(ball, placed.position) for ball, placed in lies if placed.height >= 0.0]
    found: set[str] = set()
    for (a, at), (b, other) in combinations(balls, 2):
        if abs(at - other) < a.touching_distance(b) + CLOSE:
            found |= {a.name, b.name}
    return frozenset(found) if len(found) >= RACK else frozenset()
