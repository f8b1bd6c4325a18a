"""The sources' examples as they print them, and the laws of Bézier curves, all in exact arithmetic."""

from fractions import Fraction as F

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numeric_oracle import few_fractions, powers, slope, value, weight

from bezteach.numeric import (
    bernstein,
    curvature,
    de_casteljau,
    derivative,
    elevate,
    evaluate,
    evaluate_accurate,
    flatten,
    from_power,
    hodograph,
    sample,
    segment,
    split,
    subdivide,
    to_power,
)

DECK = [[0, 0], [1, 3], [2, 1], [3, 3]]
ARCH = [[-9, 0], [-3, 6], [3, 6], [9, 0]]

law = settings(deadline=None, max_examples=25, database=None)
numbers = few_fractions(-5, 5, 7)
parameters = few_fractions(-1, 2, 9)
inside = few_fractions(0, 1, 11)
curves = st.integers(1, 3).flatmap(
    lambda d: st.lists(st.lists(numbers, min_size=d, max_size=d), min_size=1, max_size=7)
)


# The slides


def test_triangle_of_the_deck_at_one_third():
    levels = de_casteljau(DECK, F(1, 3))
    assert [level.tolist() for level in levels] == [
        DECK,
        [[F(1, 3), 1], [F(4, 3), F(7, 3)], [F(7, 3), F(5, 3)]],
        [[F(2, 3), F(13, 9)], [F(5, 3), F(19, 9)]],
        [[1, F(5, 3)]],
    ]


def test_split_of_the_deck_at_one_third():
    left, right = split(DECK, F(1, 3))
    assert left.tolist() == [[0, 0], [F(1, 3), 1], [F(2, 3), F(13, 9)], [1, F(5, 3)]]
    assert right.tolist() == [[1, F(5, 3)], [F(5, 3), F(19, 9)], [F(7, 3), F(5, 3)], [3, 3]]


def test_part_of_the_deck_between_one_and_three_quarters():
    part = [[F(-9, 2), F(27, 8)], [F(-3, 2), F(39, 8)], [F(3, 2), F(39, 8)], [F(9, 2), F(27, 8)]]
    assert segment(ARCH, F(1, 4), F(3, 4)).tolist() == part
    first, _ = split(ARCH, F(3, 4))
    assert first.tolist() == [[-9, 0], [F(-9, 2), F(9, 2)], [0, F(45, 8)], [F(9, 2), F(27, 8)]]
    assert de_casteljau(first, F(1, 3))[2].tolist() == [[-6, F(21, 8)], [F(-3, 2), F(39, 8)]]
    assert split(first, F(1, 3))[1].tolist() == part


def test_small_cases_written_out():
    assert bernstein(3, F(1, 2)).tolist() == [F(1, 8), F(3, 8), F(3, 8), F(1, 8)]
    assert bernstein(2, 3).tolist() == [4, -12, 9]
    assert evaluate(DECK, F(1, 3)).tolist() == evaluate_accurate(DECK, F(1, 3)).tolist() == [1, F(5, 3)]
    assert evaluate(DECK, 2).tolist() == [6, 30]
    assert sample(DECK, 3).tolist() == [[0, 0], [F(3, 2), F(15, 8)], [3, 3]]
    assert hodograph(DECK).tolist() == [[3, 9], [3, -6], [3, 6]]
    assert hodograph(DECK, 2).tolist() == [[0, -30], [0, 24]]
    assert hodograph(DECK, 3).tolist() == [[0, 54]]
    assert hodograph(DECK, 4).tolist() == [[0, 0]]
    assert derivative(DECK, 1).tolist() == [3, 6]
    assert derivative(DECK, F(1, 2), 2).tolist() == [0, -3]
    assert to_power(DECK).tolist() == [[0, 0], [3, 9], [0, -15], [0, 9]]
    assert from_power([0, 1, 0, 0]).tolist() == [0, F(1, 3), F(2, 3), 1]
    assert elevate([0, 6]).tolist() == [0, 3, 6]
    assert elevate(DECK).tolist() == [[0, 0], [F(3, 4), F(9, 4)], [F(3, 2), 2], [F(9, 4), F(3, 2)], [3, 3]]
    assert elevate([0, 0, 6], 2).tolist() == [0, 0, 1, 3, 6]
    assert subdivide([0, 4, 0], 2).tolist() == [[0, 1, F(3, 2)], [F(3, 2), 2, 2], [2, 2, F(3, 2)], [F(3, 2), 1, 0]]
    assert flatten([0, 4, 0], F(1, 2)).tolist() == [0, 2, 0]
    assert flatten([0, 4, 0], F(2, 9)).tolist() == [0, F(16, 9), F(16, 9), 0]
    assert flatten([[0, 0], [1, 2]], F(1, 100)).tolist() == [[0, 0], [1, 2]]


