"""What a judged derivation says of each line and of the whole, and how it shows it."""

from dataclasses import dataclass
from typing import NamedTuple

from sympy import Expr

from bezteach.symbolic import latex, plain
from bezteach.symbolic.printing import in_words

from .exact.refuter import Counterexample
from .verdict import ARGUED, CHECKED, INVALID, PROVED, REFUTED, UNDECIDED, Verdict, point_words, sides_words

START = "start"
FOLLOWS = "follows"
CHECKED_ONLY = "checked only"
WRONG = "wrong"
NO_PROGRESS = "no progress"
RIGHT_AGAIN = "right again"
STILL_WRONG = "still wrong"
OPEN = "undecided"
MEANINGLESS = "invalid"

HOLDS = (PROVED, ARGUED)
NOT_SETTLED = (CHECKED, UNDECIDED)
_MARKS = {FOLLOWS: "✓", RIGHT_AGAIN: "✓", CHECKED_ONLY: "?", OPEN: "?", START: " "}


_ENDS = {
    PROVED: "the last line equals the first",
    ARGUED: "the last line equals the first",
    CHECKED: "the last line equals the first where it was checked",
    REFUTED: "the last line differs from the first",
    UNDECIDED: "whether the last line equals the first is undecided",
    INVALID: "the last line cannot be compared with the first",
}


class Line(NamedTuple):
    """One line: its verdicts against the line before and against the first, the remark that sums them up, and why.

    A line that is invalid has no verdicts, nor has the first one.
    """

    number: int
    expression: object
    remark: str
    step: Verdict | None = None
    whole: Verdict | None = None
    note: str = ""

    @property
    def mark(self):
        """✓, ✗, ? or, for the first line, a blank."""
        if self.remark == NO_PROGRESS:
            return {REFUTED: "✗", PROVED: "✓", ARGUED: "✓"}.get(self.whole.status, "?")
        return _MARKS.get(self.remark, "✗")

    @property
    def counterexample(self):
        """Where a wrong line differs from the line before; where one that is still wrong differs from the first."""
        if self.remark == WRONG:
            return self.step.counterexample
        return None if self.whole is None or self.remark == RIGHT_AGAIN else self.whole.counterexample

    def __repr__(self):
        line = f"{self.mark} {self.number}. {'=' if self.number > 1 else ' '} {_written(self.expression)}"
        return line if self.remark == START else f"{line}    {self._words(self.counterexample)}"

    def _words(self, *more):
        return ": ".join(filter(None, (self.remark, "; ".join(str(part) for part in (self.note, *more) if part))))

    def latex(self):
        """One row of aligned equations, and a second one for a counterexample."""
        words = self.remark == MEANINGLESS or not isinstance(self.expression, Expr)
        row = "&= " if self.number > 1 else "& "
        row += in_words(_written(self.expression)) if words else latex(self.expression)
        if self.remark != START:
            row += rf" && {in_words(f'{self.mark} {self._words()}')}"
        found = self.counterexample
        return row if found is None else f"{row} \\\\\n&&& {point_words(found)}:\\quad {sides_words(found)}"


def _written(line):
    try:
        return plain(line)
    except RecursionError:
        return "..."


@dataclass(frozen=True, repr=False)
class Judgement:
    """What is said of a chain: of each line, of the whole, and of the last line against the first (``ends``).

    The status is that of all the equalities together: PROVED only if every step is, REFUTED if one of them fails, even
    where the last line equals the first.
    """

    status: str
    lines: tuple[Line, ...]
    ends: Verdict | None = None
    seconds: float = 0.0
    note: str = ""

    @property
    def first_wrong(self):
        """The number of the first wrong line, from 1, or None."""
        return next((line.number for line in self.lines if line.remark == WRONG), None)

    @property
    def counterexample(self) -> Counterexample | None:
        """Where the first wrong line differs from the line before it."""
        return None if self.first_wrong is None else self.lines[self.first_wrong - 1].counterexample

    @property
    def last_equals_first(self):
        """Whether what the chain claims is proved, whatever is wrong in between."""
        return self.ends is not None and self.ends.status in HOLDS

    def __repr__(self):
        return "\n".join([*map(repr, self.lines), f"{self.status}: {self._summary()}"])

    def _repr_latex_(self):
        rows = [line.latex() for line in self.lines]
        rows.append(rf"& \textbf{{{self.status}}} && {in_words(self._summary())}")
        return "$$\\begin{aligned}\n" + " \\\\[1ex]\n".join(rows) + "\n\\end{aligned}$$"

    def _summary(self):
        parts = [self.note] if self.note else []
        if self.first_wrong is not None:
            parts.append(f"line {self.first_wrong} is the first wrong one")
        if self.ends is not None:
            parts.append(_ENDS[self.ends.status])
        return "; ".join(parts) or "nothing to judge"
