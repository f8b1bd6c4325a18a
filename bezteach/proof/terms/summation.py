"""One term summed: by the binomial theorem, the one lemma of the operator form, or a difference that telescopes.

What is summed over k is brought to x^(k-s) y^(m-k) / ((k-s)! (m-k)!) times what does not hold k. From k = s to k = m
that sums to (x + y)^(m-s) / (m-s)!. A polynomial in k in front is first written in falling factorials, which the
factorial of k - s absorbs. Where the sum begins after s or stops before m by a few terms, these are taken off again.
"""

from sympy import Mul, Poly, PolynomialError, S, expand, fraction

from bezteach.symbolic import E

from .edges import need, never
from .linear import least
from .size import cancelled
from .terms import Failure, Term, factorial_of, power_of, times

MOST_FACTORS = 100  # between two factorials, which are multiplied out
FEW = 12  # summands up to which a sum of a fixed length is written out


def closed_term(term, k, low, high, conditions):
    """The terms that a term, valid from low to high, sums to over this range, which is not empty."""
    rising, falling, fixed = {}, {}, {}
    for form, exponent in term.factorials.items():
        slope = form.coeff(k)
        if slope not in (0, 1, -1):
            raise Failure(f"{form}! holds a multiple of {k}")
        {0: fixed, 1: rising, -1: falling}[int(slope)][form] = exponent
    if not rising and not falling:
        return _telescoped(term, k, low, high, conditions)
    lower, above = _single(rising)
    upper, below = _single(falling)
    coefficient, lower, upper = _absorbed(cancelled(term.coefficient * above * below), lower, upper, k)
    numerator, denominator = fraction(coefficient)
    start, end = expand(k - lower), expand(k + upper)
    results = []
    for order, factor in enumerate(_in_falling_factorials(numerator, k, start)):
        if factor != 0:
            rest = Term(factor / denominator, fixed)
            results += _by_binomial_theorem(rest, term.powers, k, (start + order, end), (low, high), conditions)
    return results


def _single(factorials):
    """The one form under a factorial in the denominator, and the polynomial that is left beside it."""
    families = {}
    for form, exponent in factorials.items():
        families.setdefault(form - form.as_coeff_Add()[0], {})[form] = exponent
    chosen, rest = None, S.One
    for family in families.values():
        total, highest = sum(family.values()), max(family, key=lambda form: form.as_coeff_Add()[0])
        if total == -1 and chosen is None:
            chosen = highest
        elif total != 0:
            raise Failure("the factorials do not fit the binomial theorem")
        if max(highest - form for form in family) > MOST_FACTORS:
            raise Failure("the factorials lie too far apart")
        for form, exponent in family.items():
            product = Mul(*[form + step for step in range(1, int(highest - form) + 1)])
            rest *= product**-exponent
    if chosen is None:
        raise Failure("no factorial bounds the sum")
    return chosen, rest


def _absorbed(coefficient, lower, upper, k):
    """Divisors of the coefficient that hold k go into the factorials: 1/(form! (form + 1)) is 1/(form + 1)!."""
    for _ in range(FEW):
        divisor = fraction(coefficient)[1]
        if not divisor.has(k):
            return coefficient, lower, upper
        for form in (lower, upper):
            if expand(divisor.subs(k, k - (form + 1) / form.coeff(k))) == 0:
                break
        else:
            raise Failure(f"{divisor} divides what is summed")
        coefficient = cancelled(coefficient * (form + 1))
        lower, upper = (lower + 1, upper) if form is lower else (lower, upper + 1)
    raise Failure(f"{divisor} divides what is summed")


def _in_falling_factorials(polynomial, k, start):
    """The coefficients of a polynomial in k before 1, (k-s), (k-s)(k-s-1), ..."""
    try:
        rest = Poly(polynomial, k)
    except PolynomialError:
        raise Failure(f"{polynomial} is no polynomial in {k}") from None
    found, order = [], 0
    while not rest.is_zero:
        rest, remainder = rest.div(Poly(k - start - order, k))
        found.append(remainder.as_expr())
        order += 1
    return found


def _by_binomial_theorem(rest, powers, k, natural, given, conditions):
    """The sum of rest * powers / ((k - begin)! (end - k)!) over the given range of k, which is not empty."""
    (begin, end), (low, high) = natural, given
    length = expand(end - begin)
    if never(length, conditions):
        return []
    missing = _missing(begin, low, conditions) + _missing(high + 1, end + 1, conditions)
    need(length, conditions)
    results = _whole(rest, powers, k, begin, end, length, conditions)
    for value in missing:
        if never(value - begin, conditions) or never(end - value, conditions):
            continue
        need(value - begin, conditions)
        need(end - value, conditions)
        term = times(_at(value, powers, k, conditions), factorial_of(value - begin, -1))
        term = times(times(rest, term), factorial_of(end - value, -1))
        results.append(term._replace(coefficient=-term.coefficient))
    return results


def _missing(first, after, conditions):
    """The values of k from first to the one before ``after``, of which there must be few."""
    if least(first - after, conditions) >= 0:
        return []
    count = expand(after - first)
    if not count.is_Integer or count > FEW:
        raise Failure(f"what is summed is not 0 from {first} to before {after}")
    return [expand(first + step) for step in range(int(count))]


def _at(value, powers, k, conditions):
    """The powers at a value of k outside the range of the sum, where none may divide by what can be 0."""
    result = Term()
    for base, exponent in powers.items():
        exponent = expand(exponent.subs(k, value))
        if base != E and not base.is_number:
            need(exponent, conditions)
        result = times(result, power_of(base, exponent))
    return result


def _whole(rest, powers, k, begin, end, length, conditions):
    """The sum from begin to end, by the binomial theorem."""
    x, y = S.One, S.One
    for base, exponent in powers.items():
        slope = _slope(base, exponent, k)
        rest = times(rest, power_of(base, exponent.subs(k, begin if slope >= 0 else end)))
        x, y = (x * base**slope, y) if slope > 0 else (x, y * base**-slope)
    total = expand(x + y)
    rest = times(rest, factorial_of(length, -1))
    if total == 0:
        if never(length - 1, conditions):
            return [rest]
        need(length - 1, conditions)
        return []
    return [times(rest, power_of(total, length))]


def _slope(base, exponent, k):
    slope = expand(exponent).coeff(k)
    if not slope.is_Integer or expand(exponent - slope * k).has(k):
        raise Failure(f"the exponent of {base} is not linear in {k}")
    return slope


def _telescoped(term, k, low, high, conditions):
    """The sum of differences of neighbouring points, (E - 1) E^k, is what is behind the last less the first; and the
    sum of equal terms is one of them times their number.
    """
    ratio = Mul(*[base ** _slope(base, exponent, k) for base, exponent in term.powers.items()])
    if ratio == 1 and not term.coefficient.has(k):
        return [times(term, Term(expand(high - low + 1)))]
    quotient = cancelled(term.coefficient / (ratio - 1)) if ratio.has(E) else term.coefficient
    if not ratio.has(E) or quotient.has(k) or fraction(quotient)[1].has(E):
        raise Failure("no factorial bounds the sum, and it does not telescope")
    rest = Term(quotient, term.factorials)
    last, first = (times(rest, _at(value, term.powers, k, conditions)) for value in (high + 1, low))
    return [last, first._replace(coefficient=-first.coefficient)]
