"""What a notebook, a figure and a film show of a world, a log, a shot and a sensitivity."""

import json
import re
import subprocess
import sys
from xml.etree import ElementTree

import numpy as np
import pytest

from physics import (
    Ball,
    CueStroke,
    Shot,
    Track,
    Wall,
    World,
    animate,
    ledger,
    recover,
    scenes,
    sensitivity,
    simulate,
    store,
    tables,
    trace,
)

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def after():
    return simulate(scenes.carom(), "white", Shot(2.0, 10.0, follow=-1.0, side=1.0))


def broken():
    world = tables.pool_9ft()
    for ball in world.table.rack("9-ball"):
        world.add(ball)
    world.add(Ball("<cue>", at=(-0.6, 0.1)))
    return simulate(world, "<cue>", Shot(8.0, -4.3, follow=2.0))


WORLDS = {
    "nothing": World,
    "no walls": lambda: World(balls=[Ball("a", (0.0, 0.0), velocity=(1.0, 0.0))]),
    "an arc": lambda: World(walls=[Wall.arc((0.0, 0.0), 1.0, 0.0, 360.0)]),
    "a break": broken,
    **scenes.SCENES,
}


@pytest.mark.parametrize("name", WORLDS)
def test_the_picture_of_any_world_is_svg_with_a_disc_for_each_ball_that_is_there(name):
    world = WORLDS[name]()
    world.run(until=world.time + 1.0)
    root = ElementTree.fromstring(world._repr_svg_())
    discs = [disc for disc in root.iter(f"{SVG}circle") if disc.find(f"{SVG}title") is not None]
    here = [ball for ball in world.balls if not ball.gone]
    assert [disc.find(f"{SVG}title").text for disc in discs] == [ball.name for ball in here]
    for disc, ball in zip(discs, here, strict=True):
        x, y = float(disc.get("cx")), -float(disc.get("cy"))
        assert (x, y) == pytest.approx([1000.0 * at for at in ball.position], abs=0.06)


def test_the_ways_in_the_picture_are_those_of_the_trace(after):
    root = ElementTree.fromstring(after._repr_svg_())
    way, *_ = [path.get("d") for path in root.iter(f"{SVG}path")]
    curves = [[float(n) for n in re.findall(r"-?[\d.]+", leg)] for leg in way.split("M")[1:]]
    s = np.linspace(0.0, 1.0, 50)[:, None]
    drawn = np.concatenate([
        (1 - s) ** 2 * c[:2] + 2 * s * (1 - s) * np.array(c[2:4]) + s**2 * c[4:]
        for c in map(np.array, curves)
    ])  # fmt: skip
    _, paths = trace(after, 200.0)
    gaps = [min(np.hypot(*(drawn - spot).T)) for spot in paths[:, 0] * (1000.0, -1000.0)]
    assert max(gaps) < 25.0  # mm, half of what lies between two of the points
    assert np.median(gaps) < 8.0


def test_shots_are_laid_over_one_another_on_the_axes_of_a_figure(after):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("Agg")
    axes = None
    for law in ("rigid", "mathavan"):
        world = scenes.carom()
        world.cushion_law = law
        axes = simulate(world, "white", Shot(3.0, 35.0)).plot(axes, label=law, balls=["white"])
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["rigid", "mathavan"]
    figure, mine = pyplot.subplots()
    before = len(after.plot(ax=mine).patches)
    assert mine.figure is figure
    assert after.plot(ax=mine) is mine
    assert len(mine.patches) < 2 * before  # the table is there once
    with pytest.raises(ValueError, match="there is no ball 'blue'"):
        after.plot(ax=mine, balls=["blue"])
    pyplot.close("all")


def test_a_page_plays_the_legs_themselves(after):
    page = animate(after, speed=0.5).html()
    legs = json.loads(re.search(r"balls=(\[\[.*?\]\]\]),from=", page)[1])
    assert len(legs) == len(after.balls) == page.count("<circle")
    for mine, ball in zip(legs, after.balls, strict=True):
        for (time, x, y, *_), leg in zip(mine, after.log.legs(ball.name), strict=True):
            assert (time, x, y) == pytest.approx(
                (leg.time, leg.position.real, leg.position.imag), abs=1e-8
            )
    assert "rate=0.5," in page
    assert "http" not in page.replace("http://www.w3.org/2000/svg", "")  # it needs no network


