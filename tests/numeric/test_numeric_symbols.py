"""Run on SymPy symbols every function gives the right polynomial, derived here from the definition by SymPy alone."""

from fractions import Fraction as F

import pytest
import sympy
from sympy import Rational, binomial, diff, expand, symbols

from bezteach.numeric import (
    bernstein,
    curvature,
    de_casteljau,
    derivative,
    elevate,
    evaluate,
    evaluate_accurate,
    from_power,
    hodograph,
    segment,
    split,
    subdivide,
    to_power,
)

t, u, a, b = symbols("t u a b")
degrees = pytest.mark.parametrize("n", range(7))


def points(n, d=2):
    return [list(symbols(f"x{i} y{i} z{i}")[:d]) for i in range(n + 1)]


def curve(rows, s):
    n = len(rows) - 1
    weights = [binomial(n, i) * s**i * (1 - s) ** (n - i) for i in range(n + 1)]
    return [sum(w * row[c] for w, row in zip(weights, rows, strict=True)) for c in range(len(rows[0]))]


def same(left, right):
    assert len(left) == len(right)
    assert all(expand(x - y) == 0 for x, y in zip(left, right, strict=True))


@degrees
def test_basis_and_values(n):
    b_ = points(n)
    same(bernstein(n, t).tolist(), [binomial(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)])
    same(evaluate(b_, t).tolist(), curve(b_, t))
    same(de_casteljau(b_, t)[-1][0].tolist(), curve(b_, t))
    same(evaluate(b_, [t, F(1, 3)])[1].tolist(), curve(b_, Rational(1, 3)))
    # nested fractions, which SymPy is slow to cancel: compared as expressions in the points at several t
    quick = evaluate_accurate(b_, t).tolist()
    for s in (Rational(k, 7) for k in range(-3, 12)):
        same([x.subs(t, s) for x in quick], curve(b_, s))


@degrees
def test_parts(n):
    b_ = points(n)
    same(curve(segment(b_, a, b).tolist(), u), curve(b_, a + (b - a) * u))
    left, right = split(b_, t)
    same(curve(left.tolist(), u), curve(b_, t * u))
    same(curve(right.tolist(), u), curve(b_, 1 - (1 - t) * (1 - u)))
    for k, part in enumerate(subdivide(b_, 1).tolist()):
        same(curve(part, u), curve(b_, (k + u) / 2))


@degrees
def test_derivatives_and_forms(n):
    b_ = points(n)
    for r in range(n + 2):
        expected = [diff(x, t, r) for x in curve(b_, t)]
        same(curve(hodograph(b_, r).tolist(), t), expected)
        same(derivative(b_, t, r).tolist(), expected)
        same(curve(elevate(b_, r).tolist(), t), curve(b_, t))
    same([sum(c * t**k for k, c in enumerate(x)) for x in to_power(b_).T], curve(b_, t))
    same(curve(from_power(b_).tolist(), t), [sum(c * t**k for k, c in enumerate(x)) for x in zip(*b_, strict=True)])


@pytest.mark.parametrize("n", range(1, 5))
def test_curvature_is_the_formula(n):
    b_ = points(n)
    (x, y), (xx, yy) = ([diff(c, t, r) for c in curve(b_, t)] for r in (1, 2))
    got = curvature(b_, t)
    assert isinstance(got, sympy.Expr)
    assert expand(got * (derivative(b_, t) ** 2).sum() ** Rational(3, 2) - (x * yy - y * xx)) == 0


def test_curvature_of_symbols_in_space_and_of_mixtures():
    c = [[0, 0, 0], [1, 0, 2], list(symbols("x y z"))]
    first, second = (sympy.Matrix([diff(x, t, r) for x in curve(c, t)]) for r in (1, 2))
    got, normal = curvature(c, t), first.cross(second)
    assert expand((got * derivative(c, t).dot(derivative(c, t)) ** Rational(3, 2)) ** 2 - normal.dot(normal)) == 0
    x = symbols("x", positive=True)
    both = curvature([[[1, 0], [1, 1], [0, 1]], [[x, 0], [x, x], [0, x]]], 0)
    assert both[0] == Rational(1, 2) and sympy.simplify(both[1] - 1 / (2 * x)) == 0
    assert all(isinstance(k, sympy.Expr) for k in both)
    assert curvature([[0, 0], [1, 0], [1, sympy.sqrt(2)]], 0) == sympy.sqrt(2) / 2
