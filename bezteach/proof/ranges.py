"""Where the symbols of a statement range, and in which order one walks through their values.

An integer symbol has ``Integers``, a real one a SymPy ``Interval``; the ends may be expressions in other symbols. What
a symbol is, its assumptions decide, and where it has none, its use: a symbol inside a degree, an index, the limit of a
sum, an order of differentiation, the argument of a binomial or factorial, or an exponent is an integer, any other is
real.
"""

import re
from typing import NamedTuple

from sympy import Expr, Indexed, Interval, S, Symbol, ceiling, floor, nan, oo, zoo

from bezteach.symbolic import E

from .errors import InvalidStatement
from .exact.evaluate import evaluator, expression
from .uses import uses

NO_NAME = r"[\s+\-*/^()=<>]"  # SymPy tells some expressions apart by what they print
TELLING = ("even", "odd", "prime", "composite", "zero", "irrational", "rational", "nonzero")
SIGNS = ("positive", "negative", "nonnegative", "nonpositive")


class Integers(NamedTuple):
    """The integers from low to high, both included if finite."""

    low: Expr
    high: Expr


def ranges(expressions, given):
    """The range of each free symbol, in the order of the walk: n, the other integers, then the reals.

    A symbol comes after those that its ends contain. ``InvalidStatement`` says what is wrong with a symbol or a range.
    """
    if not isinstance(given, dict | None):
        raise InvalidStatement(f"given is {given!r}, not a dict of ranges")
    given = {symbol: _range(symbol, wanted) for symbol, wanted in (given or {}).items()}
    found = [use for expr in expressions for use in uses(expr)]
    found += [use for r in given.values() for end in ends(r) for use in uses(end, isinstance(r, Integers))]
    _check_names({use.symbol for use in found} | set(given))
    free = {use.symbol for use in found if not use.bound}
    for symbol in given:
        if symbol not in free:
            where = (
                ", except as the variable of a sum or an integral" if symbol in {use.symbol for use in found} else ""
            )
            raise InvalidStatement(f"a range is given for {symbol}, which does not occur{where}")
    integers = {symbol for symbol in free if _is_integer(symbol, any(use.whole for use in found if use[0] == symbol))}
    for symbol in integers & set(given):
        if reals := sorted(_names(given[symbol]) & free - integers, key=str):
            raise InvalidStatement(f"the range of {symbol}, an integer, has an end with {reals[0]}, which is real")
    return _in_order({symbol: _settled(symbol, symbol in integers, given.get(symbol)) for symbol in free})


def about(expressions, given):
    """What is given of the symbols that occur in the expressions, and of those that their ranges hold.

    >>> from bezteach.symbolic import i, n, t
    >>> about([i + t], {n: (1, oo), i: (0, n), t: Interval(0, 1)}) == {n: (1, oo), i: (0, n), t: Interval(0, 1)}
    True
    """
    if not isinstance(given, dict):
        return given
    names = set().union(*(expression.free_symbols for expression in expressions))
    while more := {name for symbol in names & set(given) for name in _names(given[symbol])} - names:
        names |= more
    return {symbol: wanted for symbol, wanted in given.items() if symbol in names}


def _names(wanted):
    parts = wanted if isinstance(wanted, tuple) else getattr(wanted, "args", ())
    return set().union(*(getattr(part, "free_symbols", ()) for part in parts))


def _range(symbol, wanted):
    if not isinstance(symbol, Symbol):
        raise InvalidStatement(f"a range is given for {symbol!r}, which is not a symbol")
    if isinstance(wanted, tuple) and len(wanted) == 2:
        wanted = Integers(*map(expression, wanted))
    if isinstance(wanted, Interval | Integers):
        for end in ends(wanted):
            infinite = end.has(oo, -oo, zoo, nan) and end not in (oo, -oo)
            if infinite or end.has(E, Indexed) or (end.is_number and not end.is_extended_real):
                raise InvalidStatement(f"the range of {symbol} ends at {end}, which is no real number")
        return wanted
    empty = wanted is S.EmptySet
    raise InvalidStatement(f"the range of {symbol} " + ("is empty" if empty else f"is {wanted}, not (low, high)"))


