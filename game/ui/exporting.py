"""The shot on show as data and as a picture, written where the player keeps files."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import pygame

from game.session.session import Session
from game.settings import shot_files


def export(session: Session, picture: pygame.Surface, folder: Path | None) -> None:
    """Write both, and say where, or why that cannot be."""
    image = BytesIO()
    pygame.image.save(picture, image, "shot.png")
    began = session.began if session.shown_shot else session.world.time
    try:
        path = shot_files.write(folder, session.world, began, image.getvalue())
    except OSError as error:
        session.say("unexported", error=True, about=error.strerror or str(error))
    else:
        session.say("exported", about=shot_files.shortly(path))
