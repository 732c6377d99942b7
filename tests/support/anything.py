"""A player that presses, drags, types and commands at random, on any table with any engine.

What must always hold: nothing is raised, every number stays finite, and undo gives back
the digits that were there before.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from math import inf, isfinite
from unittest.mock import patch

import pygame

from danggu.players import opponent
from game.aim.entry import Aim
from game.app import App
from game.input.key_tables import NAMES
from game.replay.script import parse
from game.session.action import Action
from game.session.terms import DISCIPLINES, GAMES, SEATS, Contestant, Terms
from game.session.ticks import TICKS
from game.settings.settings import CHOICES
from game.table import presets
from game.text import LANGUAGES
from game.ui.pages.shelf import laid
from physics import EventDriven, TimeStepping
from physics.engines.stepping import SCHEMES
from tests.support.players import FRAME, an_app, assert_same_as_anew

SIZES = [(640, 360), (700, 900), (1100, 400)]
PLAYED = [
    "shoot", "fire", "fire", "place", "stop", "retry", "undo", "undo", "redo", "engine", "engine",
    "skip", "pause", "frame", "back", "home", "arrange", "next", "centre", "clear", "enter", "both",
]  # fmt: skip
"""Actions without a value; those that move balls more often."""
CODES = [code for code in NAMES if code < 128] + [
    getattr(pygame, f"K_{name}")
    for name in ("LEFT", "RIGHT", "UP", "DOWN", "PAGEUP", "PAGEDOWN", "HOME", "END", "KP_ENTER")
] + [getattr(pygame, f"K_F{n}") for n in (1, 2, 3, 4, 5, 6, 10)]  # fmt: skip
MODS = [0] * 6 + [pygame.KMOD_SHIFT, pygame.KMOD_CTRL, pygame.KMOD_ALT, pygame.KMOD_CTRL | 1]
CHARACTERS = "0123456789.-+e,abcxyz가나ㅎ½\u2028 "
SEEN = [
    "WINDOWFOCUSLOST", "WINDOWFOCUSGAINED", "WINDOWLEAVE", "WINDOWENTER", "WINDOWMINIMIZED",
    "WINDOWRESTORED", "WINDOWHIDDEN", "WINDOWSHOWN", "WINDOWEXPOSED", "VIDEOEXPOSE",
]  # fmt: skip
SHOTS = [
    "speed 4 follow 1 masse 0 side 2 angle 34.5", "speed 50 follow 100 masse -100 side 100 angle 1",
    "speed 0.05 follow 0 masse 0 side 0 angle -90", "speed 8 follow 0 masse 0 side 0 angle 0",
    "speed 12 follow -9 masse 7 side -9 angle 180", "speed 2 follow 0 masse 0 side 30 angle 200",
]  # fmt: skip


@contextmanager
def engines(scheme: str, jumps: bool = False) -> Iterator[None]:
    """Let the key E choose between exact and this scheme of steps, or a tired exact engine.

    With `jumps` every shot leaves the cloth, as no shot from the boxes does yet.
    """
    budget = 40 if scheme == "tired" else 3000  # a law of 1 ms a hit must not take minutes
    kinds = {"exact": partial(EventDriven, budget=budget)}
    if scheme in SCHEMES:
        kinds["thesis"] = partial(TimeStepping, 1 / 180, scheme)
    flat = Aim.shot.fget

    def jumping(aim: Aim) -> object:
        shot = flat(aim)
        return replace(shot, climb=0.4 * shot.speed) if shot else None

    # it must not think longer than the test has time for
    quick = patch.object(opponent, "ROUNDS", ((2, 2), (2, 1)))
    shot = property(jumping if jumps else flat)
    with patch.dict(presets.ENGINES, kinds), patch.object(Aim, "shot", shot), quick:
        yield


class RandomPlayer:
    """A player without a plan; the same for the same seed."""

    def __init__(self, app: App, seed: object, far: float = 20.0) -> None:
        self.app, self.rng, self.far = app, random.Random(str(seed)), far
        self.kept: list[tuple[object, object]] = []
        """Every moment of the history, and how the balls lay when it was noted."""
        self._perform = app._act
        app._act = self._watched

    # -- what they do

    def do_anything(self) -> None:
        """One input, and what has to hold after it."""
        what = (self._press, self._type, self._mouse, self._command, self._write, self._window)
        self.rng.choices(what, (30, 6, 24, 34, 3, 3))[0]()
        self.check()

    def _press(self) -> None:
        key, mod = self.rng.choice(CODES), self.rng.choice(MODS)
        char = chr(key) if 32 <= key < 127 else ""
        self._send(pygame.KEYDOWN, key=key, mod=mod, unicode=char)

    def _type(self) -> None:
        for _ in range(self.rng.choice((1, 1, 3, 20))):
            self._send(pygame.TEXTINPUT, text=self.rng.choice(CHARACTERS))

    def _mouse(self) -> None:
        width, height = self.app.screen.get_size()
        at = self.rng.randrange(-20, width + 20), self.rng.randrange(-20, height + 20)
        kind = self.rng.choice(
            [pygame.MOUSEMOTION] * 4 + [pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP] * 2
            + [pygame.MOUSEWHEEL]
        )  # fmt: skip
        if kind == pygame.MOUSEWHEEL:
            y = self.rng.choice((-3, -1, 0, 1, 2))
            self._send(kind, x=0, y=y, flipped=False)
        else:
            button = self.rng.choice((1, 1, 1, 2, 3))
            self._send(kind, pos=at, button=button, rel=(0, 0), buttons=(1, 0, 0))

    def _command(self) -> None:
        """What keys and mouse would take long to come to; a page over the table takes them all."""
        if self.app.session.held:
            self._send(pygame.KEYDOWN, key=pygame.K_ESCAPE, mod=0, unicode="")
        else:
            self.app.perform(self._any_command())

    def _any_command(self) -> Action:
        rng, session = self.rng, self.app.session
        number = rng.choice((0.0, 0.05, 1.0, -3.5, 8.0, 359.9, -720.0))
        pair = f"{rng.uniform(-2, 2):.3f} {rng.uniform(-1, 1):.3f}"
        names = [ball.name for ball in session.world.balls]
        with_value = {
            "set": rng.choice((*SHOTS, f"angle {rng.uniform(-400, 400):.2f}")),
            "turn": str(number), "push": str(number), "power": str(abs(number)), "tip": pair,
            "nudge": pair, "tilt": str(number), "elevate": str(abs(number)),
            "thick": rng.randrange(-7, 8), "thicker": rng.choice((1, -1)),
            "scrub": rng.randrange(0, 12 * TICKS), "event": rng.choice((1, -1)),
            "faster": rng.choice((1, -1, 3)), "hold": rng.choice(names), "move": pair,
            "law": rng.choice(tuple(presets.LAWS)), "cloth": rng.choice(tuple(presets.CLOTHS)),
            "language": rng.choice(tuple(LANGUAGES)), "aids": rng.choice(CHOICES["aids"]),
            "sheet": rng.choice(("menu", "shelf", "rules", "score", "settings", "")),
            "ball": rng.choice((1, -1)), "pocket": rng.choice((1, -1)), "put": pair,
            "call": self._any_call(names), "answer": self._any_answer(),
        }  # fmt: skip
        if rng.random() < 0.45:
            return Action(rng.choice(PLAYED))
        if rng.random() < 0.02:
            return self._elsewhere()
        if rng.random() < 0.05 and not self._gone():
            return Action("line", laid(session, shot=rng.random() < 0.5).line())
        name = rng.choice([*with_value, "set"])
        return Action(name, with_value[name])

    def _gone(self) -> bool:
        """Is the cue ball off the table, or any ball of a scene?"""
        session = self.app.session
        scene = session.table not in presets.TABLES
        balls = session.world.balls if scene else [session.world.ball(session.cue)]
        return any(ball.gone for ball in balls)

    def _any_call(self, names: list[str]) -> str:
        name = self.rng.choice((*names, "17", "north pocket", "south-east pocket", ""))
        word = self.rng.choice(("ball", "pocket", "cue", "safety", "push", "nothing"))
        return word if word in ("safety", "push") else f"{word} {name}"

    def _any_answer(self) -> str:
        contest = self.app.session.contest
        asked = contest.match.asked if contest is not None else None
        return self.rng.choice(asked.options).key if asked is not None else "accept"

    def _elsewhere(self) -> Action:
        rng = self.rng
        seats = tuple(Contestant("", rng.choice(SEATS), rng.randrange(1, 4)) for _ in range(2))
        game = rng.choice(GAMES)
        terms = Terms(game, seats, DISCIPLINES[game].table, race=2, seed=rng.randrange(9))
        return rng.choice((
            Action("table", rng.choice(tuple(presets.TABLES))),
            Action("scene", rng.choice(tuple(presets.SCENES))),
            Action("match", terms.line()),
        ))  # fmt: skip

    def _write(self) -> None:
        """A few lines of a script."""
        keys = ("return", "down", "space", "e", "r", "z", "y", "ctrl+return", "end", "left")
        text = "\n".join(
            self.rng.choice((f"0 key {self.rng.choice(keys)}", "0 text 2.5", "0 click 300 200"))
            for _ in range(3)
        )
        for line in parse(text).due(0):
            for event in line.events:
                self.app.handle(event)

    def _window(self) -> None:
        if self.rng.random() < 0.1:
            size = self.rng.choice(SIZES)
            if size != self.app.screen.get_size():  # else it would come back empty
                pygame.display.set_mode(size, pygame.RESIZABLE)
            self._send(pygame.VIDEORESIZE, size=size, w=size[0], h=size[1])
        elif self.rng.random() < 0.1:
            self._send(pygame.QUIT)
        else:
            self._send(getattr(pygame, self.rng.choice(SEEN)))

    def _send(self, kind: int, **said: object) -> None:
        self.app.handle(pygame.event.Event(kind, **said))

    # -- what must hold

    def check(self) -> None:
        """Nothing has become infinite, and no ball is far away."""
        session = self.app.session
        for ball in session.world.balls:
            numbers = (*ball.position, *ball.velocity, *ball.spin, ball.height, ball.climb)
            assert all(map(isfinite, numbers)), ball
            assert max(map(abs, ball.position)) < self.far, ball
        session.over = False

    def _watched(self, action: Action) -> None:
        """Let the game do an action; what can be undone is noted, and what is undone compared."""
        world, history = self.app.session.world, self.app.session.history
        before, past = world.layout(), list(history.past)
        self._perform(action)
        count = len(history.past)
        if action.name == "undo" and count < len(past):
            then = next(layout for moment, layout in self.kept if moment is past[count])
            assert world.layout() == then, "undo gives back other digits"
        elif action.name != "redo" and count == len(past) + 1:
            self.kept.append((history.past[-1], before))


def play(seed: object, count: int, *, jumps: bool = False, scheme: str = "exact", **options) -> App:
    """Do so many things at random on a table, with a frame between some of them."""
    with engines(scheme, jumps):
        stepping = scheme in SCHEMES
        app = an_app(size=SIZES[0], engine="thesis" if stepping else "exact", **options)
        # each preview of fixed steps takes as long as a shot
        app.preferences.settings.aids = "off" if stepping else "full"
        # the thesis's program lets balls through its cushions
        player = RandomPlayer(app, seed, inf if scheme == "literal" else 20.0)
        for k in range(count):
            player.do_anything()
            if player.rng.random() < 0.4:
                _let_time_pass(app, player, drawn=k % 3 == 0)
            if k % 150 == 149:
                assert_same_as_anew(app)
        return app


def _let_time_pass(app: App, player: RandomPlayer, *, drawn: bool) -> None:
    ticks = player.rng.choice((FRAME, FRAME, 6 * FRAME, 30 * FRAME))
    if drawn:
        app.frame(ticks)
    else:
        app.update(ticks)
        app.perform(app.thinker.think(), human=False)
    player.check()


RACKED = [name for name, one in DISCIPLINES.items() if one.rules and not one.position]
PLACES: list[dict[str, str]] = [
    {"table": "medium"}, {"table": "match"}, {"table": "thesis"},
    *({"scene": name} for name in presets.SCENES),
    {"game": "four-ball", "handicap": "2", "table": "medium"},
    {"game": "three-cushion", "table": "match"},
    {"game": "four-ball", "level": "club", "handicap": "3", "table": "medium"},
    {"table": "match", "game": "balkline-47/2"},
]  # fmt: skip
"""Where it is played."""
RACKS: list[dict[str, str]] = [
    {"table": "pool-9"}, {"table": "snooker"},
    *({"game": game, "table": DISCIPLINES[game].table} for game in RACKED),
    {"game": "8-ball", "level": "club", "table": "pool-9"},
    {"game": "snooker", "level": "club,club", "table": "snooker"},
]  # fmt: skip
"""Where there are pockets: with so many balls fixed steps would take minutes."""
KINDS = ["exact", "tired", "jumps", *SCHEMES]


def trial(kind: str, place: dict[str, str], seed: object, count: int) -> App:
    """Play anything with an engine at a place."""
    scheme = "exact" if kind == "jumps" else kind
    return play(f"{kind} {place} {seed}", count, jumps=kind == "jumps", scheme=scheme, **place)
