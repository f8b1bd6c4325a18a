"""The hodograph and the higher derivatives of the curve, at every parameter and at the ends."""

from sympy import Derivative, Integer, Sum, binomial, factorial

from bezteach.symbolic import B, E, b, j, n, r, t

from ..claim import claim
from ..forms import DELTA, FALLING, FROM_ONE, FROM_TWO, ORDER, G, curve, derivative_at

CURVE = G**n * b[0]
ORDER_R = Derivative(CURVE, (t, r))

HODOGRAPH = [
    Derivative(curve(index=j), t),
    n * Sum((B(j - 1, n - 1, t) - B(j, n - 1, t)) * b[j], (j, 0, n)),
    n * Sum(B(j - 1, n - 1, t) * b[j], (j, 1, n)) - n * Sum(B(j, n - 1, t) * b[j], (j, 0, n - 1)),
    n * Sum(B(j, n - 1, t) * b[j + 1], (j, 0, n - 1)) - n * Sum(B(j, n - 1, t) * b[j], (j, 0, n - 1)),
    n * Sum((b[j + 1] - b[j]) * B(j, n - 1, t), (j, 0, n - 1)),
    n * Sum(DELTA * b[j] * B(j, n - 1, t), (j, 0, n - 1)),
]
FIRST = [
    Derivative(CURVE, t),
    n * G ** (n - 1) * (E * b[0] - b[0]),
    n * G ** (n - 1) * (b[1] - b[0]),
    n * G ** (n - 1) * DELTA * b[0],
]
SECOND = [
    Derivative(CURVE, (t, 2)),
    n * (n - 1) * G ** (n - 2) * (E * DELTA * b[0] - DELTA * b[0]),
    n * (n - 1) * G ** (n - 2) * (DELTA * b[1] - DELTA * b[0]),
    n * (n - 1) * G ** (n - 2) * DELTA**2 * b[0],
]
ORDER_R_LINES = [
    ORDER_R,
    FALLING * G ** (n - r) * DELTA**r * b[0],
    FALLING * Sum(DELTA**r * b[j] * B(j, n - r, t), (j, 0, n - r)),
]


def at(end, order):
    """The derivative of this order of the curve, at an end."""
    return derivative_at(end, curve(), order)


START_R = (at(0, r), FALLING * DELTA**r * b[0])
END_R = (at(1, r), FALLING * DELTA**r * b[n - r])

HODOGRAPHS = [
    claim(
        "curve/hodograph",
        "the derivative is the curve of the edges, n times",
        (Derivative(curve(), t), HODOGRAPH[4]),
        FROM_ONE,
        twins=[
            (Derivative(curve(), t), Sum((b[j + 1] - b[j]) * B(j, n - 1, t), (j, 0, n - 1))),
            (Derivative(curve(), t), n * Sum((b[j] - b[j + 1]) * B(j, n - 1, t), (j, 0, n - 1))),
            (Derivative(curve(), t), n * Sum((b[j + 1] - b[j]) * B(j, n, t), (j, 0, n - 1))),
        ],
    ),
    claim(
        "curve/hodograph/from-basis",
        "the derivative of the curve from those of the basis",
        (HODOGRAPH[0], HODOGRAPH[1]),
        FROM_ONE,
        twins=[(HODOGRAPH[0], n * Sum((B(j, n - 1, t) - B(j - 1, n - 1, t)) * b[j], (j, 0, n)))],
    ),
    claim(
        "curve/hodograph/proof",
        "the derivative, gathered by the edges",
        HODOGRAPH,
        FROM_ONE,
        twins=[
            [*HODOGRAPH[:3], n * Sum(B(j, n - 1, t) * b[j + 1], (j, 1, n)) - n * Sum(B(j, n - 1, t) * b[j], (j, 1, n))]
        ],
    ),
    claim(
        "curve/hodograph/points",
        "there are n differences of neighbours, and n points make a curve of degree n - 1",
        (Sum(Integer(1), (j, 0, n - 1)), n),
        FROM_ONE,
        twins=[(Sum(Integer(1), (j, 0, n - 1)), n - 1)],
    ),
]

HIGHER = [
    claim(
        "curve/derivative/operator",
        "the power of the step differentiated once",
        FIRST,
        FROM_ONE,
        twins=[[FIRST[0], n * G**n * DELTA * b[0]], [FIRST[0], n * G ** (n - 1) * b[1]]],
    ),
    claim(
        "curve/second-derivative/operator",
        "the power of the step differentiated twice",
        SECOND,
        FROM_TWO,
        twins=[[SECOND[0], n**2 * G ** (n - 2) * DELTA**2 * b[0]]],
    ),
    claim(
        "curve/derivative-r",
        "the derivative of order r is the curve of the differences of order r, times n!/(n - r)!",
        ORDER_R_LINES,
        ORDER,
        twins=[
            [ORDER_R, binomial(n, r) * G ** (n - r) * DELTA**r * b[0]],
            [ORDER_R, FALLING * Sum(DELTA**r * b[j] * B(j, n, t), (j, 0, n - r))],
        ],
    ),
    claim(
        "curve/derivative-r/factor",
        "n!/(n - r)! is n (n - 1) ... (n - r + 1): each derivative brings one factor more, n - r after r of them",
        (factorial(n) / factorial(n - (r + 1)), (n - r) * FALLING),
        FROM_ONE | {r: (0, n - 1)},
        twins=[(factorial(n) / factorial(n - (r + 1)), (n - r - 1) * FALLING)],
    ),
]

ENDS = [
    claim(
        "curve/derivative-r/start/difference",
        "the derivative of order r at the start is a multiple of the first difference of order r",
        START_R,
        ORDER,
        twins=[(at(0, r), FALLING * DELTA**r * b[1]), (at(0, r), binomial(n, r) * DELTA**r * b[0])],
    ),
    claim(
        "curve/derivative-r/end/difference",
        "the derivative of order r at the end is a multiple of the last difference of order r",
        END_R,
        ORDER,
        twins=[(at(1, r), FALLING * DELTA**r * b[n]), (at(1, r), FALLING * (1 - E) ** r * b[n - r])],
    ),
    claim(
        "curve/tangent/start/difference",
        "the tangent at the start is n times the first edge",
        [at(0, 1), n * DELTA * b[0], n * (b[1] - b[0])],
        twins=[[at(0, 1), DELTA * b[0]], [at(0, 1), n * (b[0] - b[1])]],
    ),
    claim(
        "curve/tangent/end/difference",
        "the tangent at the end is n times the last edge",
        [at(1, 1), n * DELTA * b[n - 1], n * (b[n] - b[n - 1])],
        twins=[[at(1, 1), n * DELTA * b[n]], [at(1, 1), n * (b[n - 1] - b[n])]],
    ),
    claim(
        "curve/second/start/difference",
        "the second derivative at the start from the first second difference",
        (at(0, 2), n * (n - 1) * DELTA**2 * b[0]),
        twins=[(at(0, 2), n**2 * DELTA**2 * b[0])],
    ),
    claim(
        "curve/second/end/difference",
        "the second derivative at the end from the last second difference",
        (at(1, 2), n * (n - 1) * DELTA**2 * b[n - 2]),
        twins=[(at(1, 2), n * (n - 1) * DELTA**2 * b[n - 1])],
    ),
]

CLAIMS = [*HODOGRAPHS, *HIGHER, *ENDS]
