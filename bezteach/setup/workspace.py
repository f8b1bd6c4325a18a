"""The user's folder of lessons: brought up to date without ever touching what the user changed.

A manifest in the folder remembers the identity of every file as it was copied. A file that still has it was not changed
by the user and follows the shipped one; any other is the user's own, and a newer shipped version is placed beside it.
"""

import os
from collections import Counter
from itertools import count
from pathlib import Path
from typing import NamedTuple

from bezteach.setup.manifest import MANIFEST, identity, manifest_text, read_manifest
from bezteach.setup.progress import Problem
from bezteach.setup.requirements import PACKAGE, checkout
from bezteach.setup.writing import removed_if_empty, write

DEFAULT = "bezteach-lessons"


class Step(NamedTuple):
    """What is to be done, or was done, about one shipped file.

    ``path`` is its path below the folder, with slashes. ``action`` is "copy" (it was not there), "update" (the user
    had not changed it), "same" (nothing to do), "keep" (the user changed it, and knows of the shipped version) or
    "beside" (the user changed it, and the newer one goes beside). ``place`` is the path written, "" if none.
    """

    path: str
    action: str
    place: str = ""


def lessons_source(root=None):
    """Return the folder of the shipped lessons: ``lessons`` in a checkout, ``bezteach/_lessons`` in a wheel."""
    root = root or checkout()
    return root / "lessons" if root is not None else PACKAGE / "_lessons"


def folder(chosen=None):
    """Return the absolute path of the user's folder: the chosen one, or the default one in the home folder.

    Raises Problem if there is no home folder.
    """
    try:
        path = Path.home() / DEFAULT if chosen is None else Path(chosen).expanduser()
        return path.resolve()
    except RuntimeError as error:
        # No home folder, or links that lead in a circle.
        raise Problem(f"{error}: choose a folder with --dir") from None


def plan(source, target):
    """Return [(step, what the manifest has to remember of it)] for bringing the shipped files into the target.

    Reads only; both are absolute paths. Raises Problem if it cannot be done: no lessons, a target that is a file, lies
    in the shipped folder or cannot be read or written, or something in the target that stands in the way of a lesson.
    """
    shipped = _shipped(source)
    _look_at_target(source, target)
    manifest = read_manifest(target)
    result = []
    for path in shipped:
        _look_at_place(target, path)
        content = identity(source / path)
        present = _present(target / path)
        known = manifest.get(path, {})
        remembered = {path: {"copied": content}}
        if present is None:
            step = Step(path, "copy", path)
        elif present == content:
            step = Step(path, "same")
        elif present == known.get("copied"):
            step = Step(path, "update", path)
        elif content in (known.get("copied"), known.get("told")):
            step, remembered = Step(path, "keep"), {}
        else:
            step = Step(path, "beside", _place_beside(target, path, content, manifest))
            remembered = {path: {**known, "told": content}, step.place: {"copied": content}}
        manifest.update(remembered)
        result.append((step, remembered))
    return result


def copy_lessons(source, target):
    """Bring the shipped files into the target and return what was done, one Step for each.

    No file that the user changed is written to. Raises Problem as ``plan`` does, before anything is written, or if
    writing fails; then every file is whole, and what was not there before the run or was not reached is as it was.
    """
    steps = plan(source, target)
    before = read_manifest(target)
    manifest, done = dict(before), []
    try:
        with removed_if_empty(target):
            target.mkdir(parents=True, exist_ok=True)
            try:
                for step, remembered in steps:
                    if step.place:
                        place = target / step.place
                        place.parent.mkdir(parents=True, exist_ok=True)
                        write(place, (source / step.path).read_bytes())
                    manifest.update(remembered)
                    done.append(step)
            finally:
                # Cut off half-way, the manifest must still know what was copied.
                if manifest != before:
                    write(target / MANIFEST, manifest_text(manifest).encode())
    except OSError as error:
        what = error.strerror or str(error)
        raise Problem(f"cannot write in {target} ({what}): make room, or choose another folder with --dir") from None
    return done


def summary(steps, target):
    """Return the lines that tell the user what was done."""
    words = {"copy": "copied", "update": "brought up to date", "keep": "yours, left as they are"}
    number = Counter(step.action for step in steps)
    parts = [f"{number[action]} {word}" for action, word in words.items() if number[action]]
    lines = [f"your lessons are in {target}" + (f" ({', '.join(parts)})" if parts else "")]
    for step in steps:
        if step.action == "beside":
            lines.append(f"{step.path}: you changed it, so the new version is beside it as {step.place}")
    return lines


def written(steps, target):
    """Return the paths of the notebooks that were written."""
    return [target / step.place for step in steps if step.place.endswith(".ipynb")]


def _shipped(source):
    """Return the relative paths of the shipped files, sorted: no caches, no checkpoints, nothing hidden."""
    if not source.is_dir():
        raise Problem(f"the lessons are missing ({source}): clone or install bezteach again")
    files = [path.relative_to(source) for path in source.rglob("*") if path.is_file()]
    shown = [path for path in files if not any(part.startswith(".") or part == "__pycache__" for part in path.parts)]
    if not shown:
        raise Problem(f"there are no lessons in {source}: clone or install bezteach again")
    return sorted(path.as_posix() for path in shown)


def _look_at_target(source, target):
    """Raise Problem if the target is no place for lessons."""
    source = source.resolve()
    if target == source or source in target.parents:
        raise Problem(f"{target} belongs to the project itself: choose another folder with --dir")
    place = next(place for place in (target, *target.parents) if os.path.lexists(place))
    if not place.is_dir():
        raise Problem(f"{place} is not a folder: choose another with --dir")
    if not os.access(place, os.R_OK | os.W_OK | os.X_OK):
        raise Problem(f"no permission to write in {place}: choose another folder with --dir")


def _look_at_place(target, path):
    """Raise Problem if a shipped file's place is a folder, or lies behind a file or a link out of the target."""
    place = target / path
    if _is_obstacle(place):
        raise Problem(f"{place} is no file, and a lesson has that name: move it elsewhere")
    for parent in list(place.parents)[: len(Path(path).parts) - 1]:
        if os.path.lexists(parent) and (not parent.is_dir() or not parent.resolve().is_relative_to(target)):
            raise Problem(f"{parent} is in the way, lessons need a folder of that name: move it elsewhere")


def _is_obstacle(path):
    return os.path.lexists(path) and not path.is_symlink() and not path.is_file()


def _present(path):
    """Return the identity of what is there, None if nothing is; a link is the user's own, like nothing shipped."""
    if path.is_symlink():
        return "link"
    return identity(path) if path.exists() else None


def _place_beside(target, path, content, manifest):
    """Return the first of "x (new).ipynb", "x (new 2).ipynb" ... that holds nothing the user changed."""
    pure = Path(path)
    for number in count(1):
        mark = "(new)" if number == 1 else f"(new {number})"
        place = pure.with_name(f"{pure.stem} {mark}{pure.suffix}").as_posix()
        if _is_obstacle(target / place):
            continue
        present = _present(target / place)
        if present in (None, content) or present == manifest.get(place, {}).get("copied"):
            return place
