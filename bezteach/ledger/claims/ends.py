"""The ends of a Bézier curve: where it starts and ends, and its derivatives there."""

from sympy import Mul, Subs, Sum, binomial

from bezteach.symbolic import b, i, n, r, t

from ..claim import claim
from ..forms import FALLING, FROM_ONE, FROM_TWO, ORDER, derivative_at, difference
from .curve import CURVE


def at(end, order=1):
    """The derivative of this order of the curve, at an end."""
    return derivative_at(end, CURVE, order)


def bend(first, second):
    """The second derivative at an end, from its two edges."""
    return Mul(n, n - 1, difference(second, first), evaluate=False)


CLAIMS = [
    claim(
        "curve/start",
        "the curve starts at the first control point",
        (Subs(CURVE, t, 0), b[0]),
        twins=[(Subs(CURVE, t, 0), b[n])],
    ),
    claim(
        "curve/end",
        "the curve ends at the last control point",
        (Subs(CURVE, t, 1), b[n]),
        twins=[(Subs(CURVE, t, 1), b[n + 1]), (Subs(CURVE, t, 1), b[0])],
    ),
    claim(
        "curve/tangent/start",
        "the tangent vector at the start is n times the first edge",
        (at(0), n * (b[1] - b[0])),
        FROM_ONE,
        twins=[(at(0), b[1] - b[0]), (at(0), n * (b[0] - b[1]))],
    ),
    claim(
        "curve/tangent/end",
        "the tangent vector at the end is n times the last edge",
        (at(1), n * (b[n] - b[n - 1])),
        FROM_ONE,
        twins=[(at(1), n * (b[n - 1] - b[n])), (at(1), n * (b[n + 1] - b[n]))],
    ),
    claim(
        "curve/second/start",
        "the second derivative at the start, from the first two edges",
        (at(0, 2), bend(b[1] - b[0], b[2] - b[1])),
        FROM_TWO,
        twins=[
            (at(0, 2), bend(b[2] - b[1], b[1] - b[0])),
            (at(0, 2), n**2 * (b[2] - 2 * b[1] + b[0])),
        ],
    ),
    claim(
        "curve/second/end",
        "the second derivative at the end, from the last two edges",
        (at(1, 2), bend(b[n - 1] - b[n - 2], b[n] - b[n - 1])),
        FROM_TWO,
        twins=[
            (at(1, 2), bend(b[n] - b[n - 1], b[n - 1] - b[n - 2])),
            (at(1, 2), n * (n - 1) * (b[n] - b[n - 2])),
        ],
    ),
    claim(
        "curve/derivative-r/start",
        "the r-th derivative at the start, from the first r + 1 control points",
        (at(0, r), FALLING * Sum((-1) ** (r - i) * binomial(r, i) * b[i], (i, 0, r))),
        ORDER,
        twins=[
            (at(0, r), FALLING * Sum((-1) ** i * binomial(r, i) * b[i], (i, 0, r))),
            (at(0, r), Sum((-1) ** (r - i) * binomial(r, i) * b[i], (i, 0, r))),
        ],
    ),
    claim(
        "curve/derivative-r/end",
        "the r-th derivative at the end, from the last r + 1 control points",
        (at(1, r), FALLING * Sum((-1) ** i * binomial(r, i) * b[n - i], (i, 0, r))),
        ORDER,
        twins=[
            (at(1, r), FALLING * Sum((-1) ** (r - i) * binomial(r, i) * b[n - i], (i, 0, r))),
            (at(1, r), FALLING * Sum(binomial(r, i) * b[n - i], (i, 0, r))),
        ],
    ),
    claim(
        "curve/derivative-r/start/edges",
        "the r-th derivative at the start, from the first r edges",
        (
            at(0, r),
            FALLING * Sum((-1) ** (r - 1 - i) * binomial(r - 1, i) * (b[i + 1] - b[i]), (i, 0, r - 1)),
        ),
        FROM_ONE | {r: (1, n)},
        twins=[
            (
                at(0, r),
                FALLING * Sum((-1) ** (r - i) * binomial(r - 1, i) * (b[i + 1] - b[i]), (i, 0, r - 1)),
            )
        ],
    ),
    claim(
        "curve/derivative-r/end/edges",
        "the r-th derivative at the end, from the last r edges",
        (
            at(1, r),
            FALLING * Sum((-1) ** i * binomial(r - 1, i) * (b[n - i] - b[n - i - 1]), (i, 0, r - 1)),
        ),
        FROM_ONE | {r: (1, n)},
        twins=[
            (
                at(1, r),
                FALLING * Sum((-1) ** (r - 1 - i) * binomial(r - 1, i) * (b[n - i] - b[n - i - 1]), (i, 0, r - 1)),
            )
        ],
    ),
]
