"""What decides a statement of the course: six verdicts, and never a lie.

``prove`` takes two sides or a relation, with ranges for the symbols, and returns a ``Verdict``. ``evaluate`` is the
exact evaluator that judges every prover; ``counterexample`` walks through the allowed points with it.
"""

from .budget import Budget
from .derivations import check_derivation
from .engine import prove
from .errors import InvalidStatement, OutOfTime, Undefined, Unsupported
from .evaluate import evaluate, evaluator
from .judgement import Judgement
from .refuter import Counterexample, counterexample
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
