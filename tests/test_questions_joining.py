"""The lesson on joining: goals reached by what their words ask for alone."""

from fractions import Fraction as F
from types import SimpleNamespace

import pytest

from bezteach.questions import GOALS
from bezteach.questions.joining import CORNER, EVEN, FAST, LEFT


def reached(name, right, place=None, to=None, t=F(1, 2)):
    points = [*LEFT, *right[1:]]
    if place is not None:
        points[place] = to
    return GOALS[f"joining/{name}"].reached(SimpleNamespace(points=tuple(points), t=t))


@pytest.mark.parametrize(
    ("to", "t", "is_c1"),
    [
        ((6, 4), F(1, 2), True),
        ((8, 4), F(1, 2), False),
        ((8, 4), F(1, 3), False),  # C1, but b_3 is not in the middle
        ((6, 4), F(1, 3), False),
        ((2, 4), F(1, 2), False),
        ((4, 2), F(1, 2), False),
    ],
)
def test_goal_of_the_corner(to, t, is_c1):
    assert reached("no-corner", CORNER, 4, to, t) == is_c1


def test_goal_of_the_corner_wants_the_other_points_where_they_were():
    assert not reached("no-corner", ((4, 4), (6, 4), (6, 1), (8, 2)))
    assert not reached("no-corner", CORNER[:3], 4, (6, 4))


def test_goal_of_the_clock():
    assert reached("clock", FAST, t=F(1, 3))
    assert not reached("clock", FAST, t=F(1, 2))
    assert not reached("clock", FAST, t=F(0)) and not reached("clock", FAST, t=F(1))
    assert not reached("clock", FAST, 4, (6, 4))


@pytest.mark.parametrize(
    ("to", "is_c2", "is_g2_alone"), [((8, 2), True, False), ((9, 2), False, True), ((8, 3), False, False)]
)
def test_goals_of_the_second_derivative(to, is_c2, is_g2_alone):
    assert reached("close-the-frame", EVEN, 5, to) == is_c2
    assert reached("same-bend", EVEN, 5, to) == is_g2_alone


def test_goals_of_the_second_derivative_want_the_other_points_where_they_were():
    assert not reached("close-the-frame", ((4, 4), (6, 4), (8, 2), (9, 9)))
    assert not reached("same-bend", EVEN, 5, (9, 2), t=F(1, 3))


@pytest.mark.parametrize("name", ["no-corner", "close-the-frame", "same-bend"])
def test_a_goal_that_wants_equal_intervals_says_so(name):
    assert GOALS[f"joining/{name}"].text.startswith("Task: t stays 1/2.")
