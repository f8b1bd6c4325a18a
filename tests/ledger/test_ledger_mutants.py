"""No prover proves a false mutant of a claim: a few of each here; ``ledger_mutants.py`` tries all of them."""

import pytest
from ledger_mutants import judged, mutants_of, relations
from sympy import Integer, Sum

from bezteach import ledger
from bezteach.ledger.claim import eq
from bezteach.symbolic import B, i, n, t

EACH = 3
CLAIMS = [id for id in ledger.CLAIMS if relations(ledger.CLAIMS[id])]


@pytest.mark.parametrize("id", CLAIMS)
def test_no_prover_proves_a_false_mutant(id):
    mutants = list(mutants_of(ledger.CLAIMS[id]))
    for mutant, given in mutants[:: max(1, len(mutants) // EACH)]:
        assert judged(mutant, given) != "false proof", mutant


def test_the_judge_knows_a_true_mutant_from_a_false_one():
    assert judged(eq(Sum(B(i, n, t), (i, 0, n)), Integer(1)), {}) == "proved"
    assert judged(eq(Sum(B(i, n, t), (i, 1, n)), Integer(1)), {}) == "refuted"
    assert judged(eq(B(i, -1, t), B(i, -1, t)), {}) == "invalid"
