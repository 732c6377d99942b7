"""What a ball can meet on a table, as plain points, and the object of a world that it becomes."""

from collections.abc import Callable
from typing import NamedTuple

from physics.post import Pocket, Post
from physics.wall import Obstacle, Wall


class Piece(NamedTuple):
    """Something fixed; points are complex numbers, m, and the middle of the table is 0.

    kind: "line", "segment", "arc", "post" or "pocket".
    points: of a line, one of it and the normal towards the table; of a segment its ends, the table
        on the left; of what is round the centre.
    radius: of what is round, m.
    name: that a world knows it by.
    part: "rail", "facing", "nose", "hole" or "back".
    start, end: of an arc, degrees.
    """

    kind: str
    points: tuple[complex, ...]
    radius: float
    name: str
    part: str
    start: float = 0.0
    end: float = 0.0


def four_lines(length: float, width: float) -> tuple[Piece, ...]:
    """The cushions of a table without pockets."""
    x, y = 0.5 * length, 0.5 * width
    lines = (
        (complex(-x, 0.0), complex(1.0, 0.0), "west"),
        (complex(x, 0.0), complex(-1.0, 0.0), "east"),
        (complex(0.0, -y), complex(0.0, 1.0), "south"),
        (complex(0.0, y), complex(0.0, -1.0), "north"),
    )
    return tuple(Piece("line", (p, n), 0.0, name, "rail") for p, n, name in lines)


def _line(piece: Piece) -> Wall:
    point, normal = piece.points
    return Wall(normal, (normal.conjugate() * point).real, piece.name)


def _segment(piece: Piece) -> Obstacle:
    p, q = piece.points
    return Wall.segment((p.real, p.imag), (q.real, q.imag), piece.name)


def _arc(piece: Piece) -> Obstacle:
    (at,) = piece.points
    return Wall.arc((at.real, at.imag), piece.radius, piece.start, piece.end, piece.name)


def _post(piece: Piece) -> Post:
    (at,) = piece.points
    return Post((at.real, at.imag), piece.radius, piece.name)


def _pocket(piece: Piece) -> Pocket:
    (at,) = piece.points
    return Pocket((at.real, at.imag), piece.radius, piece.name)


SOLIDS: dict[str, Callable[[Piece], Obstacle]] = {
    "line": _line, "segment": _segment, "arc": _arc, "post": _post, "pocket": _pocket,
}  # fmt: skip
"""What makes one of each kind: another kind is one more line."""


def solid(piece: Piece) -> Obstacle:
    """The object that a world takes; ValueError, naming it, for a kind that worlds do not know."""
    if piece.kind not in SOLIDS:
        raise ValueError(f"a world cannot have the {piece.part} {piece.name!r}")
    return SOLIDS[piece.kind](piece)
