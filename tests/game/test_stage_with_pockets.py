"""The table's stage with pockets: drawn in part it is the same as drawn anew."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.session.ticks import TICKS
from tests.support.pictures import pixels
from tests.support.stages import TABLES, a_stage, break_off, racked, shown

FRAME = TICKS // 60


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_a_break_drawn_in_part_is_the_same_as_drawn_anew(table):
    session, stage = a_stage(racked(table))
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    break_off(session)
    for frame in range(240):
        session.advance(FRAME)
        stage.follow(session)
        stage.draw(surface, session)
        if frame % 40 == 39:
            assert np.array_equal(pixels(surface), pixels(shown(session, stage)))
