"""Inequalities by induction on n: a step multiplies one side by a known factor, and the other is held against it."""

from sympy import PolynomialError, expand, factor

from bezteach.symbolic import Step

from ..certificate import ByGrowth
from ..terms.normal import Edge
from ..terms.size import cancelled, factored
from ..terms.terms import Failure, common_part
from .factors import cases_shown, one_term, signed
from .polynomial_signs import is_rational
from .sign_of import signs
from .sign_sets import NOT_NEGATIVE, POSITIVE


def by_induction(claim):
    """On a symbol that is in no other range, where one side is a single term f with f(n + 1) = q f(n)."""
    for n in sorted(claim.region.whole, key=str):
        for larger in (True, False):
            try:
                return _induction(claim, n, larger)
            except (Failure, Edge, PolynomialError):
                continue
    raise Failure("no induction")


def _induction(claim, n, larger):
    now, after = _one_step(claim, n, larger)
    ratio = factored(cancelled(after / now))
    check_ratio(claim, n, larger, ratio)
    (first, base), gap = first_of(claim, n), gap_of(claim, n, larger, ratio)
    return ByGrowth(
        n,
        start_of(claim, n),
        larger,
        ratio,
        signed(first, base, claim.wanted, claim.budget),
        signed(gap, claim.region, NOT_NEGATIVE, claim.budget),
    )


def start_of(claim, n):
    """The first value of n, a number; no other condition may hold n."""
    about = [condition for condition in claim.region.conditions if condition.has(n)]
    start = expand(n - about[0]) if len(about) == 1 else None
    if start is None or not start.is_Integer:
        raise Failure(f"no induction on {n}")
    return start


def _one_step(claim, n, larger):
    """The rational functions to which one side is proportional, for n and for n + 1."""
    term = claim.large if larger else claim.small
    _, rests = common_part([one_term(part, claim.region) for part in (term, term.subs(n, n + 1))])
    return rests


def check_ratio(claim, n, larger, ratio):
    """``Failure`` unless the ratio takes one side from n to n + 1, and has the sign that is wanted."""
    now, after = _one_step(claim, n, larger)
    if signs(now, claim.region) != POSITIVE or not signs(ratio, claim.region) <= claim.wanted:
        raise Failure("the factor of a step may be negative")
    if cancelled(ratio * now - after) != 0:
        raise Failure(f"{ratio} is not the factor of a step")


def first_of(claim, n):
    """The difference for the first n, and the region of the other symbols."""
    region = claim.region
    conditions = tuple(condition for condition in region.conditions if not condition.has(n))
    base = region._replace(whole=region.whole - {n}, conditions=conditions)
    return (claim.large - claim.small).subs(n, start_of(claim, n)), base


def gap_of(claim, n, larger, ratio):
    """By how much the other side, times the ratio, is on the right side of what it is for n + 1."""
    other, sense = (claim.small, 1) if larger else (claim.large, -1)
    gap = sense * expand(ratio * other - other.subs(n, n + 1))
    return factor(gap) if is_rational(gap) else gap


def growth_shown(claim, certificate):
    """The lines for a reader."""
    n, start, larger, ratio, first_cases, gap_cases = certificate
    term, other = (claim.large, claim.small) if larger else (claim.small, claim.large)
    first, base = first_of(claim, n)
    yield Step(first, f"the larger side minus the smaller one for {n} = {start}")
    yield from cases_shown(first, base, first_cases)
    yield Step(ratio, f"what takes {term} from {n} to {n} + 1, and it is not negative", term.subs(n, n + 1) / term)
    gap = (1 if larger else -1) * expand(ratio * other - other.subs(n, n + 1))
    yield Step(gap, f"what is left from {n} to {n} + 1, for the other side times the same factor")
    yield from cases_shown(gap_of(claim, n, larger, ratio), claim.region, gap_cases)
