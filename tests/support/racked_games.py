"""Games with pockets for tests: a session in a match, and players without a window."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from random import Random

from danggu.players.minds import mind
from game.session import terms
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.table import presets
from physics import Placed

RACKED = tuple(name for name, one in terms.DISCIPLINES.items() if one.rules and not one.position)
LEVEL = terms.SKILLS["club"]


def playing(game: str, **more: object) -> Session:
    """A session in a match of that game between two people."""
    session = Session(presets.table_world("medium"))
    wanted = terms.Terms(game, table=terms.DISCIPLINES[game].table, **more)
    perform(session, Action("match", wanted.line()))
    return session


def stroke(session: Session, line: str) -> None:
    """Play five numbers, and wait for the balls."""
    perform(session, Action("play", line))
    perform(session, Action("skip"))


def leave(session: Session, **places: tuple[float, float]) -> None:
    """Lay these balls there, take every other one off, and let the state of the game know it."""
    world, contest = session.world, session.contest
    layout = [
        Placed(complex(*places[_key(ball.name)]))
        if _key(ball.name) in places
        else ball.placed._replace(height=-2.0)
        for ball in world.balls
    ]
    session.put(layout)
    state = contest.match.state
    left = tuple(name for name in contest.match.rules.start(2).left if _key(name) in places)
    contest.match = replace(contest.match, state=replace(state, left=left, phase="", region=""))
    session.lies = world.layout()


def _key(name: str) -> str:
    return f"b{name}" if name.isdigit() else name


def played(session: Session, seed: int, most: int) -> Iterator[str]:
    """Let a club player play both sides: what happened, stroke by stroke, at most so often."""
    rng, contest = Random(seed), session.contest
    for number in range(most):
        if contest.over:
            return
        if contest.between:
            perform(session, Action("next"))
        elif contest.match.asked is not None:
            key = rng.choice(contest.match.asked.options).key
            perform(session, Action("answer", key))
            yield f"answer {key}"
        else:
            thinker = mind(session.world.copy(), contest.match, LEVEL, number, 24)
            while not thinker.think(1.0):
                pass
            plan = thinker.played(rng)
            if plan.place is not None:
                perform(session, Action("put", f"{plan.place[0]!r} {plan.place[1]!r}"))
            if plan.call.ball:
                perform(session, Action("call", f"ball {plan.call.ball}"))
            shot = plan.shot
            numbers = shot.speed, shot.follow, shot.masse, shot.side, shot.angle
            stroke(session, " ".join(f"{n:.4f}" for n in numbers))
            yield contest.verdict.reason