def test_a_notebook_shows_the_page_in_a_frame_of_its_own():
    shown = animate(broken())._repr_html_()
    assert shown.count("<") == 2  # all of the page is escaped, names too
    assert "&amp;lt;cue&amp;gt;" in shown


@pytest.mark.parametrize("kind", ["html", "gif"])
def test_a_film_is_saved_and_tells_of_its_progress(after, tmp_path, kind):
    pytest.importorskip("matplotlib")
    seen = []
    film = animate(after, speed=after.time / 0.45, rate=10.0)
    film.save(tmp_path / f"film.{kind}", seen.append)
    assert (tmp_path / f"film.{kind}").stat().st_size > 2000
    if kind == "gif":
        from PIL import Image

        assert sum(seen) == len(film.times()) == 6
        with Image.open(tmp_path / "film.gif") as film_of_it:
            assert film_of_it.n_frames == 6
        assert film.times()[-1] == after.time


def test_an_mp4_is_saved_or_says_what_is_missing(after, tmp_path):
    animation = pytest.importorskip("matplotlib.animation")
    film = animate(after, speed=after.time / 0.2, rate=10.0)
    if animation.FFMpegWriter.isAvailable():
        film.save(tmp_path / "film.mp4")
        assert (tmp_path / "film.mp4").stat().st_size > 1000
    else:
        with pytest.raises(FileNotFoundError, match="need the program ffmpeg"):
            film.save(tmp_path / "film.mp4")


@pytest.mark.parametrize(
    ("ask", "words"),
    [(lambda w: animate(scenes.carom()), "nothing to animate"),
     (lambda w: animate(w, speed=0.0), "animate speed must be above zero"),
     (lambda w: animate(w, rate=-1.0), "animate rate must be above zero"),
     (lambda w: animate(w).save("film.avi"), "a .html, .gif or .mp4 file, not 'film.avi'"),
     (lambda w: animate(w, rate=1e6).save("film.gif"), "are too many: at most 20000")],
)  # fmt: skip
def test_a_film_that_cannot_be_is_refused(after, ask, words):
    with pytest.raises(ValueError, match=words):
        ask(after)


def test_logs_shots_ledgers_and_sensitivities_are_tables_in_a_notebook(after):
    seen = sensitivity(scenes.carom(), "white", Shot(2.0, 10.0))
    shot, book = Shot(2.0, 10.0, side=1.0), ledger(after.log)
    for thing, count in ((after.log, len(after.log)), (shot, 3), (seen, 8), (book, len(book))):
        root = ElementTree.fromstring(thing._repr_html_())
        assert len(root.findall("tbody/tr")) == count


def test_a_long_log_is_cut_and_says_how_long_it_is():
    log = scenes.rack15()
    log.run()
    shown = log.log._repr_html_()
    assert shown.count("<tr>") < 40
    assert f"{len(log.log)} events" in shown


def test_whatever_a_session_shows_is_short(after):
    seen = sensitivity(scenes.carom(), "white", Shot(2.0, 10.0))
    things = [after, after.log, Shot(2.0), seen, seen.events[0], ledger(after.log), animate(after)]
    things += [tables.pool_9ft().table, CueStroke(3.0, side=0.1), after.log.legs("white")[0]]
    times, paths = trace(after, times=np.arange(0.0, 0.2, 0.02))
    things += [recover(times, paths[:, 0], after.cloth), Track(times, paths, name="one")]
    things += [ledger(after.log)[0], store.Played.of(scenes.carom(), "white", Shot(2.0))]
    things += [after.balls[0], after.log[0], after.log.at([0.0, 1.0])["red"]]
    assert [repr(thing) for thing in things if len(repr(thing)) > 120] == []
    assert repr(CueStroke(3.0, side=0.1)) == "CueStroke(speed=3.0, side=0.1)"
    assert repr(Shot(2.0, 10.0, side=-1.5)) == "Shot(speed=2.0, angle=10.0, side=-1.5)"
    assert eval(repr(Shot(2.0, follow=0.1))) == Shot(2.0, follow=0.1)


def test_importing_physics_loads_nothing_that_shows():
    code = (
        "import sys, physics; "
        "print([m for m in sys.modules if m.startswith('physics.') and m.split('.')[-1] in "
        "('svg', 'plot', 'animation', 'markup', 'moments', 'aim', 'ledger')])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
