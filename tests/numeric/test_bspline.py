"""B-splines on exact numbers: the cases of the transcript by hand, and the laws against the recursion."""

from fractions import Fraction as F
from itertools import pairwise, permutations
from math import comb

import numpy as np
import pytest
from bspline_oracle import JUMP, KNOTS, POINTS, exact, places, slope, splines, value, weights
from hypothesis import given, settings
from hypothesis import strategies as st
from numeric_oracle import few_fractions

from bezteach import numeric
from bezteach.examples import EXAMPLES
from bezteach.numeric.bspline import (
    averages,
    basis,
    blossom,
    clamped,
    de_boor,
    derivative,
    evaluate,
    insert,
    multiplicities,
    span,
    to_bezier,
    uniform,
)

law = settings(deadline=None, max_examples=25, database=None)

# The transcript's cases, by hand


def test_the_knots_of_the_transcript():
    printed = {name: EXAMPLES[f"transcript/{name}"] for name in ("clamped-knots", "uniform-knots", "bezier-knots")}
    assert tuple(clamped(6, 2)) == (0, 0, 0, 1, 2, 3, 4, 4, 4) == printed["clamped-knots"].printed["knots"]
    assert tuple(clamped(4, 3)) == (0, 0, 0, 0, 1, 1, 1, 1) == printed["bezier-knots"].printed["knots"]
    for count, degree in ((5, 0), (4, 1), (3, 2)):
        assert tuple(uniform(count, degree)) == (0, 1, 2, 3, 4, 5) == printed["uniform-knots"].printed["knots"]
    assert [clamped(3, 0).tolist(), clamped(3, 1).tolist()] == [[0, 1, 2, 3], [0, 0, 1, 2, 2]]
    assert all(type(k) is int for k in [*clamped(6, 2), *uniform(6, 2)])


def test_degree_0_is_a_staircase_and_degree_1_the_polygon():
    assert evaluate([5, 7, 9], uniform(3, 0), [0, F(1, 2), 1, F(5, 2), 3]).tolist() == [5, 5, 7, 9, 9]
    assert basis([0, 1, 2], 0, [0, 1, 2]).tolist() == [[1, 0], [0, 1], [0, 1]]
    assert evaluate([5, 7, 1], clamped(3, 1), [0, F(1, 2), 1, F(7, 4), 2]).tolist() == [5, 6, 7, F(5, 2), 1]


def test_the_quadratic_of_six_points():
    assert basis(KNOTS, 2, F(3, 2)).tolist() == [0, F(1, 8), F(3, 4), F(1, 8), 0, 0]
    assert basis(KNOTS, 2, F(1, 2)).tolist() == [F(1, 4), F(5, 8), F(1, 8), 0, 0, 0]
    assert evaluate(POINTS, KNOTS, [0, 1, F(3, 2), 4]).tolist() == [0, 3, F(13, 4), 2]
    assert derivative(POINTS, KNOTS, [0, 1, 4]).tolist() == [4, 2, -4]
    assert derivative(POINTS, KNOTS, [0, 1, 4], 2).tolist() == [-2, -6, -8]
    assert span(KNOTS, 2, [0, F(1, 2), 1, F(7, 2), 4]).tolist() == [2, 2, 3, 5, 5]
    assert exact(averages(KNOTS, 2)) == [0, F(1, 2), F(3, 2), F(5, 2), F(7, 2), 4]


def test_the_uniform_cubic_has_the_weights_of_the_textbooks():
    at_knots, between = basis(uniform(4, 3), 3, [3, F(7, 2)]).tolist()
    assert at_knots == [F(1, 6), F(2, 3), F(1, 6), 0]
    assert between == [F(1, 48), F(23, 48), F(23, 48), F(1, 48)]
    # one whole bump, from end to end of its support
    assert basis([0, 1, 2, 3], 2, [0, F(1, 2), 1, F(3, 2), 2, 3]).ravel().tolist() == [
        *(0, F(1, 8), F(1, 2), F(3, 4), F(1, 2), 0)
    ]


