"""How a Korean hall says a handicap (수지) of four-ball: ten for each point to be made."""

from __future__ import annotations

from game.session.terms import FOUR_BALL, Terms

TEN = 10


def said(points: int) -> str:
    """The handicap of so many points as it is said: 15 points are 150."""
    return str(points * TEN)


def handicap(terms: Terms, seat: int, w: dict[str, str]) -> list[str]:
    """What a player's plate says of the handicap: nothing in games where halls count points."""
    if terms.game != FOUR_BALL:
        return []
    return [w["hall.handicap"].format(hall=said(terms.seats[seat].target))]


def goal(terms: Terms, seat: int, w: dict[str, str]) -> str:
    """A player's goal in the menu: the points, and in four-ball the handicap."""
    points = terms.seats[seat].target
    if terms.game != FOUR_BALL:
        return str(points)
    return " · ".join([w["hall.points"].format(points=points), *handicap(terms, seat, w)])


def hint(terms: Terms, seat: int, w: dict[str, str]) -> str:
    """The foot of the menu while a handicap is typed: what it is in a hall."""
    points = terms.seats[seat].target
    return w["menu.hint.hall"].format(points=points, hall=said(points))
