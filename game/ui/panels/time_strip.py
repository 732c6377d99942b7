"""The strip below the boxes: undo, the buttons and the speed of time, and the shot's timeline."""

from __future__ import annotations

from collections.abc import Hashable
from math import ceil

import pygame

from game.aim.preview import NO_STORY, Story
from game.render.layout import Layout
from game.render.parts import lanes
from game.session.action import Action
from game.session.ticks import TICKS
from game.ui.sight import Place, Sight

from .parts import Panel, number


def _playing(sight: Sight) -> bool:
    session = sight.session
    if session.timeline.at is not None:
        return session.timeline.playing
    return session.moving and not session.paused


def _buttons(sight: Sight) -> lanes.Buttons:
    """How the buttons look: whether there is something to undo, redo and play, and the speed."""
    session = sight.session
    past, future = bool(session.history.past), bool(session.history.future)
    return lanes.Buttons(past, future, _playing(sight), session.timeline.label)


def key(sight: Sight) -> Hashable:
    """What the strip depends on."""
    session = sight.session
    if sight.mode == "aim":
        return "aim", session.preview_key, sight.settings.aids, _buttons(sight)
    return session.stamp, session.began, session.readout_time, _buttons(sight)


def draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Draw it: the preview of the next shot, or the last one with its handle."""
    session, w, args = sight.session, sight.words, (surface, rect, sight.type)
    if sight.mode == "aim":
        seen = session.preview if sight.settings.aids == "full" else None
        found = seen.story if seen else NO_STORY
        label = w["preview"].format(time=number(found.duration, 1)) if seen else ""
        return lanes.timeline(*args, _lanes(sight, found), found.duration, label, _buttons(sight))
    found, length = session.forecast, _length(sight)
    now = min(session.readout_time, length)  # the last frame ends after the last event
    label = w["time"].format(now=number(now), all=number(length))
    return lanes.timeline(*args, _lanes(sight, found), length, label, _buttons(sight), now)


def _length(sight: Sight) -> float:
    session = sight.session
    return max(session.forecast.duration, session.timeline.end / TICKS, 1e-9)


def touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    """A button, or a place on the timeline: while the mouse is held it scrubs."""
    pointer, s = sight.pointer, sight.layout.s
    track = lanes.track(rect, s)
    if pointer.pressing:
        for box, action in _actions(rect, sight):
            if box.collidepoint(at):
                return action
        if not track.inflate(round(16 * s), 0).collidepoint(at):
            return None
        pointer.grip = "time"
    if pointer.grip != "time" or sight.mode != "after":
        return None
    share = min(max((at[0] - track.x) / track.w, 0.0), 1.0)
    return Action("scrub", ceil(share * _length(sight) * TICKS))


def _actions(rect: pygame.Rect, sight: Sight) -> list[tuple[pygame.Rect, Action]]:
    session, s = sight.session, sight.layout.s
    if sight.mode == "after":
        play, back = Action("pause"), Action("home")
    else:
        play, back = Action("fire"), Action("retry")
    names = [Action("undo"), Action("redo"), back, play, Action("skip")]
    if sight.mode == "aim" and not session.shots:
        names[2] = Action("home")
    slower, faster = lanes.rate_halves(rect, s)
    pairs = list(zip(lanes.buttons(rect, s), names, strict=True))
    return [*pairs, (slower, Action("faster", -1)), (faster, Action("faster", 1))]


def wheel(steps: int, sight: Sight) -> Action:
    """One frame on or back a notch."""
    return Action("back" if steps < 0 else "frame")


def _lanes(sight: Sight, found: Story) -> list[lanes.Lane]:
    session, traced, result = sight.session, sight.session.traced, []
    names = [ball.name for ball in session.world.balls if ball.name in traced]
    for name in names:
        own = [e for e in found.events if name in e.balls]
        legs = next((lane.legs for lane in found.lanes if lane.name == name), ())
        joins = (
            (e.time, names.index(other))
            for e in own
            if e.kind == "ball"
            for other in e.balls
            if other != name and other in names
        )
        kinds = "cushion", "rest", "pocket"
        marks = {k: tuple(e.time for e in own if e.kind == k) for k in kinds}
        rests = tuple(time for time in marks["rest"] if time not in marks["pocket"])
        ink = sight.look(name).ui
        lane = lanes.Lane(ink, legs, marks["cushion"], tuple(joins), rests, marks["pocket"])
        result.append(lane)
    return result


def part(layout: Layout) -> Panel:
    """The strip in the window."""
    return Panel("lanes", layout.timeline, key, draw, touch, True, spill=7, wheel=wheel)
