"""Replay of an equation that follows from two others which have a line in common."""

from ..errors import ReplayFailed
from ..regions import has_values
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
    known = statement.ranges
    for verdict in certificate.verdicts:
        known = _with_ranges(known, verdict.statement.ranges)
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


def _with_ranges(known, found):
    """The known ranges, and those found beside them, so that each point of the known ones is part of one of them all:
    a symbol of both ranges over the same, and any other has a value wherever the known ones have.
    """
    known = dict(known)
    for symbol, values in found.items():
        if symbol not in known and not has_values(values, known):
            raise ReplayFailed(f"for some values {symbol}, which is in a part of the proof only, has none")
        if known.setdefault(symbol, values) != values:
            raise ReplayFailed(f"{symbol} ranges over {values} in a part of the proof, and not everywhere")
    return known
