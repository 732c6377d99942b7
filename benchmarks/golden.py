"""The outcome of every scene and of 150 shots, to the last bit: `--write` renews tests/golden.json.

Every machine gives the same bits (docs/accuracy.md, "The same digits everywhere"), unless its
Python was built to fuse the product and the sum in a complex product: there positions must agree to
a tolerance, the events of each scene in number.
"""

import argparse
import json
import sys
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from random import Random
from struct import pack
from typing import Any

from physics import Ball, CueStroke, Shot, World, heading, laws, scenes, simulate, tables

FILE = Path(__file__).parent.parent / "tests" / "golden.json"
STRUCK = {"carom": ("white", Shot(3.0, 10.0, follow=0.5, side=1.5))}  # waits for a shot
UNTIL = 10.0  # s: on a cloth without friction nothing comes to rest
OF_EACH = 30  # shots of each of the five kinds
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
    places = [[(x + 0.0).hex() for x in ball.position] for ball in world.balls]  # one zero, not two
    digest = sha256(json.dumps(places).encode()).hexdigest()[:16]
    return {"events": len(world.log), "hash": digest, "positions": places}


def shots() -> Iterator[tuple[World, Shot]]:
    """150 shots at the first ball of a world: drawn, but by no function of a C library."""
    draw = Random(150).uniform
    carom, steep, rack = scenes.carom(), scenes.carom(), scenes.rack15()
    match = tables.match_carom(edition=1)
    steep.cushion_law = laws.MathavanCushion()
    rack.stop()
    for name, at in (("white", (-0.9, 0.1)), ("yellow", (0.5, 0.3)), ("red", (0.7, -0.4))):
        match.add(Ball(name, at=at, radius=0.03075, mass=0.21))

    def angle(world: World, k: int) -> float:
        """Past one of the other balls, or nearly."""
        x, y = world.balls[0].position
        u, v = world.balls[1 + k % (len(world.balls) - 1)].position
        return heading(complex(u - x, v - y)) + draw(-5.0, 5.0)

    for k in range(OF_EACH):
        spins = draw(-3.0, 3.0), draw(-1.0, 1.0), draw(-3.0, 3.0)
        yield carom, Shot(draw(1.5, 6.0), angle(carom, k), *spins)
        yield steep, Shot(draw(1.5, 6.0), angle(steep, k) + 360.0 * k, *spins)
        tip = {"side": draw(-0.3, 0.3), "height": draw(-0.3, 0.3)}
        stroke = CueStroke(draw(2.0, 7.0), angle(match, k), elevation=draw(0.0, 8.0), **tip)
        yield match, stroke.shot(match.balls[0])
        stroke = CueStroke(draw(2.0, 5.0), angle(match, k), height=0.6, elevation=draw(35.0, 45.0))
        yield match, stroke.jump(match.balls[0])
        yield rack, Shot(draw(4.0, 9.0), draw(-3.0, 3.0))


def digests() -> list[str]:
    """For each shot a hash of where and when the balls rest, and after how many events."""
    found = []
    for world, shot in shots():
        after = simulate(world, world.balls[0], shot)
        places = [x + 0.0 for ball in after.balls for x in ball.position]
        numbers = pack(f"<q{len(places) + 1}d", len(after.log), after.time, *places)
        found.append(sha256(numbers).hexdigest()[:16])
    return found


def fused() -> bool:
    """Was this Python built to fuse the complex product?  clang does so for ARM by default."""
    z = 0.1 + 0.3j
    return (z * z.conjugate()).imag != 0.0


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


def tolerance(name: str) -> float:
    """The distance allowed: none, or where products are fused, what hits make of rounding."""
    if not fused():
        return 0.0
    return NEAR_BREAK if name == "rack15" else NEAR


def read() -> dict[str, Any]:
    golden: dict[str, Any] = json.loads(FILE.read_text(encoding="utf-8"))
    return golden


def write() -> None:
    """Make the present outcome the golden one."""
    golden = {"scenes": {name: outcome(name) for name in scenes.SCENES}, "shots": digests()}
    FILE.write_text(json.dumps(golden, indent=1) + "\n", encoding="utf-8")


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks golden", description=__doc__)
    parser.add_argument("--write", action="store_true", help="take what comes out now as golden")
    if parser.parse_args(arguments).write:
        write()
        return 0
    golden, worst = read(), 0
    for name in scenes.SCENES:
        off, allowed = difference(name, golden), tolerance(name)
        worst += off > allowed
        print(f"{name:16} {off:.1e} m of {allowed:.0e}")
    found = digests()
    other = [k for k, (a, b) in enumerate(zip(found, golden["shots"], strict=True)) if a != b]
    print(f"{len(found) - len(other)} of {len(found)} shots; their hash", end=" ")
    print(sha256("".join(found).encode()).hexdigest()[:16])
    if fused():
        print("this Python fuses complex products: shots need not have the same digits")
    elif other:
        worst += 1
        print(f"other digits: shots {', '.join(map(str, other))}")
    if worst:
        print(
            "not as golden; if that is meant: python -m benchmarks golden --write", file=sys.stderr
        )
    return 1 if worst else 0