def test_fewer_b_splines_than_a_domain_needs():
    assert basis([0, 0, 0, 1], 2, [0, F(1, 2), 1]).tolist() == [[1], [F(1, 4)], [0]]
    assert basis([0, 1, 1, 1], 2, [0, F(1, 2), 1]).tolist() == [[0], [F(1, 4)], [1]]
    assert basis([0, 1, 1, 2], 1, [F(1, 2), 1, F(3, 2)]).tolist() == [[F(1, 2), 0], [0, 1], [0, F(1, 2)]]


def test_de_boors_triangle_by_hand():
    assert [level.tolist() for level in de_boor(POINTS, KNOTS, F(3, 2))] == [[2, 4, 0], [F(7, 2), 3], [F(13, 4)]]
    assert [level.tolist() for level in de_boor(POINTS, KNOTS, 4)] == [[0, 4, 2], [4, 2], [2]]


def test_insertion_by_hand():
    points, knots = insert(POINTS, KNOTS, F(3, 2))
    assert points.tolist() == [0, 2, F(7, 2), 3, 0, 4, 2]
    assert knots.tolist() == [0, 0, 0, 1, F(3, 2), 2, 3, 4, 4, 4]
    points, knots = insert(POINTS, KNOTS, 2, 2)
    assert points.tolist() == [
        0,
        2,
        4,
        2,
        2,
        0,
        4,
        2,
    ]  # level 1 is 4, 2 and p(2) = 2; a third 2 in a row is a jump of 0
    assert knots.tolist() == [0, 0, 0, 1, 2, 2, 2, 3, 4, 4, 4]


def test_a_knot_of_multiplicity_p_plus_1_is_a_jump():
    knots, points = JUMP
    assert evaluate(points, knots, [0, F(1, 2), 1, 2, 3]).tolist() == [0, 1, 5, 6, 7]
    assert derivative(points, knots, [0, 1, 3]).tolist() == [2, 1, 1]
    segments, breaks = to_bezier(points, knots)
    assert (segments.tolist(), breaks.tolist()) == ([[0, 2], [5, 7]], [0, 1, 3])
    assert basis(knots, 1, 1).tolist() == [0, 0, 1, 0]
    assert value(points, knots, 1) == 5


def test_corners_of_the_curve_at_multiple_knots():
    """A knot that stands p times is a control point of the curve, and its derivative may turn there."""
    points, knots = [0, 3, 6, 0, 0], [0, 0, 0, 1, 1, 2, 2, 2]
    assert evaluate(points, knots, 1) == 6 and derivative(points, knots, 1) == -12
    assert derivative(points, knots, 1, span=2) == 6
    assert [v.tolist() for v in multiplicities(knots)] == [[0, 1, 2], [3, 2, 3]]


# Against the recursion


