"""Points of a curve at many parameters: by the basis, by a cached basis, and with almost no error."""

from fractions import Fraction
from functools import lru_cache
from math import isfinite

import numpy as np
from numpy import ndarray, vdot

from bezteach.numeric.arrays import (
    FEW,
    FLOAT,
    control_points,
    drop,
    finish,
    one_arithmetic,
    plain,
    quiet,
    read,
    shown,
    whole,
)
from bezteach.numeric.basis import HIGHEST, basis, frozen, product, segment_rows
from bezteach.numeric.planar import basis_values, planar_values, tame

CACHED = 2**17  # numbers in a cached basis: at most 1 MB each
MANY = 1000  # samples from which on a planar product, with the coordinates in rows, is the quicker one
PIECE = 4096  # steps in one of the pieces of a large sample


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
    # the checks one by one cost as much as a thousand points; most often one bound shows that all is well
    if plain(points, 2) and plain(t, 1) and len(points) <= HIGHEST + 1 and tame(points.T, t):
        return basis_values(points.T, t).T
    points, flat = control_points(points)
    points, t = one_arithmetic(points, read(t, "parameter t"))
    return drop(values_at(points, t), flat)


@quiet
def values_at(points, t):
    """evaluate(points, t) without the checks, in the arithmetic of both."""
    *lead, count, d = points.shape
    if points.dtype is not FLOAT:
        values = basis(count - 1, t.ravel()) @ points
    else:
        values = planar_values(points.mT.reshape(-1, count), t.ravel()).reshape(*lead, d, t.size).mT
    return values if t.ndim == 1 else values.reshape(*lead, *t.shape, d)


def sample(points, m):
    """Points at the m uniform parameters 0, 1/(m-1), ..., 1: shape (m, d), for a batch (N, m, d).

    >>> sample([[0, 0], [1, 3], [2, 1], [3, 3]], 4).astype(str).tolist()
    [['0', '0'], ['1', '5/3'], ['2', '2'], ['3', '3']]

    Exact points are sampled exactly. The ends are b_0 and b_n. Raises ValueError for points that are no finite real
    numbers and an m that is no whole number or below 2. Source: deck, section 1.1, Bernstein form.
    """
    # a picture's few hundred points cost little more than their checks, so these come first in their shortest form
    if type(points) is ndarray and points.dtype is FLOAT and points.ndim == 2 and type(m) is int and m > 1:
        size = points.size
        if 0 < m * size <= CACHED and isfinite(sum(points.ravel().tolist()) if size <= FEW else vdot(points, points)):
            cached = uniform_basis(len(points) - 1, m)
            return cached.dot(points) if m < MANY else points.T.dot(cached.T).T
    points, flat = control_points(points)
    m = whole(m, "count m", 2)
    count = points.shape[-2]
    if points.dtype is not FLOAT:
        values = values_at(points, np.array([Fraction(i, m - 1) for i in range(m)]))
    elif count * m <= CACHED:
        planar = points.mT.reshape(-1, count)
        values = product(planar, uniform_basis(count - 1, m).T).reshape(*points.mT.shape[:-1], m).mT
    elif m // PIECE * count**2 <= 8 * CACHED and points.ndim == 2:
        values = pieces(points, m)
    else:
        values = values_at(points, np.linspace(0, 1, m))
    return drop(values, flat)


@lru_cache(maxsize=16)
def uniform_basis(n, m):
    """The basis at m uniform parameters, (m, n+1), in memory column after column."""
    return frozen(np.asfortranarray(basis(n, np.linspace(0, 1, m))))


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
