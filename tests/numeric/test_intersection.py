"""Boxes, and where curves meet: crossings worked by hand, resultants, polylines, and what cannot be known yet."""

from fractions import Fraction as F
from math import cos, pi

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numeric_oracle import few_fractions, value
from sympy import Poly, Rational, expand, resultant, symbols

from bezteach.numeric import box, elevate, evaluate, from_power, intersections, roots, sample, subdivide, to_power

law = settings(deadline=None, max_examples=40, database=None)
PARABOLA = [(0, 0), (1, 2), (2, 0)]
CHEBYSHEV = [(-3, -3), (-1, 15), (1, -15), (3, 3)]  # three times y = 4x^3 - 3x on [-1, 1]
FINE = F(1, 2**20)


def within(crossing, s, t):
    return crossing.one[0] <= s <= crossing.one[1] and crossing.other[0] <= t <= crossing.other[1]


# The box


def test_boxes():
    assert box([(0, 3), (1, -1), (F(1, 2), 7)]).tolist() == [[0, -1], [1, 7]]
    assert box([3, 1, 2]).tolist() == [1, 3] and box([(5, 6)]).tolist() == [[5, 6], [5, 6]]
    assert box(np.array([[0.5, 1.0], [2.0, -1.0]])).tolist() == [[0.5, -1.0], [2.0, 1.0]]
    assert box(subdivide(PARABOLA, 1)).astype(str).tolist() == [[["0", "0"], ["1", "1"]], [["1", "0"], ["2", "1"]]]
    with pytest.raises(ValueError, match="control points hold x"):
        box([1, symbols("x")])


@law
@given(st.lists(st.lists(few_fractions(-9, 9, 4), min_size=2, max_size=2), min_size=1, max_size=6))
def test_the_curve_stays_in_its_box_and_halving_never_widens_it(points):
    low, high = box(points)
    seen = sample(points, 9)
    assert (low <= seen).all() and (seen <= high).all()
    parts = box(subdivide(points, 3))
    assert (low <= parts[:, 0]).all() and (parts[:, 1] <= high).all()


# By hand


def test_a_parabola_and_a_line():
    """4t(1 - t) = 2t/3 at t = 0 and t = 5/6, where x = 5/3 is 5/9 of the line."""
    first, second = intersections(PARABOLA, [(0, 0), (3, 1)])
    assert first == ((0, 0), (0, 0), True)
    assert second.certain and within(second, F(5, 6), F(5, 9)) and second.one[1] - second.one[0] == FINE


def test_nine_crossings_of_two_cubics():
    """x = cos a, y = cos 3a and the same with x and y changed: cos 9a = cos a, so a is k pi/4 or k pi/5."""
    found = intersections(CHEBYSHEV, [(y, x) for x, y in CHEBYSHEV])
    angles = sorted({*(k * pi / 4 for k in range(5)), *(k * pi / 5 for k in range(6))}, reverse=True)
    assert len(found) == 9 and all(crossing.certain for crossing in found)
    for crossing, a in zip(found, angles, strict=True):
        assert (1 + cos(a)) / 2 == pytest.approx(float(sum(crossing.one)) / 2, abs=2e-6)
        assert (1 + cos(3 * a)) / 2 == pytest.approx(float(sum(crossing.other)) / 2, abs=2e-6)
    exact = [crossing.one[0] for crossing in found if crossing.one[0] == crossing.one[1]]
    assert exact == [0, F(1, 2), 1]


@pytest.mark.parametrize("line", [[(0, 1), (2, 1)], [(0, F(8, 9) - F(4, 9)), (1, F(8, 9) + F(2, 9))]])
def test_a_line_that_touches_is_not_certain(line):
    """The tangents at t = 1/2 and at t = 1/3."""
    for tolerance in (F(1, 8), F(1, 2**10), F(1, 2**30)):
        (touch,) = intersections(PARABOLA, line, tolerance)
        assert not touch.certain and touch.one[1] - touch.one[0] <= 4 * tolerance


