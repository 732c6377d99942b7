"""Where no folder can keep the compiled kernel, or only until it is full: it works all the same."""

import errno
import logging
import os
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

pytest.importorskip("numba", reason="compiled batches need the extra `fast`")
from numba.core import caching, config

from physics.batch import compiled
from physics.kernel import body

ROOT = Path(__file__).parents[2]
TINY = "def many(*arguments):\n    pass\n"


@pytest.fixture
def source(tmp_path, monkeypatch):
    """A kernel that is compiled in no time stands in for the real one; numba is the real one."""
    path = tmp_path / "source" / "calendar.py"
    path.parent.mkdir()
    path.write_text(TINY)

    def load(name, subset):
        functions: dict = {"__name__": name}
        exec(compile(path.read_text(), str(path), "exec"), functions)
        module = SimpleNamespace(many=subset.whole(functions["many"]))
        return SimpleNamespace(calendar=module, body=body)

    monkeypatch.setattr(compiled, "load", load)
    for name in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    return path.parent


@pytest.fixture
def home(tmp_path, monkeypatch):
    folder = tmp_path / "home"
    folder.mkdir()
    monkeypatch.setenv("HOME", str(folder))
    return folder


def kernel(caplog):
    """(the package, what was said), as a new process gets them."""
    caplog.clear()
    with caplog.at_level(logging.WARNING, logger="physics"):
        package = compiled._kernel.__wrapped__()
    return package, [record.getMessage() for record in caplog.records]


def code(folder):
    return list(folder.rglob("*.nb[ic]"))


def test_the_folder_is_the_one_set_for_numba_or_the_system_or_in_the_home(
    source, home, tmp_path, monkeypatch
):
    assert compiled.cache_folder().parent == home / ".cache" / "danggu"
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    assert compiled.cache_folder().parent == tmp_path / "xdg" / "danggu"
    monkeypatch.setattr(config, "CACHE_DIR", str(tmp_path / "numba"))
    assert compiled.cache_folder().parent == tmp_path / "numba" / "danggu"
    monkeypatch.setattr(config, "CACHE_DIR", "beside")
    assert compiled.cache_folder().parent == Path.cwd() / "beside" / "danggu"


@pytest.mark.parametrize("given", ["", "caches", "./caches", "~/caches"])
def test_a_cache_home_that_is_no_absolute_path_is_ignored(
    given, source, home, monkeypatch
):
    monkeypatch.setenv("XDG_CACHE_HOME", given)
    assert compiled.cache_folder().parent == home / ".cache" / "danggu"


@pytest.mark.parametrize("given", ["missing", "file", "relative"])
def test_a_home_that_is_none_is_not_made(given, source, tmp_path, monkeypatch, caplog):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("HOME", given if given == "relative" else str(tmp_path / given))
    package, said = kernel(caplog)
    assert package.calendar.many.stats.cache_path is None
    assert len(said) == 1
    assert "no home" in said[0]
    assert not (tmp_path / "missing").exists()
    assert code(tmp_path) == []


def test_a_user_without_name_and_home_gets_a_kernel(source, monkeypatch, caplog):
    monkeypatch.delenv("HOME", raising=False)
    monkeypatch.setattr(Path, "home", lambda: (_ for _ in ()).throw(RuntimeError("no home")))
    package, said = kernel(caplog)
    assert package.calendar.many.stats.cache_path is None
    assert len(said) == 1


@pytest.mark.parametrize("where", ["/proc/nope", "a file", "in a file", "read only"])
def test_where_nothing_can_be_written_nothing_is_kept_and_that_is_said_once(
    where, source, tmp_path, monkeypatch, caplog
):
    file = tmp_path / "file"
    file.write_text("")
    place = {"a file": file, "in a file": file / "caches"}.get(where, Path(where))
    if where == "read only":
        place = tmp_path / "caches"

        def refuses(**_):
            raise OSError(errno.EROFS, "Read-only file system")

        monkeypatch.setattr(compiled, "TemporaryFile", refuses)
    monkeypatch.setenv("XDG_CACHE_HOME", str(place))
    package, said = kernel(caplog)
    assert package.calendar.many.stats.cache_path is None
    assert len(said) == 1
    assert str(place) in said[0]
    assert code(tmp_path) == []


def test_numba_set_to_keep_code_beside_the_source_does_not(
    source, home, tmp_path, monkeypatch, caplog
):
    monkeypatch.setattr(config, "CACHE_LOCATOR_CLASSES", "InTreeCacheLocator", raising=False)
    package, said = kernel(caplog)
    if package.calendar.many.stats.cache_path is None:  # this numba takes a folder
        assert "cannot keep it" in said[-1]
    assert code(source) == []


