"""What has to be proved if p S(n + 1) - q S(n) telescopes, where S(n) is a sum over k that shall be R(n).

With p F(n+1, k) - q F(n, k) = G(n, k+1) - G(n, k) for every k of the sum but the last, p S(n+1) - q S(n) is what G is
at both ends, the last term, and what the sum gains or loses from n to n + 1. If that is 0, if p R(n+1) = q R(n), if p
is never 0 and if S = R at the first n, then S = R for every n. Each of these is a statement of its own.
"""

from typing import NamedTuple

from sympy import Add, Eq, Expr, Function, Mul, S, Sum, Symbol, binomial, expand, factor, factorial

from bezteach.symbolic import Step

from ..ranges import Integers, ends
from ..regions import region_of
from ..statement import Statement
from ..terms.defined import check_defined
from ..terms.linear import is_whole_form, least
from ..terms.terms import Failure


class Summed(NamedTuple):
    """That the sum of the terms over k from low to high is the result."""

    term: Expr
    k: Symbol
    low: Expr
    high: Expr
    result: Expr


def summed(statement):
    """The one sum over one index of an equation, and what it shall be; ``Failure`` where it is not of this kind."""
    parts = [*Add.make_args(statement.lhs), *[-part for part in Add.make_args(statement.rhs)]]
    sums = [part for part in parts if part.has(Sum)]
    if statement.relation != "=" or len(sums) != 1:
        raise Failure("not one sum")
    totals = [part for part in Mul.make_args(sums[0]) if part.has(Sum)]
    total = totals[0] if len(totals) == 1 else S.Zero
    if not isinstance(total, Sum) or len(total.limits) != 1 or total.function.has(Sum):
        raise Failure("not one sum over one index")
    ((index, low, high),) = total.limits
    k = Symbol(index.name, integer=True)  # it goes where the sum goes, below 0 too
    if {index, k} & statement.ranges.keys():
        raise Failure(f"{k} has a range, and is an index too")
    if not any(part.has(index) for part in total.function.atoms(binomial, factorial)):
        raise Failure("no binomial coefficient or factorial in what is summed")
    rest = Add(*[part for part in parts if not part.has(Sum)])
    return Summed(sums[0] / total * total.function.subs(index, k), k, low, high, -rest)


def lemmas_of(statement, claim, n, p, q, telescope):
    """The statements, each with a reason for a reader; ``Failure`` where the argument does not apply.

    What is needed beside them is checked here: p is never 0, and the sum is never empty.
    """
    others, inner = ranges_without(statement.ranges, n)
    low, high = statement.ranges[n]
    steps = others | {n: inner}
    shift = {n: n + 1}
    conditions = region_of(steps)[1]
    _check_limits(claim, n, shift, conditions)
    if p.has(claim.k) or q.has(claim.k) or not never_zero(p, conditions):
        raise Failure(f"{p} may be 0")
    k, after = claim.k, claim.term.subs(shift)
    for part in (claim.term, after, telescope):  # before values are put in: SymPy knows C(-1, -1) as 0
        check_defined(part, [*conditions, k - claim.low, claim.high - k], steps)
    amount = p * after - q * claim.term
    at_ends = telescope.subs(k, claim.high) - telescope.subs(k, claim.low) + amount.subs(k, claim.high)
    gained = Add(*[sign * after.subs(k, at) for sign, at in _gained(claim, n)])
    first = (statement.lhs.subs(n, low), statement.rhs.subs(n, low))
    along = _before_reals(steps, k, Integers(claim.low, claim.high - 1))
    return (
        (
            Statement(amount, "=", telescope.subs(k, k + 1) - telescope, along),
            f"for every {k} from {claim.low} to {claim.high - 1}: the sum telescopes",
        ),
        (
            Statement(at_ends + p * gained, "=", S.Zero, steps),
            f"what is left: the ends, the term for {k} = {claim.high}, and what the sum gains",
        ),
        (Statement(p * claim.result.subs(shift), "=", q * claim.result, steps), "the side without the sum"),
        (Statement(*_equation(first), others), f"both sides for {n} = {low}"),
    )


def steps_of(statement, claim, n, p, telescope, lemmas):
    """The lines that a reader is shown."""
    yield Step(telescope, "the certificate, found by Gosper's algorithm", Function("G")(n, claim.k))
    for found, reason in lemmas:
        yield Step(Eq(found.lhs, found.rhs, evaluate=False), reason)
    words = f"for every {n}, by induction" + ("" if p.is_number else f": {p} is never 0")
    yield Step(Eq(statement.lhs, statement.rhs, evaluate=False), words)


def ranges_without(ranges, n):
    """The ranges of the other symbols, and that of n without its last value."""
    low, high = ranges[n]
    others = {symbol: found for symbol, found in ranges.items() if symbol != n}
    if not is_whole_form(low) or any(n in end.free_symbols for found in others.values() for end in ends(found)):
        raise Failure(f"no induction on {n}")
    return others, Integers(low, high - 1)


def never_zero(expr, conditions):
    """Whether each factor of a polynomial is known not to be 0."""
    factors = [part.as_base_exp()[0] for part in Mul.make_args(factor(expr))]
    return all(
        part.is_nonzero if part.is_number else least(part - 1, conditions) >= 0 or least(-part - 1, conditions) >= 0
        for part in factors
    )


def check_sides(statement):
    """``Failure`` unless both sides have values everywhere."""
    for side in (statement.lhs, statement.rhs):
        check_defined(side, region_of(statement.ranges)[1], statement.ranges)


def _check_limits(claim, n, shift, conditions):
    length = claim.high - claim.low
    for limit in (claim.low, claim.high):
        if not is_whole_form(limit):
            raise Failure(f"the limit {limit} is no linear form of integers")
    if any(least(form, conditions) < 0 for form in (length, length.subs(shift))):
        raise Failure("the sum may be empty")


def _gained(claim, n):
    """The places k that the sum has for n + 1 and not for n, with 1, and those that it loses, with -1."""
    above, below = (int(expand(end.subs(n, n + 1) - end)) for end in (claim.high, claim.low))
    yield from ((1, claim.high + step) for step in range(1, above + 1))
    yield from ((-1, claim.high + step) for step in range(above + 1, 1))
    yield from ((-1, claim.low + step) for step in range(below))
    yield from ((1, claim.low + step) for step in range(below, 0))


def _before_reals(ranges, symbol, found):
    whole = {s: values for s, values in ranges.items() if isinstance(values, Integers)}
    return whole | {symbol: found} | ranges


def _equation(sides):
    return sides[0], "=", sides[1]
