"""The Bernstein basis: its definition, signs, sum, symmetry, integral and values at the ends."""

from sympy import (
    Add,
    Ge,
    Gt,
    Integer,
    Integral,
    Interval,
    Le,
    Pow,
    Rational,
    Sum,
    Symbol,
    binomial,
    factorial,
    oo,
)

from bezteach.symbolic import B, i, n, t

from ..claim import claim
from ..forms import FROM_ONE, UNIT, WITHIN

ANY = Symbol("i", integer=True)
ONE = Pow(Add(t, 1 - t, evaluate=False), n, evaluate=False)

CLAIMS = [
    claim(
        "basis/definition",
        "the Bernstein functions of degree n",
        (B(i, n, t), binomial(n, i) * t**i * (1 - t) ** (n - i)),
        WITHIN,
        twins=[(B(i, n, t), binomial(n, i) * t ** (n - i) * (1 - t) ** i)],
    ),
    claim(
        "basis/vanishes-below",
        "a negative index gives the zero function",
        (B(ANY, n, t), Integer(0)),
        {ANY: (-oo, -1)},
        twins=[(B(ANY + 1, n, t), Integer(0))],
    ),
    claim(
        "basis/vanishes-above",
        "an index beyond the degree gives the zero function",
        (B(i, n, t), Integer(0)),
        {i: (n + 1, oo)},
        twins=[(B(i - 1, n, t), Integer(0))],
    ),
    claim(
        "basis/non-negative",
        "none is negative on [0, 1]",
        Ge(B(i, n, t), 0, evaluate=False),
        WITHIN | UNIT,
        twins=[Gt(B(i, n, t), 0, evaluate=False)],
    ),
    claim(
        "basis/positive-inside",
        "all are positive between 0 and 1",
        Gt(B(i, n, t), 0, evaluate=False),
        WITHIN | {t: Interval.open(0, 1)},
        twins=[Gt(B(i - 1, n, t), 0, evaluate=False), Gt(B(i, n, -t), 0, evaluate=False)],
    ),
    claim(
        "basis/at-most-one",
        "none exceeds 1 on [0, 1]",
        Le(B(i, n, t), 1, evaluate=False),
        WITHIN | UNIT,
        twins=[Le(B(i, n, t), Rational(1, 2), evaluate=False), Le(B(i, n, 2 * t), 1, evaluate=False)],
    ),
    claim(
        "basis/unity",
        "they sum to one",
        (Sum(B(i, n, t), (i, 0, n)), Integer(1)),
        twins=[(Sum(B(i, n, t), (i, 1, n)), Integer(1))],
    ),
    claim(
        "basis/unity/proof",
        "they sum to one, by the binomial theorem",
        [
            Integer(1),
            (ONE, "t and 1 - t sum to 1"),
            (Sum(binomial(n, i) * t**i * (1 - t) ** (n - i), (i, 0, n)), "binomial theorem"),
            (Sum(B(i, n, t), (i, 0, n)), "each term is a basis function"),
        ],
        twins=[[Integer(1), ONE, Sum(binomial(n, i) * t**i * (1 - t) ** (n - i), (i, 1, n))]],
    ),
    claim(
        "basis/symmetry",
        "the i-th from the left is the mirror image of the i-th from the right",
        (B(i, n, t), B(n - i, n, 1 - t)),
        WITHIN,
        twins=[(B(i, n, t), B(n - i, n, t)), (B(i, n, t), B(i, n, 1 - t))],
    ),
    claim(
        "basis/integral",
        "all have the same integral over [0, 1]",
        (Integral(B(i, n, t), (t, 0, 1)), 1 / (n + 1)),
        WITHIN,
        twins=[(Integral(B(i, n, t), (t, 0, 1)), 1 / (n + 2)), (Integral(B(i, n, t), (t, 0, 1)), (i + 1) / (n + 1))],
    ),
    claim(
        "basis/integral/proof",
        "the integral, from that of t^i (1-t)^(n-i)",
        [
            Integral(B(i, n, t), (t, 0, 1)),
            (binomial(n, i) * Integral(t**i * (1 - t) ** (n - i), (t, 0, 1)), "definition"),
            (binomial(n, i) * factorial(i) * factorial(n - i) / factorial(n + 1), "Beta integral"),
            (1 / (n + 1), "n! / (n+1)! is left"),
        ],
        WITHIN,
        twins=[[Integral(B(i, n, t), (t, 0, 1)), factorial(i) * factorial(n - i) / factorial(n + 1), 1 / (n + 1)]],
    ),
    claim(
        "basis/start/first",
        "the first is 1 at 0",
        (B(0, n, 0), Integer(1)),
        twins=[(B(n, n, 0), Integer(1))],
    ),
    claim(
        "basis/start/others",
        "the others are 0 at 0",
        (B(i, n, 0), Integer(0)),
        {i: (1, n)},
        twins=[(B(i - 1, n, 0), Integer(0))],
    ),
    claim(
        "basis/end/last",
        "the last is 1 at 1",
        (B(n, n, 1), Integer(1)),
        twins=[(B(0, n, 1), Integer(1))],
    ),
    claim(
        "basis/end/others",
        "the others are 0 at 1",
        (B(i, n, 1), Integer(0)),
        FROM_ONE | {i: (0, n - 1)},
        twins=[(B(i + 1, n, 1), Integer(0))],
    ),
]
