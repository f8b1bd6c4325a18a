"""The tasks of the lesson on de Casteljau's algorithm are reached by what they ask for alone; its answers by hand."""

from fractions import Fraction as F

import pytest

from bezteach import widgets
from bezteach.questions import GOALS, QUESTIONS, judge
from bezteach.questions.casteljau import TENT


@pytest.mark.parametrize(
    ("name", "answer"),
    [
        ("missing-level", "(4/3, 16/9) (7/3, 19/9)"),
        ("exercise-point", "(3/8, 17/16)"),
        ("exercise-level", "(1/2, 19/16) (3/2, 9/4)"),
        ("exercise-tangent", "(33/8, 21/8)"),
        ("exercise-path", "(1, 4) (2, 0) (3, 4)"),
        ("exercise-count", "126"),
    ],
)
def test_answers_worked_on_paper(name, answer):
    assert judge(QUESTIONS[f"casteljau/{name}"], answer) == (True, "Right.")


@pytest.mark.parametrize(
    ("name", "points", "t", "reached"),
    [
        ("horizontal", TENT, F(2, 3), True),
        ("horizontal", TENT, F(1, 3), False),
        ("horizontal", ((0, 0), (2, 4), (6, 4)), 1, False),
        ("horizontal", ((0, 0), (0, 0), (0, 0)), F(2, 3), False),
        ("still", ((0, 0), (2, 4), (0, 0)), F(1, 2), True),
        ("still", TENT, F(1, 2), False),
        ("still", ((0, 0), (2, 4), (0, 0)), F(1, 3), False),
        ("still", ((1, 1), (1, 1), (1, 1)), F(1, 2), False),
        ("still", ((0, 0), (2, 4), (0, 0), (0, 0)), F(1, 2), False),
    ],
)
def test_a_board_recognises_its_goal_and_nothing_else(name, points, t, reached):
    goal = GOALS[f"casteljau/{name}"]
    board = widgets.explore_tangents(TENT, goal=goal)
    assert goal.text in board.text
    board.points, board.t = points, t
    assert (goal.praise in board.text) == reached
    assert (goal.text in board.text) != reached
