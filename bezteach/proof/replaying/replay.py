"""A PROVED verdict checked again from its statement and its certificate, without the search that found it.

The kernel that both share is small: the rules of ``normal`` and ``closing`` for one case, ``signs`` for one expression,
``least``, and the exact evaluator. What is not shared is everything that looks for cases, groups, factors, bounds or a
telescoping sum. See ``Verdict.replay`` for what is checked.
"""

from operator import eq

from ..certificate import (
    ByBounds,
    ByCases,
    ByGrowth,
    ByInduction,
    ByPartOfSum,
    ByPeak,
    BySigns,
    ByTelescoping,
    ByTerms,
    Through,
)
from ..errors import ReplayFailed
from ..exact.polynomial import Polynomial
from ..exact.refuter import COMPARE
from ..verdict import PROVED
from .alike import alike
from .cases import replay_cases
from .grid import Grid
from .inductions import replay_induction
from .inequalities import replay_bounds, replay_growth, replay_part_of_sum, replay_peak
from .signs import replay_signs
from .telescoping import replay_telescoping
from .terms import replay_terms
from .through import replay_through

RULES = {
    ByTerms: replay_terms,
    ByTelescoping: replay_telescoping,
    ByInduction: replay_induction,
    BySigns: replay_signs,
    ByBounds: replay_bounds,
    ByPartOfSum: replay_part_of_sum,
    ByPeak: replay_peak,
    ByGrowth: replay_growth,
    ByCases: replay_cases,
    Through: replay_through,
}


def replay(verdict):
    """Return if the proof of a verdict holds, else raise ``ReplayFailed`` with the first step that does not."""
    if verdict.status != PROVED:
        raise ReplayFailed(f"only a PROVED verdict can be replayed, and this one is {verdict.status}")
    replay_proof(verdict.statement, verdict)


def replay_proof(statement, proof):
    """Check the certificate of a ``Proof`` or a ``Verdict``, and that the steps shown are those it gives."""
    if proof.status != PROVED:
        raise ReplayFailed(f"{statement} is {proof.status}")
    check_steps(proof.steps, check_certificate(statement, proof.certificate))
    check_values(statement)


def check_certificate(statement, certificate):
    """Check that a certificate proves a statement, and return the steps that show it."""
    if type(certificate) not in RULES:
        raise ReplayFailed(f"there is no certificate that proves {statement}")
    try:
        return RULES[type(certificate)](statement, certificate, replay_proof)
    except ReplayFailed:
        raise
    except Exception as error:  # an entry of a wrong kind may break any rule: then nothing is proved
        raise ReplayFailed(f"the certificate cannot be read: {type(error).__name__}: {error}") from error


def check_values(statement):
    """``ReplayFailed`` where the statement itself fails on the grid."""
    grid, compare = Grid(statement.ranges), COMPARE[statement.relation]
    left, right = grid.evaluator(statement.lhs), grid.evaluator(statement.rhs)
    for point in grid.points():
        values = left(point), right(point)
        if None in values:
            continue
        if compare is not eq and any(isinstance(value, Polynomial) for value in values):
            raise ReplayFailed(f"{statement} puts in order what is no number")
        if not compare(*values):
            raise ReplayFailed(f"{statement} fails at {grid.words(point)}: {values[0]} and {values[1]}")


def check_steps(shown, found):
    """``ReplayFailed`` at the first line that a reader is shown and that is not the one the certificate gives."""
    for number, (one, other) in enumerate(zip(shown, found, strict=False), 1):
        same = one.reason == other.reason and (one.left is None) == (other.left is None)
        same = same and alike(one.expression, other.expression)
        if not same or not (one.left is None or alike(one.left, other.left)):
            raise ReplayFailed(f"step {number} shows {one.expression}, and the certificate gives {other.expression}")
    if len(shown) != len(found):
        raise ReplayFailed(f"{len(shown)} steps are shown, and the certificate gives {len(found)}")
