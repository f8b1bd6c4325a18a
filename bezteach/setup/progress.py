"""What the user is told: how far a command is, in place of pip's many lines, and why it failed, in one line."""

import contextlib
import os
import queue
import re
import shutil
import subprocess
import sys
import threading
import time

from bezteach.setup.processes import end, held_back, start

AGAIN = "then run the command again"


class Problem(Exception):
    """Something the user can put right. Its text is one line that says what is wrong and what to do."""


def say(text):
    """Tell the user what is going on, at once even if the output is a pipe."""
    print(f"bezteach: {text}", flush=True)


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
    begin, said, terminal = clock(), None, stream.isatty()

    def tell(stage, detail=""):
        nonlocal said
        if terminal:
            width = max(shutil.get_terminal_size().columns - 1, 20)
            text = "" if stage is None else f"[{clock() - begin:3.0f} s] {stage}{': ' * bool(detail)}{detail}"
            short = text if len(text) <= width else text[: width - 3] + "..."
            stream.write("\r" + short.ljust(width) + "\r")
        elif stage and stage != said:
            stream.write(f"bezteach: {stage}\n")
        said = stage
        stream.flush()

    return tell


def run(command, root, tell, stage):
    """Run a command quietly, telling how it goes; return (exit code, lines of its output). Interrupted, it is ended."""
    process, lines, coming, detail = None, [], queue.SimpleQueue(), ""
    # Only where they are not set, so that pip stays the user's: one retry, so that being offline shows at once; no
    # question, because nobody would see it.
    pips = {"PIP_RETRIES": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_NO_INPUT": "1"}

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
                env={**pips, **os.environ},
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


_FULL = f"the disk or the folder for temporary files is full: free about 600 MB, {AGAIN}"
_REASONS = {
    r"No space left on device|Errno 28|not enough space|Disk quota": _FULL,
    r"name resolution|NameResolution|NewConnection|getaddrinfo|[Tt]imed out|Proxy|unreachable|refused|Disconnected": (
        f"no connection to the package index: look at the network (or the proxy), {AGAIN}"
    ),
    r"No module named '?pip\b": f"the folder .venv has no pip: delete the folder, {AGAIN}",
    r"Permission denied|Errno 13|Access is denied|Read-only file system": (
        "no permission to write there: take a copy of the whole folder to a place of your own, and run it there"
    ),
}


def reason(lines, folder=None):
    """Say in one line why a command failed, from its output: a reason we know, else its last ERROR line.

    ``folder`` is where it wrote: some programs fail on a full disk without saying so.
    """
    if folder is not None:
        with contextlib.suppress(OSError):
            if shutil.disk_usage(folder).free < 20_000_000:
                return _FULL
    text = "\n".join(lines)
    for pattern, meaning in _REASONS.items():
        if re.search(pattern, text):
            return meaning
    errors = [line for line in lines if re.match(r"\s*(ERROR|error|Error)\b", line)]
    last = next((line.strip() for line in reversed(errors or lines) if line.strip()), "no reason was given")
    return re.sub(r"^(ERROR|error|Error): *", "", last)
