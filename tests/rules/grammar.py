"""The events of a rule case as they are written, read into a stroke.

a>b first and further contacts of ball a with b; a>b+c at one instant; a| or a|N a cushion; a^NE
pocketed; a@off left the table; a:word something else.  What is in brackets says more of the event
before it, or of how the balls come to lie.
"""

import re
from dataclasses import dataclass, field, replace
from math import inf

from danggu.rules.stroke import Act, Stroke, stroke
from tests.support.event_log import BEAT, FakeEvent

NAME = r"[A-Za-z0-9_]+"
EVENT = re.compile(
    rf"(?P<ball>{NAME})(?:"
    rf">(?P<hits>{NAME}(?:\+{NAME})*)"
    rf"|\|(?P<wall>{NAME})?"
    rf"|\^(?P<pocket>{NAME})?"
    r"|@(?P<off>off)"
    rf"|:(?P<word>{NAME}))"
)
TOKEN = re.compile(r"\([^()]*\)|[^\s()]+")


@dataclass
class Written:
    """What the events of a case say: a log, what a referee saw, and remarks in brackets."""

    log: list[FakeEvent] = field(default_factory=list)
    acts: list[Act] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)

    def stroke(self, cue: str) -> Stroke:
        """The stroke, seen from the ball that was played."""
        return replace(stroke(self.log, cue), acts=tuple(self.acts))


def read(events: list[str], frozen: dict[str, str] | None = None) -> Written:
    """The events, in order, a beat apart; ValueError names what cannot be read.

    frozen  balls that touch a cushion as the stroke begins, and which
    """
    written, lies = Written(), dict(frozen or {})
    time = 0.0
    tokens = TOKEN.findall(" ".join(events))
    for at, token in enumerate(tokens):
        if token.startswith("("):
            written.remarks.append(token.strip("()"))
            continue
        found = EVENT.fullmatch(token)
        if found is None:
            raise ValueError(f"{token!r} is no event")
        remark = tokens[at + 1].strip("()") if tokens[at + 1 : at + 2] else ""
        follows = tokens[at + 1 : at + 2] and tokens[at + 1].startswith("(")
        time += BEAT
        _write(written, found, time, lies, remark if follows else "")
    return written


def _write(
    written: Written, found: re.Match[str], time: float, lies: dict[str, str], remark: str
) -> None:
    ball = found["ball"]
    if found["hits"]:
        for other in found["hits"].split("+"):
            written.log.append(FakeEvent(time, "ball", (ball, other)))
    elif found["off"]:
        written.log.append(FakeEvent(time, "off", (ball,)))
    elif found["word"]:
        written.acts.append(Act(ball, found["word"], remark))
    elif "^" in found[0]:
        written.log.append(FakeEvent(time, "pocket", (ball,), found["pocket"] or ""))
    else:
        away = _away(lies.pop(ball, None), found["wall"], remark)
        written.log.append(FakeEvent(time, "cushion", (ball,), found["wall"] or "some", away))


def _away(lies: str | None, wall: str | None, remark: str) -> float:
    """0 for a ball pressed into the cushion that it lies against, unless a massé took it off."""
    lifted = "massé" in remark and "no massé" not in remark
    return 0.0 if lies is not None and lies == wall and not lifted else inf
