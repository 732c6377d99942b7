"""The kernel compiled by numba, from the same source, beside the interpreted one in one process.

numba's cache notices neither that another file has changed nor which options it was given: so the
cache folder's name holds a hash of all that decides the code, and of where and how old the kernel
is. Where no such folder can be written to, nothing is kept, least of all beside the source.
"""

import gc
import hashlib
import logging
import os
import shutil
from contextlib import suppress
from functools import cache, partial
from math import inf, nan, sqrt
from pathlib import Path
from tempfile import TemporaryFile
from threading import Lock
from types import ModuleType
from typing import Any

from physics import binding
from physics.binding import FOLDER, load
from physics.kernel.body import (
    COLUMNS,
    NUMBERS,
    Band,
    Blow,
    Body,
    Felt,
    Rule,
    Scene,
    Seat,
    Tie,
    Way,
    no_grid,
    rows,
    ties,
)
from physics.kernel.obstacle import Shape
from physics.laws import CustomRule

from .outcomes import contact_type

log = logging.getLogger("physics")
_lock = Lock()  # threads may ask at once

NAME = "physics.compiled_kernel"
UNUSED = 7 * 86400.0  # s, see _forget
BINDING = Path(__file__), Path(__file__).with_name("pointers.py"), Path(binding.__file__)
DONE = "*/*.many-*.nbi"  # what numba writes when it has compiled


def cache_folder() -> Path | None:
    """Where the compiled kernel is kept: in the user's cache folder, by the hash of its sources;
    None for a user without such a folder.

    Of this file and the binding too, in which flags and stubs are; and of where and how old the
    kernel's are, by which numba goes: so no folder has code of another kernel.
    """
    import numba

    home = _caches()
    if home is None:
        return None
    paths = sorted(FOLDER.glob("*.py"))
    sources = b"".join(path.read_bytes() for path in (*paths, *BINDING))
    checks = numba.core.config.BOUNDSCHECK
    place = f"{numba.__version__} {checks} {FOLDER} {[path.stat().st_mtime_ns for path in paths]}"
    key = hashlib.sha256(sources + place.encode()).hexdigest()[:16]
    return home / "danggu" / f"kernel-{key}"


def _caches() -> Path | None:
    """The folder of caches: the one that is set for numba or the system, or in the home, if there
    is one."""
    from numba.core import config

    if config.CACHE_DIR:
        return Path(config.CACHE_DIR).absolute()
    given = Path(os.environ.get("XDG_CACHE_HOME", ""))
    if given.is_absolute():  # its specification says to ignore a relative one
        return given
    with suppress(RuntimeError):  # a user without name or home
        home = Path.home()
        if home.is_absolute() and os.path.isdir(home):
            return home / ".cache"
    return None


def _no_door(function: Any, *_: Any) -> None:
    raise TypeError(f"only compiled code can call {function.__name__}; physics.kernel has it too")


def _parts() -> Any:
    """A compiler of functions that are only parts of others: it makes no machine code of them,
    which is a quarter of the work."""
    from numba.core.codegen import JITCodeLibrary
    from numba.core.compiler import Compiler

    class PartLibrary(JITCodeLibrary):  # type: ignore[misc]
        @property
        def codegen(self) -> Any:
            return self

        def set_env(self, name: str, environment: Any) -> None:
            """It has no Python globals either."""

        def get_pointer_to_function(self, name: str) -> int:
            return 0  # as for all functions that Python cannot call

        def _optimize_final_module(self) -> None:
            """With the passes that numba calls cheap: all of them follow in the whole."""
            codegen = self._codegen
            if hasattr(codegen, "_mpm_cheap"):  # numba before 0.62
                codegen._mpm_cheap.run(self._final_module)
                return
            cheap = {"loop_vectorize": False, "slp_vectorize": False, "cost": "cheap"}
            passes, builder = codegen._module_pass_manager(opt=codegen._opt_level, **cheap)
            passes.run(self._final_module, builder)

        def _finalize_final_module(self) -> None:
            self._finalized = True

    class PartCompiler(Compiler):  # type: ignore[misc]
        def compile_extra(self, function: Any) -> Any:
            self.state.library = PartLibrary(self.state.targetctx.codegen(), function.__qualname__)
            return super().compile_extra(function)

    return PartCompiler


def _subset(folder: Path | None) -> ModuleType:
    """What the kernel is written in, for numba; what is compiled is kept in the folder, if any."""
    from numba import njit
    from numba.core.registry import CPUDispatcher

    from . import pointers

    # nothing here allocates, so no references need counting, of which a scene has many
    bare = partial(njit, nogil=True, error_model="numpy", _nrt=False, no_cfunc_wrapper=True)

    inner = type("Inner", (CPUDispatcher,), {"__call__": _no_door})  # which would crash
    parts = _parts()

    def kernel(function: Any) -> Any:
        """Called by compiled code alone: Python cannot, and it has no file of its own."""
        compiled = bare(function, no_cpython_wrapper=True, pipeline_class=parts)
        compiled.__class__ = inner
        return compiled

    def whole(function: Any) -> Any:
        compiled = bare(function, cache=folder is not None, inline="always")
        where = compiled.stats.cache_path
        if folder is not None and folder not in Path(where).parents:
            # beside the source, say, where an edit of another file would not be noticed
            raise OSError(f"numba would keep it in {where}")
        return compiled

    subset = ModuleType(f"{NAME}.subset")
    vars(subset).update(
        kernel=kernel, elementary=kernel, whole=whole,
        inf=inf, nan=nan, sqrt=sqrt, complex=complex, room=kernel(lambda ties, contacts: None),
        custom_cushion=kernel(pointers.custom_cushion()),
        custom_ball=kernel(pointers.custom_ball()),
    )  # fmt: skip
    return subset


