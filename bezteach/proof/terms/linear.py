"""Linear forms in integer symbols: what is the least value that one takes where others are not negative?"""

from fractions import Fraction
from functools import lru_cache
from math import ceil, gcd, lcm

from sympy import Dummy, Integer, Rational, S, expand, oo

from bezteach.symbolic import E

_VALUE = Dummy("value")
MOST = 500  # inequalities that one step of the elimination may leave; it may square their number


def coefficients(form):
    """{symbol: coefficient, 1: constant} of a linear form with rational coefficients; None for anything else, such as
    one with the operator E, which is no number.

    >>> from bezteach.symbolic import i, n
    >>> coefficients(n - i + 1) == {n: 1, i: -1, S.One: 1}, coefficients(n * i)
    (True, None)
    """
    found = {S.One: S.Zero} | dict(expand(form).as_coefficients_dict())
    linear = all(part == 1 or (part.is_Symbol and part != E) for part in found)
    return found if linear and all(isinstance(c, Rational) for c in found.values()) else None


def is_whole_form(form):
    """Whether it is a linear form with integer coefficients: a whole number where all of its symbols are. A symbol that
    is declared to be none, as the variables of integrals are by ``defined``, makes it none.

    >>> from bezteach.symbolic import i, n
    >>> is_whole_form(n - 2 * i), is_whole_form(n / 2), is_whole_form(n**2)
    (True, False, False)
    """
    found = coefficients(form)
    return found is not None and all(c.is_Integer and part.is_integer is not False for part, c in found.items())


def least(form, conditions):
    """A lower bound of an integer linear form where every one of the conditions, linear forms, is >= 0.

    It is the least value over the real numbers, rounded up (Fourier-Motzkin elimination); -oo where there is none, oo
    where the conditions cannot hold together. What is not linear has no bound, and a condition that is not is left out;
    none is found where the elimination grows too large.

    >>> from bezteach.symbolic import i, n
    >>> least(n - i - 1, [i, n - i]), least(n - i, [i, n]), least(i, [i - 3, 2 - i])
    (-1, -oo, oo)
    """
    return _least(form, tuple(conditions))


def impossible(conditions):
    """Whether conditions, linear forms that are to be >= 0, are known not to hold together.

    >>> from bezteach.symbolic import i
    >>> impossible([i - 3, 2 - i]), impossible([i - 2, 2 - i])
    (True, False)
    """
    return least(S.Zero, conditions) == oo


@lru_cache(maxsize=2**14)  # a proof asks the same of each of its terms
def _least(form, conditions):
    target = coefficients(form)
    if target is None:
        return -oo
    given = {_inequality(row) for row in map(coefficients, conditions) if row is not None}
    rows = given | {_inequality(target | {_VALUE: S.NegativeOne}), _inequality(_negative(target) | {_VALUE: S.One})}
    while symbols := {s for row in rows for s, _ in row if s not in (S.One, _VALUE)}:
        lower, upper, rest = min((_bounds(symbol, rows) for symbol in sorted(symbols, key=str)), key=_count)
        if _count((lower, upper, rest)) > MOST:
            return -oo
        rows = rest | {_sum(high_c, low, low_c, high) for low_c, low in lower for high_c, high in upper}
    ends = [(row.get(_VALUE, 0), row.get(S.One, 0)) for row in map(dict, rows)]
    if any(slope == 0 and constant < 0 for slope, constant in ends):
        return oo
    bounds = [Fraction(-constant, slope) for slope, constant in ends if slope > 0]
    tops = [Fraction(-constant, slope) for slope, constant in ends if slope < 0]
    if bounds and tops and max(bounds) > min(tops):
        return oo
    return Integer(ceil(max(bounds))) if bounds else -oo


def _inequality(row):
    """The row >= 0 in least whole numbers: its (symbol, coefficient) where that is not 0."""
    scale = lcm(*(int(c.q) for c in row.values()))
    return _reduced({s: int(c * scale) for s, c in row.items()})


def _reduced(row):
    divisor = gcd(*row.values()) or 1
    return frozenset((s, c // divisor) for s, c in row.items() if c)


def _negative(row):
    return {s: -c for s, c in row.items()}


def _bounds(symbol, rows):
    """The rows that bound a symbol from below and from above, with their coefficients, and those without it."""
    found = [(dict(row).get(symbol, 0), row) for row in rows]
    lower = [(c, dict(row)) for c, row in found if c > 0]
    upper = [(-c, dict(row)) for c, row in found if c < 0]
    return lower, upper, {row for c, row in found if c == 0}


def _count(bounds):
    """How many inequalities are left without the symbol: each lower bound of it lies below each upper one."""
    lower, upper, rest = bounds
    return len(lower) * len(upper) + len(rest)


def _sum(times, one, other_times, other):
    return _reduced({s: times * one.get(s, 0) + other_times * other.get(s, 0) for s in one | other})
