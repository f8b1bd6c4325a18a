"""Child processes that import this package, that Ctrl-C does not reach by itself, and that can always be ended."""

import contextlib
import os
import signal
import subprocess
import sys
import threading

WINDOWS = os.name == "nt"
# What ends a program from outside: Ctrl-C, kill, a closed terminal (Windows knows only some).
ENDINGS = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]


def child_environment(root):
    """Return the environment for child processes: the checkout comes first on PYTHONPATH, so they all import it."""
    environment = dict(os.environ)
    if root is not None:
        paths = [str(root), *filter(None, environment.get("PYTHONPATH", "").split(os.pathsep))]
        environment["PYTHONPATH"] = os.pathsep.join(dict.fromkeys(paths))
    return environment


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
    """Go on as another command of ours, in our terminal; does not return.

    On POSIX this process becomes the other, so signals and the exit code are its own. A Ctrl-C while the other
    interpreter starts would end in a traceback of Python's own, so it waits. Windows has no such thing: the other runs
    as a child, and its exit code is passed through.
    """
    command = [str(part) for part in command]
    sys.stdout.flush()
    if windows:
        sys.exit(_attend(command, environment, cwd))
    if cwd is not None:
        os.chdir(cwd)
    with waiting():
        os.execve(command[0], command, environment)


@contextlib.contextmanager
def waiting():
    """Let Ctrl-C and the like wait, also in an interpreter that is started here, until it calls ``let_through``."""
    if not WINDOWS:
        signal.pthread_sigmask(signal.SIG_BLOCK, ENDINGS)
    try:
        yield
    finally:
        let_through()


def let_through():
    """Let Ctrl-C and the like come that were made to wait; here they can be dealt with."""
    if not WINDOWS:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDINGS)


def attend(command, environment, cwd):
    """Run another command of ours until it ends, and return its exit code.

    Ctrl-C is passed on to it alone, and is its to deal with: the processes that it has started do not each have
    something to say about it.
    """
    if WINDOWS:
        return _attend(command, environment, cwd)
    with waiting():
        process = start(command, env=environment, cwd=cwd)
    try:
        while True:
            try:
                return process.wait()
            except KeyboardInterrupt:
                process.send_signal(signal.SIGINT)
    finally:
        with held_back():
            end(process)


def _attend(command, environment, cwd):
    """Run a child until it ends and return its exit code. Ctrl-C reaches it too, and is its to deal with."""
    process = subprocess.Popen(command, env=environment, cwd=cwd)
    while True:
        with contextlib.suppress(KeyboardInterrupt):
            return process.wait()
