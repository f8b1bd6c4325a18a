"""Points of a curve at many parameters: by the basis, by a cached basis, and with almost no error.

In float64 there are faster ways than the definition. There the coordinates lie in rows, (d, n+1) or "planar", because
a product of few rows with many columns is the quick one, and results are its transposed view.
"""

from fractions import Fraction
from functools import lru_cache
from math import isqrt

import numpy as np

from bezteach.numeric.arrays import (
    FLOAT,
    control_points,
    drop,
    finish,
    is_finite,
    one_arithmetic,
    quiet,
    read,
    shown,
    whole,
)
from bezteach.numeric.basis import (
    HIGHEST,
    SINGLE,
    basis,
    binomials,
    elevation,
    fill_products,
    frozen,
    product,
    products,
    segment_rows,
)

BLOCK = 16384  # parameters at a time, so that the scratch arrays stay in the processor's cache
FEW = 512  # numbers in the basis below which the count of calls decides
CACHED = 2**17  # numbers in a cached basis: at most 1 MB each
PIECE = 4096  # steps in one of the pieces of a large sample


@quiet
def evaluate(points, t):
    """Points p(t) = sum of B_{i,n}(t) b_i of the curve: shape t.shape + (d,), for a batch (N,) + t.shape + (d,).

    >>> from fractions import Fraction
    >>> evaluate([[0, 0], [1, 3], [2, 1], [3, 3]], Fraction(1, 3)).astype(str).tolist()
    ['1', '5/3']
    >>> evaluate([[0, 0], [1, 3], [2, 1], [3, 3]], [0, 0.5, 1]).tolist()
    [[0.0, 0.0], [1.5, 1.875], [3.0, 3.0]]

    A t outside [0, 1] extrapolates. In float64 the ends are met exactly, and in [0, 1] the error is at most
    1.5 n u max|b| (or 4u max|b| if that is more), u = 2^-53. Raises ValueError for points or t that are no finite real
    numbers, and where p(t) is too large for float64. Source: deck, section 1.1, Bernstein form.
    """
    points, flat = control_points(points)
    points, t = one_arithmetic(points, read(t, "parameter t"))
    return drop(values_at(points, t), flat)


def values_at(points, t):
    """evaluate(points, t) without the checks, in the arithmetic of both."""
    *lead, count, d = points.shape
    if points.dtype is not FLOAT:
        values = basis(count - 1, t.ravel()) @ points
    else:
        planar = points.mT.reshape(-1, count)
        values = planar_values(planar, t.ravel())
        if not is_finite(values):  # too large in between: the averages need no more than the points
            values = finish(averages(planar, t.ravel()))
        values = values.reshape(*lead, d, t.size).mT
    return values if t.ndim == 1 else values.reshape(*lead, *t.shape, d)


