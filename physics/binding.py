"""The kernel loaded a second time, with another module in place of its subset."""

import importlib
import importlib.util
import sys
from pathlib import Path
from types import ModuleType

FOLDER = Path(__file__).parent / "kernel"


def load(name: str, subset: ModuleType) -> ModuleType:
    """The package physics.kernel under another name, with `subset` as its module subset."""
    spec = importlib.util.spec_from_file_location(
        name, FOLDER / "__init__.py", submodule_search_locations=[str(FOLDER)]
    )
    assert spec is not None
    assert spec.loader is not None
    package = importlib.util.module_from_spec(spec)
    for module in [other for other in sys.modules if other.startswith(f"{name}.")]:
        del sys.modules[module]  # of an earlier load: they are bound to another subset
    sys.modules[name] = package
    sys.modules[f"{name}.subset"] = subset
    spec.loader.exec_module(package)
    for module in ("body", "calendar", "elementary"):
        importlib.import_module(f"{name}.{module}")
    return package
