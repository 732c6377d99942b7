"""The rooms around the game: which may name which, no circles, no window where none belongs."""

import ast
import subprocess
import sys
from collections.abc import Iterator

import pytest

from tests.whole.test_architecture import MODULES, ROOT, SOURCES, dotted, imported, needed

AROUND = ("benchmarks", "tools", "tests")  # not installed with the packages
FILES = sorted(path for part in AROUND for path in (ROOT / part).rglob("*.py"))
EVERY = [*SOURCES, *FILES]
NAMES = MODULES | {dotted(path) for path in FILES}
# each may name those before it
ORDER = ("assets", "physics", "danggu", "game", "tests.support", "benchmarks", "tools", "tests")
# file outside the game: why it opens the game
OPENS_THE_GAME = {
    "benchmarks/frame.py": "times its frames",
    "tools/animate.py": "draws its pictures",
    "tools/draw_icons.py": "draws with its balls and cloth",
    "tools/lab_pictures.py": "draws its pictures",
    "tools/readme_pictures.py": "draws its pictures",
    "tests/rules/test_cushions_that_count.py": "its counters count as the rules do",
}


def place(module: str) -> int:
    """Where a module stands in ORDER."""
    leading = [room for room in ORDER if f"{module}.".startswith(f"{room}.")]
    return ORDER.index(max(leading, key=len))


def circles(graph: dict[str, set[str]]) -> Iterator[str]:
    """Every way that leads back to where it began, once for each edge that closes one."""
    done: set[str] = set()

    def visit(name: str, path: tuple[str, ...]) -> Iterator[str]:
        if name in path:
            yield " -> ".join((*path[path.index(name) :], name))
        elif name not in done:
            for other in graph.get(name, ()):
                yield from visit(other, (*path, name))
            done.add(name)

    for name in graph:
        yield from visit(name, ())


@pytest.mark.parametrize("path", FILES, ids=lambda p: str(p.relative_to(ROOT)))
def test_what_stands_around_the_packages_names_nothing_above_itself(path):
    assert {name for name in needed(path, NAMES) if place(name) > place(dotted(path))} == set()


@pytest.mark.parametrize("package", ["physics", "danggu", "game", "benchmarks", "tests"])
def test_no_module_leads_back_to_itself_not_even_for_types_or_in_a_function(package):
    graph = {dotted(p): needed(p, NAMES) for p in EVERY if p.is_relative_to(ROOT / package)}
    assert list(circles(graph)) == []


def test_a_circle_would_be_found():
    assert list(circles({"a": {"b"}, "b": {"c"}, "c": {"b"}})) == ["b -> c -> b"]


@pytest.mark.parametrize("path", EVERY, ids=lambda p: str(p.relative_to(ROOT)))
def test_the_game_and_pygame_are_imported_only_where_they_are_shown(path):
    name = path.relative_to(ROOT).as_posix()
    rooms = ("physics", "danggu", "assets", "benchmarks", "tools", "tests/physics", "tests/rules",
             "tests/players")  # fmt: skip
    if name.startswith(tuple(f"{room}/" for room in rooms)) and name not in OPENS_THE_GAME:
        assert not {"pygame", "game"} & imported(path)


@pytest.mark.parametrize("package", ["physics", "danggu"])
def test_every_module_of_a_library_loads_without_pygame_and_without_the_game(package):
    optional = ("physics.batch.compiled", "physics.studies.plot")  # these need an extra
    modules = {dotted(path) for path in (ROOT / package).rglob("*.py")} - {*optional}
    names = ", ".join(sorted(name for name in modules if not name.endswith("__main__")))
    code = f"import sys, {names}; print(sorted({{'pygame', 'game'}} & {{*sys.modules}}))"
    out = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert out.stdout.strip() == "[]"


@pytest.mark.parametrize("path", FILES, ids=lambda p: str(p.relative_to(ROOT)))
def test_what_stands_around_the_packages_is_small_enough_to_read(path):
    source = path.read_text()
    assert source.count("\n") <= 400
    assert ast.get_docstring(ast.parse(source)), "the first line says the file's one idea"
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef):
            assert (node.end_lineno or 0) - node.lineno < 40, f"{node.name} is too long"
