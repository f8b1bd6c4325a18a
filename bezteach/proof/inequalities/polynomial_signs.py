"""Which signs can a rational function of integers and reals have in a region?

What is known of an integer form comes from ``linear.least``, of a polynomial in one real symbol from counting its
roots, of any other polynomial from its Bernstein coefficients, or from what the conditions of the region say is >= 0.
"""

from functools import lru_cache
from itertools import combinations, islice
from math import comb, prod

from sympy import (
    Add,
    Dummy,
    Matrix,
    Poly,
    Rational,
    S,
    expand,
    fraction,
    oo,
    together,
)

from ..terms.linear import coefficients
from ..terms.size import degree
from .sign_sets import ANY, NOT_NEGATIVE, POSITIVE, ZERO, product, total

HIGHEST, MOST_SYMBOLS_TIMES_DEGREE, MOST_REALS = 40, 24, 2
MOST_CHOICES = 500  # of conditions that are taken for coordinates
MOST_POLYNOMIALS = 500  # coefficients of coefficients: each real symbol multiplies their number
LARGEST = 10**60  # of a number: SymPy's factoring takes minutes with hundreds of digits


def is_rational(expr):
    """Whether it is a rational function of its symbols, small enough to be taken apart."""
    highest, count = degree(expr), len(expr.free_symbols)
    if highest is None or any(max(abs(one.p), one.q) > LARGEST for one in expr.atoms(Rational)):
        return False
    return highest <= HIGHEST if count < 2 else highest * count <= MOST_SYMBOLS_TIMES_DEGREE


def of_rational(expr, region):
    if not expr.free_symbols <= region.whole | region.reals.keys():
        return ANY
    numerator, denominator = fraction(together(expr))
    below = _of_polynomial(denominator, region)
    return ANY if 0 in below else product(_of_polynomial(numerator, region), below)


def _of_polynomial(expr, region, most_reals=MOST_REALS):
    expr = expand(expr)
    if expr.is_Rational:
        return frozenset({(expr.p > 0) - (expr.p < 0)})
    content, factors = Poly(expr, *sorted(expr.free_symbols, key=str), domain="QQ").factor_list()
    found = [_of_polynomial(content, region)]
    for factor, times in factors:
        symbols = [symbol for symbol in factor.gens if factor.degree(symbol)]  # exclude() fails on python-flint
        factor = Poly(factor.as_expr(), *symbols, domain="QQ")
        once = _of_irreducible(factor.clear_denoms()[1], region, most_reals)
        found.append(frozenset(sign**times for sign in once))
    return product(*found)


def _of_irreducible(poly, region, most_reals):
    expr, reals = poly.as_expr(), [symbol for symbol in poly.gens if symbol in region.reals]
    if not reals:
        return of_form(expr, region) if poly.total_degree() == 1 else _by_slack(expr, region)
    if len(poly.gens) == 1:
        return _by_roots(poly, region.reals[poly.gen])
    result, tried = ANY, _reals_tried(poly, reals, region, most_reals)
    for symbol in sorted(reals, key=poly.degree)[:tried]:
        result &= _by_bernstein_coefficients(poly, symbol, region, tried)
    return result


def _reals_tried(poly, reals, region, most):
    """By how many of its real symbols a polynomial is taken apart, and each of its coefficients again: ``most`` or
    fewer, so that there are not too many coefficients in the end.
    """
    ends = [(region.reals[symbol].start, region.reals[symbol].end) for symbol in reals]
    counts = [(poly.degree(s) + 1) * (1 + (end == (-oo, oo))) for s, end in zip(reals, ends, strict=True)]
    return next((tried for tried in range(most, 0, -1) if prod(tried * c for c in counts) <= MOST_POLYNOMIALS), 0)


def of_form(form, region):
    """An integer form: each sign that the conditions do not exclude."""
    not_zero = region.holds(form - 1) or region.holds(-form - 1)
    excluded = {-1: region.holds(form), 0: not_zero, 1: region.holds(-form)}
    return frozenset(sign for sign in ANY if not excluded[sign])


@lru_cache(4096)  # many terms share few factors
def _by_roots(poly, interval):
    """An irreducible polynomial turns its sign at each root, and has no rational one unless it is linear."""
    low, high = interval.start, interval.end
    if low == high:
        return _of_polynomial(poly.eval(low), None)
    if poly.degree() == 1:
        root = -poly.nth(0) / poly.nth(1)
        turns, zero = low < root < high, root in interval
    else:
        turns = zero = poly.count_roots(*(None if end.is_infinite else end for end in (low, high))) > 0
    if turns:
        return ANY
    inner = (
        S.Zero if (low, high) == (-oo, oo) else high - 1 if low == -oo else low + 1 if high == oo else (low + high) / 2
    )
    return _of_polynomial(poly.eval(inner), None) | (ZERO if zero else frozenset())


def _by_bernstein_coefficients(poly, symbol, region, most_reals):
    """On [a, b] the polynomial is the sum of its coefficients times B's; on [a, oo) of others times powers of t - a."""
    interval, expr, s = region.reals[symbol], poly.as_expr(), Dummy("s")
    low, high = interval.start, interval.end
    if low == high:
        return _of_polynomial(expr.subs(symbol, low), region)

    def along(path):
        return Poly(expr.subs(symbol, path), s).all_coeffs()[::-1]

    if low.is_finite and high.is_finite:
        powers = along(low + (high - low) * s)
        degree = len(powers) - 1
        weights = [
            Add(*[Rational(comb(place, k), comb(degree, k)) * powers[k] for k in range(place + 1)])
            for place in range(degree + 1)
        ]
        found = _unless_any(weights, region, most_reals)
        at_ends = ([] if interval.left_open else [found[0]]) + ([] if interval.right_open else [found[-1]])
        return total(found).union(*at_ends)
    result = frozenset()
    start = low if low.is_finite else high if high.is_finite else S.Zero
    for direction in (1, -1):
        if (high if direction == 1 else low).is_infinite:
            found = _unless_any(along(start + direction * s), region, most_reals)
            result |= total(found) | (found[0] if start in interval else frozenset())
    return result


def _unless_any(polynomials, region, most_reals):
    """The signs of each; no more of them once their sum may have any sign."""
    found = []
    for polynomial in polynomials:
        found.append(_of_polynomial(polynomial, region, most_reals))
        if total(found) == ANY:
            return [ANY]
    return found


def _by_slack(expr, region):
    """An integer polynomial in what some of the conditions say is >= 0: all its coefficients may have one sign."""
    symbols, result = sorted(expr.free_symbols, key=str), ANY
    rows = [form for form in map(coefficients, region.conditions) if form and {s for s in form if s != 1} <= {*symbols}]
    for chosen in islice(combinations(rows, len(symbols)), MOST_CHOICES):
        matrix = Matrix([[row.get(symbol, 0) for symbol in symbols] for row in chosen])
        if matrix.det() == 0:
            continue
        slack = [Dummy() for _ in symbols]
        values = matrix.LUsolve(Matrix([s - row[S.One] for s, row in zip(slack, chosen, strict=True)]))
        poly = Poly(expr.subs(dict(zip(symbols, values, strict=True)), simultaneous=True), *slack)
        constant = poly.nth(*[0] * len(slack))
        if all(c >= 0 for c in poly.coeffs()):
            result &= POSITIVE if constant > 0 else NOT_NEGATIVE
        if all(c <= 0 for c in poly.coeffs()):
            result &= frozenset({-1} if constant < 0 else {-1, 0})
    return result
