"""What decides a statement of the course: six verdicts, and never a lie.

``prove`` takes two sides or a relation, with ranges for the symbols, and returns a ``Verdict``, which can be replayed;
``check_derivation`` judges a chain line by line. ``evaluate`` is the exact evaluator that judges every prover, and
``counterexample`` walks through the allowed points with it.

- ``exact/``: the evaluator and the refuter, which share nothing with the provers
- ``terms/``: expressions as sums of hypergeometric terms
- ``equations/``, ``inequalities/``, ``fixed``: the provers; ``engine`` asks one after the other
- ``replaying/``: a proof checked again from the ``certificate`` that its prover left
"""

from .budget import Budget
from .derivations import check_derivation
from .engine import prove
from .errors import InvalidStatement, OutOfTime, Undefined, Unsupported
from .exact.evaluate import evaluate, evaluator
from .exact.refuter import Counterexample, counterexample
from .judgement import Judgement
from .statement import Statement, statement
from .verdict import ARGUED, CHECKED, INVALID, PROVED, REFUTED, UNDECIDED, Proof, Verdict

__all__ = [
    "ARGUED",
    "CHECKED",
    "INVALID",
    "PROVED",
    "REFUTED",
    "UNDECIDED",
    "Budget",
    "Judgement",
    "Counterexample",
    "InvalidStatement",
    "OutOfTime",
    "Proof",
    "Statement",
    "Undefined",
    "Unsupported",
    "Verdict",
    "check_derivation",
    "counterexample",
    "evaluate",
    "evaluator",
    "prove",
    "statement",
]
