"""Differences of the control points: E - 1 takes each point to the way to the next, E b_i = b_{i+1}."""

from sympy import Mul, Sum, binomial, oo

from bezteach.symbolic import b, i, k, r

from ..claim import claim
from ..forms import DELTA, difference

STEP = [
    DELTA**r * b[i],
    Mul(DELTA, DELTA ** (r - 1), b[i], evaluate=False),
    difference(DELTA ** (r - 1) * b[i + 1], DELTA ** (r - 1) * b[i]),
]
SECOND = [
    DELTA**2 * b[i],
    difference(DELTA * b[i + 1], DELTA * b[i]),
    b[i + 2] - 2 * b[i + 1] + b[i],
]

CLAIMS = [
    claim(
        "difference/first",
        "the first difference: the way from a point to the next",
        (DELTA * b[i], b[i + 1] - b[i]),
        twins=[(DELTA * b[i], b[i] - b[i + 1])],
    ),
    claim(
        "difference/step",
        "a difference of order r is the difference of two of order r - 1",
        STEP,
        {r: (1, oo)},
        twins=[
            [*STEP[:2], difference(DELTA ** (r - 1) * b[i], DELTA ** (r - 1) * b[i + 1])],
            [STEP[0], DELTA ** (r - 1) * b[i]],
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
        (DELTA**r * b[i], Sum((-1) ** k * binomial(r, k) * b[i + r - k], (k, 0, r))),
        twins=[
            (DELTA**r * b[i], Sum((-1) ** k * binomial(r, k) * b[i + k], (k, 0, r))),
            (DELTA**r * b[i], Sum(binomial(r, k) * b[i + r - k], (k, 0, r))),
        ],
    ),
]
