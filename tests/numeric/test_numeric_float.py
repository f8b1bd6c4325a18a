"""float64 against exact fractions of the same numbers, for degrees 0 to 100 and at the edges of the arithmetic."""

from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction as F
from math import comb

import numpy as np
import pytest
from numeric_oracle import error, fractions, slope, value
from scipy.interpolate import BPoly

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

ULP = 2.0**-53
degrees = pytest.mark.parametrize("n", [*range(11), 16, 24, 37, 63, 100])


def curve(n, d=2):
    """Points of few bits, so that their exact fractions are cheap."""
    return np.random.default_rng(n).integers(-1024, 1025, (n + 1, d)) / 1024


def places(n, count=3):
    return np.array([0.0, 1.0, 1e-12, 1 - 1e-9, 0.5, *np.random.default_rng(n + 1).uniform(0, 1, count)])


def bound(n):
    return max(4, 1.5 * n) * ULP


@degrees
def test_values(n):
    points, t = curve(n), places(n)
    exact = [value(fractions(points), F(s)) for s in t]
    assert error(evaluate(points, t), exact) <= bound(n)
    assert error(evaluate_accurate(points, t), exact) <= 10 * ULP
    assert error([de_casteljau(points, s)[-1][0] for s in t], exact) <= bound(n)
    # many parameters and a batch go other ways
    many = np.tile(t, 200)
    assert error(evaluate(points, many)[-8:], exact) <= bound(n)
    assert error(evaluate(np.stack([points] * 9), t)[4], exact) <= bound(n)
    assert error(evaluate(np.stack([points] * 9), many)[8, :8], exact) <= bound(n)
    weights = [[comb(n, i) * F(s) ** i * (1 - F(s)) ** (n - i) for i in range(n + 1)] for s in t]
    assert error(bernstein(n, t), weights) <= bound(n)
    for ends in (evaluate(points, t), evaluate(points, many), evaluate_accurate(points, t)):
        assert (ends[:2] == points[[0, -1]]).all()


@pytest.mark.parametrize("n", [0, 1, 3, 10, 50, 100])
@pytest.mark.parametrize("m", [2, 33, 5000, 40001, 140001])
def test_samples(n, m):
    points = curve(n)
    got = sample(points, m)
    assert got.shape == (m, 2) and (got[[0, -1]] == points[[0, -1]]).all()
    some = sorted({0, 1, m // 3, m // 2, m - 2, m - 1, min(4095, m - 1), min(4096, m - 1), min(4097, m - 1)})
    # the parameter is rounded too, and the curve moves by |p'| <= 2 n with it
    exact = [value(fractions(points), F(i, m - 1)) for i in some]
    assert error(got[some], exact) <= bound(n) + 2 * n * ULP
    np.testing.assert_allclose(got, evaluate(points, np.linspace(0, 1, m)), rtol=0, atol=4 * bound(n))
    np.testing.assert_array_equal(sample(points[:, 0], m), sample(points[:, :1], m)[:, 0])


@pytest.mark.parametrize("n", [0, 1, 2, 3, 4, 5, 10, 20])
@pytest.mark.parametrize("d", [1, 2, 3, 9])
@pytest.mark.parametrize("m", [1023, 1025, 10240, 10241, 20501])
def test_many_parameters_are_few_at_a_time(n, d, m):
    points, t = curve(n, d), np.random.default_rng(m).uniform(-0.5, 1.5, m)
    t[[0, 1, -2, -1]] = 0, 1, 0, 1
    got, few = evaluate(points, t), np.linspace(0, m - 1, 40).astype(int)
    assert got.shape == (m, d) and (got[[0, 1, -2, -1]] == points[[0, -1, 0, -1]]).all()
    peer = BPoly(points[:, None, :], [0, 1])(t)
    np.testing.assert_allclose(got, peer, rtol=0, atol=2 * bound(n) * 2.0**n)  # |t| + |1-t| <= 2
    np.testing.assert_allclose(got[few], evaluate(points, t[few]), rtol=0, atol=2 * bound(n) * 2.0**n)


@pytest.mark.parametrize("n", [3, 10, 40])
def test_threads_keep_out_of_each_other_s_way(n):
    points, t = [curve(n) + shift for shift in range(4)], np.random.default_rng(n).uniform(0, 1, 20_000)
    alone = [evaluate(some, t) for some in points]
    with ThreadPoolExecutor(4) as threads:
        for _ in range(20):
            for one, other in zip(alone, threads.map(lambda some: evaluate(some, t), points), strict=True):
                assert np.array_equal(one, other)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5])
def test_low_degrees_at_their_worst(n):
    rng = np.random.default_rng(n)
    signs = np.array([[(k >> i & 1) * 2.0 - 1 for k in range(2 ** (n + 1))] for i in range(n + 1)])
    for points in (signs * (1 - rng.random(signs.shape) / 64), rng.uniform(-1, 1, signs.shape)):
        t = rng.uniform(0, 1, 60)
        among_many = evaluate(points, np.tile(t, 20))[:60]
        assert error(among_many, [value(fractions(points), F(s)) for s in t]) <= bound(n)


