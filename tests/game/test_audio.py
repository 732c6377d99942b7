"""Sounds: what they are made of, which ones are heard, and that silence costs nothing."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pygame
import pytest

from game.__main__ import new_game
from game.app import App
from game.options import Options
from game.session.action import Action
from game.sound import audio, hearing, synth
from game.sound.audio import Audio, sides
from game.sound.hearing import SILENCE, Ear, Heard, Sound
from game.table.presets import scene_world, table_world
from game.ui.view import View
from physics import Ball, Shot, tables
from tests.support.players import FRAME, press, run_to_rest

LOUD = Sound("click", 7, 1.0, 0.0)


@pytest.fixture(scope="module")
def bank():
    return dict(audio.bank())


@pytest.fixture(autouse=True)
def _no_mixer():
    yield
    pygame.mixer.quit()


def centroid(wave):
    power = np.abs(np.fft.rfft(wave)) ** 2
    return float((np.fft.rfftfreq(wave.size, 1 / synth.RATE) * power).sum() / power.sum())


def gone(wave):
    """Seconds until nine tenths of a sound's energy have been heard."""
    return int(np.searchsorted(np.cumsum(wave**2), 0.9 * np.sum(wave**2))) / synth.RATE


# -- what they are made of -----------------------------------------------------------------------


def test_every_sound_peaks_at_one_and_ends_in_silence(bank):
    for (kind, _), wave in bank.items():
        assert np.abs(wave).max() == pytest.approx(1.0)
        if kind != "rumble":
            assert abs(wave[-1]) < 1e-12
            assert gone(wave) < 0.05


def test_the_push_of_a_click_takes_as_long_as_hertz_says():
    radius, mass, young, poisson = 0.03075, 0.21, 5.8e9, 0.34
    stiff = young / (2 * (1 - poisson**2))
    taken = 2.87 * ((mass / 2) ** 2 / (radius / 2 * stiff**2 * 1.0)) ** 0.2
    assert pytest.approx(taken, rel=0.02) == synth.CLICK.contact


def test_harder_clicks_are_brighter_and_shorter(bank):
    clicks = [bank["click", k] for k in range(8)]
    assert all(centroid(soft) < centroid(hard) for soft, hard in pairwise(clicks))
    assert gone(clicks[7]) < gone(clicks[0])


def test_a_cushion_is_deeper_than_a_stroke_and_a_stroke_than_a_click(bank):
    deep, middle, bright = (centroid(bank[kind, 5]) for kind in ("thud", "stroke", "click"))
    assert deep < middle / 1.5 < bright / 1.5**2


def test_the_rumble_runs_on_from_its_end_to_its_beginning(bank):
    wave = bank["rumble", 0]
    assert abs(wave[0] - wave[-1]) <= np.abs(np.diff(wave)).max()


def test_a_closing_speed_gets_the_nearest_level_by_ratio():
    assert [synth.loudness(v) for v in synth.SPEEDS] == list(range(8))
    assert synth.loudness(0.0) == 0
    assert synth.loudness(50.0) == 7
    assert synth.loudness(0.1 * 1.4) == 1
    assert synth.loudness(0.1 * 1.45) == 2


def test_pan_keeps_the_power_and_the_left_end_is_louder_on_the_left():
    for pan in (-1.0, -0.3, 0.0, 0.8):
        left, right = sides(0.5, pan)
        assert left**2 + right**2 == pytest.approx(0.25)
    left, right = sides(1.0, -1.0)
    assert left > 2 * right > 0


def test_a_jaw_is_brighter_than_a_cushion_and_a_ball_that_drops_is_the_deepest_of_all(bank):
    deep, cushion, jaw, click = (centroid(bank[k, 5]) for k in ("drop", "thud", "jaw", "click"))
    assert deep < cushion < jaw < click


def test_a_hard_chain_of_balls_is_heard_longer_than_a_click(bank):
    for level in range(4, 8):
        assert gone(bank["chain", level]) > 2 * gone(bank["click", level])


# -- which ones are heard ------------------------------------------------------------------------


def a_break(seconds=0.0):
    world = scene_world("rack15")
    ear = Ear(1.2)
    ear.listen(world, 0)
    world.run(world.time + seconds)
    return world, ear


def test_of_a_break_the_loudest_few_are_heard_loudest_first():
    world, ear = a_break(0.9)
    assert len(world.log) > 2 * hearing.LOUDEST
    gains = [sound.gain for sound in ear.listen(world, 0).sounds]
    assert len(gains) == hearing.LOUDEST
    assert gains == sorted(gains, reverse=True)


def test_only_so_many_events_of_a_frame_are_looked_at(monkeypatch):
    looked = []
    monkeypatch.setattr(hearing, "_of_event", lambda event, half: looked.append(event))
    world, ear = a_break(0.9)
    ear.listen(world, 0)
    assert len(world.log) > len(looked) == hearing.LOOKED_AT


