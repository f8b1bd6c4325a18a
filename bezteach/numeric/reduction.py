"""Down by a degree: the curve of degree n-1 nearest to one of degree n, which is the same one if that can be."""

import operator
from fractions import Fraction
from math import comb

import numpy as np

from bezteach.numeric.arrays import FLOAT, control_points, finish, quiet


@quiet
def lower(points):
    """Control points of the nearest curve of degree n-1: (n+1, d) to (n, d); a batch leads, one coordinate is flat.

    Nearest means: the integral over [0, 1] of the squared distance at equal t is the least. With D = (E - 1)^n b_0, the
    coefficient of t^n, no point is further away than |D| / C(2n,n). If D = 0 it is the same curve.

    >>> lower([0, 2, 3, 3]).astype(str).tolist()
    ['0', '3', '3']
    >>> lower([0, 0, 1]).astype(str).tolist()
    ['-1/6', '5/6']

    Exact points give Fractions. Raises ValueError for points that are no finite real numbers, and for a single point,
    whose degree is 0. It undoes `elevate`; the sources have the way up only (games, "property 6, elevation"). That the
    nearest polygon gives the nearest curve is due to Lutterkort, Peters and Reif (1999).
    """
    points, flat = control_points(points)
    n = points.shape[-2] - 1
    if n == 0:
        raise ValueError("one control point has degree 0: there is no degree below")
    divide = operator.truediv if points.dtype is FLOAT else Fraction
    return finish(lowered(without_top(points, divide), divide), flat)


def without_top(points, divide):
    """The points less the multiple of C(n,0), -C(n,1), C(n,2), ... that makes their n-th difference 0.

    The n-th difference is the product with this row, so what is left is the nearest such polygon. The row is shifted
    Legendre's polynomial in the Bernstein basis, (t(1-t))^n differentiated n times, over n!: it is orthogonal to all of
    lower degree, so what is left is the nearest curve, too.
    """
    n = points.shape[-2] - 1
    row = [(-1) ** i * comb(n, i) for i in range(n + 1)]
    if points.dtype is FLOAT:
        row = [c / comb(n, n // 2) for c in row]  # at most 1: a binomial may be too large for float64
    row = np.array(row, points.dtype)
    return points - row[:, None] * (divide(1, row @ row) * row.dot(points))[..., None, :]


def lowered(points, divide):
    """The same curve in degree n-1, if the n-th difference of the points is 0.

    i c_{i-1} + (n-i) c_i = n b_i, solved from both ends to the middle: so no factor is larger than 1 and none grows.
    """
    *lead, count, d = points.shape
    n = count - 1
    found, middle = np.empty((*lead, n, d), points.dtype), (n + 1) // 2
    for i in range(middle):
        before = found[..., i - 1, :] if i else 0
        found[..., i, :] = divide(n, n - i) * points[..., i, :] - divide(i, n - i) * before
    for i in range(n, middle, -1):
        after = found[..., i, :] if i < n else 0
        found[..., i - 1, :] = divide(n, i) * points[..., i, :] - divide(n - i, i) * after
    return found
