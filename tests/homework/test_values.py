"""Numbers, points, lists of points and matrices: what is right, what is said to what is not."""

from fractions import Fraction as F

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational, sqrt

from bezteach.homework import CORRECT, OPEN, PARTLY, WRONG, InvalidAnswer
from bezteach.homework.reading import is_blank, read
from bezteach.homework.values import ADVICE, compared, same, value_of

LEFT = ((F(0), F(0)), (F(1, 3), F(1)), (F(2, 3), F(13, 9)), (F(1), F(5, 3)))  # the deck's cubic split at 1/3
RIGHT = ((F(1), F(5, 3)), (F(5, 3), F(19, 9)), (F(7, 3), F(5, 3)), (F(3), F(3)))
MISTAKES = [(LEFT[::-1], "the order is reversed"), (RIGHT, "this is the other half")]


def judged(answer, right=LEFT, kind="points", mistakes=MISTAKES):
    return compared(value_of(kind, answer), right, mistakes)


@pytest.mark.parametrize(
    "answer",
    [
        [(0, 0), (F(1, 3), 1), (F(2, 3), F(13, 9)), (1, F(5, 3))],
        "(0, 0), (1/3, 1), (2/3, 13/9), (1, 5/3)",
        "[(0,0), (1/3,1), (2/3,13/9), (1,5/3)]",
        [["0", "0"], ["1/3", "1"], ["2/3", "13/9"], [1, "\\frac{5}{3}"]],
    ],
)
def test_the_left_half_in_every_form(answer):
    assert judged(answer) == (CORRECT, "Right.")


def test_a_float_is_taken_with_the_advice_to_write_a_fraction():
    assert judged([(0, 0), (1 / 3, 1), (2 / 3, 13 / 9), (1, 5 / 3)]) == (CORRECT, ADVICE)
    assert judged(1 / 3 + 1e-11, F(1, 3), "number").status == WRONG
    assert judged(1e9 / 3, F(10**9, 3), "number").status == CORRECT  # near, for its size


def test_a_known_mistake_is_named_and_the_answer_is_not():
    assert judged(LEFT[::-1]) == (WRONG, "the order is reversed")
    assert judged(RIGHT) == (WRONG, "this is the other half")


def test_what_is_right_in_part_is_said():
    answer = [LEFT[0], LEFT[1], (F(2, 3), F(14, 9)), LEFT[3]]
    assert judged(answer) == (PARTLY, "3 of 4 rows are right: look at number 3 again.")
    assert judged([(9, 9)] * 4) == (WRONG, "None of the 4 rows is right.")
    assert judged((1, 2), (F(1), F(3)), "point") == (PARTLY, "1 of 2 numbers are right: look at number 2 again.")


def test_another_size_is_said():
    assert judged(LEFT[:3]) == (WRONG, "The answer is 4 rows of 2 numbers; yours is 3 rows of 2 numbers.")
    assert judged((1, 2, 3), (F(1), F(2)), "point").feedback == "The answer is 2 numbers; yours is 3 numbers."


@pytest.mark.parametrize(
    ("kind", "answer", "said"),
    [
        ("number", (1, 2), "this is a list of numbers: a number like 2, -5/3 or 0.25 is asked for"),
        ("point", 3, "this is a number: a point like (1/2, 3) is asked for"),
        ("point", [(1, 2)], "this is a list of lists: a point"),
        ("points", (1, 2), "item 1 is a number: a list of points like [(0, 0), (1/2, 1)] is asked for"),
        ("points", [(0, 0), (1, 2, 3)], "item 2 has 3 numbers, and item 1 has 2"),
        ("points", [], "this is an empty list"),
        ("matrix", [[], []], "item 1 is an empty list"),
        ("number", "t + 1", "t + 1 is no number"),
        ("points", [(0, 0), (1, "t")], "at place 2, 2: t is no number"),
        ("number", "1/3)", "character 4"),
        ("number", True, "True is no number"),
        ("number", float("nan"), "nan is no number that a curve has"),
        ("points", [[(0, 0)]], "lists stand in lists in lists here"),
    ],
)
def test_what_is_no_answer_of_this_kind(kind, answer, said):
    with pytest.raises(InvalidAnswer) as problem:
        value_of(kind, answer)
    assert said in str(problem.value)


def test_irrational_numbers_are_compared_by_proof():
    assert same(read("sqrt(8)"), 2 * sqrt(2)) and same(read("sqrt(4)"), F(2))
    assert same(read("sqrt(2)"), F(141421356, 10**8)) is False
    assert judged("sqrt(2)/2", sqrt(Rational(1, 2)), "number", ()).status == CORRECT


@pytest.mark.parametrize(
    ("answer", "right", "kind"),
    [
        (3.33, F(10, 3), "number"),
        ("0.333", F(1, 3), "number"),
        ("(1, 1.67)", (F(1), F(5, 3)), "point"),
        ([(0.667, 0), (1, "1/2")], ((F(2, 3), F(0)), (F(1), F(1, 2))), "points"),
    ],
)
def test_what_is_rounded_is_said_to_be(answer, right, kind):
    verdict = judged(answer, right, kind, ())
    assert verdict == (WRONG, "This is rounded, and so not the number itself: write a fraction, such as 1/3.")


@pytest.mark.parametrize(
    ("answer", "right"), [("3.3", F(10, 3)), ("335/1002", F(1, 3)), ("(1.67, 2)", (F(5, 3), F(3)))]
)
def test_what_is_not_near_or_no_decimal_number_is_not_rounded(answer, right):
    kind = "point" if isinstance(right, tuple) else "number"
    assert "rounded" not in judged(answer, right, kind, ()).feedback


def test_a_decimal_number_may_stand_for_a_root():
    said = 'Right. Write roots in quotes, such as "sqrt(2)", and the answer is exact.'
    assert judged(2**0.5, sqrt(2), "number", ()) == (CORRECT, said)
    assert judged(1.4142, sqrt(2), "number", ()).status == WRONG


def test_what_cannot_be_decided_is_not_wrong(monkeypatch):
    monkeypatch.setattr("bezteach.homework.values.same", lambda *both: None)
    assert judged("sqrt(2)", F(1), "number", ()).status == OPEN


def test_blanks():
    assert all(map(is_blank, (..., None, "", "  ", "...", [...], (0, ...))))
    assert not any(map(is_blank, (0, False, "0", [], [0], "a...")))


numbers = st.builds(F, st.integers(-99, 99), st.integers(1, 99))


@given(st.lists(st.tuples(numbers, numbers), min_size=1, max_size=6), st.data())
def test_one_number_changed_is_never_right(points, data):
    right = tuple(points)
    i, axis = data.draw(st.integers(0, len(points) - 1)), data.draw(st.integers(0, 1))
    moved = list(points[i])
    moved[axis] += data.draw(numbers.filter(bool))
    answer = [*points[:i], tuple(moved), *points[i + 1 :]]
    written = [tuple(map(str, point)) for point in answer]
    assert judged(points, right, mistakes=()).status == CORRECT
    for form in (answer, written, ", ".join(f"({x}, {y})" for x, y in answer) if len(answer) > 1 else written):
        assert judged(form, right, mistakes=()).status in (WRONG, PARTLY)
