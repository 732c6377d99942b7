"""The large button, the key named on it and RETURN: they do the same in every state."""

import pytest

from game.app import App
from game.input.bindings import Keys
from game.input.captions import words
from game.replay.game_record import read
from game.replay.recorder import Recorder
from game.replay.replay import Replay
from game.replay.script import parse
from game.session.action import Action
from game.session.session import Notice
from game.ui.panels import prompts
from game.ui.panels.parts import hint
from tests.support.contrast import contrast
from tests.support.matches import opening_numbers
from tests.support.players import (
    FRAME,
    FREE,
    an_app,
    click,
    enter,
    places,
    press,
    run_to_rest,
    write,
)


def free(*keys, **options):
    """A way into a state by keys on the free table."""

    def make():
        app = an_app(**options)
        press(app, *keys)
        return app

    return make


def rested(*keys, **options):
    """A way into a state after a shot."""

    def make():
        app = an_app(**options)
        press(app, "return")
        run_to_rest(app)
        press(app, *keys)
        return app

    return make


def of_match(*keys, **options):
    def make():
        app = an_app(game="four-ball", **options)
        enter(app, *opening_numbers())
        press(app, *keys)
        return app

    return make


def over():
    app = an_app(game="four-ball", handicap="1", finish="none")
    enter(app, *opening_numbers())
    press(app, "return", "end")
    assert app.session.contest.match.finished
    return app


def spoilt(*keys):
    def make():
        app = an_app()
        press(app, "right")
        write(app, "2x")
        press(app, *keys)
        return app

    return make


def entered():
    app = an_app()
    enter(app, "1", "0", "0", "0", "0")
    return app


def placing_and_a_box():
    app = an_app()
    press(app, "b")
    click(app, app.view.sight.layout.fields[1].center)
    return app


def typed_while_rolling():
    app = an_app()
    press(app, "return")
    enter(app, "1", "0", "0", "0", "0")
    return app


COMPUTER = {"players": "1", "level": "club"}
STATES = {
    "aiming": (free(), "shoot"),
    "aiming by mouse keys": (free("q", "pageup"), "shoot"),
    "editing": (free("left"), "shoot"),
    "editing the last box": (free("shift+tab"), "shoot"),
    "left half way": (free("left", "escape"), "complete"),
    "unreadable, editing": (spoilt(), "shoot"),
    "unreadable, left": (spoilt("escape"), "complete"),
    "entered": (entered, "shoot"),
    "placing": (free("b"), "place.done"),
    "placing, then a box": (placing_and_a_box, "shoot"),
    "rolling": (free("return"), "stop"),
    "rolling, editing": (free("return", "left"), "shoot"),
    "rolling, entered": (typed_while_rolling, "stop"),
    "paused": (free("return", "p"), "stop"),
    "paused with nothing to hold": (free("p"), "shoot"),
    "scrubbed while it rolls": (free("return", "p", ","), "stop"),
    "after the shot": (rested(), "next"),
    "after the shot, replayed": (rested("p"), "next"),
    "after the shot, scrubbed": (rested(",", ","), "next"),
    "after the shot, RETURN": (rested("return"), "shoot"),
    "after the shot, RETURN twice": (rested("return", "return"), "shoot"),
    "after the shot, left again": (rested("return", "escape"), "complete"),
    "put back": (rested("r"), "shoot"),
    "undone": (rested("z"), "shoot"),
    "stopped in a pause": (free("return", "p", "space"), "next"),
    "a scene that has stopped": (free("space", scene="carom"), "shoot"),
    "a match": (of_match(), "shoot"),
    "a match, editing": (of_match("left"), "shoot"),
    "a match, left half way": (of_match("left", "escape"), "complete"),
    "a stroke rolls": (of_match("return"), "skip"),
    "a stroke rolls, editing": (of_match("return", "left"), "skip"),
    "a stroke is paused": (of_match("return", "p"), "skip"),
    "after a stroke": (of_match("return", "end"), "next"),
    "after a stroke that was paused": (of_match("return", "p", "end"), "next"),
    "the next stroke": (of_match("return", "end", "return"), "shoot"),
    "the computer's turn": (free(game="four-ball", **COMPUTER), "hurry"),
    "the computer's turn, paused": (free("p", game="four-ball", **COMPUTER), "resume"),
    "the end": (over, "again"),
    "the end, RETURN": (lambda: press(app := over(), "return") or app, "again"),
}
PRESSES = {
    "key.enter": "return", "key.fire": "ctrl+return", "key.space": "space", "key.end": "end",
    "key.b": "b", "key.f10": "f10", "key.p": "p",
}  # fmt: skip


def state(app):
    """All that a press may change, and that is to be the same whichever way it was meant."""
    session, aim = app.session, app.session.aim
    return (
        places(session), session.shots, session.moving, session.paused, session.arranging,
        session.page, session.shown_shot, session.timeline.at, aim.box, aim.texts, aim.complete,
        aim.wrong,
        app.thinker._hurried,
    )  # fmt: skip


