"""The user's clock: what one waits for. Fresh interpreters and a board that is moved count in processor time, long
commands, which use all cores, by the clock on the wall.
"""

import os
import resource
import subprocess
import sys
from fractions import Fraction
from itertools import cycle
from time import perf_counter

from bezteach.widgets import Board

from . import peers
from .job import Job, Row
from .measuring import timed

CUBIC = [(0, 0), (1, 3), (2, 1), (3, 3)]
FIGURE = "bezteach.figures.split([(0, 0), (1, 3), (2, 1), (3, 3)], 0.5).savefig(io.BytesIO(), format='png')"
PLAIN = (
    "matplotlib.figure.Figure(); f.subplots().plot([0, 1, 2, 3], [0, 3, 1, 3]); f.savefig(io.BytesIO(), format='png')"
)
CLAIMS = "basis/derivative*"


def jobs(small=False):
    """All jobs by the user's clock that take seconds; small ones do not start an interpreter."""
    yield frame("curve, polygon, point", 0.001, None)
    yield frame("levels, halves, hodograph", None, ("polygon", "curve", "levels", "halves", "hodograph"))
    yield picture()
    if not small:
        yield starting("import bezteach", 1.15, "import bezteach", "import numpy")
        yield starting("import bezteach.numeric", None, "import bezteach.numeric", "import numpy")
        yield starting(
            "first figure", None, f"import io, bezteach.figures; {FIGURE}", f"import io, matplotlib.figure; f = {PLAIN}"
        )
        if "python-flint" in peers.found:
            yield flint()


def children():
    """Seconds of processor time that finished child processes took."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def interpreter(*arguments, **variables):
    """A call that runs a fresh interpreter, and gives its exit code."""
    environment = os.environ | variables
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    return lambda: subprocess.run([sys.executable, *arguments], env=environment, check=False, **quiet).returncode


def succeeded(code):
    """The check of an interpreter."""
    return code == 0


def starting(name, bar, ours, theirs):
    """A fresh interpreter that runs our code, against one that runs the bare minimum."""
    peer = theirs if len(theirs) < 20 else "matplotlib alone"
    return Job(name, bar, interpreter("-c", ours), {peer: interpreter("-c", theirs)}, succeeded, clock=children)


def flint():
    """Some of the ledger proved with SymPy on python-flint, against SymPy on Python's own integers."""
    proving = ("-W", "ignore", "-m", "bezteach", "prove", CLAIMS)
    ours, plain = (interpreter(*proving, SYMPY_GROUND_TYPES=types) for types in ("flint", "python"))
    return Job(f"prove '{CLAIMS}' with flint", None, ours, {"without flint": plain}, succeeded, clock=children)


def frame(shown, bar, layers):
    """What Python computes when a control point of a board is dragged to another place: numbers, words, marks."""
    board = Board(CUBIC, t=Fraction(1, 3), **({} if layers is None else {"show": layers}))
    places = cycle([(1, 3), (Fraction(5, 4), 3)])

    def move():
        board.points = [CUBIC[0], next(places), *CUBIC[2:]]
        return board.answer

    return Job(f"board moved ({shown})", bar, move, {}, lambda answer: bool(answer["text"]), absolute=True)


def picture():
    """The board's picture as SVG, without a browser."""
    board = Board(CUBIC, t=Fraction(1, 3))
    return Job(
        "board's picture as SVG", 0.001, lambda: board.svg, {}, lambda svg: svg.startswith("<svg"), absolute=True
    )


LONG = {  # what runs on its own for minutes, what SymPy computes with there, and the most seconds that it may take
    "whole ledger": (("-m", "bezteach", "prove"), "python", 60),
    "whole ledger on python-flint": (("-W", "ignore", "-m", "bezteach", "prove"), "flint", None),
    "whole test command": (("-m", "bezteach", "test"), "auto", 480),
}


def long_commands():
    """The names of those that can run here: without python-flint, SymPy would take Python's numbers in its place."""
    return [name for name, (_, types, _) in LONG.items() if types != "flint" or "python-flint" in peers.found]


def whole(name):
    """The row of a long command, run once; one that fails is named, and reaches no bar."""
    arguments, types, most = LONG[name]
    run, codes = interpreter(*arguments, SYMPY_GROUND_TYPES=types), []
    times = timed({"ours": lambda: codes.append(run())}, 0, perf_counter)
    if codes != [0]:
        return Row(f"{name} (exit code {codes[0]})", times["ours"])
    return Row(name, times["ours"], bar=most, absolute=True)
