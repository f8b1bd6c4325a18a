"""What a command needs to run, and how it gets it: the ``.venv`` beside pyproject.toml.

Runs before anything is installed, so it imports the standard library only. The way through it is ``ready``: nothing
happens where nothing is lacking; an installed wheel is told what to install; a checkout gets its ``.venv`` made or
completed, and the command starts again inside it.
"""

import contextlib
import importlib.metadata
import json
import operator
import os
import queue
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
import tomllib
from pathlib import Path

from bezteach.__main__ import NEEDED

PACKAGE = Path(__file__).resolve().parent
WINDOWS = os.name == "nt"
# Lies in a .venv until it is complete, so that one left by a power cut is not taken for a good one.
UNFINISHED = "bezteach-unfinished"
# What ends a program from outside: Ctrl-C, kill, a closed terminal (Windows knows only some).
ENDINGS = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
AGAIN = "then run the command again"


class Problem(Exception):
    """Something the user can put right. Its text is one line that says what is wrong and what to do."""


def say(text):
    """Tell the user what is going on, at once even if the output is a pipe."""
    print(f"bezteach: {text}", flush=True)


# ---------------------------------------------------------------------------------------------------------------------
# What is needed


def checkout(package=PACKAGE):
    """Return the folder with this project's pyproject.toml that the package lies in; None in an installed wheel.

    Raises Problem if there is such a file that cannot be read.
    """
    path = package.parent / "pyproject.toml"
    if not path.is_file():
        return None
    return package.parent if _project(package.parent).get("name") == "bezteach" else None


def _project(root):
    try:
        return tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8")).get("project", {})
    except (OSError, ValueError) as error:
        raise Problem(f"cannot read {root / 'pyproject.toml'} ({error}): put it right, {AGAIN}") from None


def declared(root):
    """Return the requirements as declared: {extra: [requirement]}, the always needed ones under "".

    They come from pyproject.toml in ``root``, or from the installed package's metadata if ``root`` is None.
    """
    if root is not None:
        project = _project(root)
        return {"": project.get("dependencies", []), **project.get("optional-dependencies", {})}
    try:
        lines = importlib.metadata.requires("bezteach") or []
    except importlib.metadata.PackageNotFoundError:
        raise Problem('this copy of bezteach is incomplete: run pip install "bezteach[lab]"') from None
    result = {"": []}
    for line in lines:
        requirement, _, marker = line.partition(";")
        extra = re.fullmatch(r"""\s*extra\s*==\s*['"]([^'"]+)['"]\s*""", marker)
        if marker and not extra:
            raise ValueError(f"requirement {line!r} has a marker other than an extra")
        result.setdefault(extra[1] if extra else "", []).append(requirement.strip())
    return result


def requirements(extra, root):
    """Return every requirement of this extra, ``bezteach[other]`` replaced by what it stands for, each once.

    Raises ValueError if there is no such extra.
    """
    groups, result, seen = declared(root), [], set()
    waiting = ["", extra]
    while waiting:
        group = waiting.pop(0)
        if group not in groups:
            raise ValueError(f"bezteach has no extra {group!r}")
        seen.add(group)
        for requirement in groups[group]:
            name, extras, _ = split_requirement(requirement)
            if name == "bezteach":
                waiting += [other for other in extras if other not in seen]
            elif requirement not in result:
                result.append(requirement)
    return result


_COMPARE = {
    ">=": operator.ge,
    "<=": operator.le,
    "==": operator.eq,
    "!=": operator.ne,
    ">": operator.gt,
    "<": operator.lt,
}


def split_requirement(text):
    """Split a requirement into its name, its extras and its (operator, version) pairs.

    This is the part of the grammar that pyproject.toml uses, no markers, no ``~=``, no wildcards: ValueError otherwise.

    >>> split_requirement("bezteach[lab,test] >= 1.2, < 2")
    ('bezteach', ['lab', 'test'], [('>=', '1.2'), ('<', '2')])
    """
    match = re.fullmatch(r"\s*([A-Za-z0-9][\w.-]*)\s*(?:\[([^\]]*)\])?\s*([^;\[\]]*)", text)
    if not match:
        raise ValueError(f"cannot read requirement {text!r}")
    pairs = []
    for part in filter(None, (part.strip() for part in match[3].split(","))):
        specifier = re.fullmatch(r"(>=|<=|==|!=|>|<)\s*(\d+(?:\.\d+)*)", part)
        if not specifier:
            raise ValueError(f"cannot read {part!r} in requirement {text!r}")
        pairs.append((specifier[1], specifier[2]))
    return match[1].lower(), [extra.strip() for extra in (match[2] or "").split(",") if extra.strip()], pairs


