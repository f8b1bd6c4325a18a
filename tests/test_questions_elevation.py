"""The lesson on degree elevation: answers worked on paper, and goals reached by what their words ask for alone."""

from fractions import Fraction as F
from types import SimpleNamespace

import numpy as np
import pytest

from bezteach.display import point
from bezteach.questions import GOALS, QUESTIONS
from bezteach.questions.elevation import CUBIC, TASK

BY_HAND = {
    "elevate": "(0, 0) (2, 2) (4, 2) (6, 0)",
    "edge": "(6, 2)",
    "distance": "1/9",
    "degree": "2",
    "lower": "(0, 0) (3, 6) (9, 3)",
    "missing": "6",
    "nearest": "(1/20, -1/4, 19/20)",
}


@pytest.mark.parametrize("name", BY_HAND)
def test_right_answers_by_hand(name):
    right = np.asarray(QUESTIONS[f"elevation/exercise-{name}"].right(), dtype=object)
    assert (" ".join(map(point, right)) if right.ndim == 2 else point(right[()])) == BY_HAND[name]


def with_b2(*place):
    return (*TASK[:2], place, TASK[3])


@pytest.mark.parametrize(
    ("points", "is_reached"),
    [
        (with_b2(3, 4), True),
        (TASK, False),
        (with_b2(3, F(7, 2)), False),
        (tuple((x + 1, y) for x, y in with_b2(3, 4)), False),  # a parabola too, but all points moved
        ((*with_b2(3, 4), (9, 9)), False),
        (((0, 0), (1, 3), (6, 3)), False),
    ],
)
def test_goal_of_the_parabola(points, is_reached):
    assert GOALS["elevation/parabola"].reached(SimpleNamespace(points=points)) == is_reached


@pytest.mark.parametrize(
    ("line", "raised", "is_reached"),
    [
        (((0, F(5, 2)), (3, F(5, 2))), 1, True),
        (((3, F(3, 2)), (0, F(3, 2))), 1, True),
        (((0, 2), (3, 2)), 1, False),  # where the lesson's board begins
        (((0, 2), (3, 2)), 0, False),
        (((0, F(1, 2)), (3, F(1, 2))), 1, False),  # once and once
        (((0, 5), (3, 5)), 1, False),
        (((0, F(5, 2)), (3, F(5, 2))), 0, False),
    ],
)
def test_goal_of_the_line(line, raised, is_reached):
    goal = GOALS["elevation/cut-off"]
    assert goal.reached(SimpleNamespace(points=CUBIC, line=line, raised=raised)) == is_reached
    assert not goal.reached(SimpleNamespace(points=CUBIC[::-1], line=line, raised=raised))
