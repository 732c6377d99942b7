"""Drills for tables with pockets: a pot to learn by, and the stroke that makes it.

Places are in diamonds, as in `positions`; so a drill is on a table of any size.
"""

from __future__ import annotations

from .positions import Answer, Place, Position

POOL, SNOOKER, PYRAMID = "pool", "snooker", "pyramid"
COLOURS = (
    "yellow 1.652 1.343, green 1.652 2.657, brown 1.652 2, blue 4 2, pink 6 2, black 7.274 2"
)
"""Snooker's colours on their spots."""


def places(said: str) -> dict[str, Place]:
    """Balls and their places, written "cue 5 1, red1 6.2 2.2"."""
    words = [ball.split() for ball in said.split(",")]
    return {name: (float(x), float(y)) for name, x, y in words}


def _on(game: str, key: str, way: str, answer: Answer, *balls: str) -> Position:
    """`way`: what is hit first, and "ball>pocket" for what drops."""
    first, _, drop = way.partition(" ")
    ball, _, pocket = drop.partition(">")
    met = (first, ball, f"{pocket} pocket")
    return Position(key, game, places(", ".join(balls)), met, answer, "cue")


# fmt: off
DRILLS: tuple[Position, ...] = (
    _on(POOL, "stop", "1 1>north-east", (45, 1.8, 0, -0.25),
        "cue 5 1, 1 6.2 2.2"),
    _on(POOL, "stop_long", "1 1>south-east", (-16.19, 2.6, 0, -0.42),
        "cue 2 2, 1 5.4 1"),
    _on(POOL, "draw", "1 1>north-east", (45, 2.2, 0, -0.45),
        "cue 5.4 1.4, 1 6.4 2.4"),
    _on(POOL, "follow", "1 1>north-east", (44.76, 1.6, 0, 0.4),
        "cue 5.2 1.2, 1 6.2 2.2"),
    _on(POOL, "cut_30", "1 1>north-east", (14.42, 1.6, 0, 0),
        "cue 4.4 2, 1 6.4 2.6"),
    _on(POOL, "cut_45", "1 1>north-east", (-6.71, 1.8, 0, 0),
        "cue 4.6 2.9, 1 6.6 2.8"),
    _on(POOL, "cut_60", "1 1>north-east", (-17.2, 2, 0, 0),
        "cue 5.2 3.1, 1 6.7 2.8"),
    _on(POOL, "rail", "1 1>north-east", (34.87, 2, 0.2, 0),
        "cue 4 2.4, 1 6.2 3.82"),
    _on(POOL, "side_pocket", "1 1>north", (67.9, 1.4, 0, -0.2),
        "cue 3.2 1, 1 3.8 2.6"),
    _on(POOL, "side_cut", "1 1>north", (29.34, 1.4, 0, 0),
        "cue 2.6 2.2, 1 3.6 2.9"),
    _on(POOL, "combination", "1 9>north-east", (43.65, 2.2, 0, 0),
        "cue 5.2 1.3, 1 6.5 2.55, 9 6.9 2.95"),
    _on(POOL, "bank", "1 1>north", (-52.34, 2.2, 0, 0),
        "cue 2.6 2.6, 1 3.4 1.4"),
    _on(POOL, "position", "1 1>north-east", (32.99, 1.9, 0, 0.2),
        "cue 4.4 1.2, 1 6.2 2.4, 2 6.6 0.5, 3 1.4 3.4"),
    _on(POOL, "side_spin", "1 1>north-east", (25, 2.2, -0.35, 0.1),
        "cue 5 2, 1 6.8 2.9, 2 1 0.6"),
    _on(SNOOKER, "black", "black black>north-east", (31.95, 1.8, 0, -0.1),
        "cue 6.3 1.3, black 7.274 2"),
    _on(SNOOKER, "blue", "blue blue>north", (55.47, 1.8, 0, -0.2),
        "cue 3.4 1, blue 4 2"),
    _on(SNOOKER, "pink", "pink pink>north-east", (37.8, 2.2, 0, -0.3),
        "cue 5 1.2, pink 6 2"),
    _on(SNOOKER, "long_pot", "red1 red1>north-east", (20.2, 2.8, 0, 0),
        "cue 1.5 1.3, red1 5.8 2.9"),
    _on(SNOOKER, "stun", "black black>south-east", (-12.52, 2, 0, -0.15),
        "cue 6.4 2.3, black 7.274 2, red1 6.4 3.2"),
    _on(SNOOKER, "screw", "red1 red1>north-east", (41.78, 2.2, 0, -0.45),
        "cue 5.9 2.2, red1 6.8 3, black 7.274 2"),
    _on(SNOOKER, "follow", "red1 red1>north-east", (42.11, 1.7, 0, 0.4),
        "cue 5.7 2, red1 6.7 2.9, black 7.274 2"),
    _on(SNOOKER, "red_black", "red1 red1>north-east", (51.33, 1.8, 0, 0),
        "cue 5.6 1.5, red1 6.5 2.6, black 7.274 2, red2 6.9 1.2"),
    _on(SNOOKER, "cushion_red", "red1 red1>north-east", (39.13, 1.6, 0, 0),
        "cue 5.6 2.8, red1 7 3.86"),
    _on(SNOOKER, "plant", "red1 red2>north-east", (43.44, 2, 0, 0),
        "cue 5.6 1.8, red1 6.6 2.76, red2 6.75 2.9"),
    _on(SNOOKER, "middle", "red1 red1>north", (52.87, 1.6, 0, 0),
        "cue 3 1.6, red1 3.9 2.9"),
    _on(SNOOKER, "colours", "yellow yellow>south-west", (-142.63, 1.6, 0, -0.1),
        "cue 2.7 2.15", COLOURS),
    _on(SNOOKER, "line_up", "red1 red1>north-east", (50.7, 1.8, 0, 0),
        "cue 4.3 1.2, red1 5 2, red2 4.6 2, red3 5.4 2, red4 6.4 2, red5 6.8 2", COLOURS),
    _on(PYRAMID, "straight", "1 1>north-east", (44.92, 1.6, 0, 0),
        "cue 6.6 2.6, 1 7.4 3.4"),
    _on(PYRAMID, "side_pocket", "1 1>north", (89.88, 2, 0, 0),
        "cue 4 1.6, 1 4 2.9"),
    _on(PYRAMID, "side_cut", "1 1>north", (62.4, 1.8, 0, 0),
        "cue 3.5 2.2, 1 3.95 3.2"),
    _on(PYRAMID, "cut", "1 1>north-east", (20.05, 1.8, 0, 0),
        "cue 6.4 2.9, 1 7.3 3.3"),
    _on(PYRAMID, "stop", "1 1>north-east", (45, 2.4, 0, -0.25),
        "cue 6.5 2.5, 1 7.2 3.2"),
    _on(PYRAMID, "follow", "1 1>north-east", (44.92, 1.6, 0, 0.4),
        "cue 6.6 2.6, 1 7.3 3.3"),
    _on(PYRAMID, "own_side", "1 cue>north", (70.12, 2, 0, 0.2),
        "cue 3.4 1.8, 1 4.12 3.72"),
    _on(PYRAMID, "own_thin", "1 cue>north-east", (48.07, 1.8, 0, 0),
        "cue 6.8 2.9, 1 7.5 3.7"),
    _on(PYRAMID, "hanger", "1 1>north-east", (29.64, 2.4, 0, 0),
        "cue 3 1, 1 7.75 3.75"),
    _on(PYRAMID, "combination", "1 2>north-east", (43.72, 2.4, 0, 0),
        "cue 6 2.1, 1 6.9 2.95, 2 7.15 3.18"),
    _on(PYRAMID, "rail", "1 1>north-east", (37.84, 1.8, 0, 0),
        "cue 6 2.9, 1 7.2 3.75"),
    _on(PYRAMID, "hanger_side", "1 1>north", (39.68, 2, 0, 0),
        "cue 2 2, 1 4.03 3.86"),
)
# fmt: on
"""`way` of a drill: the ball that is hit first, the one that drops, and the pocket. The answers
were found on the 9 ft pool table, the snooker table and the pyramid's; the tests play them."""
