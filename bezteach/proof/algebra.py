"""Equations for every n: both sides as hypergeometric terms, divided by what the terms share.

What is left is a rational function, and 0 or not. Where a binomial coefficient vanishes, or a sum is empty, the terms
have another form: these finitely many edges, such as i = 0, i = n or n = 0, are proved apart in the same way.
"""

from sympy import Add, Dummy, Indexed, Mul, S, Subs, Sum, cancel, expand, oo

from bezteach.symbolic import B, Step

from .defined import check_defined
from .linear import coefficients, least
from .normal import POINT, Edge, normal
from .ranges import Integers
from .terms import Failure, Term, common_part, times, written
from .verdict import PROVED, Proof

DEEPEST = 8  # edges of edges
WIDEST = 6  # cases on one edge


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
    sides = tuple(_with_ends_apart(with_fresh_indices(side)) for side in (statement.lhs, statement.rhs))
    if len({point.base for side in sides for point in side.atoms(Indexed)}) > 1:
        return None
    whole = frozenset(s for s, values in statement.ranges.items() if isinstance(values, Integers))
    conditions = []
    for symbol in whole:
        low, high = statement.ranges[symbol]
        conditions += [symbol - low] * (low != -oo) + [high - symbol] * (high != oo)
    if least(S.Zero, conditions) != 0:
        return None  # nothing is in the ranges, and nothing is said of it
    try:
        for side in sides:
            check_defined(side, conditions)
        steps = list(_proved(sides, whole, conditions, DEEPEST, budget))
    except Failure:
        return None
    method = "binomial theorem" if any(side.has(Sum) for side in sides) else "ratio of terms"
    return Proof(PROVED, method, tuple(steps))


def _with_ends_apart(expr):
    """B(i, n, 0) and B(i, n, 1) inside a sum as the values at a point of what is summed first."""
    for end in {function.args[2] for total in expr.atoms(Sum) for function in total.atoms(B)} & {S.Zero, S.One}:
        x = Dummy("x", real=True)
        moved = {f: B(*f.args[:2], x) for f in expr.atoms(B) if f.args[2] == end}
        expr = Subs(expr.xreplace(moved), x, end)
    return expr


def with_fresh_indices(expr):
    """Every index of a sum a symbol of its own, so that none is caught when a symbol outside is replaced."""
    if not expr.has(Sum):
        return expr
    expr = expr.func(*map(with_fresh_indices, expr.args)) if expr.args else expr
    if isinstance(expr, Sum):
        for index in expr.variables:
            expr = expr.xreplace({index: Dummy(index.name, integer=True)})
    return expr


def _proved(sides, whole, conditions, depth, budget):
    """The steps of a proof that the sides agree where the conditions hold; ``Failure`` if this way gives none."""
    budget.spend()
    if least(S.Zero, conditions) != 0:
        return
    left, right = sides
    try:
        terms = normal(left, whole, conditions)
        terms += [times(Term(S.NegativeOne), term) for term in normal(right, whole, conditions)]
    except Edge as edge:
        yield from _beyond(edge.form, sides, whole, conditions, depth, budget)
        yield from _proved(sides, whole, [*conditions, edge.form], depth - 1, budget)
        return
    if any(term.coefficient.diff(POINT, 2) != 0 for term in terms):
        raise Failure("a product of points is not a matter of the operator")
    yield Step(left - right, "the difference of both sides")
    for group in _alike(terms):
        shared, rests = common_part(group)
        if cancel(Add(*rests)) != 0:
            raise Failure("what is left is not 0")
        yield Step(
            Mul(written(shared), Add(*rests, evaluate=False), evaluate=False),
            "what the terms share stands in front; the rest is a rational function",
        )
    yield Step(S.Zero, "it is 0 for all values")


def _beyond(form, sides, whole, conditions, depth, budget):
    """The cases form = -1, -2, ..., each with one integer symbol less."""
    low = least(form, conditions)
    if depth == 0 or low < -WIDEST:
        raise Failure(f"too many cases where {form} is negative")
    found = coefficients(form)
    symbol = max((s for s in whole if abs(found.get(s, 0)) == 1), key=str, default=None)
    if symbol is None:
        raise Failure(f"{form} cannot be solved for a symbol")
    for value in range(1, int(-low) + 1):
        at = expand(symbol - found[symbol] * (form + value))
        inside = [expand(condition.subs(symbol, at)) for condition in conditions]
        if least(S.Zero, inside) != 0:
            continue
        case = tuple(side.subs(symbol, at) for side in sides)
        yield Step(at, "the edge apart, where the terms have another form", symbol)
        yield from _proved(case, whole - {symbol}, inside, depth - 1, budget)


def _alike(terms):
    """The terms in groups whose quotients are rational."""
    groups = []
    for term in terms:
        for group in groups:
            try:
                common_part([*group, term])
            except Failure:
                continue
            group.append(term)
            break
        else:
            groups.append([term])
    return groups
