"""Sums over an index with symbolic limits, as terms: the summands are brought to one form, joined and closed.

A range is cut where a factor of what is summed is 0 beyond, and where it has another form at an end, the few terms
there are written out. A double sum over a triangle that does not close in one order is tried in the other.
"""

from sympy import Add, KroneckerDelta, Mul, S, Sum, expand

from bezteach.symbolic import B

from .edges import Edge, need, never, one_of
from .exchange import exchanged
from .linear import coefficients
from .normal import normal
from .summation import FEW, closed_term
from .terms import Failure, joined


def closed(expr, whole, conditions, turned=False):
    """The terms of a Sum where the conditions hold; one over several indices is closed from the inside.

    >>> from bezteach.symbolic import i, n, t
    >>> closed(Sum(B(i, n, t), (i, 0, n)), frozenset([n]), [n])
    [Term(coefficient=1, factorials={}, powers={})]
    """
    *inner, (k, low, high) = expr.limits
    function = Sum(expr.function, *inner) if inner else expr.function
    if never(high - low, conditions):
        return []
    need(high - low, conditions, vanishing=True)
    try:
        return _closed(function, k, low, high, whole, conditions)
    except Failure:
        other = None if turned else exchanged(function, (k, low, high), conditions)
        if other is None:
            raise
    return closed(other, whole, conditions, turned=True)


def _closed(function, k, low, high, whole, conditions):
    length = expand(high - low)
    if length.is_Integer and length < FEW:
        values = [low + step for step in range(int(length) + 1)]
        return _written_out(function, k, values, whole, conditions, len(values))
    results, by_range = [], {}
    parts = Add.make_args(expand(function, power_exp=False, power_base=False, log=False, basic=False))
    for part in parts:
        with one_of(len(parts)):
            ends, terms, rest = _in_one_form(part, k, low, high, whole, conditions)
        results += ends
        by_range.setdefault(rest, []).extend(terms)
    for (first, last), terms in by_range.items():
        results += [result for term in joined(terms) for result in closed_term(term, k, first, last, conditions)]
    return results


def _written_out(function, k, values, whole, conditions, count):
    """The terms of the summands at these values of k, which are all or some of so many."""
    terms = []
    for value in values:
        with one_of(count):
            terms += normal(function.subs(k, value), whole, conditions)
    return terms


def _in_one_form(part, k, low, high, whole, conditions):
    """The terms at an end where a product has another form; those it has over the rest of the range; that rest."""
    picked = _picked(part, k)
    if picked is not None:
        return _at_one_value(*picked, low, high, whole, conditions), [], (low, high)
    ends = []
    while True:
        if never(high - low, conditions):
            return ends, [], (low, high)
        need(high - low, conditions, vanishing=not ends)
        try:
            return ends, normal(part, whole | {k}, [*conditions, k - low, high - k]), (low, high)
        except Edge as edge:
            slope = (coefficients(edge.form) or {}).get(k, S.Zero)
            if slope == 0:
                raise Edge(edge.form, edge.vanishing and not ends) from None
            beyond, rest = _cut(edge.form, k, slope, low, high, conditions)
            if not edge.vanishing:
                values = _values(*beyond, low, high, conditions)
                ends += _written_out(part, k, values, whole, conditions, len(values) + 1)
            low, high = rest


def _cut(form, k, slope, low, high, conditions):
    """The range of k where a form is negative, and the range where it is not; one of them is at each end."""
    if slope not in (1, -1):
        raise Failure(f"{form} holds a multiple of {k}")
    end = expand(k - slope * form)
    beyond, rest = ((low, end - 1), (end, high)) if slope == 1 else ((end + 1, high), (low, end))
    need(beyond[1] - beyond[0] + 1, conditions)
    return beyond, rest


def _values(first, last, low, high, conditions):
    """The values from first to last, if they are few and lie in the range."""
    length = expand(last - first)
    if not length.is_Integer or length > FEW:
        raise Failure(f"from {first} to {last} what is summed has another form")
    need(last - first, conditions)
    need(first - low, conditions)
    need(high - last, conditions)
    return [expand(first + step) for step in range(int(length) + 1)]


def _picked(part, k):
    """The product without a factor that is 0 for all k but one, at this k; and this k. None without such a factor."""
    factors = Mul.make_args(part)
    for place, factor in enumerate(factors):
        form = _zero_at(factor)
        slope = (coefficients(form) or {}).get(k, S.Zero)
        if slope in (1, -1):
            value = expand(k - slope * form)
            return Mul(*factors[:place], *factors[place + 1 :]).subs(k, value), value
    return None


def _zero_at(factor):
    """The form for which a factor is 1 where the form is 0, and 0 elsewhere; 0 if it is no such factor."""
    if isinstance(factor, KroneckerDelta) and len(factor.args) == 2:
        return expand(factor.args[0] - factor.args[1])
    if isinstance(factor, B) and expand(factor.args[2]) in (0, 1):
        i, n, x = factor.args
        return expand(i if expand(x) == 0 else n - i)
    return S.Zero


def _at_one_value(rest, value, low, high, whole, conditions):
    for form in (value - low, high - value):
        if never(form, conditions):
            return []
        need(form, conditions, vanishing=True)
    return normal(rest, whole, conditions)
