"""All one-edit mutants of the ledger's proved claims: ``python tests/ledger/ledger_mutants.py [PATTERN]`` judges each.

The provers are asked without the refuter in front of them, and the exact evaluator, which knows nothing of them, is the
judge: what both a prover proves and the evaluator refutes is a false proof. The rest is counted, and what is left open
is listed.
"""

import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from sympy.core.relational import Relational

from bezteach import ledger
from bezteach.ledger.claim import Chain, eq, flat
from bezteach.proof import Budget, InvalidStatement, OutOfTime, Unsupported, counterexample, statement
from bezteach.proof.engine import PROVERS
from bezteach.proof.ranges import about

sys.path.insert(0, str(Path(__file__).parents[1] / "proof"))
from proof_claims import mutants  # noqa: E402


def relations(claim):
    """A claim as relations: itself, or each line of its chain against the one before."""
    if isinstance(claim.statement, Relational):
        return [claim.statement]
    lines = claim.statement.lines if isinstance(claim.statement, Chain) else ()
    return [eq(one, other) for one, other in zip(lines, lines[1:], strict=False)]


def mutants_of(claim):
    """(relation, given) for all one-edit mutants of a claim; what SymPy makes of it may be no relation at all."""
    for relation in relations(claim):
        left, right = flat(relation.lhs), flat(relation.rhs)
        for lhs, rhs in [(one, right) for one in mutants(left)] + [(left, other) for other in mutants(right)]:
            mutant = relation.func(lhs, rhs, evaluate=False)
            yield mutant, about((mutant,), claim.given)


def judged(mutant, given, seconds=1.0):
    """ "false proof", "proved", "refuted", "invalid" or "open"."""
    try:
        claim = statement(mutant, given=given)
    except InvalidStatement:
        return "invalid"
    proved = any(_proves(prover, claim, seconds) for prover in PROVERS)
    found = counterexample(claim, Budget(seconds))
    if found.undefined is not None and found.counterexample is None:
        return "false proof" if proved else "invalid"
    if found.counterexample is not None:
        return "false proof" if proved else "refuted"
    return "proved" if proved else "open"


def _proves(prover, claim, seconds):
    try:
        proof = prover(claim, Budget(seconds))
    except (OutOfTime, Unsupported, InvalidStatement):
        return False
    return proof is not None and proof.status == "PROVED"


def of_claim(id):
    """[(verdict, mutant)] of one claim."""
    return [(judged(mutant, given), str(mutant)) for mutant, given in mutants_of(ledger.CLAIMS[id])]


def main(pattern=None):
    ids = [id for id in ledger.matching(pattern) if relations(ledger.CLAIMS[id])]
    counts = Counter()
    with ProcessPoolExecutor(2) as pool:
        for id, results in zip(ids, pool.map(of_claim, ids), strict=True):
            counts += Counter(verdict for verdict, _ in results)
            for verdict, mutant in results:
                if verdict in ("false proof", "open"):
                    print(f"{verdict:12} {id}: {mutant}", flush=True)
    print(f"{counts.total()} mutants of {len(ids)} claims:", dict(counts))
    return 1 if counts["false proof"] else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
