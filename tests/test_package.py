"""The package as a whole: what loads when, and which way the arrows between its rooms point."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import bezteach

PACKAGE = Path(bezteach.__file__).parent


def loaded_after(code):
    program = f"import sys; {code}; print(*sorted(sys.modules))"
    done = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True)
    return set(done.stdout.split())


def test_the_bare_package_loads_nothing_but_python():
    assert not loaded_after("import bezteach") & {"numpy", "sympy", "matplotlib", "ipywidgets", "IPython", "nbformat"}


def test_the_numeric_mirror_loads_numpy_alone():
    modules = loaded_after("import bezteach as bz; bz.split([0, 1], 0.5)")
    assert "numpy" in modules
    assert not modules & {"sympy", "matplotlib", "ipywidgets", "IPython"}


def test_the_short_names_are_those_of_the_numeric_mirror():
    from bezteach import numeric

    assert set(bezteach._NUMERIC) == set(numeric.__all__)
    assert all(getattr(bezteach, name) is getattr(numeric, name) for name in numeric.__all__)
    assert {*bezteach.__all__} <= {*dir(bezteach)}
    with pytest.raises(AttributeError, match="module 'bezteach' has no attribute 'splitt'"):
        bezteach.splitt  # noqa: B018


# room: the rooms that it may import from
ARROWS = {
    "numeric": set(),
    "symbolic": set(),
    "parsing": {"symbolic"},
    "proof": {"symbolic"},
    "examples": set(),
    "display": {"symbolic"},
    "questions": {"numeric", "examples"},
    "palette": set(),
    "naming": set(),
    "coverage": {"display", "examples", "setup"},
    "glossary": {"coverage", "display"},
    "figures": {"numeric", "display", "palette", "naming"},
    "bench": {"parsing", "proof"},
    "homework": {"parsing", "proof", "symbolic", "numeric", "examples", "display", "widgets"},
    "ledger": {"proof", "symbolic", "display", "examples"},
    "widgets": {
        "numeric",
        "figures",
        "examples",
        "symbolic",
        "display",
        "questions",
        "palette",
        "naming",
        "bench",
        "parsing",
        "proof",
    },
}


def rooms_imported(path):
    """The rooms of the package that a module imports from, wherever in it the import stands."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            base = path.parent.parts[len(PACKAGE.parts) :][
                : len(path.parent.parts) - len(PACKAGE.parts) - node.level + 1
            ]
            module = [*base, *(node.module or "").split(".")] if node.level else (node.module or "").split(".")[1:]
            if node.level or (node.module or "").split(".")[0] == "bezteach":
                named = [part for part in module if part] or [alias.name for alias in node.names]
                yield named[0]
        elif isinstance(node, ast.Import):
            yield from (alias.name.split(".")[1] for alias in node.names if alias.name.startswith("bezteach."))


@pytest.mark.parametrize("room", ARROWS)
def test_arrows_point_down_only(room):
    files = [PACKAGE / f"{room}.py"] if (PACKAGE / f"{room}.py").is_file() else sorted((PACKAGE / room).glob("**/*.py"))
    assert files
    for path in files:
        assert set(rooms_imported(path)) - {room} <= ARROWS[room], path
