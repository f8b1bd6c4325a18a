"""The lesson on the properties of the curve: answers worked on paper, and goals reached by what their words ask for."""

from fractions import Fraction as F
from types import SimpleNamespace

import numpy as np
import pytest

from bezteach.display import point
from bezteach.numeric import evaluate
from bezteach.questions import GOALS, QUESTIONS
from bezteach.questions.curve import ARCH, CUBIC, DENT, HEIGHTS, LOOP

BY_HAND = {
    "end": "(8, -12)",
    "second": "(0, -12)",
    "passages": "3",
    "mapped": "(1/3, 14/3)",
    "backwards": "(-3, -6)",
    "range": "(0, 2)",
    "pull": "(64, 0)",
}


@pytest.mark.parametrize("name", BY_HAND)
def test_right_answers_by_hand(name):
    assert point(np.asarray(QUESTIONS[f"curve/exercise-{name}"].right(), dtype=object)) == BY_HAND[name]


def test_numbers_in_the_words():
    """What questions and feedback say of their curves."""
    assert tuple(evaluate(DENT, F(1, 2))) == (F(9, 8), F(21, 8))
    assert tuple(evaluate([(0, 0), (0, 0), (2, 1), (6, 3)], F(1, 2))) == (F(3, 2), F(3, 4))
    assert tuple(evaluate([0, 1, 0, 0], [F(1, 3), F(9, 10)])) == (F(4, 9), F(27, 1000))
    assert max(x + y for x, y in DENT) == 6
    assert len(HEIGHTS) == 6 and len(ARCH) == 4
    assert [evaluate([y for _, y in LOOP], t) for t in (0, F(1, 2))] == [0, 0]


def reached(name, points=CUBIC, line=((0, 0), (1, 0))):
    points = tuple((F(x), F(y)) for x, y in points)
    return GOALS[f"curve/{name}"].reached(SimpleNamespace(points=points, line=line))


@pytest.mark.parametrize(
    ("points", "there"),
    [
        (((0, 0), (2, 0), (3, 5), (3, 3)), True),
        (((0, 0), (6, 0), (3, 9), (3, 3)), False),  # the edges are as long as the velocities should be
        (((0, 0), (2, 0), (3, 1), (3, 3)), False),  # it arrives upwards
        (((1, 0), (3, 0), (3, 5), (3, 3)), False),  # the start has moved
        (((0, 0), (F(3, 2), 0), (1, 1), (3, F(9, 2)), (3, 3)), False),  # a point more
        (CUBIC, False),
    ],
)
def test_goal_of_the_velocities(points, there):
    assert reached("velocities", points) == there


@pytest.mark.parametrize(
    ("line", "there"),
    [
        (((F(5, 3), F(3, 2)), (F(8, 3), 2)), False),
        (((0, 1), (2, 2)), True),  # y = 1 + x/2 crosses at three places in (0, 3)
        (((2, 2), (0, 1)), True),
        (((0, F(3, 2)), (3, F(3, 2))), False),  # three passages of the polygon, one of the curve
        (((0, 5), (1, 5)), False),
        (((0, 0), (3, 3)), False),  # through both ends, which are not crossed
    ],
)
def test_goal_of_the_three_crossings(line, there):
    heights = [
        y - line[0][1] - (x - line[0][0]) * F(line[1][1] - line[0][1], line[1][0] - line[0][0]) for x, y in CUBIC
    ]
    along = [evaluate(heights, F(k, 240)) for k in range(241)]
    crossings = sum(one * other < 0 for one, other in zip(along, along[1:], strict=False))
    crossings += sum(a * c < 0 and b == 0 for a, b, c in zip(along, along[1:], along[2:], strict=False))
    assert (crossings == 3) == there
    assert reached("three-crossings", line=line) == there


def test_goal_of_the_three_crossings_wants_the_curve_as_it_was():
    assert not reached("three-crossings", ((0, 0), (1, 9), (2, -6), (3, 3)), ((0, 1), (2, 2)))


def quartic(w, *, side=F(1, 4)):
    return ((0, 0), (F(1, 4), side), (F(1, 2), w), (F(3, 4), F(1, 4)), (1, 0))


@pytest.mark.parametrize(
    ("w", "there"),
    [(0, True), (F(1, 8), True), (F(3, 16), True), (F(1, 4), False), (F(-1, 16), False), (F(3, 4), False)],
)
def test_goal_of_the_dented_polygon(w, there):
    assert reached("dented", quartic(w)) == there
    assert not reached("dented", quartic(w, side=F(1, 2)))
    assert not reached("dented", (*quartic(w), (1, 0))) and not reached("dented", quartic(w)[:2])


@pytest.mark.parametrize(
    ("points", "there"),
    [
        (((0, 0), (1, 3), (4, 2), (3, 3)), True),
        (((0, 0), (3, 4), (2, 1), (3, 3)), False),  # there, but by b_1
        (((0, 0), (1, 3), (F(11, 4), F(11, 8)), (3, 3)), False),  # b_2 has gone as far as the point should
        (CUBIC, False),
        (CUBIC[:3], False),
        ((*CUBIC, (3, 3)), False),
    ],
)
def test_goal_of_the_pulled_point(points, there):
    assert reached("pulled", points) == there
