"""A match that can be gone on with: its terms, how it stands, and the balls to the last bit."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any, NamedTuple

from danggu.rules.lag import Lag
from danggu.rules.match import Match, Sheet
from danggu.rules.race import Race
from danggu.rules.state import Call, GameState, Question
from physics import Placed, World

from .packing import packed, unpacked
from .running_match import Contest
from .scorecard import Visit
from .terms import Terms
from .terms import read as terms_of


class Kept(NamedTuple):
    """How a match stands, without its rules and players, which its terms have."""

    sheets: tuple[Sheet, ...]
    at: int
    visit: int
    run: int
    winner: int | None
    over: bool
    state: GameState
    call: Call
    asked: Question | None
    reached: tuple[int, ...]
    race: Race
    card: tuple[Visit, ...]
    balls: tuple[str, ...]
    layout: tuple[Placed, ...]
    lies: tuple[Placed, ...] | None
    lag: tuple[Lag, ...] | None
    shots: int


class SavedMatch(NamedTuple):
    """A saved match that has been read."""

    terms: Terms
    kept: Kept

    @property
    def standing(self) -> Match:
        """The match as it stood."""
        own = {name: getattr(self.kept, name) for name in KEPT}
        return replace(self.terms.match(), **own)


KEPT = ("sheets", "at", "visit", "run", "winner", "over", "state", "call", "asked", "reached")


def written(contest: Contest, world: World, shots: int) -> str:
    """The match in one line of text; only while the balls lie still."""
    own: dict[str, Any] = {name: getattr(contest.match, name) for name in KEPT}
    names = tuple(ball.name for ball in world.balls)
    places = {"balls": names, "layout": world.layout(), "lies": contest.lies}
    own |= {name: getattr(contest, name) for name in ("lag", "race", "card")}
    own |= {"shots": shots, **places}
    kept = Kept(**own)
    data = {"terms": json.loads(contest.terms.line()), "kept": packed(kept)}
    return json.dumps(data, ensure_ascii=False, separators=(",", ":"))


def read(text: str) -> SavedMatch:
    """What `written` wrote; ValueError, saying what is wrong, for anything else."""
    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        raise ValueError("a saved match is written as JSON") from None
    if not isinstance(data, dict) or {*data} != {"terms", "kept"}:
        raise ValueError("a saved match has terms, and how it stands")
    terms = terms_of(json.dumps(data["terms"]))
    try:
        found = SavedMatch(terms, unpacked(Kept, data["kept"]))
    except RecursionError:
        raise ValueError("a saved match is not that deep") from None
    _check(found)
    return found


def _check(found: SavedMatch) -> None:
    """ValueError for what does not belong together."""
    terms, kept = found.terms, found.kept
    if terms.game == "free":
        raise ValueError("the free table has no match")
    players, names = len(terms.seats), {ball.name for ball in terms.world().balls}
    if {*kept.balls} != names or len(kept.balls) != len(names):
        raise ValueError("the balls are not those of the game")
    layouts = [kept.layout] if kept.lies is None else [kept.layout, kept.lies]
    if any(len(layout) != len(names) for layout in layouts):
        raise ValueError("there is not a place for each ball")
    if len(kept.sheets) != players or len(kept.race.won) != players:
        raise ValueError("the sheets are not those of the players")
    if not 0 <= kept.at < players or kept.winner not in (None, *range(players)):
        raise ValueError(f"there is no player {kept.at} or {kept.winner}")
    if not {*kept.state.left} <= names:
        raise ValueError("a ball is said to be left that the game has not")
    if not {ball for visit in kept.card for ball in visit.balls} <= names:
        raise ValueError("a ball is said to have been potted that the game has not")
    far = max(terms.world().table.length, 1.0)
    for placed in (*kept.layout, *(kept.lies or ())):
        if not abs(placed.position) < far or placed.velocity or placed.roll or placed.climb:
            raise ValueError("a ball does not lie still on the table")
