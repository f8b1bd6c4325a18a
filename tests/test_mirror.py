"""The heart of the project: numeric functions, run on symbols, return exactly the formulas that ``symbolic`` derived.

One algorithm serves floats, fractions and symbols; ``symbolic`` comes to its formulas by the operator form. So a row of
the table holds two independent answers to one question, compared as polynomials for degrees 0 to 6. ``sample`` and
``flatten`` are left out: the numbers of points they choose have no formula.
"""

import numpy as np
import pytest
from sympy import QQ, IndexedBase, Mul, Rational, expand, symbols, sympify

from bezteach import numeric, symbolic
from bezteach.numeric import bspline as arrays
from bezteach.symbolic import B, b, t
from bezteach.symbolic import bspline as derived

start, end = symbols("start end", real=True)
x, y, z = map(IndexedBase, "xyz")
a = IndexedBase("a")


def row(base, n):
    """The n + 1 symbols of one coordinate."""
    return [base[i] for i in range(n + 1)]


def indices(n):
    return range(n + 1)


# function: (what the numeric module makes of symbols, what the symbolic module derived), both for degree n
MIRROR = {
    "bernstein": (
        lambda n: numeric.bernstein(n, t),
        lambda n: [B(i, n, t).doit() for i in indices(n)],
    ),
    "evaluate": (
        lambda n: numeric.evaluate(row(b, n), t),
        lambda n: symbolic.curve(n, t),
    ),
    "de_casteljau": (
        lambda n: [point for level in numeric.de_casteljau(row(b, n), t) for point in level],
        lambda n: [symbolic.de_casteljau(k, j, t) for k in indices(n) for j in range(n + 1 - k)],
    ),
    "split": (
        lambda n: numeric.split(row(b, n), t),
        lambda n: [[symbolic.segment(n, j, *part) for j in indices(n)] for part in ((0, t), (t, 1))],
    ),
    "segment": (
        lambda n: numeric.segment(row(b, n), start, end),
        lambda n: [symbolic.segment(n, j, start, end) for j in indices(n)],
    ),
    "hodograph": (
        lambda n: numeric.hodograph(row(b, n)),
        lambda n: [symbolic.hodograph(n, 1, j) for j in range(max(n, 1))],
    ),
    "second hodograph": (
        lambda n: numeric.hodograph(row(b, n), 2),
        lambda n: [symbolic.hodograph(n, 2, j) for j in range(max(n - 1, 1))],
    ),
    "derivative": (
        lambda n: [numeric.derivative(row(b, n), t, r) for r in range(n + 2)],
        lambda n: [symbolic.derivative(n, t, r) for r in range(n + 2)],
    ),
    "derivative at the ends": (
        lambda n: [numeric.derivative(row(b, n), at, r) for at in (0, 1) for r in range(n + 2)],
        lambda n: [symbolic.end_derivative(n, r, at) for at in (0, 1) for r in range(n + 2)],
    ),
    "elevate": (
        lambda n: numeric.elevate(row(b, n)),
        lambda n: [symbolic.elevate(n, j) for j in range(n + 2)],
    ),
    "elevate three times": (
        lambda n: numeric.elevate(row(b, n), 3),
        lambda n: [symbolic.elevate(n, j, 3) for j in range(n + 4)],
    ),
    "to_power": (
        lambda n: numeric.to_power(row(b, n)),
        lambda n: [symbolic.to_power(n, k) for k in indices(n)],
    ),
    "from_power": (
        lambda n: numeric.from_power(row(a, n)),
        lambda n: [symbolic.from_power(n, j) for j in indices(n)],
    ),
    "basis_matrix": (
        lambda n: numeric.to_power(np.eye(n + 1, dtype=int)),
        lambda n: symbolic.basis_matrix(n),
    ),
    "power_matrix": (
        lambda n: numeric.from_power(np.eye(n + 1, dtype=int)),
        lambda n: symbolic.power_matrix(n),
    ),
    "subdivide": (
        lambda n: numeric.subdivide(row(b, n), 2),
        lambda n: [
            [symbolic.segment(n, j, Rational(piece, 4), Rational(piece + 1, 4)) for j in indices(n)]
            for piece in range(4)
        ],
    ),
}


def expanded(answer):
    return [expand(part) for part in np.asarray(answer, dtype=object).ravel()]


@pytest.mark.parametrize("name", MIRROR)
@pytest.mark.parametrize("n", range(7))
def test_numeric_on_symbols_is_the_symbolic_formula(name, n):
    numeric_answer, symbolic_answer = MIRROR[name]
    assert expanded(numeric_answer(n)) == expanded(symbolic_answer(n))


# knots of degree p: simple, then multiple ones; the span is the number beside them
SPANS = {
    "simple": (lambda p: [Rational(j * j + j, 3) for j in range(2 * p + 3)], lambda p: p + 1),
    "multiple": (lambda p: [0] * p + [2] + [5] * p + [9] * (p + 1), lambda p: 2 * p),
    "clamped": (lambda p: [0] * (p + 1) + [1] * (p + 1), lambda p: p),
}
u = symbols("u1:5", real=True)


