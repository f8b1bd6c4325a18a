"""Rational Bézier curves: each control point has a weight. Exact numbers in, exact numbers out.

A control point b with the weight w is the point (w b, w), one dimension higher. There the curve is a polynomial one,
and every algorithm for such curves serves; the division by the last coordinate brings it back.

Weights are finite real numbers. Positive ones are the rule; 0 and negative ones are let through, because a curve may
have them, but where the weights' own polynomial is 0 there is no point, and that is an error.
"""

from fractions import Fraction

import numpy as np

from bezteach.numeric.arrays import FLOAT, control_points, finish, one_arithmetic, quiet, read
from bezteach.numeric.evaluation import evaluate as polynomial
from bezteach.numeric.exact import exact, is_zero, tidy


@quiet
def lift(points, weights):
    """The points (w_i b_i, w_i): shape (n+1, d+1) for control points of shape (n+1, d), (n+1, 2) for (n+1,).

    >>> lift([(1, 0), (1, 1), (0, 1)], [1, 1, 2]).tolist()
    [[1, 0, 1], [1, 1, 1], [0, 2, 2]]

    Raises ValueError for points and weights that are no finite real numbers, and unless there is one weight for each
    control point. Source: Farin, Curves and Surfaces for CAGD, "Rational Bézier and B-spline Curves".
    """
    points, _ = control_points(points)
    weights = read(weights, "weight w")
    if points.ndim != 2 or weights.ndim != 1:
        raise ValueError("one curve and one list of weights are needed, no batch")
    if len(weights) != len(points):
        raise ValueError(f"{len(points)} control points and {len(weights)} weights: each point needs one weight")
    points, weights = one_arithmetic(points, weights)
    return finish(np.column_stack([weights[:, None] * points, weights]))


@quiet
def project(lifted):
    """The points (x, y, ...) / w of (x, y, ..., w), shape (..., d+1): shape (..., d), seen from the origin on w = 1.

    >>> project([(Fraction(3, 4), 1, Fraction(5, 4)), (0, 2, 2)]).astype(str).tolist()
    [['3/5', '4/5'], ['0', '1']]

    Raises ValueError for numbers that are not finite or not real, for points without a coordinate beside w, and names
    the first point with w = 0.
    """
    lifted = read(lifted, "lifted point")
    if not lifted.ndim or lifted.shape[-1] < 2:
        raise ValueError("a lifted point needs a coordinate before its last one, w")
    below = lifted[..., -1:] if lifted.dtype is FLOAT else exact(lifted[..., -1:])
    missing = [number for number, w in enumerate(below.ravel().tolist()) if is_zero(w)]
    if missing:
        raise ValueError(f"lifted point {missing[0]} has w = 0: it lies in no ray that meets w = 1")
    return finish(tidy(lifted[..., :-1] / below) if lifted.dtype is not FLOAT else lifted[..., :-1] / below)


def evaluate(points, weights, t):
    """Points sum of w_i B_{i,n}(t) b_i / sum of w_i B_{i,n}(t): shape t.shape + (d,), t.shape for points (n+1,).

    >>> evaluate([(1, 0), (1, 1), (0, 1)], [1, 1, 2], Fraction(1, 2)).astype(str).tolist()
    ['3/5', '4/5']

    Raises ValueError as `lift` does, for a t that is no finite real number, and names the first t at which the weights
    sum to 0. Source: Piegl, Tiller, The NURBS Book, section 1.4.
    """
    flat = np.ndim(points) == 1
    above, t = one_arithmetic(lift(points, weights), read(t, "parameter t"))
    values = polynomial(above, t)
    for at, w in zip(t.ravel().tolist(), values[..., -1].ravel().tolist(), strict=True):
        if is_zero(w):
            raise ValueError(f"at t = {at} the weights times the basis sum to 0: there is no point")
    found = project(values)
    return found[..., 0][()] if flat else found


def on_unit_circle(points, weights):
    """Whether every point of the curve in the plane lies on x^2 + y^2 = 1; exact for exact numbers.

    With X, Y, W above the plane, X^2 + Y^2 - W^2 has the degree 2n at most: it is 0 if it is 0 at 2n + 1 places.

    >>> on_unit_circle([(1, 0), (1, 1), (0, 1)], [1, 1, 2]), on_unit_circle([(1, 0), (1, 1), (0, 1)], [1, 1, 1])
    (True, False)

    Raises ValueError as `lift` does, and for points that are not in a plane.
    """
    above = lift(points, weights)
    if above.shape[1] != 3:
        raise ValueError(f"the control points have {above.shape[1] - 1} coordinates: a circle needs 2")
    places = 2 * len(above) - 1
    x, y, w = polynomial(above, [Fraction(k, places) for k in range(places)]).T
    return all(is_zero(value) for value in exact(x * x + y * y - w * w))
