"""What a student calls in a notebook: ``start``, ``ask``, ``board``, ``check``, ``hint``, ``solution``, ``points``."""

from difflib import get_close_matches

from bezteach.display import Page, escaped

from .kinds import judged
from .reading import is_blank
from .sets import QUESTIONS, SETS, data_of
from .student import student_of

MARKS = {"CORRECT": "✓", "PARTLY": "◐", "WRONG": "✗", "INVALID": "?", "UNATTEMPTED": "…", "OPEN": "?"}
POINTS = {"CORRECT": 1, "PARTLY": 0.5}
_session = {"student": None, "checked": {}, "hints": {}}


def start(name=None):
    """Begin: with a name the numbers are this student's own, the same every time; without one they are the book's.

    Names that differ in capitals and spaces alone are one. ``ValueError`` for what is no name.

    >>> start("Ada  Lovelace")
    The numbers of ada lovelace.
    >>> start()
    The book's numbers.
    """
    student = None if name is None else student_of(name)
    _session.update(student=student, checked={}, hints={})
    print("The book's numbers." if student is None else f"The numbers of {student}.")


def ask(id):
    """What is asked, with this student's numbers, a ``Page`` to look at; ``ValueError`` as for ``check``.

    >>> start()
    The book's numbers.
    >>> ask("08-splitting/point")
    The point at t = 1/3 of the cubic b_0 = (0, 0), b_1 = (1, 3), b_2 = (2, 1), b_3 = (3, 3).
    """
    question, data = _of(id)
    text = question.text(data)
    return Page(text, escaped(text))


def check(id, answer=...):
    """Print the verdict on an answer, any object; a blank, ``...``, is UNATTEMPTED. Never raises on a bad answer.

    >>> check("08-splitting/local", 1/3)
    ✓ CORRECT: Right. Write fractions, such as 1/3, and the answer is exact.
    >>> check("08-splitting/local", "2/3")
    ✗ WRONG: This is where b stands in the piece behind a. Here the cut at b came first.

    ``ValueError`` names the nearest questions if there is none of this id.
    """
    question, data = _of(id)
    verdict = judged(question, data, answer)
    if not is_blank(answer):
        _session["checked"][id] = verdict.status
    print(f"{MARKS[verdict.status]} {verdict.status}: {verdict.feedback}")


def board(id):
    """A ``Board`` to find the control points on that a question asks for, with the line to paste beside it.

    ``ValueError`` as for ``check``, and if the question asks for something else.
    """
    from .boards import board_for

    question, data = _of(id)
    if question.position is None:
        raise ValueError(f"{id} asks for no position of control points")
    return board_for(id, question.position(data))


def hint(id):
    """Print one more hint each time; ``ValueError`` as for ``check``."""
    question, _ = _of(id)
    count = _session["hints"].get(id, 0)
    _session["hints"][id] = count + 1
    print(question.hints[count] if count < len(question.hints) else "There are no more hints.")


def solution(id):
    """Print the right answer, once an answer has been tried; ``ValueError`` as for ``check``."""
    question, data = _of(id)
    print(
        question.solution(data) if id in _session["checked"] else "Try an answer first: check it, and then look here."
    )


def points(name):
    """How many points the answers checked so far have in a set: 1 for a right one, 1/2 for one that is right in part.

    >>> start()
    The book's numbers.
    >>> check("08-splitting/local", "1/3")
    ✓ CORRECT: Right.
    >>> points("08-splitting")
    1

    Of a question that is checked again the last answer counts. ``ValueError`` if there is no such set.
    """
    if type(name) is not str or name not in SETS:
        raise ValueError(f"there is no set {name if type(name) is str else type(name).__name__!r}: {', '.join(SETS)}")
    checked = _session["checked"]
    return sum(POINTS.get(checked[id], 0) for id, (own, _) in QUESTIONS.items() if own == name and id in checked)


def _of(id):
    if type(id) is not str or id not in QUESTIONS:
        near = get_close_matches(id, QUESTIONS) if type(id) is str else []
        raise ValueError(
            f"there is no question {id if type(id) is str else type(id).__name__!r}: {', '.join(near or QUESTIONS)}"
        )
    name, question = QUESTIONS[id]
    return question, data_of(name, _session["student"])