def release(version):
    """Return the release numbers of a version, trailing zeros dropped; a pre-release counts as its release.

    >>> release("3.10.0rc1"), release("2.0") == release("2")
    ((3, 10), True)
    """
    numbers = [int(part) for part in re.match(r"v?(?:\d+!)?(\d+(?:\.\d+)*)", version)[1].split(".")]
    while numbers and numbers[-1] == 0:
        numbers.pop()
    return tuple(numbers)


def satisfies(version, pairs):
    """Tell whether an installed version meets all (operator, version) pairs, compared number by number."""
    return all(_COMPARE[sign](release(version), release(bound)) for sign, bound in pairs)


def lacking(extra, root=None):
    """Return the requirements of this extra that the running interpreter does not satisfy.

    ``root`` is the checkout, looked up if not given.
    """
    result = []
    for requirement in requirements(extra, root or checkout()):
        name, _, pairs = split_requirement(requirement)
        try:
            version = importlib.metadata.version(name)
        except (importlib.metadata.PackageNotFoundError, KeyError):
            version = None
        # A broken installation has no version, or one that is not a number.
        if not version or not re.match(r"v?\d", version) or not satisfies(version, pairs):
            result.append(requirement)
    return result


# ---------------------------------------------------------------------------------------------------------------------
# Processes


def child_environment(root):
    """Return the environment for child processes: the checkout comes first on PYTHONPATH, so they all import it."""
    environment = dict(os.environ)
    if root is not None:
        paths = [str(root), *filter(None, environment.get("PYTHONPATH", "").split(os.pathsep))]
        environment["PYTHONPATH"] = os.pathsep.join(dict.fromkeys(paths))
    return environment


def _pip_environment():
    # Setting them only if they are not set leaves pip to the user: one retry, so that being offline shows at once;
    # no question, because nobody would see it.
    return {"PIP_RETRIES": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_NO_INPUT": "1", **os.environ}


@contextlib.contextmanager
def held_back():
    """Let Ctrl-C and the like wait until the block is done.

    Needed where an interruption would lose a process just started or leave a folder half removed.
    """
    came, before = [], {}
    if threading.current_thread() is threading.main_thread():
        for number in ENDINGS:
            # What is ignored stays ignored: the user asked for it (nohup).
            if signal.getsignal(number) not in (signal.SIG_IGN, None):
                before[number] = signal.signal(number, lambda number, frame: came.append(number))
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    if came:
        signal.raise_signal(came[0])


def start(command, **options):
    """Start a process in a group of its own, so that Ctrl-C reaches only us and ``end`` reaches all that it starts."""
    if WINDOWS:
        options["creationflags"] = subprocess.CREATE_NEW_PROCESS_GROUP
    else:
        options["start_new_session"] = True
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, **options)


def end(process, patience=10.0):
    """End a process of ``start`` if it still runs: politely, and after ``patience`` seconds for certain."""
    if process.poll() is not None:
        return
    for strength in ("SIGTERM", "SIGKILL"):
        with contextlib.suppress(OSError):
            if WINDOWS:
                process.terminate()
            else:
                os.killpg(process.pid, getattr(signal, strength))
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(patience)
            return


def become(command, environment, cwd=None, windows=WINDOWS):
    """Go on as another command, in our terminal; does not return.

    On POSIX this process becomes the other, so signals and the exit code are its own. Windows has no such thing: the
    other runs as a child, and its exit code is passed through.
    """
    command = [str(part) for part in command]
    sys.stdout.flush()
    if windows:
        sys.exit(_attend(command, environment, cwd))
    if cwd is not None:
        os.chdir(cwd)
    os.execve(command[0], command, environment)


