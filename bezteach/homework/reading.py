"""What a student gives as an answer, read exactly: numbers, lists and texts are looked at, nothing is ever called.

An answer is judged alike in a notebook and from its syntax tree, so it is what can be written out in a cell: an int, a
float, a Fraction, a text, a list or tuple of those. Of any other object, a subclass too, only the type is looked at.
"""

from fractions import Fraction
from math import isfinite

from sympy import Rational

from bezteach.parsing import InvalidAnswer, parse

MOST = 64  # items in a list
MOST_IN_ALL = 400
DEEPEST = 2  # a list of points, the rows of a matrix
DIGITS = 40
_NAME = type.__dict__["__name__"].__get__  # which no metaclass can answer for


def is_blank(answer):
    """Whether an answer is still what the blank homework has.

    >>> is_blank(...), is_blank(" "), is_blank([..., (0, 1)]), is_blank(0)
    (True, True, True, False)
    """
    kind = type(answer)
    if kind in (list, tuple):
        return any(one is ... for one in answer[:MOST])
    return answer is ... or answer is None or (kind is str and answer.strip() in ("", "..."))


def read(answer):
    """Nested tuples of Fractions, floats and SymPy formulas.

    >>> read([("1/3", 1), (0.5, Fraction(2, 3))])
    ((Fraction(1, 3), Fraction(1, 1)), (0.5, Fraction(2, 3)))
    >>> read("t(1 - t)")
    t*(1 - t)
    >>> read({1, 2})
    Traceback (most recent call last):
    bezteach.parsing.errors.InvalidAnswer: this is a set: give a number, a list of them, or a text in quotes

    ``InvalidAnswer`` says what is wrong; no object ever makes another exception.
    """
    left = [MOST_IN_ALL]
    return _read(answer, 0, left)


def _read(answer, depth, left):
    left[0] -= 1
    if left[0] < 0:
        raise InvalidAnswer(f"these are more than {MOST_IN_ALL} numbers")
    kind = type(answer)
    if kind in _READERS:
        return _READERS[kind](answer)
    if kind not in (list, tuple):
        raise InvalidAnswer(f"this is {_named(kind)}: give a number, a list of them, or a text in quotes")
    if depth == DEEPEST:
        raise InvalidAnswer("lists stand in lists in lists here: a list of points is as deep as it gets")
    if len(answer) > MOST:
        raise InvalidAnswer(f"this list has {len(answer)} items: {MOST} are read")
    return tuple(_read(one, depth + 1, left) for one in answer)


def _named(kind):
    name = _NAME(kind)
    if not (name.isascii() and name.isidentifier() and len(name) <= DIGITS):
        return "an object of a kind that is not read"
    return f"{'an' if name[0] in 'aeiouAEIOU' else 'a'} {name}"


def _whole(answer):
    return _bounded(answer, 1)


def _fraction(answer):
    parts = getattr(answer, "_numerator", None), getattr(answer, "_denominator", None)
    if any(type(part) is not int for part in parts) or parts[1] < 1:
        raise InvalidAnswer("this is no fraction of whole numbers")
    return _bounded(*parts)


def _bounded(p, q):
    if max(abs(p), q) >= 10**DIGITS:
        raise InvalidAnswer(f"this number is too long: {DIGITS} digits are read")
    return Fraction(p, q)


def _float(answer):
    if not isfinite(answer):
        raise InvalidAnswer(f"{answer} is no number that a curve has")
    return answer


def _bool(answer):
    raise InvalidAnswer(f"{answer} is no number")


def _text(answer):
    return _exact(parse(answer))


def _exact(found):
    """What the parser found, numbers as Fractions."""
    if isinstance(found, tuple):
        return tuple(map(_exact, found))
    return Fraction(int(found.p), int(found.q)) if isinstance(found, Rational) else found


_READERS = {int: _whole, Fraction: _fraction, float: _float, bool: _bool, str: _text}
