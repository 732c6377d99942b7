"""Every measurement, one after the other, with the same options."""

from importlib import import_module

MEASUREMENTS = ("speed", "work-precision", "scale", "peers", "skips", "batch", "frame")


def main(arguments: list[str] | None = None) -> int:
    failed = 0
    for name in MEASUREMENTS:
        module = import_module(f"benchmarks.{name.replace('-', '_')}")
        failed += bool(module.main(arguments))
        print()
    return failed
