"""A scene is an object when interpreted and a tuple when compiled: of the same fields."""

import pytest

from physics import Shot, scenes, simulate
from physics.kernel.body import Packed, Scene, twin_scene


def test_both_forms_of_a_scene_have_the_same_fields_in_the_same_order():
    assert Packed._fields == tuple(Scene.__slots__)


def test_a_scene_with_a_change_is_another_scene_that_shares_all_else():
    scene = scenes.carom().scene
    other = scene._replace(celled=True)
    assert other is not scene
    assert (scene.celled, other.celled) == (False, True)
    same = [name for name in Scene.__slots__ if name != "celled"]
    assert all(getattr(other, name) is getattr(scene, name) for name in same)


def test_a_scene_refuses_a_change_of_what_it_does_not_have():
    with pytest.raises(ValueError, match="a scene has no ball_rules"):
        scenes.carom().scene._replace(ball_rules=None)


def test_a_copy_of_a_scene_has_all_that_the_scene_has():
    scene = scenes.carom().scene
    own = {"balls", "meetings", "walls", "ties", "grid", "celled"}
    marks = {name: object() for name in Scene.__slots__ if name not in own}
    copy = twin_scene(scene._replace(**marks), scene.balls)
    assert {name: getattr(copy, name) for name in marks} == marks


def test_the_scene_of_a_copy_shares_nothing_that_a_shot_changes():
    world = scenes.carom()
    world.plan()
    before = [ball.position for ball in world.balls], world.scene.meetings[:]
    after = simulate(world, "white", Shot(3.0, 40.0, follow=0.5, side=1.5))
    assert after.scene.meetings is not world.scene.meetings
    assert ([ball.position for ball in world.balls], world.scene.meetings) == before
