"""How far a control polygon is from its curve."""

from fractions import Fraction

import numpy as np

from bezteach.numeric.arrays import control_points
from bezteach.numeric.evaluation import evaluate


def polygon_gap(points):
    """The largest distance of a control point b_i from the curve's point p(i/n); float64, (N,) for a batch.

    p(i/n) is where b_i has its strongest influence, so this is how far polygon and curve are apart, point by point. It
    is 0 for degrees 0 and 1, and falls by 4 with each halving. ``ValueError`` for bad points and for symbols.
    Source: deck, 1.2, property 9, and 2.3, limit theorem.

    >>> float(polygon_gap([(0, 0), (1, 2), (2, 0)]))
    1.0
    """
    values, _ = control_points(points)
    n = values.shape[-2] - 1
    on_curve = evaluate(values, [Fraction(i, max(n, 1)) for i in range(n + 1)])
    try:
        apart = np.asarray(values - on_curve, dtype=float)
    except TypeError:
        raise ValueError("a distance is a number: the control points must hold no symbols") from None
    return np.hypot.reduce(apart, axis=-1).max(axis=-1)[()]
