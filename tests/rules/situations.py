"""The situation of a rule case, read into a match that stands so."""

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from danggu.rules import GAMES, balkline, snooker
from danggu.rules.carom import Carom
from danggu.rules.eight_ball import GROUPS
from danggu.rules.match import Match, Player, Sheet
from danggu.rules.state import ANYWHERE, AS_IT_LIES, KITCHEN, PLAY, SECOND, Call, D
from danggu.rules.stroke import Act, Rest, Stroke, Zone
from danggu.rules.verdict import Rules

REGIONS = {"anywhere": ANYWHERE, "behind head string": KITCHEN, "D": D, "none": AS_IT_LIES}
ALIASES = {
    "4-ball": "four-ball",
    "sagu": "four-ball",
    "straight-pool": "14.1",
    "pyramid": "free-pyramid",
    "russian-pyramid": "free-pyramid",
}
SECONDS = ("legal break", "break")


def rules_of(name: str, said: dict[str, Any]) -> Rules:
    """The rules of a game as the cases name it; ValueError for one that there is not."""
    key = name.replace(" ", "-")
    key = ALIASES.get(key, key)
    if key not in GAMES:
        raise ValueError(f"there is no game {name!r}")
    made = GAMES[key]
    options: dict[str, Any] = {}
    if key in ("three-cushion", "one-cushion"):
        options = {"umb": True}
    for option in ("edition", "penalty", "early", "miss"):
        if option in said and option in getattr(made, "__dataclass_fields__", {}):
            options[option] = said[option]
    return made(**options)


def match_of(name: str, said: dict[str, Any]) -> Match:
    """The match before the stroke."""
    rules = rules_of(name, said)
    target = said.get("target")
    match = Match.of(rules, Player("striker", target), Player("other", target))
    other = said.get("opponent_score", said.get("opponent", 0))
    scores = said.get("scores", (said.get("score", 0), other))
    strokes = int("opening" not in said)
    sheets = tuple(Sheet(score=score, strokes=strokes, innings=strokes) for score in scores)
    match = replace(match, sheets=sheets)
    state = match.state
    if not isinstance(rules, Carom):
        state = replace(state, phase=PLAY, region=AS_IT_LIES)
    match = replace(match, state=state)
    for key, read in READERS.items():
        if key in said:
            match = read(match, said[key], said)
    if name == "snooker":
        match = _snooker(match, said)
    return match


# -- pool ------------------------------------------------------------------------------------------


def _shot(match: Match, value: str, said: dict[str, Any]) -> Match:
    if "break" in value:
        start = match.rules.start(2)
        return replace(match, state=start)
    if value == "push out":
        phase = PLAY if "foul" in str(said.get("after")) else SECOND
        pushed = replace(match.call, push=True)
        return replace(match, state=replace(match.state, phase=phase), call=pushed)
    if value == "safety":
        return replace(match, call=replace(match.call, safety=True))
    return match


def _after(match: Match, value: str, said: dict[str, Any]) -> Match:
    if value in SECONDS and said.get("shot", "") != "break":
        return replace(match, state=replace(match.state, phase=SECOND))
    return match


def _called(match: Match, value: str | None, said: dict[str, Any]) -> Match:
    if value in ("safety", "push out"):
        return _shot(match, str(value), said)
    ball, _, pocket = (value or "").partition("^")
    return replace(match, call=replace(match.call, ball=ball, pocket=pocket))


def _lowest(match: Match, value: str, said: dict[str, Any]) -> Match:
    left = tuple(ball for ball in match.rules.balls if ball.isdigit() and int(ball) >= int(value))
    return replace(match, state=replace(match.state, left=left))


def _group(match: Match, value: str | None, said: dict[str, Any]) -> Match:
    other = "stripes" if value == "solids" else "solids"
    groups = (value, other) if value else ()
    return replace(match, state=replace(match.state, groups=groups))


def _left(match: Match, value: list[str], said: dict[str, Any]) -> Match:
    """The balls left; in 8-ball those of the player's group, beside the others and the 8."""
    group = said.get("group")
    others = [ball for ball in match.rules.balls[1:] if ball not in GROUPS.get(group or "", ())]
    left = [*value, *others] if group else [*value]
    return replace(match, state=replace(match.state, left=tuple(left)))


def _fouls(match: Match, value: int, said: dict[str, Any]) -> Match:
    warned = (bool(said.get("warned")), False)
    return replace(match, state=replace(match.state, fouls=(value, 0), warned=warned))


