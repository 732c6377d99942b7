"""What tests of matches share: hands on the menu, a known opening, and what the window shows."""

from __future__ import annotations

from danggu.players.positions import opening
from game.app import App
from game.ui.pages import menu_view
from game.ui.panels import score_plates
from tests.support.players import click


def told(app: App) -> tuple[str, str, str]:
    """What the result card says."""
    contest = app.session.contest
    return score_plates.result(contest, contest.verdict, app.view.sight)[:3]


def scores(app: App) -> list[int]:
    """The points of each player."""
    return [sheet.score for sheet in app.session.contest.match.sheets]


def opening_numbers() -> list[str]:
    """The five numbers of the usual opening of 4-ball."""
    angle, speed, right, up = opening("sagu").answer
    return [f"{n:.4f}" for n in (speed, 2.5 * speed * up, 0.0, 2.5 * speed * right, angle)]


def choose(app: App, name: str, step: int = 1, times: int = 1) -> None:
    """Click the arrow of a row in the open menu."""
    sheet, layout = app.view.page, app.view.sight.layout
    place = next(i for i, row in enumerate(sheet.rows) if row.name == name)
    arrow = menu_view.arrows(menu_view.row_rect(sheet.rows, place, layout), layout)[step > 0]
    for _ in range(times):
        click(app, arrow.center)


def menu_button(app: App, name: str) -> tuple[int, int]:
    """Where a button of the menu is."""
    place = menu_view.BUTTONS.index(name)
    return menu_view.button_rects(app.view.sight.layout)[place].center
