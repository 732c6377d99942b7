"""What the physics package offers can be found without reading it."""

import subprocess
import sys

import physics


def test_dir_lists_what_has_not_been_loaded_yet():
    code = "import physics; print(dir(physics) == sorted(physics.__all__))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout == "True\n", done.stderr


def test_every_public_name_can_be_had():
    for name in physics.__all__:
        assert getattr(physics, name) is not None
