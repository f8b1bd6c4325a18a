"""What the tests compare with: the definitions, on lists of Fractions, sharing nothing with the package."""

from fractions import Fraction
from math import ceil, comb, factorial, floor

import numpy as np
from hypothesis import strategies as st


def weight(n, i, t):
    return comb(n, i) * t**i * (1 - t) ** (n - i) if 0 <= i <= n else 0


def value(points, t):
    """sum of C(n,i) t^i (1-t)^(n-i) b_i for rows of coordinates."""
    n = len(points) - 1
    return [sum(weight(n, i, t) * b[c] for i, b in enumerate(points)) for c in range(len(points[0]))]


def powers(points):
    """Ascending coefficients, one list of polynomials per coordinate, by multiplying out (1-t)^(n-i)."""
    n = len(points) - 1
    rows = [[Fraction(0)] * len(points[0]) for _ in range(n + 1)]
    for i, b in enumerate(points):
        for k in range(n - i + 1):
            for c, x in enumerate(b):
                rows[i + k][c] += comb(n, i) * comb(n - i, k) * (-1) ** k * x
    return rows


def slope(points, t, r):
    """The r-th derivative, from the coefficients of the powers."""
    return [
        sum(
            (Fraction(factorial(k), factorial(k - r)) * c * t ** (k - r) for k, c in enumerate(column) if k >= r),
            start=Fraction(0),
        )
        for column in zip(*powers(points), strict=True)
    ]


def fractions(values):
    """A float64 array as nested lists of the Fractions it stands for."""
    if np.ndim(values) == 0:
        return Fraction(float(values))
    return [fractions(v) for v in values]


def error(got, exact):
    """Largest difference of a float64 array from nested exact values, as a float."""
    return float(max(abs(Fraction(float(g)) - e) for g, e in zip(np.ravel(got), flat(exact), strict=True)))


def flat(values):
    if isinstance(values, (list, tuple)):
        return [x for v in values for x in flat(v)]
    return [values]


def few_fractions(low, high, denominator):
    """A strategy for the fractions from low to high with at most this denominator; drawn from a list, for speed."""
    quotients = {Fraction(a, b) for b in range(1, denominator + 1) for a in range(ceil(low * b), floor(high * b) + 1)}
    return st.sampled_from(sorted(quotients, key=lambda x: (x.denominator, abs(x), x < 0)))


def dot(u, v):
    return sum(x * y for x, y in zip(u, v, strict=True))


SMALL = few_fractions(-4, 4, 3)


def vectors(d):
    return st.lists(SMALL, min_size=d, max_size=d)


def curves(d, least=1, most=6):
    return st.lists(vectors(d), min_size=least, max_size=most)


def some_data(least=2, most=9):
    """Rows of one to three coordinates."""
    return st.integers(1, 3).flatmap(lambda d: curves(d, least, most))