def test_curvature_has_the_sign_of_the_turn_and_is_the_reciprocal_radius():
    left = [[1, 0], [1, 1], [0, 1]]
    assert curvature(left, 0) == 0.5 and curvature(left[::-1], 0) == -0.5
    assert curvature([[x, y, 0] for x, y in left[::-1]], 0) == 0.5
    # y = x^2 at 0 has radius 1/2; in space y = x^2 in the plane z = x
    assert curvature([[-1, 1], [0, -1], [1, 1]], F(1, 2)) == 2
    assert curvature([[-1, 1, -1], [0, -1, 0], [1, 1, 1]], F(1, 2)) == 1
    # (n-1)/n |edge x edge| / |edge|^3 at both ends
    assert curvature(ARCH, [0, 1]) == pytest.approx([-2 / 3 * 36 / 72**1.5] * 2, rel=1e-15)


def test_one_large_case():
    points = [[F(i * i - 40 * i, 3), F((-1) ** i * i, 7)] for i in range(61)]
    t = F(2, 7)
    assert evaluate(points, t).tolist() == evaluate_accurate(points, t).tolist() == value(points, t)
    left, right = split(points, t)
    assert evaluate(left, F(1, 3)).tolist() == value(points, t / 3)
    assert evaluate(right, F(1, 3)).tolist() == value(points, t + (1 - t) / 3)
    assert from_power(to_power(points)).tolist() == points
    assert evaluate(elevate(points, 5), t).tolist() == value(points, t)
    assert derivative(points, t, 4).tolist() == slope(points, t, 4)


# The laws


@law
@given(st.integers(0, 9), parameters)
def test_basis_is_the_definition_and_sums_to_one(n, t):
    row = bernstein(n, t)
    assert row.tolist() == [weight(n, i, t) for i in range(n + 1)]
    assert row.sum() == 1 and (bernstein(n, 1 - t)[::-1] == row).all()


@law
@given(curves, parameters)
def test_value_is_the_definition_and_the_tip_of_the_triangle(points, t):
    assert evaluate(points, t).tolist() == value(points, t) == de_casteljau(points, t)[-1][0].tolist()


@law
@given(curves, inside)
def test_accurate_value_is_the_value(points, t):
    assert evaluate_accurate(points, t).tolist() == value(points, t)


@law
@given(curves, parameters)
def test_levels_are_curves_of_their_neighbours(points, t):
    for k, level in enumerate(de_casteljau(points, t)):
        assert level.tolist() == [value(points[j : j + k + 1], t) for j in range(len(points) - k)]


@law
@given(curves, parameters)
def test_split_is_the_two_edges_of_the_triangle(points, t):
    left, right = split(points, t)
    levels = de_casteljau(points, t)
    assert left.tolist() == [level[0].tolist() for level in levels]
    assert right.tolist() == [level[-1].tolist() for level in levels[::-1]]


@law
@given(curves, parameters, parameters, parameters)
def test_segment_runs_over_its_part(points, a, b, u):
    part = segment(points, a, b)
    assert part.shape == (len(points), len(points[0]))
    assert evaluate(part, u).tolist() == value(points, a + (b - a) * u)
    assert segment(points, b, a).tolist() == part.tolist()[::-1]
    assert segment(points, 0, 1).tolist() == points


@law
@given(curves, parameters, parameters, parameters, parameters)
def test_segment_of_a_segment(points, a, b, c, d):
    inner = segment(points, a + (b - a) * c, a + (b - a) * d)
    assert segment(segment(points, a, b), c, d).tolist() == inner.tolist()


