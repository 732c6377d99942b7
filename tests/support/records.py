"""What tests of records share: a record with every way in which a shot can end, and replays."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from game import __main__ as entry
from game.options import Options
from tests.support.players import TWO_SHOTS

Lines = list[dict[str, Any]]
OPTIONS = replace(Options(), size=(640, 360), frames=10**6)
SHOTS = f"""{TWO_SHOTS}
12.0 key l
12.1 key ctrl+return
13.0 key p
13.5 key p
14.0 key f1
14.3 key f1
15.3 key space
15.4 key down
15.5 key ctrl+return
15.9 key r
16.0 key e
16.1 key ctrl+return
16.4 key end
16.7 key ctrl+return
17.2 quit
"""


def recorded(folder: Path) -> Path:
    """A record of shots that come to rest, are cut off by the next, stopped, undone and skipped."""
    script, path = folder / "script.txt", folder / "game.rec"
    script.write_text(SHOTS, encoding="utf-8")
    said = ["--script", str(script), "--record", str(path), "--seed", "7"]
    assert entry.main([*said, "--size", "640x360", "--frames", "100000"]) == 0
    return path


def lines(path: Path) -> Lines:
    """What the lines of a record say."""
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def rewritten(path: Path, folder: Path, change: Callable[[Lines], object]) -> Path:
    """A copy of a record in which `change` has been made to its lines."""
    found = lines(path)
    change(found)
    copy = folder / "changed.rec"
    copy.write_text("".join(json.dumps(line) + "\n" for line in found), encoding="utf-8")
    return copy


def replayed(path: Path) -> int:
    """The exit code of a replay without a window."""
    return entry.main(["--replay", str(path), "--headless"])


def shown(path: Path, *more: str) -> int:
    """The exit code of a replay in a window."""
    return entry.main(["--replay", str(path), "--size", "640x360", "--frames", "100000", *more])
