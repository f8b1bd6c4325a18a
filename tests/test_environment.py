"""What is lacking, and how a checkout gets its .venv: whole or not at all, and every failure one line.

The set-ups here are real processes with a stand-in for ``venv`` and ``pip`` on PYTHONPATH: no network, no waiting.
"""

import ast
import importlib.metadata
import io
import os
import re
import shutil
import signal
import subprocess
import sys
import textwrap
import time
import tomllib
from pathlib import Path

import psutil  # comes with ipykernel
import pytest

from bezteach import environment
from bezteach.__main__ import NEEDED, too_old
from bezteach.environment import Problem

ROOT = Path(environment.__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
posix = pytest.mark.skipif(os.name != "posix", reason="the stand-in .venv is made of links")


# --- the version of Python


def test_needed_version_is_the_declared_one():
    assert PROJECT["requires-python"] == ">=" + ".".join(map(str, NEEDED))


@pytest.mark.parametrize("version", [(2, 7, 18), (3, 6, 15), (3, 10, 99)])
def test_old_python_is_told_in_one_line(version):
    message = too_old(version)
    assert "3.11" in message and ".".join(map(str, version)) in message and "\n" not in message


@pytest.mark.parametrize("version", [(3, 11, 0), (3, 14, 0), (4, 0, 0)])
def test_new_python_is_good(version):
    assert too_old(version) == ""


@pytest.mark.parametrize("name", ["__init__.py", "__main__.py"])
def test_old_python_can_read_what_tells_it(name):
    ast.parse((ROOT / "bezteach" / name).read_text(encoding="utf-8"), feature_version=(3, 6))


@pytest.mark.parametrize("name", ["__init__", "__main__", "cli", "environment", "lab", "workspace"])
def test_what_runs_before_the_set_up_imports_the_standard_library_only(name):
    tree = ast.parse((ROOT / "bezteach" / f"{name}.py").read_text(encoding="utf-8"))
    names = []
    for node in tree.body:
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names.append(node.module)
    assert {name.partition(".")[0] for name in names} <= {*sys.stdlib_module_names, "bezteach"}


# --- requirements


def test_every_declared_requirement_is_understood():
    for group in environment.declared(ROOT).values():
        for requirement in group:
            environment.split_requirement(requirement)


@pytest.mark.parametrize("text", ["x~=1.0", "x==1.*", "x>=1; python_version<'3.12'", "x @ file:///x", ""])
def test_requirement_of_another_kind_is_refused(text):
    with pytest.raises(ValueError, match="cannot read"):
        environment.split_requirement(text)


@pytest.mark.parametrize(
    ("version", "pairs", "expected"),
    [
        ("3.10.0", [(">=", "3.9")], True),  # numbers, not text
        ("3.9", [(">=", "3.10")], False),
        ("2", [("==", "2.0.0")], True),
        ("3.11.2", [("==", "3.11.2")], True),
        ("3.11.20", [("==", "3.11.2")], False),
        ("2.5", [(">=", "2"), ("<", "3")], True),
        ("3.0", [(">=", "2"), ("<", "3")], False),
        ("2.0rc1", [(">=", "2.0")], True),
        ("1.2.post1+local", [("<=", "1.2"), ("!=", "1.3"), (">", "1.1")], True),
        ("0", [], True),
    ],
)
def test_versions_are_compared_number_by_number(version, pairs, expected):
    assert environment.satisfies(version, pairs) is expected


def test_an_extra_brings_what_it_refers_to():
    names = {environment.split_requirement(text)[0] for text in environment.requirements("test", ROOT)}
    assert {"numpy", "jupyterlab", "ipykernel", "pytest"} <= names
    assert "bezteach" not in names


def test_extras_that_refer_to_each_other_end(monkeypatch):
    groups = {"": ["x"], "a": ["bezteach[b]", "y"], "b": ["bezteach[a]", "x", "z"]}
    monkeypatch.setattr(environment, "declared", lambda root: groups)
    assert environment.requirements("a", None) == ["x", "y", "z"]
    with pytest.raises(ValueError, match="no extra 'c'"):
        environment.requirements("c", None)


def test_installed_metadata_say_the_same_as_pyproject(monkeypatch):
    lines = [*PROJECT["dependencies"]]
    for extra, group in PROJECT["optional-dependencies"].items():
        lines += [f"{requirement}; extra == '{extra}'" for requirement in group]
    monkeypatch.setattr(importlib.metadata, "requires", lambda name: lines)
    assert environment.declared(None) == environment.declared(ROOT)


def test_metadata_missing_is_an_incomplete_copy(monkeypatch):
    def requires(name):
        raise importlib.metadata.PackageNotFoundError

    monkeypatch.setattr(importlib.metadata, "requires", requires)
    with pytest.raises(Problem, match="pip install"):
        environment.declared(None)


def test_lacking_names_what_is_absent_too_old_or_broken(monkeypatch):
    installed = {"good": "2.0", "old": "1.9", "broken": None}
    asked = ["good>=2", "old>=2", "broken", "absent"]
    monkeypatch.setattr(environment, "declared", lambda root: {"": asked, "x": []})

    def version(name):
        if name not in installed:
            raise importlib.metadata.PackageNotFoundError
        return installed[name]

    monkeypatch.setattr(importlib.metadata, "version", version)
    assert environment.lacking("x", ROOT) == ["old>=2", "broken", "absent"]


def test_here_nothing_is_lacking_and_nothing_is_set_up(monkeypatch):
    monkeypatch.setattr(environment, "set_up", lambda *arguments: pytest.fail("set up"))
    environment.ready("test", [])


def test_installed_wheel_says_what_to_install(monkeypatch):
    monkeypatch.setattr(environment, "checkout", lambda: None)
    monkeypatch.setattr(environment, "lacking", lambda extra, root: ["jupyterlab"])
    with pytest.raises(Problem, match=re.escape('pip install "bezteach[lab]"')):
        environment.ready("lab", [])


def test_checkout_is_told_from_an_installed_package(tmp_path):
    package = tmp_path / "bezteach"
    assert environment.checkout(package) is None
    for text, expected in (("[project]\nname='other'", None), ("[project]\nname='bezteach'", tmp_path)):
        (tmp_path / "pyproject.toml").write_text(text, encoding="utf-8")
        assert environment.checkout(package) == expected
    (tmp_path / "pyproject.toml").write_text("<<<<<<< HEAD", encoding="utf-8")
    with pytest.raises(Problem, match="cannot read"):
        environment.checkout(package)


# --- paths, processes, words


def test_interpreter_on_windows_and_elsewhere():
    folder = Path("x", ".venv")
    assert environment.interpreter(folder, windows=True) == folder / "Scripts" / "python.exe"
    assert environment.interpreter(folder, windows=False) == folder / "bin" / "python"


def test_children_find_the_checkout_first_and_once(monkeypatch):
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(["", "/other", "/clone"]))
    assert environment.child_environment(Path("/clone"))["PYTHONPATH"] == os.pathsep.join(["/clone", "/other"])
    monkeypatch.delenv("PYTHONPATH")
    assert environment.child_environment(Path("/clone"))["PYTHONPATH"] == "/clone"
    assert "PYTHONPATH" not in environment.child_environment(None)


