"""What a student calls in a notebook: ``start``, ``check``, ``hint``, ``solution``."""

from difflib import get_close_matches

from .kinds import judged
from .reading import is_blank
from .sets import QUESTIONS, data_of
from .student import student_of

MARKS = {"CORRECT": "✓", "PARTLY": "◐", "WRONG": "✗", "INVALID": "?", "UNATTEMPTED": "…", "OPEN": "?"}
_session = {"student": None, "tried": set(), "hints": {}}


def start(name=None):
    """Begin: with a name the numbers are this student's own, the same every time; without one they are the book's.

    Names that differ in capitals and spaces alone are one. ``ValueError`` for what is no name.

    >>> start("Ada  Lovelace")
    The numbers of ada lovelace.
    >>> start()
    The book's numbers.
    """
    student = None if name is None else student_of(name)
    _session.update(student=student, tried=set(), hints={})
    print("The book's numbers." if student is None else f"The numbers of {student}.")


def ask(id):
    """Print what is asked, with this student's numbers; ``ValueError`` as for ``check``."""
    question, data = _of(id)
    print(question.text(data))


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
        _session["tried"].add(id)
    print(f"{MARKS[verdict.status]} {verdict.status}: {verdict.feedback}")


def hint(id):
    """Print one more hint each time; ``ValueError`` as for ``check``."""
    question, _ = _of(id)
    count = _session["hints"].get(id, 0)
    _session["hints"][id] = count + 1
    print(question.hints[count] if count < len(question.hints) else "There are no more hints.")


def solution(id):
    """Print the right answer, once an answer has been tried; ``ValueError`` as for ``check``."""
    question, data = _of(id)
    print(question.solution(data) if id in _session["tried"] else "Try an answer first: check it, and then look here.")


def _of(id):
    if type(id) is not str or id not in QUESTIONS:
        near = get_close_matches(id, QUESTIONS) if type(id) is str else []
        raise ValueError(
            f"there is no question {id if type(id) is str else type(id).__name__!r}: {', '.join(near or QUESTIONS)}"
        )
    name, question = QUESTIONS[id]
    return question, data_of(name, _session["student"])
