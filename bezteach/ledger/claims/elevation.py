"""The same curve written with one degree more."""

from sympy import Sum

from bezteach.symbolic import B, b, i, n, t

from ..claim import claim
from ..forms import curve


def elevated(first, second):
    """The curve of degree n + 1 whose points are means of neighbours with these weights."""
    return Sum(B(i, n + 1, t) * (first * b[i] + second * b[i - 1]), (i, 0, n + 1))


def with_ends(first, second):
    """The same with the ends apart, so that every point that is named exists."""
    between = Sum(B(i, n + 1, t) * (first * b[i - 1] + second * b[i]), (i, 1, n))
    return B(0, n + 1, t) * b[0] + between + B(n + 1, n + 1, t) * b[n]


CLAIMS = [
    claim(
        "curve/elevation",
        "the same curve with degree n + 1: each new point is a mean of two neighbours",
        (curve(), elevated((n + 1 - i) / (n + 1), i / (n + 1))),
        twins=[
            (curve(), elevated(i / (n + 1), (n + 1 - i) / (n + 1))),
            (curve(), elevated((n - i) / n, i / n)),
        ],
    ),
    claim(
        "elevation/points",
        "n + 2 points for the same curve: both ends, and means of neighbours between them",
        (curve(), with_ends(i / (n + 1), 1 - i / (n + 1))),
        twins=[
            (curve(), with_ends(1 - i / (n + 1), i / (n + 1))),
            (curve(), with_ends((i - 1) / (n + 1), 1 - (i - 1) / (n + 1))),
        ],
    ),
]
