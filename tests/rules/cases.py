"""Rule cases: `python -m tests.rules.cases FILE` plays each and prints those that fail.

Exits 0 if all hold, 1 if one does not, 2 if the file cannot be read.
"""

import json
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from danggu.rules import balkline, snooker
from danggu.rules import straight_pool as straight
from danggu.rules.carom import RESPOT
from danggu.rules.match import Match
from danggu.rules.nine_ball import SECOND
from danggu.rules.reasons import ILLEGAL_BREAK
from danggu.rules.spots import carom_spots, colour_spots, respotted
from danggu.rules.state import BREAK
from danggu.rules.verdict import Verdict

from .grammar import read
from .situations import KNOWN, REGIONS, STATES, match_of, seen

OPTIONS = {
    "accept": "accept table",
    "rerack": "rerack and break",
    "rerack_offender": "rerack, offender breaks",
    "spot_and_accept": "spot 8 and accept",
    "rebreak": "re-break",
    "spot_in_hand": "spot 8, cue ball in hand behind head string",
    "in_hand_head": "cue ball in hand behind head string",
    "break_again": "make offender break again",
    "shoot": "shoot",
    "offender_again": "make the offender shoot",
    "play_on": "play",
    "put_in_again": "make the offender play again",
    "replay": "replace the balls and make the offender play again",
}
FOULS = {
    straight.BREAKING_FOUL: "breaking",
    straight.SERIOUS_FOUL: "serious",
    balkline.REMAINED: "remaining in there",
}
PLACES = {
    "pocketed": straight.DOWN,
    "in rack": straight.RACK,
    "in the rack": straight.RACK,
    "head spot": straight.HEAD,
    "not behind head string": straight.ELSEWHERE,
    "behind head string": straight.KITCHEN,
    "elsewhere": straight.ELSEWHERE,
}
SPOTS = {
    straight.FOOT: "foot spot",
    straight.CENTRE: "centre spot",
    straight.HEAD: "head spot",
    straight.STAYS: "as is",
    straight.KITCHEN: "in hand behind head string",
}
WORSE = "counts as in the same zone: the case that is worse for the player"

Case = dict[str, Any]


class UnreadableError(Exception):
    """A file that holds no cases."""


@dataclass
class Played:
    """A stroke of a case: the match before, the verdict, and the match after."""

    before: Match
    verdict: Verdict
    after: Match


def played(case: Case) -> Played:
    """The case's stroke, judged; ValueError for what cannot be read."""
    said = case["situation"]
    match = match_of(case["game"], said)
    written = read(case["stroke_events"], said.get("frozen"))
    verdict = match.ruled(seen(written.stroke(match.cue), said, written.remarks))
    return Played(match, verdict, match.after(verdict))


# -- what is expected ------------------------------------------------------------------------------


def _turn(p: Played, want: Any) -> Any:
    asked, own = p.after.asked, p.after.at == p.before.at
    chosen = f"choice of {'breaker' if own else 'opponent'}"
    plain = "same" if own else "opponent"
    goes_on = asked is not None and (asked.optional or asked.shooter)
    if asked is None or (goes_on and want == plain):
        return plain
    return chosen


def _foul(p: Played, want: Any) -> Any:
    if isinstance(want, bool):
        return p.verdict.foul
    if isinstance(want, int):
        return p.verdict.gift or max(-p.verdict.points, 0)
    return FOULS.get(p.verdict.reason, "standard" if p.verdict.foul else False)


def _options(p: Played, want: Any) -> Any:
    return sorted(OPTIONS.get(o.key, o.key) for o in p.after.asked.options) if p.after.asked else []


def _next(p: Played, want: Any) -> Any:
    who = "offender" if p.after.at == p.before.at else "opponent"
    return f"the {who} plays {'an opening break' if p.after.state.phase == BREAK else 'on'}"


def _state(zone: str) -> Any:
    return {value: said for said, value in STATES.items()}.get(zone)


def _counts(p: Played, want: Any) -> Any:
    return p.after.state.fouls[p.before.at] > p.before.state.fouls[p.before.at]


def _reds(p: Played, want: Any) -> Any:
    return sum(snooker.kind(ball) == snooker.RED for ball in p.after.state.left)


