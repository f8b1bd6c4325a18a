"""What a claim of the ledger is: a statement of the course, and false neighbours that must be refuted.

A statement is one of three:

* a SymPy relation, for all values in the ranges ``given``;
* a ``Chain`` of equalities, as a printed proof is one;
* an ``Argument``, where no equation settles the matter: steps in words between steps that are computed.
"""

from collections.abc import Callable
from typing import NamedTuple

from sympy import Eq, Expr, MatMul, oo
from sympy.core.relational import Relational

from bezteach.symbolic import latex
from bezteach.symbolic.printing import in_words


class Chain(NamedTuple):
    """Lines that are all equal, and why each is equal to the one before, for a reader; "" where that is not said."""

    lines: tuple[Expr, ...]
    reasons: tuple[str, ...] = ()


class Words(NamedTuple):
    """A step of an argument that nothing but its reader checks."""

    text: str


class Known(NamedTuple):
    """A step that is a claim of the ledger."""

    text: str
    id: str


class Shown(NamedTuple):
    """A step that is proved on the spot."""

    text: str
    statement: Relational
    given: dict = {}


class Computed(NamedTuple):
    """A step that an exact computation settles: ``holds()`` returns whether it does."""

    text: str
    holds: Callable[[], bool]


class Argument(NamedTuple):
    """The steps of an argument: ``Words``, ``Known``, ``Shown`` and ``Computed`` ones."""

    steps: tuple


class Claim(NamedTuple):
    """One statement of the course; ``title`` says it in a line of words, ``twins`` are false statements beside it."""

    id: str
    title: str
    statement: Relational | Chain | Argument
    given: dict
    twins: tuple


def eq(lhs, rhs):
    """The equation, left as it stands."""
    return Eq(lhs, rhs, evaluate=False)


def claim(id, title, statement, given=None, *, twins=()):
    """A claim of the ledger; a pair (lhs, rhs) is an equation, a list is a chain, also among the twins."""
    return Claim(id, title, as_statement(statement), given or {}, tuple(map(as_statement, twins)))


def argued(id, title, *steps):
    """A claim with an argument; a step that is only text is in words."""
    return Claim(id, title, Argument(tuple(Words(step) if isinstance(step, str) else step for step in steps)), {}, ())


def as_statement(written):
    """A pair as the equation, a list as the chain that it is short for; a line may be (expression, reason)."""
    if isinstance(written, list):
        pairs = [line if type(line) is tuple else (line, "") for line in written]
        return Chain(*map(tuple, zip(*pairs, strict=True)))
    return eq(*written) if type(written) is tuple else written


def flat(expression):
    """An expression with each product of matrices that is one number, or one point, as that number."""
    products = expression.atoms(MatMul)
    return expression.xreplace({product: product.doit()[0, 0] for product in products}) if products else expression


def statement_latex(statement, title=""):
    """A statement as LaTeX, made from what is checked; an argument is its title."""
    if isinstance(statement, Argument):
        return in_words(title)
    if isinstance(statement, Chain):
        return " = ".join(map(latex, statement.lines))
    return relation_latex(statement)


def given_latex(given):
    """The ranges as LaTeX, "" for none."""
    return r",\; ".join(_range(symbol, values, latex, r"\le", r"\ge") for symbol, values in given.items())


def given_plain(given):
    """The ranges in plain text, "" for none."""
    return ", ".join(_range(symbol, values, str, "<=", ">=") for symbol, values in given.items())


def _range(symbol, values, shown, at_most, at_least):
    low, high = values if isinstance(values, tuple) else (values.start, values.end)
    below = "<" if getattr(values, "left_open", False) else at_most
    above = "<" if getattr(values, "right_open", False) else at_most
    if high == oo:
        return f"{shown(symbol)} {'>' if below == '<' else at_least} {shown(low)}"
    front = "" if low == -oo else f"{shown(low)} {below} "
    return f"{front}{shown(symbol)} {above} {shown(high)}"


_SIGNS = {"==": "=", ">=": r"\ge", "<=": r"\le", ">": ">", "<": "<"}


def relation_latex(relation):
    return f"{latex(relation.lhs)} {_SIGNS[relation.rel_op]} {latex(relation.rhs)}"
