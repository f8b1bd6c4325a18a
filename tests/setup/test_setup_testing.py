"""Pytest's interpreter: a Ctrl-C that came while it started, or while pytest loads, is one line."""

import os
import subprocess
import sys

import pytest

from bezteach.setup import processes
from bezteach.setup.requirements import PACKAGE

posix = pytest.mark.skipif(os.name != "posix", reason="Windows knows neither exec nor these signals")


def run(code, *arguments):
    """Run the code; a pytest in it comes with no plugin but what its arguments name, which is seconds faster."""
    environment = processes.child_environment(PACKAGE.parent) | {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
    command = [sys.executable, "-c", code, *arguments]
    return subprocess.run(command, check=False, capture_output=True, text=True, env=environment)


INTERRUPTED = """if True:
    import os, signal, sys
    from bezteach.setup import processes
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    os.kill(os.getpid(), signal.SIGINT)
    processes.become([sys.executable, "-m", *sys.argv[1:]], dict(os.environ))
"""


@posix
def test_an_interruption_waits_for_the_next_interpreter():
    done = run(INTERRUPTED, "bezteach", "test", "--version")
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "bezteach: stopped\n")


@posix
def test_an_interruption_waits_until_pytest_can_deal_with_it(tmp_path):
    (tmp_path / "pytest.ini").write_text("[pytest]\n")
    done = run(
        INTERRUPTED, "bezteach.setup.testing", "-p", "xdist", "-n0", "-c", str(tmp_path / "pytest.ini"), str(tmp_path)
    )
    assert done.returncode == pytest.ExitCode.INTERRUPTED
    assert "! KeyboardInterrupt !" in done.stdout and "Traceback" not in done.stdout + done.stderr


@posix
def test_ctrl_c_is_passed_on_to_the_child_alone():
    """Child and grandchild count what they get; the parent gets two interruptions, and the child's exit code."""
    grandchild = "import signal, time; signal.signal(signal.SIGINT, lambda *_: print('grandchild')); time.sleep(0.4)"
    child = f"""if True:
        import signal, subprocess, sys
        got = []
        signal.signal(signal.SIGINT, lambda *_: got.append(1))
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
        print("ready", flush=True)
        subprocess.run([sys.executable, "-c", {grandchild!r}])
        sys.exit(10 + len(got))
    """
    done = run(f"""if True:
        import os, signal, sys, threading, time
        from bezteach.setup import processes
        def interrupt():
            for _ in range(2):
                time.sleep(0.2)
                os.kill(os.getpid(), signal.SIGINT)
        threading.Thread(target=interrupt).start()
        sys.exit(processes.attend([sys.executable, "-c", {child!r}], dict(os.environ), "."))
    """)
    assert done.returncode in (11, 12) and done.stdout == "ready\n", done.stderr


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
        sys.exit(main(["-p", "xdist", "-n0", "-c", {str(tmp_path / "pytest.ini")!r}, {str(tmp_path)!r}]))
    """)
    assert done.returncode == pytest.ExitCode.NO_TESTS_COLLECTED
    assert "no tests ran" in done.stdout
