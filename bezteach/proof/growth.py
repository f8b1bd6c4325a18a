"""Inequalities by induction on n: a step multiplies one side by a known factor, and the other is held against it."""

from sympy import PolynomialError, cancel, expand, factor

from bezteach.symbolic import Step

from .factors import DEEPEST, one_term, signed
from .normal import Edge
from .polynomial_signs import is_rational
from .sign_of import signs
from .sign_sets import NOT_NEGATIVE, POSITIVE
from .terms import Failure, common_part


def by_induction(claim):
    """On a symbol that is in no other range, where one side is a single term f with f(n + 1) = q f(n)."""
    for n in sorted(claim.region.whole, key=str):
        about = [condition for condition in claim.region.conditions if condition.has(n)]
        start = expand(n - about[0]) if len(about) == 1 else None
        if start is not None and start.is_Integer:
            for term, other, sense in ((claim.large, claim.small, 1), (claim.small, claim.large, -1)):
                try:
                    yield from list(_induction(claim, n, start, term, other, sense))
                    return
                except (Failure, Edge, PolynomialError):
                    continue
    raise Failure("no induction")


def _induction(claim, n, start, term, other, sense):
    region, following = claim.region, {n: n + 1}
    _, (now, after) = common_part([one_term(part, region) for part in (term, term.subs(following))])
    ratio = factor(cancel(after / now))
    if signs(now, region) != POSITIVE or not signs(ratio, region) <= claim.wanted:
        raise Failure("the factor of a step may be negative")
    first = (claim.large - claim.small).subs(n, start)
    conditions = tuple(condition for condition in region.conditions if not condition.has(n))
    base = region._replace(whole=region.whole - {n}, conditions=conditions)
    yield Step(first, f"the larger side minus the smaller one for {n} = {start}")
    yield from signed(first, base, claim.wanted, DEEPEST, claim.budget)
    yield Step(ratio, f"what takes {term} from {n} to {n} + 1, and it is not negative", term.subs(following) / term)
    gap = sense * expand(ratio * other - other.subs(following))
    yield Step(gap, f"what is left from {n} to {n} + 1, for the other side times the same factor")
    yield from signed(factor(gap) if is_rational(gap) else gap, region, NOT_NEGATIVE, DEEPEST, claim.budget)
