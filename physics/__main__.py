"""From the command line: `scene` plays a scene, `sweep` many shots in it, `fit` fits a table."""

import argparse
import csv
import os
import sys
from contextlib import nullcontext
from dataclasses import replace
from functools import partial
from inspect import getdoc
from math import hypot, inf

from . import commandline, laws, scenes, tables
from .batch import sweep
from .engines.exact import EventBudgetError, EventDriven
from .engines.stepping import SCHEMES, TimeStepping
from .files import store
from .log import Event
from .ranges import joined
from .shot import Shot
from .studies import fitting
from .studies.trace import trace
from .world import World

LAWS = {
    "thesis": tables.THESIS, "medium": tables.MEDIUM_CAROM, "match": tables.MATCH_CAROM_2,
    "medium2": tables.MEDIUM_CAROM_2, "match1": tables.MATCH_CAROM, "match2": tables.MATCH_CAROM_2,
}  # fmt: skip
POCKETED = ("pool_9ft", "pool_8ft", "pool_7ft", "snooker_12ft", "pyramid_12ft")
ENDLESS = {"sinai": 20.0, "stadium": 20.0}  # s: scenes in which nothing ever comes to rest
CUSHIONS = ("rigid", "mathavan")  # the game's sets of laws: with balls that rub
STEP, RATE = 1 / 180, 60.0  # s of fixed steps, samples a second, where nothing is said
SHORTEST, FINEST = 1e-6, 1e6  # s, and samples a second: beyond, a shot takes hours or terabytes
WORDS = {"exact": "exact engine", "literal": "the thesis's program", "thesis": "the thesis's step"}


def main(argv: list[str] | None = None) -> int:
    """Exit code 0, or 2 with a message where something cannot be."""
    options = parser().parse_args(joined(sys.argv[1:] if argv is None else argv))
    if options.command != "fit" and (wrong := idle(options)):
        return refuse(wrong)
    try:
        if options.command == "fit":
            return fit(options)
        world = begun(options.name)
        set_laws(world, options.law)
        if options.command == "scene":
            return scene(world, options)
        if options.engine:
            world.engine = chosen(options.engine, STEP if options.dt is None else options.dt)
        said = sweep.sweep(world, options)
        print(said, file=sys.stderr)
        return 0
    except EventBudgetError as error:
        more = ": --until T plays T seconds" if options.command == "scene" else ""
        return refuse(f"{str(error).partition(';')[0]}, and no end{more}")
    except (ValueError, ImportError, OSError, MemoryError) as error:
        return refuse(str(error))
    except KeyboardInterrupt:
        return refuse("stopped")


def begun(name: str) -> World:
    """The scene of that name, or in that file, with its shot just struck."""
    if name in scenes.SCENES:
        return scenes.SCENES[name]()
    if not name.endswith(".json"):
        known = ", ".join(scenes.SCENES)
        raise ValueError(f"no scene {name!r}: there are {known}, and files that end in .json")
    thing = store.load(name)
    if isinstance(thing, Shot):
        raise ValueError(f"{name}: a shot alone, without a world to play it in")
    if isinstance(thing, World):
        return thing
    if thing.ball is not None and thing.shot is not None:
        thing.world.strike(thing.ball, thing.shot)
    return thing.world


def refuse(message: str) -> int:
    print(f"python -m physics: {message}", file=sys.stderr)
    return 2


def idle(options: argparse.Namespace) -> str:
    """What would do nothing, or what no computer can do, in words; "" if there is nothing."""
    engines = {options.engine, getattr(options, "against", None)} - {None, "exact"}
    if options.dt is not None and not engines:
        return f"--dt {options.dt:g}: needs --engine {', '.join(SCHEMES)}"
    if options.dt is not None and 0.0 < options.dt < SHORTEST:
        return f"--dt {options.dt:g}: at least {SHORTEST:g} s"
    if options.command == "scene":
        if options.against and not options.png:
            return f"--against {options.against}: needs --png FILE"
        if options.rate is not None and not options.csv:
            return f"--rate {options.rate:g}: needs --csv FILE"
        if options.rate is not None and FINEST < options.rate < inf:
            return f"--rate {options.rate:g}: at most {FINEST:g}"
    if getattr(options, "contacts", 0) and not options.npz:
        return f"--contacts {options.contacts}: needs --npz FILE"
    files = {"csv": options.csv, **{k: vars(options).get(k) for k in ("png", "npz")}}
    named = [f"--{name} {file}" for name, file in files.items() if file]
    if len(named) > 1 and len({os.path.realpath(file) for file in files.values() if file}) == 1:
        return f"{' and '.join(named)}: one file for both"
    return ""


def parser() -> argparse.ArgumentParser:
    """The options."""
    commands = commandline.Refusing(prog="python -m physics", description="Billiards, exact.")
    sub = commands.add_subparsers(dest="command", required=True, metavar="scene, sweep or fit")
    one = sub.add_parser("scene", help="play a scene and print what happens")
    many = sub.add_parser("sweep", help="play many shots in a scene, each from its beginning")
    fitted = sub.add_parser("fit", help="find coefficients from tracks of real or other strokes")
    fitting.add_options(fitted, [*LAWS, *POCKETED])
    fitted.add_argument("--law", choices=CUSHIONS, help="the cushion's law")
    until = ", ".join(f"{name}: {time:g}" for name, time in ENDLESS.items())
    engines, sets = ["exact", *SCHEMES], [*LAWS, *CUSHIONS]
    for each in (one, many):
        each.add_argument("name", metavar="NAME", help=f"{', '.join(scenes.SCENES)}, or FILE.json")
        each.add_argument("--law", choices=sets, help="cloth and laws of a table; or a cushion")
        each.add_argument("--engine", choices=engines, help="what moves the balls")
        each.add_argument("--dt", type=float, help="s, of fixed steps (1/180)")
    one.add_argument("--against", choices=engines, help="a second engine, dashed in the picture")
    one.add_argument("--until", type=float, help=f"s; all at rest if not given ({until})")
    one.add_argument("--rate", type=float, help="samples a second of --csv (60)")
    one.add_argument("--csv", metavar="FILE", help="write times and places (- for the terminal)")
    one.add_argument("--png", metavar="FILE", help="write a picture (needs matplotlib)")
    sweep.add_options(many)
    return commands


