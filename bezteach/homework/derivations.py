"""Derivations, line by line: from what is given to what is to be shown, each line equal to the one before."""

from typing import NamedTuple

from sympy import Expr

from bezteach.parsing import InvalidAnswer
from bezteach.proof import PROVED, REFUTED
from bezteach.symbolic import text

from .formulas import formula_of
from .remembered import derived
from .verdict import CORRECT, INVALID, OPEN, PARTLY, WRONG, Verdict

MOST = 30  # lines
SECONDS = 20.0


class Line(NamedTuple):
    """A line as it is written, and its formula, in which SymPy has made 1 of (1 - t) + t."""

    written: str
    formula: Expr


def lines_of(answer, letters):
    """The ``Line``s of a derivation: a text of several lines, or a list of texts; a line may begin with its sign "=".

    >>> from bezteach.symbolic import t
    >>> lines_of('''(1 - t) + t
    ... = 1''', {t})
    [Line(written='(1 - t) + t', formula=1), Line(written='1', formula=1)]

    ``InvalidAnswer`` names the line.
    """
    texts = answer.splitlines() if type(answer) is str else answer
    if type(texts) not in (list, tuple) or any(type(line) is not str for line in texts):
        raise InvalidAnswer("a derivation is a text of several lines, or a list of texts")
    texts = [line.strip() for line in texts if line.strip()]
    if not 2 <= len(texts) <= MOST:
        raise InvalidAnswer(f"a derivation has 2 to {MOST} lines, and this one has {len(texts)}: one formula a line")
    return [_line(number, line, letters) for number, line in enumerate(texts, 1)]


def _line(number, line, letters):
    try:
        line = line.removeprefix("=") if number > 1 else line
        return Line(line.strip(), formula_of(line, letters))
    except InvalidAnswer as problem:
        raise InvalidAnswer(f"line {number}: {problem}") from None


def compared(lines, start, goal, ranges, least=1):
    """The ``Verdict`` on a derivation of ``goal`` from ``start``, with ``least`` lines at least between the two.

    CORRECT only if it begins and ends as asked, letter by letter but for the indices of sums, and every step is proved;
    OPEN if one of them could not be decided.
    """
    if not _is_same(lines[0].formula, start):
        return Verdict(WRONG, f"The first line is not what is given: begin with {text(start)}.")
    judgement = derived([line.formula for line in lines], ranges, SECONDS)
    wrong = judgement.first_wrong
    if wrong is not None:
        where = judgement.lines[wrong - 1].counterexample
        return Verdict(PARTLY if wrong > 2 else WRONG, f"Line {wrong} does not follow from line {wrong - 1}: {where}.")
    if judgement.status not in (PROVED, REFUTED):
        told = next((line for line in judgement.lines[1:] if line.step is None or line.step.status != PROVED), None)
        words = judgement.note if told is None else f"line {told.number}: {told.note or told.remark}"
        return Verdict(INVALID if judgement.status == "INVALID" else OPEN, f"Not every step could be decided; {words}.")
    if not _is_same(lines[-1].formula, goal):
        return Verdict(PARTLY, f"Every line follows from the one before. Go on until the line is {text(goal)}.")
    if len({line.written for line in lines if _is_between(line, start, goal)}) < least:
        return Verdict(PARTLY, f"True, but show why: at least {least} different line{'s' * (least != 1)} between.")
    return Verdict(CORRECT, f"Right: each of the {len(lines) - 1} steps is proved.")


def _is_same(formula, asked):
    return formula.as_dummy() == asked.as_dummy()


def _is_between(line, start, goal):
    """Whether a line is another formula than both, or has letters that SymPy has cancelled in it."""
    is_other = not _is_same(line.formula, start) and not _is_same(line.formula, goal)
    return is_other or bool({*filter(str.isalpha, line.written)} - {*text(line.formula)})
