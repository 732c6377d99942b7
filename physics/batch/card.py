"""Batches on a graphics card: the kernel's source once more, bound to numba.cuda.

The bits are the CPU's: the kernel uses +, -, *, / and square roots, which the card rounds alike as
long as it does not fuse a product with a sum. numba has no switch for that, so what it hands to
NVVM is intercepted (`arranged`), which also takes the compilation from minutes to seconds.
"""

import importlib
import logging
import re
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from math import inf, nan, sqrt
from threading import Lock
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
from numba import cuda
from numba.core.errors import NumbaPerformanceWarning

from physics.binding import load
from physics.engines.exact import EventDriven
from physics.kernel import body
from physics.laws import CustomRule
from physics.world import World

from . import compiled
from .jobs import ENDLESS
from .outcomes import Part
from .shots import Asked

log = logging.getLogger("physics")
_lock = Lock()  # numba is patched for a launch

NAME = "physics.cuda_kernel"
CHUNK = 131_072  # shots at once: a card that also drives a screen may be held for seconds only
THREADS = 65_536  # at most, and as many as find room in
ROOM = 2**30  # bytes
BLOCK = 64  # threads
PART = 300  # lines of LLVM's language: a part of the kernel that is longer is called, not copied
_PACKAGE = "".join(f"{len(word)}{word}" for word in NAME.split("."))  # as names of code have it
_PARTS = rf"_ZN{_PACKAGE}(?!5lanes)"  # not the kernel itself: numba knows it by its name
_NAMES = re.compile(rf'@"({_PARTS}[^"]*)"')
_DEFINED = re.compile(rf'^(define [^@{{]*@"{_PARTS}(\w+?)B[^{{]*?\))(\s*\{{)', re.MULTILINE)
_copied: set[str] = set()
"""The functions that are handed a whole scene: a call would hand on each of its arrays."""


class OnCard(NamedTuple):
    """What plays a batch on the card: see jobs.Job."""

    scene: body.Scene
    before: Any
    struck: int
    contacts: int
    budget: int
    until: int
    chunk: int = CHUNK
    compiled: bool = True

    def run(self, table: Any, places: Any, into: Part | None = None) -> Part:
        """The outcomes of the shots in the rows, from these places, if there are any."""
        part = into or Part.room(len(table), len(self.before), self.contacts)
        if len(table):
            given = (cuda.to_device(np.ascontiguousarray(a)) for a in (table, places, self.before))
            out = [cuda.to_device(column) for column in part]
            rests, times, counts, kept, found = out
            how = self.struck, self.budget, self.contacts, self.until
            launch(
                min(len(table), THREADS), self.scene,
                *given, *how, rests, times, counts, kept, found,
            )  # fmt: skip
            for column, there in zip(part, out, strict=True):
                there.copy_to_host(column)
        if self.contacts:
            np.maximum(part.dropped - self.contacts, 0, out=part.dropped)
        return part


def job_on(world: World, asked: Asked, contacts: int, until: int) -> OnCard:
    """What plays the shots; ValueError for a world that no card plays, RuntimeError without one."""
    if not isinstance(world.engine, EventDriven) or world.cluster_law is not None:
        raise ValueError(
            "device='cuda' plays worlds of the engine EventDriven without a cluster law, not"
            f" with {world.cluster_law if isinstance(world.engine, EventDriven) else world.engine}"
        )
    for rule in (world.scene.ball_rule, world.scene.cushion_rule, *world.scene.rules):
        if isinstance(rule, CustomRule):
            raise ValueError(f"device='cuda' plays no custom laws: {rule.law!r} is one")
    if not cuda.is_available():
        raise RuntimeError(f"device='cuda': numba finds no CUDA device: {cuda.cuda_error()}")
    budget = int(min(world.engine.budget, ENDLESS))
    return OnCard(world.scene, asked.before, asked.struck, contacts, budget, until)


