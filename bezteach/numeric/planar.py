"""Values of float64 polynomials at many parameters: the quick ways, each for its degree and its number of parameters.

The coordinates lie in rows, (rows, n+1) or "planar", because a product of few rows with many columns is the quick one.
"""

import threading
from math import isqrt, log2

import numpy as np

from bezteach.numeric.arrays import finish, is_finite
from bezteach.numeric.basis import HIGHEST, SINGLE, binomials, elevation, fill_products, products

BLOCK = 10240  # parameters at a time, so that the scratch arrays stay in the processor's cache
FEW = 1024  # numbers in the basis below which the count of calls decides
# From Bernstein coefficients to those of u, t, w, wt, w^2, w^2 t, where u = 1-t and w = ut. The entries grow with the
# degree, and so do the rounding errors: from degree 6 on they would be larger than `evaluate` promises.
LOW = {
    1: np.eye(2),
    2: np.array([[1.0, 0, -1], [0, 0, 2], [0, 1, -1]]),
    3: np.array([[1.0, 0, -2, 1], [0, 0, 3, -3], [0, 0, 0, 3], [0, 1, -1, -1]]),
    4: np.array([[1.0, 0, -3, 2, 1], [0, 0, 4, -4, -4], [0, 0, 0, 0, 6], [0, 0, 0, 4, -4], [0, 1, -1, -2, 1]]),
    5: np.array(
        [
            [1.0, 0, -4, 3, 3, -1],
            [0, 0, 5, -5, -10, 5],
            [0, 0, 0, 0, 10, -10],
            [0, 0, 0, 0, 0, 10],
            [0, 0, 0, 5, -5, -5],
            [0, 1, -1, -3, 2, 1],
        ]
    ),
}

_own = threading.local()


def planar_values(planar, t):
    """Values (rows, m) of the polynomials with these rows of Bernstein coefficients."""
    if planar.shape[1] <= HIGHEST + 1:
        values = basis_values(planar, t)
        if (values.size > FEW and tame(planar, t)) or is_finite(values):
            return values
    return finish(averages(planar, t))  # nothing in between is larger than the points


def tame(planar, t):
    """Whether a bound shows that points, parameters and values are finite, with no pass over the values."""
    size, reach = float(np.vdot(planar, planar)), float(np.vdot(t, t))  # Python's floats overflow without a warning
    # |t| + |1-t| and 2 are at most the root of 4 + 8 t^2, and no more than 1.5 n of these are multiplied
    return 1.5 * planar.shape[1] * log2(4 + 8 * reach) + log2(1 + size) < 2000


def basis_values(planar, t):
    """planar_values where nothing in between is too large."""
    n = planar.shape[1] - 1
    if n == 0:
        return np.repeat(planar, t.size, axis=1)
    if n > 3 and t.size * n <= FEW:
        return (planar * binomials(n)).dot(products(n, t))
    return low_values(planar, t) if n in LOW else factored_values(planar, t)


def low_values(planar, t):
    """basis_values for n = 1, ..., 5, where the powers of t (1-t) take the fewest products. The ends are exact."""
    rows, count = planar.shape
    coefficients, values = planar.dot(LOW[count - 1]), np.empty((rows, t.size))
    size, blocks = slices(t.size, min(BLOCK, SINGLE // coefficients.size))
    row = scratch(count, size)
    for part in blocks:
        row[1] = t[part]
        np.subtract(1, row[1], out=row[0])
        for k in range(2, count):
            np.multiply(row[k - 2], row[2 if k > 2 else 1], out=row[k])
        np.matmul(coefficients, row, out=values[:, part])
    return values


def factored_values(planar, t):
    """basis_values for any n and many parameters: t^i (1-t)^(n-i) is one of q small factors times one of p giant ones.

    There p q = n+1. There is no division and no branch, and the ends are exact.
    """
    rows, count = planar.shape
    q = isqrt(count - 1) + 1
    p = -(-count // q)
    raised = planar.dot(elevation(count - 1, p * q - count).T) if p * q > count else planar
    coefficients, values = raised * binomials(p * q - 1), np.empty((rows, t.size))
    size, blocks = slices(t.size, min(BLOCK // 2, SINGLE // coefficients.size))
    sums_first = 2 * rows <= q  # with few rows it is less work to sum over the small factors first
    memory = scratch(4 + q + p + p * (rows if sums_first else q), size)
    pair, ends, small = memory[:2], memory[2:4], memory[4 : 4 + q]
    giant = ends if p == 2 else memory[4 + q : 4 + q + p]
    work = memory[4 + q + p :].reshape(rows if sums_first else p, -1, size)
    for here in blocks:
        np.subtract(1, t[here], out=pair[0])
        pair[1] = t[here]
        fill_products(pair, small)
        fill_products(np.multiply(small[:: q - 1], pair, out=ends), giant)
        if sums_first:
            np.matmul(coefficients.reshape(rows * p, q), small, out=work.reshape(rows * p, size))
            np.add.reduce(np.multiply(work, giant, out=work), axis=1, out=values[:, here])
        else:
            np.multiply(giant[:, None], small, out=work)
            np.matmul(coefficients, work.reshape(p * q, size), out=values[:, here])
    return values


def scratch(rows, size):
    """Memory for what is in between, at most 9 MB: each thread's own, and kept, since fresh memory takes longest.

    >>> np.shares_memory(scratch(2, 3), scratch(1, 3))
    True
    """
    if getattr(_own, "numbers", np.empty(0)).size < rows * size:
        _own.numbers = np.empty(rows * size)
    return _own.numbers[: rows * size].reshape(rows, size)


def slices(count, most):
    """Cut count parameters into slices of one size, so that one scratch fits all; the last may overlap."""
    size = -(-count // -(-count // max(1024, most)))
    return size, [slice(start, start + size) for start in (*range(0, count - size, size), count - size)]


def averages(planar, t):
    """planar_values by de Casteljau's loop: slow, but for t in [0, 1] nothing in it is larger than the points."""
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
