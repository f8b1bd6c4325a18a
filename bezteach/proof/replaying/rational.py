"""Rational functions over QQ by polynomial arithmetic alone, and where what stands below them is not 0."""

from sympy import QQ, Add, Dummy, Integer, Mul, fraction, together
from sympy.polys.polyerrors import CoercionFailed

from ..errors import ReplayFailed
from ..terms.defined import check_defined
from ..terms.terms import Failure


def element(expr):
    """The element of a field of rational functions that an expression is; ``ReplayFailed`` if it is none.

    >>> from sympy.abc import x
    >>> element((x**2 - 1) / (x - 1)) == element(x + 1), element(x - x**2 / x)
    (True, 0)
    """
    letters = sorted(expr.free_symbols, key=str) or [Dummy()]
    try:
        return QQ.frac_field(*letters).from_sympy(_evaluated(expr))
    except (CoercionFailed, ValueError, ZeroDivisionError):
        raise ReplayFailed(f"{expr} is no rational function") from None


def _evaluated(expr):
    """The expression without what stands unevaluated in it, such as 1/(1/2): as a function it is the same."""
    return expr.func(*map(_evaluated, expr.args)) if expr.args else expr


def check_zero(parts, what):
    """``ReplayFailed`` unless the sum of these rational functions is 0."""
    total = Add(*parts, evaluate=False)
    if element(total) != 0:
        raise ReplayFailed(f"{what}: {total} is not 0")


def check_denominators(expr, conditions, ranges):
    """``ReplayFailed`` unless each factor below a rational function is known not to be 0 under the conditions."""
    _, below = fraction(together(expr))
    for factor in Mul.make_args(below.factor()):
        check_has_value(1 / factor, conditions, ranges)


def check_has_value(expr, conditions, ranges):
    """``ReplayFailed`` unless an expression is defined under the conditions, for all reals of the ranges."""
    try:
        check_defined(expr, conditions, ranges)
    except Failure as error:
        raise ReplayFailed(str(error)) from None


def quotient(term, shared):
    """The rational function that a term is beside the shared part; None if the quotient is not one.

    The forms of one family differ by numbers: what is left of their factorials is a product of linear factors.
    """
    result, families = term.coefficient / shared.coefficient, {}
    for sign, factorials in ((1, term.factorials), (-1, shared.factorials)):
        for form, exponent in factorials.items():
            constant, rest = form.as_coeff_Add()
            family = families.setdefault(rest, {})
            family[constant] = family.get(constant, 0) + sign * exponent
    for rest, family in families.items():
        lowest = min(family)
        if sum(family.values()) != 0 or not all((constant - lowest).is_Integer for constant in family):
            return None
        for constant, exponent in family.items():
            result *= Mul(*[rest + lowest + step for step in range(1, int(constant - lowest) + 1)]) ** exponent
    for base in {**term.powers, **shared.powers}:
        gap = (term.powers.get(base, Integer(0)) - shared.powers.get(base, Integer(0))).expand()
        if not gap.is_Integer:
            return None
        result *= base**gap
    return result
