"""The verdict on a claim: the prover's, the derivation's, or, of an argument, that each computable step holds."""

import time
from typing import NamedTuple

from sympy.core.relational import Relational

from bezteach.proof import ARGUED, PROVED, REFUTED, UNDECIDED, Judgement, Verdict, check_derivation, prove
from bezteach.proof.ranges import about

from .claim import Argument, Chain, Claim, Computed, Known, Shown, flat

BUDGET = 10.0  # seconds for one statement


class Twin(NamedTuple):
    """A false neighbour and the verdict on it."""

    statement: Relational | Chain
    verdict: Verdict | Judgement


class Judged(NamedTuple):
    """A claim with its verdict; ``verdict`` is a Verdict, or the Judgement of a chain."""

    claim: Claim
    verdict: Verdict | Judgement
    twins: tuple[Twin, ...]
    seconds: float

    @property
    def status(self):
        return self.verdict.status

    @property
    def method(self):
        if isinstance(self.verdict, Verdict):
            return self.verdict.method
        methods = {line.step.method for line in self.verdict.lines if line.step is not None}
        return "line by line: " + ", ".join(sorted(methods))

    @property
    def settled(self):
        """Whether the claim is proved or argued."""
        return self.status in (PROVED, ARGUED)

    @property
    def holds(self):
        """Whether the claim is settled, and each of its twins refuted."""
        return self.settled and all(twin.verdict.status == REFUTED for twin in self.twins)


def judged(claim, known):
    """Judge a claim; ``known(id)`` says whether a claim that its argument refers to is settled."""
    started = time.perf_counter()
    if isinstance(claim.statement, Argument):
        verdict = argument_verdict(claim.statement, known)
    else:
        verdict = statement_verdict(claim.statement, claim.given)
    twins = tuple(Twin(twin, statement_verdict(twin, claim.given)) for twin in claim.twins)
    return Judged(claim, verdict, twins, time.perf_counter() - started)


def statement_verdict(statement, given):
    """The verdict on a relation or a chain; ranges of symbols that do not occur in it are left out."""
    if isinstance(statement, Chain):
        lines = tuple(map(flat, statement.lines))
        return check_derivation(lines, given=about(lines, given))
    relation = statement.func(flat(statement.lhs), flat(statement.rhs), evaluate=False)
    return prove(relation, given=about((relation,), given), budget=BUDGET)


def argument_verdict(argument, known):
    """ARGUED if every step that can be checked holds; else UNDECIDED, with the first that does not."""
    for number, step in enumerate(argument.steps, 1):
        if not _step_holds(step, known):
            return Verdict(UNDECIDED, "", note=f"step {number} does not hold: {step.text}")
    checked = sum(isinstance(step, Known | Shown | Computed) for step in argument.steps)
    return Verdict(ARGUED, f"{checked} of {len(argument.steps)} steps checked, the others in words")


def _step_holds(step, known):
    if isinstance(step, Known):
        return known(step.id)
    if isinstance(step, Shown):
        return statement_verdict(step.statement, step.given).status == PROVED
    return step.holds() is True if isinstance(step, Computed) else True
