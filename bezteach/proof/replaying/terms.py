"""Replay of an equation of terms: the cases cover the range, and in each the difference of both sides is 0.

The kernel rules run again in each case as it stands; they look for no further case. What they give is divided by the
recorded shared part, and the rest is compared with the recorded one, and with 0, as rational functions over QQ.
"""

from sympy import Add, Indexed, Mul, S, expand

from ..equations.algebra import difference_terms, in_part, prepared, steps_of
from ..errors import ReplayFailed
from ..regions import region_of
from ..terms.linear import impossible
from ..terms.normal import POINT, Edge
from ..terms.terms import Failure, written
from .cover import check_covered, forms_of
from .grid import Grid
from .rational import check_denominators, check_has_value, check_zero, quotient


def replay_terms(statement, certificate, replay_proof):
    """Check that the sides agree in each case, and return the steps that show it."""
    if statement.relation != "=":
        raise ReplayFailed(f"{statement} is no equation of terms")
    sides, (whole, conditions) = prepared(statement), region_of(statement.ranges)
    if impossible(conditions):
        raise ReplayFailed("the ranges hold no point")
    for side in sides:
        check_has_value(side, conditions, statement.ranges)
    check_covered(conditions, [case.part for case in certificate.cases])
    points = {point.base for side in sides for point in side.atoms(Indexed)}
    if len(points) > 1:
        raise ReplayFailed("there are points of two polygons")
    grid = Grid(statement.ranges)
    for case in certificate.cases:
        _check_case(case, sides, whole, conditions, statement.ranges)
        _check_values(case, sides, grid, {POINT: next(iter(points))[0]} if points else {})
    return tuple(steps_of(sides, certificate.cases))


def conditions_in(part, conditions):
    """The conditions on the symbols that are left in a part."""
    for symbol, at in part.values:
        conditions = [expand(condition.subs(symbol, at)) for condition in conditions]
    return [*conditions, *part.where]


def remaining(part, whole):
    """The integer symbols that are left in a part; each value is one of an integer symbol, in those left after it."""
    for symbol, at in part.values:
        if symbol not in whole or not at.free_symbols <= whole - {symbol}:
            raise ReplayFailed(f"{symbol} = {at} is no value of a case")
        whole = whole - {symbol}
    return whole


def _check_case(case, sides, whole, conditions, ranges):
    part, groups = case
    whole, inside = remaining(part, whole), conditions_in(part, conditions)
    try:
        terms = difference_terms(in_part(sides, part), whole, inside)
    except (Edge, Failure) as error:
        raise ReplayFailed(f"the case {words(part)} needs another one beside it: {error}") from None
    if any(term.coefficient.diff(POINT, 2) != 0 for term in terms):
        raise ReplayFailed("a product of points is not a matter of the operator")
    found = [[] for _ in groups]
    for term in terms:
        place, rest = _group_of(term, groups, part)
        found[place].append(rest)
    for (shared, rests), again in zip(groups, found, strict=True):
        check_shared(shared, inside, ranges)
        for rest in rests:
            check_denominators(rest, inside, ranges)
        check_zero(rests, f"the rest beside {written(shared)} in the case {words(part)}")
        check_zero([*again, *[-rest for rest in rests]], f"what is recorded beside {written(shared)}")


def _group_of(term, groups, part):
    for place, (shared, _) in enumerate(groups):
        rest = quotient(term, shared)
        if rest is not None:
            return place, rest
    raise ReplayFailed(f"no group holds the term {written(term)} in the case {words(part)}")


def check_shared(shared, conditions, ranges):
    """It must have a value: factorials of forms >= 0, powers with exponents >= 0 unless the base is never 0."""
    if shared.coefficient == 0:
        raise ReplayFailed("the shared part is 0")
    check_has_value(written(shared), conditions, ranges)


def _check_values(case, sides, grid, point):
    """On the grid the difference is what the groups are, each of them."""
    left, right = in_part(sides, case.part)
    groups = [Mul(written(shared), Add(*rests)).xreplace(point) for shared, rests in case.groups]
    points = grid.points(forms_of(case.part))
    grid.check_equal(left - right, S.Zero, points, f"the difference in the case {words(case.part)}")
    grid.check_equal(left - right, Add(*groups), points, f"the groups in the case {words(case.part)}")
    for shared, rests in case.groups:
        grid.check_equal(Add(*rests).xreplace(point), S.Zero, points, f"the rest beside {written(shared)}")


def words(part):
    """A part of the range in words."""
    parts = [f"{symbol} = {at}" for symbol, at in part.values] + [f"{form} >= 0" for form in part.where]
    return ", ".join(parts) or "of all values"
