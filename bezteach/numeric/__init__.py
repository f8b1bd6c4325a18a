"""Bernstein polynomials and Bézier curves on arrays: exact numbers in, exact numbers out.

Points are rows: (n+1, d) is a curve, (n+1,) one coordinate, (N, n+1, d) a batch. Every function works on float64, on
ints and Fractions, and on SymPy expressions, and rejects bad input with a ValueError that names it.
"""

from bezteach.numeric import bspline, joins, rational
from bezteach.numeric.basis import bernstein, from_power, to_power
from bezteach.numeric.curve import de_casteljau, elevate, flatten, segment, split, subdivide
from bezteach.numeric.derivatives import curvature, derivative, hodograph
from bezteach.numeric.distance import polygon_gap
from bezteach.numeric.evaluation import evaluate, evaluate_accurate, sample
from bezteach.numeric.fitting import fit
from bezteach.numeric.intersection import box, intersections
from bezteach.numeric.reduction import lower
from bezteach.numeric.roots import roots, sign_changes

__all__ = [
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
]