def fit(options: argparse.Namespace) -> int:
    """Find the coefficients of a table and print a report."""
    table = called(options.table)
    if options.law:
        law = laws.cushion_law(options.law, table.cushion_law)
        table = replace(table, cushion_law=law)
    for line in fitting.run(options, table):
        print(line)
    return 0


def called(name: str) -> tables.Table:
    """The table of that name, or in that file."""
    if name in POCKETED:
        found: tables.Table = getattr(tables, name)().table
        return found
    if name not in LAWS and not name.endswith(".json"):
        known = ", ".join([*LAWS, *POCKETED])
        raise ValueError(f"no table {name!r}: there are {known}, and files that end in .json")
    return LAWS[name] if name in LAWS else tables.load(name)


def set_laws(world: World, name: str | None) -> None:
    """Cloth and laws of a table; or a cushion's law, and balls that rub."""
    if name in CUSHIONS:
        world.ball_law, world.cushion_law = "rough", name
    elif name:
        table = LAWS[name]
        world.cloth, world.ball_law = table.cloth, table.ball_law
        world.cushion_law = table.cushion_law


def scene(start: World, options: argparse.Namespace) -> int:
    """Play the scene and write what was asked for."""
    other = start.copy() if options.against else None
    dt = STEP if options.dt is None else options.dt
    until = ENDLESS.get(options.name, inf) if options.until is None else options.until
    world = played(start, options.engine, dt, until)
    report(world, options)
    if options.csv:
        write(world, RATE if options.rate is None else options.rate, options.csv)
    if options.png:
        if other is not None:
            other = played(other, options.against, dt, world.time)
        draw(world, other, options)
    return 0


def chosen(engine: str, dt: float) -> EventDriven | TimeStepping:
    """The engine of that name."""
    return EventDriven() if engine == "exact" else TimeStepping(dt, engine)


def played(world: World, engine: str | None, dt: float, until: float) -> World:
    """The world at the end, moved by this engine."""
    if engine:
        world.engine = chosen(engine, dt)
    world.run(until)
    return world


def word(engine: str | None) -> str:
    """The engine's name for people; every scene is exact unless an engine is given."""
    return WORDS.get(engine or "exact", f"{engine}")


def report(world: World, options: argparse.Namespace) -> None:
    """A line an event; elsewhere than the samples, if those go to the terminal."""
    say = partial(print, file=sys.stderr if options.csv == "-" else sys.stdout)
    count = len(world.log)
    say(f"{options.name}: {count} events in {world.time:.4f} s, {word(options.engine)}")
    if not count and world.at_rest:
        say(f"all balls lie still: python -m physics sweep {options.name} --speed 2 plays a shot")
        return
    say(f"{'time, s':>9}  {'event':8} {'what':24} speed before -> after, m/s")
    for event in world.log:
        what = ", ".join([*event.balls, *([event.wall] if event.wall else [])])
        say(f"{event.time:9.4f}  {event.kind:8} {what:24} {speeds(event)}")


def speeds(event: Event) -> str:
    pairs = zip(event.before, event.after, strict=True)
    return ", ".join(f"{hypot(*b.velocity):.4f} -> {hypot(*a.velocity):.4f}" for b, a in pairs)


def write(world: World, rate: float, file: str) -> None:
    """The paths as comma-separated values."""
    times, paths = trace(world, rate)
    names = [ball.name for ball in world.balls]
    with nullcontext(sys.stdout) if file == "-" else open(file, "w", newline="") as out:
        rows = csv.writer(out)
        rows.writerow(["time", *(f"{name} {axis}" for name in names for axis in "xy")])
        for time, spots in zip(times, paths, strict=True):
            rows.writerow([float(time), *map(float, spots.flat)])


def draw(world: World, other: World | None, options: argparse.Namespace) -> None:
    """The picture, titled with the first sentence of the scene."""
    from .studies import plot

    said = getdoc(scenes.SCENES[options.name]) if options.name in scenes.SCENES else None
    first = " ".join((said or options.name).split("\n\n")[0].split())
    title = first.split(". ")[0].rstrip(".").replace("`", "")
    dashes = word(options.against) if other else ""
    note = f"After {world.time:.2f} s. " + (apart(world, other, dashes) if other else "")
    figure = plot.picture(world, title, note, word(options.engine), other, dashes)
    plot.save(figure, options.png)


def apart(world: World, other: World, dashes: str) -> str:
    """How far the balls of the other world are from where they should be, and how fast."""
    words = []
    for a, b in zip(world.balls, other.balls, strict=True):
        (x, y), (p, q) = a.position, b.position
        far, fast, slow = hypot(x - p, y - q), hypot(*b.velocity), hypot(*a.velocity)
        words.append(f"{a.name} {far:.2f} m away, at {fast:.2f}, not {slow:.2f} m/s")
    return f"With {dashes}: {'; '.join(words)}."


if __name__ == "__main__":
    sys.exit(main())
