"""Replay of all cases: every value of the integer symbols is there, and both sides are what is recorded for it."""

from itertools import islice

from sympy import oo

from ..budget import Budget
from ..errors import InvalidStatement, OutOfTime, ReplayFailed, Undefined, Unsupported
from ..exact.evaluate import evaluator
from ..exact.polynomial import Polynomial
from ..exact.refuter import COMPARE
from ..exact.walk import integer_points
from ..fixed import MOST_CASES, letters, steps_of
from ..ranges import Integers
from .grid import SECONDS


def replay_cases(statement, certificate, replay_proof):
    """Check that the cases are all there are, and that the relation holds in each of them."""
    whole = {s: found for s, found in statement.ranges.items() if isinstance(found, Integers)}
    for symbol, (low, high) in whole.items():
        if -oo in (low, high) or oo in (low, high):
            raise ReplayFailed(f"{symbol} has no end")
    try:
        _check_all(statement, certificate.cases, Budget(SECONDS))
    except (Undefined, Unsupported, InvalidStatement) as error:
        raise ReplayFailed(f"a case has no value: {error}") from None
    except OutOfTime:
        raise ReplayFailed("the replay is out of time") from None
    return steps_of(statement, certificate.cases)


def _check_all(statement, cases, budget):
    points = list(islice(integer_points(statement.ranges, None, budget), MOST_CASES + 1))
    recorded = [case for case, _, _ in cases]
    if not points or points != recorded:
        missing = next((point for point in points if point not in recorded), "more than there are")
        raise ReplayFailed(f"the cases are not those of the ranges: {missing}")
    symbols, reals, compare = tuple(statement.ranges), letters(statement), COMPARE[statement.relation]
    sides = [evaluator(side, symbols) for side in (statement.lhs, statement.rhs)]
    for case, *values in cases:
        found = [side((*case, *reals), budget) for side in sides]
        if found != values:
            raise ReplayFailed(f"at {case} the sides are {found}, and recorded is {values}")
        if compare is not COMPARE["="] and any(isinstance(value, Polynomial) for value in found):
            raise ReplayFailed(f"at {case} a polynomial has no order")
        if not compare(*found):
            raise ReplayFailed(f"at {case} the relation fails: {found}")
