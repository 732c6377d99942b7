"""What is kept of a match: after each stroke how it stands, at its end the figures."""

from __future__ import annotations

import os
from pathlib import Path

from game.session import saved, scorecard
from game.session.running_match import Contest
from game.session.session import Session
from game.session.terms import HUMAN

from .kept_matches import KeptMatches
from .statistics import Statistics, kept_name


class Keeper:
    """Looks at a session after each thing that happens; without a folder it keeps nothing."""

    def __init__(self, session: Session, folder: Path | None) -> None:
        self.session = session
        self.own = os.urandom(8).hex()
        """Under which this game's match is kept: two games at once keep two."""
        self.matches = KeptMatches(folder / "matches.json" if folder else None)
        self.statistics = Statistics(folder / "statistics.json" if folder else None)
        self._seen: tuple[object, ...] = ()
        self._kept = False
        self._told = False

    @property
    def keeps(self) -> bool:
        """Is there a folder to keep anything in?"""
        return self.matches.path is not None

    def note(self) -> None:
        """Save the match if it has gone on, add it to the figures if it is over."""
        session, contest = self.session, self.session.contest
        if not self.keeps or contest is None or session.moving or contest.pending:
            return
        seen = id(contest), contest.match, contest.race
        if seen == self._seen:
            return
        fresh, self._seen = self._seen[:1] != seen[:1], seen
        if contest.over:
            if self._kept:
                self.statistics.add(contest.terms.game, figures(contest))
                self.matches.drop(self.own)
            self._kept = False
        elif contest.card or not fresh:
            text = saved.written(contest, session.world, session.shots)
            if not self._kept:
                self.matches.taken_up(text, self.own)
            self._kept = self.matches.put(self.own, text)
            self._tell()

    def _tell(self) -> None:
        """Say once in the window that matches cannot be kept."""
        if not self._kept and not self._told:
            self._told = True
            self.session.say("match.unsaved", error=True)

    def offered(self) -> tuple[str, ...]:
        """The lines of the matches that can be gone on with, the newest first."""
        return self.matches.lines() if self.keeps else ()


def figures(contest: Contest) -> dict[str, tuple[scorecard.Totals, bool]]:
    """What each person has done in a match, by name."""
    won = contest.match.winner if contest.race.winner is None else contest.race.winner
    return {
        kept_name(seat.name, index): (scorecard.totals(contest.card, index), won == index)
        for index, seat in enumerate(contest.terms.seats)
        if seat.level == HUMAN
    }
