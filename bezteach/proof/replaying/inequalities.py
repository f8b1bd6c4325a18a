"""Replay of inequalities by bounds, by a part of a sum, by the peak, and by growth from n to n + 1."""

from fractions import Fraction

from sympy import Mul, PolynomialError, oo

from bezteach.symbolic import B

from ..errors import ReplayFailed
from ..exact.polynomial import to_sympy
from ..inequalities.bounds import (
    bounds_of,
    bounds_shown,
    check_enough,
    check_stretch,
    outermost,
    part_of_sum_shown,
    unity,
)
from ..inequalities.growth import check_ratio, first_of, gap_of, growth_shown, start_of
from ..inequalities.inequality import difference_of
from ..inequalities.peak import check_peak, peak_shown, sides_of
from ..inequalities.sign_sets import NOT_NEGATIVE
from ..terms.normal import Edge
from ..terms.terms import Failure
from .alike import alike
from .grid import Grid, sign_at
from .signs import check_signs, claim_again
from .telescoping import check_lemmas


def _kernel(rule, *args):
    """What a rule of the kernel says; its ``Failure`` is one of the replay."""
    try:
        return rule(*args)
    except (Failure, Edge, PolynomialError) as error:
        raise ReplayFailed(str(error)) from None


def replay_bounds(statement, certificate, replay_proof):
    """Each part lies within its bounds, by the rule and on the grid, and the bounds are enough."""
    grid = Grid(statement.ranges)
    claim = claim_again(statement, grid)
    parts = outermost(_kernel(difference_of, claim))
    if len(parts) != len(certificate.bounds) or not all(map(alike, parts, [bound[0] for bound in certificate.bounds])):
        raise ReplayFailed("the bounds are not those of the parts of the difference")
    bounds = [(part, *bound[1:]) for part, bound in zip(parts, certificate.bounds, strict=True)]
    for part, interval, reason in bounds:
        if _kernel(bounds_of, part, claim.region) != (interval, reason):
            raise ReplayFailed(f"{part} is not known to lie in {interval}")
        value = grid.evaluator(part)
        for point in grid.points():
            found = value(point)
            if isinstance(found, int | Fraction) and to_sympy(found) not in interval:
                raise ReplayFailed(f"{part} is {found} at {grid.words(point)}, outside {interval}")
    _kernel(check_enough, claim, bounds)
    needed = [unity()] if any(part.has(B) for part in parts) else []
    check_lemmas([certificate.unity] if certificate.unity else [], needed, replay_proof)
    return tuple(bounds_shown(claim, certificate))


def replay_part_of_sum(statement, certificate, replay_proof):
    """The smaller side is a stretch of the larger one, a sum without negative terms."""
    claim = claim_again(statement, Grid(statement.ranges))
    _kernel(check_stretch, claim, certificate.first, certificate.last)
    return tuple(part_of_sum_shown(claim, certificate))


def replay_peak(statement, certificate, replay_proof):
    """One side is a constant times the powers, which turn at the peak."""
    grid = Grid(statement.ranges)
    claim = claim_again(statement, grid)
    _kernel(check_peak, claim, certificate)
    t, powers, _ = certificate
    changing, _, _ = _kernel(sides_of, claim, t)
    interval = claim.region.reals[t]
    low = interval.start if interval.start != -oo else min(interval.end, 0) - 2
    high = interval.end if interval.end != oo else max(interval.start, 0) + 2
    one, other = low + (high - low) / 3, low + (high - low) / 4
    product = Mul(*[base**exponent for base, exponent in powers])
    crosswise = [changing.subs(t, a) * product.subs(t, b) for a, b in ((one, other), (other, one))]
    grid.check_equal(*crosswise, grid.points(), f"{changing} is not a constant times the powers")
    return tuple(peak_shown(claim, certificate))


def replay_growth(statement, certificate, replay_proof):
    """It holds for the first n, and the ratio and the gap of a step have the right signs."""
    grid = Grid(statement.ranges)
    claim = claim_again(statement, grid)
    n, start, larger, ratio, first_cases, gap_cases = certificate
    if n not in claim.region.whole or start != _kernel(start_of, claim, n) or larger not in (True, False):
        raise ReplayFailed(f"{n} = {start} is not the first case")
    _kernel(check_ratio, claim, n, larger, ratio)
    first, base = first_of(claim, n)
    check_signs(first, base, claim.wanted, first_cases, grid, [n - start, start - n])
    check_signs(gap_of(claim, n, larger, ratio), claim.region, NOT_NEGATIVE, gap_cases, grid)
    _check_ratio_values(claim.large if larger else claim.small, n, ratio, grid)
    return tuple(growth_shown(claim, certificate))


def _check_ratio_values(term, n, ratio, grid):
    points = grid.points()
    grid.check_equal(term.subs(n, n + 1), ratio * term, points, f"{ratio} is not the factor of a step")
    value = grid.evaluator(ratio)
    if any(sign_at(value(point)) == -1 for point in points):
        raise ReplayFailed(f"{ratio} is negative somewhere")
