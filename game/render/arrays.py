"""The array types the renderer passes around: floats of either width, and pixel indices."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating[Any]]
Indices = NDArray[np.intp]
Bytes = NDArray[np.uint8]
Points = Sequence[tuple[float, float]]
"""Screen or table points, in order."""
