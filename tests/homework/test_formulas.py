"""Formulas: right only by proof, wrong only with a place where they are, and open otherwise."""

import pytest
from sympy import Interval, Rational, oo, sqrt

from bezteach.homework import CORRECT, OPEN, WRONG, InvalidAnswer
from bezteach.homework.formulas import compared, formula_of, is_bernstein, is_expanded, is_factored
from bezteach.symbolic import B, b, i, n, t

RANGES = {n: (1, oo), i: (0, n), t: Interval.open(0, 1)}
DERIVATIVE = n * (B(i - 1, n - 1, t) - B(i, n - 1, t))
MISTAKES = [
    (B(i - 1, n - 1, t) - B(i, n - 1, t), "a factor n is missing"),
    (n * (B(i, n - 1, t) - B(i - 1, n - 1, t)), "the two terms are the other way round"),
]
LETTERS = {i, n, t, b}


def judged(answer, right=DERIVATIVE, ranges=RANGES, mistakes=MISTAKES):
    return compared(formula_of(answer, LETTERS), right, ranges, mistakes)


@pytest.mark.parametrize(
    "answer",
    [
        "n (B(i-1, n-1, t) - B(i, n-1, t))",
        "n B(i-1,n-1,t) - n B(i,n-1,t)",
        "-n (B_{i,n-1}(t) - B_{i-1,n-1}(t))",
        "n C(n-1,i-1) t^(i-1) (1-t)^(n-i) - n C(n-1,i) t^i (1-t)^(n-1-i)",
        "diff(B(i,n,t), t)",
    ],
)
def test_one_formula_in_many_forms_is_proved_for_every_degree(answer):
    assert judged(answer).status == CORRECT


def test_a_known_mistake_is_named_in_any_form():
    assert judged("B(i-1,n-1,t) - B(i,n-1,t)") == (WRONG, "a factor n is missing")
    assert judged("n B(i,n-1,t) - n B(i-1,n-1,t)") == (WRONG, "the two terms are the other way round")


def test_another_mistake_is_shown_at_its_simplest_place():
    verdict = judged("(n-1) (B(i-1,n-1,t) - B(i,n-1,t))")
    assert verdict == (WRONG, "At n = 1, i = 0, t = 1/2 your formula is 0, and that is not right.")
    assert judged("n B(i-1,n-1,t)/i").feedback.endswith("has no value (division by 0).")


def test_a_number_for_the_degree():
    right = 3 * t**2 - 2 * t**3
    assert judged("B(2,3,t) + B(3,3,t)", right, {}, ()).status == CORRECT
    assert judged("t^2 (3 - 2t)", right, {}, ()).status == CORRECT
    assert judged("3t^2 - t^3", right, {}, ()).status == WRONG
    assert judged("1/3", Rational(1, 3), {}, ()).status == CORRECT


def test_points_may_stand_in_a_formula():
    right = n * (b[1] - b[0])
    assert judged("n (b_1 - b_0)", right, {n: (1, oo)}, ()).status == CORRECT
    assert judged("b_1 - b_0", right, {n: (1, oo)}, ()).status == WRONG


def test_what_cannot_be_decided_is_open_and_not_wrong(monkeypatch):
    monkeypatch.setattr("bezteach.homework.formulas.SECONDS", 0.0)
    verdict = judged("n B(i-1,n-1,t) - n B(i,n-1,t)")
    assert verdict.status == OPEN and "could not be decided. At n = 1, i = 0, t = 1/2 both are -1." in verdict.feedback
    assert judged("n (B(i-1,n-1,t) - B(i,n-1,t))").status == CORRECT  # letter by letter what is right


def test_where_nothing_can_be_computed_it_is_open_too():
    verdict = judged("sqrt(t^3)/t - t^2 + t^2", sqrt(t), {t: Interval.open(0, 1)}, ())
    assert verdict == (
        OPEN,
        "Whether this is the right formula could not be decided. At t = 1/4 both are 1/2. Write it in a simpler form.",
    )


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("t, t", "this is a list: one formula is asked for"),
        (0.5, "this is a decimal number: write it as a fraction"),
        ("t = 1", "this is a statement: one formula is asked for"),
        ("x + t", "x does not occur in the task"),
        ("t + ", "character"),
        (True, "True is no number"),
    ],
)
def test_what_is_no_formula(answer, said):
    with pytest.raises(InvalidAnswer) as problem:
        formula_of(answer, LETTERS)
    assert said in str(problem.value)


@pytest.mark.parametrize(
    ("text", "expanded", "factored"),
    [
        ("t^2 - 2t + 1", True, False),
        ("(t - 1)^2", False, True),
        ("3 t (1 - t)^2", False, True),
        ("t (t^2 - 1)", False, False),
        ("t^2 + 1", True, True),
        ("5", True, True),
        ("2t", True, True),
    ],
)
def test_forms(text, expanded, factored):
    formula = formula_of(text, {t})
    assert (is_expanded(formula), is_factored(formula)) == (expanded, factored)


@pytest.mark.parametrize(
    ("text", "is_one"),
    [
        ("B(0,2,t)/3 + 2 B(2,2,t)", True),
        ("2 (B(0,2,t) - B(1,2,t))", True),
        ("B(0,2,t) + 1", False),
        ("B(0,2,t)^2", False),
        ("B(0,2,t) B(1,2,t)", False),
        ("t B(0,2,t)", False),
        ("B(0,3,t)", False),
        ("B(0,2,1-t)", False),
    ],
)
def test_the_bernstein_form(text, is_one):
    assert is_bernstein(formula_of(text, {t}), 2, t) is is_one
