"""The scene command on balls that have not been struck."""

import pytest

from physics.__main__ import main


def test_a_scene_at_rest_says_how_a_shot_is_played(capsys):
    main(["scene", "carom"])
    said = capsys.readouterr().out
    assert "all balls lie still" in said
    assert "python -m physics sweep carom --speed 2" in said
    assert "speed before" not in said


@pytest.mark.parametrize("scene", ["cradle", "single"])
def test_a_scene_in_motion_says_no_such_thing(capsys, scene):
    main(["scene", scene])
    assert "lie still" not in capsys.readouterr().out
