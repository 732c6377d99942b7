"""The match in the window: score plates, inning, and what the last stroke counted."""

from __future__ import annotations

from collections.abc import Hashable

import pygame

from danggu.rules.pocketed import CUE
from danggu.rules.pool import SCRATCH
from danggu.rules.sagu import LAST_POINT_3C
from danggu.rules.verdict import OFF_TABLE, Verdict
from game.render.parts import cards
from game.render.table.balls import portrait
from game.render.theme import ACCENT, ERROR, GOOD, TEXT, TEXT_SOFT, Colour
from game.session.running_match import Contest
from game.ui import halls
from game.ui.names import player_name, short_name
from game.ui.sight import Sight

from . import plate_balls, rack_words
from .parts import number

CUE_BALL = 14
"""Radius on the plates of games with pockets, px at s = 1: a ball of snooker's table is tiny."""
COUNTED = {"no_red", "opponent_ball", "off_table", "opening_not_red"}
"""Fouls that say what they cost, also where that is nothing."""
Result = tuple[str, str, str, Colour]


def match_look(contest: Contest, sight: Sight) -> Hashable:
    """Return what plates and inning depend on."""
    thinking = contest.thinking, contest.share if sight.mode == "aim" else None
    drawn = contest.card, sight.settings.colours
    own = contest.match, contest.race, contest.terms
    return own, drawn, thinking, sight.session.moving, sight.mode


def match_draw(contest: Contest, surface: pygame.Surface, sight: Sight) -> None:
    """Draw the plates of the players and the inning between them."""
    first, middle, last = sight.layout.score
    match, w = contest.match, sight.words
    label, number_ = rack_words.middle(contest, w)
    cards.inning(surface, middle, sight.type, label, number_)
    _plate(surface, first, sight, contest, 0)
    if len(match.players) > 1:
        _plate(surface, last, sight, contest, 1)
    else:
        _alone(surface, last, sight, contest)


def _plate(
    surface: pygame.Surface, rect: pygame.Rect, sight: Sight, contest: Contest, index: int
) -> None:
    match = contest.match
    points, goal, target = rack_words.points(contest, index)
    playing = match.winner == index if match.finished else match.at == index
    said, tone = _line(sight, contest, index)
    row = plate_balls.of(contest, index)
    share = points / target if target and tone is None and not row else None
    ball = None if plate_balls.grouped(row) else _cue_ball(sight, contest, match.cue_of(index))
    name, shown = player_name(contest.terms, index, sight.words), number(points, 0)
    left, end = cards.score_room(rect, sight.type, shown, goal, ball is not None)
    words = plate_balls.beside(contest, sight, row, (name, said), end - left)
    if row and sight.type.width(name, 15) > words:
        name = short_name(contest.terms, index, sight.words)
    kept = end - left - words if row else 0
    cards.score(
        surface,
        rect,
        sight.type,
        name,
        said,
        shown,
        goal,
        playing,
        ball,
        share,
        tone,
        kept,
    )
    if row:
        gap = round(plate_balls.GAP * sight.type.s)
        room = pygame.Rect(end - kept + gap, rect.y, kept - gap, rect.h)
        plate_balls.draw(surface, room, sight, row)


def _cue_ball(sight: Sight, contest: Contest, name: str) -> pygame.Surface | None:
    """A picture of a player's ball: in carom as on the table, where it tells the two apart."""
    if not contest.terms.discipline.position:
        return portrait(sight.look(name), round(CUE_BALL * sight.layout.s, 1))
    names = [ball.name for ball in sight.session.world.balls]
    return sight.portrait(names.index(name)) if sight.portrait else None


