"""The Bernstein basis, and the change to the power basis and back.

With the shift operator E, E^k b_0 = b_k, one de Casteljau step is g(t) = (1-t) + t E, and the Bernstein basis of
degree n is the row of coefficients of g(t)^n.
"""

import operator
from fractions import Fraction
from functools import lru_cache
from math import comb, inf

import numpy as np

from bezteach.numeric.arrays import FLOAT, control_points, finish, quiet, read, whole

# comb(n, n//2) times the powers of t stays within float64 up to here; above, the basis is computed by recursion.
HIGHEST = 1000
SINGLE = 2**18  # multiplications up to which BLAS stays on one thread


@quiet
def bernstein(n, t):
    """Values of the n+1 Bernstein polynomials of degree n, shape t.shape + (n+1,).

    B_{i,n}(t) = C(n,i) t^i (1-t)^(n-i). They sum to 1, and on [0, 1] none is negative.

    >>> from fractions import Fraction
    >>> [str(value) for value in bernstein(3, Fraction(1, 3))]
    ['8/27', '4/9', '2/9', '1/27']

    Assumes nothing of t but that it is real; outside [0, 1] the polynomials are continued. Raises ValueError for a
    degree that is no whole number or negative, a t that is no number, and values beyond float64.
    Source: deck, section 1.2, Bernstein form and properties of the basis.
    """
    n = whole(n, "degree n", 0)
    return finish(basis(n, read(t, "parameter t")))


def basis(n, t):
    """bernstein(n, t) without the checks, in the arithmetic of t."""
    if t.dtype is FLOAT:
        rows = recursion(n, t.ravel()) if n > HIGHEST else products(n, t.ravel()) * binomials(n)[:, None]
        return rows.T.reshape(*t.shape, n + 1)
    t = t[..., None]
    i = np.arange(n + 1).astype(object)
    return binomials(n, t.dtype) * t**i * (1 - t) ** i[::-1]


def products(n, t):
    """Rows t^i (1-t)^(n-i) of a float64 vector t by powers: the fewest calls."""
    up, down = exponents(n)
    return t**up * (1 - t) ** down


@lru_cache(maxsize=64)
def exponents(n):
    """The columns 0, ..., n and n, ..., 0, read-only."""
    up = np.arange(n + 1.0)[:, None]
    return frozen(up), frozen(up[::-1].copy())


def fill_products(pair, rows):
    """Fill the rows with t^i u^(n-i), where pair is (u, t), degree after degree; two rows are taken to be the pair."""
    u, t = last = pair
    for k in range(2, len(rows)):
        np.multiply(last[k - 1], t, out=rows[k])
        np.multiply(last[:k], u, out=rows[:k])
        last = rows


def recursion(n, t):
    """The basis of any degree, B_{i,k} = (1-t) B_{i,k-1} + t B_{i-1,k-1}, shape (n+1, m)."""
    rows = np.zeros((n + 1, t.size))
    rows[0] = 1
    for k in range(1, n + 1):
        rows[1 : k + 1] = (1 - t) * rows[1 : k + 1] + t * rows[:k]
        rows[0] *= 1 - t
    return rows


@lru_cache(maxsize=64)
def binomials(n, dtype=FLOAT):
    """C(n,0), ..., C(n,n), read-only; infinite where float64 ends."""
    row = [comb(n, i) for i in range(n + 1)]
    if dtype is FLOAT:
        row = [float(c) if c.bit_length() < 1024 else inf for c in row]
    return frozen(np.array(row, dtype=dtype))


def segment_rows(n, a, b):
    """Rows g(a)^(n-j) g(b)^j, which give the control points over [a, b]: shape a.shape + (n+1, n+1)."""
    rows = np.zeros((*a.shape, n + 1, n + 1), a.dtype)
    for j in range(n + 1):
        front, back = basis(n - j, a), basis(j, b)
        for i in range(j + 1):
            rows[..., j, i : i + n - j + 1] += back[..., i, None] * front
    return rows


@lru_cache(maxsize=32)
def elevation(n, r, dtype=FLOAT):
    """Rows C(n,i) C(r,j-i) / C(n+r,j) that raise the degree from n to n+r, read-only."""
    old, step, new = ([comb(k, i) for i in range(k + 1)] for k in (n, r, n + r))
    divide = operator.truediv if dtype is FLOAT else Fraction  # int / int is rounded once, whatever the size
    rows = np.zeros((n + r + 1, n + 1), dtype)
    for j in range(n + r + 1):
        for i in range(max(0, j - r), min(n, j) + 1):
            rows[j, i] = divide(old[i] * step[j - i], new[j])
    return frozen(rows)


def product(left, right, out=None):
    """left @ right in blocks of rows that BLAS leaves on one thread; two are many times slower on skinny blocks."""
    out = np.empty((len(left), right.shape[1])) if out is None else out
    step = max(1, SINGLE // right.size)
    for start in range(0, len(left), step):
        np.matmul(left[start : start + step], right, out=out[start : start + step])
    return out


def frozen(values):
    """The array, read-only: for what is cached."""
    values.flags.writeable = False
    return values


@quiet
def to_power(points):
    """Coefficients c_0, ..., c_n of the ascending powers, p(t) = sum of c_k t^k, in the shape of the points.

    g(t) = 1 + t (E - 1), so c_k = C(n,k) (E - 1)^k b_0: the k-th difference, k binomial coefficients.

    >>> to_power([[0, 0], [1, 3], [2, 1], [3, 3]]).tolist()
    [[0, 0], [3, 9], [0, -15], [0, 9]]

    In float64 a high degree loses digits, because the terms of the differences cancel. Raises ValueError for points
    that are no finite real numbers. Source: deck, section 1.2, property 10; games, "power basis".
    """
    points, flat = control_points(points)
    n = points.shape[-2] - 1
    differences = points.copy()
    for k in range(1, n + 1):
        differences[..., k:, :] = np.diff(differences[..., k - 1 :, :], axis=-2)
    return finish(differences * binomials(n, points.dtype)[:, None], flat)


@quiet
def from_power(coefficients):
    """Control points of the curve sum of c_k t^k, in the shape of the coefficients; undoes `to_power`.

    The k-th difference of b at 0 is c_k / C(n,k), and sums undo differences.

    >>> from_power([[0, 0], [3, 9], [0, -15], [0, 9]]).astype(str).tolist()
    [['0', '0'], ['1', '3'], ['2', '1'], ['3', '3']]

    Raises ValueError for coefficients that are no finite real numbers.
    Source: deck, section 1.2, property 10; games, "property 2, a basis".
    """
    coefficients, flat = control_points(coefficients, "coefficient c")
    n = coefficients.shape[-2] - 1
    if coefficients.dtype is FLOAT:
        points = coefficients / binomials(n)[:, None]
    else:
        points = coefficients * np.array([[Fraction(1, comb(n, k))] for k in range(n + 1)])
    for k in range(n, 0, -1):
        points[..., k - 1 :, :] = np.cumsum(points[..., k - 1 :, :], axis=-2)
    return finish(points, flat)