def _check_names(symbols):
    names = {}
    for symbol in symbols:
        if names.setdefault(symbol.name, symbol) != symbol:
            raise InvalidStatement(f"two different symbols are called {symbol.name}: their assumptions differ")
        if re.search(NO_NAME, symbol.name):
            raise InvalidStatement(f"a symbol is called {symbol.name!r}, which is no name but a formula")
        if symbol.name == E.name:
            raise InvalidStatement("a symbol is called E: that is the operator, bezteach.symbolic.E")
        if strange := _unread(symbol):
            raise InvalidStatement(f"{symbol} is declared {strange}: this engine reads no such assumption")


def _unread(symbol):
    """What is assumed of a symbol, in a word, beside that it is an integer or real, and a sign; None for nothing."""
    signs = {sign: True for sign in SIGNS if getattr(symbol, f"is_{sign}")}
    read = Symbol("x", **{"integer" if symbol.is_integer else "real": True}, **signs).assumptions0
    beyond = {name for name, value in symbol.assumptions0.items() if read.get(name) is not value}
    words = ["noncommutative"] * (not symbol.is_commutative) + ["infinite"] * bool(symbol.is_infinite)
    words += ["not " + kind for kind in ("real", "an integer") if getattr(symbol, f"is_{kind.split()[-1]}") is False]
    words += [word for word in TELLING if getattr(symbol, f"is_{word}") and word in beyond | {"zero"}]
    return (words + sorted(beyond) + [None])[0]


def _is_integer(symbol, used_as_integer):
    """By its assumptions, else by its use."""
    if symbol.is_integer:
        return True
    if used_as_integer and (symbol.is_integer is False or symbol.is_real):
        raise InvalidStatement(f"{symbol} stands where a whole number must stand, but is declared real")
    return used_as_integer


def _settled(symbol, is_integer, given):
    """The range with its default; what the assumptions of the symbol exclude is not in it."""
    low, high = assumed(symbol, is_integer)
    if not is_integer:
        if isinstance(given, Integers):
            given = Interval(*given)
        found = Interval(low, high, bool(symbol.is_positive), bool(symbol.is_negative)) if given is None else given
        if not isinstance(found, Interval):
            raise InvalidStatement(f"the range of {symbol} is {found}, not an interval")
    else:
        if isinstance(given, Interval):
            raise InvalidStatement(f"{symbol} is an integer: give its range as (low, high)")
        found = given or Integers(max(low, S.Zero), high)
    first, last = ends(found)
    if first.is_number and last.is_number:
        inside = (ceiling(first), floor(last)) if is_integer else (first, last)
        if first is oo or last is -oo or not inside[0] <= inside[1]:
            raise InvalidStatement(f"the range of {symbol} is empty")
    at_zero = not is_integer and (
        (symbol.is_positive and first == 0 and not found.left_open)
        or (symbol.is_negative and last == 0 and not found.right_open)
    )
    if at_zero or (first.is_number and first < low) or (last.is_number and last > high):
        raise InvalidStatement(f"the range of {symbol} goes beyond what is assumed of the symbol")
    return found


def assumed(symbol, is_integer):
    """The lowest and the highest value that the assumptions of a symbol allow."""
    edge = S.One if is_integer else S.Zero
    low = edge if symbol.is_positive else S.Zero if symbol.is_nonnegative else -oo
    high = -edge if symbol.is_negative else S.Zero if symbol.is_nonpositive else oo
    return low, high


def ends(found):
    """The lower and the upper end of a range."""
    return tuple(found) if isinstance(found, Integers) else (found.start, found.end)


def _in_order(found):
    order = {}
    names = {s: [use.symbol for end in ends(found[s]) for use in uses(end)] for s in found}
    rest = sorted(found, key=lambda s: (not isinstance(found[s], Integers), s.name != "n", bool(names[s]), s.name))
    while rest:
        ready = [s for s in rest if all(name in order for name in names[s])]
        if not ready:
            raise InvalidStatement(f"the ranges of {', '.join(map(str, rest))} depend on each other in a circle")
        order[ready[0]] = found[ready[0]]
        rest.remove(ready[0])
        for end in ends(found[ready[0]]):
            evaluator(end, tuple(order))
    return order
