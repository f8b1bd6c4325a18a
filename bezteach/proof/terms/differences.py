"""What an expression gains when a symbol grows by one: a sum over shifted ranges is the sum over their common range
and the terms at its ends."""

from sympy import Add, Derivative, Sum, expand

from .linear import least

MOST_ENDS = 4  # terms at an end that are written out


def difference(expr, symbol, conditions):
    """The expression at symbol + 1 less the expression at the symbol, where the conditions hold.

    >>> from bezteach.symbolic import i, k, n
    >>> difference(Sum(k**2, (k, i, n)), n, [i, n - i]), difference(Sum(k * n, (k, 0, n)), n, [n])
    ((n + 1)**2, (n + 1)**2 + Sum(-k*n + k*(n + 1), (k, 0, n)))
    """
    return Add(*[_of_part(part, symbol, conditions) for part in Add.make_args(expr)])


def _of_part(part, symbol, conditions):
    if isinstance(part, Derivative) and not any(limit.has(symbol) for limit in part.args[1:]):
        return Derivative(difference(part.expr, symbol, conditions), *part.args[1:])
    sums = [factor for factor in part.args if isinstance(factor, Sum)] if part.is_Mul else [part]
    if len(sums) == 1 and isinstance(sums[0], Sum) and len(sums[0].limits) == 1:
        found = _of_sum(part / sums[0] * sums[0].function, sums[0].limits[0], symbol, conditions)
        if found is not None:
            return found
    return part.subs(symbol, symbol + 1) - part


def _of_sum(now, limits, symbol, conditions):
    """For a sum of ``now``; None where the ranges do not overlap, or where one of them may end before it begins."""
    index, low, high = limits
    after, up = now.subs(symbol, symbol + 1), [expand(end.subs(symbol, symbol + 1) - end) for end in (low, high)]
    if not all(step.is_Integer and abs(step) <= MOST_ENDS for step in up):
        return None
    first, last = low + max(up[0], 0), high + min(up[1], 0)
    if least(last - first + 1, conditions) < 0:
        return None

    def between(body, begin, end):
        """The terms from begin to end, which are few."""
        return [body.subs(index, expand(begin + step)) for step in range(int(expand(end - begin)) + 1)]

    gained = between(after, low + up[0], first - 1) + between(after, last + 1, high + up[1])
    lost = between(now, low, first - 1) + between(now, last + 1, high)
    change = after - now
    common = [Sum(change, (index, first, last))] if change != 0 else []
    return Add(*gained, *[-term for term in lost], *common)
