"""What ranges say for all values together: linear forms that are >= 0, and whether a range is one everywhere."""

from sympy import Interval, ilcm, oo, preorder_traversal

from .errors import InvalidStatement
from .ranges import Integers, assumed, ends
from .terms.defined import check_defined
from .terms.failure import Failure
from .terms.linear import coefficients, is_whole_form, least


def region_of(ranges):
    """The integer symbols, and the forms that are >= 0 in these ranges."""
    whole = frozenset(s for s, values in ranges.items() if isinstance(values, Integers))
    conditions = []
    for symbol in whole:
        low, high = ranges[symbol]
        conditions += [symbol - low] * (low != -oo) + [high - symbol] * (high != oo)
    return whole, conditions


def check_ranges(found):
    """``InvalidStatement`` if an end of a range may have no value, or may go beyond what is assumed of the symbol.

    The refuter meets only what is near, and SymPy goes by what is assumed.
    """
    conditions = region_of(found)[1]
    for symbol, values in found.items():
        low, high = ends(values)
        lowest, highest = assumed(symbol, isinstance(values, Integers))
        real = isinstance(values, Interval)
        sides = (
            (low, lowest, 1, real and symbol.is_positive and not values.left_open),
            (high, highest, -1, real and symbol.is_negative and not values.right_open),
        )
        for end, assumed_end, sign, strict in sides:
            if not (end.is_infinite or (real and all(map(_has_a_value, preorder_traversal(end))))):
                _check_end(symbol, end, conditions)
            if assumed_end.is_finite and not _is_never_negative(sign * (end - assumed_end), conditions, strict):
                raise InvalidStatement(f"the range of {symbol} may go beyond what is assumed of it")


def _check_end(symbol, end, conditions):
    try:
        check_defined(end, conditions)
    except Failure as error:
        raise InvalidStatement(f"the range of {symbol} may have no end: {error}") from None


def _has_a_value(number):
    """Whether it is a rational number, a root of a positive one, a sum, a product: ``check_defined`` knows no roots."""
    is_root = number.is_Pow and all(part.is_Rational for part in number.args) and number.base > 0
    return number.is_Rational or is_root or number.is_Add or number.is_Mul


def _is_never_negative(form, conditions, strict):
    """Whether a form is >= 0, or > 0 if that is wanted."""
    row = coefficients(form)
    if row is None:
        return form.is_extended_positive if strict else form.is_extended_nonnegative
    return least(form * ilcm(1, *(c.q for c in row.values())), conditions) >= int(bool(strict))


def has_values(values, known):
    """Whether a range is known to hold a value wherever the symbols of the known ranges have theirs.

    >>> from sympy import S
    >>> from bezteach.symbolic import n
    >>> known = {n: Integers(S.Zero, oo)}
    >>> has_values(Integers(S.Zero, n), known), has_values(Integers(S.One, n), known)
    (True, False)
    """
    low, high = ends(values)
    if low is -oo or high is oo or (low.is_number and high.is_number):
        return True
    if not isinstance(values, Integers) or not (is_whole_form(low) and is_whole_form(high)):
        return False  # between 0 and n - 1/2 there is no whole number for n = 0, and n > 0 needs a proof
    return least(high - low, region_of(known)[1]) >= 0
