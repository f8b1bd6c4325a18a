"""The lesson on why Bernstein's basis: answers worked on paper, and a goal reached by what its words ask for alone."""

from fractions import Fraction as F
from types import SimpleNamespace

import numpy as np
import pytest

from bezteach.display import point
from bezteach.questions import GOALS, QUESTIONS

BY_HAND = {
    "end": "(0, 1)",
    "smooth": "(0, 0, 1, 1)",
    "exercise-circle": "(4/5, 3/5)",
    "exercise-from-power": "(1, 2) (3, 1) (2, 1)",
    "exercise-to-power": "(2, 0) (-2, 6) (4, -4)",
    "exercise-fit": "(1/2, 7/2)",
    "exercise-move": "(0, 3)",
    "exercise-pull": "(2, 6)",
    "exercise-way": "1/3",
}


@pytest.mark.parametrize("name", BY_HAND)
def test_right_answers_by_hand(name):
    right = np.asarray(QUESTIONS[f"why/{name}"].right(), dtype=object)
    assert (" ".join(map(point, right)) if right.ndim == 2 else point(right) if right.ndim else str(right)) == BY_HAND[
        name
    ]


def test_every_typed_answer_is_written_out_here():
    assert {
        name for name, question in QUESTIONS.items() if name.startswith("why/") and hasattr(question, "mistakes")
    } == {f"why/{name}" for name in BY_HAND}


def reached(*points):
    return GOALS["why/through"].reached(SimpleNamespace(points=points))


def test_the_goal_is_reached_by_the_middle_point_alone():
    """(1, 0)/4 + b_1/2 + (0, 1)/4 = (1, 1) needs b_1 = (3/2, 3/2)."""
    assert reached((1, 0), (F(3, 2), F(3, 2)), (0, 1))
    assert not reached((1, 0), (0, 0), (0, 1)) and not reached((1, 0), (1, 1), (0, 1))
    assert not reached((2, 1), (F(1, 2), F(1, 2)), (1, 2))  # it passes there too, with other ends
    assert not reached((1, 0), (F(3, 2), F(3, 2)), (F(3, 2), F(3, 2)), (0, 1)) and not reached((1, 0), (0, 1))


def test_the_graph_of_the_task_runs_from_0_to_1_and_is_flat_at_both_ends():
    b = list(map(F, QUESTIONS["why/smooth"].right()))
    assert (b[0], b[3]) == (0, 1) and b[0] == b[1] and b[2] == b[3]
    assert [F(c) for c in (0, 0, 3, -2)] == [
        b[0],
        3 * (b[1] - b[0]),
        3 * (b[0] - 2 * b[1] + b[2]),
        b[3] - 3 * b[2] + 3 * b[1] - b[0],
    ]