@law
@given(splines())
def test_values_basis_and_derivatives_are_those_of_the_recursion(spline):
    points, knots = spline
    p, t = len(knots) - len(points) - 1, places(knots, len(points))
    assert exact(evaluate(points, knots, t)) == [value(points, knots, s) for s in t]
    end = knots[len(points)]
    rows = [weights(knots, p, s, s == end) for s in t]
    assert exact(basis(knots, p, t)) == rows
    assert exact(span(knots, p, t)) == [
        max(k for k in range(len(knots)) if (knots[k] < s if s == end else knots[k] <= s)) for s in t
    ]
    for s in t[:: max(1, len(t) // 4)] + [end]:
        for r in range(p + 2):
            assert derivative(points, knots, s, r) == slope(points, knots, s, r)
        levels = de_boor(points, knots, s)
        assert [len(level) for level in levels] == list(range(p + 1, 0, -1))
        assert levels[-1] == value(points, knots, s)


@law
@given(splines())
def test_the_basis_is_positive_local_and_sums_to_1_on_the_domain(spline):
    points, knots = spline
    count, p = len(points), len(knots) - len(points) - 1
    inner = sorted(set(knots))
    t = inner + [(a + b) / 2 for a, b in pairwise(inner)]
    for s, row in zip(t, basis(knots, p, t).tolist(), strict=True):
        left = s in (knots[count], knots[-1])
        assert row == weights(knots, p, s, left)
        assert min(row) >= 0 and sum(row) <= 1
        assert all(n == 0 or knots[i] <= s <= knots[i + p + 1] for i, n in enumerate(row))
        if knots[p] <= s <= knots[count]:
            assert sum(row) == 1


@law
@given(splines(), st.data())
def test_insertion_leaves_the_curve_as_it_is(spline, data):
    points, knots = spline
    p, t = len(knots) - len(points) - 1, places(knots, len(points))
    new = data.draw(st.sampled_from(t))
    times = data.draw(st.integers(0, p + 1 - knots.count(new)))
    more, longer = insert(points, knots, new, times)
    assert longer.tolist() == sorted(knots + [new] * times)
    assert len(more) == len(points) + times
    assert exact(evaluate(more, longer, t)) == [value(points, knots, s) for s in t]
    assert exact(derivative(more, longer, t)) == exact(derivative(points, knots, t))
    if p and longer.tolist().count(new) >= p and new != knots[len(points)]:
        k = span(longer, p, new)
        assert more[k - p] == value(points, knots, new)
    one_by_one = points, knots
    for _ in range(times):
        one_by_one = insert(*one_by_one, new)
    assert exact(one_by_one[0]) == exact(more)


@law
@given(splines())
def test_clamping_by_insertion_and_splitting(spline):
    """The ends of the domain may be inserted too; then the curve starts and ends at control points."""
    points, knots = spline
    p, a, b = len(knots) - len(points) - 1, knots[len(knots) - len(points) - 1], knots[len(points)]
    more, longer = insert(points, knots, a, p + 1 - knots.count(a))
    more, longer = insert(more, longer, b, p + 1 - knots.count(b))
    first, last = longer.tolist().index(a), longer.tolist().index(b)
    t = places(knots, len(points))
    inner, ends = more[first:last], longer[first : last + p + 1]
    assert exact(evaluate(inner, ends, t)) == [value(points, knots, s) for s in t]
    assert [inner[0], inner[-1]] == [value(points, knots, a), value(points, knots, b)]


@law
@given(splines())
def test_bezier_segments_join_and_are_the_curve(spline):
    points, knots = spline
    p = len(knots) - len(points) - 1
    segments, breaks = to_bezier(points, knots)
    assert breaks.tolist() == sorted(set(knots[p : len(points) + 1]))
    assert segments.shape == (len(breaks) - 1, p + 1)
    for segment, (a, b) in zip(segments, pairwise(breaks), strict=True):
        for w in (0, F(1, 3), F(1, 2), F(6, 7)):
            t = a + (b - a) * w
            bezier = sum(comb(p, i) * w**i * (1 - w) ** (p - i) * c for i, c in enumerate(segment))
            assert bezier == value(points, knots, t)
        assert segment[-1] == value(points, knots, b, left=True)
    for left, right, knot in zip(segments, segments[1:], breaks[1:], strict=False):
        assert knots.count(knot) == p + 1 or left[-1] == right[0]


@law
@given(splines(least=1, full=False))
def test_continuity_is_degree_minus_multiplicity(spline):
    points, knots = spline
    p = len(knots) - len(points) - 1
    for knot in sorted(set(knots[p + 1 : len(points)]) - {knots[p], knots[len(points)]}):
        after = span(knots, p, knot)
        before = int(np.flatnonzero(np.array(knots) < knot)[-1])
        for r in range(p - knots.count(knot) + 1):
            assert derivative(points, knots, knot, r, before) == derivative(points, knots, knot, r, after)


@law
@given(splines(), few_fractions(-3, 3, 4), few_fractions(-3, 3, 4))
def test_an_affine_map_of_points_or_of_knots(spline, a, b):
    points, knots = spline
    t = places(knots, len(points))
    moved = [a * c + b for c in points]
    assert exact(evaluate(moved, knots, t)) == [a * c + b for c in evaluate(points, knots, t)]
    scale = abs(a) + F(1, 2)
    faster, s = [scale * k + b for k in knots], [scale * k + b for k in t]
    assert exact(evaluate(points, faster, s)) == exact(evaluate(points, knots, t))
    assert exact(derivative(points, faster, s)) == [c / scale for c in derivative(points, knots, t)]


@law
@given(splines(least=1))
def test_linear_precision_and_differentiation_by_hand(spline):
    """The averages are the points of x(t) = t; the derivative has the points p (b_i - b_{i-1}) / (t_{i+p} - t_i)."""
    points, knots = spline
    count, p, t = len(points), len(knots) - len(points) - 1, places(knots, len(points))
    means = averages(knots, p)
    assert exact(means) == [sum(knots[i + 1 : i + p + 1], F(0)) / p for i in range(count)]
    assert exact(evaluate(means, knots, t)) == t
    if all(knots[i] < knots[i + p] for i in range(1, count)):
        edges = [p * (points[i] - points[i - 1]) / (knots[i + p] - knots[i]) for i in range(1, count)]
        assert exact(derivative(points, knots, t)) == exact(evaluate(edges, knots[1:-1], t))


@law
@given(splines(most=3), st.data())
def test_the_blossom_is_symmetric_affine_and_holds_the_control_points(spline, data):
    points, knots = spline
    count, p = len(points), len(knots) - len(points) - 1
    k = data.draw(st.sampled_from([k for k in range(p, count) if knots[k] < knots[k + 1]]))
    some = few_fractions(-3, 3, 2)
    u = [data.draw(some) for _ in range(p)]
    assert len({blossom(points, knots, k, *v) for v in permutations(u)}) == 1
    for i in range(k - p, k + 1):
        assert blossom(points, knots, k, *knots[i + 1 : i + p + 1]) == points[i]
    assert blossom(points, knots, k, *[u[0]] * p if p else []) == evaluate(points, knots, u[0] if p else 0, k)
    if p:
        v, w = data.draw(some), data.draw(some)
        ends = [blossom(points, knots, k, c, *u[1:]) for c in (u[0], v)]
        assert blossom(points, knots, k, (1 - w) * u[0] + w * v, *u[1:]) == (1 - w) * ends[0] + w * ends[1]
    (corners, breaks) = to_bezier(points, knots)
    a, b = knots[k], knots[k + 1]
    (piece,) = corners[breaks[:-1] == a]
    assert exact(piece) == [blossom(points, knots, k, *[a] * (p - j), *[b] * j) for j in range(p + 1)]


@pytest.mark.parametrize("n", range(7))
def test_knots_0_and_1_make_a_bezier_curve(n):
    points = [[F(i * i - 3, 2), F((-1) ** i * i)] for i in range(n + 1)]
    knots, t = clamped(n + 1, n), [0, F(1, 7), F(1, 2), 1]
    assert exact(basis(knots, n, t)) == exact(numeric.bernstein(n, t))
    assert exact(evaluate(points, knots, t)) == exact(numeric.evaluate(points, t))
    for r in range(n + 2):
        assert exact(derivative(points, knots, t, r)) == exact(numeric.derivative(points, t, r))
    segments, breaks = to_bezier(points, knots)
    assert (exact(segments), exact(breaks)) == ([points], [0, 1])
    for level, other in zip(de_boor(points, knots, F(1, 3)), numeric.de_casteljau(points, F(1, 3)), strict=True):
        assert exact(level) == exact(other)
    more, longer = insert(points, knots, F(1, 3), n + 1)
    left, right = numeric.split(points, F(1, 3))
    assert exact(more) == exact([*left, *right]) and multiplicities(longer)[1].tolist() == [n + 1] * 3


def test_a_large_curve():
    count, p = 400, 3
    knots = clamped(count, p)
    points = [[F(i * i % 17), F(-i % 5)] for i in range(count)]
    t = [F(k * 397, 50) for k in range(51)]
    got = evaluate(points, knots, t)
    for s, row in list(zip(t, got.tolist(), strict=True))[::5]:
        assert row == [value([b[c] for b in points], knots.tolist(), s) for c in (0, 1)]
    segments, breaks = to_bezier(points, knots)
    assert segments.shape == (397, 4, 2) and breaks.tolist() == list(range(398))
    assert (segments[1:, 0] == segments[:-1, 3]).all()
