"""The greatest value of a product of powers, such as B(i, n, t), as a function of one real symbol."""

from sympy import (
    Add,
    Derivative,
    Expr,
    Ge,
    Integer,
    Interval,
    Le,
    Mul,
    Poly,
    Pow,
    S,
    cancel,
    expand,
    fraction,
    together,
)

from bezteach.symbolic import Step

from ..certificate import ByPeak
from ..terms.size import check_size
from ..terms.terms import Failure
from .factors import one_term
from .polynomial_signs import is_rational
from .sign_of import of_power, signs
from .sign_sets import NOT_NEGATIVE, POSITIVE, product


def by_peak(claim):
    """A product of powers, as a function of t, against its own value at the root of its logarithmic derivative."""
    left, right = claim.small.free_symbols, claim.large.free_symbols
    if not (turning := (left ^ right) & claim.region.reals.keys()):
        raise Failure("no real symbol on one side alone")
    t = min(turning, key=str)
    powers, _ = _powers_of(t, sides_of(claim, t)[0], _inside(claim, t))
    peak = _root(t, powers)
    certificate = ByPeak(t, tuple(powers.items()), peak)
    check_peak(claim, certificate)
    return certificate


def sides_of(claim, t):
    """The side that holds t, the other one, and 1 if the first shall be the smaller one, else -1."""
    found = [t in side.free_symbols for side in (claim.small, claim.large)]
    if sum(found) != 1:
        raise Failure(f"{t} is not on one side alone")
    return (claim.small, claim.large, 1) if found[0] else (claim.large, claim.small, -1)


def _inside(claim, t):
    interval = claim.region.reals.get(t, S.EmptySet).interior
    if not isinstance(interval, Interval):
        raise Failure(f"{t} has no interval")
    return claim.region._replace(reals=claim.region.reals | {t: interval})


def _numerator(t, powers):
    """That of the logarithmic derivative: each power p^e contributes e p'/p."""
    return expand(Add(*[e * base.diff(t) * Mul(*[p for p in powers if p != base]) for base, e in powers.items()]))


def _root(t, powers):
    rest = _numerator(t, powers)
    if Poly(rest, t).degree() != 1:
        raise Failure("the logarithmic derivative has not one root")
    return cancel(-rest.coeff(t, 0) / rest.coeff(t, 1))


def check_peak(claim, certificate):
    """``Failure`` unless the powers are those of the one side, and it turns at the peak, within the interval."""
    t, recorded, peak = certificate
    changing, fixed, sense = sides_of(claim, t)
    inside = _inside(claim, t)
    powers, front = _powers_of(t, changing, inside)
    rest = _numerator(t, powers)
    if claim.strict or powers != dict(recorded) or len(powers) != len(recorded) or Poly(rest, t).degree() != 1:
        raise Failure("the powers are not those of the side, or their derivative has not one root")
    turn = signs(rest.coeff(t, 1), inside)
    if turn not in (POSITIVE, frozenset({-1})) or not product(front, turn, frozenset({sense})) <= {-1, 0}:
        raise Failure("it does not turn from growing to falling")
    if cancel(rest.subs(t, peak)) != 0:
        raise Failure(f"{peak} is no root")
    if not all(signs(place.gts - place.lts, claim.region) <= NOT_NEGATIVE for place in _places(claim, t, peak)):
        raise Failure("the root is outside")
    if not _same(changing.subs(t, peak), fixed):
        raise Failure("not its value at the root")


def _places(claim, t, peak):
    """That the peak is not beyond the ends of the interval."""
    interval = claim.region.reals[t]
    places = [Ge(peak, interval.start, evaluate=False)] if interval.start.is_finite else []
    return places + ([Le(peak, interval.end, evaluate=False)] if interval.end.is_finite else [])


def peak_shown(claim, certificate):
    """The lines for a reader."""
    t, powers, peak = certificate
    changing, _, sense = sides_of(claim, t)
    yield Step(
        Mul(changing, _numerator(t, dict(powers)), Pow(Mul(*[base for base, _ in powers]), -1), evaluate=False),
        "inside the interval: each power p^e contributes e p'/p",
        Derivative(changing, t),
    )
    yield Step(peak, "the only root of the numerator", t)
    yield from (Step(place, "by the ranges") for place in _places(claim, t, peak))
    words = ("grows", "falls") if sense == 1 else ("falls", "grows")
    yield Step(
        Le(claim.small, claim.large, evaluate=False),
        f"it {words[0]} before the root and {words[1]} after it, as a polynomial in {t}, so continuous at the ends too",
    )


def _powers_of(t, expr, inside):
    """{base: exponent} of what holds t in one term, each base > 0 inside, and the signs of the rest."""
    term = one_term(expr, inside)
    numerator, denominator = fraction(together(term.coefficient))
    if denominator.has(t):
        raise Failure(f"{t} divides")
    check_size(numerator)
    content, factors = Poly(numerator, *sorted(numerator.free_symbols | {t}, key=str), domain="QQ").factor_list()
    powers = [(part.as_expr(), Integer(power)) for part, power in factors] + list(term.powers.items())
    front, found = product(signs(content, inside), signs(denominator, inside)), {}
    for base, exponent in powers:
        if not base.has(t):
            front = product(front, of_power(base, exponent, inside))
            continue
        if signs(base, inside) == {-1}:
            base, front = expand(-base), product(front, of_power(S.NegativeOne, exponent, inside))
        if signs(base, inside) != POSITIVE or not signs(exponent, inside) <= NOT_NEGATIVE:
            raise Failure(f"{base} may have either sign")
        found[base] = found.get(base, 0) + exponent
    return found, front


def _same(one, other):
    """Whether two expressions agree part by part, as rational functions."""
    if one == other:
        return True
    if isinstance(one, Expr) and isinstance(other, Expr) and is_rational(one - other):
        return cancel(one - other) == 0
    alike = one.func == other.func and len(one.args) == len(other.args) > 0
    return alike and all(_same(*pair) for pair in zip(one.args, other.args, strict=True))
