"""Tests need no screen and no sound."""

import os

import pytest

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("SDL_AUDIODRIVER", "dummy")
os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")


@pytest.fixture(scope="module")
def undrawn():
    """Drawing changes nothing, and takes most of the time."""
    from game.ui.view import View

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(View, "draw", lambda view, surface: [])
        yield
