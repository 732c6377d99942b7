"""The parts that tell about a shot: head, tip, power, thickness, result, log and lanes."""

from __future__ import annotations

from collections.abc import Hashable
from math import atan2, degrees, hypot

import pygame

from game.actions import Action
from game.play import Game
from game.preview import NO_STORY, Contact, Story
from game.render import cards, gauges, lanes
from game.render.layout import Layout
from game.render.theme import TEXT, TEXT_SOFT

from .looks import ball_words, look
from .parts import Part, Place, Sight, number

STRONGEST = 8.0
"""Right end of the power bar, m/s."""
LEVER = 2.5
"""Surface speed over speed for a tip one radius off the centre: F r = (2/5) m R² ω."""
EIGHTHS = 8


# -- the row above the table ---------------------------------------------------------------------


def _state(game: Game) -> str:
    if game.paused:
        return "paused"
    if game.moving:
        return "moving"
    if game.aim.box is not None:
        return "editing"
    if game.shown_shot:
        return "rest"
    return "ready" if game.aim.complete else "spent"


def _head_numbers(sight: Sight) -> tuple[tuple[str, str], ...]:
    game, w = sight.game, sight.words
    balls, cushions = game.counts
    values = (str(game.shots), str(balls), str(cushions), number(game.readout_time))
    names = ("count.shots", "count.balls", "count.cushions", "count.time")
    return tuple((w[name], value) for name, value in zip(names, values, strict=True))


def _head_look(sight: Sight) -> Hashable:
    return _state(sight.game), _head_numbers(sight)


def _head_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    s, t, w = sight.layout.s, sight.type, sight.words
    cards.card(surface, rect, s, raised=True)
    left = rect.x + round(16 * s)
    t.draw(surface, w["free"], (left, rect.y + 21 * s), 15, TEXT)
    t.draw(surface, w["state." + _state(sight.game)], (left, rect.y + 39 * s), 12, TEXT_SOFT)
    right = rect.right - round(16 * s)
    for name, value in reversed(_head_numbers(sight)):
        middle = right - round(36 * s)
        t.draw(surface, name, (middle, rect.y + 18 * s), 12, TEXT_SOFT, "centre")
        t.draw(surface, value, (middle, rect.y + 40 * s), 20, TEXT, "centre")
        right -= round(88 * s)
    return rect


# -- the next shot -------------------------------------------------------------------------------


def _tip_look(sight: Sight) -> tuple[float, float, float] | None:
    """Where the cue must strike for the spins in the boxes: right and up in R, and massé / V."""
    shot = sight.game.aim.shot
    if shot is None:
        return None
    reach = LEVER * shot.speed
    return shot.side / reach, shot.follow / reach, shot.masse / reach


def _tip_key(sight: Sight) -> Hashable:
    return _tip_look(sight)


def _tip_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    w, found = sight.words, _tip_look(sight)
    right, up, masse = found or (0.0, 0.0, 0.0)
    names = (w["tip.side"], w["tip.height"], w["tip.masse"])
    parts = zip(names, (right, up, masse), strict=True)
    values = [(name, _signed(v) if found else "–") for name, v in parts]
    safe = hypot(right, up) <= gauges.MISCUE
    size = max(1.0, hypot(right, up) / 0.97)
    point = (right / size, up / size)
    return gauges.tip(surface, rect, sight.type, w["tip"], point, values, safe)


def _signed(value: float) -> str:
    return ("+" if value > 0 else "") + number(value) + " R"


def _tip_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    shot = sight.game.aim.shot
    (x, y), radius = gauges.tip_circle(rect, sight.layout.s)
    right, up = (at[0] - x) / radius, (y - at[1]) / radius
    if shot is None or (hypot(right, up) > 1.0 and sight.pointer.held != "tip"):
        return None
    size = max(1.0, hypot(right, up) / gauges.MISCUE)
    reach = LEVER * shot.speed / size
    return Action("set", f"side {right * reach:.2f} follow {up * reach:.2f}")


def _power_key(sight: Sight) -> Hashable:
    shot = sight.game.aim.shot
    return shot.speed if shot else None