def _region(match: Match, value: str, said: dict[str, Any]) -> Match:
    if value in REGIONS:
        return replace(match, state=replace(match.state, region=REGIONS[value]))
    if value in match.rules.cues:
        return replace(match, at=match.rules.cues.index(value))
    return match


# -- carom and pyramid -----------------------------------------------------------------------------

STATES = {
    "come in": balkline.COME_IN,
    "in there": balkline.IN_THERE,
    "astride": balkline.ASTRIDE,
}


def _state(match: Match, value: str | None, said: dict[str, Any]) -> Match:
    return replace(match, state=replace(match.state, zone=_zone(value)))


def _anchor(match: Match, value: str | None, said: dict[str, Any]) -> Match:
    return replace(match, state=replace(match.state, anchor=_zone(value)))


def _zone(value: str | None) -> str:
    return next((zone for said, zone in STATES.items() if (value or "").startswith(said)), "")


# -- snooker ---------------------------------------------------------------------------------------


def _snooker(match: Match, said: dict[str, Any]) -> Match:
    after_red = said.get("after") in ("red", "a red")
    on = said.get("on") or (snooker.COLOUR if after_red else snooker.RED)
    reds = said.get("reds", 0 if on in snooker.COLOURS else snooker.REDS)
    first = snooker.COLOURS.index(on) if on in snooker.COLOURS and not reds else 0
    left = (*(f"red{n}" for n in range(1, reds + 1)), *snooker.COLOURS[first:])
    left = tuple(said.get("left", left))
    free = said.get("free_ball") or ""
    pairs = tuple(("cue", ball) for ball in _names(said.get("touching")) if ball != "cue")
    state = replace(match.state, on=on, left=left, free=bool(free), touching=pairs)
    named = free if isinstance(free, str) and free else said.get("nominated") or ""
    return replace(match, state=state, call=Call(ball=named))


def _names(value: Any) -> tuple[str, ...]:
    return (value,) if isinstance(value, str) else tuple(value if isinstance(value, list) else ())


# -- the stroke ------------------------------------------------------------------------------------


def seen(done: Stroke, said: dict[str, Any], remarks: list[str]) -> Stroke:
    """The stroke with what the situation and the remarks say of it beside the events."""
    acts = [*done.acts, *(Act(ball, "moving") for ball in _names(said.get("moving")))]
    zone, anchor = _lies(said, remarks)
    after = str(said.get("after", ""))
    hidden = re.search(r"snookered .*by the (\w+)", after)
    snookered = bool(said.get("snookered")) or (bool(hidden) and not said.get("free_ball"))
    rest = Rest((), snookered, hidden[1] if hidden else "", zone, anchor)
    return replace(done, acts=tuple(acts), rest=rest)


def _lies(said: dict[str, Any], remarks: list[str]) -> tuple[Zone, Zone]:
    """How the object balls lie: as they lay, unless a remark says that they left or came."""
    text = " ".join(remarks)
    apart = Zone()
    inside = bool(said.get("state") or said.get("state_anchor") or text)
    if "astride" in text or (not text and said.get("state") == "astride"):
        return Zone(balkline.ASTRIDE), apart
    if "return" in text or "come" in text or "enter" in text:
        zone = Zone(balkline.IN, left=True)
    elif "leave" in text or "out" in text or not inside:
        zone = apart
    else:
        zone = Zone(balkline.IN, left=False)
    return (apart, zone) if "anchor" in text or "state_anchor" in said else (zone, apart)


Reader = Callable[[Match, Any, dict[str, Any]], Match]

READERS: dict[str, Reader] = {
    "lowest": _lowest,
    "group": _group,
    "left": _left,
    "shot": _shot,
    "after": _after,
    "called": _called,
    "fouls": _fouls,
    "cue": _region,
    "in_hand": _region,
    "state": _state,
    "state_anchor": _anchor,
}
KNOWN = {
    *READERS, "warned", "score", "opponent_score", "opponent", "scores", "target", "table",
    "frozen", "opening", "moving", "touching", "on", "nominated", "reds", "free_ball", "snookered",
    "zone", "edition", "penalty", "early", "miss", "any_ball_is_cue", "note", "off", "choice",
    "moment", "place", "break_ball", "foot_spot", "head_spot", "centre_spot", "occupied", "respot",
}  # fmt: skip
