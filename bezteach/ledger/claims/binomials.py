"""The binomial coefficients, as the games slides define them."""

from sympy import Integer, Symbol, binomial, factorial, oo

from bezteach.symbolic import i, n

from ..claim import claim

ANY = Symbol("i", integer=True)

CLAIMS = [
    claim(
        "binomial/factorials",
        "a binomial coefficient by factorials",
        (binomial(n, i), factorial(n) / (factorial(n - i) * factorial(i))),
        {i: (0, n)},
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
]
