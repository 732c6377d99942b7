"""What `import physics` and `import danggu` give, and what they cost."""

import subprocess
import sys
from importlib.metadata import version
from types import ModuleType

import pytest

import danggu
import physics
from danggu import labs, players, rules
from physics import aim, laws, scenes, store, tables, tracks

PUBLIC = [physics, danggu, labs, players, rules, aim, laws, scenes, store, tables, tracks]


@pytest.mark.parametrize("package", PUBLIC, ids=lambda package: package.__name__)
def test_completion_finds_every_public_name_and_none_that_is_private(package):
    names = dir(package)
    assert {*names} - {"__version__"} == {*package.__all__}
    assert ("__version__" in names) == hasattr(package, "__version__")
    assert [name for name in names if name[0] == "_" and name != "__version__"] == []
    assert [name for name in names if not hasattr(package, name)] == []


def test_every_module_among_the_public_names_says_what_is_public_in_it():
    names = [getattr(package, name) for package in (physics, danggu) for name in dir(package)]
    modules = {name for name in names if isinstance(name, ModuleType)}
    assert modules == {*PUBLIC} - {physics, danggu}


def test_a_name_is_a_call_or_a_module_and_not_both():
    for package in PUBLIC:
        for name in dir(package):
            thing = getattr(package, name)
            assert not (isinstance(thing, ModuleType) and name in thing.__dict__.get("__all__", ()))


@pytest.mark.parametrize("package", [labs, players, rules, aim, laws, scenes, store, tracks])
def test_a_public_module_has_no_imports_of_its_own_among_its_names(package):
    assert "Any" not in dir(package)
    assert "annotations" not in dir(package)
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        _ = package.nothing


def test_danggu_gives_the_names_of_physics_itself():
    assert {*danggu.__all__} == {*physics.__all__, "labs", "players", "rules"}
    assert all(getattr(danggu, name) is getattr(physics, name) for name in physics.__all__)
    assert danggu.__version__ == physics.__version__ == version("danggu")


@pytest.mark.parametrize("package", [physics, danggu], ids=["physics", "danggu"])
def test_a_name_that_does_not_exist_is_an_error_that_says_so(package):
    with pytest.raises(AttributeError, match=f"'{package.__name__}' has no attribute 'bal'"):
        _ = package.bal


@pytest.mark.parametrize("name", ["Ball", "labs", "rules", "players", "scenes", "__version__"])
def test_import_danggu_loads_nothing_but_what_is_asked_for(name):
    code = (
        "import sys, danggu; assert 'physics' not in sys.modules; danggu.{}; "
        "print(sorted({{'numpy', 'pygame', 'numba', 'game'}} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code.format(name)], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"
