"""Homework: answers are read exactly and judged by the project's own computations and proofs.

``reading.py`` reads what a student gives; ``values.py``, ``formulas.py``, ``truth.py`` and ``derivations.py`` judge one
kind of answer each, against what the project computes.
"""

from bezteach.parsing import InvalidAnswer, parse

from .verdict import CORRECT, INVALID, OPEN, PARTLY, UNATTEMPTED, WRONG, Verdict

__all__ = ["CORRECT", "INVALID", "OPEN", "PARTLY", "UNATTEMPTED", "WRONG", "InvalidAnswer", "Verdict", "parse"]
