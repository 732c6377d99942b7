"""What commands around the table do to a session: its equipment, matches, placing balls, pages."""

from __future__ import annotations

import warnings
from collections.abc import Callable

from game.table import drill_lies, lineup, placing, presets, shared
from game.text import LANGUAGES
from physics import World

from . import equipment, match_commands, saved, terms
from .running_match import Contest
from .session import Session

SQUIRTS = ("off", "on")

# -- table and equipment -------------------------------------------------------------------------


def use_engine(session: Session, key: str = "") -> None:
    """Continue with another engine, or the next one."""
    session.use_engine(key or equipment.after([*presets.ENGINES], session.engine))


def use_law(session: Session, key: str = "") -> None:
    """Continue with another law set, or the next one."""
    key = key or equipment.after([*presets.LAWS], session.law)
    equipment.with_laws(session.world, key, session.edition, session.came_with)
    session.law = key
    session.timeline.stamp += 1


def use_cloth(session: Session, key: str = "") -> None:
    """Continue on another cloth, the one that the table came with ("table"), or the next one."""
    key = key or equipment.after([*presets.CLOTHS], session.cloth)
    equipment.with_cloth(session.world, key, session.edition, session.came_with)
    session.cloth = key
    session.timeline.stamp += 1


def said(use: Callable[[Session, str], None], notice: str) -> Callable[..., None]:
    """Taking something else as a command that says what is in use now."""

    def do(session: Session, key: str = "") -> None:
        use(session, key)
        if session.notice is None:
            session.warn(notice, error=False)

    return do


def _begin(session: Session, world: World, table: str) -> None:
    """Play on another table with the engine that was in use."""
    session.begin(world, table)
    session.use_engine(session.engine)


def table(session: Session, key: str = "") -> None:
    """Lay the balls on another table, with its own cloth and laws; the engine stays."""
    key = key or equipment.after([*presets.TABLES], session.table)
    session.page = "" if session.page == "tracks" else session.page
    _begin(session, presets.table_world(key), key)


def language(session: Session, key: str = "") -> None:
    """Say everything in another language, or in the next one."""
    session.language = key or equipment.after([*LANGUAGES], session.language)


def squirt(session: Session, key: str = "") -> None:
    """Let the cue stay where it points while the tip is moved aside, or the ball's course."""
    session.squirt = key or equipment.after([*SQUIRTS], session.squirt)
    session.aim.squirts = session.squirt == "on"


def match(session: Session, text: str) -> None:
    """Begin a match as the line of its terms says; ValueError for a line that is none."""
    wanted = terms.read(text)
    session.page = ""
    if wanted.game != terms.FREE:
        session.engine = wanted.engine
    _begin(session, wanted.world(), wanted.table)
    if wanted.law != "table":
        use_law(session, wanted.law)
    if wanted.cloth != "table":
        use_cloth(session, wanted.cloth)
    session.contest = Contest.of(wanted)
    if session.contest is not None:
        if session.contest.lag is not None:
            session.contest.open_up(session.world)
            session.put(session.world.layout())
        session.seat()
        session.contest.given = False
        session.give_boxes()
        session.aim.finish()


def resume(session: Session, text: str) -> None:
    """Go on with a saved match, to the last bit as it stood; ValueError for a text that is none."""
    found = saved.read(text)
    match(session, found.terms.line())
    contest, kept = session.contest, found.kept
    assert contest is not None
    lies = dict(zip(kept.balls, kept.layout, strict=True))
    session.put([lies[ball.name] for ball in session.world.balls])
    contest.match, contest.race, contest.card = found.standing, kept.race, kept.card
    contest.lies, contest.lag, session.shots = kept.lies, kept.lag, kept.shots
    session.lies = kept.lies or session.world.layout()
    session.history.clear()
    session.seat()
    session.aim.spent()
    contest.given = session.arranging = False
    session.show_aim()
    session.aim.finish()


def scene(session: Session, name: str) -> None:
    """Begin with a scene of the physics package; KeyError if there is none of that name."""
    session.page = ""
    if (world := _made(session, lambda: presets.scene_world(name))) is not None:
        _begin(session, world, name)