def test_every_hit_of_a_slow_shot_is_heard_once_and_with_its_own_kind():
    world = table_world("medium")
    world.strike("white", Shot(3.5, 34.5, follow=1, side=2))
    ear, heard = Ear(1.27), []
    heard += ear.listen(world, 1, (world.ball("white"), 3.5)).sounds
    for _ in range(600):
        world.step(1 / 60)
        heard += ear.listen(world, 1).sounds
    names = {"ball": "click", "cushion": "thud"}
    events = [names[e.kind] for e in world.log if e.kind in names]
    assert [sound.kind for sound in heard] == ["stroke", *events]


def test_gain_follows_the_impulse_and_pan_the_place():
    world = table_world("medium")
    white = world.ball("white")
    soft, hard = (Ear(1.27).listen(world, 1, (white, v)).sounds[0] for v in (1.0, 2.0))
    assert hard.gain / soft.gain == pytest.approx(2**hearing.LOUDNESS)
    assert soft.pan == pytest.approx(white.position[0] / 1.27)


def listened(world, seconds, shot=1):
    """All sounds of so many seconds, sixty times a second."""
    ear, found = Ear(1.27), []
    for _ in range(round(60 * seconds)):
        found += ear.listen(world, shot).sounds
        world.step(1 / 60)
    return found


def potted(speed):
    world = tables.pool_9ft()
    world.add(Ball("cue", at=(0.9, 0.3)))
    world.strike("cue", Shot(speed, 42.5))
    return world


def test_a_ball_is_heard_to_drop_on_the_side_of_its_pocket_and_louder_the_faster_it_is():
    slow, fast = (listened(potted(v), 3.0) for v in (0.9, 5.0))
    (soft,), (loud,) = ([s for s in heard if s.kind == "drop"] for heard in (slow, fast))
    assert soft.gain < loud.gain <= 1.0
    assert soft.loudness < loud.loudness
    assert soft.pan == pytest.approx(1.0, abs=0.05)


def test_a_rail_and_the_jaws_of_a_pocket_sound_different():
    world = tables.pool_9ft()
    world.add(Ball("cue", at=(0.9, 0.3)))
    world.strike("cue", Shot(2.0, 60.0))
    heard = listened(world, 6.0)
    walls = [e.wall.rsplit(" ", 1)[-1] for e in world.log if e.kind == "cushion"]
    kinds = ["jaw" if wall in hearing.JAWS else "thud" for wall in walls]
    assert [s.kind for s in heard if s.kind in ("jaw", "thud")] == kinds
    assert "thud" in kinds
    world = tables.pool_9ft()
    world.add(Ball("cue", at=(0.9, 0.3)))
    world.strike("cue", Shot(2.0, 46.4))
    assert "jaw" in [s.kind for s in listened(world, 4.0)]


def test_the_hits_of_a_pack_that_are_too_many_to_hear_become_a_chain():
    world, ear = a_break(0.9)
    sounds = ear.listen(world, 0).sounds
    (chain,) = (s for s in sounds if s.kind == "chain")
    assert len(sounds) == hearing.LOUDEST
    quiet = [s for s in sounds if s.kind == "click"]
    assert chain.gain > min(s.gain for s in quiet) * 0.5


def test_two_balls_and_a_cushion_at_once_are_three_sounds():
    sounds = [Sound("click", 3, 0.5, 0.0), Sound("thud", 3, 0.4, 0.0), Sound("click", 2, 0.1, 0.0)]
    assert hearing._few(sounds, 0) == sounds


def test_a_leap_to_the_end_and_a_way_back_in_time_are_silent():
    world, ear = a_break(2 * hearing.JUMP)
    assert ear.listen(world, 0) == SILENCE
    assert ear.listen(table_world("medium"), 0) == SILENCE


def test_rolling_is_heard_while_balls_roll_and_time_runs():
    world = table_world("medium")
    world.strike("white", Shot(2.0))
    ear = Ear(1.27)
    ear.listen(world, 1)
    world.step(1 / 60)
    assert ear.listen(world, 1).rolling > 0.0
    assert ear.listen(world, 1).rolling == 0.0


# -- the loudspeaker -----------------------------------------------------------------------------


def test_the_first_sound_opens_the_mixer_and_not_before():
    speaker = Audio()
    speaker.play(SILENCE, 0)
    assert pygame.mixer.get_init() is None
    speaker.play(Heard((LOUD,), 0.05), 0)
    assert pygame.mixer.get_init() == (synth.RATE, -16, 2)
    assert pygame.mixer.get_busy()
    speaker.close()
    assert pygame.mixer.get_init() is None


