"""Is every part of an expression defined wherever the conditions hold? A prover must know before it drops a term.

0 times an undefined number is undefined, so a proof that leaves out a vanishing binomial coefficient, or cancels a
factor, is good only where everything beside it has a value.
"""

from sympy import (
    Abs,
    Add,
    Derivative,
    Dummy,
    Indexed,
    Integral,
    Interval,
    KroneckerDelta,
    Max,
    Min,
    Mul,
    Pow,
    Rational,
    Subs,
    Sum,
    Symbol,
    binomial,
    ceiling,
    factorial,
    floor,
    oo,
)

from bezteach.symbolic import B, E

from ..indices import renamed, with_fresh_indices
from ..inequalities.sign_of import Region, signs
from .linear import is_whole_form, least
from .terms import Failure

# Functions of numbers, which the operator is none of; they have no derivative at some of them.
_OF_NUMBERS = (Abs, Max, Min, floor, ceiling)
# These have a value where all their parts have one.
_OF_ITS_PARTS = (Rational, Symbol, Add, Mul, Integral, *_OF_NUMBERS)


def check_defined(expr, conditions, ranges=None):
    """Return if every part has a value for all integers that the conditions allow and all reals, else ``Failure``.

    What divides may hold real symbols if their ranges are given: a dict {symbol: Interval}, where others are passed by.

    >>> from bezteach.symbolic import i, n, t
    >>> check_defined(B(i, n - 1, t) / n, [n - 1])
    >>> check_defined(1 / (1 - t), [], {t: Interval.open(0, 1)})
    >>> check_defined(t ** (i - 1), [i])
    Traceback (most recent call last):
    ...
    bezteach.proof.terms.failure.Failure: t**(i - 1) has a negative exponent somewhere
    """
    _check(with_fresh_indices(expr), list(conditions), _reals(ranges or {}))


def _reals(ranges):
    """The intervals of the real symbols; an end that is no rational number is left out."""
    found = {}
    for symbol, values in ranges.items():
        if isinstance(values, Interval):
            low = values.start if values.start.is_Rational else -oo
            high = values.end if values.end.is_Rational else oo
            found[symbol] = Interval(low, high, values.left_open, values.right_open)
    return found


def _check(expr, conditions, reals):
    if isinstance(expr, Sum):
        for index, low, high in expr.limits[::-1]:
            _check_ends(expr, (low, high), conditions, reals)
            conditions = [*conditions, index - low, high - index]
        _check(expr.function, conditions, reals)
        return
    if isinstance(expr, Indexed):
        _check_ends(expr, expr.indices, conditions, reals)
        return
    if isinstance(expr, Pow):
        _check_power(expr, conditions, reals)
    elif isinstance(expr, B):
        _check_whole(expr, *expr.args[:2])
        _check_not_negative(expr, expr.args[1], conditions)
    elif isinstance(expr, binomial | factorial):
        _check_whole(expr, *expr.args)
        _check_not_negative(expr, expr.args[0], conditions)
    elif isinstance(expr, KroneckerDelta):
        _check_whole(expr, *expr.args[:2])
    elif isinstance(expr, Derivative):
        if expr.expr.has(*_OF_NUMBERS):  # SymPy names one everywhere: sign(t) for Abs(t)
            raise Failure(f"it is not known where {expr} has a value")
        for _, order in expr.variable_count:
            _check_ends(expr, [order], conditions, reals)
            _check_not_negative(expr, order, conditions)
    elif isinstance(expr, Subs):
        for point in expr.point:
            _check(point, conditions, reals)
    elif not isinstance(expr, _OF_ITS_PARTS) or (isinstance(expr, _OF_NUMBERS) and expr.has(E)):
        raise Failure(f"it is not known where {expr} has a value")
    for part in _bodies(expr):
        _check(part, conditions, reals)


def _bodies(expr):
    """The parts that must have a value, without variables and points.

    What is bound in them is a letter of its own, that is no whole number; an operator, where one is put in its place.
    """
    if isinstance(expr, Derivative):
        parts, bound = (expr.expr,), {symbol: symbol for symbol, _ in expr.variable_count}
    elif isinstance(expr, Subs):
        parts, bound = (expr.expr,), dict(zip(expr.variables, expr.point, strict=True))
    elif isinstance(expr, Integral):  # an inner limit may hold an outer variable
        parts = (expr.function, *(end for _, *ends in expr.limits for end in ends))
        bound = {symbol: symbol for symbol in expr.variables}
    else:
        return expr.args
    letters = {symbol: _stand_in(symbol, value) for symbol, value in bound.items()}
    return [renamed(part, letters) for part in parts]


def _stand_in(symbol, value):
    letter = Dummy(symbol.name, integer=False)
    return E + letter if value.has(E) else letter


def _check_ends(expr, forms, conditions, reals):
    """Limits, indices and orders: whole numbers, and each with a value before anything in it is cancelled."""
    _check_whole(expr, *forms)
    for form in forms:
        _check(form, conditions, reals)


def _check_whole(expr, *forms):
    for form in forms:
        if not is_whole_form(form):
            raise Failure(f"{form} in {expr} is not known to be a whole number")


def _check_not_negative(expr, form, conditions):
    if least(form, conditions) < 0:
        raise Failure(f"{expr} is not defined where {form} is negative")


def _check_power(expr, conditions, reals):
    base, exponent = expr.as_base_exp()
    _check_whole(expr, exponent)
    if base == E or least(exponent, conditions) >= 0 or _never_zero(base, conditions, reals):
        return
    if exponent.is_Integer:
        raise Failure(f"{base} may be 0, and something is divided by it")
    raise Failure(f"{expr} has a negative exponent somewhere")


def _never_zero(base, conditions, reals):
    if base.has(E):  # no number: 1 + E^2 takes some points to 0
        return False
    if base.is_number:
        return base.is_nonzero
    if isinstance(base, Pow | Mul):
        return all(_never_zero(part.as_base_exp()[0], conditions, reals) for part in Mul.make_args(base))
    if isinstance(base, binomial):
        top, bottom = base.args
        return least(bottom, conditions) >= 0 and least(top - bottom, conditions) >= 0
    if isinstance(base, factorial) or least(base - 1, conditions) >= 0 or least(-base - 1, conditions) >= 0:
        return True
    whole = frozenset().union(*(condition.free_symbols for condition in conditions)) - reals.keys()
    return bool(reals) and 0 not in signs(base, Region(whole, tuple(conditions), reals))
