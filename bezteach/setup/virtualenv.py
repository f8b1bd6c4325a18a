"""The ``.venv`` beside pyproject.toml, in which a checkout's commands run.

The way through it is ``ready``: nothing happens where nothing is lacking; an installed wheel is told what to install;
a checkout gets its ``.venv`` made or completed, and the command starts again inside it.
"""

import json
import os
import shutil
import subprocess
import sys
import time

from bezteach.__main__ import NEEDED
from bezteach.setup.locking import alone
from bezteach.setup.processes import WINDOWS, become, child_environment, held_back
from bezteach.setup.progress import AGAIN, Problem, reason, run, say, teller
from bezteach.setup.requirements import checkout, lacking

# Lies in a .venv until it is complete, so that one left by a power cut is not taken for a good one.
UNFINISHED = "bezteach-unfinished"


def interpreter(folder, windows=WINDOWS):
    """Return the path of a virtual environment's interpreter."""
    return folder.joinpath(*(("Scripts", "python.exe") if windows else ("bin", "python")))


def ready(extra, arguments):
    """Return if everything of this extra is here; else see to it, and go on as ``bezteach arguments`` where it is.

    Raises Problem if that is not possible; a .venv made on the way is removed again.
    """
    root = checkout()
    if not lacking(extra, root):
        return
    if root is None:
        raise Problem(f'something is missing here: run pip install "bezteach{bracketed(extra)}", {AGAIN}')
    with alone(root):
        python = set_up(root, extra)
    become([python, "-m", "bezteach", *arguments], child_environment(root))


def set_up(root, extra):
    """Bring the checkout's .venv to where it satisfies the extra, and return its interpreter. Assumes ``alone``."""
    folder = root / ".venv"
    python = interpreter(folder)
    whole = (folder / "pyvenv.cfg").is_file()
    if (folder / UNFINISHED).exists():
        say("an earlier set-up was cut off; starting anew")
        _remove(folder)
    elif whole and not _runs(python):
        say(f"the Python that {folder} was made with is gone; making it anew")
        _can_make()
        _remove(folder)
    if not os.path.lexists(folder):
        _make(root, folder, extra)
    elif not whole:
        raise Problem(f"{folder} is in the way, it is no virtual environment: move it elsewhere, {AGAIN}")
    elif missing := _ask(python, root, extra):
        say(f"installing what is new into .venv: {', '.join(missing)}")
        _install(root, python, extra, teller())
    return python


def bracketed(extra):
    """An extra behind the name it belongs to; none for what is always needed."""
    return f"[{extra}]" if extra else ""


def _runs(python):
    """Tell whether an interpreter starts at all (-I: whatever the user's PYTHON variables say)."""
    try:
        subprocess.run([python, "-I", "-c", ""], check=True, stdin=subprocess.DEVNULL, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        return False
    return True


_QUESTION = """
import json, sys
from bezteach.__main__ import too_old
answer = too_old(sys.version_info)
if not answer:
    from bezteach.setup.requirements import checkout, lacking
    answer = lacking(sys.argv[1], checkout())
print(json.dumps(answer))
"""


def _ask(python, root, extra):
    """Ask another interpreter what it lacks. Raises Problem if it cannot tell."""
    answer = subprocess.run(
        [python, "-c", _QUESTION, extra],
        check=False,
        env=child_environment(root),
        cwd=root,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        errors="replace",
    )
    if answer.returncode:
        raise Problem(f"{python} does not work: {reason(answer.stderr.splitlines())}")
    found = json.loads(answer.stdout.splitlines()[-1])
    if isinstance(found, str):
        raise Problem(f"{python} is too old, {'.'.join(map(str, NEEDED))} is needed: delete {root / '.venv'}, {AGAIN}")
    return found


def _can_make():
    """Raise Problem if this Python cannot make virtual environments (Debian ships that part apart)."""
    try:
        import ensurepip  # noqa: F401
        import venv  # noqa: F401
    except ImportError:
        package = f"python{sys.version_info[0]}.{sys.version_info[1]}-venv"
        todo = f"run sudo apt install {package}" if shutil.which("apt") else "install the part of Python with them"
        raise Problem(f"this Python lacks the modules venv and ensurepip: {todo}, {AGAIN}") from None


def _make(root, folder, extra):
    """Make the .venv with everything in it, or leave nothing behind."""
    _can_make()
    made = False
    say(f"setting up {folder} (once, a minute or two; Ctrl-C stops it)")
    tell, begin = teller(), time.monotonic()
    try:
        with held_back():
            folder.mkdir()
            made = True
            (folder / UNFINISHED).touch()
        code, lines = run([sys.executable, "-m", "venv", str(folder)], root, tell, "making .venv")
        if code:
            raise Problem(f"could not make {folder}: {reason(lines, root)}")
        _install(root, interpreter(folder), extra, tell)
        (folder / UNFINISHED).unlink()
    except BaseException as error:
        if made:
            with held_back():
                _remove(folder)
        if isinstance(error, OSError):
            raise Problem(f"could not make {folder}: {reason([str(error)], root)}") from None
        raise
    say(f"set up after {time.monotonic() - begin:.0f} s")


def _install(root, python, extra, tell):
    """Install the checkout with its extra, in place. Raises Problem with pip's reason."""
    # --no-user: a setting that is of use outside, and an error inside a virtual environment.
    command = [str(python), "-m", "pip", "install", "--no-user", "-e", f".{bracketed(extra)}"]
    code, lines = run(command, root, tell, "preparing")
    if code:
        raise Problem(f"installing failed: {reason(lines, root)}")
    if missing := _ask(python, root, extra):
        raise Problem(f"after installing, {python} still lacks {', '.join(missing)}: delete {root / '.venv'}, {AGAIN}")


def _remove(folder):
    """Remove a .venv. Raises Problem if something of it stays."""
    shutil.rmtree(folder, ignore_errors=True)
    if os.path.lexists(folder):
        raise Problem(f"could not remove {folder}: delete it, {AGAIN}")
