"""Is there room for one obstacle more: do the lines leave a table, and is no pocket in another?"""

from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import pairwise

from .kernel.motion import length
from .post import Pocket
from .wall import Obstacle, Wall

OUT = 1e3  # times as far as any line: there a table that does not close ends
REACHED = 1e-12  # of that: a line that is no farther away from the table bounds it
ALONG = 1e-9  # how far the normals of two lines that are parallel may differ
MIDDLE = 0.0, 0.0  # a line faces the same way everywhere


def check_room(thing: Obstacle, others: Sequence[Obstacle]) -> None:
    """ValueError, saying why, if the obstacle cannot stand among the others."""
    if isinstance(thing, Wall):
        _check_lines([other for other in others if isinstance(other, Wall)], thing)
    elif isinstance(thing, Pocket):
        for other in others:
            if isinstance(other, Pocket) and _overlap(thing, other):
                raise ValueError(f"the pockets {called(thing)} and {called(other)} overlap")


def inside(lines: Iterable[Wall], far: float, out: float = 0.0) -> list[complex]:
    """The corners of what lies inside all these lines, each moved out by so many metres, within a
    square of half the side `far`, m."""
    corners = [complex(x, y) * far for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    for line in lines:
        corners = cut(corners, [line.distance((p.real, p.imag)) + out for p in corners])
    return corners


def cut(corners: list[complex], ahead: list[float]) -> list[complex]:
    """The part of a convex polygon in front of a line; ahead: how far each corner is, m."""
    left: list[complex] = []
    placed = [*zip(corners, ahead, strict=True)]
    for (p, a), (q, b) in pairwise([*placed, *placed[:1]]):
        if a >= 0.0:
            left.append(p)
        if a * b < 0.0:
            left.append(p + a / (a - b) * (q - p))
    return left


def _check_lines(lines: list[Wall], new: Wall) -> None:
    """A line has no end, so a table of lines has no corner that points inward: one that is meant
    to have one would lose some of its walls. A side may be moved in."""
    left, met, lost = _lost(tuple(line.numbers for line in (*lines, new)))
    if not left:
        raise ValueError(f"no place is inside all lines with {called(new)}")
    if not met:
        raise ValueError(f"no ball can meet {called(new)}: other lines are in front of it")
    if lost and not (len(lost) == 1 and _moves_in(new, lines[lost[0]])):
        raise ValueError(
            f"lines have no ends: behind {called(new)} no ball can meet"
            f" {' and '.join(called(lines[k]) for k in lost)}; use Wall.segment for walls that end"
        )


def _moves_in(new: Wall, old: Wall) -> bool:
    """Is it the same side of the table, nearer?"""
    return bool(length(new.facing(MIDDLE) - old.facing(MIDDLE)) < ALONG)


@lru_cache(maxsize=256)
def _lost(bare: tuple[tuple[complex, float], ...]) -> tuple[bool, bool, tuple[int, ...]]:
    """Is anything of the table left with the last of the lines, can a ball meet that one, and which
    of the others can none meet any more behind it?  Kept, since the same tables are made again and
    again."""
    *lines, new = (Wall(*line) for line in bare)
    far = OUT * max(1.0, *(abs(line.distance(MIDDLE)) for line in (*lines, new)))
    before, after = inside(lines, far), inside([*lines, new], far)
    if not after:
        return False, False, ()
    numbered = enumerate(lines)
    lost = tuple(
        k for k, line in numbered if _bounds(line, before, far) and not _bounds(line, after, far)
    )
    return True, _bounds(new, after, far), lost


def _bounds(line: Wall, corners: list[complex], far: float) -> bool:
    """Is one of the corners on the line?"""
    return min(line.distance((p.real, p.imag)) for p in corners) <= REACHED * far


def _overlap(a: Pocket, b: Pocket) -> bool:
    return float(length(a.shape.centre - b.shape.centre)) < a.radius + b.radius


def called(thing: Obstacle) -> str:
    """What a message says of it: its name, or what it is."""
    return repr(thing.name) if thing.name else repr(thing)
