"""Cubics through data points: the one-sixth rule and the natural spline."""

from fractions import Fraction as F
from itertools import pairwise

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from numeric_oracle import dot, slope, some_data, value, vectors
from scipy.interpolate import CubicSpline

from bezteach.numeric import hodograph
from bezteach.numeric.joins import catmull_rom, continuity, natural

law = settings(deadline=None, max_examples=30, database=None)
both_rules = pytest.mark.parametrize("rule", [catmull_rom, natural])


def joins_of(cubics):
    return [continuity(left, right) for left, right in pairwise(cubics)]


def test_small_splines_written_out():
    assert catmull_rom([0, 6, 6]).tolist() == [[0, 2, 5, 6], [6, 7, 6, 6]]
    assert natural([0, 6, 6]).tolist() == [[0, F(5, 2), 5, 6], [6, 7, F(13, 2), 6]]
    square = [[0, 0], [6, 0], [6, 6], [0, 6]]
    assert catmull_rom(square).tolist() == [
        [[0, 0], [2, 0], [5, -1], [6, 0]],
        [[6, 0], [7, 1], [7, 5], [6, 6]],
        [[6, 6], [5, 7], [2, 6], [0, 6]],
    ]
    assert natural([0, 0, 15, 0]).tolist() == [[0, -2, -4, 0], [0, 4, 14, 15], [15, 16, 8, 0]]


@both_rules
def test_two_points_are_joined_by_a_line_run_through_evenly(rule):
    assert rule([[0, 3], [3, 0]]).tolist() == [[[0, 3], [1, 2], [2, 1], [3, 0]]]


@both_rules
def test_a_symbol_at_each_point_gives_the_weights(rule):
    data = sympy.symbols("D0:6")
    weights = [rule(row) for row in np.eye(6, dtype=int)]
    for place, control in np.ndenumerate(rule(data)):
        assert sympy.expand(control - sum(w[place] * x for w, x in zip(weights, data, strict=True))) == 0


def test_every_data_point_enters_every_cubic_of_the_natural_spline():
    for row in np.eye(7, dtype=int):
        assert all(any(cubic) for cubic in natural(row))


@pytest.mark.parametrize(
    "place, touched", [(0, [0, 1]), (1, [0, 1, 2]), (3, [1, 2, 3, 4]), (7, [5, 6]), (6, [4, 5, 6])]
)
def test_a_data_point_of_the_one_sixth_rule_enters_at_most_four_cubics(place, touched):
    row = np.eye(8, dtype=int)[place]
    assert [k for k, cubic in enumerate(catmull_rom(row)) if any(cubic)] == touched


@law
@given(some_data(), st.data())
def test_moving_one_data_point_moves_at_most_four_cubics(data, draw):
    place = draw.draw(st.integers(0, len(data) - 1))
    moved = [*data[:place], draw.draw(vectors(len(data[0]))), *data[place + 1 :]]
    changed = [
        k
        for k, pair in enumerate(zip(catmull_rom(data), catmull_rom(moved), strict=True))
        if (pair[0] != pair[1]).any()
    ]
    assert set(changed) <= {place - 2, place - 1, place, place + 1}


@both_rules
@law
@given(some_data())
def test_the_cubics_pass_through_the_data_and_meet_with_c1(rule, data):
    cubics = rule(data)
    assert cubics.shape == (len(data) - 1, 4, len(data[0]))
    assert cubics[:, 0].tolist() == data[:-1] and cubics[:, 3].tolist() == data[1:]
    assert all(report.C1.holds for report in joins_of(cubics))


@law
@given(some_data())
def test_the_one_sixth_rule_has_half_the_chord_of_the_neighbours_as_velocity(data):
    first, last = (
        [2 * x - y for x, y in zip(*data[:2], strict=True)],
        [2 * x - y for x, y in zip(*data[:-3:-1], strict=True)],
    )
    for k, (before, after) in enumerate(zip([first, *data], [*data[1:], last], strict=False)):
        velocity = [(y - x) / 2 for x, y in zip(before, after, strict=True)]
        cubics = catmull_rom(data)
        if k < len(cubics):
            assert slope(cubics[k].tolist(), 0, 1) == velocity
        if k > 0:
            assert slope(cubics[k - 1].tolist(), 1, 1) == velocity


