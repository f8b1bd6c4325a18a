"""True or false, and if false a counterexample that must refute."""

import re

from sympy import Equality

from bezteach.parsing import InvalidAnswer, parse
from bezteach.proof import OutOfTime, Undefined, Unsupported, evaluate
from bezteach.proof.exact.refuter import COMPARE, shown

from .verdict import CORRECT, OPEN, PARTLY, WRONG, Verdict

WORDS = {"true": True, "false": False}
LIKE = 'write True, or False with a counterexample: (False, "n = 2, t = 1/2")'


def truth_of(answer):
    """(True, {}) or (False, {letter: number}) of ``True``, ``"true"``, ``(False, "n = 2, t = 1/2")`` or a text of it.

    >>> truth_of((False, "n = 2, t = 1/2"))
    (False, {n: 2, t: 1/2})
    >>> truth_of("false: t = 3"), truth_of("False, t = 3")
    ((False, {t: 3}), (False, {t: 3}))

    ``InvalidAnswer`` says what is wrong.
    """
    kind = type(answer)
    if kind is bool:
        return answer, {}
    if kind in (tuple, list) and len(answer) == 2 and type(answer[0]) is bool and type(answer[1]) is str:
        return _with_places(answer[0], answer[1])
    found = re.fullmatch(r"\s*(true|false)\s*(?:[:,;](.*))?", answer, re.I | re.S) if kind is str else None
    if found:
        return _with_places(WORDS[found[1].lower()], found[2] or "")
    raise InvalidAnswer(LIKE)


def _with_places(holds, text):
    if not text.strip():
        return holds, {}
    if holds:
        raise InvalidAnswer("what is true has no counterexample: write True alone")
    return holds, _places(text)


def _places(text):
    relations = parse(text)
    places = {}
    for relation in relations if isinstance(relations, tuple) else (relations,):
        if not (isinstance(relation, Equality) and relation.lhs.is_Symbol and relation.rhs.is_Rational):
            raise InvalidAnswer(f"a counterexample gives each letter a number; {LIKE}")
        if relation.lhs in places:
            raise InvalidAnswer(f"{relation.lhs} has two values")
        places[relation.lhs] = relation.rhs
    return places


def compared(given, relation, allowed, right):
    """The ``Verdict`` on ``truth_of`` an answer to whether the relation holds, which is ``right``.

    ``allowed(places)`` says whether the relation speaks of these values. A wrong counterexample is PARTLY right; it is
    one also where one side alone has no value.
    """
    holds, places = given
    if holds != right:
        hint = "Try the smallest cases first." if right else "There is a place where it fails: try small ones."
        return Verdict(WRONG, f"Not so. {hint}")
    if right:
        return Verdict(CORRECT, "Right.")
    missing = sorted(map(str, relation.free_symbols - {*places}))
    if missing:
        return Verdict(PARTLY, f"False, yes. Now a counterexample: a number for each of {', '.join(missing)}.")
    values = {symbol: value for symbol, value in places.items() if symbol in relation.free_symbols}
    if any(symbol.is_integer and not value.is_Integer for symbol, value in values.items()) or not allowed(values):
        return Verdict(PARTLY, "False, yes; but your letters are outside of what the statement speaks of.")
    try:
        sides = [_value(side, values) for side in (relation.lhs, relation.rhs)]
    except (OutOfTime, Unsupported):
        return Verdict(OPEN, "False, yes; but your counterexample is too large to be computed: take a smaller one.")
    undefined = [isinstance(side, Undefined) for side in sides]
    if all(undefined):
        return Verdict(PARTLY, f"False, yes; but there neither side has a value ({sides[0]}).")
    sign = "=" if relation.rel_op == "==" else relation.rel_op
    if not any(undefined) and COMPARE[sign](*sides):
        return Verdict(PARTLY, f"False, yes; but there the statement holds: both sides give {sides[0]} and {sides[1]}.")
    return Verdict(CORRECT, f"Right: there the sides are {shown(sides[0])} and {shown(sides[1])}.")


def _value(side, values):
    """The exact value, or why there is none."""
    try:
        return evaluate(side, values)
    except Undefined as why:
        return why
