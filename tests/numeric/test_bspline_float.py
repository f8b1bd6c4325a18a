"""B-splines in float64 against SciPy on thousands of random knot vectors, and against exact fractions."""

from fractions import Fraction as F

import numpy as np
import pytest
from numeric_oracle import error, fractions
from scipy.interpolate import BSpline, make_lsq_spline

from bezteach.numeric.bspline import (
    averages,
    basis,
    blossom,
    clamped,
    de_boor,
    derivative,
    evaluate,
    insert,
    span,
    to_bezier,
    uniform,
)

ULP = 2.0**-53


def bound(p):
    """A few units in the last place of max|b|."""
    return max(4, 2 * p) * ULP


def random_knots(rng, p, count):
    """Knots of any spacing that stand up to p+1 times, with a domain that is not empty."""
    while True:
        times = rng.integers(1, p + 2, count + 2 * p + 1)
        values = np.cumsum(10.0 ** rng.uniform(-2, 1, len(times))) - rng.integers(0, 20)
        start = rng.integers(0, p + 1)
        knots = np.repeat(values, times)[start : start + count + p + 1]
        if knots[p] < knots[count]:
            return knots


def places(rng, knots, p, count, m=9):
    """Parameters in the domain: every knot, what is just before and after it, and m more."""
    inner = knots[p : count + 1]
    t = [inner, np.nextafter(inner, -np.inf), np.nextafter(inner, np.inf), rng.uniform(inner[0], inner[-1], m)]
    return np.clip(np.concatenate(t), inner[0], inner[-1])


def peer(points, knots, p, t, r=0):
    """SciPy's values; where the domain's end is a multiple knot, without the last points, which enter nowhere in it."""
    last = len(points)
    while knots[last - 1] == knots[last]:
        last -= 1
    inner = np.concatenate([knots[:last], knots[last:][: p + 1]])
    return BSpline(inner, points[:last], p)(t, nu=r)


def exactly(values):
    return np.array(fractions(values), object)


@pytest.mark.parametrize("p", range(7))
def test_values_derivatives_and_basis_are_those_of_scipy(p):
    rng = np.random.default_rng(p)
    for _ in range(300):
        count = int(rng.integers(p + 1, p + 9))
        knots, points = random_knots(rng, p, count), rng.uniform(-1, 1, (count, 2))
        t = places(rng, knots, p, count)
        np.testing.assert_allclose(evaluate(points, knots, t), peer(points, knots, p, t), rtol=0, atol=1e-14 * (p + 1))
        if p:
            r = int(rng.integers(1, p + 1))
            expected = peer(points, knots, p, t, r)
            np.testing.assert_allclose(
                derivative(points, knots, t, r), expected, rtol=1e-9, atol=1e-12 * abs(expected).max()
            )
        rows = basis(knots, p, t)
        assert (rows >= 0).all() and abs(rows.sum(axis=1) - 1).max() <= bound(p)
        np.testing.assert_allclose(rows, peer(np.eye(count), knots, p, t), rtol=0, atol=1e-14 * (p + 1))
        np.testing.assert_allclose(rows @ points, evaluate(points, knots, t), rtol=0, atol=1e-14 * (p + 1))


@pytest.mark.parametrize("p", range(1, 6))
def test_insertion_is_that_of_scipy(p):
    rng = np.random.default_rng(p)
    for _ in range(100):
        count = int(rng.integers(p + 1, p + 9))
        knots, points = np.sort(rng.uniform(-3, 3, count + p + 1)), rng.uniform(-1, 1, (count, 2))
        t = rng.uniform(knots[p], knots[count])
        times = int(rng.integers(1, p + 1))
        more, longer = insert(points, knots, t, times)
        expected = BSpline(knots, points, p).insert_knot(t, times)
        np.testing.assert_array_equal(longer, expected.t)
        np.testing.assert_allclose(more, expected.c, rtol=0, atol=1e-12)
        s = places(rng, longer, p, count + times)
        np.testing.assert_allclose(evaluate(more, longer, s), evaluate(points, knots, s), rtol=0, atol=1e-13)


@pytest.mark.parametrize("p", [1, 2, 3, 5])
def test_least_squares_of_scipy_are_met(p):
    """A spline that SciPy fits to a spline of ours is that one again."""
    rng = np.random.default_rng(p)
    points, knots = rng.uniform(-1, 1, (12, 3)), clamped(12, p).astype(float)
    t = np.linspace(0, knots[-1], 200)
    fitted = make_lsq_spline(t, evaluate(points, knots, t), knots, p)
    np.testing.assert_allclose(fitted.c, points, rtol=0, atol=1e-10)