def test_the_mixer_closes_after_a_long_silence_and_opens_again():
    speaker = Audio()
    speaker.play(Heard((LOUD,), 0.0), 1000)
    speaker.play(SILENCE, 1000 + audio.PATIENCE)
    assert pygame.mixer.get_init()
    speaker.play(SILENCE, 1001 + audio.PATIENCE)
    assert pygame.mixer.get_init() is None
    speaker.play(Heard((LOUD,), 0.0), 10 * audio.PATIENCE)
    assert pygame.mixer.get_busy()


@pytest.mark.parametrize("speaker", [Audio(muted=True), Audio(volume=0.0)])
def test_a_muted_loudspeaker_opens_nothing(speaker):
    speaker.play(Heard((LOUD,), 0.1), 0)
    assert speaker.silent
    assert pygame.mixer.get_init() is None


def test_without_a_device_there_is_silence_and_not_a_word(monkeypatch, capfd):
    monkeypatch.setenv("SDL_AUDIODRIVER", "there is none")
    speaker = Audio()
    for _ in range(3):
        speaker.play(Heard((LOUD,), 0.0), 0)
    assert speaker.broken
    assert capfd.readouterr() == ("", "")


class Channel:
    """Takes what a mixer's channel takes."""

    def __init__(self):
        self.gains = []

    def play(self, sound):
        pass

    def set_volume(self, left, right):
        self.gains.append((left, right))


def volumes(monkeypatch, volume, sounds):
    channel, speaker = Channel(), Audio(volume)
    monkeypatch.setattr(pygame.mixer, "find_channel", lambda: channel)
    speaker.play(Heard(sounds, 0.0), 0)
    return np.array(channel.gains)


def test_the_loudest_frame_does_not_clip(monkeypatch):
    gains = volumes(monkeypatch, 1.0, (LOUD,) * hearing.LOUDEST)
    assert len(gains) == hearing.LOUDEST
    assert (gains.sum(axis=0) * audio.HEADROOM <= 1.0).all()


def test_half_the_volume_is_a_quarter_of_the_pressure(monkeypatch):
    full, half = (volumes(monkeypatch, v, (LOUD,)) for v in (1.0, 0.5))
    assert half == pytest.approx(full / 4)


# -- in the game ---------------------------------------------------------------------------------


@pytest.fixture
def app(monkeypatch):
    monkeypatch.setattr(View, "draw", lambda view, surface: [])
    chosen = replace(Options(), size=(640, 360))
    return App(new_game(chosen), chosen)


@pytest.fixture
def played(app, monkeypatch):
    """The kinds of the sounds that the app has begun."""
    kinds = []
    listen = app.ear.listen

    def listened(*args):
        heard = listen(*args)
        kinds.extend(sound.kind for sound in heard.sounds)
        return heard

    monkeypatch.setattr(app.ear, "listen", listened)
    return kinds


def test_a_shot_in_the_game_sounds_like_its_events(app, played):
    press(app, "return")
    while app.session.moving:
        app.frame(FRAME)
    hits = [e.kind for e in app.session.world.log if e.kind in ("ball", "cushion")]
    assert played.count("stroke") == 1
    assert played.count("click") == hits.count("ball")
    assert played.count("thud") == hits.count("cushion")


def test_m_mutes_and_then_nobody_listens(app, played):
    press(app, "m", "return")
    assert app.session.moving
    run_to_rest(app)
    assert app.preferences.settings.muted
    assert played == []
    assert pygame.mixer.get_init() is None


def test_muting_closes_the_mixer_at_once(app):
    press(app, "return")
    app.frame(FRAME)
    assert pygame.mixer.get_init()
    press(app, "m")
    assert pygame.mixer.get_init() is None


def test_a_shot_looked_at_again_sounds_as_it_did_but_not_while_it_is_dragged(app, played):
    press(app, "return")
    run_to_rest(app)
    app.frame(FRAME)
    played.clear()
    heard = []
    app.preferences.audio.play = lambda sounds, now: heard.extend(s.kind for s in sounds.sounds)
    press(app, "home", "p")
    while app.session.timeline.at is not None:
        app.frame(FRAME)
    hits = [e.kind for e in app.session.world.log if e.kind in ("ball", "cushion")]
    assert heard.count("click") == hits.count("ball")
    assert heard.count("thud") == hits.count("cushion")
    assert "stroke" not in heard
    heard.clear()
    press(app, "home")
    app.perform(Action("scrub", 2 * FRAME))
    for _ in range(60):
        app.perform(Action("frame"))
        app.frame(FRAME)
    assert heard == []


def test_going_to_the_end_at_once_is_silent_but_for_the_stroke(app, played):
    press(app, "return", "end")
    assert not app.session.moving
    assert set(played) <= {"stroke"}
