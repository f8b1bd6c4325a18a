"""Inequalities for every n: the sign of each factor, bounds of each part, the peak of a product, induction on n.

Every method looks at the larger side minus the smaller one. The signs of its parts are those of ``sign_of``, exact with
respect to open and closed ends; nothing is taken from what SymPy assumes of a symbol.
"""

from sympy import PolynomialError

from ..terms.normal import Edge
from ..terms.terms import Failure
from ..verdict import PROVED, Proof
from .bounds import bounds_shown, by_bounds, by_part_of_sum, part_of_sum_shown
from .factors import by_factors, factors_shown
from .growth import by_induction, growth_shown
from .inequality import claim_of
from .peak import by_peak, peak_shown

METHODS = {  # each is a search for a certificate, and what it shows of it
    "signs of the factors": (by_factors, factors_shown),
    "bounds": (by_bounds, bounds_shown),
    "part of a sum": (by_part_of_sum, part_of_sum_shown),
    "peak": (by_peak, peak_shown),
    "induction": (by_induction, growth_shown),
}


def by_signs(statement, budget):
    """A ``Proof`` of an inequality for all values in its ranges, or None.

    >>> from sympy import Interval, oo
    >>> from bezteach.proof.budget import Budget
    >>> from bezteach.proof.statement import statement
    >>> from bezteach.symbolic import B, i, n, t
    >>> peak = statement(B(i, n, t) <= B(i, n, i / n), given={n: (1, oo), i: (0, n), t: Interval(0, 1)})
    >>> by_signs(peak, Budget(5)).method
    'peak'
    """
    if statement.relation == "=":
        return None
    try:
        claim = claim_of(statement, budget)
    except Failure:
        return None
    for method, (proved, shown) in METHODS.items():
        budget.spend()
        try:
            certificate = proved(claim)
            steps = []
            for step in shown(claim, certificate):
                budget.spend()
                steps.append(step)
            return Proof(PROVED, method, tuple(steps), certificate=certificate)
        except (Failure, Edge, PolynomialError):
            continue
    return None
