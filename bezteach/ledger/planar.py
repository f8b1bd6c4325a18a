"""Exact geometry for what arguments and counterexamples compute: points of curves, their derivatives, hulls, lines.

Coordinates are ints and Fractions, points and vectors are tuples of them; a line a x + b y = c is (a, b, c).
"""

from fractions import Fraction
from itertools import pairwise


def levels(points, t):
    """The levels of the algorithm, from the control points to the point of the curve.

    >>> levels([(0, 0), (2, 4), (4, 0)], 1)[-1]
    [(4, 0)]
    """
    rows = [list(points)]
    while len(rows[-1]) > 1:
        pairs = pairwise(rows[-1])
        rows.append([tuple((1 - t) * a + t * b for a, b in zip(*pair, strict=True)) for pair in pairs])
    return rows


def curve_point(points, t):
    """The point of the curve at a parameter.

    >>> curve_point([(0, 0), (1, 1), (2, 0)], Fraction(1, 2))
    (Fraction(1, 1), Fraction(1, 2))
    """
    return levels(points, t)[-1][0]


def halves(points, t):
    """The control points of the two parts into which t cuts the curve."""
    rows = levels(points, t)
    return [row[0] for row in rows], [row[-1] for row in reversed(rows)]


def velocity(points, t):
    """The first derivative at t."""
    *_, (first, second), _ = levels(points, t)
    return times(len(points) - 1, minus(second, first))


def acceleration(points, t):
    """The second derivative at t; the degree is at least 2."""
    *_, (first, second, third), _, _ = levels(points, t)
    degree = len(points) - 1
    return times(degree * (degree - 1), minus(minus(third, second), minus(second, first)))


def minus(a, b):
    """The vector from b to a."""
    return tuple(x - y for x, y in zip(a, b, strict=True))


def times(factor, a):
    """A multiple of a vector."""
    return tuple(factor * x for x in a)


def dot(a, b):
    """The inner product; of a vector with itself, its length squared."""
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a, b):
    """The signed area that two vectors of the plane span."""
    return a[0] * b[1] - a[1] * b[0]


def curvature_squared(points, t):
    """The square of the curvature at t, a fraction."""
    first, second = velocity(points, t), acceleration(points, t)
    return cross(first, second) ** 2 / dot(first, first) ** 3


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
    return cross(minus(q, p), minus(other, p))


def line_values(points, line):
    """The values a x + b y - c of a line at the points.

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
