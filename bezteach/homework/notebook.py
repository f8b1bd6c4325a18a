"""A set of homework as a blank notebook, and the teacher's answers to it."""

import json

from .sets import QUESTIONS, SETS, data_of

KERNEL = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
INTRODUCTION = """# Homework on lesson {lesson}

Put your answer in the place of the three dots and run the cell. A number is `2`, `-5/3` or `Fraction(1, 3)`, a point \
`(1/2, 3)`, a list of points `[(0, 0), (1/2, 1)]`; a formula stands in quotes, `"2t(1 - t)"`, \
with a sign after a fraction, `"n/(n+1) * b_1"`. Write the answer itself into the call: it is also read without \
running the notebook. Where there is a board, drag its points and copy its last line, the check, into the cell below it.

`start()` takes the book's numbers, `start("Ada")` those of a student of this name. `hint("{id}")` gives one more hint \
each time, `solution("{id}")` the answer once you have tried."""
IMPORTS = """from fractions import Fraction

from bezteach.homework import ask, board, check, hint, points, solution, start"""
POINTS = "## Points\n\nOne for each right answer, half a one for an answer that is right in part."


def notebook(name, student=None):
    """The text of a blank notebook of a set, with this student's numbers, or the book's.

    >>> book = json.loads(notebook("08-splitting", "Ada"))
    >>> print(book["cells"][1]["source"])
    from fractions import Fraction
    <BLANKLINE>
    from bezteach.homework import ask, board, check, hint, points, solution, start
    <BLANKLINE>
    start("Ada")
    """
    called = "" if student is None else json.dumps(student, ensure_ascii=False)
    first = f"{name}/{next(iter(SETS[name].questions))}"
    cells = [
        _markdown(INTRODUCTION.format(lesson=name.replace("-", ": ", 1).replace("-", " "), id=first)),
        _code(f"{IMPORTS}\n\nstart({called})"),
    ]
    for number, (short, question) in enumerate(SETS[name].questions.items(), 1):
        cells += [_markdown(f"## {number}. {short.replace('-', ' ').capitalize()}")]
        calls = ["ask({})", *["board({})"] * (question.position is not None), "check({}, ...)"]
        cells += [_code(call.format(f'"{name}/{short}"')) for call in calls]
    cells += [_markdown(POINTS), _code(f'points("{name}")', _autograded(name))]
    book = {
        "cells": [cell | {"id": f"cell-{place}"} for place, cell in enumerate(cells)],
        "metadata": {"kernelspec": KERNEL},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return json.dumps(book, ensure_ascii=False, indent=1) + "\n"


def _markdown(source):
    return {"cell_type": "markdown", "metadata": {}, "source": source}


def _code(source, metadata=None):
    return {"cell_type": "code", "execution_count": None, "metadata": metadata or {}, "outputs": [], "source": source}


def _autograded(name):
    """What nbgrader has to know of the last cell: it is a test, and its number is the points that are given."""
    test = {"grade": True, "solution": False, "task": False, "locked": True, "grade_id": f"points-{name}"}
    return {"nbgrader": {**test, "points": len(SETS[name].questions), "cell_type": "code", "schema_version": 3}}


def key(name, student=None):
    """The teacher's answers to a set, question by question: what is asked, and what is right."""
    data = data_of(name, student)
    mine = [(id, question) for id, (own, question) in QUESTIONS.items() if own == name]
    return "\n\n".join(f"{id}\n  {question.text(data)}\n  = {question.solution(data)}" for id, question in mine)
