"""The binomial coefficients, as the games slides define them, and the theorem that closes every sum of the operator."""

from sympy import Integer, Symbol, binomial, factorial, oo, symbols

from bezteach.symbolic import i, n

from ..claim import Shown, argued, claim, eq
from ..forms import FROM_ONE, WITHIN

ANY = Symbol("i", integer=True)
x, y = symbols("x y", real=True)
STEP = eq(
    x * binomial(n, i - 1) * x ** (i - 1) * y ** (n + 1 - i) + y * binomial(n, i) * x**i * y ** (n - i),
    binomial(n + 1, i) * x**i * y ** (n + 1 - i),
)

CLAIMS = [
    claim(
        "binomial/factorials",
        "a binomial coefficient by factorials",
        (binomial(n, i), factorial(n) / (factorial(n - i) * factorial(i))),
        WITHIN,
        twins=[
            (binomial(n, i), factorial(n) / factorial(n - i)),
            (binomial(n, i), factorial(n) / (factorial(n) * factorial(i))),
        ],
    ),
    claim(
        "binomial/vanishes-below",
        "0 for a negative lower number",
        (binomial(n, ANY), Integer(0)),
        {ANY: (-oo, -1)},
        twins=[(binomial(n, ANY + 1), Integer(0))],
    ),
    claim(
        "binomial/vanishes-above",
        "0 for a lower number greater than the upper one",
        (binomial(n, i), Integer(0)),
        {i: (n + 1, oo)},
        twins=[(binomial(n, i - 1), Integer(0))],
    ),
    argued(
        "binomial/theorem",
        "the sum of C(n, i) x^i y^(n-i), i = 0, ..., n, is (x + y)^n: the one lemma of the operator form",
        "Induction on n. For n = 0 the sum has one term, C(0, 0) x^0 y^0 = 1, and (x + y)^0 = 1.",
        "From n to n + 1: let the sum for n be (x + y)^n, and multiply it by x + y. The power x^i y^(n+1-i) comes from "
        "x times the term with i - 1 and from y times the term with i.",
        Shown(
            "For 1 <= i <= n both are there, and together they are the term with i for n + 1 (a quotient of the terms, "
            "no sum, is all that this step takes):",
            STEP,
            FROM_ONE | {i: (1, n)},
        ),
        "At i = 0 there is the second alone, y times C(n, 0) y^n, at i = n + 1 the first alone, x times C(n, n) x^n; "
        "and C(n, 0) = C(n + 1, 0) = 1, C(n, n) = C(n + 1, n + 1) = 1.",
        "These are all terms of the sum for n + 1; so that is (x + y)^(n+1).",
    ),
]