@pytest.mark.parametrize("windows", [True, pytest.param(False, marks=posix)])
def test_becoming_another_command_passes_its_exit_code_on(windows, tmp_path):
    code = textwrap.dedent(f"""
        import os, sys
        from bezteach.environment import become
        inner = "import os, sys; print(os.getcwd(), sys.argv[1:]); sys.exit(7)"
        become([sys.executable, "-c", inner, "a b", "-h"], dict(os.environ), cwd={str(tmp_path)!r}, windows={windows})
    """)
    done = subprocess.run(
        [sys.executable, "-c", code],
        check=False,
        capture_output=True,
        text=True,
        env=environment.child_environment(ROOT),
    )
    assert (done.returncode, done.stdout, done.stderr) == (7, f"{tmp_path.resolve()} ['a b', '-h']\n", "")


@posix
def test_interruption_waits_until_the_block_is_done():
    steps = []
    with pytest.raises(KeyboardInterrupt), environment.held_back():
        signal.raise_signal(signal.SIGINT)
        steps.append("done")
    assert steps == ["done"]


PIP = """\
Looking in indexes: x
Obtaining file:///clone
  Installing build dependencies: started
Collecting numpy>=2.0 (from bezteach==0.1.0)
  Downloading numpy-2.3.1-cp311-cp311-linux.whl (16 MB)
Collecting ipywidgets>=8.1
Building wheels for collected packages: bezteach
Installing collected packages: numpy, ipywidgets, bezteach
Successfully installed numpy-2.3.1
""".splitlines()


