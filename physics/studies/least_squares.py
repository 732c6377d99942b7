"""Least squares with shared and own unknowns: each stroke has its own, all share the coefficients.

The normal equations are solved by eliminating what is each stroke's own (Schur's complement), so
that the work grows with the number of strokes alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]


class Block(NamedTuple):
    """A stroke's part of the normal equations: curvature by shared and own unknowns, and downhill.

    shared: (S, S), mixed: (S, n), own: (n, n), down_shared: (S,), down_own: (n,).
    """

    shared: Any
    mixed: Any
    own: Any
    down_shared: Any
    down_own: Any


def huber(size: Any, bend: float) -> float:
    """The summed loss of misses of that size, in noises: squares, but linear beyond `bend`."""
    import numpy as np

    size = size[np.isfinite(size)]
    loss = np.where(size <= bend, size * size, bend * (2.0 * size - bend))
    return float(loss.sum())


def block(miss: Any, slopes: Any, shared: int, noise: float, bend: float) -> Block:
    """From complex misses (n,) and slopes (n, unknowns), of which the first are shared."""
    import numpy as np

    size = np.abs(miss) / noise
    weight = np.sqrt(np.minimum(1.0, bend / np.maximum(size, 1e-12))) / noise
    r = np.concatenate((miss.real * weight, miss.imag * weight))
    j = np.concatenate((slopes.real * weight[:, None], slopes.imag * weight[:, None]))
    curve, down = j.T @ j, j.T @ r
    s = shared
    return Block(curve[:s, :s], curve[:s, s:], curve[s:, s:], down[:s], down[s:])


def step(
    blocks: Sequence[Block], damping: float, free: Array, own_free: Sequence[Array]
) -> tuple[Array, list[Array]]:
    """The damped step of Gauss and Newton: of the shared unknowns, and of each stroke's own.

    free, own_free: how far an unknown may go for nothing, in its unit; so one that no sample shows
    stays where it is.
    """
    import numpy as np

    whole = np.diag(free**-2.0)
    down = np.zeros(len(free))
    parts = []
    for part, wide in zip(blocks, own_free, strict=True):
        own = part.own + np.diag(damping * np.diag(part.own) + wide**-2.0)
        across = np.linalg.solve(own, np.column_stack((part.mixed.T, part.down_own)))
        shared = part.shared + np.diag(damping * np.diag(part.shared))
        whole += shared - part.mixed @ across[:, :-1]
        down += part.down_shared - part.mixed @ across[:, -1]
        parts.append(across)
    moved: Any = np.linalg.solve(whole, down) if len(free) else down
    return moved, [across[:, -1] - across[:, :-1] @ moved for across in parts]


def information(blocks: Sequence[Block]) -> tuple[Array, Array]:
    """(S, S) of the shared unknowns with the strokes' own unknown too; and (S,) with all known."""
    import numpy as np

    shared = len(blocks[0].down_shared)
    whole, alone = np.zeros((shared, shared)), np.zeros(shared)
    for part in blocks:
        whole += part.shared - part.mixed @ inverse(part.own) @ part.mixed.T
        alone += np.diag(part.shared)
    return whole, alone


def inverse(curve: Any) -> Any:
    """Of a symmetric matrix; of what it does not show, 0."""
    import numpy as np

    diagonal = np.diag(curve)
    scale = np.sqrt(np.where(diagonal > 0.0, diagonal, 1.0))
    return np.linalg.pinv(curve / np.outer(scale, scale), 1e-10, True) / np.outer(scale, scale)