def _power_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    w, shot = sight.words, sight.game.aim.shot
    value = number(shot.speed) if shot else "–"
    share = shot.speed / STRONGEST if shot else 0.0
    ticks = [(v / STRONGEST, str(v) if v % 2 == 0 else "") for v in range(int(STRONGEST) + 1)]
    args = (w["power"], value, w["unit.speed"], share, ticks)
    return gauges.power(surface, rect, sight.type, *args)


def _power_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    track = gauges.power_track(rect, sight.layout.s)
    share = (at[0] - track.x - track.h / 2) / (track.w - track.h)
    return Action("set", f"speed {min(max(share, 0.00625), 1.0) * STRONGEST:.2f}")


def _contact(sight: Sight) -> Contact | None:
    seen = sight.game.preview if sight.settings.aids != "off" else None
    return seen.contact if seen else None


def _thickness_key(sight: Sight) -> Hashable:
    return sight.game.preview is None, _contact(sight), sight.settings.aids


def _thickness_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    w, contact, game = sight.words, _contact(sight), sight.game
    if contact is None:
        return _nothing_met(surface, rect, sight)
    names = [ball.name for ball in game.world.balls]
    colour = look(contact.ball, names.index(contact.ball), sight.settings.colours).ui
    items = [(eighths(contact.overlap), w["thickness.cut"].format(angle=number(contact.cut, 1)))]
    return gauges.thickness(
        surface, rect, sight.type, w["thickness"], items, contact.overlap, colour
    )


