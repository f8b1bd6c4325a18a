"""The lesson on the basis: its goal is reached by what its words ask for alone."""

from fractions import Fraction as F
from types import SimpleNamespace

import pytest

from bezteach.questions import GOALS


@pytest.mark.parametrize(
    ("heights", "straight"),
    [
        ((0, F(1, 3), F(2, 3), 1), True),
        ((1, F(1, 2), 0, F(-1, 2)), True),
        ((1, 1, 1, 1), False),
        ((0, 1, 0, 1), False),
        ((0, 1, 2), False),
    ],
)
def test_goal_of_the_straight_line(heights, straight):
    points = tuple((F(i, 3), y) for i, y in enumerate(heights))
    assert GOALS["basis/straight"].reached(SimpleNamespace(points=points)) == straight
