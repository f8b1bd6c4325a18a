"""Levels, halves, velocities and curvatures of Bézier curves, exact, for what arguments and counterexamples compute."""

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
