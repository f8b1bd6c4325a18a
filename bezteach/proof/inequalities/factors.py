"""The sign of an expression from the signs of its factors, with a line for every part whose sign decides.

Beside the edges, where the terms have another form, an expression is one product of what its terms share.
"""

from sympy import Add, Eq, Ge, Gt, Integral, Le, Lt, Mul, Ne, Pow, Sum, binomial, expand, factor, factorial

from bezteach.symbolic import B, Step

from ..certificate import BySigns, Part, SignsCase
from ..terms.linear import coefficients, impossible, is_whole_form, least
from ..terms.normal import Edge, normal
from ..terms.size import cancelled, factored
from ..terms.terms import Failure, common_part, written
from .inequality import difference_of, is_whole
from .polynomial_signs import is_rational
from .sign_of import of_power, signs, unbound
from .sign_sets import ANY, POSITIVE, ZERO, product, total

DEEPEST, WIDEST = 6, 6  # edges of edges, cases on one edge


def by_factors(claim):
    """The ``BySigns`` of a claim, or ``Failure``."""
    difference = difference_of(claim)
    if not claim.strict and is_whole(difference, claim.region):
        found = signs(difference + 1, claim.region)
        if found <= POSITIVE:  # a whole number that is greater than -1
            return BySigns(1, (SignsCase(Part(), None, ((difference + 1, found),)),))
    return BySigns(0, signed(difference, claim.region, claim.wanted, claim.budget))


def factors_shown(claim, certificate):
    """The lines for a reader."""
    difference = difference_of(claim)
    yield Step(difference, "the larger side minus the smaller one")
    yield from cases_shown(difference + certificate.plus, claim.region, certificate.cases)
    if certificate.plus:
        yield Step(Ge(difference, 0, evaluate=False), "a whole number that is greater than -1")


def signed(expr, region, wanted, budget):
    """The cases to the sign of an expression; beside the edges, as one product of what its terms share."""
    return tuple(_cases(expr, region, wanted, DEEPEST, budget, Part()))


def _cases(expr, region, wanted, depth, budget, part):
    budget.spend()
    if impossible(region.conditions):
        return
    found = signs(expr, region)
    if found <= wanted:
        yield SignsCase(part, None, ((expr, found),))
        return
    try:
        terms = normal(expr, region.whole, list(region.conditions))
    except Edge as edge:
        yield from _beyond(edge.form, expr, region, wanted, depth, budget, part)
        yield from _cases(expr, region.where(edge.form), wanted, depth - 1, budget, part.also(edge.form))
        return
    shared, rests = common_part(terms)
    rest = factored(cancelled(Add(*rests)))
    factors = [(rest, signs(rest, region))]
    factors += [(Pow(*power), of_power(*power, region)) for power in shared.powers.items()]
    if not product(*(found for _, found in factors)) <= wanted:
        raise Failure("a factor may have either sign")
    yield SignsCase(part, shared, tuple(factors))


def cases_shown(expr, region, cases):
    """The lines for the signs of an expression in each case."""
    before = ()
    for case in cases:
        for place, (symbol, at) in enumerate(case.part.values):
            if case.part.values[: place + 1] != before[: place + 1]:
                yield Step(at, "this edge apart: the terms have another form", symbol)
        before = case.part.values
        yield from _case_shown(case, *in_part_of(expr, region, case.part))


def in_part_of(expr, region, part):
    """An expression and the region, in a part of it."""
    conditions, whole = region.conditions, region.whole
    for symbol, at in part.values:
        expr, whole = expr.subs(symbol, at), whole - {symbol}
        conditions = tuple(expand(condition.subs(symbol, at)) for condition in conditions)
    return expr, region._replace(whole=whole, conditions=conditions).where(*part.where)


def _case_shown(case, expr, region):
    _, shared, factors = case
    if shared is None:
        yield from _reasons(expr, region)
        return
    (rest, _), *powers = factors
    found = product(*(found for _, found in factors))
    yield Step(Mul(written(shared), rest), "what the terms share stands in front")
    for part in (*Mul.make_args(rest), *(power for power, _ in powers)):
        if not part.is_number or found == ZERO:
            yield from _reasons(part, region)


def _beyond(form, expr, region, wanted, depth, budget, part):
    """The cases form = -1, -2, ..., each with one integer symbol less."""
    low, found = least(form, region.conditions), coefficients(form)
    symbol = max((s for s in region.whole if abs(found.get(s, 0)) == 1), key=str, default=None)
    if depth == 0 or low < -WIDEST or symbol is None or not is_whole_form(form):
        raise Failure(f"too many cases where {form} is negative")
    for value in range(1, int(-low) + 1):
        at = expand(symbol - found[symbol] * (form + value))
        case, inside = in_part_of(expr, region, Part(((symbol, at),)))
        if not impossible(inside.conditions):
            yield from _cases(case, inside, wanted, depth - 1, budget, part.with_value(symbol, at))


def one_term(expr, region):
    terms = normal(expr, region.whole, list(region.conditions))
    if len(terms) != 1:
        raise Failure("more than one term")
    return terms[0]


def _reasons(expr, region):
    """A line for every part whose sign decides."""
    found = signs(expr, region)
    if expr.is_Mul or expr.is_Add:
        parts = [part for part in expr.args if not (expr.is_Mul and part.is_number)]
        if (product(*_each(expr.args, region)) if expr.is_Mul else total(_each(expr.args, region))) == found:
            for part in parts:
                yield from _reasons(part, region)
            return
    in_factors = factor(expr) if is_rational(expr) and expr.is_Add else expr
    if in_factors != expr and not in_factors.is_Add and signs(in_factors, region) == found:
        yield Step(Eq(expr, in_factors, evaluate=False), "factored")
        yield from _reasons(in_factors, region)
        return
    yield Step(against_zero(expr, found), "it may have any sign" if found == ANY else why(expr, region))


def _each(parts, region):
    return [signs(part, region) for part in parts]


def against_zero(expr, found):
    """The relation to 0 that a set of signs is; the expression itself where there is none."""
    relations = {(1,): Gt, (0, 1): Ge, (0,): Eq, (-1, 0): Le, (-1,): Lt, (-1, 1): Ne}
    relation = relations.get(tuple(sorted(found)))
    return expr if relation is None else relation(expr, 0, evaluate=False)


def why(expr, region):
    if expr.is_number:
        return "a number"
    if isinstance(expr, Sum | Integral):
        body, inside = unbound(expr, region)
        return f"{'every term' if isinstance(expr, Sum) else 'the integrand'} has this sign: {why(body, inside)}"
    if isinstance(expr, B):
        return f"a basis function where {expr.args[2]} lies between 0 and 1"
    if isinstance(expr, binomial | factorial):
        return "it counts something"
    if isinstance(expr, Pow):
        return f"a power of {expr.base}"
    reals = [symbol for symbol in sorted(expr.free_symbols, key=str) if symbol in region.reals]
    if not reals:
        return "by the ranges of the integers"
    if len(expr.free_symbols) == 1:
        return f"a polynomial in {reals[0]}, its roots in the interval counted exactly"
    return "a polynomial, by the signs of its factors and their Bernstein coefficients"