def piece_sum(p, knots, k):
    """The polynomial of span k: the symbols b[i] weighted by the derived pieces."""
    return sum(derived.piece(i, p, knots, t, k) * b[i] for i in range(k - p, k + 1))


def with_knot(p, knots, k, at):
    """The control points after one knot more in span k, each the blossom of that span at its new knots."""
    longer = [*knots[: k + 1], at, *knots[k + 1 :]]
    count = len(knots) - p - 1
    new = [derived.blossom(p, knots, k, longer[i + 1 : i + p + 1]) for i in range(k - p + 1, k + 1)]
    return [b[i] for i in range(k - p + 1)] + new + [b[i] for i in range(k, count)]


def bezier_points(p, knots):
    """The blossom of each span at its two ends."""
    count = len(knots) - p - 1
    spans = [k for k in range(p, count) if knots[k] != knots[k + 1]]
    ends = [[knots[k]] * (p - j) + [knots[k + 1]] * j for k in spans for j in range(p + 1)]
    return [derived.blossom(p, knots, k, ends.pop(0)) for k in spans for _ in range(p + 1)]


# the same table for B-splines: both for degree p, the knots and one of their spans
SPLINES = {
    "basis": (
        lambda p, knots, k: arrays.basis(knots, p, t, k),
        lambda p, knots, k: [derived.piece(i, p, knots, t, k) for i in range(len(knots) - p - 1)],
    ),
    "evaluate": (
        lambda p, knots, k: arrays.evaluate(row(b, len(knots) - p - 2), knots, t, k),
        piece_sum,
    ),
    "derivative": (
        lambda p, knots, k: arrays.derivative(row(b, len(knots) - p - 2), knots, t, 1, k),
        lambda p, knots, k: sum(derived.derivative_piece(i, p, knots, t, k) * b[i] for i in range(k - p, k + 1)),
    ),
    "de_boor": (
        lambda p, knots, k: arrays.de_boor(row(b, len(knots) - p - 2), knots, t, k)[-1],
        lambda p, knots, k: derived.blossom(p, knots, k, [t] * p),
    ),
    "blossom": (
        lambda p, knots, k: arrays.blossom(row(b, len(knots) - p - 2), knots, k, *u[:p]),
        lambda p, knots, k: derived.polar(expand(piece_sum(p, knots, k)), p, t, u[:p]),
    ),
    "insert": (
        lambda p, knots, k: arrays.insert(row(b, len(knots) - p - 2), knots, (knots[k] + knots[k + 1]) / Rational(2))[
            0
        ],
        lambda p, knots, k: with_knot(p, knots, k, (knots[k] + knots[k + 1]) / Rational(2)),
    ),
    "to_bezier": (
        lambda p, knots, k: arrays.to_bezier(row(b, len(knots) - p - 2), knots)[0],
        lambda p, knots, k: bezier_points(p, knots),
    ),
}


@pytest.mark.parametrize("name", SPLINES)
@pytest.mark.parametrize("kind", SPANS)
@pytest.mark.parametrize("p", range(1, 5))
def test_numeric_b_splines_on_symbols_are_the_symbolic_formula(name, kind, p):
    knots, span = (made(p) for made in SPANS[kind])
    numeric_answer, symbolic_answer = SPLINES[name]
    assert expanded(numeric_answer(p, knots, span)) == expanded(symbolic_answer(p, knots, span))


@pytest.mark.parametrize("n", range(7))
def test_evaluate_accurate_divides_and_still_returns_the_basis(n):
    """On the unit points its coordinates are the basis functions, as rational functions that cancel to polynomials."""
    rational_functions = QQ.frac_field(t)
    answer = [
        rational_functions.from_sympy(sympify(value))
        for value in numeric.evaluate_accurate(np.eye(n + 1, dtype=int), t)
    ]
    assert answer == [rational_functions.from_sympy(B(i, n, t).doit()) for i in indices(n)]


@pytest.mark.parametrize("coordinates", [(x, y), (x, y, z)])
@pytest.mark.parametrize("n", range(1, 7))
def test_curvature_is_the_same_quotient(coordinates, n):
    """All coordinates are numbers but two: with more, the squares under the root fill the time of the test."""
    numbers = {c[i]: Rational((-1) ** i * (i + k), k + 2) for k, c in enumerate(coordinates) for i in indices(n)}
    del numbers[x[0]], numbers[y[n]]
    points = [[numbers.get(c[i], c[i]) for c in coordinates] for i in indices(n)]
    answer = numeric.curvature(points, t)
    derived = symbolic.curvature(n, t, len(coordinates)).subs(numbers)
    assert parted(answer) == parted(derived)


def parted(quotient):
    """Its roots with what stands under them expanded, and its polynomial part expanded."""
    factors = Mul.make_args(quotient)
    roots = {expand(factor.base) ** factor.exp for factor in factors if factor.is_Pow and not factor.exp.is_Integer}
    rest = expand(Mul(*[factor for factor in factors if not (factor.is_Pow and not factor.exp.is_Integer)]))
    return (roots, rest) if rest != 0 else (set(), 0)
