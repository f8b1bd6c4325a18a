"""SymPy derivations: the Bernstein basis, the operator form, and every formula of a Bézier curve with its steps.

The letters i, j, k, n, r (non-negative integers), t, u (real), the shift operator E and the control points b are ready
to import. A derived function returns its result; ``segment.steps(n, j, 0, t)`` gives the lines that lead to it.
B-splines, with symbolic knots, are in ``bspline``.
"""

from . import bspline as bspline
from .basis import B
from .curve import curve, de_casteljau, elevate, segment
from .derivation import Derivation, Step
from .derivative import curvature, derivative, end_curvature, end_derivative, hodograph
from .operator import apply, binomial_theorem, step
from .power import basis_matrix, from_power, power_matrix, to_power
from .printing import latex
from .symbols import E, b, i, j, k, n, r, t, u
from .text import plain, text

__all__ = [
    "B",
    "Derivation",
    "E",
    "Step",
    "apply",
    "b",
    "basis_matrix",
    "binomial_theorem",
    "curvature",
    "curve",
    "de_casteljau",
    "derivative",
    "elevate",
    "end_curvature",
    "end_derivative",
    "from_power",
    "hodograph",
    "i",
    "j",
    "k",
    "latex",
    "n",
    "plain",
    "power_matrix",
    "r",
    "segment",
    "step",
    "t",
    "text",
    "to_power",
    "u",
]
