"""A shot as files: its data and a picture, in a folder of the user's, each written whole."""

from __future__ import annotations

from io import BytesIO
from itertools import count
from pathlib import Path

import pygame

import danggu
from game.session.session import Session
from game.table import library
from physics import World, whole_files

from . import user_files

FOLDER = "exports"
LONGEST = 120.0
"""Seconds of data at most: a scene that never ends would be written for minutes."""


def export(session: Session, picture: pygame.Surface, folder: Path | None) -> None:
    """Write the shot on show, or how the balls lie before one, and say where, or why not.

    folder: that of the user's own things if None.
    """
    image = BytesIO()
    pygame.image.save(picture, image, "shot.png")
    began = session.began if session.shown_shot else session.world.time
    try:
        path = write(folder or library.folder(), session.world, began, image.getvalue())
    except OSError as error:
        session.say("unexported", error=True, about=error.strerror or str(error))
    else:
        session.say("exported", about=shortly(path))


def write(folder: Path | None, world: World, began: float, picture: bytes) -> Path:
    """Write the shot that began then, world seconds, as CSV, and a picture (PNG) beside it.

    Of a longer one only the last LONGEST seconds are written.
    Returns the file of the data; its name has the first number that is free. OSError if either
    cannot be written: then neither is there.
    """
    if folder is None:
        raise OSError("there is no home folder")
    home = folder / FOLDER
    data = danggu.labs.samples(world, begin=max(began, world.time - LONGEST)).encode()
    with user_files.alone(home / "any"):
        names = (home / f"shot-{n:03}" for n in count(1))
        name = next(n for n in names if not any(map(Path.exists, files(n))))
        table, image = files(name)
        whole_files.replace(table, data)
        try:
            whole_files.replace(image, picture)
        except OSError:
            table.unlink(missing_ok=True)
            raise
    return table


def files(name: Path) -> tuple[Path, Path]:
    """The two files of a shot."""
    return name.with_suffix(".csv"), name.with_suffix(".png")


def shortly(path: Path) -> str:
    """A path with a sign for the user's home."""
    try:
        return str(Path("~") / path.relative_to(Path.home()))
    except (ValueError, RuntimeError):
        return str(path)