class Terminal(io.StringIO):
    def isatty(self):
        return True


def told(stream):
    tell = environment.teller(stream, clock=lambda: 0.0)
    for line in PIP:
        if news := environment.news(line):
            tell(*news)
    tell(None)
    return stream.getvalue()


def test_pips_many_lines_become_a_few():
    assert told(io.StringIO()).splitlines() == [
        "bezteach: preparing",
        "bezteach: collecting packages",
        "bezteach: installing 3 packages",
    ]


def test_on_a_terminal_one_line_is_kept_up_to_date_and_cleared(monkeypatch):
    monkeypatch.setenv("COLUMNS", "50")
    text = told(Terminal())
    assert "\n" not in text
    shown = [part.rstrip() for part in text.split("\r") if part.strip()]
    assert shown[-1] == "[  0 s] installing 3 packages: numpy, ipywidge..."
    assert "[  0 s] collecting packages: numpy" in shown
    assert max(map(len, shown)) < 50
    assert text.endswith("\r" + " " * 49 + "\r")


@pytest.mark.parametrize(
    ("output", "expected"),
    [
        (
            "WARNING: Retrying ... NewConnectionError(...)\nERROR: No matching distribution found for hatchling",
            "network",
        ),
        ("ERROR: Could not install packages due to an OSError: [Errno 28] No space left on device", "full"),
        ("/x/.venv/bin/python: No module named pip", "no pip"),
        ("ERROR: Could not install: [Errno 13] Permission denied: '/x'", "permission"),
        (
            "ERROR: first\nnote: this is\nERROR: No matching distribution found for x==9\n\n[notice] new pip",
            "found for x==9",
        ),
        ("Traceback\nValueError: odd", "ValueError: odd"),
        ("", "no reason was given"),
    ],
)
def test_reason_is_one_line(output, expected):
    reason = environment.reason(output.splitlines())
    assert expected in reason and "\n" not in reason and "ERROR" not in reason


# --- set-ups, with stand-ins for venv and pip

# Makes what counts in a .venv: an interpreter of its own, with its own place for packages.
VENV = f"""
import os, pathlib, sys
if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[-1])
    (folder / "bin").mkdir(parents=True)
    (folder / "bin" / "python").symlink_to({os.path.realpath(sys.executable)!r})
    (folder / "pyvenv.cfg").write_text("home = " + {os.path.dirname(os.path.realpath(sys.executable))!r})
"""
# Installs the one package that lacks, and leaves a note of every call.
PIP_GOOD = """
import os, pathlib, sys, sysconfig
with open(os.environ["CALLS"], "a") as calls:
    print(*sys.argv[1:], file=calls)
print("Installing collected packages: absent")
folder = pathlib.Path(sysconfig.get_path("purelib"), "absent-1.0.dist-info")
folder.mkdir(parents=True)
(folder / "METADATA").write_text("Metadata-Version: 2.1\\nName: absent\\nVersion: 1.0\\n")
"""
PIP_FAILS = """
import sys
print("Collecting absent")
print("ERROR: No matching distribution found for absent>=1")
print("[notice] something else")
sys.exit(1)
"""
PIP_SLOW = """
import os, subprocess, sys, time
child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
open(os.environ["CALLS"], "w").write(f"{os.getpid()} {child.pid}")
print("Collecting absent", flush=True)
time.sleep(600)
"""
PYTEST = """
import os, sys
import bezteach
print("pytest", sys.argv[1:], os.getcwd(), bezteach.__file__, "in", sys.prefix)
sys.exit(5)
"""


@pytest.fixture
def clone(tmp_path):
    """A checkout whose name is hard to handle, with a requirement that is nowhere installed, and the stand-ins."""
    root = tmp_path / "Bézier 曲线, a 'copy'"
    root.mkdir()
    shutil.copytree(ROOT / "bezteach", root / "bezteach", ignore=shutil.ignore_patterns("__pycache__"))
    (root / "pyproject.toml").write_text(
        '[project]\nname = "bezteach"\n[project.optional-dependencies]\ntest = ["absent>=1"]\n', encoding="utf-8"
    )
    stand_in(tmp_path, venv=VENV, pip=PIP_GOOD, pytest=PYTEST, ensurepip="")
    return root


