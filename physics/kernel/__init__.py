"""The inner loop, written once: CPython runs it as it stands, numba compiles it as it stands."""
