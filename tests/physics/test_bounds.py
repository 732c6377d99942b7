"""The compiled kernel reads and writes nothing beyond its arrays: nothing else would notice."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("numba", reason="compiled batches need the extra `fast`")

ROOT = Path(__file__).parents[2]


@pytest.mark.stress
def test_no_index_of_the_compiled_kernel_is_out_of_bounds(tmp_path):
    environment = {
        **os.environ, "NUMBA_BOUNDSCHECK": "1", "XDG_CACHE_HOME": str(tmp_path),
        "PYTHONPATH": str(ROOT),
    }  # fmt: skip
    end = subprocess.run(
        [sys.executable, "-m", "tests.support.bounds"],
        env=environment,
        capture_output=True,
        text=True,
    )
    assert end.returncode == 0, end.stderr
    played = [line.rpartition(" ")[0] for line in end.stdout.splitlines()]
    assert played[:-1] == [
        "carom", "mathavan", "clusters", "cells", "jumps", "jumps in a crowd"
    ]  # fmt: skip
    assert end.stdout.endswith("checked\n")  # an index was out of bounds there, and was caught
