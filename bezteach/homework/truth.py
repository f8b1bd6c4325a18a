"""True or false, and if false a counterexample that must refute."""

from sympy import Rational

from bezteach.parsing import InvalidAnswer, parse
from bezteach.proof import InvalidStatement, OutOfTime, Undefined, Unsupported, evaluate
from bezteach.proof.exact.refuter import COMPARE

from .verdict import CORRECT, INVALID, OPEN, PARTLY, WRONG, Verdict

WORDS = {"true": True, "false": False}
LIKE = 'write True, or False with a counterexample: (False, "n = 2, t = 1/2")'


def truth_of(answer):
    """(True, {}) or (False, {letter: number}) of ``True``, ``"true"``, ``(False, "n = 2, t = 1/2")`` or a text of it.

    >>> truth_of((False, "n = 2, t = 1/2"))
    (False, {n: 2, t: 1/2})
    >>> truth_of("false: t = 3")
    (False, {t: 3})

    ``InvalidAnswer`` says what is wrong.
    """
    kind = type(answer)
    if kind is bool:
        return answer, {}
    if kind in (tuple, list) and len(answer) == 2 and type(answer[0]) is bool and type(answer[1]) is str:
        return _with_places(answer[0], answer[1])
    if kind is str:
        word, _, rest = answer.partition(":")
        if word.strip().lower() in WORDS:
            return _with_places(WORDS[word.strip().lower()], rest)
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
        symbol, value = (
            getattr(relation, "args", (None, None)) if getattr(relation, "rel_op", "") == "==" else (None, 0)
        )
        if not getattr(symbol, "is_Symbol", False) or not isinstance(value, Rational):
            raise InvalidAnswer(f"a counterexample gives each letter a number; {LIKE}")
        if symbol in places:
            raise InvalidAnswer(f"{symbol} has two values")
        places[symbol] = value
    return places


def compared(given, relation, allowed, right):
    """The ``Verdict`` on ``truth_of`` an answer: ``relation`` is the statement, ``right`` whether it is true, and
    ``allowed(places)`` says whether it speaks of these values.

    A wrong counterexample to a false statement is PARTLY right.
    """
    holds, places = given
    if holds != right:
        return Verdict(
            WRONG,
            "Not so. Try the smallest cases first." if right else "There is a place where it fails: try small ones.",
        )
    if right:
        return Verdict(CORRECT, "Right.")
    missing = sorted(map(str, relation.free_symbols - {*places}))
    if missing:
        return Verdict(PARTLY, f"False, yes. Now a counterexample: a number for each of {', '.join(missing)}.")
    values = {symbol: value for symbol, value in places.items() if symbol in relation.free_symbols}
    if any(symbol.is_integer and not value.is_Integer for symbol, value in values.items()) or not allowed(values):
        return Verdict(PARTLY, "False, yes; but your letters are outside of what the statement speaks of.")
    try:
        sides = evaluate(relation.lhs, values), evaluate(relation.rhs, values)
    except Undefined as why:
        return Verdict(PARTLY, f"False, yes; but there one side has no value ({why}).")
    except (OutOfTime, Unsupported):
        return Verdict(OPEN, "False, yes; but your counterexample is too large to be computed: take a smaller one.")
    except InvalidStatement as why:
        return Verdict(INVALID, str(why))
    sign = "=" if relation.rel_op == "==" else relation.rel_op
    if COMPARE[sign](*sides):
        return Verdict(PARTLY, f"False, yes; but there the statement holds: both sides give {sides[0]} and {sides[1]}.")
    return Verdict(CORRECT, f"Right: there the sides are {sides[0]} and {sides[1]}.")