def _line(sight: Sight, contest: Contest, index: int) -> tuple[str, Colour | None]:
    """The line under a name, and its colour if it is not the usual one."""
    w, match = sight.words, contest.match
    sheet = match.sheets[index]
    if match.winner == index:
        return rack_words.won(contest, w) or _counted("score.won", sheet.innings, w), GOOD
    parts = [
        w["score.average"].format(n=number(sheet.average)),
        w["score.high"].format(n=sheet.best),
    ]
    racked = rack_words.line(contest, index, w)
    parts = parts if racked is None else racked
    if sheet.fouls and racked is None:
        parts.append(w["score.fouls"].format(n=sheet.fouls))
    parts = [*halls.handicap(contest.terms, index, w), *parts]
    if match.at != index or match.finished:
        return " · ".join(parts), None
    if contest.level is not None and not sight.session.moving and sight.mode == "aim":
        return _thought(contest, w, short=bool(plate_balls.of(contest, index))), ACCENT
    if contest.closing:
        last = contest.terms.finish == LAST_POINT_3C
        return w["score.last" if last else "score.extra"], ACCENT
    if match.run and racked is None:
        parts.insert(0, w["score.run"].format(n=match.run))
    return " · ".join([*rack_words.zones(match, w), *parts]), None


def _thought(contest: Contest, w: dict[str, str], *, short: bool) -> str:
    if contest.share is None or (short and contest.thinking):
        return w["score.thinking"]
    key = "score.thinks" if contest.thinking else "score.intends"
    return w[key].format(n=round(100 * contest.share))


def _alone(surface: pygame.Surface, rect: pygame.Rect, sight: Sight, contest: Contest) -> None:
    """Draw the numbers of a player who plays alone where the other player's plate would be."""
    s, t, w = sight.layout.s, sight.type, sight.words
    cards.card(surface, rect, s)
    sheet = contest.match.sheets[0]
    values = {
        "run": contest.match.run,
        "best": sheet.best,
        "fouls": sheet.fouls,
        "strokes": sheet.strokes,
    }
    step = rect.w / len(values)
    for i, (name, value) in enumerate(values.items()):
        middle = rect.x + (i + 0.5) * step
        label = t.fitted(w[f"alone.{name}"], 12, step - 6 * s)
        t.draw(surface, label, (middle, rect.y + 18 * s), 12, TEXT_SOFT, "centre")
        t.draw(surface, str(value), (middle, rect.y + 40 * s), 20, TEXT, "centre")


# -- the last stroke -----------------------------------------------------------------------------


def result(contest: Contest, verdict: Verdict, sight: Sight) -> Result:
    """Badge, two lines and the badge's colour for the last stroke."""
    w, match, index = sight.words, contest.match, contest.shooter
    first, (badge, tone) = reason(verdict, w), counted(verdict)
    if not contest.terms.discipline.position:
        return badge, first, " · ".join(rack_words.facts(contest, verdict, w)), tone
    if verdict.won:
        name = player_name(contest.terms, index, w)
        sheet = match.sheets[index]
        said = _counted("fact.innings", sheet.innings, w)
        said += " · " + w["score.average"].format(n=number(sheet.average))
        return badge, w["score.wins"].format(name=name), f"{said} · {first}", tone
    return badge, first, " · ".join(_facts(contest, verdict, w)), tone


def counted(verdict: Verdict) -> tuple[str, Colour]:
    """Badge and its colour for what a stroke counts."""
    if verdict.foul:
        counts = verdict.points or verdict.reason in COUNTED
        return number(verdict.points, 0) if counts else "F", ERROR
    if verdict.made:
        return f"+{verdict.points}" if verdict.points else "○", GOOD
    return "0", TEXT


def _facts(contest: Contest, verdict: Verdict, w: dict[str, str]) -> list[str]:
    match, index = contest.match, contest.shooter
    sheet, target = match.sheets[index], match.players[index].target
    if verdict.made:
        return [
            w["fact.count"].format(score=sheet.score, target=target),
            w["fact.run"].format(n=match.run),
        ]
    passes = w["fact.passes" if len(match.players) > 1 else "fact.inning"]
    said = [passes] if verdict.passes else [w["fact.same"]]
    if verdict.facts.cushions and not verdict.foul:
        said.append(_counted("fact.cushions", verdict.facts.cushions, w))
    return said


def _counted(key: str, n: int, w: dict[str, str]) -> str:
    """Say a number of something, with the singular where a language has one."""
    return (w.get(f"{key}.{n}") or w[key]).format(n=n)


def reason(verdict: Verdict, w: dict[str, str]) -> str:
    """Say why a stroke counted what it did; a cue ball that is lost may have left the table."""
    left = verdict.reason == SCRATCH and CUE in verdict.facts.off
    key = OFF_TABLE if left else verdict.reason
    return _counted(f"reason.{key}", verdict.facts.cushions, w)
