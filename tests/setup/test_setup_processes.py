"""Processes: they import the checkout, pass on their exit code, and are neither lost nor left over."""

import os
import signal
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from bezteach.setup import processes
from bezteach.setup.requirements import PACKAGE

posix = pytest.mark.skipif(os.name != "posix", reason="Windows knows neither exec nor these signals")


def test_children_find_the_checkout_first_and_once(monkeypatch):
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(["", "/other", "/clone"]))
    assert processes.child_environment(Path("/clone"))["PYTHONPATH"] == os.pathsep.join(["/clone", "/other"])
    monkeypatch.delenv("PYTHONPATH")
    assert processes.child_environment(Path("/clone"))["PYTHONPATH"] == "/clone"
    assert "PYTHONPATH" not in processes.child_environment(None)


@pytest.mark.parametrize("windows", [True, pytest.param(False, marks=posix)])
def test_becoming_another_command_passes_its_exit_code_on(windows, tmp_path):
    code = textwrap.dedent(f"""
        import os, sys
        from bezteach.setup.processes import become
        inner = "import os, sys; print(os.getcwd(), sys.argv[1:]); sys.exit(7)"
        become([sys.executable, "-c", inner, "a b", "-h"], dict(os.environ), cwd={str(tmp_path)!r}, windows={windows})
    """)
    done = subprocess.run(
        [sys.executable, "-c", code],
        check=False,
        capture_output=True,
        text=True,
        env=processes.child_environment(PACKAGE.parent),
    )
    assert (done.returncode, done.stdout, done.stderr) == (7, f"{tmp_path.resolve()} ['a b', '-h']\n", "")


@posix
def test_interruption_waits_until_the_block_is_done():
    steps = []
    with pytest.raises(KeyboardInterrupt), processes.held_back():
        signal.raise_signal(signal.SIGINT)
        steps.append("done")
    assert steps == ["done"]