def _attend(command, environment, cwd):
    """Run a child until it ends and return its exit code. Ctrl-C reaches it too, and is its to deal with."""
    process = subprocess.Popen(command, env=environment, cwd=cwd)
    while True:
        with contextlib.suppress(KeyboardInterrupt):
            return process.wait()


# ---------------------------------------------------------------------------------------------------------------------
# Saying what goes on


def news(line):
    """Return what a line of pip's output means to a reader: (stage, detail), or None for the rest.

    >>> news("Collecting numpy>=2.0 (from bezteach==0.1.0)")
    ('collecting packages', 'numpy')
    >>> news("Installing collected packages: wheel, numpy")
    ('installing 2 packages', 'wheel, numpy')
    """
    line = line.strip()
    if match := re.match(r"(?:Collecting|Downloading|Using cached) (?:\S*/)?([A-Za-z0-9._]+(?:-[A-Za-z_]+)*)", line):
        return "collecting packages", match[1]
    if line.startswith("Installing collected packages: "):
        names = line.partition(": ")[2]
        return f"installing {len(names.split(','))} packages", names
    if re.match(r"(Installing build dependencies|Preparing|Obtaining|Getting requirements)", line):
        return "preparing", ""
    return None


def teller(stream=None, clock=time.monotonic):
    """Return a function tell(stage, detail) that shows how far a set-up is.

    On a terminal it keeps one line up to date, and ``tell(None)`` clears it; elsewhere every stage is said once.
    """
    stream = sys.stdout if stream is None else stream
    begin, said, terminal = clock(), [""], stream.isatty()

    def tell(stage, detail=""):
        if terminal:
            width = max(shutil.get_terminal_size().columns - 1, 20)
            text = "" if stage is None else f"[{clock() - begin:3.0f} s] {stage}{': ' * bool(detail)}{detail}"
            short = text if len(text) <= width else text[: width - 3] + "..."
            stream.write("\r" + short.ljust(width) + "\r")
        elif stage and stage != said[0]:
            stream.write(f"bezteach: {stage}\n")
        said[0] = stage
        stream.flush()

    return tell


def run(command, root, tell, stage):
    """Run a command quietly, telling how it goes; return (exit code, lines of its output). Interrupted, it is ended."""
    process, lines, coming, detail = None, [], queue.SimpleQueue(), ""

    def read():
        with process.stdout as output:
            for line in output:
                coming.put(line)
        coming.put(None)

    try:
        with held_back():
            process = start(
                command,
                cwd=root,
                env=_pip_environment(),
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                errors="replace",
            )
            reader = threading.Thread(target=read, daemon=True)
            reader.start()
        while True:
            tell(stage, detail)
            try:
                line = coming.get(timeout=1)
            except queue.Empty:
                continue  # nothing new, but the clock on the status line goes on
            if line is None:
                break
            lines.append(line.rstrip())
            stage, detail = news(line) or (stage, detail)
        return process.wait(), lines
    finally:
        if process is not None:
            with held_back():
                end(process)
                reader.join(5)
        tell(None)


_REASONS = (
    (
        r"No space left on device|Errno 28|not enough space|Disk quota",
        f"the disk or the folder for temporary files is full: free about 600 MB, {AGAIN}",
    ),
    (
        r"name resolution|NameResolution|NewConnection|getaddrinfo|[Tt]imed out|Proxy|unreachable|refused|Disconnected",
        f"no connection to the package index: look at the network (or the proxy), {AGAIN}",
    ),
    (
        r"No module named '?pip\b",
        f"the folder .venv has no pip: delete the folder, {AGAIN}",
    ),
    (
        r"Permission denied|Errno 13|Access is denied|Read-only file system",
        "no permission to write there: take a copy of the whole folder to a place of your own, and run it there",
    ),
)


def reason(lines):
    """Say in one line why a command failed, from its output: a reason we know, else its last ERROR line."""
    text = "\n".join(lines)
    for pattern, meaning in _REASONS:
        if re.search(pattern, text):
            return meaning
    errors = [line for line in lines if re.match(r"\s*(ERROR|error|Error)\b", line)]
    last = next((line.strip() for line in reversed(errors or lines) if line.strip()), "no reason was given")
    return re.sub(r"^(ERROR|error|Error): *", "", last)


