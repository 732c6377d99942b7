"""How much work the kernel does: its functions are wrapped for a while and count their calls."""

from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import ModuleType
from typing import Any

from physics import World
from physics.engines import exact
from physics.kernel import calendar, cluster, contact, obstacle

WATCHED: dict[str, tuple[str, tuple[ModuleType, ...]]] = {
    # counter: (function, where its name is looked up)
    "events": ("happen", (exact,)),
    "legs": ("start_leg", (calendar, exact)),
    "contact solves": ("contact_time", (contact, calendar)),
    "pairs met in boxes": ("meeting", (calendar,)),
    "wall solves": ("first_fall", (obstacle,)),
    "nearness tests": ("touching", (cluster,)),
}


@contextmanager
def counting() -> Iterator[Counter[str]]:
    """Counts of every kind of work, while it lasts."""
    counts: Counter[str] = Counter()
    replaced: list[tuple[ModuleType, str, Any]] = []
    for what, (name, places) in WATCHED.items():
        for module in places:
            if hasattr(module, name):
                replaced.append((module, name, getattr(module, name)))
                setattr(module, name, _counted(getattr(module, name), what, counts))
    try:
        yield counts
    finally:
        for module, name, function in replaced:
            setattr(module, name, function)


def _counted(function: Callable[..., Any], what: str, counts: Counter[str]) -> Callable[..., Any]:
    def counted(*arguments: Any) -> Any:
        counts[what] += 1
        return function(*arguments)

    return counted


def work(world: World, until: float) -> dict[str, int]:
    """The work that it takes to bring a world to rest, or to `until`, seconds."""
    with counting() as counts:
        world.run(until)
    return {what: counts[what] for what in WATCHED}
