"""Rational curves: against the definition on lists of Fractions, on symbols, and on a circle."""

from fractions import Fraction as F

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from numeric_oracle import SMALL, few_fractions, weight

from bezteach.numeric import evaluate, rational

QUARTER = [(1, 0), (1, 1), (0, 1)]
ROUND = [1, 1, 2]
FACTORS = few_fractions(F(1, 3), 4, 3)
UNIT = few_fractions(0, 1, 7)

law = settings(deadline=None, max_examples=40, database=None)


@st.composite
def weighted(draw, factors=FACTORS):
    """Control points in the plane and a weight for each."""
    points = draw(st.lists(st.tuples(SMALL, SMALL), min_size=1, max_size=6))
    return points, draw(st.lists(factors, min_size=len(points), max_size=len(points)))


def quotient(points, weights, t):
    """The definition."""
    n = len(points) - 1
    shares = [w * weight(n, i, t) for i, w in enumerate(weights)]
    return [sum(share * b[c] for share, b in zip(shares, points, strict=True)) / sum(shares) for c in (0, 1)]


def test_written_out():
    assert rational.lift(QUARTER, ROUND).tolist() == [[1, 0, 1], [1, 1, 1], [0, 2, 2]]
    assert rational.evaluate(QUARTER, ROUND, F(1, 2)).tolist() == [F(3, 5), F(4, 5)]
    assert rational.evaluate(QUARTER, ROUND, [0, F(2, 3), 1]).tolist() == [[1, 0], [F(5, 13), F(12, 13)], [0, 1]]
    assert rational.evaluate([(0, 0), (2, 4), (4, 0)], [1, 3, 1], F(1, 2)).tolist() == [2, 3]
    assert rational.evaluate([0, 4, 0], [1, 3, 1], F(1, 2)) == 3
    assert rational.evaluate([0, 4, 0], [1, 3, 1], [[0, F(1, 2)]]).tolist() == [[0, 3]]
    assert rational.project([6, 12, 3]).tolist() == [2, 4]


@law
@given(weighted(), UNIT)
def test_it_is_the_quotient_of_the_definition(curve, t):
    points, weights = curve
    found = rational.evaluate(points, weights, t)
    assert found.tolist() == quotient(points, weights, t) and {type(x) for x in found} <= {int, F}


@law
@given(weighted(), UNIT, FACTORS)
def test_equal_weights_give_the_bezier_curve_and_a_common_factor_nothing(curve, t, factor):
    points, weights = curve
    assert rational.evaluate(points, [factor] * len(points), t).tolist() == evaluate(points, t).tolist()
    scaled = [-factor * w for w in weights]
    assert rational.evaluate(points, scaled, t).tolist() == rational.evaluate(points, weights, t).tolist()


@law
@given(weighted(), UNIT)
def test_lifted_and_projected_a_point_is_where_it_was(curve, t):
    points, weights = curve
    assert rational.project(rational.lift(points, weights)).tolist() == [list(b) for b in points]


@law
@given(weighted(), st.integers(0, 5), FACTORS, FACTORS)
def test_a_larger_weight_pulls_straight_towards_its_point(curve, place, more, at):
    (points, weights), t = curve, at / 5
    j = place % len(points)
    heavier = [w + more * (i == j) for i, w in enumerate(weights)]
    before, after = (quotient(points, some, t) for some in (weights, heavier))
    there, then = rational.evaluate(points, weights, t), rational.evaluate(points, heavier, t)
    assert [there.tolist(), then.tolist()] == [before, after]
    to_go, gone = np.array(points[j]) - there, then - there
    assert to_go[0] * gone[1] == to_go[1] * gone[0] and to_go @ gone >= 0
    assert (to_go - gone) @ (to_go - gone) <= to_go @ to_go


@law
@given(few_fractions(-3, 3, 12))
def test_the_quarter_is_on_the_circle_beyond_its_ends_too(t):
    x, y = rational.evaluate(QUARTER, ROUND, t)
    assert x * x + y * y == 1


