"""A table from its tracks, from the command line: a report, and a file with what was found."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from physics import tables
from physics.ball import Ball
from physics.checks import finite
from physics.tables import table_file
from physics.world import World

from . import tracks as files
from .fit import Fit, StrokeFound, fit
from .model import set_coefficients
from .parameters import coefficients

if TYPE_CHECKING:
    from .tracks import Track

UNKNOWN = "cloth.slide,cloth.roll,cushion.e,cushion.mu"
MM = 1e3


def add_options(one: argparse.ArgumentParser, known: Mapping[str, tables.Table]) -> None:
    """What the command `fit` takes."""
    one.add_argument("tracks", metavar="FILE", help="lines of track, time, white x, white y, ...")
    one.add_argument("--table", choices=known, default="match", help="size, balls, laws (match)")
    one.add_argument("--unknown", default=UNKNOWN, metavar="NAMES", help=f"to be found ({UNKNOWN})")
    one.add_argument("--share", metavar="NAMES", help="those that are the same in all tracks (all)")
    one.add_argument("--set", default="", metavar="NAME=VALUE,...", help="what to begin with")
    one.add_argument("--struck", metavar="BALL", help="which ball (that which moves first)")
    one.add_argument("--noise", type=float, default=0.5, help="of a coordinate, mm (0.5)")
    one.add_argument("--hold", type=int, default=0, metavar="N", help="test on the last N tracks")
    one.add_argument("--preset", metavar="FILE", help="write the table that was found")
    one.add_argument("--name", default="my table", help="of that table (my table)")
    one.add_argument("--png", metavar="FILE", help="write what is left over (needs matplotlib)")


def run(options: argparse.Namespace, table: tables.Table) -> Iterator[str]:
    """Fit and write what is wanted; the lines of the report."""
    world, seen = _read(options, table)
    if not 0 <= options.hold < max(len(seen), 1):
        raise ValueError(f"--hold {options.hold}: there are {len(seen)} tracks")
    kept = len(seen) - options.hold
    share = None if options.share is None else _names(options.share)
    found = fit(world, seen[:kept], _names(options.unknown), share)
    yield from report(found, world, seen[:kept])
    if options.hold:
        tested = fit(found.world, seen[kept:], ())
        yield f"held out, with these values: misfit {MM * tested.misfit:.2f} mm"
        yield from map(_stroke, tested.strokes)
    if options.preset:
        table_file.save(replace(found.table, name=options.name), options.preset)
        yield f"written to {options.preset}: tables.load reads it"
    if options.png:
        from .residuals import draw

        draw(found, seen[:kept], options.png)


def _names(text: str) -> list[str]:
    return [name.strip() for name in text.split(",") if name.strip()]


def _read(options: argparse.Namespace, table: tables.Table) -> tuple[World, list[Track]]:
    """The table with the balls of the file, and its tracks."""
    world = table.world()
    for k, name in enumerate(files.balls(options.tracks)):
        place = (-0.4 * table.length + 2.5 * k * table.radius, 0.0)
        world.add(Ball(name, place, radius=table.radius, mass=table.mass))
    set_coefficients(world, _set(options.set, world))
    seen = files.read(options.tracks, world, options.noise / MM)
    return world, [replace(track, ball=options.struck) for track in seen]


def _set(text: str, world: World) -> dict[str, float]:
    """Coefficients by name; ball.mu=… also where friction followed a fit of its own."""
    found = {}
    for item in filter(None, text.split(",")):
        name, equals, number = (part.strip() for part in item.partition("="))
        if not equals or name not in (*coefficients(world), "ball.mu"):
            raise ValueError(f"--set {item!r}: NAME=VALUE, with {', '.join(coefficients(world))}")
        try:
            found[name] = finite(f"--set {name}", float(number))
        except ValueError:
            raise ValueError(f"--set {item!r}: {number!r} is no number") from None
    return found


def report(found: Fit, before: World, seen: Sequence[Track]) -> Iterator[str]:
    """Lines: what was found, how well, and how each stroke was struck."""
    sights = len([1 for track in seen for x in track.positions[..., 0].flat if x == x])
    yield f"{len(seen)} tracks, {sights} sights; misfit {MM * found.misfit:.2f} mm"
    yield f"{'':18} {'before':>9} {'found':>9}  ±"
    given = {"cloth": before.cloth, "cushion": before.cushion_law, "ball": before.ball_law}
    for name, value, error in zip(found.names, found.values, found.errors, strict=True):
        part, _, key = name.partition(".")
        yield f"{name:18} {getattr(given[part], key):9.5g} {value:9.5g}  {error:.2g}"
    yield from map(_stroke, found.strokes)


def _stroke(stroke: StrokeFound) -> str:
    shot = stroke.shot
    struck = f"{shot.speed:.3f} m/s at {shot.angle % 360.0:.2f}°, follow {shot.follow:.2f}"
    left = "" if stroke.share > 0.99 else f", followed for {100.0 * stroke.share:.0f} % of it"
    return (
        f"{stroke.name}: {stroke.ball} {struck}, side {shot.side:.2f} m/s;"
        f" misfit {MM * stroke.misfit:.2f} mm{left}"
    )
