"""The picture: what is redrawn in part equals what is drawn anew, in every state and language."""

from itertools import pairwise

import pygame
import pytest

import assets
from game.aim.entry import BOXES
from game.aim.preview import path
from game.input.bindings import Keys
from game.input.captions import words
from game.render.font import Type
from game.render.layout import Layout
from game.render.parts.cards import LOG_HEAD
from game.text import LANGUAGES
from game.ui.pages import help as page
from physics import scenes
from tests.support.players import (
    FRAME,
    an_app,
    assert_same_as_anew,
    click,
    enter,
    pixels,
    press,
    run_to_rest,
    write,
)


def test_a_rolling_ball_leaves_no_trace_of_itself_in_the_picture():
    app = an_app()
    press(app, "return")
    for _ in range(12):
        for _ in range(17):
            app.frame(FRAME)
        assert_same_as_anew(app)
    run_to_rest(app)
    assert_same_as_anew(app)


def test_every_state_of_the_window_is_the_same_drawn_in_part_and_anew():
    app = an_app()
    steps = [
        ("left",), ("tab",), ("backspace",), ("tab",), ("escape",), ("return",), ("right",),
        ("return",), ("escape",), ("r",), ("l",), ("f2",), ("down",), ("ctrl+return",), ("p",),
        (".",), ("p",), ("space",), ("return",), ("f1",), ("f2",), ("f1",), ("r",), ("end",),
    ]  # fmt: skip
    for keys in steps:
        press(app, *keys)
        assert_same_as_anew(app)


def test_aiming_with_the_mouse_is_the_same_drawn_in_part_and_anew():
    app = an_app()
    layout = app.view.sight.layout
    for at in ((300, 200), (500, 300), (620, 90)):
        click(app, at)
        assert_same_as_anew(app)
    click(app, layout.power.center)
    click(app, layout.tip.center)
    assert_same_as_anew(app)
    pygame.event.post(pygame.event.Event(pygame.MOUSEMOTION, pos=layout.shoot.center, buttons=()))
    app.frame(FRAME)
    assert app.view.pointer.over == "shoot"
    assert_same_as_anew(app)


def test_sixteen_balls_at_once_are_the_same_drawn_in_part_and_anew():
    app = an_app(scene="rack15")
    for _ in range(60):
        app.frame(FRAME)
        if app.session.tick % (7 * FRAME) < FRAME:
            assert_same_as_anew(app)


def test_a_resized_window_shows_what_a_new_one_would():
    app = an_app(size=(1280, 720))
    press(app, "l")
    app.screen = pygame.display.set_mode((960, 540), pygame.RESIZABLE)
    app._resize()
    app.frame(0)
    resized = pixels(app)
    other = an_app(size=(960, 540))
    press(other, "l")
    assert pixels(other) == resized


def test_drawing_changes_no_state():
    app = an_app()
    press(app, "return")
    session = app.session
    before = (
        session.version,
        session.tick,
        session.calls,
        session.world.time,
        list(session.aim.texts),
    )
    app.view.expose()
    app.view.draw(app.screen)
    assert (
        session.version,
        session.tick,
        session.calls,
        session.world.time,
        list(session.aim.texts),
    ) == before


def test_one_moving_ball_redraws_a_small_part_of_the_window():
    app = an_app(size=(1280, 720))
    enter(app, "0.5", "0.5", "0", "0", "90")
    press(app, "return")
    for _ in range(30):  # the cue has been put away by then
        app.frame(FRAME)
    area = []
    for _ in range(10):
        app.session.advance(FRAME)
        app.view.stage.follow(app.session)
        area.append(sum(r.w * r.h for r in app.view.stage.draw(app.screen, app.session)))
    ball = (4 * app.view.stage.sprites.px) ** 2
    assert max(area) < 6 * ball


# -- words ---------------------------------------------------------------------------------------


def test_all_languages_have_the_same_keys():
    keys = [list(w) for w in LANGUAGES.values()]
    assert all(k == keys[0] for k in keys)


def test_every_character_of_the_interface_is_in_the_font():
    font = pygame.font.Font(assets.stream(assets.FONT), 20)

    def glyph(char):
        return pygame.image.tobytes(font.render(char, True, "white"), "RGBA")

    used = {c for w in LANGUAGES.values() for text in w.values() for c in text}
    unknown = glyph("\U0001f3b1")  # the box that stands for any missing character
    assert {c for c in used if glyph(c) == unknown} == set()
    assert glyph("\u4e59") == unknown


def layouts():
    return [
        Layout(size, length, width)
        for size in ((960, 540), (1280, 720), (1920, 1080))
        for length, width in ((2.448, 1.27), (2.54, 1.27), (2.84, 1.42))
    ]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("layout", layouts(), ids=lambda v: f"{v.size[0]}-{v.length}")
def test_every_hint_and_error_fits_into_its_line(language, layout):
    w, type_ = words(language), Type(layout.s)
    room = layout.hint.w - round(36 * layout.s)  # beside an error's sign
    errors = [
        w["wrong"].format(box=w["box." + box], why=w["why." + why].format(most="3600"))
        for box in BOXES
        for why in ("empty", "number", "finite", "positive", "most")
    ]
    said = [text for key, text in w.items() if key.startswith(("hint.", "notice."))]
    for text in [*errors, *said, w["wrong.mended"]]:
        assert type_.width(text, 13) <= room, text


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("layout", layouts(), ids=lambda v: f"{v.size[0]}-{v.length}")
def test_badges_and_help_fit_into_their_places(language, layout):
    w, type_ = words(language), Type(layout.s)
    engine = layout.engine.w - 40 * layout.s
    for law in (k for k in w if k.startswith("law.")):
        for mover in (k for k in w if k.startswith("engine.")):
            assert type_.width(f"{w[mover]} · {w[law]}", 13) <= engine
    sheet = page.panel(layout)
    assert all(type_.width(w[line], 13) <= sheet.w - 2 * page.PAD * layout.s for line in page.MOUSE)
    room, names = page.column(layout) - page.KEY_COLUMN * layout.s, Keys().names
    sections = [section for column in page.COLUMNS for section in column]
    for key, said in ((row.keys, row.text) for name in sections for row in page.rows(name)):
        cap = page.caption(key, w, names)
        assert type_.width(cap, 12) <= (page.KEY_COLUMN - 12) * layout.s, cap
        assert type_.width(w[said], 13) <= room, w[said]
    assert LOG_HEAD > 0


def test_the_window_opens_in_both_languages_and_differs():
    english = an_app()
    first = pixels(english)
    korean = an_app(lang="ko")
    assert pixels(korean) != first


def test_a_long_text_keeps_its_caret_in_the_box():
    app = an_app()
    press(app, "right")
    write(app, "-1234567890.12345")
    assert_same_as_anew(app)


def test_a_small_window_is_the_same_drawn_in_part_and_anew():
    app = an_app(size=(640, 360))
    for key in ("f2", "left", "tab", "escape", "ctrl+return", "p", "f2", "p", "end", "f2"):
        press(app, key)
        assert_same_as_anew(app)


def test_a_drawn_curve_is_nowhere_a_quarter_of_a_millimetre_off():
    world = scenes.thesis_1()
    world.run()
    leg = world.log.legs("white")[0]
    end = world.log.legs("white")[1].time
    points = path(world.log, "white", 0.0, end)
    assert len(points) > 20
    step = end / (len(points) - 1)
    for k, (p, q) in enumerate(pairwise(points)):
        middle = leg.after((k + 0.5) * step).position
        assert abs(middle - (complex(*p) + complex(*q)) / 2) <= 0.00025