def test_on_symbols_it_is_the_formula():
    t, w, a, b, c = sympy.symbols("t w a b c", real=True)
    found = rational.evaluate([a, b, c], [1, w, 2], t)
    above = a * (1 - t) ** 2 + 2 * w * b * t * (1 - t) + 2 * c * t**2
    below = (1 - t) ** 2 + 2 * w * t * (1 - t) + 2 * t**2
    assert sympy.simplify(found - above / below) == 0
    x, y = rational.evaluate(QUARTER, ROUND, t)
    assert [sympy.cancel(x - (1 - t**2) / (1 + t**2)), sympy.cancel(y - 2 * t / (1 + t**2))] == [0, 0]


def test_irrational_weights_are_exact():
    root = sympy.sqrt(2) / 2
    assert rational.on_unit_circle(QUARTER, [1, root, 1]) and not rational.on_unit_circle(QUARTER, [1, F(5, 7), 1])
    assert sympy.simplify(sum(x**2 for x in rational.evaluate(QUARTER, [1, root, 1], F(1, 3)))) == 1


@pytest.mark.parametrize(
    ("weights", "is_round"),
    [((1, 1, 2), True), ((2, 1, 1), True), ((3, 3, 6), True), ((1, -1, 2), True), ((2, 2, 4), True)]
    + [((1, 1, 1), False), ((1, 2, 2), False), ((1, 1, 3), False)],
)
def test_which_weights_make_the_quarter_round(weights, is_round):
    """For whole numbers: if 2 w_1^2 = w_0 w_2."""
    assert rational.on_unit_circle(QUARTER, weights) == is_round == (2 * weights[1] ** 2 == weights[0] * weights[2])


def test_what_touches_the_circle_often_is_not_on_it():
    assert not rational.on_unit_circle([(1, 0), (1, 1), (-1, 1), (-1, 0)], [1, 1, 1, 1])
    assert not rational.on_unit_circle([(1, 0), (1, F(11, 20)), (F(11, 20), 1), (0, 1)], [1] * 4)
    assert rational.on_unit_circle([(0, 1)] * 3, [1, 5, 2])  # a point


def test_floats_are_near():
    t = np.linspace(0, 1, 9)
    found = rational.evaluate(QUARTER, [1.0, 1.0, 2.0], t)
    assert found.dtype == float and found.shape == (9, 2)
    exact = [quotient(QUARTER, ROUND, F(k, 8)) for k in range(9)]
    assert np.abs(found - np.array(exact, dtype=float)).max() < 1e-15


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: rational.lift(QUARTER, [1, 1]), "3 control points and 2 weights"),
        (lambda: rational.lift([QUARTER], [1, 1, 2]), "no batch"),
        (lambda: rational.lift(QUARTER, [1, float("nan"), 2]), "weight w_1 .* nan"),
        (lambda: rational.lift(QUARTER, [1, None, 2]), "weight w_1 .* None"),
        (lambda: rational.lift([(1, 0), (1, float("inf")), (0, 1)], ROUND), "control point b_1 .* inf"),
        (lambda: rational.lift([(1e300, 0)], [1e300]), "too large for float64"),
        (lambda: rational.evaluate(QUARTER, [1, -1, 1], [0, F(1, 2)]), "at t = 1/2 the weights"),
        (lambda: rational.evaluate(QUARTER, [1.0, -1.0, 1.0], 0.5), "at t = 0.5 the weights"),
        (lambda: rational.evaluate(QUARTER, [0, 1, 1], 0), "at t = 0 the weights"),
        (lambda: rational.evaluate(QUARTER, ROUND, "1/2"), "parameter t"),
        (lambda: rational.project([(1, 1, 1), (1, 1, 0)]), "lifted point 1 has w = 0"),
        (lambda: rational.project([(1,), (1,)]), "a coordinate before its last one"),
        (lambda: rational.project(3), "a coordinate before its last one"),
        (lambda: rational.on_unit_circle([1, 0, 1], ROUND), "1 coordinates: a circle needs 2"),
    ],
)
def test_an_error_names_the_rule_and_the_offender(call, words):
    with pytest.raises(ValueError, match=words):
        call()