FOUND: dict[str, Callable[[Played, Any], Any]] = {
    "turn": _turn,
    "foul": _foul,
    "options": _options,
    "next": _next,
    "counts_to_three": _counts,
    "reds": _reds,
    "points": lambda p, want: p.verdict.points,
    "score": lambda p, want: p.after.sheets[p.before.at].score,
    "opponent_points": lambda p, want: p.verdict.gift,
    "opponent_score": lambda p, want: p.after.sheets[p.before.next].score,
    "penalty": lambda p, want: p.verdict.gift,
    "won": lambda p, want: p.after.winner == p.before.at,
    "lost": lambda p, want: p.after.winner == p.before.next,
    "drawn": lambda p, want: p.after.over,
    "over": lambda p, want: p.after.finished,
    "spot": lambda p, want: sorted(p.verdict.spot),
    "down": lambda p, want: sorted(p.verdict.down),
    "in_hand": lambda p, want: {v: k for k, v in REGIONS.items()}.get(p.after.state.region),
    "table": lambda p, want: "open" if not p.after.state.groups else "closed",
    "group": lambda p, want: p.after.state.group(p.before.at) or None,
    "illegal_break": lambda p, want: p.verdict.reason == ILLEGAL_BREAK,
    "fouls": lambda p, want: p.after.state.fouls[p.before.at],
    "warned": lambda p, want: p.after.state.warned[p.before.at],
    "rerack": lambda p, want: p.verdict.rack,
    "push_out_allowed": lambda p, want: p.after.state.phase == SECOND,
    "on": lambda p, want: p.after.state.on,
    "free_ball": lambda p, want: p.after.state.free,
    "state": lambda p, want: _state(p.after.state.zone),
    "state_anchor": lambda p, want: _state(p.after.state.anchor),
}


def found(case: Case, want: dict[str, Any]) -> dict[str, Any]:
    """What the rules say of a stroke, for each key that is expected."""
    p = played(case)
    unknown = set(want) - set(FOUND)
    if unknown:
        raise ValueError(f"nothing is expected by the name of {min(unknown)!r}")
    return {key: FOUND[key](p, value) for key, value in want.items()}


# -- moments without a stroke ----------------------------------------------------------------------


def racking(case: Case) -> dict[str, Any]:
    """Where the last two balls go when fourteen are racked."""
    said = case["situation"]
    last, cue = straight.racked(_place(said["break_ball"]), _place(said["cue"]))
    fifteen = ", fifteen balls racked" if said["break_ball"] == "pocketed" else ""
    return {"break_ball": SPOTS[last] + fifteen, "cue": SPOTS[cue]}


def _place(said: str) -> str:
    for part, place in PLACES.items():
        if part in said:
            return place
    raise ValueError(f"no such place: {said!r}")


def spotting(case: Case) -> dict[str, Any]:
    """Where balls go in three-cushion that have left the table or touch."""
    said = case["situation"]
    cue = said.get("cue", "white")
    other = "yellow" if cue == "white" else "white"
    spots = carom_spots(cue, other)
    said_of = {spot: said.get(f"{spot}_spot") for spot in spots.values()}
    covered = {spot: by.removeprefix("covered by ") for spot, by in said_of.items() if by}
    balls = said.get("off") or (said["touching"] if said.get("choice") == RESPOT else [])
    place = respotted(balls, spots, covered)
    return {
        "place": {ball: SPOTS[spot] for ball, spot in place.items()},
        "as_is": sorted(set(spots) - set(place)),
    }


def on_a_line(case: Case) -> dict[str, Any]:
    """A ball exactly on a line of balkline, and another one in the zone beside it."""
    areas = balkline.squares(2.84, 1.42, 0.47)
    line = -0.71 + 0.47
    zone = balkline.zone(areas, [(0.0, line)], [(0.1, line + 0.1)])
    other = balkline.zone(areas, [(0.0, line)], [(0.1, line - 0.1)])
    same = zone.ends == other.ends == balkline.IN
    return {"state": WORSE if same else "counts as in the other zone"}


