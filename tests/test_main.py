"""The entry: an old Python gets one line, a bare one gets as far as the set-up."""

import ast
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import bezteach
from bezteach.__main__ import NEEDED, too_old

ROOT = Path(bezteach.__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


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


def test_what_runs_before_the_set_up_loads_the_standard_library_only():
    modules = ["bezteach.cli", *(f"bezteach.setup.{path.stem}" for path in (ROOT / "bezteach/setup").glob("*.py"))]
    assert len(modules) > 2
    # -S: without the installed packages.
    command = [sys.executable, "-E", "-S", "-c", "import " + ", ".join(modules)]
    done = subprocess.run(command, check=False, cwd=ROOT, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