def _made(session: Session, make: Callable[[], World]) -> World | None:
    """The world of a set-up; where it cannot be made, that is said and the game goes on."""
    try:
        return make()
    except lineup.UNMADE as error:
        warnings.warn(f"the set-up cannot be laid: {error!r}", RuntimeWarning, stacklevel=2)
        session.refuse("unmade")
        return None


def line(session: Session, text: str) -> None:
    """Lay the balls as a line of text says, with its shot in the boxes; LineError if it is none."""
    found = lineup.read(text)
    session.page = ""
    names = [name for name, _ in found.balls]
    same = found.table == session.table and names == [b.name for b in session.world.balls]
    gone = found.down or any(ball.gone for ball in session.world.balls)
    if session.contest or not same or gone:
        if (world := _made(session, found.world)) is None:
            return
        _begin(session, world, found.table)
    else:
        session.lay([place for _, place in found.balls])
    session.timeline.shown = False
    if found.texts:
        session.aim.texts = list(found.texts)
    session.aim.leave()
    session.aim.finish()


def open_shot(session: Session, text: str) -> None:
    """Lay a shot that was kept or shared, with what it was played with; a replay is played at once.

    LineError for a text that is none.
    """
    found, uses = shared.read(text), {"engine": use_engine, "law": use_law, "cloth": use_cloth}
    line(session, found.lineup.line())
    for name, key in found.kit:
        uses[name](session, key)
    session.cue = session.held_ball = found.cue or presets.cue_ball(session.world)
    if found.replay:
        session.strike()


def drill(session: Session, name: str) -> None:
    """Lay a drill, with the cue pointing at the ball to be hit first."""
    line(session, drill_lies.laid(name).line())
    session.cue = session.held_ball = presets.cue_ball(session.world)


# -- placing balls -------------------------------------------------------------------------------


def place(session: Session) -> None:
    """Lay all balls down at random; not those of a match, and not where there is no room."""
    if session.contest is not None:
        session.refuse("match")
        return
    try:
        places = presets.places(session.world, session.rng)
    except ValueError:
        session.refuse("room")
        return
    session.put(presets.lying(places))


def arrange(session: Session) -> None:
    """Begin or end placing balls by hand; of those of a match only the cue ball in hand."""
    if session.contest is not None and not session.contest.match.finished:
        match_commands.hold_in_hand(session)
    elif session.moving:
        session.refuse("moving")
    else:
        session.arranging, session.sketching = not session.arranging, False
        session.timeline.shown = False
        session.aim.leave()


def hold(session: Session, name: str) -> None:
    """Take the ball that keys and mouse move; in a match it is the cue ball."""
    if session.contest is not None and not session.contest.match.finished:
        return
    if name in {ball.name for ball in session.world.balls}:
        session.held_ball = name


def move(session: Session, to: str) -> None:
    """Move the ball in hand to "X Y" metres, or as near as there is room."""
    if not session.arranging:
        return
    x, y = map(float, to.split())
    if session.contest is not None and not session.contest.match.finished:
        match_commands.move_in_hand(session, (x, y))
        return
    held, balls = session.held_ball, session.world.balls
    found = placing.slid(session.world, held, (x, y))
    if found != session.world.ball(held).position or session.world.ball(held).gone:
        there = placing.lying_at(found)
        session.put([there if ball.name == held else ball.placed for ball in balls])
        session.lies = session.world.layout()


# -- pages ---------------------------------------------------------------------------------------


def page(session: Session, name: str = "") -> None:
    """Lay a page over the table, or take it away ("" or the one that is there)."""
    session.page = "" if session.page == name else name
    session.aim.leave()


def settings(session: Session) -> None:
    """Open or close the settings page."""
    page(session, "settings")


def keys(session: Session) -> None:
    """Open or close the page of keys."""
    session.help = not session.help


def quit_game(session: Session) -> None:
    """Leave."""
    session.leave()
