"""Where something that divides is 0: points that the refuter's walk from the smallest on might never come to."""

from fractions import Fraction
from itertools import islice

from sympy import Pow, Sum

from ..errors import InvalidStatement, Undefined, Unsupported
from ..indices import with_fresh_indices
from .evaluate import evaluator
from .polynomial import Polynomial
from .walk import is_allowed

MOST = 24  # points


def roots(statement, walked, budget):
    """Allowed points at which a divisor vanishes that is linear in a letter, beside those that are walked to.

    >>> from bezteach.proof.budget import Budget
    >>> from bezteach.proof.statement import statement
    >>> from bezteach.symbolic import n, t
    >>> list(roots(statement(t / (n - 12), 0), [(3, 1)], Budget(1)))
    [(Fraction(12, 1), 1)]
    """
    symbols = tuple(statement.ranges)
    found = (
        point
        for divisor in dict.fromkeys(
            divisor for side in (statement.lhs, statement.rhs) for divisor in _divisors(with_fresh_indices(side))
        )
        if divisor.free_symbols and divisor.free_symbols <= set(symbols)
        for values in walked
        for point in _zeros(divisor, symbols, values, budget)
        if is_allowed(point, statement.ranges, budget)
    )
    return islice(dict.fromkeys(found), MOST)


def _divisors(expr):
    """The bases of powers that may divide; a letter that a sum runs over stands at an end of its range."""
    found = [expr.base] if isinstance(expr, Pow) and not expr.exp.is_nonnegative else []
    found += [divisor for part in expr.args for divisor in _divisors(part)]
    for index, *ends in expr.limits if isinstance(expr, Sum) else ():
        found = [divisor.xreplace({index: end}) for divisor in found for end in ends]
    return found


def _zeros(divisor, symbols, values, budget):
    """The points that differ from one in one letter, and where the divisor is 0 if it is linear in that letter."""
    run = evaluator(divisor, symbols)
    for place in range(len(symbols)):
        if symbols[place] not in divisor.free_symbols:
            continue
        try:
            first, second = (run((*values[:place], value, *values[place + 1 :]), budget) for value in (0, 1))
        except (Undefined, Unsupported, InvalidStatement):
            continue
        if not isinstance(first - second, Polynomial) and first != second:
            yield (*values[:place], Fraction(first) / (first - second), *values[place + 1 :])
