"""What the coach says about a way to score, in one line."""

from __future__ import annotations

from game.aim.advice import NONE, Advice
from game.ui.table.looks import ball_words


def said(way: Advice, w: dict[str, str]) -> str:
    """The number of the way, its share, how full the first ball is hit and where the tip is."""
    named = {"place": way.place, "count": way.ways, "share": way.share}
    return w["coach.found"].format(**named, hit=_hit(way, w), tip=_tip(way, w))


def _hit(way: Advice, w: dict[str, str]) -> str:
    if way.ball == NONE:
        return w["coach.hit.none"]
    ball = ball_words(way.ball, w)
    if way.side == "full":
        return w["coach.hit.full"].format(ball=ball)
    eighths = way.eighths or "<1"
    return w["coach.hit"].format(ball=ball, eighths=eighths, side=w[f"coach.{way.side}"])


def _tip(way: Advice, w: dict[str, str]) -> str:
    if not way.hour:
        return w["coach.tip.centre"]
    return w["coach.tip"].format(hour=way.hour)