def test_a_line_that_passes_closely_is_told_from_one_that_touches_by_a_smaller_tolerance():
    """The tangent at t = 1/3 is y = 4/9 + 2x/3; moved by a millionth it passes, or crosses twice."""
    (x, y), (u, v), lift = (0, F(4, 9)), (1, F(10, 9)), F(1, 10**6)
    assert [c.certain for c in intersections(PARABOLA, [(x, y + lift), (u, v + lift)], F(1, 16))] == [False]
    assert intersections(PARABOLA, [(x, y + lift), (u, v + lift)], F(1, 2**12)) == []
    below = intersections(PARABOLA, [(x, y - lift), (u, v - lift)], F(1, 2**14))
    assert [c.certain for c in below] == [True, True]


def test_curves_that_meet_at_their_ends_and_in_a_t():
    assert intersections([(0, 0), (1, 1)], [(1, 1), (2, 0)]) == [((1, 1), (0, 0), True)]
    assert intersections([(0, 0), (2, 0)], [(1, 0), (1, 5)]) == [((F(1, 2), F(1, 2)), (0, 0), True)]
    (tee,) = intersections([(0, 0), (3, 0)], [(1, 0), (1, 5)])  # an end at t = 1/3: no sign shows that they meet
    assert not tee.certain and within(tee, F(1, 3), 0)


def test_a_curve_through_its_own_double_point():
    """The loop of (0,0) (4,4) (-1,4) (3,0) passes the line x = 3/2 three times, twice in one point."""
    found = intersections([(0, 0), (4, 4), (-1, 4), (3, 0)], [(F(3, 2), -1), (F(3, 2), 7)])
    assert [crossing.certain for crossing in found] == [True] * 3 and found[1].one == (F(1, 2), F(1, 2))


def test_hulls_that_meet_and_curves_that_do_not():
    assert intersections(PARABOLA, [(0, F(3, 2)), (2, F(3, 2))], F(1, 4)) == []
    assert intersections([(0, 0), (1, 1)], [(5, 0), (6, 1)]) == []


def test_points_as_curves():
    assert intersections([(1, 1)], [(2, 2)]) == []
    assert [crossing.certain for crossing in intersections([(1, 1)], PARABOLA, F(1, 2))] == [False]


def test_curves_along_each_other():
    for other in (PARABOLA, elevate(PARABOLA), PARABOLA[::-1]):
        with pytest.raises(ValueError, match="run along each other") as caught:
            intersections(PARABOLA, other)
        assert "\n" not in str(caught.value) and len(str(caught.value)) < 200
    (all_of_it,) = intersections(PARABOLA, PARABOLA, F(1, 8))
    assert all_of_it == ((0, 1), (0, 1), False)


def test_floats_count_as_the_fractions_that_they_are():
    floats = np.array(PARABOLA, float) / 3
    exact = [tuple(map(F, row)) for row in floats.tolist()]
    assert intersections(floats, [(0, 0), (1, 0.3)]) == intersections(exact, [(0, 0), (1, F(0.3))]) != []


# Independent


def test_one_large_against_polylines():
    """Degree 20: the edges of two polylines that cross, all against all, in floats."""
    random = np.random.default_rng(1)
    one, other = (random.integers(-9, 9, (21, 2)) for _ in range(2))
    found = intersections(one, other)
    count = 2001
    p, q = (sample(points.astype(float), count) for points in (one, other))
    d, e = np.diff(p, axis=0)[:, None], np.diff(q, axis=0)[None]
    gap = q[None, :-1] - p[:-1, None]
    turn = d[..., 0] * e[..., 1] - d[..., 1] * e[..., 0]
    s = (gap[..., 0] * e[..., 1] - gap[..., 1] * e[..., 0]) / turn
    t = (gap[..., 0] * d[..., 1] - gap[..., 1] * d[..., 0]) / turn
    places = np.argwhere((s >= 0) & (s < 1) & (t >= 0) & (t < 1))
    assert len(places) == len(found) > 5 and all(crossing.certain for crossing in found)
    for (i, k), crossing in zip(places.tolist(), found, strict=True):
        assert float(crossing.one[0]) == pytest.approx(i / (count - 1), abs=2 / count)
        assert float(crossing.other[0]) == pytest.approx(k / (count - 1), abs=2 / count)