@degrees
def test_parts(n):
    points, exact = curve(n), fractions(curve(n))
    a, b = 0.3125, 0.8125

    def cut(curve, t):  # de_casteljau is tested against the definition elsewhere
        levels = [level.tolist() for level in de_casteljau(curve, t)]
        return [level[0] for level in levels], [level[-1] for level in levels[::-1]]

    exact_left, exact_right = cut(exact, F(a))
    part = cut(exact_right, (F(b) - F(a)) / (1 - F(a)))[0]
    assert error(segment(points, a, b), part) <= bound(n) + 4 * ULP
    left, right = split(points, a)
    assert error(left, exact_left) <= bound(n) + 4 * ULP
    assert error(right, exact_right) <= bound(n) + 4 * ULP
    assert (left[-1] == right[0]).all() and (left[0] == points[0]).all() and (right[-1] == points[-1]).all()
    parts = subdivide(points, 3)
    assert error(parts[5], cut(cut(exact, F(5, 8))[1], F(1, 3))[0]) <= 3 * bound(n)
    assert (parts[1:, 0] == parts[:-1, -1]).all()
    for level, right_level in zip(de_casteljau(points, a), de_casteljau(exact, F(a)), strict=True):
        assert error(level, right_level.tolist()) <= bound(n)


@degrees
def test_derivatives_elevation_powers(n):
    points, exact, t = curve(n), fractions(curve(n)), places(n, 2)
    for r in (0, 1, 2, 5):
        scale = 2.0**r * n**r + 1
        assert error(hodograph(points, r), hodograph(exact, r).tolist()) <= 2 * bound(n) * scale
        assert error(derivative(points, t, r), [slope(exact, F(s), r) for s in t]) <= 3 * bound(n) * scale
        assert error(elevate(points, r), elevate(exact, r).tolist()) <= 4 * ULP
    assert elevate(points, 7)[0].tolist() == points[0].tolist() and (elevate(points, 7)[-1] == points[-1]).all()
    scale = max(comb(n, k) * 2**k for k in range(n + 1))
    assert error(to_power(points), to_power(exact).tolist()) <= 2 * bound(n) * scale
    assert error(from_power(points), from_power(exact).tolist()) <= (n + 2) * ULP * (n + 1)


@pytest.mark.parametrize("n", [*range(1, 12), 20, 50, 100])
@pytest.mark.parametrize("d", [2, 3])
def test_curvature(n, d):
    points, t = curve(n, d) + np.linspace(0, 9, n + 1)[:, None], places(n, 3)
    exact = curvature(fractions(points), [F(s) for s in t])
    np.testing.assert_allclose(curvature(points, t), exact, rtol=1e-9, atol=1e-9 * n)
    np.testing.assert_allclose(
        curvature(np.stack([points, 2 * points]), t), [exact, exact / 2], rtol=1e-9, atol=1e-9 * n
    )


