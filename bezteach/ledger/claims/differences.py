"""Differences of the control points: E - 1 takes each point to the way to the next, E b_i = b_{i+1}."""

from sympy import Add, Mul, Sum, binomial, oo

from bezteach.symbolic import E, b, i, k, r

from ..claim import claim

DIFFERENCE = E - 1


def minus(left, right):
    """A difference as it stands."""
    return Add(left, Mul(-1, right, evaluate=False), evaluate=False)


STEP = [
    DIFFERENCE**r * b[i],
    Mul(DIFFERENCE, DIFFERENCE ** (r - 1), b[i], evaluate=False),
    minus(DIFFERENCE ** (r - 1) * b[i + 1], DIFFERENCE ** (r - 1) * b[i]),
]
SECOND = [
    DIFFERENCE**2 * b[i],
    minus(DIFFERENCE * b[i + 1], DIFFERENCE * b[i]),
    b[i + 2] - 2 * b[i + 1] + b[i],
]

CLAIMS = [
    claim(
        "difference/first",
        "the first difference: the way from a point to the next",
        (DIFFERENCE * b[i], b[i + 1] - b[i]),
        twins=[(DIFFERENCE * b[i], b[i] - b[i + 1])],
    ),
    claim(
        "difference/step",
        "a difference of order r is the difference of two of order r - 1",
        STEP,
        {r: (1, oo)},
        twins=[
            [*STEP[:2], minus(DIFFERENCE ** (r - 1) * b[i], DIFFERENCE ** (r - 1) * b[i + 1])],
            [STEP[0], DIFFERENCE ** (r - 1) * b[i]],
        ],
    ),
    claim(
        "difference/second",
        "the second difference, from three neighbours",
        SECOND,
        twins=[
            [*SECOND[:2], b[i + 2] - b[i + 1] + b[i]],
            [*SECOND[:2], b[i + 2] - 2 * b[i] + b[i + 1]],
        ],
    ),
    claim(
        "difference/r",
        "the difference of order r, written out",
        (DIFFERENCE**r * b[i], Sum((-1) ** k * binomial(r, k) * b[i + r - k], (k, 0, r))),
        twins=[
            (DIFFERENCE**r * b[i], Sum((-1) ** k * binomial(r, k) * b[i + k], (k, 0, r))),
            (DIFFERENCE**r * b[i], Sum(binomial(r, k) * b[i + r - k], (k, 0, r))),
        ],
    ),
]
