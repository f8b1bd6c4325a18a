"""Which signs can an expression have, for all integers and reals of a region? Exact, and never too few.

The answer is a set of signs out of -1, 0, 1. What is known of a rational function comes from ``polynomial_signs``.
"""

from typing import NamedTuple

from sympy import Add, Dummy, Integral, Interval, Mul, Pow, S, Sum, binomial, factorial

from bezteach.symbolic import B

from ..terms.linear import coefficients, is_whole_form, least
from .polynomial_signs import is_rational, of_form, of_rational
from .sign_sets import ANY, POSITIVE, ZERO, product, total


class Region(NamedTuple):
    """Integer symbols, linear forms in them that are >= 0, and the real symbols with intervals of rational ends."""

    whole: frozenset
    conditions: tuple
    reals: dict

    def where(self, *forms):
        """The part where these forms are >= 0 too."""
        return self._replace(conditions=(*self.conditions, *forms))

    def holds(self, form):
        """Whether an integer form is >= 0 everywhere."""
        return least(form, self.conditions) >= 0


def signs(expr, region):
    """The signs that a value may have; where the expression is not defined, that says nothing.

    >>> from bezteach.symbolic import i, n, t
    >>> unit = Region(frozenset({i, n}), (i, n - i), {t: Interval(0, 1)})
    >>> signs(B(i, n, t), unit) == {0, 1}, signs(i - n, unit) == {-1, 0}, signs(t**2 - t + 1, unit) == {1}
    (True, True, True)
    """
    found = of_rational(expr, region) if is_rational(expr) else ANY
    for kind, rule in _RULES.items():
        if isinstance(expr, kind):
            found &= rule(expr, region)
    return found or ANY  # none at all: the region is empty


def of_power(base, exponent, region):
    """With 0**0 = 1, and 0 to a negative power undefined."""
    form, below = coefficients(exponent), signs(base, region)
    if not is_whole_form(exponent) or not exponent.free_symbols <= region.whole:
        return ANY
    above = of_form(exponent, region)
    if 0 in below and -1 in above:
        return ANY
    even = all(c % 2 == 0 for symbol, c in form.items() if symbol != 1)
    result = {1} if 1 in below else set()
    if -1 in below:
        result |= {-1 if form[S.One] % 2 else 1} if even else {-1, 1}
    if 0 in below:
        result |= {1 - sign for sign in above}
    return frozenset(result)


def _of_basis(expr, region):
    i, n, x = expr.args
    inside = region.where(i, n - i)
    found = product(of_power(x, i, inside), of_power(1 - x, n - i, inside))
    return _unless_outside(found, i, n, region)


def _unless_outside(found, i, n, region):
    """What is 0 unless 0 <= i <= n."""
    if not region.holds(n):
        return ANY
    if region.holds(-i - 1) or region.holds(i - n - 1):
        return ZERO
    return found if region.holds(i) and region.holds(n - i) else found | ZERO


def _of_binomial(expr, region):
    top, bottom = expr.args
    return _unless_outside(POSITIVE, bottom, top, region)


def _of_factorial(expr, region):
    return POSITIVE if region.holds(expr.args[0]) else ANY


def _of_binder(expr, region):
    opened = unbound(expr, region)
    if opened is None:
        return ANY
    body, inside = opened
    if isinstance(expr, Integral):
        return _many(signs(body, inside))
    *_, (_, low, high) = expr.limits
    if region.holds(low - high - 1):
        return ZERO
    found = _many(signs(body, inside))
    return found if region.holds(high - low) else found | ZERO


def _many(term):
    """The signs of a sum of one or more terms of one kind."""
    return total([term, term]) if len(term) > 1 else term


def unbound(expr, region):
    """What a Sum, or an Integral between numbers, is taken of, and the region where; None for another Integral."""
    *inner, (variable, low, high) = expr.limits
    body = expr.func(expr.function, *inner) if inner else expr.function
    known = region.whole | region.reals.keys() | set().union(*(form.free_symbols for form in region.conditions))
    if isinstance(expr, Sum):
        letter = Dummy(variable.name, integer=True) if variable in known else variable
        inside = region._replace(whole=region.whole | {letter}).where(letter - low, high - letter)
    elif low.is_Rational and high.is_Rational and low < high:
        letter = Dummy(variable.name, real=True) if variable in known else variable
        inside = region._replace(reals=region.reals | {letter: Interval.open(low, high)})
    else:
        return None
    return body.xreplace({variable: letter}), inside


_RULES = {
    Add: lambda expr, region: total(signs(part, region) for part in expr.args),
    Mul: lambda expr, region: product(*(signs(part, region) for part in expr.args)),
    Pow: lambda expr, region: of_power(*expr.as_base_exp(), region),
    B: _of_basis,
    binomial: _of_binomial,
    factorial: _of_factorial,
    Sum: _of_binder,
    Integral: _of_binder,
}
