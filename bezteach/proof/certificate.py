"""What a prover leaves behind: the little that is needed to check its proof again without the search that found it.

Nothing in a certificate is believed. ``replay`` derives from the statement what each entry must be, and checks it.
"""

from typing import NamedTuple

from sympy import Expr, Symbol

from .terms.terms import Term


class Part(NamedTuple):
    """A part of the range: each symbol has its value, one put in after the other, and the forms are >= 0."""

    values: tuple[tuple[Symbol, Expr], ...] = ()
    where: tuple[Expr, ...] = ()

    def also(self, form):
        """The part of it where this form is >= 0 too."""
        return self._replace(where=(*self.where, form))

    def with_value(self, symbol, at):
        """The part of it where a symbol has this value."""
        where = tuple(form.subs(symbol, at).expand() for form in self.where)
        return Part((*self.values, (symbol, at)), where)


class Group(NamedTuple):
    """Terms whose quotients are rational: what they share, and the rational function that is left of each."""

    shared: Term
    rests: tuple[Expr, ...]


class TermsCase(NamedTuple):
    """The difference of both sides on a part of the range, as groups of terms."""

    part: Part
    groups: tuple[Group, ...]


class ByTerms(NamedTuple):
    """The difference is 0 in each case, and the cases cover the range."""

    cases: tuple[TermsCase, ...]


class Lemma(NamedTuple):
    """A statement on which a proof rests, and its own ``Proof``."""

    statement: object
    proof: object


class ByInduction(NamedTuple):
    """It holds at the end of the range of the symbol, and what both sides gain by one step is the same."""

    symbol: Symbol
    upward: bool
    first: Lemma
    step: Lemma


class ByTelescoping(NamedTuple):
    """p S(n+1) - q S(n) telescopes: what is summed is G(k+1) - G(k). Lemmas: that, its ends, R, the first case."""

    symbol: Symbol
    p: Expr
    q: Expr
    telescope: Expr
    lemmas: tuple[Lemma, ...]


class ByCases(NamedTuple):
    """Every value of the integer symbols, with the values of both sides there, polynomials in the real symbols."""

    cases: tuple[tuple, ...]


class SignsCase(NamedTuple):
    """An expression on a part of the range as a product of factors whose signs are known; factorials are left out."""

    part: Part
    shared: Term
    factors: tuple[tuple[Expr, frozenset], ...]


class BySigns(NamedTuple):
    """The larger side minus the smaller one, plus 1 if it is a whole number that only has to be > -1."""

    plus: int
    cases: tuple[SignsCase, ...]


class ByBounds(NamedTuple):
    """Each part of the difference with the interval in which it lies; ``unity`` is that the basis sums to 1."""

    bounds: tuple[tuple, ...]
    unity: Lemma | None


class ByPartOfSum(NamedTuple):
    """The smaller side is the sum of the larger one's terms from first to last."""

    first: Expr
    last: Expr


class ByPeak(NamedTuple):
    """One side is a product of powers of bases > 0 that hold t; its logarithmic derivative has the one root."""

    symbol: Symbol
    powers: tuple[tuple[Expr, Expr], ...]
    peak: Expr


class ByGrowth(NamedTuple):
    """One side is multiplied by the ratio from n to n + 1; the other grows no faster. Both parts by signs."""

    symbol: Symbol
    start: Expr
    larger: bool
    ratio: Expr
    first: tuple[SignsCase, ...]
    gap: tuple[SignsCase, ...]


class Through(NamedTuple):
    """Two proved equations that have a side in common."""

    verdicts: tuple