def stand_in(folder, **modules):
    (folder / "fakes").mkdir(exist_ok=True)
    for name, text in modules.items():
        (folder / "fakes" / f"{name}.py").write_text(text, encoding="utf-8")


def setting(clone):
    fakes = clone.parent / "fakes"
    paths = os.pathsep.join([str(clone), str(fakes)])
    return {**os.environ, "PYTHONPATH": paths, "CALLS": str(clone.parent / "calls"), "PYTHONUTF8": "1"}


def run(clone, *arguments, **options):
    return subprocess.run(
        [sys.executable, "-m", "bezteach", *(arguments or ["test"])],
        check=False,
        cwd=clone.parent,
        env={**setting(clone), **options},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=120,
    )


def begin(clone, wait_for):
    """Start ``bezteach test`` and return the process once a line of its output has these words."""
    process = subprocess.Popen(
        [sys.executable, "-m", "bezteach", "test"],
        cwd=clone.parent,
        env=setting(clone),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        encoding="utf-8",
    )
    if not any(wait_for in line for line in process.stdout):
        pytest.fail(process.communicate()[1])
    return process


def one_line(done, *words):
    """The run failed with one line on stderr that has these words."""
    assert done.returncode == 1
    assert done.stderr.startswith("bezteach: ") and done.stderr.count("\n") == 1, done.stderr
    for word in words:
        assert word in done.stderr
    return True


