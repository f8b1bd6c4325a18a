"""Inequalities from bounds of the parts of both sides, and of a part of a sum by the whole."""

from sympy import Dummy, Ge, Gt, Interval, Le, Lt, S, Sum, binomial, factorial, oo

from bezteach.symbolic import B, Step, k, n, t

from ..certificate import ByBounds, ByPartOfSum, Lemma
from ..equations.algebra import by_algebra
from ..statement import statement as stated
from ..terms.linear import coefficients
from ..terms.terms import Failure
from .factors import against_zero, why
from .inequality import BINDERS, difference_of, is_whole
from .sign_of import signs, unbound
from .sign_sets import NOT_NEGATIVE, POSITIVE


def by_bounds(claim):
    """The ``ByBounds`` of a claim, or ``Failure``: each part between its bounds is enough for the whole."""
    bounds = tuple((part, *bounds_of(part, claim.region)) for part in outermost(difference_of(claim)))
    check_enough(claim, bounds)
    return ByBounds(bounds, _unity(claim.budget) if any(part.has(B) for part, *_ in bounds) else None)


def check_enough(claim, bounds):
    """Put for each B, power, binomial coefficient and factorial a letter that ranges between its bounds."""
    difference, reals, letters = difference_of(claim), dict(claim.region.reals), {}
    if not claim.strict and is_whole(difference, claim.region):
        difference += S.Half  # a whole number is >= 0 if it is > -1
    for part, interval, _ in bounds:
        letters[part] = Dummy(f"x_{len(letters)}", real=True)
        reals[letters[part]] = interval
    if not signs(difference.xreplace(letters), claim.region._replace(reals=reals)) <= claim.wanted:
        raise Failure("the bounds are not enough")


def bounds_shown(claim, certificate):
    """The lines for a reader."""
    if certificate.unity is not None:
        found, proof = certificate.unity
        yield Step(S.One, f"by the {proof.method}, for every degree and argument", found.lhs)
    for bound in certificate.bounds:
        yield from _between(*bound)
    relation = Gt if claim.strict else Ge
    yield Step(relation(claim.large - claim.small, 0, evaluate=False), "it holds for all values within these bounds")


def outermost(expr):
    """The parts for which letters stand."""
    if isinstance(expr, B | binomial | factorial | BINDERS) or (expr.is_Pow and not expr.exp.is_Integer):
        return [expr]
    return list(dict.fromkeys(part for each in expr.args for part in outermost(each)))


def bounds_of(expr, region):
    """The interval in which a part lies, and why."""
    found = signs(expr, region)
    if isinstance(expr, binomial | factorial) and found <= NOT_NEGATIVE:
        return Interval(int(found == POSITIVE), oo), "a whole number"
    if expr.is_Pow:
        base, exponent = expr.as_base_exp()
        if signs(base, region) | signs(1 - base, region) <= NOT_NEGATIVE and region.holds(exponent):
            below = signs(1 - base, region) == POSITIVE and region.holds(exponent - 1)
            return Interval(0, 1, found == POSITIVE, below), f"a power of {base}, which lies between 0 and 1"
    if isinstance(expr, B) and _is_share(*expr.args[1:], region):
        reason = "one term of the sum of all, which is 1, and none of them is negative"
        return Interval(0, 1, found == POSITIVE, _is_below_one(*expr.args, region)), reason
    if isinstance(expr, Sum) and isinstance(expr.function, B) and len(expr.limits) == 1:
        (index, n, x), k = expr.function.args, expr.limits[0][0]
        slope = (coefficients(index) or {}).get(k)  # k - (k - i) is i, whatever SymPy reads off before it expands
        if k not in n.free_symbols | x.free_symbols and slope in (1, -1) and _is_share(n, x, region):
            reason = "a part of the sum of all, which is 1, and none of them is negative"
            return Interval(0, 1, found == POSITIVE), reason
    low, high = (-oo if -1 in found else S.Zero), (oo if 1 in found else S.Zero)
    if low == high:
        raise Failure(f"{expr} is 0")
    return Interval(low, high, 0 not in found, 0 not in found), "its sign"


def _is_share(n, x, region):
    return signs(x, region) | signs(1 - x, region) <= NOT_NEGATIVE and region.holds(n)


def _is_below_one(i, n, x, region):
    """B is 1 only where it is the only one that is not 0: of degree 0, at 0 for i = 0, at 1 for i = n."""
    at_zero = signs(x, region) == POSITIVE or region.holds(i - 1)
    at_one = signs(1 - x, region) == POSITIVE or region.holds(n - i - 1)
    return region.holds(n - 1) and at_zero and at_one


def _between(part, interval, reason):
    low, high = Gt if interval.left_open else Ge, Lt if interval.right_open else Le
    if interval.start != -oo:
        yield Step(low(part, interval.start, evaluate=False), reason)
    if interval.end != oo:
        yield Step(high(part, interval.end, evaluate=False), reason)


def unity():
    """That the basis functions of a degree sum to 1."""
    return stated(Sum(B(k, n, t), (k, 0, n)), S.One)


def _unity(budget):
    proof = by_algebra(unity(), budget)
    if proof is None:
        raise Failure("the sum of all is not known")
    return Lemma(unity(), proof)


def by_part_of_sum(claim):
    """A term of a sum, or a stretch of it, is at most the whole if none of the terms is negative."""
    small, large = claim.small, claim.large
    if not isinstance(large, Sum) or len(large.limits) != 1:
        raise Failure("no sum on the larger side")
    ((k, low, high),) = large.limits
    stretches = [(place, place) for place in (*claim.region.whole, low, high)]
    stretches += [small.limits[0][1:]] if isinstance(small, Sum) else []
    for first, last in stretches:
        try:
            check_stretch(claim, first, last)
            return ByPartOfSum(first, last)
        except Failure:
            continue
    raise Failure("no part of the sum")


def check_stretch(claim, first, last):
    """``Failure`` unless no term of the larger side is negative, and the smaller one is those from first to last."""
    small, large, region = claim.small, claim.large, claim.region
    if claim.strict or not isinstance(large, Sum) or len(large.limits) != 1:
        raise Failure("no sum on the larger side")
    ((k, low, high),) = large.limits
    if not signs(*unbound(large, region)) <= NOT_NEGATIVE:
        raise Failure("a term may be negative")
    if isinstance(small, Sum) and len(small.limits) == 1 and small.limits[0][1:] == (first, last):
        same = small.function.subs(small.limits[0][0], k) == large.function
    else:
        same = first == last and large.function.subs(k, first) == small
    if not same or not region.holds(first - low) or not region.holds(high - last):
        raise Failure("no part of the sum")


def part_of_sum_shown(claim, certificate):
    """The lines for a reader."""
    body, inside = unbound(claim.large, claim.region)
    first, last = certificate
    yield Step(against_zero(claim.large.function, signs(body, inside)), why(body, inside))
    words = f"a part of the sum: {claim.large.limits[0][0]} from {first} to {last}"
    yield Step(Le(claim.small, claim.large, evaluate=False), words)
