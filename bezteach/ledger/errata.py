"""What the sources print wrongly, with its counterexample or the reading in which it is true, and the correction."""

from typing import NamedTuple

from bezteach.proof import Judgement

from .claim import Claim, statement_latex
from .judging import statement_verdict
from .reading import AMENDED, Slip


class Erratum(NamedTuple):
    """One slip at its place; ``claim`` is the correction, ``why`` the counterexample or the reason.

    ``stands`` says whether the slip is what it is said to be: that what is printed was refuted here and now.
    """

    source: str
    place: str
    slip: Slip
    claim: Claim
    why: str
    stands: bool

    @property
    def printed(self):
        """What is printed, as LaTeX or in words."""
        return self.slip.printed if isinstance(self.slip.printed, str) else statement_latex(self.slip.printed)

    @property
    def corrected(self):
        """The correction as LaTeX."""
        return statement_latex(self.claim.statement, self.claim.title)


def errata(readings, claims):
    """An ``Erratum`` for each slip in the readings, in their order; the refuter runs as they are asked for."""
    for source, rows in readings.items():
        for place, id, slip in rows:
            if slip is not None:
                yield Erratum(source, place, slip, claims[id], *found(slip))


def found(slip):
    """Why a slip is one, in words, and whether that stands."""
    if slip.kind == AMENDED:
        return slip.reason, True
    if slip.holds is not None:
        return slip.reason, slip.holds() is True
    verdict = statement_verdict(slip.printed, slip.given)
    if verdict.status != "REFUTED":
        return f"{verdict.status}: {verdict.note}", False
    line = f"line {verdict.first_wrong}: " if isinstance(verdict, Judgement) else ""
    return f"{line}{verdict.counterexample}", True
