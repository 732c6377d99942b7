"""Keys are called by the names that the player has given them, wherever they are spoken of."""

import re

import pytest

from game.input.bindings import DEFAULTS, Keys
from game.input.captions import words
from game.render.font import Type
from game.render.layout import Layout
from game.session.action import Action
from game.text import KEY, LANGUAGES
from game.ui.pages import help as page
from game.ui.panels.parts import badge, hint
from tests.support.players import FREE, SPARE, an_app, press

EN = words("en")
SPEAKING = ("hint.", "notice.", "rule.", "help.mouse", "help.close", "key.")
"""How the keys of texts begin that speak of the keyboard."""


def spoken():
    """Every text that speaks of a key, with the actions whose keys it speaks of."""
    return [
        (language, key, KEY.findall(text))
        for language, found in LANGUAGES.items()
        for key, text in found.items()
        if KEY.search(text)
    ]


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_mark_is_left_in_a_text(language):
    assert [text for text in words(language).values() if "@[" in text] == []


def test_every_text_speaks_of_actions_that_there_are():
    assert {name for _, _, names in spoken() for name in names} <= set(DEFAULTS)


def test_languages_speak_of_the_same_keys():
    said = {language: {} for language in LANGUAGES}
    for language, key, names in spoken():
        said[language][key] = sorted(names)
    assert said["en"] == said["ko"]


D_OF_A_TABLE = "notice.hand.snooker"
"""A text that speaks of a part of the table, not of a key."""


def test_no_text_names_a_key_that_may_be_another_one():
    """All but the fixed ones are written as marks: F1, P, Space, End, and signs such as [."""
    caps = {"Space", "Home", *(f"F{n}" for n in range(1, 13))}
    letters = {binding.key.upper() for binding in DEFAULTS.values() if len(binding.key) == 1}
    left = []
    for found in LANGUAGES.values():
        for key, text in found.items():
            if not key.startswith(SPEAKING) or key == D_OF_A_TABLE:
                continue
            named = set(re.findall(r"[A-Za-z0-9\[\],.]+", KEY.sub("", text)))
            left += [(key, text) for cap in (caps | letters) & named if cap not in ("A", ",", ".")]
    assert left == []


def test_words_follow_what_the_player_has_chosen():
    changed = {"help": "f13", "stop": "h", "pause": "space", "back": "backslash"}
    w = words("en", changed)
    assert w["hint.moving"] == "H stops · Space pause · F13 help"
    assert w["hint.paused"] == "Space go on · \\ . frame · [ ] speed"
    assert w["help.close"] == "F13 or Esc closes this page"
    assert w["key.space"] == "H"
    assert words("en")["hint.moving"] == "Space stops · P pause · F1 help"


@pytest.mark.parametrize("name", ["stop", "pause", "help", "retry", "undo", "arrange"])
def test_the_window_follows_at_once(name):
    app = an_app()
    key = "f13" if DEFAULTS[name].always else FREE
    before = dict(app.view.sight.words)
    app.perform(Action("bind", f"{name} {key}"))
    after = app.view.sight.words
    changed = {k for k in before if before[k] != after[k]}
    assert changed == {k for language, k, names in spoken() if language == "en" and name in names}
    app.perform(Action("unbind", name))
    assert app.view.sight.words == before


def test_the_page_of_keys_names_those_held_with_shift_too():
    names = Keys({"back": FREE, "frame": SPARE}).names
    assert page.caption("Shift+@back @frame", EN, names) == f"Shift+{FREE.upper()} {SPARE.upper()}"


@pytest.mark.parametrize("key", ["x", "space", "home", "delete", "left", "quote", "kp_period"])
def test_a_key_that_types_or_moves_the_caret_cannot_work_everywhere(key):
    """Else a name could not be written with it."""
    free = {b.key: name for name, b in DEFAULTS.items()}.get(key)
    keys = Keys({free: "f14"} if free else {})
    with pytest.raises(ValueError, match="types"):
        keys.with_key("help", key)


# -- what is said of laws and engine -------------------------------------------------------------


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize("size", [(640, 360), (960, 540), (1280, 720), (1920, 1080)])
@pytest.mark.parametrize("table", ["thesis", "medium", "match"])
def test_every_change_of_laws_is_seen_on_the_card(lang, size, table, monkeypatch):
    app, drawn, draw = an_app(size=size, lang=lang, table=table), [], Type.draw

    def noted(self, surface, string, *how):
        drawn.append(string)
        return draw(self, surface, string, *how)

    monkeypatch.setattr(Type, "draw", noted)
    for key in "llllee":
        drawn.clear()
        press(app, key)
        w, session = app.view.sight.words, app.session
        engine, law = f"engine.{session.engine}", f"law.{session.law}"
        short = f"{w[engine.replace('.', '.short.')]} · {w['set.' + law]}"
        assert {f"{w[engine]} · {w[law]}", short} & set(drawn)


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1024, 768)])
def test_engine_and_laws_always_fit_beside_the_buttons_of_the_card(lang, size):
    w = words(lang)
    for length, width in ((2.448, 1.27), (2.54, 1.27), (2.84, 1.42)):
        layout = Layout(size, length, width)
        room = layout.engine.w - (42 + 72) * layout.s
        for engine in (k for k in w if k.startswith("engine.short.")):
            for law in ("rigid", "thesis", "mathavan", "own"):
                text = f"{w[engine]} · {w.get(f'set.law.{law}') or w[f'law.{law}']}"
                assert Type(layout.s).width(text, 13) <= room, text


@pytest.mark.parametrize("lang", LANGUAGES)
def test_the_new_laws_and_the_new_engine_are_said(lang):
    app = an_app(lang=lang)
    w = words(lang)
    press(app, "l")
    assert w["law.thesis"] in hint(app.session, w)[0]
    press(app, "e")
    assert w["engine.thesis"] in hint(app.session, w)[0]
    assert not hint(app.session, w)[1]
    assert w["law.thesis"] in badge(app.session, w)[0]
    press(app, "q")
    assert hint(app.session, w)[0] == w["hint.ready"]


def test_what_is_said_of_laws_does_not_hide_what_is_wrong():
    app = an_app()
    press(app, "right", "escape", "l")
    assert hint(app.session, EN)[1]
