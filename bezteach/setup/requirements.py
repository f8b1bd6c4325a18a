"""What a command needs, as pyproject.toml or the installed package declares it, and what of it is lacking."""

import importlib.metadata
import operator
import re
import tomllib
from pathlib import Path

from bezteach.setup.progress import AGAIN, Problem

PACKAGE = Path(__file__).resolve().parents[1]


def checkout(package=PACKAGE):
    """Return the folder with this project's pyproject.toml that the package lies in; None in an installed wheel.

    Raises Problem if there is such a file that cannot be read.
    """
    root = package.parent
    if (root / "pyproject.toml").is_file() and _project(root).get("name") == "bezteach":
        return root
    return None


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
    for part in _parts(match[3]):
        specifier = re.fullmatch(r"(>=|<=|==|!=|>|<)\s*(\d+(?:\.\d+)*)", part)
        if not specifier:
            raise ValueError(f"cannot read {part!r} in requirement {text!r}")
        pairs.append(specifier.groups())
    return match[1].lower(), _parts(match[2] or ""), pairs


def _parts(text):
    return [part.strip() for part in text.split(",") if part.strip()]


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


def lacking(extra, root):
    """Return the requirements of this extra that the running interpreter does not satisfy."""
    result = []
    for requirement in requirements(extra, root):
        name, _, pairs = split_requirement(requirement)
        try:
            version = importlib.metadata.version(name)
        except (importlib.metadata.PackageNotFoundError, KeyError):
            version = None
        # A broken installation has no version, or one that is not a number.
        if not version or not re.match(r"v?\d", version) or not satisfies(version, pairs):
            result.append(requirement)
    return result
