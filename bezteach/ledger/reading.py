"""A source read from its first line to its last: at each place the claim that stands there, and what is wrong with it.

A slip is what a source prints where it is not the claim of the ledger. It is *refuted* if what is printed has an exact
counterexample, and *amended* if there is a reading of it that is true. The claim of the row is the correction.
"""

from collections.abc import Callable
from typing import NamedTuple

from sympy.core.relational import Relational

from .claim import Chain, as_statement

REFUTED, AMENDED = "refuted", "amended"


class Slip(NamedTuple):
    """What is printed, a statement or words, and why it will not do.

    A refuted statement needs no ``reason``, the refuter finds its counterexample; of refuted words ``reason`` is the
    counterexample, and ``holds()`` computes that it is one.
    """

    kind: str
    printed: Relational | Chain | str
    reason: str = ""
    given: dict = {}
    holds: Callable[[], bool] | None = None


class Row(NamedTuple):
    """One statement of a source: where it stands, the id of its claim, and the slip in it if there is one."""

    place: str
    claim: str
    slip: Slip | None = None


def row(place, claim, slip=None):
    """A row of a reading."""
    return Row(place, claim, slip)


def refuted(printed, given=None):
    """A printed statement, as for ``claim``, that the refuter refutes."""
    return Slip(REFUTED, as_statement(printed), "", given or {})


def refuted_words(printed, counterexample, holds):
    """Printed words with a counterexample in words, which ``holds()`` computes exactly."""
    return Slip(REFUTED, printed, counterexample, {}, holds)


def amended(printed, reason, given=None):
    """A printed statement, or words, that is true in a reading that the reason names."""
    return Slip(AMENDED, as_statement(printed) if not isinstance(printed, str) else printed, reason, given or {})
