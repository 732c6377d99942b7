"""Small windows: they show what one of 960 x 540 shows, only smaller, and the mouse still hits."""

import pygame
import pytest

from game.render.layout import Layout
from game.render.theme import BACKGROUND
from game.window.canvas import LEAST, SHAPE, Canvas
from tests.support.players import FRAME, an_app, assert_same_as_anew, in_window, press, run_to_rest

SMALL = [(640, 360), (800, 450), (959, 540), (960, 539), (700, 900), (1200, 300), (320, 180)]
ODD = [(1, 1), (200, 16384), (16384, 200), (3, 700)]


def canvas(size):
    return Canvas(pygame.Surface(size, 0, 32))


def clicked(app, at):
    """Press the left button at a point of the window, as SDL tells it."""
    for kind in (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
        event = pygame.event.Event(kind, pos=at, button=1, rel=(0, 0), buttons=(1, 0, 0))
        pygame.event.post(event)
    app.frame(FRAME)


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1200, 1920), (3440, 1440)])
def test_a_window_that_is_large_enough_is_drawn_on_itself(size):
    made = canvas(size)
    assert made.surface is made.window
    assert made.at((7, 9)) == (7, 9)
    assert made.show([pygame.Rect(1, 2, 3, 4)]) == [pygame.Rect(1, 2, 3, 4)]


@pytest.mark.parametrize("size", SMALL + ODD)
def test_the_picture_of_a_small_window_has_room_for_all_text(size):
    made = canvas(size)
    picture = made.surface.get_size()
    assert picture[0] >= LEAST[0]
    assert picture[1] >= LEAST[1]
    assert Layout(picture, 2.54, 1.27).s >= 0.75
    assert max(picture) <= SHAPE * LEAST[0]
    if size in SMALL:
        assert made.part.size == size
        assert picture[0] / picture[1] == pytest.approx(size[0] / size[1], rel=0.005)


@pytest.mark.parametrize("size", SMALL)
def test_every_point_of_the_window_is_one_of_the_picture(size):
    made = canvas(size)
    inside = made.surface.get_rect()
    for corner in ((0, 0), (size[0] - 1, 0), (0, size[1] - 1), (size[0] - 1, size[1] - 1)):
        assert inside.collidepoint(made.at(corner))
    assert made.at((size[0] // 2, size[1] // 2)) == pytest.approx(inside.center, abs=made.scale)


@pytest.mark.parametrize("size", [(640, 360), (800, 450), (1200, 300)])
def test_a_small_window_shows_its_picture_scaled_down(size):
    app = an_app(size=size)
    press(app, "return", "end", "f10", "down")
    assert app.screen.get_size() == size
    shown = pygame.image.tobytes(app.screen, "RGB")
    wanted = pygame.transform.smoothscale(app.canvas.surface, size)
    assert shown == pygame.image.tobytes(wanted, "RGB")


def test_the_mouse_hits_what_is_seen_in_a_small_window():
    app = an_app(size=(640, 360))
    shoot = app.view.sight.layout.shoot
    before = app.session.shots
    for corner in ((shoot.x + 2, shoot.y + 2), (shoot.right - 2, shoot.bottom - 2)):
        clicked(app, in_window(app, corner))
        before += 1
        assert app.session.shots == before
        run_to_rest(app)
        press(app, "r")
    clicked(app, in_window(app, (shoot.x - 4, shoot.centery)))
    assert app.session.shots == before


def test_a_window_made_small_and_large_again_shows_what_it_did():
    app = an_app(size=(1280, 720))
    press(app, "return", "space")
    before = pygame.image.tobytes(app.screen, "RGB")
    for size in ((640, 360), (1280, 720)):
        pygame.display.set_mode(size, pygame.RESIZABLE)
        app.handle(pygame.event.Event(pygame.VIDEORESIZE, size=size, w=size[0], h=size[1]))
        app.frame(0)
        assert app.screen.get_size() == size == app.preferences.settings.size
        assert_same_as_anew(app)
    assert pygame.image.tobytes(app.screen, "RGB") == before


def test_nothing_is_scaled_when_nothing_changes(monkeypatch):
    app = an_app(size=(640, 360))
    scaled, whole = [], pygame.transform.smoothscale
    monkeypatch.setattr(
        pygame.transform, "smoothscale", lambda *args: scaled.append(1) or whole(*args)
    )
    for _ in range(5):
        app.frame(FRAME)
    assert scaled == []


@pytest.mark.parametrize("size", [(1280, 200), (1280, 300), (240, 1180)])
def test_nothing_is_left_of_the_old_picture_beside_a_very_wide_or_tall_one(size):
    app = an_app(size=(1280, 720))
    app.screen.fill((255, 0, 255))  # what the window's surface may hold when it changes its shape
    screen = pygame.display.set_mode(size, pygame.RESIZABLE)
    screen.fill((255, 0, 255))
    app.handle(pygame.event.Event(pygame.VIDEORESIZE, size=size, w=size[0], h=size[1]))
    shown = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(pygame.display, "update", shown.append)
        app.frame(0)
    assert shown == [[app.screen.get_rect()]]
    beside = [app.screen.get_at((x, y)) for x, y in ((0, 0), (size[0] - 1, size[1] - 1))]
    assert [tuple(colour)[:3] for colour in beside] == [BACKGROUND] * 2
    assert_same_as_anew(app)
    press(app, "q")
    app.handle(pygame.event.Event(pygame.VIDEOEXPOSE))
    app.frame(0)
    assert tuple(app.screen.get_at((0, 0)))[:3] == BACKGROUND
