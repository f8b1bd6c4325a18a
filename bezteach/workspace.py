"""The user's folder of lessons: brought up to date without ever touching what the user changed.

A manifest in the folder remembers the hash of every file as it was copied. A file that still has it was not changed
by the user and follows the shipped one; any other is the user's own, and a newer shipped version is placed beside it.
"""

import contextlib
import hashlib
import json
import os
from itertools import count
from pathlib import Path
from typing import NamedTuple

from bezteach.environment import PACKAGE, Problem, checkout

MANIFEST = ".bezteach.json"
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
    """Return (steps, manifest as it will be) for bringing the shipped files into the target. Reads only.

    Both are absolute paths. Raises Problem if it cannot be done: no lessons, a target that is a file, lies in the
    shipped folder or cannot be read or written, or something in the target that stands in the way of a lesson.
    """
    shipped = _shipped(source)
    _look_at_target(source, target)
    manifest = _read_manifest(target)
    steps = []
    for path in shipped:
        _look_at_place(target, path)
        content = _hash(source / path)
        present = _present(target / path)
        known = manifest.get(path, {})
        if present is None:
            step = Step(path, "copy", path)
        elif present == content:
            step = Step(path, "same")
        elif present == known.get("copied"):
            step = Step(path, "update", path)
        elif content in (known.get("copied"), known.get("told")):
            step = Step(path, "keep")
        else:
            step = Step(path, "beside", _place_beside(target, path, content, manifest))
        if step.action in ("copy", "same", "update"):
            manifest[path] = {"copied": content}
        elif step.action == "beside":
            manifest[path] = {**known, "told": content}
            manifest[step.place] = {"copied": content}
        steps.append(step)
    return steps, manifest


def copy_lessons(source, target):
    """Bring the shipped files into the target and return what was done, one Step for each.

    No file that the user changed is written to. Raises Problem as ``plan`` does, before anything is written, or if
    writing fails; then every file is whole, and what was not there before the run or was not reached is as it was.
    """
    steps, manifest = plan(source, target)
    before = _read_manifest(target)
    done = []
    try:
        with _removed_if_empty(target):
            target.mkdir(parents=True, exist_ok=True)
            try:
                for step in steps:
                    if step.place:
                        place = target / step.place
                        place.parent.mkdir(parents=True, exist_ok=True)
                        _write(place, (source / step.path).read_bytes())
                    done.append(step)
            finally:
                # Cut off half-way, the manifest must still know what was copied.
                reached = {name for step in done for name in (step.path, step.place) if name}
                result = {**before, **{name: manifest[name] for name in reached if name in manifest}}
                if result != before:
                    _write(target / MANIFEST, _manifest_text(result).encode())
    except OSError as error:
        what = error.strerror or str(error)
        raise Problem(f"cannot write in {target} ({what}): make room, or choose another folder with --dir") from None
    return done


def summary(steps, target):
    """Return the lines that tell the user what was done."""
    number = {action: sum(step.action == action for step in steps) for action in ("copy", "update", "keep", "beside")}
    parts = [
        f"{number[action]} {word}"
        for action, word in (
            ("copy", "copied"),
            ("update", "brought up to date"),
            ("keep", "yours, left as they are"),
        )
        if number[action]
    ]
    lines = [f"your lessons are in {target}" + (f" ({', '.join(parts)})" if parts else "")]
    for step in steps:
        if step.action == "beside":
            lines.append(f"{step.path}: you changed it, so the new version is beside it as {step.place}")
    return lines


def written(steps, target):
    """Return the paths of the notebooks that were written."""
    return [target / step.place for step in steps if step.place.endswith(".ipynb")]


def sign(paths):
    """Sign notebooks as ours, so that their stored pictures show; return "" or why it failed.

    Needs nbformat. Never raises: an unsigned lesson lacks some pictures until a cell is run, no more.
    """
    if not paths:
        return ""
    try:
        import logging

        import nbformat
        from nbformat.sign import NotebookNotary

        # Of several lines about the database one of ours is enough.
        logging.disable()
        try:
            notary = NotebookNotary()
            try:
                for path in paths:
                    notary.sign(nbformat.read(path, as_version=4))
                # If the database on the disk does not work the notary takes one in memory, without an error.
                lost = getattr(notary.store, "db_file", None) == ":memory:" != notary.db_file
            finally:
                notary.store.close()
        finally:
            logging.disable(logging.NOTSET)
    except Exception as error:  # nothing that happens here is worth losing the lab
        return " ".join(str(error).split())[:200] or type(error).__name__
    return "the database of signatures cannot be written" if lost else ""


# ---------------------------------------------------------------------------------------------------------------------


def _shipped(source):
    """Return the relative paths of the shipped files, sorted: no caches, no checkpoints, nothing hidden."""
    if not source.is_dir():
        raise Problem(f"the lessons are missing ({source}): clone or install bezteach again")
    paths = []
    for path in source.rglob("*"):
        relative = path.relative_to(source)
        if path.is_file() and not any(part.startswith(".") or part == "__pycache__" for part in relative.parts):
            paths.append(relative.as_posix())
    if not paths:
        raise Problem(f"there are no lessons in {source}: clone or install bezteach again")
    return sorted(paths)


def _look_at_target(source, target):
    """Raise Problem if the target is no place for lessons."""
    source = source.resolve()
    if target == source or source in target.parents:
        raise Problem(f"{target} belongs to the project itself: choose another folder with --dir")
    for place in (target, *target.parents):
        if os.path.lexists(place):
            break
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
    """Return the hash of what is there, None if nothing is; a link is the user's own, and its hash is no hash."""
    if path.is_symlink():
        return "link"
    return _hash(path) if path.exists() else None


def _hash(path):
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as error:
        raise Problem(f"cannot read {path} ({error.strerror}): put it right, or choose another folder") from None


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


def _read_manifest(target):
    """Return {path: {"copied": hash, "told": hash}}; empty if the file is missing or is not what we write."""
    try:
        files = json.loads((target / MANIFEST).read_text(encoding="utf-8"))["files"]
        if all(isinstance(hashes, dict) for hashes in files.values()):
            return files
    except FileNotFoundError:
        pass
    except OSError as error:
        raise Problem(f"cannot read {target / MANIFEST} ({error.strerror}): delete it") from None
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        pass
    return {}


def _manifest_text(files):
    note = "bezteach keeps here which lessons it copied, so that it never overwrites one you changed."
    return json.dumps({"note": note, "files": files}, indent=1, sort_keys=True) + "\n"


def _write(path, content):
    """Write a file so that it is whole or not there: beside it first, then in one move."""
    draft = path.with_name(f".bezteach-{os.getpid()}.part")
    try:
        draft.write_bytes(content)
        os.replace(draft, path)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


@contextlib.contextmanager
def _removed_if_empty(target):
    """If the block fails, remove the folders it made and put nothing into."""
    new = [place for place in (target, *target.parents) if not os.path.lexists(place)]
    try:
        yield
    except BaseException:
        for place in new:
            with contextlib.suppress(OSError):
                place.rmdir()
        raise
