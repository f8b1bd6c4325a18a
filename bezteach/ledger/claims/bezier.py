"""Bézier's own form of the curve: vectors from point to point, and the functions f_i that go with them."""

from sympy import Derivative, Integer, Sum, binomial

from bezteach.symbolic import B, b, i, j, n, t

from ..claim import claim
from ..forms import FROM_ONE, curve

TAIL = Sum(B(j, n, t), (j, i, n))
IN_POWERS = Sum((-1) ** (i + j) * binomial(n, j) * binomial(j - 1, i - 1) * t**j, (j, i, n))

OWN_FORM = b[0] + Sum((b[i] - b[i - 1]) * TAIL, (i, 1, n))
CURVE = curve(index=j)

CLAIMS = [
    claim(
        "bezier/form",
        "the curve from its first point and the vectors from point to point",
        (OWN_FORM, CURVE),
        twins=[
            (b[0] + Sum((b[i] - b[i - 1]) * B(i, n, t), (i, 1, n)), CURVE),
            (Sum((b[i] - b[i - 1]) * TAIL, (i, 1, n)), CURVE),
        ],
    ),
    claim(
        "bezier/vertices",
        "each vertex is the first one and the relative vectors up to it",
        (b[0] + Sum(b[i] - b[i - 1], (i, 1, j)), b[j]),
        twins=[(b[0] + Sum(b[i] - b[i - 1], (i, 0, j)), b[j]), (b[0] + Sum(b[i] - b[i - 1], (i, 1, j)), b[j - 1])],
    ),
    claim(
        "bezier/basis",
        "Bézier's functions in powers of t are sums of the last Bernstein functions",
        (TAIL, IN_POWERS),
        FROM_ONE | {i: (1, n)},
        twins=[
            (TAIL, Sum((-1) ** (i + j) * binomial(n, j) * binomial(j, i) * t**j, (j, i, n))),
            (TAIL, Sum((-1) ** i * binomial(n, j) * binomial(j - 1, i - 1) * t**j, (j, i, n))),
        ],
    ),
    claim(
        "bezier/basis/first",
        "the first of Bézier's functions is 1",
        (Sum(B(j, n, t), (j, 0, n)), Integer(1)),
        twins=[(Sum(B(j, n, t), (j, 1, n)), Integer(1))],
    ),
    *(
        claim(
            f"bezier/cubic/{place}",
            f"number {place} of Bézier's cubic functions",
            (Sum(B(j, 3, t), (j, place, 3)), function),
            twins=[(Sum(B(j, 3, t), (j, place, 3)), wrong)],
        )
        for place, function, wrong in (
            (0, Integer(1), (1 - t) ** 3),
            (1, 3 * t - 3 * t**2 + t**3, 3 * t - 3 * t**2 - t**3),
            (2, 3 * t**2 - 2 * t**3, 3 * t**2 - 3 * t**3),
            (3, t**3, 2 * t**3),
        )
    ),
    claim(
        "bezier/derivative",
        "the derivative of Bézier's functions is a multiple of one Bernstein function",
        (Sum(Derivative(B(j, n, t), t), (j, i, n)), n * B(i - 1, n - 1, t)),
        FROM_ONE | {i: (1, n)},
        twins=[
            (Sum(Derivative(B(j, n, t), t), (j, i, n)), n * B(i, n - 1, t)),
            (Sum(Derivative(B(j, n, t), t), (j, i, n)), -n * B(i - 1, n - 1, t)),
        ],
    ),
    claim(
        "bezier/to-bernstein",
        "from vectors between the points to the points themselves",
        [
            OWN_FORM,
            (
                Sum((b[0] + Sum(b[i] - b[i - 1], (i, 1, j))) * B(j, n, t), (j, 0, n)),
                "number j of the basis is in f_i for each i up to j, and f_0 = 1 is the sum of all",
            ),
            (CURVE, "the vectors up to b_j lead from b_0 to b_j"),
        ],
        twins=[
            [OWN_FORM, Sum((b[0] + Sum(b[i] - b[i - 1], (i, 1, n))) * B(j, n, t), (j, 0, n)), CURVE],
            [OWN_FORM, Sum(b[i] * TAIL, (i, 0, n))],
        ],
    ),
]
