"""Pytest's interpreter: a Ctrl-C that came while it started, or while pytest loads, is one line."""

import os
import subprocess
import sys

import pytest

from bezteach.setup import processes
from bezteach.setup.requirements import PACKAGE

posix = pytest.mark.skipif(os.name != "posix", reason="Windows knows neither exec nor these signals")


def run(code):
    environment = processes.child_environment(PACKAGE.parent)
    return subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True, env=environment)


@posix
@pytest.mark.parametrize("module", ["bezteach", "bezteach.setup.testing"])
def test_an_interruption_waits_for_the_next_interpreter(module):
    done = run(f"""if True:
        import os, signal, sys
        from bezteach.setup import processes
        signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
        os.kill(os.getpid(), signal.SIGINT)
        processes.become([sys.executable, "-m", {module!r}, "test", "--version"], dict(os.environ))
    """)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "bezteach: stopped\n")


@posix
def test_what_cannot_be_started_leaves_interruptions_as_they_were():
    done = run("""if True:
        import os, signal
        from bezteach.setup import processes
        try:
            processes.become(["/no/such/program"], {})
        except FileNotFoundError:
            print(signal.pthread_sigmask(signal.SIG_BLOCK, []))
    """)
    assert done.stdout == "set()\n"


def test_pytest_says_its_own_words_and_has_its_own_exit_code(tmp_path):
    (tmp_path / "pytest.ini").write_text("[pytest]\n")
    done = run(f"""if True:
        import sys
        from bezteach.setup.testing import main
        sys.exit(main(["-c", {str(tmp_path / "pytest.ini")!r}, {str(tmp_path)!r}]))
    """)
    assert done.returncode == pytest.ExitCode.NO_TESTS_COLLECTED
    assert "no tests ran" in done.stdout
