"""The boards beside questions for control points: what is dragged on them can be pasted as an answer."""

import json

import pytest

from bezteach import homework
from bezteach.homework import CORRECT
from bezteach.homework.boards import board_for
from bezteach.homework.kinds import judged
from bezteach.homework.sets import QUESTIONS, data_of
from bezteach.homework.submission import submission

ON_BOARD = [id for id, (_, question) in QUESTIONS.items() if question.position]


@pytest.mark.parametrize("student", [None, "ada", "bo"])
@pytest.mark.parametrize("id", ON_BOARD)
def test_a_right_position_can_be_found_on_the_board_and_pasted(id, student):
    name, question = QUESTIONS[id]
    data = data_of(name, student)
    position = question.position(data)
    board = board_for(id, position)
    assert judged(question, data, list(board.points)).status != CORRECT
    left, low, right, high = board.view
    assert all(left < x < right and low < y < high for x, y in position)
    step = 1 / int(board.grid.removeprefix("1/"))
    assert all((float(number) / step).is_integer() for point in position for number in point)
    board.points = position
    pasted = board.text.partition("To paste: ")[2]
    book = {"nbformat": 4, "cells": [{"cell_type": "code", "source": pasted}]}
    answer = submission(json.dumps(book).encode()).answers[id]
    assert judged(question, data, answer).status == CORRECT


def test_most_sets_have_one():
    assert len({QUESTIONS[id][0] for id in ON_BOARD}) == 9


def test_a_question_for_something_else_has_no_board():
    with pytest.raises(ValueError, match="08-splitting/point asks for no position"):
        homework.board("08-splitting/point")
    with pytest.raises(ValueError, match="10-joining/seam"):
        homework.board("10-joining/sea")


def test_the_board_of_a_notebook_has_the_student_s_question(capsys):
    homework.start()
    assert 'check("10-joining/seam", [(0, 0), (1, 2), (2, 0), (3, 2)])' in homework.board("10-joining/seam").text
