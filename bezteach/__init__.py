"""bezteach: Bernstein polynomials, Bézier curves and B-splines, taught with exact numbers and checked proofs.

The numeric mirror is at hand as ``bz.split(...)``, the rest as ``bz.symbolic``, ``bz.examples`` and so on. Nothing is
loaded before it is used, so the bare package imports with nothing but Python and can set itself up.
"""

from importlib import import_module

__version__ = "0.1.0"

_MODULES = (
    "bench",
    "display",
    "examples",
    "figures",
    "ledger",
    "numeric",
    "parsing",
    "proof",
    "questions",
    "symbolic",
    "widgets",
)
_NUMERIC = (
    "bernstein",
    "box",
    "bspline",
    "curvature",
    "de_casteljau",
    "derivative",
    "elevate",
    "evaluate",
    "evaluate_accurate",
    "fit",
    "flatten",
    "from_power",
    "hodograph",
    "intersections",
    "joins",
    "lower",
    "polygon_gap",
    "rational",
    "roots",
    "sample",
    "segment",
    "sign_changes",
    "split",
    "subdivide",
    "to_power",
)
__all__ = [*_MODULES, *_NUMERIC, "__version__"]


def __getattr__(name):
    if name in _MODULES:
        return import_module(f"bezteach.{name}")
    if name in _NUMERIC:
        globals()[name] = found = getattr(import_module("bezteach.numeric"), name)  # once: this way takes microseconds
        return found
    raise AttributeError(f"module 'bezteach' has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *__all__})
