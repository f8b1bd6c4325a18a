"""An inequality for every n as the methods take it: a smaller side, a larger side, and the region of its symbols.

The region holds what the ranges say of the symbols; both sides are of kinds that have a sign, and defined in it.
"""

from typing import NamedTuple

from sympy import (
    Add,
    Derivative,
    Dummy,
    Expr,
    Integer,
    Integral,
    Interval,
    Mul,
    Pow,
    Rational,
    Sum,
    Symbol,
    binomial,
    factorial,
    nan,
    oo,
    zoo,
)

from bezteach.symbolic import B

from ..budget import Budget
from ..indices import rebuilt, renamed
from ..ranges import Integers, ends
from ..terms.defined import check_defined
from ..terms.linear import impossible, is_whole_form
from ..terms.terms import Failure
from .sign_of import Region
from .sign_sets import NOT_NEGATIVE, POSITIVE

LONGEST = 40  # terms or degree of what is written out
BINDERS = Sum | Integral | Derivative


class Claim(NamedTuple):
    """small <= large, or small < large, in a region."""

    small: Expr
    large: Expr
    strict: bool
    region: Region
    budget: Budget

    @property
    def wanted(self):
        return POSITIVE if self.strict else NOT_NEGATIVE


def claim_of(statement, budget):
    """The ``Claim`` that a statement with <, <=, > or >= makes; ``Failure`` where something in it has no sign here."""
    small, large = (statement.lhs, statement.rhs) if "<" in statement.relation else (statement.rhs, statement.lhs)
    region = _region(statement.ranges)
    small, large = (_with_free_indices(side, frozenset(statement.ranges)) for side in (small, large))
    for side in (small, large):
        _check_known(side, region.whole, region.reals.keys())
        check_defined(side, region.conditions)
    return Claim(_written_out(small), _written_out(large), "=" not in statement.relation, region, budget)


def _region(ranges):
    """Ends that are not rational numbers are left out: what holds on more holds there too."""
    conditions, reals = [], {}
    for symbol, found in ranges.items():
        low, high = ends(found)
        for end in (low, high):
            if end not in (oo, -oo):
                _check_known(end, {s for s, other in ranges.items() if isinstance(other, Integers)}, ranges.keys())
                check_defined(end, conditions)
        if isinstance(found, Integers):
            conditions += [symbol - low] if low != -oo else []
            conditions += [high - symbol] if high != oo else []
        else:
            low, high = low if low.is_Rational else -oo, high if high.is_Rational else oo
            reals[symbol] = Interval(low, high, found.left_open, found.right_open)
    if impossible(conditions):
        raise Failure("the ranges are empty")
    return Region(frozenset(ranges) - reals.keys(), tuple(conditions), reals)


def _with_free_indices(expr, taken):
    """No variable of a sum or integral is one that has a range, so that none inherits what is known of another."""
    if not expr.has(Sum, Integral):
        return expr
    if not isinstance(expr, Sum | Integral):
        return rebuilt(expr, [_with_free_indices(part, taken) for part in expr.args])
    function, inner, limits = expr.function, list(expr.limits), []
    while inner:
        variable, *ends = inner.pop()
        if variable in taken:
            letter = Dummy(variable.name, integer=variable.is_integer, real=True)
            function = renamed(function, {variable: letter})
            inner, variable = [renamed(part, {variable: letter}) for part in inner], letter
        taken |= {variable}
        limits.insert(0, (variable, *ends))
    return expr.func(_with_free_indices(function, taken), *limits)


def _check_known(expr, whole, reals):
    """What ``sign_of`` is about: ``Failure`` for any other function, and where an integer form must stand."""
    if not isinstance(
        expr, Rational | Symbol | Add | Mul | Pow | B | binomial | factorial | Sum | Integral | Derivative
    ):
        raise Failure(f"{expr} is of a kind that has no sign here")
    forms = {B: expr.args[:2], binomial: expr.args, factorial: expr.args, Pow: expr.args[1:]}.get(expr.func, ())
    if isinstance(expr, Sum):
        for index, *limits in expr.limits[::-1]:
            forms, whole = (*forms, *limits), whole | {index}
    for form in forms:
        if not is_whole_form(form) or not form.free_symbols <= whole:
            raise Failure(f"{form} in {expr} is no linear form of integers")
    if isinstance(expr, Integral | Derivative):
        reals = reals | {
            variable for variable, *_ in (*getattr(expr, "limits", ()), *getattr(expr, "variable_count", ()))
        }
    elif expr.is_Symbol and expr not in whole | reals:
        raise Failure(f"{expr} has no range")
    for part in expr.args[:1] if isinstance(expr, BINDERS) else expr.args:
        _check_known(part, whole, reals)


def _written_out(expr):
    """Sums of a few terms and basis functions of numbers as polynomials."""

    def short(part):
        (_, low, high), *more = part.limits if isinstance(part, Sum) else [(None, oo, oo)]
        return not more and low.is_Integer and high.is_Integer and high - low < LONGEST

    def terms(part):
        ((index, low, high),) = part.limits
        return Add(*[part.function.subs(index, Integer(place)) for place in range(int(low), int(high) + 1)])

    def small(part):
        return isinstance(part, B) and all(form.is_Integer for form in part.args[:2]) and 0 <= part.args[1] < LONGEST

    return expr.replace(short, terms).replace(small, lambda part: part.doit(deep=False))


def difference_of(claim):
    difference = claim.large - claim.small
    if difference.has(nan, zoo, oo):
        raise Failure("something is not defined")
    return difference


def is_whole(expr, region):
    """Whether all values are whole numbers."""
    if isinstance(expr, Add | Mul):
        return all(is_whole(part, region) for part in expr.args)
    if isinstance(expr, Pow):
        return is_whole(expr.base, region) and region.holds(expr.exp)
    return isinstance(expr, Integer | binomial | factorial) or expr in region.whole
