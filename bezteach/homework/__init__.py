"""Homework: answers are read exactly and judged by the project's own computations and proofs.

``reading.py`` reads what a student gives; ``values.py``, ``formulas.py``, ``truth.py`` and ``derivations.py`` judge one
kind of answer each, against what the project computes and proves (``remembered.py``); ``kinds.py`` makes questions of
them, ``sets/`` has those of each lesson. ``session.py`` is what a student calls, ``boards.py`` what is dragged,
``notebook.py`` what is handed out, ``submission.py`` reads what is handed in; ``decided.py`` shows what is decided.
"""

from bezteach.parsing import InvalidAnswer, parse

from .session import ask, board, check, hint, points, solution, start
from .verdict import CORRECT, INVALID, OPEN, PARTLY, UNATTEMPTED, WRONG, Verdict

__all__ = [
    "CORRECT",
    "INVALID",
    "OPEN",
    "PARTLY",
    "UNATTEMPTED",
    "WRONG",
    "InvalidAnswer",
    "Verdict",
    "ask",
    "board",
    "check",
    "hint",
    "parse",
    "points",
    "solution",
    "start",
]
