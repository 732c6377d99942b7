"""The outcome of every scene, to the last bit: `--write` renews tests/golden.json.

Equal bits are promised on one kind of machine. Elsewhere the mathematical library may round
otherwise, and each ball hit multiplies that some tenfold: there positions must agree to a
tolerance, the events of each scene in number.
"""

import argparse
import json
import platform
import sys
from hashlib import sha256
from pathlib import Path
from typing import Any

from physics import Shot, World, scenes

FILE = Path(__file__).parent.parent / "tests" / "golden.json"
STRUCK = {"carom": ("white", Shot(3.0, 10.0, follow=0.5, side=1.5))}  # waits for a shot
UNTIL = 10.0  # s: on a cloth without friction nothing comes to rest
NEAR = 1e-6  # m: twelve hits of 1e-16 m, each ten times worse
NEAR_BREAK = 1e-3  # m: of fifteen balls, which hit each other fifty times


def play(name: str) -> World:
    """A scene at its end."""
    world = scenes.SCENES[name]()
    if name in STRUCK:
        world.strike(*STRUCK[name])
    world.run(UNTIL if world.cloth.roll == 0.0 else float("inf"))
    return world


def outcome(name: str) -> dict[str, Any]:
    """Events, positions as exact hexadecimal floats, and a hash of them."""
    world = play(name)
    places = [[x.hex() for x in ball.position] for ball in world.balls]
    digest = sha256(json.dumps(places).encode()).hexdigest()[:16]
    return {"events": len(world.log), "hash": digest, "positions": places}


def machine() -> str:
    """What may change the last bit: processor and C library."""
    return f"{platform.machine()} {platform.system()} {' '.join(platform.libc_ver())}".strip()


def difference(name: str, golden: dict[str, Any]) -> float:
    """How far, m, any ball of a scene ends from its golden place; inf if events differ."""
    now, then = outcome(name), golden["scenes"][name]
    if now["hash"] == then["hash"]:
        return 0.0
    if now["events"] != then["events"] or len(now["positions"]) != len(then["positions"]):
        return float("inf")
    pairs = zip(now["positions"], then["positions"], strict=True)
    return max(
        abs(complex(*map(float.fromhex, p)) - complex(*map(float.fromhex, q))) for p, q in pairs
    )


def tolerance(name: str, golden: dict[str, Any]) -> float:
    """Nothing on the machine that wrote the file; elsewhere what the hits leave."""
    if machine() == golden["machine"]:
        return 0.0
    return NEAR_BREAK if name == "rack15" else NEAR


def read() -> dict[str, Any]:
    golden: dict[str, Any] = json.loads(FILE.read_text(encoding="utf-8"))
    return golden


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks golden", description=__doc__)
    parser.add_argument("--write", action="store_true", help="take what comes out now as golden")
    if parser.parse_args(arguments).write:
        golden = {
            "machine": machine(),
            "python": platform.python_version(),
            "scenes": {name: outcome(name) for name in scenes.SCENES},
        }
        FILE.write_text(json.dumps(golden, indent=1) + "\n", encoding="utf-8")
        return 0
    golden, worst = read(), 0
    for name in scenes.SCENES:
        off, allowed = difference(name, golden), tolerance(name, golden)
        worst += off > allowed
        print(f"{name:16} {off:.1e} m of {allowed:.0e}")
    if worst:
        print(
            "not as golden; if that is meant: python -m benchmarks golden --write", file=sys.stderr
        )
    return 1 if worst else 0
