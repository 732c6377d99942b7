"""Every measurement, one after the other, with the same options."""

from importlib import import_module

from . import report

MEASUREMENTS = ("speed", "work-precision", "scale", "peers", "skips", "batch", "envs", "frame")


def main(arguments: list[str] | None = None) -> int:
    report.options("all", __doc__, arguments)  # so that --help and errors name this command
    failed = 0
    for name in MEASUREMENTS:
        module = import_module(f"benchmarks.{name.replace('-', '_')}")
        failed += bool(module.main(arguments))
        print()
    return failed
