"""The lesson on B-splines: goals reached by what their words ask for alone."""

from fractions import Fraction as F
from types import SimpleNamespace

import pytest

from bezteach.numeric import bspline
from bezteach.questions import GOALS
from bezteach.questions.bsplines import CUBIC, CUBIC_KNOTS, KNOTS, QUADRATIC, one_function


def reached(name, points=QUADRATIC, knots=KNOTS):
    state = SimpleNamespace(points=tuple(map(tuple, points)), knots=tuple(map(F, knots)), t=F(1))
    return GOALS[f"bsplines/{name}"].reached(state)


def moved(place, to=(3, 7)):
    return [to if i == place else there for i, there in enumerate(QUADRATIC)]


def test_the_knots_of_the_first_board_are_the_transcript_s():
    assert KNOTS == (0, 0, 0, 1, 2, 3, 4, 4, 4)
    assert CUBIC_KNOTS == (0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4)


@pytest.mark.parametrize(
    ("knots", "t", "value"),
    [((0, 1), F(1, 2), 1), ((0, 1, 3), 2, F(1, 2)), ((0, 1, 2, 3), F(1, 2), F(1, 8)), ((0, 1, 3, 4), 2, F(2, 3))],
)
def test_one_function_over_all_its_knots(knots, t, value):
    assert one_function(knots, t) == value


@pytest.mark.parametrize(("place", "two_spans"), [(0, False), (1, True), (2, False), (3, False), (4, True), (5, False)])
def test_the_second_point_from_either_end_moves_two_spans(place, two_spans):
    assert reached("two-spans", moved(place)) == two_spans


def test_two_spans_want_one_moved_point_and_the_knots_where_they_were():
    assert not reached("two-spans")
    assert not reached("two-spans", [(1, 1), *moved(1)[1:]])
    assert not reached("two-spans", moved(1), (0, 0, 0, 1, 2, F(7, 2), 4, 4, 4))
    assert not reached("two-spans", moved(1)[:5], KNOTS)


@pytest.mark.parametrize(
    ("knots", "touches"),
    [
        ((0, 0, 0, 1, F(3, 2), 3, 4, 4, 4), True),
        ((0, 0, 0, F(5, 3), 2, 3, 4, 4, 4), True),
        ((0, 0, 0, 1, F(5, 4), 2, 4, 4, 4), True),
        (KNOTS, False),
        ((0, 0, 0, 1, 1, 3, 4, 4, 4), False),
    ],
)
def test_the_edge_is_touched_where_the_knots_divide_the_time(knots, touches):
    assert reached("quarter", knots=knots) == touches
    assert not reached("quarter", moved(0), knots)


@pytest.mark.parametrize(
    ("knots", "corner"),
    [
        ((0, 0, 0, 1, 1, 3, 4, 4, 4), True),
        ((0, 0, 0, 1, 3, 3, 4, 4, 4), True),
        ((0, 0, 0, 2, 2, 2, 4, 4, 4), False),  # the curve is torn
        ((0, 0, 0, 0, 2, 3, 4, 4, 4), False),  # and here an end of it
        (KNOTS, False),
    ],
)
def test_a_corner_is_a_double_knot_inside(knots, corner):
    assert reached("corner", knots=knots) == corner
    assert not reached("corner", moved(3), knots)


def test_a_corner_wants_no_inserted_knot():
    points, knots = bspline.insert(QUADRATIC, KNOTS, 1)
    assert not reached("corner", points, knots)


@pytest.mark.parametrize(
    ("knots", "passes"),
    [
        ((0, 0, 0, 0, 2, 2, 2, 4, 4, 4, 4), True),
        ((0, 0, 0, 0, 1, 1, 1, 4, 4, 4, 4), True),
        ((0, 0, 0, 0, 2, 2, 3, 4, 4, 4, 4), False),
        (CUBIC_KNOTS, False),
    ],
)
def test_a_cubic_passes_a_control_point_where_three_knots_are_one(knots, passes):
    assert reached("through", CUBIC, knots) == passes
    on_it = any((bspline.evaluate(CUBIC, knots, knot) == CUBIC[3]).all() for knot in set(knots))
    assert on_it == passes


@pytest.mark.parametrize(("at", "times", "done"), [(2, 0, False), (2, 1, False), (2, 2, True), (1, 2, False)])
def test_the_knot_is_inserted_twice_more(at, times, done):
    assert reached("insert", *bspline.insert(CUBIC, CUBIC_KNOTS, at, times)) == done


def test_inserting_means_that_no_point_is_moved_by_hand():
    points, knots = bspline.insert(CUBIC, CUBIC_KNOTS, 2, 2)
    assert not reached("insert", [(1, 1), *points[1:]], knots)
