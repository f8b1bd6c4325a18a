"""Bézier curves: de Casteljau's algorithm, the parts of a curve, degree elevation, polylines.

Whatever is linear in the points is a matrix whose rows are polynomials in the shift operator E, times the points.
"""

from fractions import Fraction
from math import ceil, inf, isfinite, sqrt

import numpy as np

from bezteach.numeric import basis
from bezteach.numeric.arrays import (
    FLOAT,
    MOST,
    control_points,
    drop,
    finish,
    one_arithmetic,
    parameter,
    plain,
    quiet,
    read,
    shown,
    whole,
)
from bezteach.numeric.evaluation import sample
from bezteach.numeric.exact import all_rational, integer_triangle, over


@quiet
def de_casteljau(points, t):
    """The levels of de Casteljau's triangle at one t, a tuple of n+1 arrays: level k has shape (n+1-k, d).

    b_j^k = (1-t) b_j^{k-1} + t b_{j+1}^{k-1}; level 0 is the control points, level n the point p(t).

    >>> from fractions import Fraction
    >>> for level in de_casteljau([[0, 0], [1, 3], [2, 1], [3, 3]], Fraction(1, 3)):
    ...     print(*("({}, {})".format(*b) for b in level))
    (0, 0) (1, 3) (2, 1) (3, 3)
    (1/3, 1) (4/3, 7/3) (7/3, 5/3)
    (2/3, 13/9) (5/3, 19/9)
    (1, 5/3)

    Outside [0, 1] the averages extrapolate. Raises ValueError for points that are no finite real numbers and a t that
    is no single one. Source: deck, section 2.1, de Casteljau algorithm; games; notes, section 2.2.
    """
    points, flat = control_points(points)
    points, t = one_arithmetic(points, parameter(t))
    t = t[()]
    if all_rational(points, t):
        levels = [points.copy(), *(over(*pair) for pair in integer_triangle(points, t)[1:])]
    else:
        levels = triangle(points.copy(), t)
    return tuple(finish(level, flat) for level in levels)


def triangle(points, t):
    """The levels of de_casteljau(points, t) without the checks, the first one the points themselves."""
    levels = [points]
    for _ in range(points.shape[-2] - 1):
        points = (1 - t) * points[..., :-1, :] + t * points[..., 1:, :]
        levels.append(points)
    return levels


@quiet
def segment(points, a, b):
    """Control points of the part over [a, b], in the shape of the points.

    c_j = g(a)^(n-j) g(b)^j b_0: n-j steps of de Casteljau's algorithm at a and j steps at b. With a > b the part runs
    backwards, with a = b it is a point.

    >>> from fractions import Fraction
    >>> part = segment([[-9, 0], [-3, 6], [3, 6], [9, 0]], Fraction(1, 4), Fraction(3, 4))
    >>> part.astype(str).tolist()
    [['-9/2', '27/8'], ['-3/2', '39/8'], ['3/2', '39/8'], ['9/2', '27/8']]

    Raises ValueError for points that are no finite real numbers, and for an a or b that is no single one.
    Source: deck, section 2.3, splitting between two parameters.
    """
    points, flat = control_points(points)
    points, a, b = one_arithmetic(points, parameter(a, "a"), parameter(b, "b"))
    return finish(act(basis.segment_rows(points.shape[-2] - 1, a, b), points), flat)


@quiet
def split(points, t):
    """(left, right): control points of the parts over [0, t] and [t, 1], each in the shape of the points.

    >>> from fractions import Fraction
    >>> left, right = split([[0, 0], [1, 3], [2, 1], [3, 3]], Fraction(1, 3))
    >>> left.astype(str).tolist()
    [['0', '0'], ['1/3', '1'], ['2/3', '13/9'], ['1', '5/3']]
    >>> right.astype(str).tolist()
    [['1', '5/3'], ['5/3', '19/9'], ['7/3', '5/3'], ['3', '3']]

    The point p(t) is the same number for number in both. Raises ValueError for points that are no finite real
    numbers and a t that is no single one. Source: deck, section 2.3, splitting theorem; notes, section 2.3.4.
    """
    points, flat = control_points(points)
    points, t = one_arithmetic(points, parameter(t))
    both = finish(halves(points, t))
    return drop(both[..., 0, :, :], flat), drop(both[..., 1, :, :], flat)


def halves(points, t):
    """Both parts of split(points, t), without the checks: shape (..., 2, n+1, d)."""
    *lead, count, d = points.shape
    if all_rational(points, t[()]):
        levels = integer_triangle(points, t[()])
        return sides(levels, lambda pair, at: over(pair[0][..., at, :], pair[1]))
    if points.dtype is not FLOAT:
        rows = basis.segment_rows(count - 1, np.stack([np.zeros_like(t), t]), np.stack([t, np.ones_like(t)]))
        return act(rows.reshape(-1, count), points).reshape(*lead, 2, count, d)
    if not lead:
        return sides(triangle(points, t), lambda level, at: level[at])
    rows = sides(triangle(np.eye(count), t), lambda level, at: level[at])
    both = act(rows.reshape(-1, count), points).reshape(*lead, 2, count, d)
    for c in range(d):  # p(t) comes out equal but for the order in which a product adds up; all d at once takes longer
        both[..., 1, 0, c] = both[..., 0, -1, c]
    return both


