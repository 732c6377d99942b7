"""A scene is called in the window what it is called on the shelf."""

import pytest

from game.input.captions import words
from game.ui.panels.parts import badge
from physics.scenes import SCENES
from tests.support.players import an_app


@pytest.mark.parametrize("language", ["en", "ko"])
@pytest.mark.parametrize("scene", SCENES)
def test_a_scene_bears_its_name_of_the_shelf(scene, language):
    app = an_app(scene=scene, lang=language)
    w = words(language)
    table = badge(app.session, w)[1]
    assert table.endswith(w[f"position.{scene}"])