def _nothing_met(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    if not rect.h:
        return rect
    s, t, w = sight.layout.s, sight.type, sight.words
    cards.card(surface, rect, s)
    t.draw(surface, w["thickness"], (rect.x + 12 * s, rect.y + 24 * s), 13, TEXT_SOFT)
    known = sight.game.preview is not None and sight.settings.aids != "off"
    said = w["thickness.free"] if known else "–"
    t.draw(surface, said, (rect.x + 12 * s, rect.y + 56 * s), 15, TEXT_SOFT)
    return rect


def eighths(overlap: float) -> str:
    """The thickness to the nearest eighth, in lowest terms: "<1/8" "1/8" "1/2" "1"."""
    n, d = round(abs(overlap) * EIGHTHS), EIGHTHS
    while n and n % 2 == 0 and d > 1:
        n, d = n // 2, d // 2
    return "<1/8" if n == 0 else str(n) if d == 1 else f"{n}/{d}"


# -- the last shot -------------------------------------------------------------------------------


def _result_look(sight: Sight) -> tuple[str, str, str]:
    w = sight.words
    balls, cushions = sight.game.counts
    time = sight.game.readout_time
    first = w[f"result.balls.{min(balls, 2)}"].format(count=balls)
    return str(balls), first, w["result.line"].format(cushions=cushions, time=number(time))


def _result_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    return cards.result(surface, rect, sight.type, *_result_look(sight), tone=TEXT)


def _log_key(sight: Sight) -> Hashable:
    game = sight.game
    return game.shots, game.began, len(game.world.log)


def log_rows(game: Game, w: dict[str, str], colours: str = "usual") -> list[cards.LogRow]:
    """The events of the shot that matter to a player."""
    names = [ball.name for ball in game.world.balls]
    colour = {name: look(name, i, colours) for i, name in enumerate(names)}

    def dots(balls: tuple[str, ...]) -> tuple[tuple[tuple[int, int, int], str], ...]:
        return tuple((colour[b].ui, colour[b].letter) for b in balls)

    rows = [cards.LogRow("0.00", dots((game.cue,)), w["event.strike"])] if game.shots else []
    for event in game.world.log:
        if event.kind == "roll":
            continue
        balls = event.balls
        if balls[-1] == game.cue:
            balls = balls[::-1]
        if event.kind == "ball":
            first, second = (ball_words(b, w) for b in balls)
            said = w["event.ball"].format(first=first, second=second)
        elif event.kind == "cushion":
            side = w.get(f"wall.{event.wall}")
            said = w["event.cushion"].format(wall=side) if side else w["event.cushion.inner"]
        else:
            said = w["event.rest"]
        rows.append(cards.LogRow(number(event.time - game.began), dots(balls), said))
    return rows


def _log_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    rows = log_rows(sight.game, sight.words, sight.settings.colours)
    shown = cards.log_rows(rect, sight.layout.s)
    top = max(0, len(rows) - shown)
    title = sight.words["events"]
    return cards.log(surface, rect, sight.type, title, rows, len(rows) - 1, first=top)


def _lanes_look(sight: Sight) -> Hashable:
    game = sight.game
    if sight.mode == "aim":
        return "aim", game.preview_key, sight.settings.aids
    return game.stamp, game.readout_time, game.moving and not game.paused


def _lanes_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    game, w = sight.game, sight.words
    if sight.mode == "aim":
        seen = game.preview if sight.settings.aids == "full" else None
        told = seen.story if seen else NO_STORY
        label = w["preview"].format(time=number(told.duration, 1)) if seen else ""
        return lanes.timeline(
            surface, rect, sight.type, _lanes(sight, told), told.duration, label, ""
        )
    told, now = game.forecast, game.readout_time
    length = max(told.duration, now)
    label = w["time"].format(now=number(now), all=number(length))
    drawn, playing = _lanes(sight, told), game.moving and not game.paused
    return lanes.timeline(surface, rect, sight.type, drawn, length, label, "", now, playing)


def _lanes_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    """The three buttons: before the shot, play or pause, to the end."""
    game = sight.game
    names = ("retry", "pause" if game.moving else "fire", "skip")
    for box, name in zip(lanes.buttons(rect, sight.layout.s), names, strict=True):
        if box.collidepoint(at) and (name != "retry" or game.shots):
            return Action(name)
    return None


def _lanes(sight: Sight, told: Story) -> list[lanes.Lane]:
    game, colours = sight.game, sight.settings.colours
    names = [name for name in (ball.name for ball in game.world.balls) if name in game.traced]
    result = []
    for place, name in enumerate(names):
        own = [e for e in told.events if name in e.balls]
        legs = next((lane.legs for lane in told.lanes if lane.name == name), ())
        joins = (
            (e.time, names.index(other))
            for e in own
            if e.kind == "ball"
            for other in e.balls
            if other != name and other in names
        )
        marks = {k: tuple(e.time for e in own if e.kind == k) for k in ("cushion", "rest")}
        ink = look(name, place, colours).ui
        lane = lanes.Lane(ink, legs, marks["cushion"], tuple(joins), marks["rest"])
        result.append(lane)
    return result


# -- the table -----------------------------------------------------------------------------------


def _table_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    game = sight.game
    if sight.mode == "after" or not sight.layout.bed.collidepoint(at):
        return None
    x, y = sight.layout.to_table(*at)
    own = game.world.ball(game.cue).position
    if hypot(x - own[0], y - own[1]) < 1e-6:
        return None
    return Action("set", f"angle {degrees(atan2(y - own[1], x - own[0])):.2f}")


def _nothing_key(sight: Sight) -> Hashable:
    return None


def _nothing_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    return pygame.Rect(0, 0, 0, 0)


def shot_parts(layout: Layout) -> list[Part]:
    """The parts that tell about the next shot or the last one."""
    head = layout.score[0].union(layout.score[2])
    return [
        Part("head", head, _head_look, _head_draw),
        Part("lanes", layout.timeline, _lanes_look, _lanes_draw, _lanes_touch, spill=7),
        Part("tip", layout.tip, _tip_key, _tip_draw, _tip_touch, drags=True, mode="aim"),
        Part("power", layout.power, _power_key, _power_draw, _power_touch, drags=True, mode="aim"),
        Part("thickness", layout.thickness, _thickness_key, _thickness_draw, mode="aim"),
        Part("result", layout.result, _result_look, _result_draw, mode="after"),
        Part("log", layout.log, _log_key, _log_draw, mode="after"),
        Part("table", layout.bed, _nothing_key, _nothing_draw, _table_touch, drags=True),
    ]
