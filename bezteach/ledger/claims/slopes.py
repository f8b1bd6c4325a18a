"""The slopes of the Bernstein functions: first and second derivative, and where each is greatest."""

from sympy import Derivative, Le, binomial

from bezteach.symbolic import B, i, n, t

from ..claim import claim
from ..forms import FROM_ONE, FROM_TWO, UNIT, WITHIN

SLOPE = [
    Derivative(B(i, n, t), t),
    binomial(n, i) * i * t ** (i - 1) * (1 - t) ** (n - i) - binomial(n, i) * (n - i) * t**i * (1 - t) ** (n - i - 1),
    n * binomial(n - 1, i - 1) * t ** (i - 1) * (1 - t) ** (n - i)
    - n * binomial(n - 1, i) * t**i * (1 - t) ** (n - i - 1),
    n * (B(i - 1, n - 1, t) - B(i, n - 1, t)),
]

WHY = [
    "",
    "product rule",
    "i C(n, i) = n C(n - 1, i - 1) and (n - i) C(n, i) = n C(n - 1, i)",
    "both terms are functions one degree lower",
]

CLAIMS = [
    claim(
        "basis/derivative",
        "the derivative, from the two neighbours one degree lower",
        (SLOPE[0], SLOPE[-1]),
        FROM_ONE | WITHIN,
        twins=[
            (SLOPE[0], n * (B(i, n - 1, t) - B(i - 1, n - 1, t))),
            (SLOPE[0], B(i - 1, n - 1, t) - B(i, n - 1, t)),
            (SLOPE[0], n * (B(i - 1, n - 1, t) - B(i, n, t))),
        ],
    ),
    claim(
        "basis/derivative/proof",
        "the derivative by the product rule",
        list(zip(SLOPE, WHY, strict=True)),
        FROM_TWO | {i: (1, n - 1)},
        twins=[[SLOPE[0], SLOPE[1].subs(i, i + 1), SLOPE[3]], [SLOPE[0], SLOPE[2] / n, SLOPE[3]]],
    ),
    claim(
        "basis/derivative/proof/first",
        "the derivative of the first function",
        [
            Derivative(B(0, n, t), t),
            (Derivative((1 - t) ** n, t), "definition"),
            (-n * (1 - t) ** (n - 1), "chain rule"),
            (-n * B(0, n - 1, t), "the first function one degree lower"),
        ],
        FROM_ONE,
        twins=[[Derivative(B(0, n, t), t), n * (1 - t) ** (n - 1)]],
    ),
    claim(
        "basis/derivative/proof/last",
        "the derivative of the last function",
        [
            Derivative(B(n, n, t), t),
            (Derivative(t**n, t), "definition"),
            (n * t ** (n - 1), "power rule"),
            (n * B(n - 1, n - 1, t), "the last function one degree lower"),
        ],
        FROM_ONE,
        twins=[[Derivative(B(n, n, t), t), n * B(n, n - 1, t)]],
    ),
    claim(
        "basis/second-derivative",
        "the second derivative, from three neighbours two degrees lower",
        (
            Derivative(B(i, n, t), (t, 2)),
            n * (n - 1) * (B(i - 2, n - 2, t) - 2 * B(i - 1, n - 2, t) + B(i, n - 2, t)),
        ),
        FROM_TWO | WITHIN,
        twins=[
            (
                Derivative(B(i, n, t), (t, 2)),
                n * (n - 1) * (B(i - 2, n - 2, t) + 2 * B(i - 1, n - 2, t) + B(i, n - 2, t)),
            ),
            (Derivative(B(i, n, t), (t, 2)), n**2 * (B(i - 2, n - 2, t) - 2 * B(i - 1, n - 2, t) + B(i, n - 2, t))),
        ],
    ),
    claim(
        "basis/maximum",
        "on [0, 1] the greatest value is taken at i/n",
        Le(B(i, n, t), B(i, n, i / n), evaluate=False),
        FROM_ONE | WITHIN | UNIT,
        twins=[
            Le(B(i, n, t), B(i, n, i / (n + 1)), evaluate=False),
            Le(B(i, n, t), B(i, n, (i + 1) / (n + 1)), evaluate=False),
            Le(B(i, n, 2 * t), B(i, n, i / n), evaluate=False),
        ],
    ),
    claim(
        "basis/maximum/from-derivative",
        "the derivative has the sign of i - nt inside (0, 1)",
        [
            t * (1 - t) * SLOPE[0],
            (t * (1 - t) * SLOPE[-1], "the derivative from two functions one degree lower"),
            (
                (i - n * t) * B(i, n, t),
                "n t times the first is i times the function, n (1 - t) times the second is n - i times it, "
                "and i (1 - t) - (n - i) t = i - n t",
            ),
        ],
        FROM_ONE | WITHIN,
        twins=[[t * (1 - t) * SLOPE[0], (n * t - i) * B(i, n, t)], [SLOPE[0], (i - n * t) * B(i, n, t)]],
    ),
]
