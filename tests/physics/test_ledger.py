"""The log as a ledger: every joule has an entry."""

import csv
from dataclasses import replace
from math import fsum, inf

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics import (
    Ball,
    Shot,
    World,
    laws,
    ledger,
    scenes,
    simulate,
    store,
    tables,
)
from physics.studies.ledger import Entry

SHOT = Shot(3.0, 37.0, follow=0.5, side=1.5)


def open_balance(world):
    """How far the ledger is from closing at its worst entry, as a share of all energy."""
    log = world.log
    start = fsum(
        log.legs(name)[0].energy(mass) for name, mass in zip(log.names, log.masses, strict=True)
    )
    entries = list(ledger(log))
    losses = [entry.energy_lost + entry.cloth_lost for entry in entries]
    whole = max(start, *(entry.energy for entry in entries))
    assert whole > 0.0
    return max(
        abs(start - fsum(losses[: k + 1]) - entry.energy) / whole for k, entry in enumerate(entries)
    )


@pytest.mark.parametrize("law", [None, laws.HertzCluster()], ids=["ties", "springs"])
@pytest.mark.parametrize("name", scenes.SCENES)
def test_the_energies_of_every_scene_add_up_at_every_event(name, law):
    world = scenes.SCENES[name]()
    world.cluster_law = law
    if world.at_rest:
        world.strike(world.balls[0], SHOT)
    world.run(inf if world.cloth.roll else 20.0)  # on ice a billiard goes on without end
    assert open_balance(world) < 1e-12


def test_the_energies_of_a_tight_rack_add_up_at_every_contact_of_the_cluster():
    for law in (None, laws.HertzCluster()):
        world = scenes.rack15(gap=0.0)
        world.cluster_law = law
        world.run()
        entries = list(ledger(world.log))
        instants = [entry.time for entry in entries if entry.kind == "ball"]
        assert instants.count(instants[0]) > 10
        assert open_balance(world) < 1e-12


@given(st.integers(0, 10_000))
@settings(max_examples=20, deadline=None)
def test_the_energies_of_random_scenes_add_up_whoever_meddles(seed):
    draw = np.random.default_rng(seed)
    world = tables.match_carom() if seed % 2 else tables.thesis()
    for k in range(draw.integers(1, 12)):
        spin = tuple(draw.uniform(-60.0, 60.0, 3))
        at = (-1.1 + 0.2 * k, draw.uniform(-0.55, 0.55))
        world.add(
            Ball(f"{k}", at, tuple(draw.uniform(-3.0, 3.0, 2)), spin, mass=draw.uniform(0.1, 0.4))
        )
    world.run(until=0.5)
    world.strike("0", Shot(2.0, draw.uniform(0.0, 360.0)))
    world.run(until=world.next_event)  # and a stroke at the very instant of an event
    world.strike(world.log[-1].balls[0], Shot(1.0, 10.0, side=1.0))
    world.run()
    assert open_balance(world) < 1e-12
    kinds = [entry.kind for entry in ledger(world.log)]
    assert kinds.count("hand") == 2
    assert len(kinds) == len(world.log) + 2


def test_an_entry_says_what_its_event_says():
    world = simulate(scenes.carom(), "white", SHOT)
    for entry, event in zip(ledger(world.log), world.log, strict=True):
        assert (entry.time, entry.kind, entry.ball) == (event.time, event.kind, event.balls[0])
        assert (entry.wall or None, (entry.x, entry.y)) == (event.wall, event.point)
        speed = np.hypot(*event.before[0].velocity), np.hypot(*event.after[0].velocity)
        assert (entry.speed_before, entry.speed_after) == pytest.approx(speed, rel=1e-15)
        assert (entry.impulse, entry.energy_lost) == (event.impulse, event.energy_lost)
        assert entry.cloth_lost >= 0.0
    assert entry.energy == pytest.approx(0.0, abs=1e-25)


def test_the_table_and_the_csv_file_hold_the_whole_ledger(tmp_path):
    world = simulate(scenes.carom(), "white", SHOT)
    entries = list(ledger(world.log))
    array = ledger(world.log).table()
    assert array.dtype.names == Entry._fields
    assert [tuple(row) for row in array.tolist()] == [tuple(entry) for entry in entries]
    ledger(world.log).write_csv(tmp_path / "shot.csv")
    with (tmp_path / "shot.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["energy"]) for row in rows] == [entry.energy for entry in entries]
    assert [row["wall"] for row in rows] == [entry.wall for entry in entries]
    assert len(ledger(World().log).table()) == 0
    assert inf not in array["time"]


def test_a_table_comes_back_from_its_file_and_from_that_of_a_world(tmp_path):
    path = tmp_path / "table.json"
    for table in (tables.MATCH_CAROM_2, tables.MEDIUM_CAROM_2, tables.pool(9), tables.THESIS):
        tables.save(table, path)
        assert tables.load(path) == table
    world = tables.match_carom()
    world.add(Ball("white", at=(0.0, 0.0)))
    world.cloth = world.cloth.rolling(lambda v: 0.04 + 0.0125 * v)
    store.save(world, path)
    assert tables.load(path) == replace(tables.MATCH_CAROM_2, cloth=world.cloth)


def test_a_file_without_a_table_is_refused_by_its_name(tmp_path):
    path = tmp_path / "table.json"
    for thing in (World(), Shot(1.0)):
        store.save(thing, path)
        with pytest.raises(ValueError, match=r"table.json: there is no table in it"):
            tables.load(path)
    path.write_text("{")
    with pytest.raises(ValueError, match=r"table.json: not JSON"):
        tables.load(path)
    with pytest.raises(ValueError, match=r"tables.save takes a Table"):
        tables.save(World(), path)
    with pytest.raises(FileNotFoundError):
        tables.load(tmp_path / "none.json")


def test_the_ledger_sums_what_was_lost_by_cause():
    world = simulate(scenes.carom(), "white", SHOT)
    lost = ledger(world.log).lost()
    assert {*lost} == {"cloth", *(event.kind for event in world.log)}
    assert [*lost.values()] == sorted(lost.values(), reverse=True)
    start = world.log.legs("white")[0].energy(world.ball("white").mass)
    assert fsum(lost.values()) == pytest.approx(start, rel=1e-12)
    assert repr(ledger(world.log)).startswith(f"<Ledger of {len(world.log)} entries; J lost: c")
    assert repr(ledger(World().log)) == "<Ledger of 0 entries; J lost: none>"
