"""Equations for every n: both sides as hypergeometric terms, divided by what the terms share.

What is left is a rational function, and 0 or not. Where a binomial coefficient vanishes, or a sum is empty, the terms
have another form: these finitely many edges, such as i = 0, i = n or n = 0, are proved apart in the same way.
"""

from sympy import Add, Dummy, Indexed, Mul, Pow, S, Subs, Sum, expand, oo

from bezteach.symbolic import B, Step

from ..certificate import ByTerms, Group, Part, TermsCase
from ..indices import renamed, with_fresh_indices
from ..regions import region_of
from ..terms.defined import check_defined
from ..terms.linear import coefficients, impossible, is_whole_form, least
from ..terms.normal import POINT, Edge, normal
from ..terms.size import cancelled
from ..terms.terms import Failure, Term, alike, common_part, times, written
from ..verdict import PROVED, Proof

DEEPEST = 8  # edges of edges
WIDEST = 6  # cases on one edge
HIGHEST = 400  # a power that is a number


def by_algebra(statement, budget):
    """A ``Proof`` of an equation for all values in its ranges, or None.

    >>> from bezteach.proof.budget import Budget
    >>> from bezteach.proof.statement import statement
    >>> from bezteach.symbolic import B, i, n, t
    >>> from sympy import Sum
    >>> by_algebra(statement(Sum(B(i, n, t), (i, 0, n)), 1), Budget(5)).status
    'PROVED'
    """
    if statement.relation != "=":
        return None
    sides = prepared(statement)
    if len({point.base for side in sides for point in side.atoms(Indexed)}) > 1:
        return None
    if any(power.exp.is_Integer and abs(power.exp) > HIGHEST for side in sides for power in side.atoms(Pow)):
        return None  # what is multiplied out, or cancelled, cannot be interrupted
    whole, conditions = region_of(statement.ranges)
    if impossible(conditions):
        return None  # nothing is in the ranges, and nothing is said of it
    try:
        for side in sides:
            check_defined(side, conditions, statement.ranges)
        cases = tuple(_proved(sides, whole, conditions, Part(), DEEPEST, budget))
    except Failure:
        return None
    method = "binomial theorem" if any(side.has(Sum) for side in sides) else "ratio of terms"
    return Proof(PROVED, method, tuple(steps_of(sides, cases)), certificate=ByTerms(cases))


def prepared(statement):
    """Both sides as this prover takes them: no index of a sum is one outside, or of another sum."""
    return tuple(_with_ends_apart(with_fresh_indices(side)) for side in (statement.lhs, statement.rhs))


def steps_of(sides, cases):
    """The lines that show the cases to a reader."""
    before, bases = (), {point.base for side in sides for point in side.atoms(Indexed)}
    first_point = {POINT: bases.pop()[0]} if bases else {}
    for part, groups in cases:
        for place, (symbol, at) in enumerate(part.values):
            if part.values[: place + 1] != before[: place + 1]:
                yield Step(at, "this edge apart: the terms have another form", symbol)
        before = part.values
        left, right = in_part(sides, part)
        yield Step(left - right, "the difference of both sides")
        for shared, rests in groups:
            left_over = Add(*[rest.xreplace(first_point) for rest in rests], evaluate=False)
            if (in_front := written(shared)) == 1:
                yield Step(left_over, "each term written out")
            else:
                yield Step(Mul(in_front, left_over, evaluate=False), "what the terms share, times what is left of each")
        yield Step(S.Zero, "it is 0 for all values")


def in_part(expressions, part):
    """The expressions with the values of a part put in."""
    for symbol, at in part.values:
        expressions = tuple(expr.subs(symbol, at) for expr in expressions)
    return expressions


def _with_ends_apart(expr):
    """B(i, n, 0) and B(i, n, 1) inside a sum as the values at a point of what is summed first."""
    for end in {function.args[2] for total in expr.atoms(Sum) for function in total.atoms(B)} & {S.Zero, S.One}:
        x = Dummy("x", real=True)
        moved = {f: B(*f.args[:2], x) for f in expr.atoms(B) if f.args[2] == end}
        expr = Subs(renamed(expr, moved), x, end)
    return expr


def _proved(sides, whole, conditions, part, depth, budget):
    """The cases of a proof that the sides agree in a part; ``Failure`` if this way gives none."""
    budget.spend()
    if impossible(conditions):
        return
    try:
        terms = difference_terms(sides, whole, conditions)
    except Edge as edge:
        yield from _beyond(edge.form, sides, whole, conditions, part, depth, budget)
        yield from _where(edge.form, sides, whole, conditions, part, depth, budget)
        return
    if any(term.coefficient.diff(POINT, 2) != 0 for term in terms):
        raise Failure("a product of points is not a matter of the operator")
    groups = []
    for group in alike(terms):
        shared, rests = common_part(group)
        if cancelled(Add(*rests)) != 0:
            raise Failure("what is left is not 0")
        groups.append(Group(shared, tuple(rests)))
    yield TermsCase(part, tuple(groups))


def difference_terms(sides, whole, conditions):
    """The terms of the left side and those of the right with the other sign; ``Edge`` where another case is needed."""
    left, right = sides
    terms = normal(left, whole, conditions)
    return terms + [times(Term(S.NegativeOne), term) for term in normal(right, whole, conditions)]


def _beyond(form, sides, whole, conditions, part, depth, budget):
    """The cases form = -1, -2, ..., each with one integer symbol less; all at once if there is no end to them."""
    low = least(form, conditions)
    if not is_whole_form(form):
        raise Failure(f"{form} is not known to be a whole number")  # it may lie between -1 and 0
    if depth == 0 or -oo < low < -WIDEST:
        raise Failure(f"too many cases where {form} is negative")
    if low == -oo:
        yield from _where(expand(-form - 1), sides, whole, conditions, part, depth, budget)
        return
    for value in range(1, int(-low) + 1):
        yield from _at(form, -value, sides, whole, conditions, part, depth, budget)


def _where(form, sides, whole, conditions, part, depth, budget):
    """The cases where form >= 0; if the conditions leave only 0, that value is put in."""
    inside = [*conditions, form]
    if least(-form, inside) == 0 and not impossible(inside):
        yield from _at(form, 0, sides, whole, conditions, part, depth, budget)
    else:
        yield from _proved(sides, whole, inside, part.also(form), depth - 1, budget)


def _at(form, value, sides, whole, conditions, part, depth, budget):
    """The cases where the form has a value, with one integer symbol less."""
    found = coefficients(form)
    symbol = max((s for s in whole if abs(found.get(s, 0)) == 1), key=str, default=None)
    if symbol is None:
        raise Failure(f"{form} cannot be solved for a symbol")
    at = expand(symbol - found[symbol] * (form - value))
    inside = [expand(condition.subs(symbol, at)) for condition in conditions]
    if not impossible(inside):
        case = tuple(side.subs(symbol, at) for side in sides)
        yield from _proved(case, whole - {symbol}, inside, part.with_value(symbol, at), depth - 1, budget)
