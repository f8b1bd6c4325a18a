"""``bezteach export``: a board as one page of HTML that opens from a file, without Python and without a network."""

import os
import re
from fractions import Fraction

from bezteach.examples import EXAMPLES
from bezteach.setup.progress import Problem, say
from bezteach.setup.writing import write
from bezteach.widgets import Board
from bezteach.widgets.board.export import page
from bezteach.widgets.board.state import points_of

ENDINGS = (".html", ".htm")


def run_export(arguments):
    """Write the page of an example and say where it is; a ``Problem`` if there is no such page or no such place."""
    path = arguments.file.absolute()
    board = board_of(arguments.example)
    _look_at(path, arguments.force)
    content = page(board, title_of(arguments.example)).encode()
    try:
        write(path, content)
    except OSError as error:
        raise Problem(f"cannot write {path} ({error.strerror}): choose another place") from None
    say(f"wrote {path} ({len(content) / 1000:.0f} KB): any browser opens it, also without a network")
    return 0


def board_of(name):
    """The board that shows an example: polygon, curve and de Casteljau's levels, at its t or at 1/3."""
    if name not in usable():
        wrong = "has no control points in the plane" if name in EXAMPLES else "is no example"
        raise Problem(f"{name!r} {wrong}: take one of {', '.join(usable())}")
    t = EXAMPLES[name].given.get("t", Fraction(1, 3))
    return Board(_points(EXAMPLES[name]), t=t, show=("polygon", "curve", "levels"))


def usable():
    """The examples with control points in the plane.

    >>> usable()
    ['deck/split', 'deck/segment', 'games/parabola', 'games/quadratic']
    """
    return [name for name, example in EXAMPLES.items() if _points(example)]


def title_of(name):
    """What the page of an example is called: the beginning of what is said about it.

    >>> title_of("deck/split")
    'A cubic split at t = 1/3'
    """
    about = re.split("[:;,]", EXAMPLES[name].about)[0]
    return about[0].upper() + about[1:]


def _points(example):
    """The control points that an example starts from or arrives at; None without such, or if they are no numbers."""
    try:
        return points_of((example.given | example.answer).get("points"))
    except ValueError:
        return None


def _look_at(path, force):
    """Raise ``Problem`` if the page cannot or must not go there."""
    if path.suffix.lower() not in ENDINGS:
        raise Problem(f"{path.name!r} is no name for a page: let it end in .html")
    if path.is_dir():
        raise Problem(f"{path} is a folder: name a file in it")
    if not path.parent.is_dir():
        raise Problem(f"there is no folder {path.parent}: make it, or choose another")
    if os.path.lexists(path) and not force:
        raise Problem(f"{path} is there already: choose another name, or let --force overwrite it")