def sides(levels, point):
    """The two sides of a triangle, downwards and upwards, where ``point(level, 0)`` is a level's first, -1 its last."""
    first, last = [point(level, 0) for level in levels], [point(level, -1) for level in levels[::-1]]
    return np.stack([np.stack(first, axis=-2), np.stack(last, axis=-2)], axis=-3)


def act(rows, points):
    """Rows of coefficients of E^0, ..., E^n times the points of each curve."""
    if points.ndim == 2:
        return rows.dot(points)  # half the cost of a call of matmul
    if points.dtype is not FLOAT or points[0].size > 64:
        return rows @ points
    # one product for the whole batch is many times quicker than one small product per curve
    count, _, d = points.shape
    return basis.product(points.reshape(count, -1), np.kron(rows.T, np.eye(d))).reshape(count, -1, d)


@quiet
def subdivide(points, depth):
    """The 2**depth parts over equal intervals, in order: shape (2**depth, n+1, d), for a batch (N, 2**depth, n+1, d).

    Every part is split at 1/2, depth times; the polygons of the parts tend to the curve.

    >>> subdivide([0, 4, 0], 1).astype(str).tolist()
    [['0', '2', '2'], ['2', '2', '0']]

    Exact points give Fractions. Raises ValueError for points that are no finite real numbers and a depth that is no
    whole number, negative, or asks for more than 10^8 points. Source: deck, section 2.3, limit theorem.
    """
    points, flat = control_points(points)
    depth = whole(depth, "depth", 0, (MOST // points.size).bit_length())
    *lead, count, d = points.shape
    half = np.array(0.5 if points.dtype is FLOAT else Fraction(1, 2))
    parts = points.reshape(-1, count, d).copy()
    for _ in range(depth):
        parts = halves(parts, half).reshape(-1, count, d)
    return finish(parts.reshape(*lead, 2**depth, count, d), flat)


def elevate(points, r=1):
    """Control points of the same curve in degree n+r: shape (n+r+1, d).

    Row j of the matrix has C(n,i) C(r,j-i) / C(n+r,j) in column i; for r = 1 that is b_j - j/(n+1) (b_j - b_{j-1}).

    >>> elevate([0, 3, 3]).astype(str).tolist()
    ['0', '2', '3', '3']

    Exact points give Fractions. Raises ValueError for points that are no finite real numbers, an r that is no whole
    number or negative, and where rounding leads beyond the largest float64. Source: games, "property 6,
    elevation"; notes, section 2.3.3.
    """
    r = whole(r, "order r", 0)
    if plain(points, 2) and isfinite(np.vdot(points, points)):  # no average of these is too large
        return basis.elevation(len(points) - 1, r).dot(points)
    points, flat = control_points(points)
    rows = basis.elevation(points.shape[-2] - 1, r, points.dtype)
    return finish(quiet(act)(rows, points), flat)


@quiet
def flatten(points, tolerance):
    """A polyline within the tolerance of the curve: points at equal steps of t, the first b_0 and the last b_n.

    Wang's bound: N steps stay within n(n-1)/8 max|b_{i+2} - 2 b_{i+1} + b_i| / N^2. In a batch all curves get the N
    of the one that needs most.

    >>> flatten([[0, 0], [2, 4], [4, 0]], 0.5).tolist()
    [[0.0, 0.0], [2.0, 2.0], [4.0, 0.0]]

    Exact points with an exact tolerance give exact points, a float makes float64. Raises ValueError for points that are
    no finite real numbers, a tolerance that is not positive, symbols, and where more than 10^8 points would be needed.
    Source: notes, section 2.3.4, subdivision; the bound is Wang's.
    """
    points, flat = control_points(points)
    allowed = read(tolerance, "tolerance")
    if allowed.ndim or not getattr(allowed[()], "is_number", True) or not allowed[()] > 0:
        raise ValueError(f"tolerance is {shown(tolerance)}: a positive number is needed")
    symbols = [x for x in points.flat if not getattr(x, "is_number", True)]
    if symbols:
        raise ValueError(f"control points hold {shown(symbols[0])}: only numbers can be flattened")
    points, allowed = one_arithmetic(points, allowed)
    n = points.shape[-2] - 1
    bends = np.diff(points, 2, axis=-2) * (1 / (allowed if points.dtype is FLOAT else Fraction(1) * allowed))
    try:
        worst = max(map(float, (bends * bends).sum(axis=-1).flat), default=0.0)
    except OverflowError:
        worst = inf
    steps = sqrt(n * (n - 1) / 8 * sqrt(worst))
    if not steps < MOST:
        raise ValueError(f"tolerance {shown(tolerance)} would take more than {MOST} points")
    return sample(points[..., 0] if flat else points, max(1, ceil(steps)) + 1)
