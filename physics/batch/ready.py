"""Scenes in the arrays of the compiled kernel, kept between batches: to pack one takes as long as a
hundred shots."""

from typing import Any, NamedTuple

from physics.kernel.body import Scene

from . import compiled

KEPT = 8  # scenes


class Ready(NamedTuple):
    """What one thread needs to play shots of a scene.

    many: the kernel's function, without a look at what it is given.
    scene: in arrays.
    notes: the class of them.
    near: room for them.
    """

    many: Any
    scene: Any
    notes: Any
    near: tuple[Any, Any]


_free: dict[tuple[Any, ...], tuple[Scene, list[Ready]]] = {}
"""By what decides the arrays; and the scene itself, so that no other is mistaken for it."""
_last: list[tuple[Any, list[Ready]]] = [(None, [])]
"""The entry that was used last: one shot after another finds it more quickly."""


def take(scene: Scene) -> tuple[Ready, list[Ready]]:
    """The scene in arrays that no other thread has, and the list to which it goes back."""
    entry = _last[0]  # looked at once: another thread may put its own there
    if entry[0] is not scene:
        entry = _entry(scene)
        _last[0] = entry
    try:
        return entry[1].pop(), entry[1]
    except IndexError:
        return _new(scene), entry[1]


def _entry(scene: Scene) -> tuple[Scene, list[Ready]]:
    """That of a scene that would be packed alike, or a new one."""
    key = _key(scene)
    entry = _free.get(key)
    if entry is None:
        while len(_free) >= KEPT:
            _free.pop(next(iter(_free)), None)
        entry = _free.setdefault(key, (scene, []))
    return entry


def _new(scene: Scene) -> Ready:
    kernel = compiled.kernel()
    near = compiled.near(len(scene.balls), len(scene.walls))
    many = compiled.door(kernel.calendar.many)
    return Ready(many, compiled.packed(scene), kernel.body.Notes, near)


def _key(scene: Scene) -> tuple[Any, ...]:
    """What is in a scene, but for how its balls lie: those are told apart by what they are."""
    parts = scene.balls, scene.walls, scene.cloth, scene.ball_rule, scene.cushion_rule, scene.rules
    sizes = len(scene.balls), len(scene.walls), scene.celled, scene.lines
    return (*map(id, parts), id(scene.grid.head), *sizes, tuple(scene.frame), scene.openings)
