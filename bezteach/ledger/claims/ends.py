"""The ends of a Bézier curve: where it starts and ends, and its derivatives there."""

from sympy import Add, Derivative, Mul, Subs, Sum, binomial, factorial, oo

from bezteach.symbolic import b, i, n, r, t

from ..claim import claim
from .curve import CURVE

FROM_ONE, FROM_TWO = {n: (1, oo)}, {n: (2, oo)}
ORDER = {r: (0, n)}


def derivative_at(at, order=1):
    """The derivative of the curve at an end, as it is defined."""
    return Subs(Derivative(CURVE, (t, order)), t, at)


def bend(first, second):
    """The difference of two edges."""
    return Mul(n, n - 1, Add(second, Mul(-1, first, evaluate=False), evaluate=False), evaluate=False)


def falling(order, combination):
    """n! over (n - order)! times a sum."""
    return factorial(n) / factorial(n - order) * combination


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
        (derivative_at(0), n * (b[1] - b[0])),
        FROM_ONE,
        twins=[(derivative_at(0), b[1] - b[0]), (derivative_at(0), n * (b[0] - b[1]))],
    ),
    claim(
        "curve/tangent/end",
        "the tangent vector at the end is n times the last edge",
        (derivative_at(1), n * (b[n] - b[n - 1])),
        FROM_ONE,
        twins=[(derivative_at(1), n * (b[n - 1] - b[n])), (derivative_at(1), n * (b[n + 1] - b[n]))],
    ),
    claim(
        "curve/second/start",
        "the second derivative at the start, from the first two edges",
        (derivative_at(0, 2), bend(b[1] - b[0], b[2] - b[1])),
        FROM_TWO,
        twins=[
            (derivative_at(0, 2), bend(b[2] - b[1], b[1] - b[0])),
            (derivative_at(0, 2), n**2 * (b[2] - 2 * b[1] + b[0])),
        ],
    ),
    claim(
        "curve/second/end",
        "the second derivative at the end, from the last two edges",
        (derivative_at(1, 2), bend(b[n - 1] - b[n - 2], b[n] - b[n - 1])),
        FROM_TWO,
        twins=[
            (derivative_at(1, 2), bend(b[n] - b[n - 1], b[n - 1] - b[n - 2])),
            (derivative_at(1, 2), n * (n - 1) * (b[n] - b[n - 2])),
        ],
    ),
    claim(
        "curve/derivative-r/start",
        "the r-th derivative at the start, from the first r + 1 control points",
        (derivative_at(0, r), falling(r, Sum((-1) ** (r - i) * binomial(r, i) * b[i], (i, 0, r)))),
        ORDER,
        twins=[
            (derivative_at(0, r), falling(r, Sum((-1) ** i * binomial(r, i) * b[i], (i, 0, r)))),
            (derivative_at(0, r), Sum((-1) ** (r - i) * binomial(r, i) * b[i], (i, 0, r))),
        ],
    ),
    claim(
        "curve/derivative-r/end",
        "the r-th derivative at the end, from the last r + 1 control points",
        (derivative_at(1, r), falling(r, Sum((-1) ** i * binomial(r, i) * b[n - i], (i, 0, r)))),
        ORDER,
        twins=[
            (derivative_at(1, r), falling(r, Sum((-1) ** (r - i) * binomial(r, i) * b[n - i], (i, 0, r)))),
            (derivative_at(1, r), falling(r, Sum(binomial(r, i) * b[n - i], (i, 0, r)))),
        ],
    ),
    claim(
        "curve/derivative-r/start/edges",
        "the r-th derivative at the start, from the first r edges",
        (
            derivative_at(0, r),
            falling(r, Sum((-1) ** (r - 1 - i) * binomial(r - 1, i) * (b[i + 1] - b[i]), (i, 0, r - 1))),
        ),
        FROM_ONE | {r: (1, n)},
        twins=[
            (
                derivative_at(0, r),
                falling(r, Sum((-1) ** (r - i) * binomial(r - 1, i) * (b[i + 1] - b[i]), (i, 0, r - 1))),
            )
        ],
    ),
    claim(
        "curve/derivative-r/end/edges",
        "the r-th derivative at the end, from the last r edges",
        (
            derivative_at(1, r),
            falling(r, Sum((-1) ** i * binomial(r - 1, i) * (b[n - i] - b[n - i - 1]), (i, 0, r - 1))),
        ),
        FROM_ONE | {r: (1, n)},
        twins=[
            (
                derivative_at(1, r),
                falling(r, Sum((-1) ** (r - 1 - i) * binomial(r - 1, i) * (b[n - i] - b[n - i - 1]), (i, 0, r - 1))),
            )
        ],
    ),
]
