"""Billiards as a library: physics' public names, and rules, players and labs built on them.

`import danggu as dg` loads nothing; each name is loaded when it is first asked for.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from physics import *  # noqa: F403
    from physics import __version__ as __version__

    from . import labs as labs
    from . import players as players
    from . import rules as rules

ROOMS = ("labs", "players", "rules")
EXTRA = ("envs",)  # needs an extra, so neither `import *` nor completion loads it


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name in ROOMS or name in EXTRA:
        return import_module(f".{name}", __name__)
    physics = import_module("physics")
    if name == "__all__":
        return [*physics.__all__, *ROOMS]
    if name in physics.__all__ or name == "__version__":
        return getattr(physics, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """All public names, loaded or not, so that completion finds them."""
    return [*__getattr__("__all__"), "__version__"]