def after_foul(case: Case) -> dict[str, Any]:
    """A foul in snooker, with a snooker left or not; the offender may have to play again."""
    said = case["situation"]
    again = "again" in said["after"]
    match = match_of("snooker", {"on": "red"})
    hidden = again or said.get("snookered", "snookered" in said["after"])
    fouled = match.ruled(seen(read(["cue>blue"]).stroke("cue"), {"snookered": hidden}, []))
    match = match.after(fouled)
    if again:
        match = match.answered(snooker.PUT_IN)
    return {"free_ball": match.state.free}


def respotting(case: Case) -> dict[str, Any]:
    """Where colours go whose spots may be occupied."""
    said = case["situation"]
    taken = [str(spot).removesuffix(" spot") for spot in said.get("occupied", [])]
    place = colour_spots(said["respot"], taken)
    near = "as near as possible to its own spot"
    return {"place": {ball: f"{spot} spot" if spot else near for ball, spot in place.items()}}


def moment(case: Case) -> Callable[[Case], dict[str, Any]] | None:
    """What answers a case without a stroke."""
    said, game = case["situation"], case["game"]
    if game == "14.1" and "break_ball" in said:
        return racking
    if game == "three-cushion" and ("off" in said or "touching" in said):
        return spotting
    if game.startswith("balkline") and "exactly on a line" in str(said.get("place")):
        return on_a_line
    if game == "snooker" and "respot" in said:
        return respotting
    if game == "snooker" and str(said.get("after")).startswith("foul"):
        return after_foul
    return None


# -- the file --------------------------------------------------------------------------------------


def wrong(case: Case) -> str:
    """Why a case fails, or ""."""
    want = {key: value for key, value in case["expected"].items() if key != "note"}
    try:
        answer = None if case["stroke_events"] else moment(case)
        got = answer(case) if answer else found(case, want)
    except (ValueError, KeyError, TypeError, AttributeError, IndexError) as error:
        return f"{type(error).__name__}: {error}"
    want = {k: sorted(v, key=str) if isinstance(v, list) else v for k, v in want.items()}
    return "; ".join(
        f"{key} is {got.get(key)!r}, not {value!r}"
        for key, value in want.items()
        if key not in got or got[key] != value or type(got[key]) is not type(value)
    )


def cases(path: Path) -> list[Case]:
    """The cases of a file; UnreadableError says what is wrong with it."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise UnreadableError(f"{path}: {error.strerror}") from None
    except (ValueError, RecursionError) as error:
        raise UnreadableError(f"{path}: no JSON: {error}") from None
    listed = data.get("cases") if isinstance(data, dict) else data
    if not isinstance(listed, list) or not listed:
        raise UnreadableError(f"{path}: there is no list of cases")
    for number, case in enumerate(listed, 1):
        _check(path, number, case)
    return listed


SHAPE = {"id": str, "game": str, "situation": dict, "stroke_events": list, "expected": dict}


def _check(path: Path, number: int, case: Any) -> None:
    if not isinstance(case, dict):
        raise UnreadableError(f"{path}: case {number} is no object")
    for key, kind in SHAPE.items():
        if not isinstance(case.get(key), kind):
            name = case.get("id", number)
            raise UnreadableError(f"{path}: case {name} needs {key!r}, a {kind.__name__}")
    if not all(isinstance(event, str) for event in case["stroke_events"]):
        raise UnreadableError(f"{path}: case {case['id']}: an event is a string")


def main(arguments: list[str]) -> int:
    """Play the cases of the files; the exit status."""
    if len(arguments) != 1:
        print("usage: python -m tests.rules.cases FILE", file=sys.stderr)
        return 2
    try:
        listed = cases(Path(arguments[0]))
    except UnreadableError as error:
        print(error, file=sys.stderr)
        return 2
    failed = [(case["id"], why) for case in listed if (why := wrong(case))]
    for case in listed:
        for key in set(case["situation"]) - KNOWN:
            print(f"{case['id']}: {key!r} of the situation is not known and was left out")
    for name, why in failed:
        print(f"{name}: {why}")
    print(f"{len(listed) - len(failed)} of {len(listed)} cases hold, {len(failed)} fail")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
