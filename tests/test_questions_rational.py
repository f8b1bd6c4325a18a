"""The lesson on rational curves: answers worked on paper, and goals reached by what their words ask for alone."""

from fractions import Fraction as F
from types import SimpleNamespace

import numpy as np
import pytest

from bezteach.display import point
from bezteach.numeric import bspline, rational
from bezteach.questions import GOALS, QUESTIONS
from bezteach.questions.rational import ARCH, KNOTS, LOADS, QUARTER, SQUARE, middle

BY_HAND = {
    "half": "(3/5, 4/5)",  # (3/4, 1) over 5/4
    "heavy": "(2, 3)",  # (4, 6) over 2
    "how-many-knots": "12",
    "exercise-point": "(5/13, 12/13)",  # 1 - 4/9 and 4/3 over 1 + 4/9
    "exercise-lift": "(0, 0, 1) (6, 12, 3) (4, 0, 1)",
    "exercise-weight": "7",  # 7/8 of the way
    "exercise-half": "(1/3, 1)",  # (1/2, 3/2) over 3/2
    "exercise-gap": "1/8",  # x = y = 3/4
}


@pytest.mark.parametrize("name", BY_HAND)
def test_right_answers_by_hand(name):
    right = np.asarray(QUESTIONS[f"rational/{name}"].right(), dtype=object)
    assert (" ".join(map(point, right)) if right.ndim == 2 else point(right[()])) == BY_HAND[name]


def test_the_arch_obeys_the_share_that_the_questions_speak_of():
    assert [4 - middle(w)[1] for w in (1, 3, 6, 7)] == [2, 1, F(4, 7), F(1, 2)]  # 4 / (1 + w) is left


@pytest.mark.parametrize(("w", "x", "y"), [(1, F(3, 5), F(4, 5)), (-1, -1, 0)])
def test_where_the_quarter_and_the_rest_of_the_circle_are_at_half(w, x, y):
    assert rational.evaluate(QUARTER, (1, w, 2), F(1, 2)).tolist() == [x, y]


def test_four_quarters_are_the_circle_and_turn_left_all_the_way_round():
    t = [F(k, 6) for k in range(25)]
    places = rational.project(bspline.evaluate(rational.lift(SQUARE, LOADS), KNOTS, t)).tolist()
    assert all(x * x + y * y == 1 for x, y in places)
    assert [places[k] for k in (0, 6, 12, 18, 24)] == [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 0]]
    assert all(x * v - y * u > 0 for (x, y), (u, v) in zip(places, places[1:], strict=False))


def state(points, weights, t=F(1, 2)):
    return SimpleNamespace(points=points, weights=weights, t=t)


@pytest.mark.parametrize(
    ("points", "weights", "reached"),
    [
        (QUARTER, (1, 1, 2), True),
        (QUARTER, (2, 2, 4), True),
        (QUARTER, (1, 1, 1), False),
        (QUARTER, (1, 1, F(7, 4)), False),
        (((1, 0),) * 3, (1, 1, 2), False),
        (QUARTER[::-1], (2, 1, 1), False),
    ],
)
def test_goal_of_the_circle(points, weights, reached):
    assert GOALS["rational/circle"].reached(state(points, weights)) == reached


@pytest.mark.parametrize("t", [F(0), F(1, 2)])
@pytest.mark.parametrize(("w", "reached"), [(2, True), (1, False), (3, False)])
def test_goal_of_the_square(w, reached, t):
    goal = GOALS["rational/through"]
    assert goal.reached(state(ARCH, (1, w, 1), t)) == reached
    assert not goal.reached(state(((0, 0), (2, F(16, 3)), (4, 0)), (1, 1, 1), t))


def test_without_weights_no_goal_is_reached():
    """A polynomial curve is never a circle, and does not pass the square."""
    for goal, points in (("circle", QUARTER), ("through", ARCH)):
        assert not GOALS[f"rational/{goal}"].reached(SimpleNamespace(points=points, t=F(1, 2)))
