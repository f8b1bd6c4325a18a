"""Replay of an equation that follows from two others which have a line in common."""

from sympy import oo

from ..equations.algebra import region_of
from ..errors import ReplayFailed
from ..ranges import Integers, ends
from ..terms.linear import least
from .alike import alike


def replay_through(statement, certificate, replay_proof):
    """The two equations lead from one side to the other, they hold wherever the statement shall, and are replayed."""
    claims = [verdict.statement for verdict in certificate.verdicts]
    if (
        len(claims) != 2
        or any(claim.relation != "=" for claim in (statement, *claims))
        or not _linked(statement, *claims)
    ):
        raise ReplayFailed(f"{statement} does not follow from {' and '.join(map(str, claims))}")
    for verdict in certificate.verdicts:
        _check_ranges(statement.ranges, verdict.statement.ranges)
        replay_proof(verdict.statement, verdict)
    return ()


def _linked(statement, one, other):
    """Whether a side that both have in common leads from the left to the right."""
    for left, middle in ((one.lhs, one.rhs), (one.rhs, one.lhs)):
        for again, right in ((other.lhs, other.rhs), (other.rhs, other.lhs)):
            for start, end in ((left, right), (right, left)):
                if alike(middle, again) and alike(start, statement.lhs) and alike(end, statement.rhs):
                    return True
    return False


def _check_ranges(wanted, found):
    """Each point of the wanted ranges must be one of the found ones, whatever more symbols those have."""
    known = {symbol: values for symbol, values in wanted.items()}
    for symbol, values in found.items():
        if symbol in wanted:
            if wanted[symbol] != values:
                raise ReplayFailed(f"{symbol} ranges over {values} in a part of the proof")
        elif not _has_values(values, known):
            raise ReplayFailed(f"for some values {symbol}, which is in a part of the proof only, has none")
        known[symbol] = values


def _has_values(values, known):
    """Whether a range holds a value, whatever the symbols before it are."""
    low, high = ends(values)
    if low == -oo or high == oo or (low.is_number and high.is_number):
        return True
    return isinstance(values, Integers) and least(high - low, region_of(known)[1]) >= 0