@law
@given(some_data())
def test_the_natural_spline_is_c2_and_straight_at_its_ends(data):
    cubics = natural(data)
    assert all(report.C2.holds for report in joins_of(cubics))
    assert not any(slope(cubics[0].tolist(), 0, 2)) and not any(slope(cubics[-1].tolist(), 1, 2))


def bending(cubics):
    """The integral of |p''|^2, whose second derivatives are linear."""
    total = F(0)
    for cubic in cubics.tolist():
        a, b = slope(cubic, 0, 2), slope(cubic, 1, 2)
        total += (dot(a, a) + dot(a, b) + dot(b, b)) / 3
    return total


@law
@given(some_data())
def test_no_cubics_through_the_data_bend_less_than_the_natural_spline(data):
    assert bending(natural(data)) <= bending(catmull_rom(data))


@both_rules
@law
@given(some_data())
def test_reversal_and_affine_maps_commute_with_the_rule(rule, data):
    cubics, points = rule(data), np.array(data)
    assert (rule(points[::-1]) == cubics[::-1, ::-1]).all()
    moved = rule(points * 3 - points[:, -1:] + 2)
    assert (moved == cubics * 3 - cubics[..., -1:] + 2).all()


@both_rules
@pytest.mark.parametrize("count", [2, 3, 4, 9])
def test_data_evenly_on_a_line_give_the_line(rule, count):
    assert rule(range(0, 3 * count, 3)).tolist() == [[3 * k, 3 * k + 1, 3 * k + 2, 3 * k + 3] for k in range(count - 1)]


@law
@given(some_data(3, 12))
def test_the_natural_spline_is_that_of_scipy(data):
    spline = CubicSpline(range(len(data)), np.array(data, float), bc_type="natural")
    for k, cubic in enumerate(natural(data).tolist()):
        for t in (F(0), F(1, 3), F(7, 8)):
            np.testing.assert_allclose(np.array(value(cubic, t), float), spline(k + float(t)), rtol=1e-12, atol=1e-12)


def test_the_natural_spline_solves_its_equations_written_out_by_sympy():
    """Inner control points as unknowns, one equation for each jump and each end."""
    data = [0, 3, 1, sympy.Rational(1, 2), 5]
    unknown = [sympy.symbols(f"a{k} b{k}") for k in range(4)]
    cubics = [(data[k], *unknown[k], data[k + 1]) for k in range(4)]
    t = sympy.Symbol("t")
    paths = [sum(sympy.binomial(3, i) * t**i * (1 - t) ** (3 - i) * c for i, c in enumerate(cubic)) for cubic in cubics]
    slopes = [[sympy.diff(path, t, r) for path in paths] for r in range(3)]
    equations = [a.subs(t, 1) - b.subs(t, 0) for r in (1, 2) for a, b in pairwise(slopes[r])]
    equations += [slopes[2][0].subs(t, 0), slopes[2][-1].subs(t, 1)]
    found = sympy.solve(equations, [x for pair in unknown for x in pair])
    assert [[x.subs(found) for x in map(sympy.sympify, cubic)] for cubic in cubics] == natural(data).tolist()


def test_one_large_natural_spline():
    data = [[F(k * k % 23, 1 + k % 4), k % 7] for k in range(300)]
    cubics = natural(data)
    first, second = hodograph(cubics), hodograph(cubics, 2)
    assert cubics[:, 0].tolist() == data[:-1] and cubics[:, 3].tolist() == data[1:]
    assert (first[:-1, -1] == first[1:, 0]).all() and (second[:-1, -1] == second[1:, 0]).all()
    assert not second[0, 0].any() and not second[-1, -1].any()


@both_rules
def test_floats_are_as_near_as_float64_can_be(rule):
    data = [[F(k * k % 23, 1 + k % 4), k % 7] for k in range(300)]
    rounded, exactly = rule(np.array(data, float)), rule(data)
    np.testing.assert_allclose(rounded, exactly.astype(float), rtol=0, atol=1e-14)
    assert (rounded[:, 0] == np.array(data[:-1], float)).all() and (rounded[:, 3] == np.array(data[1:], float)).all()