@posix
class TestSetUp:
    def test_from_nothing(self, clone):
        done = run(clone, "test", "-h", "--version", "a b")
        assert (done.returncode, done.stderr) == (5, "")
        lines = done.stdout.splitlines()
        assert lines[0].startswith(f"bezteach: setting up {clone / '.venv'} (once, a minute or two")
        assert "bezteach: installing 1 packages" in lines
        seen = f"pytest ['-h', '--version', 'a b'] {clone} {clone / 'bezteach' / '__init__.py'} in {clone / '.venv'}"
        assert lines[-1] == seen
        assert (clone.parent / "calls").read_text().split() == ["install", "--no-user", "-e", ".[test]"]
        assert sorted(path.name for path in (clone / ".venv").iterdir()) == ["bin", "lib", "pyvenv.cfg"]

    def test_second_time_it_is_used_without_a_word(self, clone):
        run(clone)
        stand_in(clone.parent, pip="raise SystemExit('called')", venv="raise SystemExit('called')")
        done = run(clone)
        assert (done.returncode, done.stderr, done.stdout.count("\n")) == (5, "", 1)

    def test_new_requirement_is_installed_into_it(self, clone):
        run(clone)
        installed = next((clone / ".venv").rglob("absent-1.0.dist-info"))
        (installed / "METADATA").write_text("Metadata-Version: 2.1\nName: absent\nVersion: 0.9\n")
        installed.rename(installed.with_name("absent-0.9.dist-info"))
        stand_in(clone.parent, pip=PIP_FAILS)
        assert one_line(run(clone), "installing failed", "No matching distribution found for absent>=1")
        assert (clone / ".venv" / "pyvenv.cfg").exists()
        stand_in(
            clone.parent,
            pip=f"import shutil; shutil.rmtree({str(installed.with_name('absent-0.9.dist-info'))!r})" + PIP_GOOD,
        )
        done = run(clone)
        assert (done.returncode, done.stderr) == (5, "")
        assert "bezteach: installing what is new into .venv: absent>=1" in done.stdout

    def test_failing_pip_leaves_nothing(self, clone):
        stand_in(clone.parent, pip=PIP_FAILS)
        assert one_line(run(clone), "installing failed: No matching distribution found for absent>=1")
        assert not (clone / ".venv").exists()

    def test_pip_that_installs_nothing_is_no_endless_loop(self, clone):
        stand_in(clone.parent, pip="")
        assert one_line(run(clone), "still lacks absent>=1")
        assert not (clone / ".venv").exists()

    def test_failing_venv_leaves_nothing(self, clone):
        stand_in(clone.parent, venv=VENV + "\n    sys.exit('Error: [Errno 28] No space left on device')")
        assert one_line(run(clone), "could not make", "full")
        assert not (clone / ".venv").exists()

    @pytest.mark.parametrize("module", ["venv", "ensurepip"])
    def test_python_without_venv(self, clone, module):
        stand_in(clone.parent, **{module: "raise ImportError"})
        assert one_line(run(clone), "lacks the modules venv and ensurepip")
        assert not (clone / ".venv").exists()

    @pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
    @pytest.mark.parametrize("slow", ["venv", "pip"])
    def test_interruption_leaves_nothing_behind(self, clone, number, slow):
        stand_in(clone.parent, **{slow: "if __name__ == '__main__':" + textwrap.indent(PIP_SLOW, "    ")})
        with begin(clone, "collecting packages") as process:
            process.send_signal(number)
            _, error = process.communicate(timeout=60)
        assert process.returncode == 128 + number
        assert error == ("bezteach: stopped\n" if number == signal.SIGINT else "")
        assert not (clone / ".venv").exists()
        for child in (clone.parent / "calls").read_text().split():
            assert is_gone(int(child))

    def test_what_a_power_cut_left_is_made_anew(self, clone):
        stand_in(clone.parent, pip=PIP_SLOW)
        with begin(clone, "collecting packages") as process:
            process.kill()
            process.communicate()
        os.killpg(int((clone.parent / "calls").read_text().split()[0]), signal.SIGKILL)
        (clone.parent / "calls").unlink()
        assert (clone / ".venv").exists()
        stand_in(clone.parent, pip=PIP_GOOD)
        done = run(clone)
        assert (done.returncode, done.stderr) == (5, "")
        assert "cut off" in done.stdout

    def test_two_at_once_wait_for_each_other(self, clone):
        stand_in(clone.parent, pip="import time; time.sleep(1.5)\n" + PIP_GOOD)
        with begin(clone, "setting up") as one, begin(clone, "waiting for another") as two:
            outputs = [one.communicate(timeout=120)[0], two.communicate(timeout=120)[0]]
        assert [one.returncode, two.returncode] == [5, 5]
        assert "set up after" in outputs[0]
        assert [line.split()[0] for line in outputs[1].splitlines()] == ["pytest"]

    def test_gone_interpreter_is_replaced(self, clone):
        run(clone)
        python = clone / ".venv" / "bin" / "python"
        python.unlink()
        python.symlink_to("/no/such/python")
        done = run(clone)
        assert (done.returncode, done.stderr) == (5, "")
        assert "is gone; making it anew" in done.stdout

    @pytest.mark.parametrize("kind", ["file", "folder", "link to nowhere"])
    def test_something_else_of_that_name_is_left_alone(self, clone, kind):
        place = clone / ".venv"
        if kind == "file":
            place.write_text("mine")
        elif kind == "folder":
            place.mkdir()
            (place / "mine").touch()
        else:
            place.symlink_to("nowhere")
        assert one_line(run(clone), "is in the way")
        assert os.path.lexists(place) and (kind != "folder" or (place / "mine").exists())

    def test_venv_without_pip(self, clone):
        run(clone)
        shutil.rmtree(next((clone / ".venv").rglob("absent-1.0.dist-info")))
        stand_in(clone.parent, pip="import sys; sys.exit('python: No module named pip')")
        assert one_line(run(clone), "has no pip", "delete the folder")
        assert (clone / ".venv" / "pyvenv.cfg").exists()

    def test_folder_that_cannot_be_written(self, clone):
        # Root is stopped by no permission bits, so the refusal comes from a stand-in.
        stand_in(clone.parent, sitecustomize=REFUSE.format(place=str(clone / ".venv")))
        assert one_line(run(clone), "could not make", "no permission to write there")

    def test_pip_settings_of_the_user_stay(self, clone):
        stand_in(clone.parent, pip="import os; print('ERROR: retries', os.environ['PIP_RETRIES']); raise SystemExit(1)")
        assert one_line(run(clone, PIP_RETRIES="7"), "retries 7")
        assert one_line(run(clone), "retries 1")


REFUSE = """
import os
real = os.mkdir
def mkdir(path, *rest, **named):
    if os.fspath(path) == {place!r}:
        raise PermissionError(13, "Permission denied", path)
    return real(path, *rest, **named)
os.mkdir = mkdir
"""


def is_gone(pid):
    """A process that has ended, waited for or not; given a moment, since signals take one."""
    for _ in range(100):
        try:
            if psutil.Process(pid).status() == psutil.STATUS_ZOMBIE:
                return True
        except psutil.NoSuchProcess:
            return True
        time.sleep(0.1)
    return False