@law
@given(curves, few_fractions(F(1, 9), 1, 9))
def test_split_pieces_rejoin(points, t):
    left, right = split(points, t)
    assert segment(left, 0, 1 / t).tolist() == points
    if t < 1:
        assert segment(right, -t / (1 - t), 1).tolist() == points


@law
@given(curves, st.integers(0, 3), parameters)
def test_subdivision_is_the_parts_in_order(points, depth, u):
    parts = subdivide(points, depth)
    assert parts.shape == (2**depth, len(points), len(points[0]))
    for k, part in enumerate(parts):
        assert evaluate(part, u).tolist() == value(points, (k + u) / 2**depth)


@law
@given(curves, st.integers(0, 8), parameters)
def test_derivative_is_that_of_the_polynomial(points, r, t):
    expected = slope(points, t, r)
    assert derivative(points, t, r).tolist() == expected
    control = hodograph(points, r)
    assert len(control) == max(1, len(points) - r)
    assert value(control.tolist(), t) == expected


@law
@given(curves, st.integers(0, 4))
def test_elevation_leaves_the_curve(points, r):
    higher = elevate(points, r)
    assert len(higher) == len(points) + r
    padded = powers(points) + [[0] * len(points[0])] * r
    assert powers(higher.tolist()) == padded
    assert elevate(elevate(points, r), 1).tolist() == elevate(points, r + 1).tolist()


@law
@given(curves)
def test_power_basis_and_back(points):
    assert to_power(points).tolist() == powers(points)
    assert from_power(to_power(points)).tolist() == points
    assert to_power(from_power(points)).tolist() == points


@law
@given(curves, parameters)
def test_reversal_and_affine_maps(points, t):
    assert evaluate(points[::-1], t).tolist() == evaluate(points, 1 - t).tolist()
    moved = [[3 * x - b[-1] + 2 for x in b] for b in points]
    p = value(points, t)
    assert evaluate(moved, t).tolist() == [3 * x - p[-1] + 2 for x in p]


@law
@given(st.integers(1, 8), parameters)
def test_linear_precision(n, t):
    assert evaluate([F(j, n) for j in range(n + 1)], t) == t


@law
@given(curves, st.integers(2, 9))
def test_sample_is_the_values_at_equal_steps(points, m):
    assert sample(points, m).tolist() == [value(points, F(i, m - 1)) for i in range(m)]


@law
@given(curves, st.fractions(F(1, 20), 2))
def test_polyline_is_within_the_tolerance(points, tolerance):
    line = flatten(points, tolerance)
    steps = len(line) - 1
    assert line.tolist() == sample(points, steps + 1).tolist()
    for i in range(steps):
        for u in (F(1, 3), F(1, 2)):
            p = value(points, (i + u) / steps)
            gap = [x - (1 - u) * a - u * b for x, a, b in zip(p, line[i], line[i + 1], strict=True)]
            assert sum(g * g for g in gap) <= tolerance**2
    # one step fewer is not promised by Wang's bound
    n = len(points) - 1
    bends = [sum((a - 2 * b + c) ** 2 for a, b, c in zip(*points[i : i + 3], strict=True)) for i in range(n - 1)]
    assert steps == 1 or F(n * (n - 1), 8) ** 2 * max(bends) > tolerance**2 * (steps - 1) ** 4


@law
@given(
    st.lists(st.lists(st.integers(-9, 9), min_size=2, max_size=2), min_size=2, max_size=5),
    few_fractions(0, 1, 5),
)
def test_curvature_squared_is_exact(points, t):
    (x, y), (xx, yy) = slope(points, t, 1), slope(points, t, 2)
    if x == y == 0:
        with pytest.raises(ValueError, match=rf"p'\(t\) = 0 at t = {t}"):
            curvature(points, t)
        return
    squared = (x * yy - y * xx) ** 2 / (x * x + y * y) ** 3
    got = curvature(points, t)
    assert abs(F(float(got)) ** 2 - squared) <= squared * F(1, 2**51)
    assert np.sign(got) == np.sign(x * yy - y * xx)
    lifted = [[*b, 0] for b in points]
    assert curvature(lifted, t) == abs(got)