@pytest.mark.parametrize("n", [0, 1, 2, 3, 7, 20])
def test_values_and_derivatives_are_those_of_scipy(n):
    points, t = curve(n, 3), np.linspace(-0.5, 1.5, 41)
    peer = BPoly(points[:, None, :], [0, 1])
    np.testing.assert_allclose(evaluate(points, t), peer(t), rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(derivative(points, t), peer.derivative()(t), rtol=1e-9, atol=1e-11)


@pytest.mark.parametrize("n", [3, 7, 40])
def test_outside_the_unit_interval(n):
    points = curve(n)
    t = np.array([-0.25, 1.25, -2.0, 3.0])
    for s, got in zip(t, evaluate(points, np.tile(t, 300)), strict=False):
        exact = value(fractions(points), F(s))
        assert error(got, exact) <= 3 * bound(n) * (abs(s) + abs(1 - s)) ** n


# The edges of the arithmetic


@pytest.mark.parametrize("n", [1000, 1001, 2000])
def test_very_high_degrees(n):
    points = np.arange(n + 1) * 37 % 64 / 64 - 0.5
    t, quarter = np.array([0.0, 0.25, 1.0]), 0
    for i in range(n + 1):  # C(n,i) 3^(n-i) / 4^n of b_i, in integers
        quarter += comb(n, i) * 3 ** (n - i) * int(points[i] * 64)
    exact = [F(points[0]), F(quarter, 64 * 4**n), F(points[-1])]
    assert error(evaluate(points, t), exact) <= 0.75 * n * ULP
    assert error(evaluate_accurate(points, t), exact) <= 10 * ULP
    assert abs(bernstein(n, t).sum(axis=-1) - 1).max() <= n * ULP
    assert sample(points, 5)[[0, 4]].tolist() == points[[0, -1]].tolist()


@pytest.mark.parametrize("n", [3, 30, 90])
def test_very_large_and_very_small_points(n):
    points, t = curve(n), np.random.default_rng(0).uniform(0, 1, 700)
    for scale in (2.0**1000, 2.0**1023, 2.0**-1000):
        scaled = evaluate(points * scale, t) / scale
        np.testing.assert_allclose(scaled, evaluate(points, t), rtol=0, atol=2 * bound(n))
        np.testing.assert_allclose(split(points * scale, 0.3)[0] / scale, split(points, 0.3)[0], atol=2 * bound(n))
    for power in (900, -900):
        got = curvature(np.ldexp(points, power), t[:20])
        np.testing.assert_allclose(np.ldexp(got, power), curvature(points, t[:20]), rtol=1e-9)


def test_what_is_too_large_is_an_error():
    for call in (
        lambda: evaluate([0.0, 1.0, 2.0, 0.0], 1e200),
        lambda: evaluate(np.array([[0.0, 1.0], [1e308, 0.0]]), [0.5, -1e300]),
        lambda: hodograph([-1e308, 1e308]),
        lambda: derivative(np.ones(301) * np.arange(301.0) ** 2, 0.5, 250),
        lambda: segment([0.0, 1e300], -1e300, 1e300),
        lambda: de_casteljau([0.0, 1e300], 1e300),
        lambda: bernstein(5, 1e100),
        lambda: to_power([1e308, -1e308, 1e308]),
    ):
        with pytest.raises(ValueError, match="too large"):
            call()


def test_no_average_of_the_largest_float_is_infinite():
    """Rounding may carry one beyond: that is an error."""
    for n, r in [(n, r) for n in range(1, 12) for r in range(1, 12)]:
        try:
            assert np.isfinite(elevate(np.full((n + 1, 2), np.finfo(float).max), r)).all()
        except ValueError as error:
            assert "too large" in str(error)


@pytest.mark.parametrize("n, m", [(1, 3000), (2, 3000), (3, 3000), (20, 3000), (3, 1), (20, 1), (700, 9), (1000, 9)])
def test_what_is_nearly_too_large_is_right_and_silent(n, m):
    points = np.resize([1.0, -1.0], (n + 1, 1))
    for scale in (2.0**400, 2.0**1000, 2.0**1023):
        assert (evaluate(points * scale, np.zeros(m)) == scale).all()
        assert (sample(points * scale, 3)[[0, 2]] == points[[0, -1]] * scale).all()


@pytest.mark.parametrize("t", [1e153, 1e154, 1e300])  # the square of the second is finite, but eight times it is not
def test_far_away_parameters_are_silent(t):
    assert (evaluate(np.array([[1.0], [2.0]]), np.full(5, t)) == 1 + t).all()


def test_tiny_speeds_count_and_rounded_ones_do_not():
    assert curvature([[0.0, 0.0], [1e-20, 0.0], [1.0, 1.0]], 0.0) == pytest.approx(0.5 * 1e40, rel=1e-12)
    assert curvature([[0.0, 0.0], [1e-150, 0.0], [0.0, 1e-150]], 0.0) == pytest.approx(0.5e150)
    # a cusp at 1/3 that float64 meets only nearly
    cusp = from_power([[F(1, 9), -F(1, 27)], [-F(2, 3), F(1, 3)], [1, -1], [0, 1]]).astype(float)
    with pytest.raises(ValueError, match=r"p'\(t\) = 0 at t = 0.333"):
        curvature(cusp, [0.1, 1 / 3])
    with pytest.raises(ValueError, match=r"p'\(t\) = 0"):
        curvature(np.array([[0.1, 0.3]] * 4), 0.7)
    assert np.isfinite(curvature(cusp, [0.3, 0.34])).all()


def test_polylines():
    points = curve(5) * 10
    for tolerance in (1.0, 1e-2, 1e-5):
        line = flatten(points, tolerance)
        steps = len(line) - 1
        dense = evaluate(points, (np.arange(steps)[:, None] + np.linspace(0, 1, 9)) / steps)
        chord = line[:-1, None] + np.linspace(0, 1, 9)[:, None] * (line[1:] - line[:-1])[:, None]
        assert np.linalg.norm(dense - chord, axis=-1).max() <= tolerance * (1 + 1e-9)
    assert flatten([[0.0, 0.0], [1e200, 0.0], [0.0, 1e200]], 1e199).shape[1] == 2
    for points, tolerance in (([0.0, 1e300, 0.0], 1e-9), ([0, 10**400, 0], 1), ([0.0, 1.7e308, 0.0], 1.0)):
        with pytest.raises(ValueError, match="points"):
            flatten(points, tolerance)


def test_not_contiguous_points_and_parameters():
    points, t = curve(6), np.linspace(0, 1, 40)
    np.testing.assert_array_equal(evaluate(points[::-1][::-1], t[::2]), evaluate(points, t[::2].copy()))
    wide = np.zeros((7, 9))
    wide[:, 2:4] = points
    np.testing.assert_allclose(evaluate(wide[:, 2:4], t), evaluate(points, t), atol=ULP * 9)
    np.testing.assert_allclose(sample(wide[:, 2:4], 12), sample(points, 12), atol=ULP * 9)
    np.testing.assert_allclose(
        evaluate(points, t.reshape(5, 8).T), evaluate(points, t).reshape(5, 8, 2).swapaxes(0, 1), atol=ULP * 9
    )