@law
@given(*[st.lists(st.tuples(*[st.integers(-6, 6)] * 2), min_size=3, max_size=4)] * 2)
def test_the_resultant_has_a_root_in_every_certain_answer_and_no_common_point_is_missed(one, other):
    """Where they meet, s is a root of the resultant of x(s) - X(t) and y(s) - Y(t) in t."""
    s, t = symbols("s t")
    (x, y), (u, v) = value(one, s), value(other, t)
    eliminated = resultant(expand(x - u), expand(y - v), t)
    assume(eliminated.has(s))
    polynomial = Poly(eliminated, s)
    found = intersections(one, other, F(1, 2**16))
    for crossing in found:
        if crossing.certain:
            assert polynomial.count_roots(*map(Rational, crossing.one)) >= 1
    for root in map(float, polynomial.real_roots()):
        place = evaluate(np.array(one, float), root)
        across = to_power(np.array(other, float)) - np.outer(np.eye(len(other))[0], place)
        for meeting in np.roots(across[::-1, 0]):
            shared = abs(meeting.imag) < 1e-9 and abs(np.polyval(across[::-1, 1], meeting.real)) < 1e-9
            if shared and 1e-6 < root < 1 - 1e-6 and 1e-6 < meeting.real < 1 - 1e-6:
                assert any(
                    c.one[0] - 1e-6 < root < c.one[1] + 1e-6 and c.other[0] - 1e-6 < meeting.real < c.other[1] + 1e-6
                    for c in found
                )


@law
@given(st.lists(st.integers(-9, 9), min_size=2, max_size=6).filter(any))
def test_the_graph_meets_the_axis_where_the_polynomial_is_zero(heights):
    places = from_power([0, 1, *[0] * (len(heights) - 2)])
    graph = list(zip(places, heights, strict=True))
    found = intersections(graph, [(-1, 0), (2, 0)], F(1, 2**14))
    known = roots(heights, F(1, 2**14))
    for root in known:
        if root.certain:
            inside = [c for c in found if c.one[0] <= root.end and root.start <= c.one[1]]
            assert len(inside) == 1 and inside[0].other[0] <= (root.end + 1) / 3
    assert sum(c.certain for c in found) <= sum(root.certain for root in known)


@law
@given(
    *[st.lists(st.tuples(*[st.integers(-5, 5)] * 2), min_size=2, max_size=5)] * 2,
    *[few_fractions(0, 1, 8)] * 2,
)
def test_a_known_common_point_is_in_exactly_one_answer(one, other, s, t):
    away = np.array(value(one, s), object) - np.array(value(other, t), object)
    moved = [tuple(np.array(point, object) + away) for point in other]
    try:
        found = intersections(one, moved, F(1, 2**10))
    except ValueError:
        assume(False)
    assert sum(within(crossing, s, t) for crossing in found) == 1
    assert sum(within(c._replace(one=c.other, other=c.one), s, t) for c in intersections(moved, one, F(1, 2**10))) == 1


# Refused

CUBE = [(0, 0, 0), (1, 1, 1)]


@pytest.mark.parametrize(
    ("one", "other", "tolerance", "words"),
    [
        (CUBE, PARABOLA, 1, "the first curve is not one curve in the plane"),
        (PARABOLA, [1, 2, 3], 1, "the second curve is not one"),
        ([PARABOLA, PARABOLA], PARABOLA, 1, "the first curve is not one"),
        (PARABOLA, [(0, 0), (1, symbols("x"))], 1, "control point b_1 is x"),
        (PARABOLA, [(0, 0), (1, float("inf"))], 1, "b_1 has coordinate inf"),
        (PARABOLA, PARABOLA, 0, "tolerance is 0: a positive"),
        (PARABOLA, PARABOLA, F(1, 2**1001), "at least 2\\^-1000"),
    ],
)
def test_what_is_refused_and_the_words(one, other, tolerance, words):
    with pytest.raises(ValueError, match=words) as caught:
        intersections(one, other, tolerance)
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 200
