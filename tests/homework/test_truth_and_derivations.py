"""True or false with a counterexample that refutes; derivations of which every line is proved."""

import pytest
from sympy import Eq, Integer, Sum, oo

from bezteach.homework import CORRECT, OPEN, PARTLY, WRONG, InvalidAnswer, derivations, truth
from bezteach.symbolic import B, b, i, j, n, t

UNITY = Eq(Sum(B(i, n, t), (i, 1, n)), Integer(1), evaluate=False)  # from 1: false


def decided(answer, relation=UNITY, right=False, allowed=lambda places: places.get(n, 0) >= 1):
    return truth.compared(truth.truth_of(answer), relation, allowed, right)


@pytest.mark.parametrize("answer", [(False, "n = 1, t = 1/2"), "false: n = 1, t = 1/2", [False, "t = 1/2, n = 1"]])
def test_a_counterexample_refutes(answer):
    assert decided(answer) == (CORRECT, "Right: there the sides are 1/2 and 1.")


@pytest.mark.parametrize(
    ("answer", "status", "said"),
    [
        (False, PARTLY, "Now a counterexample: a number for each of n, t."),
        ((False, "n = 1, t = 1"), PARTLY, "there the statement holds: both sides give 1 and 1"),
        ((False, "n = 0, t = 1/2"), PARTLY, "outside of what the statement speaks of"),
        ((False, "n = 1/2, t = 1/2"), PARTLY, "outside of what the statement speaks of"),
        ((False, "n = 1"), PARTLY, "a number for each of t."),
        (True, WRONG, "There is a place where it fails"),
        ("True", WRONG, "There is a place where it fails"),
    ],
)
def test_what_does_not_refute_is_said(answer, status, said):
    verdict = decided(answer)
    assert verdict.status == status and said in verdict.feedback


def test_what_is_true_needs_no_counterexample():
    whole = Eq(Sum(B(i, n, t), (i, 0, n)), Integer(1), evaluate=False)
    assert decided("true", whole, True).status == CORRECT
    assert decided(False, whole, True).status == WRONG


@pytest.mark.parametrize(
    "answer",
    [
        1,
        0,
        "yes",
        "false: n > 1",
        "false: 2 = n",
        "false: n = t",
        "false: n = 1, n = 2",
        "false n = 1",
        (False, 1),
        (True, "n = 1"),
    ],
)
def test_what_is_no_such_answer(answer):
    with pytest.raises(InvalidAnswer):
        truth.truth_of(answer)


# ---- Derivations


def followed(answer, start, goal, ranges, **settings):
    return derivations.compared(derivations.lines_of(answer, {i, n, t, b}), start, goal, ranges, **settings)


RANGES = {n: (1, oo), i: (0, n)}
LEFT, RIGHT = t * B(i, n, t), (i + 1) / (n + 1) * B(i + 1, n + 1, t)
PROOF = """t B(i,n,t)
= t C(n,i) t^i (1-t)^(n-i)
= C(n,i) t^(i+1) (1-t)^(n-i)
= (i+1)/(n+1) * C(n+1,i+1) t^(i+1) (1-t)^(n-i)
= (i+1)/(n+1) * B(i+1,n+1,t)"""


def test_a_proof_of_which_every_line_is_proved():
    assert followed(PROOF, LEFT, RIGHT, RANGES) == (CORRECT, "Right: each of the 4 steps is proved.")
    assert followed(PROOF.splitlines(), LEFT, RIGHT, RANGES).status == CORRECT


def test_the_first_wrong_line_is_named_with_a_place():
    verdict = followed(PROOF.replace("(i+1)/(n+1) * C(n+1", "(i+1)/n * C(n+1"), LEFT, RIGHT, RANGES)
    assert verdict.status == PARTLY
    assert verdict.feedback.startswith("Line 4 does not follow from line 3: n = 1, i = 0, t = ")


def test_it_begins_and_ends_as_asked():
    assert followed(PROOF, RIGHT, LEFT, RANGES).status == WRONG
    short = "\n".join(PROOF.splitlines()[:4])
    assert followed(short, LEFT, RIGHT, RANGES).feedback.startswith("Every line follows from the one before. Go on")


def test_the_statement_alone_is_no_proof():
    both = "t B(i,n,t)\n= (i+1)/(n+1) * B(i+1,n+1,t)"
    assert followed(both, LEFT, RIGHT, RANGES).status == PARTLY
    padded = "t B(i,n,t)\n= t B(i,n,t)\n= (i+1)/(n+1) * B(i+1,n+1,t)"
    assert followed(padded, LEFT, RIGHT, RANGES).status == PARTLY
    assert followed(both, LEFT, RIGHT, RANGES, least=0).status == CORRECT


def test_a_line_in_which_all_cancels_counts_and_the_same_formula_in_another_order_does_not():
    unity = Sum(B(i, n, t), (i, 0, n))
    assert followed("sum(B(i,n,t), i, 0, n)\n= ((1-t) + t)^n\n= 1", unity, Integer(1), {n: (0, oo)}).status == CORRECT
    turned = "t B(i,n,t)\n= B(i,n,t) t\n= (i+1)/(n+1) * B(i+1,n+1,t)"
    assert followed(turned, LEFT, RIGHT, RANGES).status == PARTLY


def test_an_index_may_have_any_name():
    unity = Sum(B(i, n, t), (i, 0, n))
    named = "sum(B(j,n,t), j, 0, n)\n= ((1-t) + t)^n\n= 1"
    lines = derivations.lines_of(named, {j, n, t})
    assert derivations.compared(lines, unity, Integer(1), {n: (0, oo)}).status == CORRECT


def test_a_step_that_is_not_decided_leaves_it_open(monkeypatch):
    monkeypatch.setattr(derivations, "SECONDS", 0.0)
    assert followed(PROOF, LEFT, RIGHT, RANGES).status == OPEN


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("t", "a derivation has 2 to 30 lines, and this one has 1"),
        ("t\n" * 31, "2 to 30 lines"),
        ("t\n= t +", "line 2: character"),
        ("t\n= x", "line 2: x does not occur in the task"),
        (["t", 1], "a derivation is a text of several lines"),
        (5, "a derivation is a text of several lines"),
    ],
)
def test_what_is_no_derivation(answer, said):
    with pytest.raises(InvalidAnswer) as problem:
        derivations.lines_of(answer, {t})
    assert said in str(problem.value)
