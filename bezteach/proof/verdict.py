"""What the engine says of a statement, and how it shows it."""

from dataclasses import dataclass
from typing import NamedTuple

from bezteach.symbolic import Step, latex
from bezteach.symbolic.printing import in_words

from .errors import Undefined
from .exact.polynomial import to_sympy
from .exact.refuter import Counterexample
from .statement import Statement

PROVED, ARGUED, CHECKED = "PROVED", "ARGUED", "CHECKED"
REFUTED, UNDECIDED, INVALID = "REFUTED", "UNDECIDED", "INVALID"


class Proof(NamedTuple):
    """What a prover returns when it has decided a statement; the status may be any but INVALID."""

    status: str
    method: str
    steps: tuple[Step, ...] = ()
    note: str = ""
    counterexample: Counterexample | None = None
    certificate: tuple | None = None  # one of certificate.py, if it is PROVED


@dataclass(frozen=True, repr=False)
class Verdict:
    """One of the six statuses, by which method and steps, after how many seconds; why, or where it fails."""

    status: str
    method: str = ""
    steps: tuple[Step, ...] = ()
    seconds: float = 0.0
    counterexample: Counterexample | None = None
    note: str = ""
    statement: Statement | None = None
    certificate: tuple | None = None

    def replay(self):
        """Check a PROVED verdict again, from its statement and certificate alone: without the search that found it.

        Checked are: that the cases cover the range; that in each case what the kernel makes of both sides is what is
        recorded, and that it is 0, or has the sign, by polynomial arithmetic; the statements that an induction or a
        telescoping sum rests on, and their proofs; that the steps shown are those of the certificate; and everything
        that has a value by the exact evaluator on a grid of points. ``ReplayFailed`` names the first that fails.

        >>> from bezteach.proof import prove
        >>> from bezteach.symbolic import B, i, n, t
        >>> prove(t * B(i, n, t), (i + 1) / (n + 1) * B(i + 1, n + 1, t), given={i: (0, n)}).replay()
        >>> prove(B(i, n, t), B(i, n, 1 - t)).replay()
        Traceback (most recent call last):
        ...
        bezteach.proof.errors.ReplayFailed: only a PROVED verdict can be replayed, and this one is REFUTED
        """
        from .replaying.replay import replay

        replay(self)

    def __repr__(self):
        how = f" ({self.method})" if self.method else ""
        what = "" if self.statement is None else f"{self.statement}"
        why = "; ".join(str(part) for part in (self.counterexample, self.note) if part)
        return f"{self.status}{how}: " + "; ".join(part for part in (what, why) if part)

    def _repr_latex_(self):
        how = f" ({self.method})" if self.method else ""
        lines = [] if self.statement is None else [self.statement.latex()]
        lines.append(rf"\textbf{{{self.status}}}" + in_words(how))
        if self.counterexample is not None:
            lines += [point_words(self.counterexample), sides_words(self.counterexample)]
        if self.note:
            lines.append(in_words(self.note))
        return "$$\\begin{gathered}\n" + " \\\\[1ex]\n".join(lines) + "\n\\end{gathered}$$"


def verdict_of(proof, claim, seconds):
    """The ``Verdict`` on a statement that a ``Proof`` is."""
    return Verdict(
        proof.status,
        proof.method,
        proof.steps,
        seconds,
        proof.counterexample,
        proof.note,
        claim,
        proof.certificate,
    )


def point_words(found):
    values = [f"{latex(symbol)} = {latex(to_sympy(value))}" for symbol, value in found.values.items()]
    return r",\quad ".join(values) or in_words("as it stands")


def sides_words(found):
    return rf"\text{{left: }} {_value(found.lhs)} \qquad \text{{right: }} {_value(found.rhs)}"


def _value(value):
    return in_words(f"undefined ({value})") if isinstance(value, Undefined) else latex(to_sympy(value))
