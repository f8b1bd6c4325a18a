"""``prove``: the statement, then the refuter, then one prover after the other until one decides.

A prover is a function from a statement and a budget to a ``Proof`` or None. It may raise OutOfTime or Unsupported,
which is the same as None, and InvalidStatement.
"""

from .budget import Budget
from .equations.algebra import by_algebra
from .equations.induction import by_induction
from .equations.wz import by_wz
from .errors import InvalidStatement, OutOfTime, Unsupported
from .exact.refuter import counterexample
from .fixed import by_cases
from .inequalities.signs import by_signs
from .regions import check_ranges
from .statement import statement
from .terms.size import MOST, most_terms
from .verdict import INVALID, REFUTED, UNDECIDED, Proof, verdict_of

PROVERS = [by_algebra, by_wz, by_induction, by_signs, by_cases]
PROVERS_SHARE = 0.6  # of the time left, so that one prover that finds nothing leaves some to the next
REFUTERS_SHARE = 0.4


def prove(lhs, rhs=None, *, given=None, budget=10.0):
    """Decide whether lhs = rhs, or a relation, holds for all values in its ranges, within a budget of seconds.

    ``given`` is {symbol: (low, high) or a SymPy Interval}; an integer symbol without one ranges over the non-negative
    integers, a real one over all reals.

    >>> from bezteach.symbolic import B, i, n, t
    >>> verdict = prove(t * B(i, n, t), (i + 1) / (n + 1) * B(i, n + 1, t), given={i: (0, n)})
    >>> verdict.status, verdict.counterexample
    ('REFUTED', n = 0, i = 0, t = 1/3: 1/3 on the left, 2/3 on the right)
    """
    clock, claim = Budget(budget), None
    try:
        claim = statement(lhs, rhs, given)
        proof = decided(claim, clock)
    except InvalidStatement as error:
        proof = Proof(INVALID, "", note=str(error))
    except RecursionError:
        proof = Proof(INVALID, "", note="the expression is nested too deeply")
    return verdict_of(proof, claim, clock.spent)


def decided(claim, clock):
    """The ``Proof`` of a statement, or that it is refuted or undecided; InvalidStatement where no side has a value."""
    found = counterexample(claim, clock.part(REFUTERS_SHARE))
    if found.counterexample is None and found.undefined is not None:
        raise InvalidStatement(f"neither side has a value at {found.undefined.point()}: {found.undefined.lhs}")
    check_ranges(claim.ranges)
    if found.counterexample is not None:
        return Proof(REFUTED, "refuter", note=str(found), counterexample=found.counterexample)
    if max(map(most_terms, (claim.lhs, claim.rhs))) > MOST:
        return Proof(UNDECIDED, "", note=f"no counterexample: {found}, and too large to be multiplied out")
    for prover in PROVERS:
        try:
            proof = prover(claim, clock if prover is PROVERS[-1] else clock.part(PROVERS_SHARE))
        except InvalidStatement:
            raise
        except (OutOfTime, Unsupported, ValueError, TypeError):
            continue  # SymPy refuses values such as a derivative's order below 0, and cannot put two Subs in order
        if proof is not None:
            return proof
    return Proof(UNDECIDED, "", note=f"no counterexample: {found}")
