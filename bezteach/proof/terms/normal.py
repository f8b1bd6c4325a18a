"""An expression as a sum of hypergeometric terms: basis functions written out, points as powers of E, sums closed.

The conditions are linear forms >= 0 in the integer symbols. Where a step needs another form to be >= 0 and the
conditions do not give it, ``Edge`` asks the caller to look at the finitely many other cases apart. Every part must
have a value where the conditions hold, which ``defined`` has to see to before.
"""

from sympy import (
    Add,
    Derivative,
    Indexed,
    Integral,
    KroneckerDelta,
    Mul,
    Pow,
    Subs,
    Sum,
    binomial,
    expand,
    factorial,
    fraction,
    together,
)

from bezteach.symbolic import B, E

from .atoms import ATOMS, POINT, one_at_zero
from .calculus_terms import at_point, derivative, integral
from .edges import Edge, need, never, one_of
from .linear import is_whole_form, least
from .size import MOST_TERMS, MOST_TO_FACTOR, check_size, most_terms
from .terms import Failure, Term, inverse, power_of, times

__all__ = ["POINT", "Edge", "need", "never", "normal"]

_TAKEN_APART = (Sum, Integral, Derivative, Subs, Indexed, B, KroneckerDelta)


def normal(expr, whole, conditions):
    """The terms whose sum an expression is where the conditions hold; ``whole`` holds its integer symbols."""
    if not expr.has(*_TAKEN_APART) and expr.is_polynomial(*expr.free_symbols):
        return [Term(expr)] if expr != 0 else []
    for kind, rule in _RULES.items():
        if isinstance(expr, kind):
            return rule(expr, whole, conditions)
    if expr.is_Symbol:
        return [Term(expr)]
    raise Failure(f"{expr} is no hypergeometric term")


def _total(expr, whole, conditions):
    if len(expr.args) > MOST_TERMS:
        raise Failure("a sum with too many terms")
    terms = []
    for part in expr.args:
        with one_of(len(expr.args)):
            terms += normal(part, whole, conditions)
    return terms


def _product(expr, whole, conditions):
    parts = [normal(part, whole, conditions) for part in expr.args]  # all of them: 0 times undefined is undefined
    if sum(any(term.coefficient.has(POINT) for term in part) for part in parts) > 1:
        raise Failure("a product of points is not a matter of the operator")
    terms = [Term()]
    for part in parts:
        terms = [times(one, other) for one in terms for other in part]
        if len(terms) > MOST_TERMS:
            raise Failure("a product with too many terms")
    return terms


def _plain(expr, whole):
    """Whether an expression is a polynomial that holds no integer symbol and nothing that has to be taken apart."""
    return _holds_none(expr, whole) and expr.is_polynomial(*expr.free_symbols)


def _holds_none(expr, whole):
    return not expr.free_symbols & whole and not expr.has(*_TAKEN_APART)


def _power(expr, whole, conditions):
    """A power of a polynomial without integer symbols may have any exponent: it has a value, as all parts have."""
    base, exponent = expr.as_base_exp()
    if not is_whole_form(exponent):  # i * n, where a power of a power was taken
        raise Failure(f"the exponent of {expr} is no linear form")
    if exponent == 0:
        return [Term()]
    if _plain(base, whole):
        if expand(base) == 0:
            return one_at_zero(exponent, conditions)
        in_front = exponent.is_Integer and base != E and not base.is_number
        return [Term(expr) if in_front else power_of(base, exponent)]
    if (base.is_Mul or base.is_Pow) and not base.has(Indexed):
        factors = [factor.as_base_exp() for factor in Mul.make_args(base)]
        return normal(Mul(*[Pow(inner, power * exponent) for inner, power in factors]), whole, conditions)
    if base.is_Add and _is_small_quotient(base, whole):
        check_size(base)
        above, below = fraction(together(base))
        if max(map(most_terms, (above, below))) > MOST_TO_FACTOR:
            raise Failure("a quotient with too many terms")
        if below != 1:
            return _power(Pow(above / below, exponent, evaluate=False), whole, conditions)
    if not exponent.is_Integer:
        raise Failure(f"the base of {expr} holds an integer symbol")
    if exponent > 0:
        return normal(expand(expr), whole, conditions) if base.is_Add else _repeated(base, exponent, whole, conditions)
    return [_reciprocal(base, -exponent, whole, conditions)]


def _is_small_quotient(base, whole):
    return len(base.args) <= MOST_TERMS and _holds_none(base, whole) and base.is_rational_function(*base.free_symbols)


def _repeated(base, exponent, whole, conditions):
    if base.is_Symbol:
        return [Term(base**exponent)]
    if exponent > 1 and base.has(Indexed):
        raise Failure("a product of points is not a matter of the operator")
    terms = [Term()]
    for _ in range(exponent):
        terms = [times(one, other) for one in terms for other in normal(base, whole, conditions)]
        if len(terms) > MOST_TERMS:
            raise Failure("a power with too many terms")
    return terms


def _reciprocal(base, exponent, whole, conditions):
    """One over a linear form that is never 0, or over one term."""
    if isinstance(base, binomial | factorial | B):
        (term,) = normal(base, whole, conditions) or (None,)
        if term is None:
            raise Failure(f"{base} is 0 somewhere, and something is divided by it")
        result = Term()
        for _ in range(exponent):
            result = times(result, inverse(term))
        return result
    if least(base - 1, conditions) >= 0 or least(-base - 1, conditions) >= 0:
        return Term(base**-exponent)
    raise Failure(f"{base} may be 0, and something is divided by it")


def _in_reals(function, variables, whole, conditions):
    """The terms of what a derivative or an integral is taken of, in variables that are no integer symbols."""
    if not whole.isdisjoint(variables):
        raise Failure(f"one of {variables} is an integer")
    if E in variables and function.has(Indexed):
        raise Failure("a point is a letter beside the operator, and no power of it")
    return normal(function, whole, conditions)


def _derivative(expr, whole, conditions):
    terms = _in_reals(expr.expr, [variable for variable, _ in expr.variable_count], whole, conditions)
    for variable, count in expr.variable_count:
        terms = derivative(terms, variable, count, conditions)
    return terms


def _at_point(expr, whole, conditions):
    if len(expr.variables) != 1 or expr.point[0].free_symbols & whole:
        raise Failure(f"{expr} is not at one real value")
    if expr.point[0].has(Indexed):
        raise Failure(f"{expr} is at a point, which is no value")
    terms = _in_reals(expr.expr, expr.variables, whole, conditions)
    return at_point(terms, expr.variables[0], expr.point[0], conditions)


def _integral(expr, whole, conditions):
    if any(limits != [0, 1] for _, *limits in expr.limits):
        raise Failure(f"the limits of {expr} are not 0 and 1")
    terms = _in_reals(expr.function, expr.variables, whole, conditions)
    for variable in expr.variables:
        terms = integral(terms, variable, conditions)
    return terms


def _sum(expr, whole, conditions):
    from .closing import closed

    return closed(expr, whole, conditions)


_RULES = {
    Add: _total,
    Mul: _product,
    **ATOMS,
    Pow: _power,
    Derivative: _derivative,
    Integral: _integral,
    Sum: _sum,
    Subs: _at_point,
}
