"""``bezteach homework``: blank notebooks into a folder, or the teacher's answers."""

import os

from bezteach.setup.progress import Problem, say
from bezteach.setup.writing import removed_if_empty, write

from .homework.notebook import key, notebook
from .homework.sets import SETS
from .homework.student import student_of


def run_homework(arguments):
    """Write the sets, or print the key to one; a ``Problem`` if a file is there already, or there is no such set."""
    student = None if arguments.name is None else _student(arguments.name)
    if arguments.key is not None:
        if arguments.folder is not None:
            raise Problem("--key prints the answers: it goes without a folder")
        if arguments.key not in SETS:
            raise Problem(f"there is no set {arguments.key!r}: take one of {', '.join(SETS)}")
        print(key(arguments.key, student))
        return 0
    if arguments.folder is None:
        raise Problem("name a folder for the notebooks, or a set with --key")
    folder = arguments.folder.expanduser().absolute()
    places = {name: folder / f"{name}.ipynb" for name in SETS}
    if taken := [path for path in places.values() if os.path.lexists(path)]:
        raise Problem(f"{taken[0]} is there already: choose another folder, for answers may be in it")
    with removed_if_empty(folder):
        folder.mkdir(parents=True, exist_ok=True)
        for name, path in places.items():
            write(path, notebook(name, arguments.name).encode())
    say(f"wrote {len(places)} sets of homework to {folder}")
    return 0


def _student(name):
    try:
        return student_of(name)
    except ValueError as problem:
        raise Problem(str(problem)) from None
