"""Builders of what binds a name: Sum and Product, Integral, Derivative, and ``Subs``, a value put in.

An empty Sum is 0 and an empty Product 1, whatever the limits. A Derivative is taken of a polynomial, and an Integral
too, between limits: the variable is kept as a letter, and its value put in afterwards.
"""

from operator import add, mul

import sympy as sp

from bezteach.symbolic import E

from ..errors import InvalidStatement, Undefined, Unsupported
from . import arithmetic as exact
from .calculus import antiderivative, derivative, put
from .closure import BUILDERS, closure
from .polynomial import OPERATOR, VARIABLE, atom

LONGEST_SUM = 5_000
HIGHEST_DERIVATIVE = 200


def _nested(expr, scope, within):
    """The function of what has limits, the last the outermost: ``within`` makes that of one limit from the body."""

    def nest(limits, scope):
        if not limits:
            return closure(expr.function, scope)
        *inner, limit = limits
        if len(limit) != 3:
            raise InvalidStatement(f"{expr} has no limits for {limit[0]}")
        symbol, low, high = limit
        low, high = closure(low, scope), closure(high, scope)
        place, scope = scope.bind(symbol)
        return within(nest(inner, scope), symbol, place, low, high)

    return nest(expr.limits, scope)


def _loop(combine, start):
    """Sum and Product."""

    def within(body, index, place, low, high):
        def total(frame):
            first, last = exact.whole(low(frame), "a limit"), exact.whole(high(frame), "a limit")
            if last - first >= LONGEST_SUM:
                raise Unsupported(f"a sum or product over {last - first + 1} terms")
            value = start
            for frame[place] in range(first, last + 1):
                frame[0].spend()
                value = exact.small(combine(value, body(frame)))
            return value

        return total

    return lambda expr, scope: _nested(expr, scope, within)


def _integral(expr, scope):
    def within(body, symbol, place, low, high):
        letter = atom(VARIABLE, symbol.name, place)

        def total(frame):
            frame[0].spend()
            frame[place] = letter
            whole = antiderivative(body(frame), letter)
            return put(whole, letter, high(frame)) - put(whole, letter, low(frame))

        return total

    return _nested(expr, scope, within)


def _derivative(expr, scope):
    def nest(counts, scope):
        if not counts:
            return closure(expr.expr, scope)
        (variable, count), *inner = counts
        if not isinstance(variable, sp.Symbol):
            raise InvalidStatement(f"{expr} differentiates by {variable}")
        at, times = closure(variable, scope), closure(count, scope)
        place, scope = scope.bind(variable)
        body = nest(inner, scope)
        letter = atom(OPERATOR if variable == E else VARIABLE, variable.name, place)

        def value(frame):
            order = exact.whole(times(frame), "the order of a derivative")
            if order < 0:
                raise Undefined(f"a derivative of order {order}")
            if order > HIGHEST_DERIVATIVE:
                raise Unsupported(f"a derivative of order {order}")
            frame[place] = letter
            result = body(frame)
            for _ in range(order):
                frame[0].spend()
                result = exact.small(derivative(result, letter))
            return put(result, letter, at(frame))

        return value

    return nest(expr.variable_count, scope)


def _at(expr, scope):
    """``Subs``: an expression with values in the place of some of its symbols, all at once."""
    for symbol in expr.variables:
        if not symbol.is_Symbol:
            raise InvalidStatement(f"{expr} puts a value in for {symbol}, which is no symbol")
    _check_order(expr)
    points = [closure(point, scope) for point in expr.point]
    places = []
    for symbol in expr.variables:
        place, scope = scope.bind(symbol)
        places.append(place)
    body = closure(expr.expr, scope)

    def value(frame):
        for place, number in zip(places, [point(frame) for point in points], strict=True):
            frame[place] = number
        return body(frame)

    return value


def _check_order(expr):
    """SymPy makes one Subs of two, the inner one first: ``InvalidStatement`` where that is not the same as at once."""
    for place, point in enumerate(expr.point):
        later = expr.variables[place + 1 :]
        if expr.variables[place] in later or not point.free_symbols.isdisjoint(later):
            raise InvalidStatement(f"in {expr} it matters which value is put in first")


BUILDERS |= {
    sp.Sum: _loop(add, 0),
    sp.Product: _loop(mul, 1),
    sp.Integral: _integral,
    sp.Derivative: _derivative,
    sp.Subs: _at,
}
