"""Verdicts of the prover, remembered: the same answer comes again, from the next student or when a cell is run anew."""

from functools import lru_cache

from bezteach.proof import PROVED, REFUTED, check_derivation, prove

MOST = 4096


class _Undecided(Exception):
    """Carries a verdict that another try, with more time, may change: an exception is not remembered."""


def proved(lhs, rhs, ranges, budget):
    """``prove``; what is proved or refuted is so for ever.

    >>> from bezteach.symbolic import t
    >>> proved(t + t, 2 * t, {}, 1.0).status
    'PROVED'
    """
    return _settled(_prove, lhs, rhs, tuple(ranges.items()), budget)


def derived(lines, ranges, budget):
    """``check_derivation``, likewise."""
    return _settled(_derive, tuple(lines), tuple(ranges.items()), budget)


def _settled(judge, *question):
    try:
        return judge(*question)
    except _Undecided as found:
        return found.args[0]


@lru_cache(MOST)
def _prove(lhs, rhs, ranges, budget):
    return _or_raised(prove(lhs, rhs, given=dict(ranges), budget=budget))


@lru_cache(MOST)
def _derive(lines, ranges, budget):
    return _or_raised(check_derivation(list(lines), given=dict(ranges), budget=budget))


def _or_raised(verdict):
    if verdict.status not in (PROVED, REFUTED):
        raise _Undecided(verdict)
    return verdict