def planar_values(planar, t):
    """Values (rows, m) of the polynomials with these rows of Bernstein coefficients.

    For many parameters t^i (1-t)^(n-i) is split into one of q small factors and one of p giant ones, where p q = n+1:
    q + p products make all n+1. There is no division and no branch, and the ends are exact.
    """
    rows, count = planar.shape
    if count - 1 > HIGHEST:
        return averages(planar, t)
    if t.size * count <= FEW:
        return (planar * binomials(count - 1)).dot(products(count - 1, t))
    q = count if count <= 4 or rows > 8 else isqrt(count - 1) + 1
    p = -(-count // q)
    raised = planar.dot(elevation(count - 1, p * q - count).T) if p * q > count else planar
    coefficients = (raised * binomials(p * q - 1)).reshape(rows * p, q)
    values, block = np.empty((rows, t.size)), max(1024, min(BLOCK, t.size, SINGLE // coefficients.size))
    scratch = np.empty((1 + q + p + (p > 1) * rows * p, block))
    for start in range(0, t.size, block):
        here, into = t[start : start + block], values[:, start : start + block]
        u, small = scratch[0, : here.size], scratch[1 : 1 + q, : here.size]
        fill_products(here, np.subtract(1, here, out=u), small)
        if p == 1:
            np.matmul(coefficients, small, out=into)
        else:
            giant, sums = scratch[1 + q : 1 + q + p, : here.size], scratch[1 + q + p :, : here.size]
            fill_products(here * small[-1], u * small[0], giant)
            np.matmul(coefficients, small, out=sums)
            np.einsum("dpm,pm->dm", sums.reshape(rows, p, -1), giant, out=into)
    return values


def averages(planar, t):
    """The same by de Casteljau's loop: slow, but for t in [0, 1] nothing in it is larger than the points."""
    rows, count = planar.shape
    values = np.empty((rows, t.size))
    block = max(1, BLOCK // count)
    for start in range(0, t.size, block):
        here = t[start : start + block]
        level = np.repeat(planar[..., None], here.size, axis=-1)
        for _ in range(count - 1):
            level = (1 - here) * level[:, :-1] + here * level[:, 1:]
        values[:, start : start + block] = level[:, 0]
    return values


def sample(points, m):
    """Points at the m uniform parameters 0, 1/(m-1), ..., 1: shape (m, d), for a batch (N, m, d).

    >>> sample([[0, 0], [1, 3], [2, 1], [3, 3]], 4).astype(str).tolist()
    [['0', '0'], ['1', '5/3'], ['2', '2'], ['3', '3']]

    Exact points are sampled exactly. The ends are b_0 and b_n. Raises ValueError for points that are no finite real
    numbers and an m that is no whole number or below 2. Source: deck, section 1.1, Bernstein form.
    """
    # a picture's few hundred points cost little more than their checks, so these come first in their shortest form
    plain = type(points) is np.ndarray and points.dtype is FLOAT and points.ndim == 2 and points.size
    if plain and type(m) is int and 2 <= m <= CACHED // len(points) and is_finite(points):
        return points.T.dot(uniform_basis(len(points) - 1, m)).T
    points, flat = control_points(points)
    m = whole(m, "count m", 2)
    count = points.shape[-2]
    if points.dtype is not FLOAT:
        values = values_at(points, np.array([Fraction(i, m - 1) for i in range(m)]))
    elif count * m <= CACHED:
        planar = points.mT.reshape(-1, count)
        values = product(planar, uniform_basis(count - 1, m)).reshape(*points.mT.shape[:-1], m).mT
    elif m // PIECE * count**2 <= 8 * CACHED and points.ndim == 2:
        values = pieces(points, m)
    else:
        values = values_at(points, np.linspace(0, 1, m))
    return drop(values, flat)


@lru_cache(maxsize=16)
def uniform_basis(n, m):
    """The basis at m uniform parameters, (n+1, m)."""
    return frozen(np.ascontiguousarray(basis(n, np.linspace(0, 1, m)).T))


def pieces(points, m):
    """sample for a large m: the curve is cut into K equal pieces, and all of them are sampled at the same s places.

    The matrix that cuts and the basis at s places are small enough to be cached, and per coordinate one product
    (K, n+1) (n+1, s) writes the values in their order.
    """
    count, d = points.shape
    cut, local = cutting(count - 1, m)
    k, s = len(cut), local.shape[1]
    values = np.empty((d, k * s))
    corners = cut @ points
    for c in range(d):
        product(corners[..., c], local, out=values[c].reshape(k, s))
    values[:, m - 1] = points[-1]
    return values[:, :m].T


@lru_cache(maxsize=4)
def cutting(n, m):
    """Rows that cut degree n into pieces of s steps 1/(m-1), and the basis at 0, 1/s, ..., (s-1)/s."""
    k = -(-m // PIECE)
    s = -(-m // k)
    breaks = np.arange(k + 1) * (s / (m - 1))
    return frozen(segment_rows(n, breaks[:-1], breaks[1:])), frozen(basis(n, np.arange(s) / s).T.copy())


@quiet
def evaluate_accurate(points, t):
    """evaluate(points, t) for t in [0, 1] with an error of a few units in the last place at any degree.

    Woźny and Chudy's geometric algorithm: the point walks along the polygon, Q <- (1-h) Q + h b_k, where
    h_k = t (n-k+1) h / (k (1-t) + t (n-k+1) h) is the share of B_k in B_0 + ... + B_k.

    >>> from fractions import Fraction
    >>> evaluate_accurate([[0, 0], [1, 3], [2, 1], [3, 3]], Fraction(1, 3)).astype(str).tolist()
    ['1', '5/3']

    Raises ValueError for a number t outside [0, 1], where a share may be infinite, and otherwise as `evaluate` does.
    Source: P. Woźny, F. Chudy, Linear-time geometric method for evaluating Bézier curves, Computer-Aided Design 118,
    2020.
    """
    points, flat = control_points(points)
    points, t = one_arithmetic(points, read(t, "parameter t"))
    suspects = t[(t < 0) | (t > 1)] if t.dtype is FLOAT else t.ravel()
    for value in suspects.tolist():
        if getattr(value, "is_number", True) and not 0 <= value <= 1:
            raise ValueError(f"parameter t is {shown(value)}: it must lie in [0, 1]")
    *lead, count, d = points.shape
    corners = np.moveaxis(points, -2, 0).reshape(count, *lead, *[1] * t.ndim, d)
    t = t[..., None]
    h = 1.0 if points.dtype is FLOAT else Fraction(1)
    point = corners[0] + 0 * t
    for k in range(1, count):
        h = h * t * (count - k)
        h = h / (k * (1 - t) + h)
        point = (1 - h) * point + h * corners[k]
    return finish(point, flat)
