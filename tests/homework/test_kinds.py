"""Questions of each kind, made for the test: forms that are asked for, and positions of a board."""

from fractions import Fraction as F

import pytest
from sympy import Eq, Integer, Sum

from bezteach import numeric
from bezteach.homework import CORRECT, INVALID, PARTLY, UNATTEMPTED, WRONG
from bezteach.homework.formulas import is_bernstein, is_expanded
from bezteach.homework.kinds import (
    asks_derivation,
    asks_formula,
    asks_position,
    asks_truth,
    asks_value,
    judged,
    within,
    written,
)
from bezteach.symbolic import B, i, n, t

POWERS = asks_formula(
    lambda data: "B(1, 2, t) in powers", lambda data: 2 * t - 2 * t**2, {t}, form=("multiplied out", is_expanded)
)
BERNSTEIN = asks_formula(
    lambda data: "t^2",
    lambda data: t**2,
    {t},
    form=("in the Bernstein basis of degree 2", lambda f: is_bernstein(f, 2, t)),
)


def test_a_form_that_is_asked_for():
    assert judged(POWERS, {}, "2t - 2t^2").status == CORRECT
    assert judged(POWERS, {}, "2t(1-t)") == (
        PARTLY,
        "This is equal, but it is not multiplied out, as it was asked for.",
    )
    assert judged(POWERS, {}, "2t - t^2").status == WRONG
    assert judged(BERNSTEIN, {}, "B(2,2,t)").status == CORRECT
    assert judged(BERNSTEIN, {}, "t^2").status == PARTLY


def ends(data, points):
    return tuple(points[0]) == (0, 0) and tuple(points[-1]) == data["end"]


def passes(data, points):
    return tuple(numeric.evaluate(points, F(1, 2))) == (1, 1)


PULL = asks_position(
    lambda data: "A quadratic from (0, 0) to the end that passes (1, 1) at t = 1/2.",
    [(ends, "The ends are not where they should be."), (passes, "At t = 1/2 it is not at (1, 1).")],
    lambda data: [(0, 0), (1, 2), (2, 0)],
)


@pytest.mark.parametrize(
    ("answer", "status", "said"),
    [
        ("(0, 0), (1, 2), (2, 0)", CORRECT, "all that was asked for"),
        ("(0, 0), (1, 1), (2, 0)", PARTLY, "At t = 1/2"),
        ("(0, 1), (1, 1), (2, 0)", WRONG, "The ends"),
        ([(0, 0), (1, 2.0), (2, 0)], INVALID, "write fractions"),
        ("(0, 0, 0), (1, 2, 0), (2, 0, 0)", INVALID, "a plane"),
        ("(0, 0)", INVALID, "a list of points"),
        (..., UNATTEMPTED, "Not answered"),
    ],
)
def test_a_position_with_properties(answer, status, said):
    verdict = judged(PULL, {"end": (2, 0)}, answer)
    assert verdict.status == status and said in verdict.feedback


def test_its_solution_is_right():
    assert judged(PULL, {"end": (2, 0)}, PULL.solution({})).status == CORRECT


def test_data_that_cannot_tell_a_mistake_from_the_right_answer_are_known():
    question = asks_value(
        "number", lambda data: "", lambda data: data["t"], lambda data: [(1 - data["t"], "exchanged")]
    )
    assert question.apart({"t": F(1, 3)}) and not question.apart({"t": F(1, 2)})


def test_solutions_are_written_as_they_are_pasted():
    assert written((F(1, 2), F(-3))) == "(Fraction(1, 2), -3)"
    assert written(((F(0), F(1)), (F(1), F(0)))) == "[(0, 1), (1, 0)]"


@pytest.mark.parametrize(
    ("places", "inside"), [((2, 2), True), ((2, 3), False), ((0, 0), False), ((9, 9), True), ((10, 0), False)]
)
def test_whether_values_are_in_ranges_that_depend_on_each_other(places, inside):
    values = dict(zip((n, i), map(Integer, places), strict=True))
    assert within(values, {n: (1, 9), i: (0, n)}) is inside


def test_what_the_prover_cannot_decide_is_no_question(monkeypatch):
    monkeypatch.setattr("bezteach.homework.kinds.SECONDS", 0.0)
    hard = asks_truth(lambda data: "", lambda data: Eq(Sum(B(i, n, t), (i, 0, n)), Integer(1), evaluate=False), {})
    with pytest.raises(ValueError, match="a question of truth that is"):
        judged(hard, {}, True)


def test_a_derivation_begins_and_ends_as_its_lines():
    question = asks_derivation(lambda data: "", (t + t * n, t * (1 + n)), {t, n}, {}, least=0)
    assert judged(question, {}, question.solution({})).status == CORRECT
    assert judged(question, {}, "t(1+n)\n= t + t n").status == WRONG
