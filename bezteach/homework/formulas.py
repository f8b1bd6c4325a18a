"""Formulas, with a number or a letter for the degree: whether two are one, and the form that is asked for."""

from contextlib import suppress
from fractions import Fraction

from sympy import Add, Dummy, Expr, Indexed, Integer, Mul, Poly, PolynomialError, Pow, Rational, expand

from bezteach.parsing import InvalidAnswer
from bezteach.proof import INVALID as MEANINGLESS
from bezteach.proof import PROVED, REFUTED, Budget, OutOfTime, Undefined, Unsupported, statement
from bezteach.proof.exact.evaluate import evaluator
from bezteach.proof.exact.refuter import shown, walk
from bezteach.proof.ranges import about
from bezteach.symbolic import B

from .reading import read
from .remembered import proved
from .verdict import CORRECT, INVALID, OPEN, WRONG, Verdict

SECONDS = 5.0  # for one comparison


def formula_of(answer, letters):
    """A SymPy formula in these letters (symbols, and bases of points); ``InvalidAnswer`` names any other.

    >>> from bezteach.symbolic import n, t
    >>> formula_of("n t^(n-1)", {n, t})
    n*t**(n - 1)
    >>> formula_of("x + t", {n, t})
    Traceback (most recent call last):
    bezteach.parsing.errors.InvalidAnswer: x does not occur in the task
    """
    found = read(answer)
    if isinstance(found, tuple):
        raise InvalidAnswer("this is a list: one formula is asked for")
    if isinstance(found, float):
        raise InvalidAnswer("this is a decimal number: write it as a fraction, such as 1/3")
    formula = Rational(found.numerator, found.denominator) if isinstance(found, Fraction) else found
    known = {part for letter in letters for part in letter.free_symbols}
    if not isinstance(formula, Expr):
        raise InvalidAnswer("this is a statement: one formula is asked for, without a sign of equality")
    strange = sorted(str(letter) for letter in formula.free_symbols - known if not isinstance(letter, Indexed))
    if strange:
        raise InvalidAnswer(f"{strange[0]} does not occur in the task")
    return formula


def compared(given, right, ranges, mistakes=()):
    """The ``Verdict`` on a formula against the right one, for all letters in their ranges.

    ``mistakes`` are (formula, feedback). WRONG has the simplest place where the answer fails, and what it is there.
    """
    if given == right:
        return Verdict(CORRECT, "Right: this is the formula.")
    verdict = proved(given, right, about((given, right), ranges), SECONDS)
    if verdict.status == PROVED:
        return Verdict(CORRECT, "Right, and proved for all that is asked.")
    if verdict.status == MEANINGLESS:
        return Verdict(INVALID, verdict.note)
    for mistake, feedback in mistakes:
        if proved(given, mistake, about((given, mistake), ranges), SECONDS).status == PROVED:
            return Verdict(WRONG, feedback)
    if verdict.status == REFUTED:
        return Verdict(WRONG, _where(verdict.counterexample))
    agree = _where_both_agree(given, right, ranges)
    return Verdict(OPEN, f"Whether this is the right formula could not be decided. {agree}Write it in a simpler form.")


def _where_both_agree(given, right, ranges):
    """A sentence on the first place at which both have one value, or nothing."""
    claim, budget = statement(given, right, about((given, right), ranges)), Budget(1.0)
    run = evaluator(claim.lhs, claim.ranges)
    try:
        for values in walk(claim, budget):
            with suppress(Undefined, Unsupported):
                at = ", ".join(f"{symbol} = {value}" for symbol, value in zip(claim.ranges, values, strict=True))
                return f"At {at} both are {shown(run(values, budget))}. "
    except OutOfTime:
        pass
    return ""


def _where(found):
    place = f"At {found.point()}" if found.values else "As it stands"
    if isinstance(found.lhs, Undefined):
        return f"{place} your formula has no value ({found.lhs})."
    return f"{place} your formula is {shown(found.lhs)}, and that is not right."


# ---- The form that is asked for


def is_expanded(formula):
    """Whether nothing is left to multiply out.

    >>> from bezteach.symbolic import t
    >>> is_expanded(t**2 - 2 * t), is_expanded(t * (t - 2))
    (True, False)
    """
    return expand(formula) == formula


def is_factored(formula):
    """Whether a polynomial with numbers for coefficients is a product of factors that have none themselves.

    >>> from bezteach.symbolic import t
    >>> is_factored(t * (t - 2)), is_factored(t**2 - 2 * t), is_factored(3 * (1 - t) ** 2), is_factored(t**2 + 1)
    (True, False, True, True)
    >>> is_factored(B(0, 2, t))
    False
    """
    bases = [part.base if isinstance(part, Pow) and part.exp.is_Integer else part for part in Mul.make_args(formula)]
    try:
        return all(base.is_number or (not base.has(B) and Poly(base).is_irreducible) for base in bases)
    except PolynomialError:
        return False


def is_bernstein(formula, n, t):
    """Whether it is a combination of the B_{0,n}(t), ..., B_{n,n}(t), with coefficients without t.

    >>> from bezteach.symbolic import t
    >>> is_bernstein(2 * B(0, 2, t) - B(1, 2, t) / 3, 2, t), is_bernstein(t * B(0, 2, t), 2, t), is_bernstein(t, 2, t)
    (True, False, False)
    """
    basis = {part: Dummy() for part in formula.atoms(B) if part.args[1:] == (Integer(n), t)}
    terms = Add.make_args(expand(formula.xreplace(basis)))
    places = {*basis.values()}
    return all(len(term.free_symbols & places) == 1 and _linear(term, places, t) for term in terms)


def _linear(term, places, t):
    (place,) = term.free_symbols & places
    factor = term / place
    return not factor.has(t) and not factor.free_symbols & places
