"""Replay of inequalities by the signs of factors: in each case the factors make the expression, and have the signs."""

from sympy import Mul

from ..errors import ReplayFailed
from ..inequalities.factors import factors_shown, in_part_of
from ..inequalities.inequality import claim_of, difference_of, is_whole
from ..inequalities.sign_of import of_power, signs
from ..inequalities.sign_sets import POSITIVE, product
from ..terms.linear import impossible
from ..terms.normal import Edge, normal
from ..terms.terms import Failure, written
from .alike import alike
from .cover import check_covered, forms_of
from .grid import Grid, sign_at
from .rational import check_zero, quotient
from .terms import check_shared, remaining, words


def claim_again(statement, grid):
    """The claim of an inequality, from the statement."""
    if statement.relation == "=":
        raise ReplayFailed("an equation is not proved by signs")
    try:
        return claim_of(statement, grid.budget)
    except Failure as error:
        raise ReplayFailed(str(error)) from None


def replay_signs(statement, certificate, replay_proof):
    """Check the cases of a certificate ``BySigns``, and return the steps that show it."""
    grid = Grid(statement.ranges)
    claim = claim_again(statement, grid)
    difference, plus = difference_of(claim), certificate.plus
    if plus not in (0, 1) or (plus and (claim.strict or not is_whole(difference, claim.region))):
        raise ReplayFailed(f"{difference} may not be held against -{plus}")
    check_signs(difference + plus, claim.region, POSITIVE if plus else claim.wanted, certificate.cases, grid)
    return tuple(factors_shown(claim, certificate))


def check_signs(expr, region, wanted, cases, grid, forms=()):
    """``ReplayFailed`` unless an expression has the signs wanted everywhere in a region; forms narrow the grid."""
    if impossible(region.conditions):
        raise ReplayFailed("the ranges hold no point")
    check_covered(region.conditions, [case.part for case in cases])
    for case in cases:
        remaining(case.part, region.whole)
        here, inside = in_part_of(expr, region, case.part)
        _check_factors(case, here, inside)
        found = product(*(recorded for _, recorded in case.factors))
        if not found <= wanted:
            raise ReplayFailed(f"the factors give the signs {sorted(found)} in the case {words(case.part)}")
        _check_values(case, here, grid, [*forms, *forms_of(case.part)], found)


def _check_factors(case, expr, region):
    """The factors make the expression, and each has no sign but the recorded ones."""
    part, shared, factors = case
    if shared is None:
        if len(factors) != 1 or not alike(factors[0][0], expr):
            raise ReplayFailed(f"the sign of {expr} is not among those recorded")
        again = [signs(expr, region)]
    else:
        (rest, _), *powers = factors
        _check_product(expr, region, shared, rest, part)
        if [power for power, _ in powers] != [base**exponent for base, exponent in shared.powers.items()]:
            raise ReplayFailed(f"the powers recorded are not those of {written(shared)}")
        again = [signs(rest, region), *(of_power(*power, region) for power in shared.powers.items())]
    for (factor, recorded), found in zip(factors, again, strict=True):
        if not found <= recorded:
            raise ReplayFailed(f"{factor} may have the signs {sorted(found)}, and recorded is {sorted(recorded)}")


def _check_product(expr, region, shared, rest, part):
    """Shared part times rest is what the kernel makes of the expression in this case."""
    try:
        terms = normal(expr, region.whole, list(region.conditions))
    except (Edge, Failure) as error:
        raise ReplayFailed(f"the case {words(part)} needs another one beside it: {error}") from None
    if shared.coefficient != 1:
        raise ReplayFailed("the shared part has a factor of unknown sign")
    check_shared(shared, region.conditions, region.reals)
    rests = [quotient(term, shared) for term in terms]
    if None in rests:
        raise ReplayFailed(f"{written(shared)} is not shared by all terms")
    check_zero([*rests, -rest], f"the rest beside {written(shared)} in the case {words(part)}")


def _check_values(case, expr, grid, forms, found):
    """On the grid each factor has a recorded sign, and so has the expression, which is their product."""
    points = grid.points(forms)
    for factor, recorded in [*case.factors, (expr, found)]:
        value = grid.evaluator(factor)
        for point in points:
            sign = sign_at(value(point))
            if sign is not None and sign not in recorded:
                raise ReplayFailed(
                    f"{factor} has the sign {sign} at {grid.words(point)}, not one of {sorted(recorded)}"
                )
    if case.shared is not None:
        grid.check_equal(expr, Mul(written(case.shared), case.factors[0][0]), points, f"the factors of {expr}")
