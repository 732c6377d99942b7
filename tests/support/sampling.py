"""Cases of which the ordinary run tries some, and `pytest -m stress` the others."""

from __future__ import annotations

from collections.abc import Container, Iterable
from typing import Any

import pytest


def mostly(cases: Iterable[Any], *, quick: Container[Any]) -> list[Any]:
    """The cases as parameters of a test, those that are not in `quick` marked as stress."""
    return [case if case in quick else _param(case) for case in cases]


def _param(case: Any) -> Any:
    values = case if isinstance(case, tuple) else (case,)
    return pytest.param(*values, marks=pytest.mark.stress)
