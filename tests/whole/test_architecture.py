"""The shape of the code: imports run one way, functions and files stay small."""

import ast
import re
import subprocess
import sys
import tomllib
from itertools import pairwise
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGES = ("physics", "danggu", "game")
SOURCES = sorted(p for part in (*PACKAGES, "assets") for p in (ROOT / part).rglob("*.py"))
# from what knows least to what may know all
LAYERS = (
    "assets", "physics.kernel", "physics", "danggu.rules", "danggu.players", "danggu", "game",
    "game.ui.sight", "game.ui.table", "game.ui.panels", "game.ui.pages", "game.ui.view",
    "game.ui.layers", "game.ui.watching", "game.app", "game.start", "game.__main__",
)  # fmt: skip
# function: why it may be longer than 40 lines
LONG: dict[str, str] = {}


def imported(path: Path) -> set[str]:
    names = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            names.add(node.module.split(".")[0])
    return names


def dotted(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


MODULES = {dotted(path) for path in SOURCES}


def needed(path: Path, ours: set[str] = MODULES) -> set[str]:
    """Our own modules that a file names anywhere: at its top, in a function or for types alone."""
    found = set()
    package = dotted(path) if path.name == "__init__.py" else dotted(path).rpartition(".")[0]
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            above = package.split(".")[: 1 - node.level or None] if node.level else []
            module = ".".join([*above, *filter(None, [node.module])])
            names = {f"{module}.{alias.name}" for alias in node.names}
            found |= names & ours | ({module} if names - ours else set())
    return found & ours - {dotted(path)}


def layer(module: str) -> int:
    """Where a module stands in LAYERS: by the longest of the names that lead to it."""
    leading = [name for name in LAYERS if f"{module}.".startswith(f"{name}.")]
    return LAYERS.index(max(leading, key=len))


@pytest.mark.parametrize("path", SOURCES, ids=lambda p: str(p.relative_to(ROOT)))
def test_no_file_names_a_layer_above_its_own_not_even_for_types_or_in_a_function(path):
    above = {name for name in needed(path) if layer(name) > layer(dotted(path))}
    assert not above


def test_every_package_says_that_it_is_typed():
    assert [part for part in PACKAGES if not (ROOT / part / "py.typed").exists()] == []


@pytest.mark.parametrize("path", SOURCES, ids=lambda p: str(p.relative_to(ROOT)))
def test_imports_run_from_the_kernel_to_physics_to_the_game(path):
    part = path.relative_to(ROOT).parts
    names = imported(path)
    if part[0] == "physics":
        assert not names & {"pygame", "game", "danggu", "assets", "time", "platformdirs"}
    if part[:2] == ("physics", "kernel"):
        assert not names - {
            "dataclasses",
            "math",
            "typing",
            "builtins",
            "collections",
            "operator",
            "numpy",
        }
        assert all(name.startswith("physics.kernel.") for name in needed(path))
    if part[0] == "danggu":
        assert not names & {"pygame", "game", "assets", "platformdirs"}
    if part[0] in ("danggu", "game"):
        assert "numba" not in names
        for node in ast.walk(ast.parse(path.read_text())):
            if (
                isinstance(node, ast.ImportFrom)
                and node.module
                and node.module.startswith("physics.")
            ):
                raise AssertionError(f"{path} reaches behind the public names: {node.module}")


@pytest.mark.parametrize("path", SOURCES, ids=lambda p: str(p.relative_to(ROOT)))
def test_functions_and_files_stay_small_enough_to_read(path):
    source = path.read_text()
    assert source.count("\n") <= 400
    assert ast.get_docstring(ast.parse(source)), "the first line says the file's one idea"
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            lines = (node.end_lineno or 0) - node.lineno + 1
            assert lines <= 40 or node.name in LONG, f"{node.name} has {lines} lines"


@pytest.mark.parametrize(
    "path", [p for p in SOURCES if p.is_relative_to(ROOT / "game")], ids=dotted
)
def test_fields_of_a_value_are_described_in_the_docstring_of_their_class(path):
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ClassDef):
            for field, after in pairwise(node.body):
                beneath = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
                assert not (isinstance(field, ast.AnnAssign) and beneath), node.name


