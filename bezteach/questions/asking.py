"""What a question is, and how an answer to it is judged."""

import re
from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from ..numeric.exact import nested

LONGEST = 500
_TOKEN = re.compile(
    r"\s*(?:(?P<number>[-+−－]?\d{1,40}(?:\.\d{1,40}|\s*[/／]\s*\d{1,40})?)|(?P<mark>[()\[\],;，；（）]))"
)
_OPENING, _CLOSING = "([（", ")]）"
_SIGNS = str.maketrans("−－／", "--/")


class Choice(NamedTuple):
    """Pick one: ``options`` maps an answer to what is said about it; ``right`` is one of them."""

    text: str
    options: dict
    right: str


class Entry(NamedTuple):
    """Type numbers or points: ``right`` and each of ``mistakes``, (answer, feedback), are computed when asked for.

    An answer is a number, a point or a list of numbers (both of shape (d,)), or a list of points (shape (m, d)). The
    ``example`` shows how it is written, points alone in parentheses.
    """

    text: str
    right: Callable
    mistakes: Callable
    example: str


class Goal(NamedTuple):
    """A task to be reached by moving something: ``reached`` judges the state of the board (``widgets.board``)."""

    text: str
    reached: Callable
    praise: str


def all_but(place, state, start):
    """Whether the state has as many points as ``start``, and all but the one at ``place`` where they are there."""
    if len(state.points) != len(start):
        return False
    pairs = enumerate(zip(state.points, start, strict=True))
    return all(i == place or now == then for i, (now, then) in pairs)


def judge(question, answer):
    """(whether it is right, what to say) for an answer as the reader gives it; None for no answer yet."""
    if answer is None or not str(answer).strip():
        return None, "Not answered yet."
    if isinstance(question, Choice):
        return answer == question.right, question.options[answer]
    try:
        given = read(answer)
    except ValueError as problem:
        return None, f"{problem} Write it like {question.example}."
    return _compared(given, nested(question.right()), question.mistakes(), question.example.startswith("("))


def _compared(given, right, mistakes, points):
    if given == right:
        return True, "Right."
    for mistake, feedback in mistakes:
        if given == nested(mistake):
            return False, feedback
    if _shape(given) != _shape(right):
        return False, f"The answer is {_named(_shape(right), points)}; yours is {_named(_shape(given), points)}."
    if isinstance(right, tuple) and isinstance(right[0], tuple):
        wrong = [i for i, (mine, true) in enumerate(zip(given, right, strict=True), 1) if mine != true]
        return (
            False,
            f"{len(right) - len(wrong)} of {len(right)} points are right; look at point number {wrong[0]} again.",
        )
    return False, "Not this. Draw it, or do one step after the other, and try again."


def read(text):
    """A number, a point or a tuple of points from what a reader types, exact: ``3``, ``1/3, 2``, ``(0, 0) (1/3, 1)``.

    Brackets of any kind do, also a list of points in brackets of its own. ``ValueError`` names what is wrong and where;
    nothing typed is ever evaluated.

    >>> read("[(0,0), (1/3, 1)]")
    ((Fraction(0, 1), Fraction(0, 1)), (Fraction(1, 3), Fraction(1, 1)))
    """
    if len(text) > LONGEST:
        raise ValueError(f"That is longer than {LONGEST} characters.")
    groups, open_groups = [], [[]]
    for mark, number, place in _tokens(text):
        if number is not None:
            open_groups[-1].append(number)
        elif mark in _OPENING:
            open_groups.append([])
        elif mark in _CLOSING:
            if len(open_groups) == 1:
                raise ValueError(f"Nothing to close at character {place}.")
            groups.append(tuple(open_groups.pop()))
    if len(open_groups) > 1:
        raise ValueError("A parenthesis is not closed.")
    return _answer(open_groups[0], [group for group in groups if group])


def _tokens(text):
    """(mark, number, place of its last character) one after the other; one of mark and number is None."""
    place = 0
    while rest := text[place:].lstrip():
        token = _TOKEN.match(text, place)
        if not token:
            place = len(text) - len(rest) + 1
            raise ValueError(f"Character {place}, {rest[0]!r}, is no number, comma or parenthesis.")
        place = token.end()
        yield token["mark"], token["number"] and _number(token["number"], place), place


def _number(text, place):
    try:
        return Fraction(re.sub(r"\s", "", text).translate(_SIGNS))
    except ZeroDivisionError:
        raise ValueError(f"A division by zero, at character {place}.") from None


def _answer(loose, points):
    if points and loose:
        raise ValueError("A number stands outside the parentheses.")
    if not points and not loose:
        raise ValueError("There is no number in it.")
    if len({len(point) for point in points}) > 1:
        raise ValueError("The points have different numbers of coordinates.")
    several = tuple(points or loose)
    return several if len(several) > 1 else several[0]


def _shape(answer):
    return np.shape(np.array(answer, dtype=object))


def _named(shape, points):
    """What an answer of this shape is, where several numbers are a point or only numbers."""
    if not shape:
        return "a number"
    if len(shape) == 1:
        return f"one point with {shape[0]} coordinates" if points else f"{shape[0]} number{'s' * (shape[0] != 1)}"
    return f"{shape[0]} points with {shape[1]} coordinates"
