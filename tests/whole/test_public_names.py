"""What `import physics` and `import danggu` give, and what they cost."""

import subprocess
import sys
from importlib.metadata import version

import pytest

import danggu
import physics
from physics import tables


@pytest.mark.parametrize("package", [physics, danggu, tables], ids=lambda package: package.__name__)
def test_completion_finds_every_public_name_and_none_that_is_private(package):
    names = dir(package)
    assert {*names} - {"__version__"} == {*package.__all__}
    assert ("__version__" in names) == hasattr(package, "__version__")
    assert [name for name in names if name[0] == "_" and name != "__version__"] == []
    assert [name for name in names if not hasattr(package, name)] == []


def test_danggu_gives_the_names_of_physics_itself():
    assert {*danggu.__all__} == {*physics.__all__, "players", "rules"}
    assert all(getattr(danggu, name) is getattr(physics, name) for name in physics.__all__)
    assert danggu.__version__ == physics.__version__ == version("danggu")


@pytest.mark.parametrize("package", [physics, danggu], ids=["physics", "danggu"])
def test_a_name_that_does_not_exist_is_an_error_that_says_so(package):
    with pytest.raises(AttributeError, match=f"'{package.__name__}' has no attribute 'bal'"):
        _ = package.bal


@pytest.mark.parametrize("name", ["Ball", "rules", "players", "scenes", "__version__"])
def test_import_danggu_loads_nothing_but_what_is_asked_for(name):
    code = (
        "import sys, danggu; assert 'physics' not in sys.modules; danggu.{}; "
        "print(sorted({{'numpy', 'pygame', 'numba', 'game'}} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code.format(name)], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"