WRITERS = {
    f"game.session.{name}"
    for name in ("session", "commands", "match_commands", "play_commands", "table_commands")
}
BELOW = ("game.session", "game.aim", "game.table", "game.text")
"""What a session is made of, and what these use."""


def test_the_game_itself_knows_no_room_of_the_window():
    of_the_window = (
        "input",
        "window",
        "sound",
        "render",
        "ui",
        "replay",
        "computer",
        "app",
        "start",
    )
    for path in SOURCES:
        if dotted(path).startswith(BELOW):
            assert not {name.split(".")[1] for name in needed(path) if name.startswith("game.")} & {
                *of_the_window
            }, path


def test_only_the_session_and_the_commands_write_to_it():
    for path in SOURCES:
        if dotted(path) in WRITERS:
            continue
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
                holders = ast.unparse(node.value).split(".")
                assert "session" not in holders, f"{path}, line {node.lineno}"


def test_the_parts_of_a_session_do_not_know_it():
    parts = {m for m in MODULES if m.startswith(BELOW)} - WRITERS
    for path in SOURCES:
        if dotted(path) in parts:
            assert not needed(path) & WRITERS, path


def test_whatever_is_imported_is_required_by_an_extra_at_least():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"].values()
    lines = [*project["dependencies"], *(line for extra in extras for line in extra)]
    required = {name for line in lines for name in re.findall(r"\w+", line.split(">")[0])}
    parts = (*PACKAGES, "assets", "benchmarks", "tests", "docs")  # tools say it themselves
    paths = [path for part in parts for path in (ROOT / part).rglob("*.py")]
    used = set().union(*map(imported, paths)) - sys.stdlib_module_names - {*parts, "tools"}
    used -= {path.stem for path in paths}
    used -= {"pooltool"}  # its own requirements disagree with ours (docs/benchmarks.md, "Peers")
    assert {{"PIL": "pillow"}.get(name, name) for name in used} <= required


def test_physics_prints_nothing_and_draws_no_chance():
    for path in (ROOT / "physics").rglob("*.py"):
        if path.name == "__main__.py":
            continue
        tree = ast.parse(path.read_text())
        calls = {
            n.func.id
            for n in ast.walk(tree)
            if isinstance(n, ast.Call) and isinstance(n.func, ast.Name)
        }
        assert "print" not in calls, path
        assert "random" not in imported(path), path


def test_import_physics_needs_neither_numpy_nor_pygame():
    code = "import sys, physics; print(sorted({'numpy', 'pygame', 'numba'} & set(sys.modules)))"
    out = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert out.stdout.strip() == "[]"


def test_a_game_is_played_without_pygame_by_all_rooms_but_those_of_the_window():
    rooms = [ROOT / "game" / room for room in ("session", "aim", "table", "computer")]
    modules = [dotted(path) for room in rooms for path in sorted(room.rglob("*.py"))]
    code = f"import sys, {', '.join(modules)}; print(sorted({{'pygame'}} & {{*sys.modules}}))"
    out = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert out.stdout.strip() == "[]"


def test_nothing_that_makes_a_shot_rounds_as_a_c_library_or_a_processor_likes():
    alike = {"ceil", "copysign", "floor", "fsum", "inf", "isfinite", "ldexp", "nan", "pi", "prod",
             "sqrt"}  # fmt: skip
    compares = {"__main__.py", "places.py", "watch.py"}  # with a slack, or shows
    analyses = {"drawn.py", "fit.py", "least_squares.py", "plot.py", "recovery.py", "search.py",
                "sensitivity.py"}  # fmt: skip
    for path in (ROOT / "physics").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.ImportFrom) and node.module == "math":
                names = {alias.name for alias in node.names}
                assert names <= alike | ({"hypot"} if path.name in compares else set()), path
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                assert node.func.id != "sum", f"{path}: not the same before Python 3.12 and after"
            if isinstance(node, ast.BinOp) and path.name not in analyses:
                assert not isinstance(node.op, ast.MatMult), f"{path}: each processor has its order"
        assert "cmath" not in imported(path)
