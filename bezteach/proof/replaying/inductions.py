"""Replay of an induction: the first case and the step are made again from the statement, and their proofs replayed."""

from ..equations.induction import first_and_step
from ..errors import ReplayFailed
from ..ranges import Integers
from ..regions import region_of
from ..terms.defined import check_defined
from ..terms.terms import Failure
from .grid import Grid
from .telescoping import check_lemmas


def replay_induction(statement, certificate, replay_proof):
    """It holds at one end of the range of the symbol, and both sides gain the same by every step."""
    symbol, upward, *lemmas = certificate
    if not isinstance(statement.ranges.get(symbol), Integers) or statement.relation != "=":
        raise ReplayFailed(f"no induction on {symbol}")
    try:
        for side in (statement.lhs, statement.rhs):
            check_defined(side, region_of(statement.ranges)[1], statement.ranges)
        wanted = first_and_step(statement, symbol, upward)
    except Failure as error:
        raise ReplayFailed(str(error)) from None
    if wanted is None:
        raise ReplayFailed(f"no induction on {symbol} from this end")
    check_lemmas(lemmas, wanted, replay_proof)
    _check_gains(statement, symbol, wanted[1])
    return tuple(step for lemma in lemmas for step in lemma.proof.steps)


def _check_gains(statement, symbol, step):
    """What the step says that a side gains is what it gains, on the grid."""
    grid = Grid(step.ranges)
    for side, gain in ((statement.lhs, step.lhs), (statement.rhs, step.rhs)):
        gained = side.subs(symbol, symbol + 1) - side
        grid.check_equal(gained, gain, grid.points(), f"what {side} gains from {symbol} to {symbol} + 1")
