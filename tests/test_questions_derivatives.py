"""The lesson on derivatives: answers worked on paper, and goals reached by what their words ask for alone."""

from fractions import Fraction as F
from types import SimpleNamespace

import numpy as np
import pytest

from bezteach.display import point
from bezteach.questions import GOALS, QUESTIONS
from bezteach.questions.derivatives import CURVE

BY_HAND = {
    "end": "(-2, 2)",
    "from-velocity": "(3, 0)",
    "second-end": "(0, -36)",
    "hodograph": "(3, 9) (3, -6) (3, 6)",
    "from-triangle": "(3, 2)",
    "second-from-triangle": "(0, -12)",
    "curvature": "1/2",
}


@pytest.mark.parametrize("name", BY_HAND)
def test_right_answers_by_hand(name):
    right = np.asarray(QUESTIONS[f"derivatives/exercise-{name}"].right(), dtype=object)
    assert (" ".join(map(point, right)) if right.ndim == 2 else point(right)) == BY_HAND[name]


def reached(name, *points):
    return GOALS[f"derivatives/{name}"].reached(SimpleNamespace(points=points))


def with_b2(*place):
    return (*CURVE[:2], place, CURVE[3])


@pytest.mark.parametrize(
    ("b2", "straight", "same"),
    [
        ((3, 2), False, False),
        ((F(3, 2), 3), True, False),
        ((F(1, 2), 1), True, False),
        ((2, 0), False, True),
        ((F(7, 2), 3), False, True),
        ((3, 1), False, False),
    ],
)
def test_goals_on_the_circle_at_the_start(b2, straight, same):
    assert reached("straight-start", *with_b2(*b2)) == straight
    assert reached("same-circle", *with_b2(*b2)) == same


def test_goals_on_the_circle_want_the_other_points_where_they_were():
    moved = tuple((x + 1, y) for x, y in with_b2(2, 0))
    assert not reached("same-circle", *moved) and not reached("same-circle", *CURVE, (5, 5))
    assert not reached("straight-start", (0, 0), (1, 1), (2, 2), (3, 0)) and not reached("straight-start", *CURVE[:3])


@pytest.mark.parametrize(
    ("b1", "b2", "is_cusp"),
    [
        ((3, 2), (0, 2), True),
        ((4, F(5, 2)), (1, F(5, 2)), True),
        ((1, 2), (3, 2), False),
        ((3, 0), (0, 0), False),  # it stops at 1/2 and goes on: no cusp
    ],
)
def test_goal_of_the_cusp(b1, b2, is_cusp):
    assert reached("cusp", CURVE[0], b1, b2, CURVE[3]) == is_cusp
    assert not reached("cusp", (0, 1), b1, b2, CURVE[3])
    assert not reached("cusp", CURVE[0], b1, CURVE[3])
