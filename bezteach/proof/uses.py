"""Where the symbols of an expression stand: what they must be there, and whether a sum or an integral binds them."""

from typing import NamedTuple

from sympy import (
    Derivative,
    FallingFactorial,
    Indexed,
    Integral,
    KroneckerDelta,
    Pow,
    Product,
    RisingFactorial,
    Subs,
    Sum,
    Symbol,
    binomial,
    factorial,
)

from bezteach.symbolic import B, E


class Use(NamedTuple):
    """One occurrence of a symbol: whether a whole number must stand there, and whether a binder has bound it."""

    symbol: Symbol
    whole: bool
    bound: bool


def uses(expr, whole=False, bound=frozenset()):
    """Every occurrence of a symbol in an expression, the operator E and the names of points left out.

    >>> from sympy.abc import n, t
    >>> [use.whole for use in uses(t**n)]
    [False, True]
    """
    if isinstance(expr, Symbol):
        if expr != E:
            yield Use(expr, whole, expr in bound)
    elif isinstance(expr, Indexed):
        yield from _all(expr.indices, True, bound)
    elif isinstance(expr, Sum | Product | Integral):
        yield from _uses_of_binder(expr, bound)
    elif isinstance(expr, Derivative):
        yield from uses(expr.expr, whole, bound)
        for symbol, count in expr.variable_count:
            yield from uses(symbol, False, bound)
            yield from uses(count, True, bound)
    elif isinstance(expr, Subs):
        yield from _all(expr.point, whole, bound)
        yield from (Use(symbol, False, True) for symbol in expr.variables if symbol.is_Symbol and symbol != E)
        yield from uses(expr.expr, whole, bound | set(expr.variables))
    else:
        kinds = [kind for kind in type(expr).__mro__ if kind in _WHOLE]
        places = _WHOLE[kinds[0]] if kinds else ()
        inherited = whole and (not kinds or kinds[0] is Pow)
        for place, argument in enumerate(expr.args):
            yield from uses(argument, inherited or place in places, bound)


_WHOLE = {
    B: (0, 1),
    Pow: (1,),
    binomial: (0, 1),
    factorial: (0,),
    FallingFactorial: (1,),
    RisingFactorial: (1,),
    KroneckerDelta: (0, 1),
}


def _all(expressions, whole, bound):
    for expr in expressions:
        yield from uses(expr, whole, bound)


def _uses_of_binder(expr, bound):
    over_integers = not isinstance(expr, Integral)
    for limit in reversed(expr.limits):
        symbol, *ends = limit
        yield from _all(ends, over_integers, bound)
        bound = bound | {symbol}
        yield Use(symbol, over_integers, True)
    yield from uses(expr.function, False, bound)
