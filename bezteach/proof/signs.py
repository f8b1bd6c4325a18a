"""Inequalities for every n: the sign of each factor, bounds of each part, the peak of a product, induction on n.

Every method looks at the larger side minus the smaller one. The signs of its parts are those of ``sign_of``, exact with
respect to open and closed ends; nothing is taken from what SymPy assumes of a symbol.
"""

from sympy import PolynomialError

from .bounds import by_bounds, by_part_of_sum
from .factors import by_factors
from .growth import by_induction
from .inequality import claim_of
from .normal import Edge
from .peak import by_peak
from .terms import Failure
from .verdict import PROVED, Proof

METHODS = {
    "signs of the factors": by_factors,
    "bounds": by_bounds,
    "part of a sum": by_part_of_sum,
    "peak": by_peak,
    "induction": by_induction,
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
    for method, proved in METHODS.items():
        budget.spend()
        try:
            return Proof(PROVED, method, tuple(proved(claim)))
        except (Failure, Edge, PolynomialError):
            continue
    return None
