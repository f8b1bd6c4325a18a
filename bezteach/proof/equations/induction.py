"""Equations with a partial sum, proved by induction on a limit that moves: one case, and the step to the next.

A sum from k = s on loses its first summand when s grows by one, and a sum up to s gains one. So the step is an equation
about that summand, and about the sum of what the others gain; ``algebra`` decides it and the case at the end.
"""

from sympy import Sum, expand

from ..certificate import ByInduction, Lemma
from ..indices import with_fresh_indices
from ..ranges import Integers, ends
from ..regions import region_of
from ..statement import Statement
from ..terms.defined import check_defined
from ..terms.differences import difference
from ..terms.linear import is_whole_form
from ..terms.size import MOST_TERMS, most_terms
from ..terms.terms import Failure
from ..verdict import PROVED, Proof
from .algebra import by_algebra


def by_induction(statement, budget):
    """A ``Proof`` of an equation by induction on one of its integer symbols, or None.

    >>> from bezteach.proof.budget import Budget
    >>> from bezteach.proof.statement import statement
    >>> from bezteach.symbolic import k, n
    >>> from sympy import Sum
    >>> by_induction(statement(Sum(k, (k, 0, n)), n * (n + 1) / 2), Budget(5)).status
    'PROVED'
    """
    if statement.relation != "=":
        return None
    whole, conditions = region_of(statement.ranges)
    try:
        for side in (statement.lhs, statement.rhs):
            check_defined(side, conditions, statement.ranges)
    except Failure:
        return None
    for symbol in sorted(whole & _moving(statement), key=str):
        for upward in (True, False):
            budget.spend()
            proof = _along(symbol, upward, statement, budget)
            if proof is not None:
                return proof
    return None


def _moving(statement):
    """The symbols in the limits of sums."""
    sums = [total for side in (statement.lhs, statement.rhs) for total in side.atoms(Sum)]
    return {symbol for total in sums for _, *limits in total.limits for end in limits for symbol in end.free_symbols}


def _along(symbol, upward, statement, budget):
    lemmas = []
    for claim in first_and_step(statement, symbol, upward) or ():
        proof = by_algebra(claim, budget)
        if proof is None:
            return None
        lemmas.append(Lemma(claim, proof))
    if not lemmas:
        return None
    low, high = statement.ranges[symbol]
    note = f"on {symbol}, from {low if upward else high}"
    steps = tuple(step for lemma in lemmas for step in lemma.proof.steps)
    return Proof(PROVED, "induction", steps, note, certificate=ByInduction(symbol, upward, *lemmas))


def first_and_step(statement, symbol, upward):
    """The statement at one end of the range of a symbol, and that both sides gain the same by a step; None if that end
    is no whole number, if the range of another symbol depends on this one, or if there are too many terms.
    """
    low, high = statement.ranges[symbol]
    start = low if upward else high
    others = {s: values for s, values in statement.ranges.items() if s != symbol}
    if not is_whole_form(start) or any(symbol in end.free_symbols for r in others.values() for end in ends(r)):
        return None
    if max(map(most_terms, (statement.lhs, statement.rhs))) > MOST_TERMS:
        return None
    sides = [with_fresh_indices(expand(side)) for side in (statement.lhs, statement.rhs)]
    ranges = {**others, symbol: Integers(low, high - 1)}
    conditions = region_of(ranges)[1]
    left, right = (side.subs(symbol, start) for side in sides)
    gains = [difference(side, symbol, conditions) for side in sides]
    return Statement(left, "=", right, others), Statement(gains[0], "=", gains[1], ranges)
