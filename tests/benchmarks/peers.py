"""The other libraries, each tried once: `found` holds those that are here, `missing` says why the others are not."""

from importlib import import_module
from importlib.metadata import PackageNotFoundError, version

MODULES = {  # distribution: module
    "bezier": "bezier",
    "scipy": "scipy.interpolate",
    "geomdl": "geomdl",
    "splines": "splines",
    "splipy": "splipy",
    "splinepy": "splinepy",
    "fonttools": "fontTools.misc.bezierTools",
    "matplotlib": "matplotlib.bezier",
    "kurbopy": "kurbopy",
    "python-flint": "flint",
    "sympy": "sympy",
}


def tried(modules, load=import_module):
    """(found, missing): {distribution: module} and {distribution: why not}."""
    found, missing = {}, {}
    for name, module in modules.items():
        try:
            found[name] = load(module)
        except Exception as problem:  # a compiled module may fail in any way
            missing[name] = f"{type(problem).__name__}: {problem}".splitlines()[0]
    return found, missing


def versions(names):
    """{distribution: version}, "?" where none is recorded."""
    known = {}
    for name in names:
        try:
            known[name] = version(name)
        except PackageNotFoundError:
            known[name] = "?"
    return known


found, missing = tried(MODULES)


def present(contenders):
    """Of {distribution or (distribution, what of it): how to make a callable} the callables of what is here.

    The key (distribution, what) gives the name "distribution what".
    """
    made = {}
    for key, make in contenders.items():
        name, *what = (key,) if isinstance(key, str) else key
        if name in found:
            made[" ".join([name, *what])] = make(found[name])
    return made
