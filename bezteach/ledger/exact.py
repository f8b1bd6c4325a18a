"""Exact answers to the questions that arguments about the shape of a curve ask: roots, signs, minors, hulls, places.

Numbers are ints and Fractions, points are tuples of them. The values of an affine function at the control points
b_0, ..., b_n are its values d_0, ..., d_n; along the curve it is the sum of the d_j B_{j,n}(t).
"""

from fractions import Fraction
from itertools import combinations, pairwise
from math import comb

from sympy import Poly, Rational
from sympy.abc import t

from .planar import levels


def bernstein(j, n, at):
    """B_{j,n} at a number.

    >>> bernstein(1, 3, Fraction(1, 3))
    Fraction(4, 9)
    """
    return comb(n, j) * at**j * (1 - at) ** (n - j)


def curve_point(points, at):
    """The point of the curve at a parameter, by de Casteljau's algorithm.

    >>> curve_point([(0, 0), (1, 1), (2, 0)], Fraction(1, 2))
    (Fraction(1, 1), Fraction(1, 2))
    """
    return levels(points, at)[-1][0]


def along_curve(values):
    """The polynomial in t that an affine function with these values at the control points is along the curve."""
    degree, one_minus = len(values) - 1, Poly(1 - t, t)
    terms = [
        Rational(value) * comb(degree, j) * Poly(t, t) ** j * one_minus ** (degree - j)
        for j, value in enumerate(values)
    ]
    return sum(terms, Poly(0, t))


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


def in_hull(points, point):
    """Whether a point of the plane lies in the convex hull of the points: within their box, outside of no edge.

    >>> in_hull([(0, 0), (1, 0), (0, 1)], (Fraction(1, 2), Fraction(1, 2))), in_hull([(0, 0), (2, 2)], (3, 3))
    (True, False)
    """
    boxed = all(min(values) <= at <= max(values) for values, at in zip(zip(*points, strict=True), point, strict=True))
    edges = [(p, q) for p in points for q in points if p != q and all(side(p, q, other) >= 0 for other in points)]
    return boxed and all(side(p, q, point) >= 0 for p, q in edges)


def side(p, q, other):
    """Twice the area of a triangle: positive if the third point is to the left of the way from p to q."""
    return (q[0] - p[0]) * (other[1] - p[1]) - (q[1] - p[1]) * (other[0] - p[0])


def line_values(points, line):
    """The values a x + b y - c at the points, for the line (a, b, c).

    >>> line_values([(0, 0), (1, 2)], (1, 1, 2))
    [-2, 1]
    """
    a, b, c = line
    return [a * x + b * y - c for x, y in points]


def polygon_places(points, line):
    """The set of places where the polygon meets a line that holds none of its edges."""
    found = set()
    for (p, at_p), (q, at_q) in pairwise(zip(points, line_values(points, line), strict=True)):
        if at_p == at_q == 0:
            raise ValueError(f"the edge from {p} to {q} lies in the line")
        if at_p * at_q <= 0:
            found.add(curve_point([p, q], Fraction(at_p, at_p - at_q)))
    return found
