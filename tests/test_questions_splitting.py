"""The lesson on splitting, sections on boxes, roots and crossings: answers worked on paper, and the goal's edges."""

from fractions import Fraction as F
from types import SimpleNamespace

import numpy as np
import pytest

from bezteach.display import point
from bezteach.numeric import box, evaluate, flatten, intersections, roots, split
from bezteach.questions import GOALS, QUESTIONS

CUBIC = [(0, 0), (1, 3), (2, 1), (3, 3)]
BY_HAND = {
    "box": "2",  # halves 0, 2, 3/2 and 3/2, 1, -2
    "left-heights": "(2, -1/2, -3/4)",
    "apart": "3",  # pieces 1/4 long beside the diagonals: [i, i+1] and [k+4, k+5] in x, [i, i+1] and [k, k+1] in y
}
CHOICES = {
    "finer": "10",
    "box-top": "to y = 1",
    "two-changes": "two or none: the signs do not tell",
    "boxes-overlap": "nothing",
    "most-crossings": "9 times",
    "exercise-count": "two roots, one in each half",
}


@pytest.mark.parametrize("name", BY_HAND)
def test_right_answers_by_hand(name):
    assert point(np.asarray(QUESTIONS[f"splitting/exercise-{name}"].right(), dtype=object)) == BY_HAND[name]


@pytest.mark.parametrize("name", CHOICES)
def test_right_choices(name):
    assert QUESTIONS[f"splitting/{name}"].right == CHOICES[name]


def test_the_choices_are_true():
    coarse, fine = (len(flatten(CUBIC, tolerance)) - 1 for tolerance in (F(1, 1000), F(1, 100000)))
    assert fine / coarse == pytest.approx(10, rel=0.02)
    parabola = [(0, 0), (1, 2), (2, 0)]
    assert (
        box(parabola)[1][1] == 2
        and evaluate(parabola, F(1, 2))[1] == 1
        and max(evaluate(parabola, [F(1, 3), F(2, 3)])[:, 1]) < 1
    )
    assert roots([1, -1, 2]) == [] and len(roots([1, -9, 2])) == 2
    assert intersections(parabola, [(0, F(3, 2)), (2, F(3, 2))]) == []
    assert [len(roots(half)) for half in split([2, -3, 1], F(1, 2))] == [1, 1]


def reached(*heights, line=((0, 0), (1, 0))):
    points = tuple((F(k, len(heights) - 1), height) for k, height in enumerate(heights))
    return GOALS["splitting/three-changes-one-root"].reached(SimpleNamespace(points=points, line=line))


@pytest.mark.parametrize(
    ("heights", "is_reached"),
    [
        ((-4, 7, -7, 4), False),  # three roots
        ((-4, 1, -1, 4), True),
        ((-4, 7, -1, 4), True),
        ((4, -1, 1, -4), True),
        ((-1, 1, -1, 1), True),  # (2t - 1)^3: one place
        ((-4, 1, 1, 4), False),  # one change
        ((-4, 0, 0, 4), False),
        ((0, 7, -7, 4), False),
        ((0, 0, 0, 0), False),
    ],
)
def test_goal_of_three_changes_and_one_root(heights, is_reached):
    assert reached(*heights) == is_reached


def test_the_goal_is_about_the_line_where_it_has_been_moved():
    assert not reached(-4, 1, -1, 4, line=((0, 2), (1, 2)))
    assert reached(-3, 2, 0, 5, line=((0, 1), (2, 1))) and reached(-4, 1, -1, 4, line=((1, 0), (0, 0)))
    assert not reached(-4, 1, -1, 4, line=((0, 0), (0, 1)))


@pytest.mark.parametrize(
    ("points", "depth", "is_reached"),
    [
        (CUBIC, 4, True),  # D = 5: 15/8 over 64 is 15/512, over 256 it is 15/2048
        (CUBIC, 3, False),
        (CUBIC, 5, False),
        ([(10 * x, 10 * y) for x, y in CUBIC], 4, False),
        ([(10 * x, 10 * y) for x, y in CUBIC], 5, True),
        ([(0, 0), (1, 0), (2, F(2, 25))], 0, False),  # D = 2/25 promises 1/50 without a halving
        ([(0, 0), (1, 0), (2, F(8, 25))], 1, True),
        ([(0, 0), (1, 1)], 0, False),
        ([(0, 0), (1, 1)], 1, False),
    ],
)
def test_goal_of_just_enough_halvings(points, depth, is_reached):
    state = SimpleNamespace(points=tuple(points), depth=depth)
    assert GOALS["splitting/just-enough"].reached(state) == is_reached