@cache
def kernel() -> Any:
    """What a card plays: `play` of kernel/lanes.py, for numba.cuda."""
    part = cuda.jit(device=True)

    def whole(function: Any) -> Any:
        module, name = function.__module__.rpartition(".")[2], function.__name__
        _copied.add(f"{len(module)}{module}{len(name)}{name}")
        return part(function)

    subset = ModuleType(f"{NAME}.subset")
    vars(subset).update(
        kernel=part, elementary=part, whole=whole,
        inf=inf, nan=nan, sqrt=sqrt, complex=complex, room=part(lambda ties, contacts: None),
        # never called: `job_on` refuses custom laws
        custom_cushion=part(lambda v, roll, side, rule: (v, roll, side)),
        custom_ball=part(lambda v, roll, side, mass, rule: (0.0 * mass, 0.0 * v)),
        thread=part(lambda: cuda.grid(1)), threads=part(lambda: cuda.gridsize(1)),
    )  # fmt: skip
    load(NAME, subset)
    return cuda.jit(importlib.import_module(f"{NAME}.lanes").play.py_func)


def launch(threads: int, scene: body.Scene, *arguments: Any) -> None:
    """Let so many threads play, or as many as find room: arguments as those of kernel/lanes.py,
    but for the scene."""
    rows, shared = lanes(scene)
    threads = max(1, min(threads, ROOM // max(1, int(np.sum([row.nbytes for row in rows])))))
    own = [_spread(row, threads) for row in rows]
    play = kernel()
    with _lock, unfused(), warnings.catch_warnings():
        warnings.simplefilter("ignore", NumbaPerformanceWarning)  # a small batch leaves most idle
        if not len(play.overloads):
            log.warning("compiling the kernel for the graphics card, once in this process")
        play[-(-threads // BLOCK), BLOCK](*arguments, *own, *shared)


def lanes(scene: body.Scene) -> tuple[list[Any], list[Any]]:
    """The scene as `play` of kernel/lanes.py takes it: a thread's row of every array that events
    change, and what all threads share."""
    packed = compiled.pack(scene, body)
    own = packed.balls, packed.meetings, *packed.ties, *packed.grid[5:]
    laws = scene.cloth, scene.ball_rule, scene.cushion_rule
    plain = packed.rules, packed.frame, packed.bands, packed.openings
    cells = scene.grid[:5]
    return (
        [*own, *compiled.near(len(scene.balls), len(scene.walls))],
        [packed.walls, *(body.rows([law]) for law in laws), *plain, scene.celled, scene.lines,
         *map(float, cells[:3]), *cells[3:]],
    )  # fmt: skip


def _spread(row: Any, threads: int) -> Any:
    """The same row for every thread, on the card; the card itself copies it."""
    flat = row.reshape(-1).view(np.uint8)
    out = cuda.device_array((threads, flat.size), np.uint8)
    if flat.size:
        _copier()[-(-threads * flat.size // 256), 256](cuda.to_device(flat), out)
    return out.view(row.dtype)


@cache
def _copier() -> Any:
    def copy(row: Any, out: Any) -> None:
        k = cuda.grid(1)
        if k < out.size:
            out[k // row.size, k % row.size] = row[k % row.size]

    return cuda.jit(copy)


@contextmanager
def unfused() -> Iterator[None]:
    """What numba compiles meanwhile has no fused products, and is `arranged`."""
    from numba.cuda.cudadrv import nvvm

    if not hasattr(nvvm, "compile_ir"):  # numba's simulator
        yield
        return
    plain = nvvm.compile_ir
    nvvm.compile_ir = lambda modules, **options: plain(arranged(modules), fma=False, **options)
    try:
        yield
    finally:
        nvvm.compile_ir = plain


def arranged(modules: Sequence[str] | str) -> list[str]:
    """The parts of a program for NVVM, each once (numba lists one for every path of calls to it,
    3 000 instead of 260), with short names (theirs list all fields of a scene: 50 MB of PTX), and
    the long ones kept apart (copied into each other they take 50 times as long to compile)."""
    names: dict[str, str] = {}

    def short(match: re.Match[str]) -> str:
        return f'@"{names.setdefault(match[1], f"part_{len(names)}")}"'

    each = [modules] if isinstance(modules, str) else dict.fromkeys(modules)
    return [_NAMES.sub(short, _apart(text)) for text in each]


def _apart(text: str) -> str:
    """A long part of the kernel, marked as one not to be copied into its callers; but for those
    that are handed a whole scene."""
    found = _DEFINED.search(text)
    if not found or found[2] in _copied or text.count("\n") <= PART:
        return text
    return f"{text[: found.end(1)]} noinline{text[found.end(1) :]}"
