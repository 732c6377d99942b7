"""What plates and cards say of games with racks: racks and frames, groups, breaks, balls down."""

from __future__ import annotations

from collections.abc import Sequence

from danggu.rules.balkline import COME_IN, IN_THERE
from danggu.rules.match import Match
from danggu.rules.snooker import remaining
from danggu.rules.verdict import Verdict
from game.session import scorecard
from game.session.running_match import Contest
from game.session.session import Session
from game.ui.names import player_name
from game.ui.table.looks import ball_words

FRAMES = "snooker"


def middle(contest: Contest, w: dict[str, str]) -> tuple[str, str]:
    """What stands between the plates: the rack or the inning and its number, or the frame and the
    points that are left in it."""
    if contest.terms.discipline.points:
        return w["score.inning"], str(contest.match.inning)
    if contest.match.rules.key != FRAMES:
        return w["score.rack"], str(contest.rack)
    if contest.match.finished:
        return w["score.frame"], str(contest.rack)
    left = remaining(contest.match.state)
    return f"{w['score.frame']} {contest.rack}", w["score.left"].format(n=left)


def points(contest: Contest, index: int) -> tuple[int, str, int | None]:
    """A player's points, what is written beside them, and the goal of the bar if there is one."""
    sheet, race = contest.match.sheets[index], contest.race
    if contest.terms.discipline.points:
        target = contest.match.players[index].target
        return sheet.score, str(target), target
    if scores(contest):
        return sheet.score, f"({race.won[index]})", None
    return race.won[index], str(race.to), race.to if race.to > 1 else None


def scores(contest: Contest) -> bool:
    """Do points count within a rack?"""
    key = contest.match.rules.key
    return key == FRAMES or key.endswith("pyramid")


def won(contest: Contest, w: dict[str, str]) -> str:
    """What the winner's plate says; "" where the number of innings is said."""
    if contest.terms.discipline.points:
        return ""
    return w["score.frame.won" if contest.match.rules.key == FRAMES else "score.rack.won"]


def line(contest: Contest, index: int, w: dict[str, str]) -> list[str] | None:
    """What the plate says under a player's name; None for games that have no racks."""
    match = contest.match
    if contest.terms.discipline.position:
        return None
    sheet = match.sheets[index]
    found: list[str] = []
    if match.rules.key == "eight_ball":
        group = match.state.group(index)
        found.append(w[f"score.{group}" if group else "score.open.table"])
    if match.state.warned and match.state.warned[index]:
        return [*found, w["score.warned"]]
    ahead = lead(match, w) if match.at == index and match.rules.key == FRAMES else []
    if match.at == index and match.run and scores(contest):
        found += [w["score.break"].format(n=match.run), *ahead]
    elif ahead:
        found += ahead
    elif sheet.best:
        found.append(w["score.best.break"].format(n=sheet.best))
    own = scorecard.totals(contest.card, index)
    if own.strokes > own.spared:
        found.append(w["score.pots"].format(n=round(100 * own.share)))
    if sheet.fouls:
        found.append(w["score.fouls"].format(n=sheet.fouls))
    return found


def lead(match: Match, w: dict[str, str]) -> list[str]:
    """How far the player at the table is ahead or behind; nothing of equal scores, or alone."""
    ahead = match.turn.score - match.turn.against if len(match.players) > 1 else 0
    if not ahead:
        return []
    return [w["score.ahead" if ahead > 0 else "score.behind"].format(n=abs(ahead))]


def zones(match: Match, w: dict[str, str]) -> list[str]:
    """In balkline, where both balls lie in a zone or an anchor: by which stroke one must leave."""
    lies = (match.state.zone, "score.zone"), (match.state.anchor, "score.anchor")
    strokes = {COME_IN: 2, IN_THERE: 1}
    found = sorted((strokes[lie], key) for lie, key in lies if lie in strokes)
    return [(w.get(f"{key}.{n}") or w[key]).format(n=n) for n, key in found]


def facts(contest: Contest, verdict: Verdict, w: dict[str, str]) -> list[str]:
    """The second line of the card of the last stroke."""
    said, match = [], contest.match
    if verdict.gift:
        said.append(gift(contest, verdict, w))
    if verdict.down:
        said.append(w["fact.down"].format(balls=_names(verdict.down, w)))
    if verdict.spot:
        said.append(w["fact.spotted"].format(balls=_names(verdict.spot, w)))
    warned = match.state.warned
    if verdict.foul and warned and warned[contest.shooter]:
        return [*said, w["fact.warned"]]
    if match.finished and contest.terms.discipline.points:
        return said
    if match.finished:
        word = "fact.frames" if match.rules.key == FRAMES else "fact.racks"
        return [*said, w[word].format(won=" : ".join(map(str, contest.race.won)))]
    passes = "fact.passes" if match.at != contest.shooter else "fact.same"
    if match.at != contest.shooter and contest.in_hand and verdict.foul:
        return [*said, w[passes], w["fact.hand"]]
    return [*said, w[passes]]


def so_far(session: Session, w: dict[str, str]) -> tuple[str, str]:
    """What a stroke has brought by the moment on show: how many balls are down, and which."""
    events = session.timeline.events[: session.timeline.passed]
    down = [event.balls[0] for event in events if event.kind == "pocket"]
    if session.shooter in down:
        return str(len(down)), w["fact.cue_down"]
    said = w["fact.down"].format(balls=_names(down, w)) if down else w["fact.none_down"]
    return str(len(down)), said[:1].upper() + said[1:]


def gift(contest: Contest, verdict: Verdict, w: dict[str, str]) -> str:
    """How many points a foul gives, and to which player."""
    other = (contest.shooter + 1) % len(contest.terms.seats)
    return w["fact.gift"].format(n=verdict.gift, name=player_name(contest.terms, other, w))


def _names(names: Sequence[str], w: dict[str, str]) -> str:
    return ", ".join(name if name.isdigit() else ball_words(name, w) for name in names)
