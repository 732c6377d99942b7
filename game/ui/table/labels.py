"""What is written on the table: numbers beside balls, where they are too small to read or their
colours are not enough, and beside a pocket the share of shots that get there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

import pygame

from game.aim.preview import Preview
from game.render.arrays import Points
from game.render.font import type_at
from game.render.layout import Layout
from game.render.table import pocket_marks, tags
from game.render.table.balls import Spot
from game.render.table.plan import Hole
from game.render.table.prints import LEAST
from game.render.theme import BallLook
from game.session.session import Session

from . import preview_lines

PACK = 4
"""Balls that look alike from which on none of them needs a name: snooker's reds."""
Rects = list[pygame.Rect]


def wanted(look: BallLook, radius: float, colours: str) -> bool:
    """Does a ball of `radius` px need a tag?  A number is read on the ball if that is large."""
    if colours == "safe" and look.letter:
        return bool(look.number) or radius < LEAST
    return bool(look.number) and radius < LEAST


def share(
    surface: pygame.Surface,
    layout: Layout,
    session: Session,
    looks: Sequence[BallLook],
    seen: Preview,
    holes: Mapping[str, Hole],
    made: float | None,
) -> Rects:
    """Write the share that is made beside the pocket of the first ball that is to fall."""
    names = [ball.name for ball in session.world.balls]
    for name, hole in preview_lines.dropped(seen, session.cue, holes).items():
        if name != session.cue and made is not None:
            ink, spot = looks[names.index(name)].ui, pocket_marks.pill_spot(layout, hole)
            text = f"{round(100 * made)} %"
            return [pocket_marks.pill(surface, type_at(layout.s), text, spot, ink)]
    return []


def tags_of(
    surface: pygame.Surface,
    layout: Layout,
    session: Session,
    looks: Sequence[BallLook],
    colours: str,
    spots: Iterable[Spot],
    paths: Sequence[Points] = (),
) -> Rects:
    """Write them beside the balls that lie on the table; `paths` (px) stay clear."""
    found, balls, alike = [], session.world.balls, Counter(looks)
    for spot in spots:
        look, radius = looks[spot.ball], balls[spot.ball].radius * layout.scale
        text = look.letter if wanted(look, radius, colours) and alike[look] < PACK else ""
        found.append(tags.Tag(layout.to_screen(*spot.at), radius, text))
    if not any(tag.text for tag in found):
        return []
    return tags.draw(surface, layout, type_at(layout.s), found, paths)
