"""Derivatives inside the curve: differences of the points that de Casteljau's algorithm leaves behind."""

from sympy import Derivative, Integer, Mul, Sum, binomial, oo

from bezteach.symbolic import b, i, j, n, r, t

from ..claim import claim
from ..forms import DELTA, FALLING, FROM_ONE, FROM_TWO, ORDER, G, curve
from .derivatives import CURVE, ORDER_R, ORDER_R_LINES

INSIDE = [
    ORDER_R,
    ORDER_R_LINES[-1],
    FALLING * DELTA**r * curve(n - r, index=j),
    FALLING * DELTA**r * G ** (n - r) * b[0],
    FALLING * DELTA**r * curve(n - r),
]


def from_points(factor, level, signs):
    """A multiple of a combination of the points of a level, the last point first."""
    last = len(signs) - 1
    total = sum(sign * (G**level * b[last - place]) for place, sign in enumerate(signs))
    return Mul(factor, total, evaluate=False)


def cubic(order):
    return Derivative(curve(3), (t, order))


THIRD = from_points(n * (n - 1) * (n - 2), n - 3, (1, -3, 3, -1))
SECOND = from_points(n * (n - 1), n - 2, (1, -2, 1))
FIRST = from_points(n, n - 1, (1, -1))

CLAIMS = [
    claim(
        "curve/derivative-r/inside",
        "the derivative of order r is a multiple of a difference of the points of level n - r",
        INSIDE,
        ORDER,
        twins=[[ORDER_R, FALLING * DELTA**r * curve(n)], [ORDER_R, FALLING * DELTA**r * curve(n - r, 1)]],
    ),
    claim(
        "casteljau/difference",
        "the difference of order r of the points of level n - r",
        (DELTA**r * curve(n - r), Sum((-1) ** (r - i) * binomial(r, i) * G ** (n - r) * b[i], (i, 0, r))),
        ORDER,
        twins=[
            (DELTA**r * curve(n - r), Sum((-1) ** i * binomial(r, i) * G ** (n - r) * b[i], (i, 0, r))),
            (DELTA**r * curve(n - r), Sum((-1) ** (r - i) * binomial(r, i) * G ** (n - r) * b[i], (i, 0, r - 1))),
        ],
    ),
    claim(
        "casteljau/difference/points",
        "level n - r has r + 1 points, with the numbers 0, ..., r",
        (Sum(Integer(1), (i, 0, r)), r + 1),
        twins=[(Sum(Integer(1), (i, 0, r)), r)],
    ),
    claim(
        "casteljau/derivative/third",
        "the third derivative from the four points of level n - 3",
        (Derivative(CURVE, (t, 3)), THIRD),
        {n: (3, oo)},
        twins=[(Derivative(CURVE, (t, 3)), from_points(n * (n - 1) * (n - 2), n - 3, (1, -2, 2, -1)))],
    ),
    claim(
        "casteljau/derivative/second",
        "the second derivative from the three points of level n - 2",
        (Derivative(CURVE, (t, 2)), SECOND),
        FROM_TWO,
        twins=[(Derivative(CURVE, (t, 2)), from_points(n * (n - 1), n - 2, (1, 2, 1)))],
    ),
    claim(
        "casteljau/derivative/first",
        "the tangent is n times the line between the two points of level n - 1",
        (Derivative(CURVE, t), FIRST),
        FROM_ONE,
        twins=[(Derivative(CURVE, t), from_points(n, n - 1, (-1, 1)))],
    ),
    claim(
        "cubic/derivative/third",
        "the third derivative of a cubic from its control points",
        (cubic(3), from_points(6, 0, (1, -3, 3, -1))),
        twins=[(cubic(3), from_points(3, 0, (1, -3, 3, -1)))],
    ),
    claim(
        "cubic/derivative/second",
        "the second derivative of a cubic from the points of level 1",
        (cubic(2), from_points(6, 1, (1, -2, 1))),
        twins=[(cubic(2), from_points(3, 1, (1, -2, 1)))],
    ),
    claim(
        "cubic/derivative/first",
        "the tangent of a cubic from the points of level 2",
        (cubic(1), from_points(3, 2, (1, -1))),
        twins=[(cubic(1), from_points(3, 1, (1, -1)))],
    ),
]
