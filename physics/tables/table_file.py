"""A table in a file: the world that it makes, without balls, as `store` writes one."""

import os
from dataclasses import replace
from typing import Any

from physics.files import store
from physics.world import World

from .table import Table


def save(thing: Table | World, path: str | os.PathLike[str]) -> None:
    """Write the table to a file, all of it or nothing; `python -m physics fit --preset` does too.

    thing: a Table, or a World: the table that it stands on, with the cloth and laws it has now.
    ValueError for anything else, a world without a table, and custom laws, which no file can hold;
    OSError where it cannot be written.
    """
    table: object = thing
    if isinstance(thing, World) and isinstance(thing.table, Table):
        table = of(thing)
    if not isinstance(table, Table):
        raise ValueError(f"tables.save takes a Table or a World that has one, not {thing!r:.60}")
    store.save(table.world(), path)


def load(path: str | os.PathLike[str]) -> Table:
    """The table in such a file, or that of any saved world, with the cloth and laws it has there.

    ValueError, naming the file and what is wrong with it; OSError where there is none.
    """
    world: Any = store.load(path)
    if not isinstance(world, World) or not isinstance(world.table, Table):
        raise ValueError(f"{os.fspath(path)}: there is no table in it")
    return of(world)


def of(world: World) -> Table:
    """What a world stands on, with the cloth and laws that it has now."""
    made: Table = replace(
        world.table, cloth=world.cloth, ball_law=world.ball_law, cushion_law=world.cushion_law
    )
    return made
