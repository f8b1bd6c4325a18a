"""Roots and signs of an affine function along a curve, exact, and the minors of the matrix of the basis.

The function has the values d_0, ..., d_n at the control points, ints and Fractions; along the curve it is the sum of
the d_j B_{j,n}(t).
"""

from itertools import combinations, pairwise
from math import comb

from sympy import Poly, Rational
from sympy.abc import t


def bernstein(j, n, at):
    """B_{j,n} at a number, a polynomial or a quotient of them, in its arithmetic.

    >>> bernstein(1, 3, 2)
    6
    """
    return comb(n, j) * at**j * (1 - at) ** (n - j)


def along_curve(values):
    """The polynomial in t that an affine function with these values at the control points is along the curve.

    >>> along_curve([0, 0, 3])
    Poly(3*t**2, t, domain='QQ')
    """
    degree = len(values) - 1
    parameter = Poly(t, t, domain="QQ")
    terms = (Rational(value) * bernstein(j, degree, parameter) for j, value in enumerate(values))
    return sum(terms, 0 * parameter)


def roots_inside(polynomial, low, high):
    """The multiplicities of the real roots between low and high, the ends left out, counted by Sturm's sequences.

    >>> sorted(roots_inside(Poly(t**2 * (2 * t - 1) ** 3 * (3 * t - 1), t), 0, 1))
    [1, 3]
    """
    if polynomial.is_zero:
        raise ValueError("every number is a root of the zero polynomial")
    found = []
    for factor, power in polynomial.sqf_list()[1]:
        ends = sum(factor.eval(end) == 0 for end in (low, high))
        found += [power] * (factor.count_roots(low, high) - ends)
    return found


def sign_changes(values):
    """How often the sign changes along a sequence, zeros left out.

    >>> sign_changes([1, 0, -2, -1, 3])
    2
    """
    signs = [value > 0 for value in values if value != 0]
    return sum(one != next_one for one, next_one in pairwise(signs))


def minors(matrix):
    """All minors of a matrix, each expanded along its first row from those of one row less."""
    found = {((), ()): 1}
    for size in range(1, min(len(matrix), len(matrix[0])) + 1):
        for rows in combinations(range(len(matrix)), size):
            for columns in combinations(range(len(matrix[0])), size):
                found[rows, columns] = sum(
                    (-1) ** place * matrix[rows[0]][column] * found[rows[1:], columns[:place] + columns[place + 1 :]]
                    for place, column in enumerate(columns)
                )
    return list(found.values())