@pytest.mark.parametrize("step", ["_save_index", "_save_data"])
def test_a_disk_that_fills_up_meanwhile_stops_nothing(step, source, home, monkeypatch, caplog):
    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as small:
        small.setattr(caching.IndexDataCacheFile, step, full)
        package, said = kernel(caplog)
    assert package.calendar.many.stats.cache_path is None
    assert "No space left" in said[-1]
    assert not compiled.cache_folder().exists()
    assert kernel(caplog)[0].calendar.many.stats.cache_path is not None
    assert len(code(home)) == 2


def test_a_folder_that_vanishes_meanwhile_is_made_again(source, home, monkeypatch, caplog):
    play = compiled._play_nothing

    def vanish(package):
        shutil.rmtree(home / ".cache")
        play(package)

    monkeypatch.setattr(compiled, "_play_nothing", vanish)
    assert kernel(caplog)[0].calendar.many.stats.cache_path is not None
    assert len(code(home)) == 2


@pytest.mark.parametrize("kind", ["nbi", "nbc"])
@pytest.mark.parametrize("left", [b"", b"\x80\x05garbage"])
def test_broken_code_is_thrown_away_and_made_again(kind, left, source, home, caplog):
    kernel(caplog)
    for file in home.rglob(f"*.{kind}"):
        file.write_bytes(left)
    package, said = kernel(caplog)
    assert package.calendar.many.stats.cache_path is None
    assert len(said) == 1
    _, said = kernel(caplog)
    assert "this once" in said[0]
    assert kernel(caplog)[1] == []


def test_numba_set_to_compile_nothing_says_so_and_loses_nothing(source, home, monkeypatch, caplog):
    kernel(caplog)
    monkeypatch.setattr(config, "DISABLE_JIT", 1)
    with pytest.raises(ImportError, match="DISABLE_JIT"):
        compiled._kernel.__wrapped__()
    assert len(code(home)) == 2


def test_the_users_settings_of_numba_stay_as_they_were(source, home, monkeypatch, caplog):
    for given in ("", str(home / "numba")):
        monkeypatch.setattr(config, "CACHE_DIR", given)
        kernel(caplog)
        assert given == config.CACHE_DIR


# The real kernel, as in a new process: half a minute each


def played(env, folder=ROOT):
    """(rests in bytes, stderr) of compiled and interpreted shots in another process."""
    code = (
        "import sys, numpy as np\n"
        "from physics import Shot, scenes, simulate_many\n"
        "shots = [[3.0, 3.6 * k, 0.5, 0.0, 1.0] for k in range(100)]\n"
        "how = [simulate_many(scenes.carom(), 'white', shots, compiled=c) for c in (True, False)]\n"
        "assert (how[0].positions == how[1].positions).all(), 'not what is interpreted'\n"
        "sys.stdout.buffer.write(how[0].positions.tobytes())\n"
    )
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("XDG_", "NUMBA_"))}
    return subprocess.Popen(
        [sys.executable, "-c", code], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        env={**kept, "PYTHONPATH": str(folder), **env},
    )  # fmt: skip


def outcome(process):
    out, err = process.communicate()
    assert process.returncode == 0, err.decode()
    return out, err.decode()


@pytest.mark.stress
def test_after_an_edit_compiled_shots_are_what_the_source_says_without_a_cache_too(tmp_path):
    shutil.copytree(ROOT / "physics", tmp_path / "physics",
                    ignore=shutil.ignore_patterns("__pycache__"))  # fmt: skip
    laws, found = tmp_path / "physics" / "kernel" / "laws.py", []
    for e in ("closing + (", "0.9 * closing + ("):
        laws.write_text(laws.read_text().replace("closing + (", e))
        out, err = outcome(played({"XDG_CACHE_HOME": "/proc/nope"}, tmp_path))
        assert err.count("\n") == 1
        found.append(out)
    assert found[0] != found[1]
    assert code(tmp_path) == []


@pytest.mark.stress
def test_two_processes_that_compile_at_once_do_not_disturb_each_other(tmp_path):
    env = {"XDG_CACHE_HOME": str(tmp_path)}
    first, second = map(outcome, [played(env), played(env)])
    assert first[0] == second[0]
    assert outcome(played(env)) == (first[0], "")


@pytest.mark.stress
@pytest.mark.skipif(not hasattr(os, "setuid") or os.getuid() != 0, reason="needs another user")
def test_a_user_unknown_to_the_system_plays_many_shots():
    code = (
        "import os, numba\n"
        "from physics import scenes, simulate_many\n"
        "numba.njit(lambda x: x * 1j)(1.0)  # loads what that user may not be able to read\n"
        "os.setgid(12345), os.setuid(12345)\n"
        "print(simulate_many(scenes.carom(), 'white', [[3.0, 10.0, 0, 0, 0]] * 5000).times[0])\n"
    )
    env = {k: v for k, v in os.environ.items() if k != "HOME" and not k.startswith("XDG_")}
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True, env=env
    )
    assert float(done.stdout) > 0.0
    assert done.stderr.count("\n") == 1
