"""A derivation: lines that a reader follows one after another, and whose last line is the result."""

from functools import wraps
from typing import NamedTuple

from sympy import Expr, Function, Symbol, expand
from sympy.core.relational import Relational

from .printing import in_words, latex
from .text import plain

p = Function("p")


class Step(NamedTuple):
    """One line: an expression, why it follows, and, where a new chain of equalities begins, what it is equal to.

    The expression may be a matrix, or a relation, which stands for itself.
    """

    expression: Expr
    reason: str
    left: Expr | None = None

    def latex(self, align=""):
        """The line without its reason; ``align`` stands before the sign of equality."""
        sign = "" if isinstance(self.expression, Relational) else "= "
        left = "" if self.left is None else latex(self.left) + " "
        return f"{left}{align}{sign}{latex(self.expression)}"

    def _repr_latex_(self):
        return rf"$\displaystyle {self.latex()}$"

    def __repr__(self):
        sign = "" if isinstance(self.expression, Relational) else "= "
        return f"{'' if self.left is None else f'{plain(self.left)} '}{sign}{plain(self.expression)}    ({self.reason})"


class Derivation(tuple):
    """The steps of a derivation; a notebook shows them as aligned equations with their reasons."""

    @property
    def result(self):
        return self[-1].expression

    def __repr__(self):
        return "\n".join(map(repr, self))

    def _repr_latex_(self):
        lines = [rf"{step.latex('&')} && {in_words(step.reason)}" for step in self]
        return "$$\\begin{aligned}\n" + " \\\\[1ex]\n".join(lines) + "\n\\end{aligned}$$"


def derived(steps):
    """Make a generator of steps a function that returns the last line; its ``steps`` gives the whole derivation."""

    def derivation(*args, **kwargs):
        return Derivation(steps(*args, **kwargs))

    @wraps(steps)
    def result(*args, **kwargs):
        return derivation(*args, **kwargs).result

    result.steps = wraps(steps)(derivation)
    return result


def rewrite(expression, old, new):
    """Put ``new`` for ``old`` where the two are the same polynomial; anything else is an error, so no line can lie."""
    if expand(old - new) != 0:
        raise ValueError(f"{old} is not equal to {new}")
    return expression.subs(old, new)


def named(letter, lower, upper=None):
    """The name of a point that a derivation defines, such as c_j or b_j^k."""
    return Symbol(rf"{letter}_{{{lower}}}" + ("" if upper is None else rf"^{{{upper}}}"))