# ---------------------------------------------------------------------------------------------------------------------
# The .venv


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
        raise Problem(f'something is missing here: run pip install "bezteach[{extra}]", {AGAIN}')
    with alone(root):
        python = set_up(root, extra)
    if not WINDOWS:
        # A Ctrl-C while the other interpreter starts would end in a traceback of Python's own; it waits for main().
        signal.pthread_sigmask(signal.SIG_BLOCK, ENDINGS)
    become([python, "-m", "bezteach", *arguments], child_environment(root))


def set_up(root, extra):
    """Bring the checkout's .venv to where it satisfies the extra, and return its interpreter. Assumes ``alone``."""
    folder = root / ".venv"
    python = interpreter(folder)
    if (folder / UNFINISHED).exists():
        say("an earlier set-up was cut off; starting anew")
        _remove(folder)
    if not os.path.lexists(folder):
        _make(root, folder, extra)
    elif not (folder / "pyvenv.cfg").is_file():
        raise Problem(f"{folder} is in the way, it is no virtual environment: move it elsewhere, {AGAIN}")
    elif not _runs(python):
        say(f"the Python that {folder} was made with is gone; making it anew")
        _can_make()
        _remove(folder)
        _make(root, folder, extra)
    elif missing := _ask(python, root, extra):
        say(f"installing what is new into .venv: {', '.join(missing)}")
        _install(root, python, extra, teller())
    return python


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
    from bezteach.environment import lacking
    answer = lacking(sys.argv[1])
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
            raise Problem(f"could not make {folder}: {_why(lines, root)}")
        _install(root, interpreter(folder), extra, tell)
        (folder / UNFINISHED).unlink()
    except BaseException as error:
        if made:
            with held_back():
                _remove(folder)
        if isinstance(error, OSError):
            raise Problem(f"could not make {folder}: {_why([str(error)], root)}") from None
        raise
    say(f"set up after {time.monotonic() - begin:.0f} s")


def _install(root, python, extra, tell):
    """Install the checkout with its extra, in place. Raises Problem with pip's reason."""
    # --no-user: a setting that is of use outside, and an error inside a virtual environment.
    command = [str(python), "-m", "pip", "install", "--no-user", "-e", f".[{extra}]"]
    code, lines = run(command, root, tell, "preparing")
    if code:
        raise Problem(f"installing failed: {_why(lines, root)}")
    if missing := _ask(python, root, extra):
        raise Problem(f"after installing, {python} still lacks {', '.join(missing)}: delete {root / '.venv'}, {AGAIN}")


def _why(lines, root):
    # Some programs fail on a full disk without saying so.
    with contextlib.suppress(OSError):
        if shutil.disk_usage(root).free < 20_000_000:
            return _REASONS[0][1]
    return reason(lines)


def _remove(folder):
    """Remove a .venv. Raises Problem if something of it stays."""
    shutil.rmtree(folder, ignore_errors=True)
    if os.path.lexists(folder):
        raise Problem(f"could not remove {folder}: delete it, {AGAIN}")


@contextlib.contextmanager
def alone(root):
    """Wait until no other run sets up this checkout, and keep others out.

    The lock is on pyproject.toml, so no file is left behind, and the system gives it back however we end. Where the
    file system knows no locks we go without.
    """
    with open(root / "pyproject.toml", "rb") as file:
        told = False
        while not _lock(file):
            if not told:
                say("waiting for another bezteach that is setting up this folder")
            told = True
            time.sleep(0.2)
        try:
            yield
        finally:
            _unlock(file)


if WINDOWS:
    import msvcrt

    # A byte far behind the end: locked bytes cannot be read by others, and they must read the file.
    _BYTE = 2**30

    def _lock(file):
        file.seek(_BYTE)
        try:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True

    def _unlock(file):
        file.seek(_BYTE)
        msvcrt.locking(file.fileno(), msvcrt.LK_UNLCK, 1)

else:
    import fcntl

    def _lock(file):
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except OSError:
            return True  # no locks on this file system
        return True

    def _unlock(file):
        with contextlib.suppress(OSError):
            fcntl.flock(file, fcntl.LOCK_UN)