@pytest.mark.parametrize("name", STATES)
@pytest.mark.usefixtures("undrawn")
def test_button_its_key_and_return_agree_and_none_is_a_dead_end(name):
    make, label = STATES[name]
    alone, clicked, pressed, returned = make(), make(), make(), make()
    found, cap, action = prompts.button(alone.session)
    assert found == label
    assert alone.view.parts[5].key(alone.view.sight)[:2] == (
        words("en")[label], words("en").get(cap, ""),
    )  # fmt: skip
    alone.frame(FRAME)
    click(clicked, clicked.view.sight.layout.shoot.center)
    assert state(clicked) != state(alone)
    if cap:
        press(pressed, PRESSES[cap])
        assert state(clicked) == state(pressed)
    assert (cap == "key.enter") == (prompts.entered(returned.session) == action)
    press(returned, "return")
    aim, said = returned.session.aim, hint(returned.session, words("en"))[0]
    explained = returned.session.notice or aim.shown_faults or said == words("en")["hint.paused"]
    assert state(returned) != state(alone) or explained


def test_a_second_return_after_a_shot_goes_on_to_the_next_one():
    app = an_app()
    press(app, "return")
    run_to_rest(app)
    press(app, *["return"] * 6)  # to the first box, through all five; now it is complete
    assert app.session.aim.complete
    press(app, "return")
    assert app.session.shots == 2


def test_return_while_balls_roll_begins_nothing():
    app = an_app()
    press(app, "return", "return", "return")
    assert app.session.shots == 1
    assert app.session.aim.box is None
    assert app.session.notice == Notice("spent")


def test_nobody_plays_the_stroke_of_a_computer_that_was_paused():
    app = an_app(game="four-ball", **COMPUTER)
    press(app, "p", "return", "ctrl+return", "left", "1")
    assert app.session.shots == 0
    assert app.session.aim.box is None
    press(app, "p")
    assert prompts.button(app.session)[0] == "hurry"


def test_balls_that_rest_are_not_paused():
    app = an_app()
    press(app, "return", "p", "end")
    assert not app.session.paused
    press(app, "r", "return")
    before = places(app.session)
    app.frame(FRAME)
    assert places(app.session) != before


def test_a_box_chosen_while_balls_are_placed_ends_the_placing():
    app = an_app()
    press(app, "b")
    click(app, app.view.sight.layout.fields[1].center)
    write(app, "2")
    press(app, "return")
    assert not app.session.arranging
    assert (app.session.aim.texts[1], app.session.aim.box) == ("2", 2)


# -- a tip beyond the ring -----------------------------------------------------------------------


def test_a_tip_held_at_the_ring_is_a_warning_and_may_be_shot():
    app = an_app()
    app.perform(Action("tip", "0.9 0"))
    assert app.session.notice == Notice("miscue", error=False)
    said, error = hint(app.session, words("en"))
    assert (said, error) == (words("en")["notice.miscue"], False)
    part = next(part for part in app.view.parts if part.name == "hint")
    assert part.key(app.view.sight) == (said, False, True)
    assert prompts.button(app.session)[0] == "shoot"
    press(app, "return")
    assert app.session.shots == 1


def test_a_warning_looks_neither_like_help_nor_like_an_error():
    from game.render import theme
    from game.render.font import Type
    from game.render.layout import Layout
    from game.render.parts import fields
    from tests.support.pictures import black, pixels

    layout, seen = Layout((1280, 720), 2.54, 1.27), set()
    for tone in ({}, {"error": True}, {"warning": True}):
        surface = black(layout)
        fields.hint(surface, layout.hint, Type(layout.s), "the same", **tone)
        seen.add(pixels(surface).tobytes())
    assert len(seen) == 3
    assert contrast(theme.WARNING, theme.BACKGROUND) >= 4.5


# -- watching a record ---------------------------------------------------------------------------


@pytest.fixture
def watched(tmp_path):
    """A record of a shot that is being played."""
    played = an_app()
    path = str(tmp_path / "game.rec")
    played.journal = Recorder(path, played.options, played.session)
    played.script = parse("0.1 key return\n4 key f2\n")
    for _ in range(300):
        played.frame(FRAME)
    played.journal.close()
    record = read(path, played.options)
    app = an_app()
    return App(app.session, app.options, journal=Replay(record, app.session))


def test_the_button_holds_and_goes_on_with_a_record_and_leaves_it(watched):
    button = watched.view.sight.layout.shoot.center
    watched.frame(FRAME)
    assert prompts.button(watched.session)[:2] == ("hold", "key.p")
    for held in (True, False):
        click(watched, button)
        assert watched.replay.paused == held
        assert prompts.button(watched.session)[0] == ("resume" if held else "hold")
    for _ in range(400):
        watched.frame(FRAME)
    assert prompts.button(watched.session)[0] == "leave"
    click(watched, button)
    assert watched.session.over


def test_nothing_else_of_the_window_is_touched_while_a_record_plays(watched):
    watched.frame(FRAME)
    before = list(watched.session.aim.texts)
    layout = watched.view.sight.layout
    for rect in (layout.bed, layout.power, layout.fields[0], layout.tip):
        click(watched, rect.center)
    assert watched.session.aim.texts == before
    assert watched.session.aim.box is None


# -- keys the player has chosen ------------------------------------------------------------------


def test_the_button_names_the_key_that_the_player_has_chosen():
    app = an_app()
    app.perform(Action("bind", f"stop {FREE}"))
    press(app, "return")
    assert app.view.parts[5].key(app.view.sight)[1] == FREE.upper()
    press(app, FREE)
    assert not app.session.moving
    assert Keys().names["stop"] == "space"
