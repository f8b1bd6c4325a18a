"""Functions of integers as hypergeometric terms: basis functions, binomial coefficients, factorials, points, deltas.

A rule takes the expression, the integer symbols and the conditions, and gives the terms whose sum the expression is.
"""

from sympy import Dummy, Indexed, KroneckerDelta, binomial, expand, factorial

from bezteach.symbolic import B, E

from .edges import Edge, need, never
from .linear import least
from .terms import Failure, Term, binomial_of, factorial_of, power_of, times

# b[k] is E^k times this: without it b[0] would be the number 1.
POINT = Dummy("point")


def _basis(expr, whole, conditions):
    i, n, x = expr.args
    if x.free_symbols & whole:
        raise Failure(f"the argument of {expr} holds an integer symbol")
    if x.has(Indexed):
        raise Failure(f"the argument of {expr} is a point")
    if expand(x) in (0, 1):
        _check_top(expr, n, conditions)
        return one_at_zero(i if expand(x) == 0 else n - i, conditions)
    terms = _binomial(binomial(n, i, evaluate=False), whole, conditions)
    return [times(term, times(power_of(x, i), power_of(1 - x, n - i))) for term in terms]


def one_at_zero(form, conditions):
    """1 where a form is 0, and 0 elsewhere: both sides of it are edges, unless it lies on one of them.

    >>> from bezteach.symbolic import i, n
    >>> one_at_zero(i + 1, [i]), one_at_zero(i - n, [i - n, n - i])
    ([], [Term(coefficient=1, factorials={}, powers={})])
    """
    if never(form, conditions) or never(-form, conditions):
        return []
    for side in (form, -form):
        if least(side, conditions) < 0:
            continue
        if least(-side, conditions) >= 0:
            return [Term()]
        raise Edge(expand(side - 1), vanishing=False)
    raise Edge(expand(form), vanishing=False)


def _delta(expr, whole, conditions):
    i, n, *interval = expr.args
    if interval:
        raise Failure(f"{expr} has a range of its own")
    if not (i - n).free_symbols <= whole:
        raise Failure(f"{expr} is not of integers")
    return one_at_zero(i - n, conditions)


def _binomial(expr, whole, conditions):
    """The coefficient as factorials; 0 for a lower number outside 0..top, undefined for a negative top."""
    top, bottom = expr.args
    _check_top(expr, top, conditions)
    for form in (bottom, top - bottom):
        if never(form, conditions):
            return []
        need(form, conditions, vanishing=True)
    return [binomial_of(top, bottom)]


def _check_top(expr, form, conditions):
    if least(form, conditions) < 0:
        raise Failure(f"{expr} is not defined where {form} is negative")


def _factorial(expr, whole, conditions):
    (form,) = expr.args
    _check_top(expr, form, conditions)
    return [factorial_of(form)]


def _point(expr, whole, conditions):
    if len(expr.indices) != 1:
        raise Failure(f"{expr} has more than one index")
    (index,) = expr.indices
    return [times(Term(POINT), power_of(E, index))]


ATOMS = {B: _basis, binomial: _binomial, factorial: _factorial, KroneckerDelta: _delta, Indexed: _point}
