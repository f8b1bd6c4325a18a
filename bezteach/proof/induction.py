"""Equations with a partial sum, proved by induction on the limit that moves: one case, and the step to the next.

A sum from k = s on loses its first summand when s grows by one, and a sum up to s gains one. So the step is an equation
without that sum, and ``algebra`` decides it and the case at the end of the range.
"""

from sympy import Add, Sum, expand

from .algebra import by_algebra, with_fresh_indices
from .ranges import Integers
from .statement import Statement
from .terms import Failure
from .verdict import PROVED, Proof


def by_induction(statement, budget):
    """A ``Proof`` of an equation by induction on one of its integer symbols, or None.

    >>> from bezteach.proof.budget import Budget
    >>> from bezteach.proof.statement import statement
    >>> from bezteach.symbolic import k, n
    >>> from sympy import Sum
    >>> by_induction(statement(Sum(k, (k, 0, n)), n * (n + 1) / 2), Budget(5)).status
    'PROVED'
    """
    if statement.relation != "=":
        return None
    sides = tuple(with_fresh_indices(expand(side)) for side in (statement.lhs, statement.rhs))
    limits = {limit for side in sides for part in side.atoms(Sum) for limit in part.limits[-1][1:]}
    for symbol in [s for s, values in statement.ranges.items() if isinstance(values, Integers) and s in limits]:
        for upward in (True, False):
            budget.spend()
            proof = _along(symbol, upward, sides, statement.ranges, budget)
            if proof is not None:
                return proof
    return None


def _along(symbol, upward, sides, ranges, budget):
    low, high = ranges[symbol]
    start, end = (low, high) if upward else (high, low)
    others = {s: values for s, values in ranges.items() if s != symbol}
    if start.is_infinite or any(symbol in _ends(values) for values in others.values()):
        return None
    try:
        steps = tuple(_difference(side, symbol, upward) for side in sides)
    except Failure:
        return None
    inner = Integers(low, high - 1)
    first = by_algebra(Statement(*_equation([side.subs(symbol, start) for side in sides]), others), budget)
    step = by_algebra(Statement(*_equation(steps), {**others, symbol: inner}), budget)
    if first is None or step is None:
        return None
    return Proof(PROVED, "induction", first.steps + step.steps, f"on {symbol}, from {start}")


def _equation(sides):
    return sides[0], "=", sides[1]


def _ends(values):
    return values.low.free_symbols | values.high.free_symbols if isinstance(values, Integers) else set()


def _difference(side, symbol, upward):
    """side at symbol + 1 less side at symbol; a partial sum gives its one summand."""
    return Add(*[_difference_of_part(part, symbol, upward) for part in Add.make_args(side)])


def _difference_of_part(part, symbol, upward):
    sums = [factor for factor in part.args if isinstance(factor, Sum)] if part.is_Mul else [part]
    if len(sums) == 1 and isinstance(sums[0], Sum) and len(sums[0].limits) == 1:
        (total,) = sums
        front = part / total
        index, low, high = total.limits[0]
        if not (front.has(symbol) or total.function.has(symbol)):
            if low == symbol and not high.has(symbol):
                return -front * total.function.subs(index, symbol)
            if high == symbol and not low.has(symbol):
                return front * total.function.subs(index, symbol + 1)
    return part.subs(symbol, symbol + 1) - part
