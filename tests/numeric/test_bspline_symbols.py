"""B-splines with symbols: points and parameters in a span that is given, against SymPy's own."""

from fractions import Fraction as F
from itertools import product

import pytest
import sympy
from bspline_oracle import KNOTS, POINTS, value, x

from bezteach import numeric
from bezteach.numeric import bspline
from bezteach.numeric.bspline import (
    basis,
    blossom,
    de_boor,
    derivative,
    evaluate,
    insert,
    span,
    to_bezier,
)


@pytest.mark.parametrize(
    "p, knots",
    [(p, list(range(p + 4))) for p in range(4)]
    + [(1, [-1, 0, 0, F(1, 2), 2, 2, 3]), (2, KNOTS), (3, [-1, 0, 0, F(1, 2), 2, 2, 3]), (3, KNOTS)],
)
def test_with_a_symbol_in_a_span_the_basis_is_that_of_sympy(p, knots):
    count = len(knots) - p - 1
    for k in (k for k in range(len(knots) - 1) if knots[k] < knots[k + 1]):
        got = basis(knots, p, x, span=k)
        middle = sympy.Rational(knots[k] + knots[k + 1]) / 2
        for i in range(count):
            pieces = sympy.bspline_basis(p, tuple(sympy.Rational(s) for s in knots), i, x)
            piece = next(e for e, where in pieces.args if bool(where.subs(x, middle)))
            assert sympy.expand(got[i] - piece) == 0


@pytest.mark.parametrize("p", range(4))
def test_symbolic_points_and_parameter(p):
    knots = [F(k * k, 3) for k in range(p + 6)]
    points = list(sympy.symbols(f"b:{len(knots) - p - 1}"))
    for k in range(p, len(points)):
        weights = basis(knots, p, x, span=k)
        curve = evaluate(points, knots, x, span=k)
        assert sympy.expand(curve - weights.dot(points)) == 0
        assert sympy.expand(de_boor(points, knots, x, span=k)[-1][0] - curve) == 0
        assert sympy.expand(blossom(points, knots, k, *[x] * p) - curve) == 0
        for r in range(p + 2):
            assert sympy.expand(derivative(points, knots, x, r, span=k) - sympy.diff(curve, x, r)) == 0
        middle = (knots[k] + knots[k + 1]) / 2
        here = [sympy.expand(c) for c in (evaluate(points, knots, middle), curve.subs(x, middle))]
        assert here[0] == here[1]
    more, longer = insert(points, knots, F(7, 5) + knots[p])
    assert sympy.expand(evaluate(more, longer, knots[p]) - evaluate(points, knots, knots[p])) == 0
    segments, breaks = to_bezier(points, knots)
    assert sympy.expand(segments[0, 0] - evaluate(points, knots, breaks[0])) == 0


def test_a_given_span_continues_its_polynomial():
    for k, t in product(range(2, 6), (-3, 0, F(5, 2), 9)):
        samples = [KNOTS[k] + F(j, 4) for j in range(3)]
        rows = [value(POINTS, KNOTS, s) for s in samples]
        by_lagrange = sum(
            rows[i] * sympy.prod([F(t - samples[j]) / (samples[i] - samples[j]) for j in range(3) if j != i])
            for i in range(3)
        )
        assert evaluate(POINTS, KNOTS, t, span=k) == by_lagrange
        assert sum(basis(KNOTS, 2, t, span=k)) == 1
    assert evaluate(POINTS, KNOTS, [0, 1], span=3).tolist() == [-2, 3]


def test_irrational_numbers_are_points_and_parameters():
    root = sympy.sqrt(2)
    got = evaluate([0, root, 4, 0, 4, 2], KNOTS, root)
    assert sympy.expand(got - evaluate([0, root, 4, 0, 4, 2], KNOTS, x, span=3).subs(x, root)) == 0
    assert span(KNOTS, 2, root) == 3
    assert evaluate(POINTS, list(map(sympy.Integer, KNOTS)), sympy.Rational(3, 2)) == sympy.Rational(13, 4)


def test_the_module_is_at_hand():
    assert numeric.bspline is bspline
