"""What the tests of B-splines compare with: the Cox-de Boor recursion with 0/0 := 0, written out on Fractions."""

from fractions import Fraction as F
from itertools import pairwise

import numpy as np
import sympy
from hypothesis import strategies as st
from numeric_oracle import few_fractions

KNOTS = [0, 0, 0, 1, 2, 3, 4, 4, 4]  # the transcript's, for six points of degree 2
POINTS = [0, 2, 4, 0, 4, 2]
JUMP = ([0, 0, 1, 1, 3, 4], [0, 2, 5, 7])  # knots and points of degree 1; 1 stands p+1 times
x = sympy.Symbol("x")


def weights(knots, p, t, left=False):
    """N_{0,p}(t), N_{1,p}(t), ... as limits from the right or from the left."""
    row = [int(a < t <= b if left else a <= t < b) for a, b in pairwise(knots)]
    for q in range(1, p + 1):
        up = [share(t - knots[i], knots[i + q] - knots[i]) * n for i, n in enumerate(row)]
        down = [share(knots[i + q] - t, knots[i + q] - knots[i]) * n for i, n in enumerate(row)]
        row = [a + b for a, b in zip(up, down[1:], strict=False)]
    return row


def share(part, whole):
    return F(part) / whole if whole else 0


def value(points, knots, t, left=None):
    p, end = len(knots) - len(points) - 1, knots[len(points)]
    left = t == end if left is None else left
    return sum(n * b for n, b in zip(weights(knots, p, t, left), points, strict=True) if n)


def slope(points, knots, t, r):
    """The r-th derivative from p+1 values on the piece at t: D = log(1 + Δ) / h, exact on polynomials of degree p."""
    p, end = len(knots) - len(points) - 1, knots[len(points)]
    onward = [k - t for k in knots if (k < t if t == end else k > t)]
    h = F(max(onward) if t == end else min(onward)) / (p + 1)
    row = [value(points, knots, t + j * h, t == end) for j in range(p + 1)]
    differences = []
    while row:
        differences.append(row[0])
        row = [b - a for a, b in pairwise(row)]
    logarithm = [F(0)] + [F((-1) ** (k + 1), k) / h for k in range(1, p + 1)]
    power = [F(1)] + [F(0)] * p
    for _ in range(r):
        power = [sum(power[i] * logarithm[k - i] for i in range(k + 1)) for k in range(p + 1)]
    return sum(c * d for c, d in zip(power, differences, strict=True))


def places(knots, count):
    """Every knot in the domain, and two places in each of its spans."""
    p = len(knots) - count - 1
    inner = sorted(set(knots[p : count + 1]))
    return inner + [a + (b - a) * w for a, b in pairwise(inner) for w in (F(1, 3), F(4, 5))]


@st.composite
def splines(draw, least=0, most=4, full=True):
    """(points, knots) with knots that may stand up to p+1 times, p where the curve must not jump."""
    p = draw(st.integers(least, most))
    gaps = few_fractions(F(1, 3), 3, 3)
    times = st.integers(1, p + 1 if full else max(1, p))
    groups = draw(st.lists(st.tuples(gaps, times), min_size=2, max_size=5))
    knots, here = [], draw(few_fractions(-2, 2, 2))
    for gap, k in groups:
        here += gap
        knots += [here] * k
    while len(knots) < 2 * p + 2 or knots[p] == knots[-p - 1]:
        knots.append(knots[-1] + draw(gaps))
    numbers = few_fractions(-4, 4, 3)
    size = len(knots) - p - 1
    return draw(st.lists(numbers, min_size=size, max_size=size)), knots


def exact(values):
    return np.asarray(values, object).tolist()
