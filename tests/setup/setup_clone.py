"""A checkout to set up with real processes, and stand-ins for ``venv`` and ``pip``: no network, no waiting."""

import os
import subprocess
import sys

import pytest

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
