"""One set-up of a checkout at a time."""

import contextlib
import time

from bezteach.setup.processes import WINDOWS
from bezteach.setup.progress import say

if WINDOWS:
    import msvcrt

    def _lock(file):
        # A byte far behind the end: locked bytes cannot be read by others, and they must read the file.
        file.seek(2**30)
        try:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True

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


@contextlib.contextmanager
def alone(root):
    """Wait until no other run sets up this checkout, and keep others out.

    The lock is on pyproject.toml, so no file is left behind, and closing the file gives it back however we end. Where
    the file system knows no locks we go without.
    """
    with open(root / "pyproject.toml", "rb") as file:
        if not _lock(file):
            say("waiting for another bezteach that is setting up this folder")
            while not _lock(file):
                time.sleep(0.2)
        yield
