"""Linear forms in integer symbols: what is the least value that one takes where others are not negative?"""

from math import ceil

from sympy import Dummy, Rational, S, expand, oo

from bezteach.symbolic import E

_VALUE = Dummy("value")


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
    where the conditions cannot hold together. What is not linear has no bound, and a condition that is not is left out.

    >>> from bezteach.symbolic import i, n
    >>> least(n - i - 1, [i, n - i]), least(n - i, [i, n]), least(i, [i - 3, 2 - i])
    (-1, -oo, oo)
    """
    rows = [row for row in map(coefficients, conditions) if row is not None]
    target = coefficients(form)
    if target is None:
        return -oo
    rows += [_sum(target, {_VALUE: S.NegativeOne}), _sum({s: -c for s, c in target.items()}, {_VALUE: S.One})]
    while symbols := {s for row in rows for s, c in row.items() if c != 0 and s not in (S.One, _VALUE)}:
        rows = _without(min(symbols, key=str), rows)
    if any(row.get(_VALUE, 0) == 0 and row.get(S.One, 0) < 0 for row in rows):
        return oo
    bounds = [-row.get(S.One, 0) / row[_VALUE] for row in rows if row.get(_VALUE, 0) > 0]
    tops = [row.get(S.One, 0) / -row[_VALUE] for row in rows if row.get(_VALUE, 0) < 0]
    if bounds and tops and max(bounds) > min(tops):
        return oo
    return ceil(max(bounds)) if bounds else -oo


def _without(symbol, rows):
    """What the inequalities say of the other symbols: each lower bound of this one lies below each upper one."""
    lower = [row for row in rows if row.get(symbol, 0) > 0]
    upper = [row for row in rows if row.get(symbol, 0) < 0]
    rest = [row for row in rows if row.get(symbol, 0) == 0]
    return rest + [_sum(low, high, -high[symbol], low[symbol]) for low in lower for high in upper]


def _sum(one, other, times=S.One, other_times=S.One):
    return {s: times * one.get(s, 0) + other_times * other.get(s, 0) for s in {**one, **other}}
