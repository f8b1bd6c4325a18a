"""Replay of a telescoping sum: the lemmas are made again from the statement, and the proof of each is replayed."""

from ..equations.telescoping import check_sides, lemmas_of, steps_of, summed
from ..errors import ReplayFailed
from ..ranges import Integers
from ..terms.terms import Failure
from .alike import alike


def replay_telescoping(statement, certificate, replay_proof):
    n, p, q, telescope, recorded = certificate
    if not isinstance(statement.ranges.get(n), Integers) or statement.relation != "=":
        raise ReplayFailed(f"it is no equation for an integer {n}")
    try:
        claim = summed(statement)
        check_sides(statement)
        lemmas = lemmas_of(statement, claim, n, p, q, telescope)
    except Failure as error:
        raise ReplayFailed(str(error)) from None
    check_lemmas(recorded, [found for found, _ in lemmas], replay_proof)
    return tuple(steps_of(statement, claim, n, p, telescope, lemmas))


def check_lemmas(recorded, wanted, replay_proof):
    """``ReplayFailed`` unless the recorded lemmas are the ones that are wanted, and their proofs hold."""
    if len(recorded) != len(wanted):
        raise ReplayFailed(f"{len(recorded)} lemmas are recorded, and {len(wanted)} are wanted")
    for lemma, found in zip(recorded, wanted, strict=True):
        check_same(lemma.statement, found)
        replay_proof(found, lemma.proof)


def check_same(recorded, wanted):
    """``ReplayFailed`` unless two statements say the same of the same values."""
    same = recorded.relation == wanted.relation and recorded.ranges == wanted.ranges
    if not same or not alike(recorded.lhs, wanted.lhs) or not alike(recorded.rhs, wanted.rhs):
        raise ReplayFailed(f"the proof rests on {recorded}, and it needs {wanted}, each in its ranges")
