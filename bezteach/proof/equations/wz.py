"""Sums of hypergeometric terms that the binomial theorem does not close, by a telescoping sum (Wilf and Zeilberger).

The ratio R(n+1)/R(n) = q/p of the side without the sum says which combination p F(n+1, k) - q F(n, k) of the terms must
telescope, and Gosper's algorithm finds of what it is the difference. This is WZ's pair without the division by R, so
that R may be 0. The search looks at the inner points only, and proves nothing: ``telescoping`` names the statements
that must be proved for all points, and ``algebra`` proves them.
"""

from sympy import Add, PolynomialError, expand, fraction

from ..certificate import ByTelescoping, Lemma
from ..ranges import Integers
from ..regions import region_of
from ..terms.normal import Edge, normal
from ..terms.size import cancelled
from ..terms.terms import Failure, common_part
from ..verdict import PROVED, Proof
from .absorbing import absorbed
from .algebra import by_algebra
from .gosper import antidifference
from .induction import by_induction
from .telescoping import check_sides, lemmas_of, ranges_without, steps_of, summed

MOST_CONDITIONS = 12


def by_wz(statement, budget):
    """A ``Proof`` of an equation between a sum and a term without one, or None.

    >>> from bezteach.proof.budget import Budget
    >>> from bezteach.proof.statement import statement
    >>> from bezteach.symbolic import k, n
    >>> from sympy import Sum, binomial
    >>> by_wz(statement(Sum(binomial(n, k) ** 2, (k, 0, n)), binomial(2 * n, n)), Budget(5)).method
    'WZ certificate'
    """
    try:
        claim = summed(statement)
        check_sides(statement)
    except Failure:
        return None
    for n in [symbol for symbol, values in statement.ranges.items() if isinstance(values, Integers)]:
        budget.spend()
        try:
            return _along(n, statement, claim, budget)
        except (Failure, PolynomialError, ZeroDivisionError):
            continue
    return None


def _along(n, statement, claim, budget):
    """The proof by induction on n."""
    ranges_without(statement.ranges, n)
    p, q, telescope = _found(n, claim, statement.ranges, budget)
    lemmas = lemmas_of(statement, claim, n, p, q, telescope)
    proofs = []
    for place, (found, _) in enumerate(lemmas):
        provers = [by_algebra] if place < 3 else [by_algebra, by_wz, by_induction]  # the last has one symbol less
        proof = next((proof for prover in provers if (proof := prover(found, budget)) is not None), None)
        if proof is None:
            raise Failure(f"{found} is not proved")
        proofs.append(Lemma(found, proof))
    certificate = ByTelescoping(n, p, q, telescope, tuple(proofs))
    steps = tuple(steps_of(statement, claim, n, p, telescope, lemmas))
    return Proof(PROVED, "WZ certificate", steps, f"on {n}, from {statement.ranges[n].low}", certificate=certificate)


def _found(n, claim, ranges, budget):
    """p, q and G, from what the terms are at points that are far from every edge."""
    whole, conditions = region_of(ranges)
    whole, conditions = whole | {claim.k}, [*conditions, claim.k - claim.low - 2, claim.high - claim.k - 2]
    now, after = _beside_each_other([claim.result, claim.result.subs(n, n + 1)], whole, conditions, budget)
    q, p = fraction(cancelled(after / now))
    term = claim.term
    parts = [term, term.subs(n, n + 1), term.subs(claim.k, claim.k + 1)]
    now, after, beside = _beside_each_other(parts, whole, conditions, budget)
    multiple = antidifference(p * after / now - q, cancelled(beside / now), claim.k, budget)
    return p.factor(), q.factor(), absorbed(multiple, term, claim.k)


def _beside_each_other(expressions, whole, conditions, budget):
    """Rational functions that are to each other as these expressions."""
    for _ in range(MOST_CONDITIONS):
        try:
            terms = [normal(expand(expr), whole, conditions) for expr in expressions]
            break
        except Edge as edge:
            conditions = [*conditions, edge.form]
    else:
        raise Failure("too many edges")
    _, rests = common_part([term for each in terms for term in each])
    rests, results = iter(rests), []
    for each in terms:
        budget.spend()
        results.append(cancelled(Add(*[next(rests) for _ in each])))
    if 0 in results:
        raise Failure("a side is 0")
    return results
