"""Batches on a graphics card: what can be proven without one.

numba's simulator plays the very kernel, a Python thread for each of the card's; NVVM compiles it.
"""

import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

from benchmarks import cuda as benchmark
from physics import Shot, TimeStepping, laws, scenes, simulate_many

numba = pytest.importorskip("numba", reason="a card is played by numba")
cuda = pytest.importorskip("numba.cuda")
if os.environ.get("NUMBA_ENABLE_CUDASIM") == "1":
    pytest.skip("the simulator stands in for the card", allow_module_level=True)

without_card = pytest.mark.skipif(cuda.is_available(), reason="there is a card here")


def on_the_simulator(*words):
    environment = {**os.environ, "NUMBA_ENABLE_CUDASIM": "1"}
    return subprocess.run([sys.executable, *words], env=environment, capture_output=True, text=True)


def simulated(scene, shots):
    return on_the_simulator("-m", "tests.support.simulated_card", scene, str(shots))


def test_numbas_simulator_of_a_card_gives_the_bits_of_the_cpu():
    done = simulated("carom", 1)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "0 shots differ" in done.stdout


@pytest.mark.stress
@pytest.mark.parametrize(
    ("scene", "shots"),
    [
        ("carom", 24),
        ("Mathavan's cushion", 8),
        ("8-ball break, pockets", 3),
        ("36 balls, cells", 2),
    ],
)
def test_the_simulator_gives_them_in_every_kind_of_scene(scene, shots):
    done = simulated(scene, shots)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "0 shots differ" in done.stdout


@pytest.mark.stress
def test_the_benchmark_of_a_card_is_ready_to_be_run(tmp_path):
    words = ["--smallest", "--out", str(tmp_path)]
    code = (
        "import sys; from benchmarks.cuda import main; from tests.support import simulated_card;"
        f"simulated_card.read_fields_as_a_card_does(); sys.exit(main({words}))"
    )
    done = on_the_simulator("-c", code)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "shots that differ" in (tmp_path / "cuda.md").read_text()


def refused(what, **how):
    with pytest.raises(what) as refusal:
        simulate_many(scenes.carom(), "white", [Shot(2.0)], **how)
    return str(refusal.value)


def test_a_device_that_there_is_not_is_refused():
    assert refused(ValueError, device="gpu").endswith("must be 'cpu' or 'cuda', not 'gpu'")


def test_a_card_shares_its_work_with_no_one():
    assert "no executor" in refused(ValueError, device="cuda", executor=ThreadPoolExecutor(1))
    assert "no compiled=False" in refused(ValueError, device="cuda", compiled=False)


@without_card
def test_without_a_card_the_error_says_so():
    assert "finds no CUDA device" in refused(RuntimeError, device="cuda")


def test_without_numba_the_error_names_the_extra(monkeypatch):
    monkeypatch.delitem(sys.modules, "physics.batch.card", raising=False)
    monkeypatch.delattr("physics.batch.card", raising=False)
    monkeypatch.setitem(sys.modules, "numba", None)
    assert "danggu[cuda]" in refused(ImportError, device="cuda")


@laws.compiled
def custom(v, roll, side):
    return complex(-v.real, v.imag), roll, side


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"cushion_law": custom}, "plays no custom laws"),
        ({"engine": TimeStepping(1e-3)}, "Stepping"),
        ({"cluster_law": "hertz"}, "HertzCluster"),
    ],
)
def test_what_a_card_does_not_play_is_refused_by_name(change, said):
    world = scenes.carom()
    for name, value in change.items():
        setattr(world, name, value)
    with pytest.raises(ValueError, match="device='cuda' plays") as refusal:
        simulate_many(world, "white", [Shot(2.0)], device="cuda")
    assert said in str(refusal.value)


@pytest.mark.stress
def test_the_kernel_compiles_for_a_card_and_fuses_no_product_with_a_sum(tmp_path):
    try:
        text = benchmark.ptx()
    except Exception as error:
        if "NVVM" not in str(error) and "libnvvm" not in str(error).lower():
            raise
        pytest.skip(f"NVVM is not to be had, which the extra `cuda` brings: {error}")
    assert text.count(".entry") == 1
    assert not re.search(r"\bfma\.|\.approx|\b(mul|add|sub|div|sqrt)\.(ftz\.)?f64", text)
    assert "mul.rn.f64" in text
    print(*benchmark.assembled(text, tmp_path), sep="\n")
