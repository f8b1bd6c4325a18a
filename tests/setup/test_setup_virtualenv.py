"""How a checkout gets its .venv: whole or not at all, and every failure one line."""

import os
import re
import shutil
import signal
import textwrap
import time
from pathlib import Path

import psutil  # comes with ipykernel
import pytest
from setup_clone import PIP_FAILS, PIP_GOOD, PIP_SLOW, VENV, begin, one_line, run, stand_in

from bezteach.setup import virtualenv
from bezteach.setup.progress import Problem

posix = pytest.mark.skipif(os.name != "posix", reason="the stand-in .venv is made of links")


def test_here_nothing_is_lacking_and_nothing_is_set_up(monkeypatch):
    monkeypatch.setattr(virtualenv, "set_up", lambda *arguments: pytest.fail("set up"))
    virtualenv.ready("test", [])


def test_installed_wheel_says_what_to_install(monkeypatch):
    monkeypatch.setattr(virtualenv, "checkout", lambda: None)
    monkeypatch.setattr(virtualenv, "lacking", lambda extra, root: ["jupyterlab"])
    with pytest.raises(Problem, match=re.escape('pip install "bezteach[lab]"')):
        virtualenv.ready("lab", [])


def test_interpreter_on_windows_and_elsewhere():
    folder = Path("x", ".venv")
    assert virtualenv.interpreter(folder, windows=True) == folder / "Scripts" / "python.exe"
    assert virtualenv.interpreter(folder, windows=False) == folder / "bin" / "python"


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
