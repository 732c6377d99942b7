"""What Enter says while the balls of a match roll."""

from game.session.session import Notice
from tests.support.players import an_app, press


def test_enter_while_the_balls_of_a_match_roll_says_to_wait():
    app = an_app(game="four-ball")
    press(app, "return", "return")
    assert app.session.moving
    assert app.session.shots == 1
    assert app.session.notice == Notice("refused.moving", error=True)


def test_enter_while_free_balls_roll_asks_for_a_new_entry():
    app = an_app()
    press(app, "return", "return")
    assert app.session.moving
    assert app.session.shots == 1
    assert app.session.notice == Notice("spent")
