"""Every question of every set: the right answer in several forms, each known mistake, a blank, a hopeless answer."""

import ast
from fractions import Fraction as F

import pytest

from bezteach.homework import CORRECT, INVALID, PARTLY, UNATTEMPTED, WRONG
from bezteach.homework.kinds import judged
from bezteach.homework.sets import QUESTIONS, SETS, data_of

STUDENTS = (None, "ada", "dürer")

# By hand, for the book's numbers: the right answer in some forms, then wrong ones with a piece of what is said to them.
BOOK = {
    "08-splitting/point": (
        ["(1, 5/3)", (1, F(5, 3)), [1, 5 / 3]],
        [((2, 2), "t and 1 - t"), ((F(4, 3), F(7, 3)), "first level"), ("(2/3, 13/9)", "second level")],
    ),
    "08-splitting/left": (
        ["(0, 0), (1/3, 1), (2/3, 13/9), (1, 5/3)", [(0, 0), (F(1, 3), 1), ("2/3", "13/9"), (1, F(5, 3))]],
        [
            ("(1, 5/3), (2/3, 13/9), (1/3, 1), (0, 0)", "order is reversed"),
            ("(1, 5/3), (5/3, 19/9), (7/3, 5/3), (3, 3)", "the other half"),
            ("(0, 0), (2/3, 2), (4/3, 16/9), (2, 2)", "t and 1 - t"),
            ("(1/3, 1), (4/3, 7/3), (7/3, 5/3)", "one level of the triangle"),
            ("(0, 0), (1/3, 1), (2/3, 1), (1, 5/3)", "3 of 4 rows"),
        ],
    ),
    "08-splitting/right": (
        ["(1, 5/3), (5/3, 19/9), (7/3, 5/3), (3, 3)"],
        [
            ("(3, 3), (7/3, 5/3), (5/3, 19/9), (1, 5/3)", "order is reversed"),
            ("(0, 0), (1/3, 1), (2/3, 13/9), (1, 5/3)", "the other half"),
        ],
    ),
    "08-splitting/local": (
        ["1/3", F(1, 3), 1 / 3],
        [
            (F(1, 4), "a itself"),
            (F(2, 3), "behind a"),
            (F(1, 2), "length of the part"),
            (0.1875, "Multiplied"),
            (F(3, 4), "Not this"),
        ],
    ),
    "08-splitting/part": (
        ["(-9/2, 27/8), (-3/2, 39/8), (3/2, 39/8), (9/2, 27/8)"],
        [
            ("(9/2, 27/8), (3/2, 39/8), (-3/2, 39/8), (-9/2, 27/8)", "order is reversed"),
            ("(-9, 0), (-9/2, 9/2), (0, 45/8), (9/2, 27/8)", "in front of b"),
            ("(-9/2, 27/8), (0, 45/8), (9/2, 9/2), (9, 0)", "behind a"),
            ("(-45/8, 351/128), (-9/4, 621/128), (9/8, 81/16), (9/2, 27/8)", "parameter of its own"),
        ],
    ),
    "08-splitting/formula": (
        ["(1-t)^2 b_0 + 2t(1-t) b_1 + t^2 b_2", "(1-t)((1-t) b0 + t b1) + t((1-t) b1 + t b2)"],
        [
            ("t^2 b_0 + 2t(1-t) b_1 + (1-t)^2 b_2", "exchanged"),
            ("(1-t)^2 b_0 + t(1-t) b_1 + t^2 b_2", "must sum to 1"),
            ("(1-t) b_1 + t b_2", "first level"),
            ("b_0", "your formula is b[0]"),
        ],
    ),
    "08-splitting/front-weight": (
        [(False, "n = 1, t = 1/2"), "false: n = 2, t = 1"],
        [(True, "a place where it fails"), (False, "Now a counterexample"), ("false: n = 0, t = 1", "outside")],
    ),
    "08-splitting/last-weight": ([True, "true"], [("false: n = 1, t = 1", "Not so")]),
    "08-splitting/unity": (
        [
            "sum(B(i,n,t), i, 0, n)\n= sum(C(n,i) t^i (1-t)^(n-i), i, 0, n)\n= ((1-t) + t)^n\n= 1",
            ["sum(B(i,n,t), i, 0, n)", "sum(B(n-i,n,t), i, 0, n)", "1"],
        ],
        [
            ("sum(B(i,n,t), i, 0, n)\n= 1", "show why"),
            ("sum(B(i,n,t), i, 0, n)\n= sum(B(i,n,t), i, 1, n)\n= 1", "Line 2 does not follow"),
            ("1\n= sum(B(i,n,t), i, 0, n)", "begin with"),
        ],
    ),
}


def test_every_question_is_here():
    assert set(BOOK) == set(QUESTIONS)
    assert all(len(part.questions) >= 8 for part in SETS.values())


@pytest.mark.parametrize("id", BOOK)
def test_the_right_answer_of_the_book_in_several_forms(id):
    name, question = QUESTIONS[id]
    for answer in BOOK[id][0]:
        assert judged(question, data_of(name), answer).status == CORRECT, answer


@pytest.mark.parametrize(
    ("id", "answer", "said"), [(id, *wrong) for id, (_, wrongs) in BOOK.items() for wrong in wrongs]
)
def test_each_mistake_gets_its_words_and_the_answer_is_not_given_away(id, answer, said):
    name, question = QUESTIONS[id]
    data = data_of(name)
    verdict = judged(question, data, answer)
    assert verdict.status in (WRONG, PARTLY) and said in verdict.feedback
    assert question.solution(data) not in verdict.feedback


@pytest.mark.parametrize("student", STUDENTS)
@pytest.mark.parametrize("id", QUESTIONS)
def test_every_student_has_answers_that_are_right_and_mistakes_that_are_not(id, student):
    name, question = QUESTIONS[id]
    data = data_of(name, student)
    assert question.apart(data) and question.text(data).strip() and question.hints
    assert judged(question, data, ...).status == UNATTEMPTED
    assert judged(question, data, {1}).status == judged(question, data, "t(").status == INVALID
    assert judged(question, data, 10**9).status in (WRONG, PARTLY, INVALID)
    solution = question.solution(data)
    if not isinstance(BOOK[id][0][0], str) or "sum(" not in BOOK[id][0][0]:
        answer = ast.literal_eval(solution) if solution.startswith("(False") else solution
        assert judged(question, data, answer).status == CORRECT, solution


def test_neighbours_have_different_numbers_and_each_student_the_same_ones():
    drawn = [data_of("08-splitting", student) for student in STUDENTS]
    assert len({str(data) for data in drawn}) == len(STUDENTS)
    assert drawn == [data_of("08-splitting", student) for student in STUDENTS]
