"""Records as no one plays them: well-formed ones with things changed in them, by a seed."""

from __future__ import annotations

import json
from collections.abc import Callable
from random import Random
from typing import Any

from game.session.commands import RECORDED

LINE = "danggu1 medium white=0,0 red1=0.1,0.1 shot=5,0,0,0,45"
FOUR = '{"game":"four-ball"}'
THREE = '{"game":"three-cushion","seats":[{"name":"a","level":"novice","target":1}]}'
USUAL: dict[str, tuple[Any, ...]] = {
    "edit": (0, 4), "type": (*"0123456789.-e",), "turn": ("1", "-37.5"), "power": ("8", "0.05"),
    "push": ("0.5", "-0.5"), "tip": ("0.1 0.2", "-1 1"), "nudge": ("0.05 0", "0 -1"),
    "move": ("0.1 0.2", "-9 9"), "elevate": ("20", "100"), "tilt": ("5", "-90"),
    "thick": (-7, 0, 3), "thicker": (-1, 1), "faster": (-1, 1, 5), "event": (-1, 1),
    "scrub": (0, 65536, 1 << 32), "hold": ("white", "red1", "nobody"), "set": ("angle 33 side 1",),
    "intend": ("3 1 0 1 20",), "play": ("3 1 0 1 20", "0 0 0 0 0"), "match": (FOUR, THREE, "{}"),
    "sheet": ("", "menu", "shelf", "rules", "settings"), "line": (LINE,),
    "scene": ("rack15", "cradle", "pi_collisions", "thesis_1"), "table": (None, "match", "thesis"),
    "engine": (None, "thesis", "exact"), "law": (None, "thesis", "mathavan"),
    "cloth": (None, "new"), "language": (None, "ko"),
}  # fmt: skip
"""Good values for every action that takes one."""
ODD: list[Any] = [
    None, True, False, 0, -1, 1, 2, 7, 1.5, float("nan"), float("inf"), 10**9, 10**12, 10**30,
    10**400, "", "x", "0", "1 2", "2 1 1 1 1", "1e308 1e308", "nan", "-1e5", "\0", "\ud800",
    "\u2028", "가", "speed 1", "angle 1e6 speed 999999", "side nan", "white", [], {}, [[[]]], ["a"],
    {"a": 1}, "medium", "menu", "rigid", "ko", "rack15", FOUR, THREE, LINE, "a" * 5000, "9" * 5000,
    '{"game":"four-ball","seats":[{"name":"\\u0000"}]}', 1 << 32, 1 << 20,
]  # fmt: skip
NAMES = [*RECORDED, "quit", "mute", "volume", "colours", "bind", "dance", "", None, 1]
BEGUN = (
    "seed", "scene", "table", "game", "players", "level", "handicap", "finish", "setup", "engine",
    "law", "cloth", "lang", "x",
)  # fmt: skip
KEYS = ("tick", "do", "shot", "digest", "end", "format", "version", "ticks", "with", "setup", "x")
BREAKS = ("\u2028", "\u2029", "\x85", "\r", "\r\n", "\0", "[" * 2000, '"', "\\ud800", "\ufeff")


def forged(seed: int) -> bytes:
    """The record of a seed."""
    rng = Random(seed)
    lines = played(rng)
    for _ in range(rng.randrange(4)):
        changed(rng, lines)
    data = b"".join(map(written, lines))
    return bent(rng, data) if rng.random() < 0.3 else data


def played(rng: Random) -> list[Any]:
    """What the lines of a record say whose actions are good, and mean nothing together."""
    setup: dict[str, Any] = {"seed": rng.randrange(100)}
    if rng.random() < 0.6:
        setup["scene"] = rng.choice(("thesis_1", "rack15", "cradle", "pi_collisions", "carom"))
    elif rng.random() < 0.4:
        setup |= {"game": rng.choice(("four-ball", "three-cushion")), "players": "a,b"}
    if rng.random() < 0.2:
        setup["engine"] = "thesis"
    lines: list[Any] = [
        {"format": "danggu record", "version": 1, "with": "x", "ticks": 65536, "setup": setup}
    ]
    tick = 0
    for _ in range(rng.randrange(1, 25)):
        tick += rng.choice((0, 1, 100, 5000, 65536, 300000))
        name = rng.choice([*RECORDED])
        value = rng.choice(USUAL.get(name, (None,)))
        lines.append({"tick": tick, "do": [name] if value is None else [name, value]})
    return [*lines, {"tick": tick + rng.choice((0, 1000, 10**6)), "end": "0"}]


def changed(rng: Random, lines: list[Any]) -> None:
    """Change something in a record."""
    line = rng.choice(lines)
    if not isinstance(line, dict):
        return
    ways: tuple[Callable[[], object], ...] = (
        lambda: line.update(tick=rng.choice(ODD)),
        lambda: line.update(do=[rng.choice(NAMES), rng.choice(ODD)]),
        lambda: line.update({rng.choice(KEYS): rng.choice(ODD)}),
        lambda: line.pop(rng.choice(KEYS), None),
        lambda: lines.insert(rng.randrange(len(lines)), rng.choice([line, *ODD])),
        lambda: rng.shuffle(lines),
        lambda: line.get("setup", line).update({rng.choice(BEGUN): rng.choice(ODD)}),
    )
    try:
        rng.choice(ways)()
    except AttributeError:
        line.clear()


def written(line: Any) -> bytes:
    """A line as it is in the file."""
    try:
        text = json.dumps(line, ensure_ascii=False)
    except ValueError:  # thousands of digits
        text = "{}"
    return text.encode("utf-8", "backslashreplace") + b"\n"


def bent(rng: Random, data: bytes) -> bytes:
    """Bytes that have been cut, or had others put into them."""
    at = rng.randrange(len(data) + 1)
    more = bytes(rng.randrange(256) for _ in range(5))
    return rng.choice((
        data[:at],
        data.replace(b"\n", b"\r\n"),
        b"\xef\xbb\xbf" + data,
        data[:at] + more + data[at:],
        data[:at] + rng.choice(BREAKS).encode() + data[at:],
        data[:at] + data[at + rng.randrange(9) :],
    ))  # fmt: skip
