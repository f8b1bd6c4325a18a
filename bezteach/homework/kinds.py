"""The kinds of questions: each function here makes one, from what is asked to how an answer to it is judged.

A question's data, the student's own numbers, is a dictionary; ``text``, ``right`` and ``mistakes`` are functions of it.
"""

from collections.abc import Callable
from fractions import Fraction
from itertools import combinations
from typing import NamedTuple

import numpy as np
from sympy import Expr, sympify

from bezteach import symbolic
from bezteach.display import points
from bezteach.numeric.exact import nested
from bezteach.parsing import InvalidAnswer
from bezteach.proof import PROVED, REFUTED

from . import derivations, formulas, truth, values
from .reading import is_blank
from .remembered import proved
from .verdict import CORRECT, INVALID, PARTLY, UNATTEMPTED, WRONG, Verdict

SECONDS = 10.0  # for the truth of what is asked


class Question(NamedTuple):
    """What is asked (``text(data)``), how an answer is judged, what is right in words, and hints, the vaguest first.

    ``mistakes(data)`` are the known ones, (an answer, what is said to it); ``apart(data)`` says whether the
    data can tell the right answer and the known mistakes from one another; ``position(data)`` is a right answer that
    can be found on a board.
    """

    text: Callable
    judge: Callable
    solution: Callable
    hints: tuple
    mistakes: Callable = lambda data: ()
    apart: Callable = lambda data: True
    position: Callable | None = None


class Set(NamedTuple):
    """The questions of one lesson by their short names, the book's data, and ``draw(chance)``, which draws others."""

    book: dict
    draw: Callable
    questions: dict


def judged(question, data, answer):
    """The ``Verdict`` on any object as an answer."""
    if is_blank(answer):
        return Verdict(UNATTEMPTED, "Not answered yet.")
    try:
        return question.judge(data, answer)
    except InvalidAnswer as problem:
        return Verdict(INVALID, str(problem))


def asks_value(kind, text, right, mistakes=lambda data: (), hints=()):
    """A question for a number, a point, points or a matrix (``values.SHAPES``); mistakes are (value, feedback)."""

    def judge(data, answer):
        return values.compared(values.value_of(kind, answer), nested(right(data)), named(data))

    def named(data):
        return [(nested(value), feedback) for value, feedback in mistakes(data)]

    def apart(data):
        known = [nested(right(data)), *(value for value, _ in named(data))]
        return all(values.same(one, other) is False for one, other in combinations(known, 2))

    def pasted(data):
        return [(value if isinstance(value, tuple) else written(value), feedback) for value, feedback in named(data)]

    return Question(text, judge, lambda data: written(nested(right(data))), hints, pasted, apart)


def written(value):
    """A value as a student can paste it.

    >>> written(((0, Fraction(1, 3)),)), written(Fraction(2, 3))
    ('[(0, Fraction(1, 3))]', 'Fraction(2, 3)')
    """
    if isinstance(value, tuple):
        inside = ", ".join(map(written, value))
        return f"[{inside}]" if value and isinstance(value[0], tuple) else f"({inside})"
    if isinstance(value, Expr) and not value.is_Rational:
        return symbolic.text(value)
    fraction = Fraction(value)
    return str(fraction) if fraction.denominator == 1 else f"Fraction({fraction.numerator}, {fraction.denominator})"


def listed(control_points, name="b"):
    """Control points, or heights, as a question prints them.

    >>> listed([(0, 0), (1, Fraction(1, 2))])
    'b_0 = (0, 0), b_1 = (1, 1/2)'
    """
    return points(control_points, name).text.replace("   ", ", ")


def asks_formula(text, right, letters, ranges=None, mistakes=lambda data: (), hints=(), form=None):
    """A question for a formula in ``letters``; ``form`` is (name, whether a formula has it), of ``formulas``."""

    def judge(data, answer):
        given = formulas.formula_of(answer, letters)
        verdict = formulas.compared(given, right(data), ranges or {}, mistakes(data))
        if verdict.status == CORRECT and form and not form[1](given):
            return Verdict(PARTLY, f"This is equal, but it is not {form[0]}, as it was asked for.")
        return verdict

    def pasted(data):
        return [(symbolic.text(formula), feedback) for formula, feedback in mistakes(data)]

    return Question(text, judge, lambda data: symbolic.text(right(data)), hints, pasted)


def asks_truth(text, relation, ranges, hints=()):
    """A question whether a relation holds for all letters in their ranges; the prover decides what is right.

    ``ValueError`` for a relation that the prover cannot decide: then this is no question.
    """

    def verdict_of(data):
        verdict = proved(relation(data), None, ranges, SECONDS)
        if verdict.status not in (PROVED, REFUTED):
            raise ValueError(f"a question of truth that is {verdict.status}: {relation(data)}")
        return verdict

    def judge(data, answer):
        given = truth.truth_of(answer)
        right = verdict_of(data).status == PROVED
        return truth.compared(given, relation(data), lambda places: within(places, ranges), right)

    def solution(data):
        verdict = verdict_of(data)
        return "True" if verdict.status == PROVED else f'(False, "{verdict.counterexample.point()}")'

    return Question(text, judge, solution, hints)


def within(places, ranges):
    """Whether each letter that has a range is in it; an end may be a formula in other letters.

    >>> from bezteach.symbolic import i, n
    >>> within({n: sympify(2), i: sympify(3)}, {n: (1, 9), i: (0, n)})
    False
    """

    def inside(value, bounds):
        if not isinstance(bounds, tuple):
            return value in bounds
        low, high = (sympify(end).subs(places) for end in bounds)
        return bool(low <= value <= high)

    return all(inside(value, ranges[symbol]) for symbol, value in places.items() if symbol in ranges)


def asks_derivation(text, lines, letters, ranges, least=1, hints=()):
    """A question for a derivation from the first of ``lines`` to the last, with ``least`` different ones between.

    ``lines``: SymPy formulas, or a text as a student writes it; they are one right answer, and any other will do.
    """
    written_out = lines if isinstance(lines, str) else "\n= ".join(map(symbolic.text, lines))

    def judge(data, answer):
        first, *_, last = derivations.lines_of(written_out, letters)
        lines = derivations.lines_of(answer, letters)
        return derivations.compared(lines, first.formula, last.formula, ranges, least)

    return Question(text, judge, lambda data: written_out, hints)


def asks_position(text, demands, solution, hints=(), on_board=True):
    """A question for control points with properties, as a board prints them.

    ``demands`` are (holds(data, points), what is said where it does not hold), points an array of Fractions, shape
    (m, 2); ``solution(data)`` is one position that meets all of them. ``on_board``: whether their curve is Bézier's.
    """

    def judge(data, answer):
        found = values.value_of("points", answer)
        if any(not isinstance(number, Fraction) for point in found for number in point):
            raise InvalidAnswer("positions are exact: write fractions, such as 1/3, for decimal numbers and roots")
        if len(found[0]) != 2:
            raise InvalidAnswer("the board is a plane: two numbers for each point")
        lacking = [words for holds, words in demands if not holds(data, np.array(found, dtype=object))]
        if not lacking:
            return Verdict(CORRECT, "Right: all that was asked for holds.")
        return Verdict(WRONG if len(lacking) == len(demands) else PARTLY, lacking[0])

    def position(data):
        return nested(solution(data))

    return Question(text, judge, lambda data: written(position(data)), hints, position=position if on_board else None)
