"""The parts that show a shot: head, result, log, and the table that is touched."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import replace
from math import ceil

import pygame

from game.input.captions import words
from game.render.layout import Layout
from game.render.parts import cards
from game.render.theme import BACKGROUND, TEXT, TEXT_SOFT
from game.session.action import Action
from game.session.session import Session
from game.session.ticks import TICKS
from game.text import LANGUAGES
from game.ui.sight import Place, Sight
from game.ui.table import drag_aim, place_balls
from game.ui.table.looks import ball_words, looks_of

from . import (
    aim_panel,
    asked_card,
    drill_words,
    graphs,
    nominate,
    rack_words,
    score_plates,
    time_strip,
)
from .parts import Panel, number

# -- the row above the table ---------------------------------------------------------------------


def _state(session: Session) -> str:
    if session.arranging:
        return "arranging"
    if session.paused or session.timeline.at is not None:
        return "replay" if session.timeline.playing else "paused"
    if session.moving:
        return "moving"
    if session.aim.box is not None:
        return "editing"
    if session.shown_shot:
        return "rest"
    return "ready" if session.aim.complete else "spent"


def _head_numbers(sight: Sight) -> tuple[tuple[str, str], ...]:
    session, w = sight.session, sight.words
    balls, cushions = session.counts
    values = (str(session.shots), str(balls), str(cushions), number(session.readout_time))
    names = ("count.shots", "count.balls", "count.cushions", "count.time")
    return tuple((w[name], value) for name, value in zip(names, values, strict=True))


def _head_look(sight: Sight) -> Hashable:
    if sight.session.contest is not None:
        return score_plates.match_look(sight.session.contest, sight)
    if drill_words.wanted(sight):
        return drill_words.key(sight)
    return _state(sight.session), _head_numbers(sight)


def _head_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    surface.fill(BACKGROUND, rect)
    if sight.session.contest is not None:
        score_plates.match_draw(sight.session.contest, surface, sight)
        return rect
    if drill_words.wanted(sight):
        return drill_words.draw(surface, rect, sight)
    s, t, w = sight.layout.s, sight.type, sight.words
    cards.card(surface, rect, s, raised=True)
    left = rect.x + round(16 * s)
    t.draw(surface, w["free"], (left, rect.y + 21 * s), 15, TEXT)
    t.draw(surface, w["state." + _state(sight.session)], (left, rect.y + 39 * s), 12, TEXT_SOFT)
    right = rect.right - round(16 * s)
    for name, value in reversed(_head_numbers(sight)):
        middle = right - round(36 * s)
        t.draw(surface, name, (middle, rect.y + 18 * s), 12, TEXT_SOFT, "centre")
        t.draw(surface, value, (middle, rect.y + 40 * s), 20, TEXT, "centre")
        right -= round(88 * s)
    return rect


# -- the last shot -------------------------------------------------------------------------------


def _result_look(sight: Sight) -> score_plates.Result:
    w, contest = sight.words, sight.session.contest
    if contest is not None and contest.verdict is not None and sight.session.timeline.at is None:
        return score_plates.result(contest, contest.verdict, sight)
    balls, cushions = sight.session.counts
    time = sight.session.readout_time
    first = w[f"result.balls.{min(balls, 2)}"].format(count=balls)
    line = w["result.line.1" if cushions == 1 else "result.line"]
    second = line.format(cushions=cushions, time=number(time))
    if settled := sight.session.settled:
        badge, tone = score_plates.counted(settled)
        return badge, score_plates.reason(settled, w), second, tone
    if contest is not None and not contest.terms.discipline.position and contest.lag is None:
        return *rack_words.so_far(sight.session, w), second, TEXT
    return str(balls), first, second, TEXT


def _result_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    return cards.result(surface, rect, sight.type, *_result_look(sight))


def _log_key(sight: Sight) -> Hashable:
    session = sight.session
    if sight.settings.graphs:
        return graphs.key(sight)
    head = session.timeline.passed, session.timeline.at is None
    return session.shots, session.began, len(session.world.log), head, sight.settings.both


def log_rows(
    session: Session, w: dict[str, str], colours: str = "usual", hit: str = "event.ball"
) -> list[cards.LogRow]:
    """The events of the shot that matter to a player, each with its ball's name.

    `hit` is the key for balls that meet; with any but the usual one, which names both, rows are for
    a second language beside the first and name no ball again.
    """
    named = hit == "event.ball"
    names = [ball.name for ball in session.world.balls]
    colour = dict(zip(names, looks_of(session.world, colours), strict=True))

    def dots(balls: tuple[str, ...]) -> tuple[tuple[tuple[int, int, int], str], ...]:
        return tuple((colour[b].ui, colour[b].letter) for b in balls)

    struck = w["event.strike"]
    struck = _of("strike", session.shooter, struck, w) if named else struck
    rows = [cards.LogRow("0.00", dots((session.shooter,)), struck)] if session.shots else []
    for event in session.timeline.notable:
        balls = event.balls
        if balls[-1] == session.shooter:
            balls = balls[::-1]
        if event.kind == "ball":
            first, second = (ball_words(b, w) for b in balls)
            said = w[hit].format(first=first, second=second)
        elif event.kind in ("pocket", "off"):
            words_ = {"ball": ball_words(balls[0], w), "pocket": w.get(f"pocket.{event.wall}", "")}
            said = w[f"event.{event.kind}"].format(**words_)
        elif event.kind == "cushion":
            side, inner = w.get(f"wall.{event.wall}"), "event.cushion.inner"
            inner = "event.jaw" if "pocket" in (event.wall or "") else inner
            met = w["event.cushion"].format(wall=side) if side else w[inner]
            said = _of("cushion", balls[0], met, w) if named else met
        else:
            said = w["event.rest"]
            said = _of("rest", balls[0], said, w) if named else said
        rows.append(cards.LogRow(number(event.time - session.began), dots(balls), said))
    return rows


def _of(kind: str, ball: str, said: str, w: dict[str, str]) -> str:
    """Say what happened to a ball with its name."""
    return w[f"event.of.{kind}"].format(ball=ball_words(ball, w), said=said)


def _log_times(session: Session) -> list[float]:
    """When the rows of the log were, world seconds."""
    times = [event.time for event in session.timeline.notable]
    return [session.began, *times] if session.shots else times


def _log_place(sight: Sight, rect: pygame.Rect) -> tuple[int, int]:
    """The current row, and the first one shown: the last ones while the log is being written."""
    session = sight.session
    times, shown = _log_times(session), cards.log_rows(rect, sight.layout.s)
    if session.timeline.at is None:
        return len(times) - 1, max(0, len(times) - shown)
    current = sum(time <= session.timeline.moment for time in times) - 1
    return current, cards.log_scroll(len(times), current, shown)


def _log_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    if sight.settings.graphs:
        return graphs.draw(surface, rect, sight)
    rows, title = (
        log_rows(sight.session, sight.words, sight.settings.colours),
        sight.words["events"],
    )
    if sight.settings.both:
        other = words(next(key for key in LANGUAGES if key != sight.session.language))
        rows = _with_second(rows, log_rows(sight.session, other, hit="event.hit"))
        title += " · " + other["events"]
    current, top = _log_place(sight, rect)
    letters = sight.settings.colours == "safe"
    cards.log(surface, rect, sight.type, title, rows, current, letters, first=top)
    at = (rect.right - 12 * sight.layout.s, rect.y + 23 * sight.layout.s)
    both = sight.type.draw(surface, sight.words["events.both"], at, 12, TEXT_SOFT, "right")
    at = (both.x - 14 * sight.layout.s, at[1])
    sight.type.draw(surface, sight.words["graphs.title"], at, 12, TEXT_SOFT, "right")
    return rect


def _with_second(rows: list[cards.LogRow], others: list[cards.LogRow]) -> list[cards.LogRow]:
    """The rows with what they say in another language."""
    return [replace(row, second=two.first) for row, two in zip(rows, others, strict=True)]


def _log_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    """Show the moment of a row; the head of the list has the graphs, and the other language."""
    if sight.settings.graphs:
        return graphs.touch(at, rect, sight)
    if not sight.pointer.pressing:
        return None
    if at[1] < cards.log_row(rect, sight.layout.s, 0).y:
        both = rect.right - 19 * sight.layout.s - sight.type.width(sight.words["events.both"], 12)
        graphed = sight.type.width(sight.words["graphs.title"], 12) + 14 * sight.layout.s
        return Action("graphs" if both - graphed <= at[0] < both else "both")
    times, (_, top) = _log_times(sight.session), _log_place(sight, rect)
    for place, time in enumerate(times[top : top + cards.log_rows(rect, sight.layout.s)]):
        if cards.log_row(rect, sight.layout.s, place).collidepoint(at):
            return Action("scrub", max(0, ceil((time - sight.session.began) * TICKS)))
    return None


# -- the table -----------------------------------------------------------------------------------


def _table_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    session = sight.session
    on_bed = sight.layout.bed.collidepoint(at)
    if session.arranging and (on_bed or not sight.pointer.pressing):
        return place_balls.touch(at, sight)
    if session.moving:
        return None
    if sight.pointer.pressing and (pocket := nominate.pocket_at(at, sight)):
        return Action("call", f"pocket {pocket}")
    held, action = place_balls.put_again(at, sight)
    if held or session.arranging or not on_bed:
        return action
    return drag_aim.touch(at, sight)


def _nothing_key(sight: Sight) -> Hashable:
    return None


def _nothing_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    return pygame.Rect(0, 0, 0, 0)


def shot_parts(layout: Layout) -> list[Panel]:
    """The parts that show the next shot or the last one."""
    head = layout.score[0].union(layout.score[2])
    table = _nothing_key, _nothing_draw, _table_touch
    return [
        Panel("head", head, _head_look, _head_draw),
        time_strip.part(layout),
        *aim_panel.parts(layout),
        asked_card.part(layout),
        Panel("result", layout.result, _result_look, _result_draw, mode="after"),
        Panel("log", layout.log, _log_key, _log_draw, _log_touch, True, mode="after"),
        Panel("table", layout.table, *table, drags=True, wheel=drag_aim.wheel),
    ]
