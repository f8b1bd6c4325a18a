"""Every question of every set: the right answer in several forms, each known mistake, a blank, a hopeless answer."""

import ast

import answers_b_splines as b_splines
import answers_basis_properties as basis_properties
import answers_curve_properties as curve_properties
import answers_de_casteljau as de_casteljau
import answers_definitions as definitions
import answers_derivatives as derivatives
import answers_elevation as elevation
import answers_joining as joining
import answers_operator as operator
import answers_rational as rational
import answers_splitting as splitting
import answers_why_bernstein as why_bernstein
import pytest

from bezteach.homework import CORRECT, INVALID, PARTLY, UNATTEMPTED, WRONG
from bezteach.homework.kinds import judged
from bezteach.homework.sets import QUESTIONS, SETS, data_of

STUDENTS = (None, "ada", "dürer")

BOOK = (
    why_bernstein.BOOK
    | definitions.BOOK
    | basis_properties.BOOK
    | curve_properties.BOOK
    | de_casteljau.BOOK
    | operator.BOOK
    | splitting.BOOK
    | elevation.BOOK
    | derivatives.BOOK
    | joining.BOOK
    | b_splines.BOOK
    | rational.BOOK
)


def test_every_question_is_here():
    assert set(BOOK) == set(QUESTIONS)
    assert all(len(part.questions) >= 8 for part in SETS.values())


@pytest.mark.parametrize("id", BOOK)
def test_the_right_answer_of_the_book_in_several_forms(id):
    name, question = QUESTIONS[id]
    assert len(BOOK[id][0]) >= 2
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
    answer = ast.literal_eval(solution) if solution.startswith("(False") else solution
    assert judged(question, data, answer).status == CORRECT, solution


@pytest.mark.parametrize("id", QUESTIONS)
def test_every_student_is_told_of_his_own_mistake(id):
    """For the book's numbers, and for those of a student if the mistakes depend on them."""
    name, question = QUESTIONS[id]
    seen = set()
    for data in (data_of(name, student) for student in STUDENTS):
        told = tuple(question.mistakes(data))
        for answer, feedback in told if told not in seen else ():
            assert judged(question, data, answer) == (WRONG, feedback)
        seen.add(told)


@pytest.mark.parametrize("name", SETS)
def test_neighbours_have_different_numbers_and_each_student_the_same_ones(name):
    drawn = [data_of(name, student) for student in STUDENTS]
    assert len({str(data) for data in drawn}) == len(STUDENTS)
    assert list(map(str, drawn)) == [str(data_of(name, student)) for student in STUDENTS]