def kernel() -> ModuleType:
    """The compiled kernel package; ImportError without the extra `fast`."""
    with _lock:
        return _kernel()


@cache
def _kernel() -> ModuleType:
    from numba.core import config

    if config.DISABLE_JIT:
        raise ImportError("NUMBA_DISABLE_JIT is set: there is no compiled kernel")
    wanted = cache_folder()
    folder = _opened(wanted) if wanted else None
    if folder is None:
        log.warning(
            "compiling the kernel for this process alone, which takes about 20 seconds: %s",
            f"cannot write to {wanted}" if wanted else "there is no home to keep it in",
        )
        return _built(None)
    if not any(folder.glob(DONE)):
        log.warning("compiling the kernel for %s, this once: it takes about 20 seconds", folder)
    try:
        return _built(folder)
    except Exception as error:  # broken files may raise anything, a full disk an OSError
        log.warning("compiling the kernel for this process alone: %s cannot keep it: %r",
                    folder, error)  # fmt: skip
        shutil.rmtree(folder, ignore_errors=True)  # the next process starts from scratch
        return _built(None)


def _opened(folder: Path) -> Path | None:
    """The folder, made if need be and marked as used; None if it cannot be written to."""
    new = not os.path.isdir(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        TemporaryFile(dir=folder).close()
    except OSError:
        return None
    with suppress(OSError):
        os.utime(folder)  # its age is the time since its last use
        if new:
            _forget(folder)
    return folder


def _built(folder: Path | None) -> ModuleType:
    """The package, from the folder or compiled into it; compiled for this process if None."""
    from numba.core import config

    before = config.CACHE_DIR
    config.CACHE_DIR = str(folder or "")
    try:
        package = load(NAME, _subset(folder))
    finally:
        config.CACHE_DIR = before
    _play_nothing(package)
    return package


def _play_nothing(package: ModuleType) -> None:
    """No shot of one ball: so the kernel is compiled, or read from its folder, here and now.

    Garbage collection is off meanwhile: the compiler leaves little (60 MB) and holds much, so the
    collector would take a seventh of the time.
    """
    import numpy as np

    still = Scene(
        [Body()], [inf], [], Felt(0.0, 0.0, 0.0), Rule(0), Rule(0), ties(1), False, no_grid(1)
    )
    collects = gc.isenabled()
    gc.disable()
    try:
        no = np.empty
        notes = package.body.Notes(0, no((0, 0), contact_type()), no(0, int), *near(1, 0))
        package.calendar.many(
            no((1, COLUMNS)), no((0, 1, 2)), no((0, NUMBERS)), 0,
            no((0, 1, 2)), no(0), no(0, int), 0, pack(still, package.body), notes,
        )  # fmt: skip
    finally:
        if collects:
            gc.enable()


def _forget(folder: Path) -> None:
    """Remove the kernels beside this new one that have not been used for a week.

    Each edit and each release leaves one, of 2 to 6 MB. Another install may still want its own:
    after a week it waits 15 s for it again. A folder is renamed first and then removed, so that no
    process finds half of one; one that another removes, or holds open, is left alone.
    """
    now = folder.stat().st_mtime
    for other in folder.parent.glob("kernel-*/"):
        with suppress(OSError):
            if other.stat().st_mtime < now - UNUSED:
                shutil.rmtree(other.rename(f"{other}.{os.getpid()}"), ignore_errors=True)


def records(items: list[Any], kind: Any) -> Any:
    """An array of records, also of none; `kind` is one such record."""
    return rows(items or [kind])[: len(items)]


def near(balls: int, walls: int) -> tuple[Any, Any]:
    """Room for how each ball has come away from the walls, for the kernel's notes."""
    import numpy as np

    return records([Way() for _ in range(balls)], Way()), np.ones(balls * walls, bool)


def door(function: Any) -> Any:
    """The compiled form of a function, for arguments of the types that it was compiled for: numba's
    own way in looks at all of them first, which takes as long as eight shots."""
    return next(iter(function.overloads.values())).entry_point


def loaded() -> bool:
    """Is the compiled kernel here already?"""
    return _kernel.cache_info().currsize > 0


def packed(scene: Scene) -> Any:
    """The same scene in arrays of its own, for the compiled kernel."""
    body = kernel().body
    for ball, rule in ((True, scene.ball_rule), *((False, rule) for rule in _cushions(scene))):
        if isinstance(rule, CustomRule):
            from .pointers import address

            rule.address = address(rule.law, ball)
    return pack(scene, body)


def _cushions(scene: Scene) -> tuple[Rule, ...]:
    return scene.cushion_rule, *scene.rules


def pack(scene: Scene, body: Any) -> Any:
    """The scene in arrays, in the classes of that module."""
    import numpy as np

    cells = scene.grid
    felt, *rules = (
        rows([record])[0] for record in (scene.cloth, scene.ball_rule, scene.cushion_rule)
    )
    member, contacts, chosen, blows = ties(len(scene.balls))
    room = body.Ties(
        np.array(member), records(contacts, Tie()), np.array(chosen, int), records(blows, Blow())
    )
    head, seats, tree, near = cells[5:]
    grid = body.Grid(
        *cells[:5], np.array(head, int), records(seats, Seat()), np.array(tree, int), np.array(near)
    )
    walls = records(scene.walls, Shape())
    meetings = np.array(scene.meetings, float)
    own = records(list(scene.rules), Rule(0))
    first = rows(scene.balls), meetings, walls, felt, *rules, room
    bands = records(list(scene.bands), Band())
    frame = np.array(scene.frame, int)
    openings = records(list(scene.openings), Shape())
    return body.Packed(*first, scene.celled, grid, scene.lines, own, frame, bands, openings)
