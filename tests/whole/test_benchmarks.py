"""Every measurement runs at its smallest and says what it should; none is held to seconds."""

import csv
from collections import Counter

import pytest

from benchmarks import __main__ as benchmarks
from benchmarks import report, scale, switches
from benchmarks.crowds import field, gas
from benchmarks.skips import go, planned
from benchmarks.speed import compiled_fan
from benchmarks.timing import in_turns
from benchmarks.work_precision import Setting, order, sample
from benchmarks.workload import break_shot, fan, play_fan, truth
from physics import scenes, simulate

NEEDS = {
    "speed": ["numba"], "work-precision": ["numba", "mpmath", "matplotlib"],
    "scale": ["numba", "matplotlib"], "peers": ["numba"], "skips": [], "batch": ["numba"],
    "frame": [], "envs": ["gymnasium", "numba"], "influence": [], "coach": ["numba"],
}  # fmt: skip
# what these measure with is tried below, or needs nothing else than the pages of the others
LONG = ("speed", "work-precision", "scale", "skips")


@pytest.mark.parametrize(
    "command", [pytest.param(c, marks=[pytest.mark.stress] * (c in LONG)) for c in NEEDS]
)
def test_a_measurement_writes_its_page_and_its_numbers(command, tmp_path, capsys):
    for module in NEEDS[command]:
        pytest.importorskip(module)
    assert benchmarks.main([command, "--smallest", "--out", str(tmp_path)]) == 0
    page = (tmp_path / f"{command}.md").read_text(encoding="utf-8")
    assert "Measured on " in page
    assert "CHANGED" not in page
    assert page.splitlines()[0].removeprefix("# ") in capsys.readouterr().out
    with (tmp_path / f"{command}.csv").open() as file:
        heads, *rows = csv.reader(file)
    assert rows
    assert all(len(row) == len(heads) for row in rows)
    for picture in tmp_path.glob("*.png"):
        assert 1000 < picture.stat().st_size < 150_000


@pytest.mark.parametrize("command", [*NEEDS, "all", "cuda", "golden", "stress"])
def test_every_command_says_how_it_is_used(command, capsys):
    with pytest.raises(SystemExit) as left:
        benchmarks.main([command, "--help"])
    assert left.value.code == 0
    assert f"usage: python -m benchmarks {command}" in capsys.readouterr().out


def test_a_gas_goes_on_and_a_shot_among_many_ends():
    assert 40 <= scale.advance_for(gas(30), 40) < 80
    assert len(simulate(field(16), "0", scale.SHOT).log) > 4


def test_the_compiled_fan_plays_the_shots_of_the_interpreted_one():
    pytest.importorskip("numba")
    batch = compiled_fan(12)
    batch()
    assert batch.events.sum() == play_fan(scenes.carom(), fan(720)[:12])


def test_a_step_ends_off_the_exact_engine_by_what_it_is_late():
    pytest.importorskip("mpmath")
    true = truth(scenes.single)
    early, late = (sample(scenes.single, "thesis", dt, true)[1] for dt in (1e-4, 1e-2))
    assert 0.0 < max(early) < max(late) < 1.0


def test_what_takes_turns_is_run_once_a_round_and_each_is_first_in_turn():
    seen: list[str] = []
    runs = {name: (lambda name=name: seen.append(name)) for name in "abc"}
    in_turns(runs, 3)
    assert "".join(seen) == "abcbcacab"


def test_the_order_of_a_method_is_found_from_errors_that_scatter():
    """Errors of C h^1.5, each off by up to a third."""
    settings = []
    for n in (1, 3, 10, 30):
        steps = [1e-2 / n * 2.0 ** (k / 18 - 0.25) for k in range(9)]
        errors = [0.2 * h**1.5 * (1 + (k * 7 % 9 - 4) / 12) for k, h in enumerate(steps)]
        settings.append(Setting("", "", n, steps, [1.0] * 9, [errors]))
    best, low, high = order(settings, 0)
    assert low <= 1.5 <= high
    assert best == pytest.approx(1.5, abs=0.1)


def test_errors_of_another_outcome_have_no_order():
    settings = [Setting("", "", n, [0.1 / n] * 3, [1.0] * 3, [[0.6, 1.0, 2.0]]) for n in (1, 3, 10)]
    assert order(settings, 0) is None


@pytest.mark.parametrize("switch", switches.SWITCHES, ids=lambda switch: switch.name)
def test_no_bit_of_a_break_hangs_on_a_shortcut(switch):
    plain, long = switches.fresh(), switches.fresh()
    switch.off(long)
    expected = go(plain, planned(break_shot, plain))
    assert repr(go(long, planned(break_shot, long))) == repr(expected)
    assert expected[1] > 100


def test_each_shortcut_that_saves_work_is_seen_to_save_it():
    """In the break: boxes and the table of meetings save pair solves, the rest saves the rest."""

    def work(off=None):
        package = switches.fresh()
        if off is not None:
            off(package)
        done: Counter[str] = Counter()
        switches.count(package, done)
        go(package, planned(break_shot, package))
        return done

    plain = work()
    assert work(switches.without_boxes)["pair solves"] > 3 * plain["pair solves"]
    assert work(switches.without_table)["pair solves"] > 2 * plain["pair solves"]
    assert work(switches.without_memory)["legs planned"] > 10 * plain["legs planned"]
    assert work(switches.without_reach)["quadratics"] > plain["quadratics"]


def test_quick_results_stay_apart_from_those_that_are_kept():
    assert report.options("speed", "", []).out == report.RESULTS
    assert report.options("speed", "", ["--quick"]).out != report.RESULTS


@pytest.mark.parametrize(
    ("said", "why"),
    [
        (["speed", "--quick", "--smallest"], "not allowed with"),
        (["speed", "--out", ""], "--out: must not be empty"),
        (["speed", "--out", __file__], "not a folder"),
        (["speed", "--out", "a", "--out", "b"], "--out: is there twice"),
        (["stress", "--short", "--count", "5"], "not allowed with"),
        (["stress", "--only", "1", "--count", "5"], "not allowed with"),
        (["stress", "--count", "0"], "'0' is no whole number from 1 on"),
        (["stress", "--only", "-1"], "'-1' is no whole number from 0 on"),
        (["stress", "--write", ""], "--write: must not be empty"),
        (["stress", "--write", "/nowhere/at/all.md"], "there is no folder /nowhere/at"),
        (["golden", "--quick"], "--quick"),
        (["all", "--quick", "--smallest"], "not allowed with"),
    ],
)
def test_options_that_say_nothing_or_contradict_each_other_are_refused(said, why, capsys):
    with pytest.raises(SystemExit) as left:
        benchmarks.main(said)
    assert left.value.code == 2
    assert why in capsys.readouterr().err.splitlines()[-1]
