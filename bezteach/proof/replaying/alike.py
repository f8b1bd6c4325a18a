"""Are two expressions the same but for the names of what a sum or an integral binds, and the order of terms?"""

from collections import Counter

from sympy import Add, Derivative, Integral, Mul, Product, Subs, Sum


def alike(one, other):
    """Whether two expressions differ in nothing but bound names; nothing is simplified.

    >>> from bezteach.symbolic import B, i, j, n, t
    >>> from sympy import Sum
    >>> alike(Sum(B(i, n, t), (i, 0, n)), Sum(B(j, n, t), (j, 0, n))), alike(Sum(i, (i, 0, n)), Sum(j, (i, 0, n)))
    (True, False)
    """
    return shape(one) == shape(other)


def shape(expr, bound=None):
    """A nested tuple that is the same for expressions that are alike."""
    bound = bound or {}
    if not expr.args:
        return ("leaf", bound.get(expr, expr))  # a tuple: SymPy would try to make its own of what it is compared with
    if isinstance(expr, Sum | Product | Integral):
        return _of_binder(expr, bound)
    if isinstance(expr, Subs):
        points = tuple(shape(point, bound) for point in expr.point)
        return Subs, points, shape(expr.expr, _with(bound, expr.variables))
    if isinstance(expr, Derivative):
        counts = tuple((shape(symbol, bound), shape(count, bound)) for symbol, count in expr.variable_count)
        return Derivative, counts, shape(expr.expr, bound)
    parts = [shape(part, bound) for part in expr.args]
    if isinstance(expr, Add | Mul):
        return expr.func, frozenset(Counter(parts).items())
    return expr.func, tuple(parts)


def _of_binder(expr, bound):
    limits = []
    for symbol, *ends in reversed(expr.limits):
        limits.append(tuple(shape(end, bound) for end in ends))
        bound = _with(bound, [symbol])
    return expr.func, tuple(limits), shape(expr.function, bound)


def _with(bound, symbols):
    """A number for each bound name, larger than those of all that were bound before it: a name may be bound again."""
    first = 1 + max((number for _, number in bound.values()), default=-1)
    return bound | {symbol: ("bound", number) for number, symbol in enumerate(symbols, first)}