KNOTS = {
    "clamped": lambda rng, p, count: clamped(count, p).astype(float),
    "uniform": lambda rng, p, count: uniform(count, p).astype(float),
    "uneven": lambda rng, p, count: np.sort(10.0 ** rng.uniform(-12, 0, count + p + 1)),
    "offset": lambda rng, p, count: 1e6 + np.sort(rng.uniform(0, 3, count + p + 1)),
    "crowded": lambda rng, p, count: np.r_[[0] * (p + 1), np.arange(1, count - p) * 1e-9, [1] * (p + 1)],
}


@pytest.mark.parametrize("kind", KNOTS)
@pytest.mark.parametrize("p", [0, 1, 2, 3, 4, 5, 6, 7, 12])
def test_the_error_is_a_few_units_in_the_last_place(p, kind):
    rng = np.random.default_rng(p)
    count = p + 5
    knots = KNOTS[kind](rng, p, count)
    points = np.stack([(-1.0) ** np.arange(count), rng.uniform(-1, 1, count), np.sign(rng.uniform(-1, 1, count))], 1)
    t = places(rng, knots, p, count, 3)
    exact = evaluate(exactly(points), exactly(knots), exactly(t)).tolist()
    assert error(evaluate(points, knots, t), exact) <= bound(p)
    many = np.tile(t, 1 + 12000 // len(t))  # these, and those in order, go other ways
    assert error(evaluate(points, knots, many)[-len(t) :], exact) <= bound(p)
    order = np.argsort(many, kind="stable")
    first = np.searchsorted(many[order], t)
    assert error(evaluate(points, knots, many[order])[first], exact) <= bound(p)
    segments, _ = to_bezier(points, knots)
    assert error(segments, to_bezier(exactly(points), exactly(knots))[0].tolist()) <= bound(p)
    assert error([de_boor(points, knots, s)[-1][0] for s in t[::5]], exact[::5]) <= bound(p)


@pytest.mark.parametrize("p", [1, 2, 3, 6])
def test_the_error_of_derivatives_against_their_largest_control_point(p):
    rng = np.random.default_rng(p)
    count = p + 5
    for kind in ("clamped", "uneven", "offset"):
        knots, points = KNOTS[kind](rng, p, count), rng.uniform(-1, 1, (count, 2))
        t = places(rng, knots, p, count, 3)
        exact = derivative(exactly(points), exactly(knots), exactly(t)).tolist()
        spans = [k for k in range(p, count) if knots[k] < knots[k + 1]]
        size = max(
            abs(p * (points[i] - points[i - 1]) / (knots[i + p] - knots[i])).max()
            for i in range(1, count)
            if any(i <= k < i + p for k in spans)
        )
        for s in (t, np.tile(t, 100)):
            assert error(derivative(points, knots, s)[-len(t) :], exact) <= 2 * bound(p) * size


# Very many parameters


@pytest.mark.parametrize("d", [1, 2, 3, 7])
@pytest.mark.parametrize("p, count", [(0, 5), (1, 2), (3, 4), (3, 10), (2, 700), (5, 300), (8, 20)])
def test_many_parameters_in_any_order_are_few_at_a_time(p, count, d):
    rng = np.random.default_rng(count + d)
    knots, points = random_knots(rng, p, count), rng.uniform(-1, 1, (count, d))
    t = places(rng, knots, p, count, 20011)
    rng.shuffle(t)
    for s in (t, np.sort(t)):
        got = evaluate(points, knots, s)
        few = np.concatenate([evaluate(points, knots, part) for part in np.array_split(s, len(s) // 999 + 1)])
        np.testing.assert_allclose(got, few, rtol=0, atol=2 * bound(p))
        np.testing.assert_array_equal(evaluate(points[:, 0], knots, s), evaluate(points[:, :1], knots, s)[:, 0])
        if p:
            slopes = np.concatenate([derivative(points, knots, part) for part in np.array_split(s, len(s) // 999 + 1)])
            np.testing.assert_allclose(derivative(points, knots, s), slopes, rtol=1e-9, atol=1e-13 * abs(slopes).max())


@pytest.mark.parametrize("order", ["any", "sorted", "backwards"])
def test_every_knot_goes_to_the_span_on_its_right(order):
    """Of degree 0, so that a parameter in the wrong span cannot be missed."""
    rng = np.random.default_rng(1)
    for spread in (0, 2, 6, 300):
        knots = np.unique(np.cumsum(10.0 ** rng.uniform(-spread, 0, 60)))
        points = np.arange(len(knots) - 1.0)
        t = np.concatenate([knots, np.nextafter(knots[1:], -np.inf), rng.uniform(knots[0], knots[-1], 90000)])
        t = np.sort(t) if order != "any" else rng.permutation(t)
        t = t[::-1] if order == "backwards" else t
        expected = np.minimum(np.searchsorted(knots, t, "right") - 1, len(points) - 1)
        np.testing.assert_array_equal(evaluate(points, knots, t), expected)
        np.testing.assert_array_equal(span(knots, 0, t), expected)


@pytest.mark.parametrize("scale", [5e-324, 1e-310, 1e-300, 1e300])
def test_knots_at_the_edges_of_the_arithmetic(scale):
    knots, points = clamped(8, 2) * scale, np.array([0.0, 1, 4, 2, 2, 7, 0, 1])
    t = np.tile(knots[2:9] if scale == 5e-324 else np.linspace(0, knots[-1], 19), 300)
    plain = evaluate(points, clamped(8, 2), t / scale)
    for s in (t, np.sort(t), t[:40]):
        np.testing.assert_allclose(np.sort(evaluate(points, knots, s)), np.sort(plain[: len(s)]), rtol=0, atol=1e-14)


def test_a_curve_of_ten_thousand_points():
    rng = np.random.default_rng(0)
    knots, points = clamped(10000, 3).astype(float), rng.uniform(-1, 1, (10000, 2))
    t = rng.uniform(0, knots[-1], 30000)
    np.testing.assert_allclose(evaluate(points, knots, t), BSpline(knots, points, 3)(t), rtol=0, atol=1e-14)
    segments, breaks = to_bezier(points, knots)
    assert segments.shape == (9997, 4, 2) and breaks.tolist() == list(range(9998))
    assert (segments[1:, 0] == segments[:-1, 3]).all()
    np.testing.assert_allclose(segments[:, 0], BSpline(knots, points, 3)(breaks[:-1]), rtol=0, atol=1e-14)


@pytest.mark.parametrize("p", range(7))
def test_segments_meet_number_for_number_and_ends_are_control_points(p):
    rng = np.random.default_rng(p)
    for _ in range(50):
        count = int(rng.integers(p + 1, p + 9))
        knots, points = random_knots(rng, p, count), rng.uniform(-1, 1, (count, 3))
        segments, breaks = to_bezier(points, knots)
        smooth = np.array([(knots == b).sum() <= p for b in breaks[1:-1]], bool)
        assert (segments[1:, 0][smooth] == segments[:-1, -1][smooth]).all()
    knots, points = clamped(p + 6, p).astype(float), rng.uniform(-1, 1, (p + 6, 3))
    assert (evaluate(points, knots, knots[[0, -1]]) == points[[0, -1]]).all()


def test_a_batch_is_its_curves_one_by_one():
    rng = np.random.default_rng(3)
    knots, points = random_knots(rng, 3, 9), rng.uniform(-1, 1, (5, 9, 2))
    inside = np.linspace(knots[3], knots[9], 7)
    for t in (inside, np.tile(inside, 400), np.sort(np.tile(inside, 4000))):
        together = evaluate(points, knots, t), derivative(points, knots, t)
        assert together[0].shape == (5, len(t), 2)
        for k, one in enumerate(points):
            np.testing.assert_allclose(together[0][k], evaluate(one, knots, t), rtol=0, atol=1e-14)
            np.testing.assert_allclose(together[1][k], derivative(one, knots, t), rtol=1e-10, atol=1e-10)
    for k, one in enumerate(points):
        assert (to_bezier(points, knots)[0][k] == to_bezier(one, knots)[0]).all()
        assert (insert(points, knots, inside[3], 2)[0][k] == insert(one, knots, inside[3], 2)[0]).all()
        assert (de_boor(points, knots, inside[3])[1][k] == de_boor(one, knots, inside[3])[1]).all()
        arguments = knots[4:7]
        assert (
            blossom(points, knots, span(knots, 3, inside[3]), *arguments)[k]
            == blossom(one, knots, span(knots, 3, inside[3]), *arguments)
        ).all()


def test_averages_give_back_the_parameter():
    rng = np.random.default_rng(4)
    for p in range(1, 6):
        knots = random_knots(rng, p, 12)
        t = places(rng, knots, p, 12)
        np.testing.assert_allclose(evaluate(averages(knots, p), knots, t), t, rtol=1e-13, atol=1e-13)


def test_float_numbers_are_fractions_to_the_exact_arithmetic():
    rng = np.random.default_rng(5)
    knots, points = random_knots(rng, 2, 7), rng.uniform(-1, 1, 7)
    t = float(rng.uniform(knots[2], knots[7]))
    exact = evaluate(fractions(points), fractions(knots), F(t))
    assert isinstance(exact, F) and abs(evaluate(points, knots, t) - float(exact)) <= bound(2)
