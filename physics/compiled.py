"""The kernel compiled by numba, from the same source, beside the interpreted one in one process.

numba's cache does not see that another file has changed: so the cache folder carries a hash of
them all, and of where and how old they are.
"""

import hashlib
import logging
import os
from functools import cache, partial
from math import exp, inf, sqrt
from pathlib import Path
from threading import Lock
from types import ModuleType
from typing import Any

from .binding import FOLDER, load
from .kernel.body import Line, Scene, rows, ties

log = logging.getLogger("physics")
_lock = Lock()  # threads may ask at once

NAME = "physics.compiled_kernel"


def cache_folder() -> Path:
    """Where the compiled kernel is kept: in the user's cache folder, by the hash of its sources.

    And of where and how old they are, by which numba goes: so the folder is there if and only if
    this kernel has been compiled.
    """
    import numba

    paths = sorted(FOLDER.glob("*.py"))
    sources = b"".join(path.read_bytes() for path in paths)
    place = f"{numba.__version__} {FOLDER} {[path.stat().st_mtime_ns for path in paths]}"
    key = hashlib.sha256(sources + place.encode()).hexdigest()[:16]
    home = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(home) / "danggu" / f"kernel-{key}"


def _lend() -> Any:
    """For compiled code: the same scene in arrays that nobody counts references to.

    Every function that is handed a scene counts two for each of its two dozen arrays, which took a
    third of the time of a batch. Whoever called holds the arrays anyway.
    """
    from numba.core import cgutils
    from numba.core.types.containers import BaseTuple
    from numba.core.types.npytypes import Array
    from numba.extending import intrinsic

    def bare(context: Any, builder: Any, kind: Any, value: Any) -> Any:
        if isinstance(kind, BaseTuple):
            for k, part in enumerate(kind):
                item = bare(context, builder, part, builder.extract_value(value, k))
                value = builder.insert_value(value, item, k)
            return value
        if not isinstance(kind, Array):
            return value
        array = context.make_array(kind)(context, builder, value)
        array.meminfo = cgutils.get_null_value(array.meminfo.type)
        return array._getvalue()

    def lend(_: Any, kind: Any) -> Any:
        return kind(kind), lambda context, builder, _, values: bare(context, builder, kind, *values)

    return intrinsic(lend)


def _subset() -> ModuleType:
    from numba import njit

    def kernel(function: Any, inline: str = "never") -> Any:
        return njit(cache=True, nogil=True, error_model="numpy", inline=inline)(function)

    subset = ModuleType(f"{NAME}.subset")
    vars(subset).update(
        kernel=kernel, inlined=partial(kernel, inline="always"), lend=_lend(),
        inf=inf, sqrt=sqrt, exp=exp, complex=complex,
        foreign_cushion=njit(nogil=True)(lambda v, roll, side, rule: (v, roll, side)),
        foreign_ball=njit(nogil=True)(lambda v, roll, side, mass, rule: (0.0 * mass, 0.0 * v)),
    )  # fmt: skip
    return subset


def kernel() -> ModuleType:
    """The compiled kernel package; ImportError without the extra `fast`."""
    with _lock:
        return _kernel()


@cache
def _kernel() -> ModuleType:
    from numba.core import config

    folder, before = cache_folder(), config.CACHE_DIR
    if not folder.exists():
        log.warning("compiling the kernel for %s, this once: it takes 10 to 30 seconds", folder)
    config.CACHE_DIR = str(folder)
    try:
        return load(NAME, _subset())
    finally:
        config.CACHE_DIR = before


def packed(scene: Scene) -> Any:
    """The same scene in arrays, with room of its own, for the compiled kernel."""
    import numpy as np

    def column(items: list[Any], kind: type = float) -> Any:
        return np.array(items, type(items[0]) if items else kind)

    body, cells = kernel().body, scene.grid
    felt, *rules = (
        rows([record])[0] for record in (scene.cloth, scene.ball_rule, scene.cushion_rule)
    )
    walls = rows(scene.walls or [Line(0j, 0.0, 0j)])[: len(scene.walls)]
    room = body.Ties(*(column(items) for items in ties(len(scene.balls))))
    lists = (column(items, float if items is cells.cross else int) for items in cells[5:])
    return body.Scene(
        rows(scene.balls),
        column(scene.meetings),
        walls,
        felt,
        *rules,
        room,
        scene.celled,
        body.Grid(*cells[:5], *lists),
    )
