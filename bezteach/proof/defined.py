"""Is every part of an expression defined wherever the conditions hold? A prover must know before it drops a term.

0 times an undefined number is undefined, so a proof that leaves out a vanishing binomial coefficient, or cancels a
factor, is good only where everything beside it has a value.
"""

from sympy import Derivative, Indexed, Integral, Pow, Subs, Sum, binomial, factorial

from bezteach.symbolic import B, E

from .linear import coefficients, least
from .terms import Failure


def check_defined(expr, conditions):
    """Return if every part has a value for all integers that the conditions allow and all reals, else ``Failure``.

    >>> from bezteach.symbolic import i, n, t
    >>> check_defined(B(i, n - 1, t) / n, [n - 1])
    >>> check_defined(t ** (i - 1), [i])
    Traceback (most recent call last):
    ...
    bezteach.proof.terms.Failure: t**(i - 1) has a negative exponent somewhere
    """
    if isinstance(expr, Sum):
        for index, low, high in expr.limits[::-1]:
            conditions = [*conditions, index - low, high - index]
        check_defined(expr.function, conditions)
        return
    if isinstance(expr, Indexed):
        return
    if isinstance(expr, Pow):
        _check_power(expr, conditions)
    elif isinstance(expr, B):
        _check_whole(expr, *expr.args[:2])
        _check_not_negative(expr, expr.args[1], conditions)
    elif isinstance(expr, binomial | factorial):
        _check_whole(expr, *expr.args)
        _check_not_negative(expr, expr.args[0], conditions)
    for part in _bodies(expr):
        check_defined(part, conditions)


def _bodies(expr):
    """The parts that must have a value, without variables, limits and points."""
    if isinstance(expr, Derivative | Subs):
        return (expr.expr,)
    return (expr.function,) if isinstance(expr, Integral) else expr.args


def _check_whole(expr, *forms):
    for form in forms:
        found = coefficients(form)
        if found is None or not all(c.is_Integer for c in found.values()):
            raise Failure(f"{form} in {expr} is not known to be a whole number")


def _check_not_negative(expr, form, conditions):
    if least(form, conditions) < 0:
        raise Failure(f"{expr} is not defined where {form} is negative")


def _check_power(expr, conditions):
    base, exponent = expr.as_base_exp()
    _check_whole(expr, exponent)
    if base == E or (base.is_number and base.is_nonzero):
        return
    if exponent.is_Integer and exponent < 0:
        if isinstance(base, binomial):
            top, bottom = base.args
            never_zero = least(bottom, conditions) >= 0 and least(top - bottom, conditions) >= 0
        else:
            never_zero = isinstance(base, factorial) or _never_zero(base, conditions)
        if not never_zero:
            raise Failure(f"{base} may be 0, and something is divided by it")
    elif least(exponent, conditions) < 0:
        raise Failure(f"{expr} has a negative exponent somewhere")


def _never_zero(base, conditions):
    return least(base - 1, conditions) >= 0 or least(-base - 1, conditions) >= 0
