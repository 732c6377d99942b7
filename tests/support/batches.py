"""Batches compared bit for bit."""

import numpy as np


def same(outcomes, others):
    """Do two batches agree in every bit?  A ball that is nowhere is so in both."""
    return all(
        np.array_equal(a, b, equal_nan=name == "positions")
        for name, a, b in zip(outcomes._fields, outcomes, others, strict=True)
    )
