"""Sums closed by the binomial theorem, the one lemma of the operator form.

What is summed over k is brought to x^(k-s) y^(m-k) / ((k-s)! (m-k)!) times what does not hold k. From k = s to k = m
that sums to (x + y)^(m-s) / (m-s)!. A polynomial in k in front is first written in falling factorials, which the
factorial of k - s absorbs.
"""

from sympy import Add, Mul, Poly, PolynomialError, S, Sum, cancel, expand, fraction

from .linear import coefficients, least
from .normal import Edge, need, never, normal
from .terms import Failure, Term, factorial_of, power_of, times

FEW = 12  # summands up to which a sum of a fixed length is written out


def closed(expr, whole, conditions):
    """The terms of a Sum where the conditions hold; one over several indices is closed from the inside."""
    *inner, (k, low, high) = expr.limits
    function = Sum(expr.function, *inner) if inner else expr.function
    if never(high - low, conditions):
        return []
    need(high - low, conditions)
    length = expand(high - low)
    if length.is_Integer and length < FEW:
        summands = (function.subs(k, low + step) for step in range(int(length) + 1))
        return [term for summand in summands for term in normal(summand, whole, conditions)]
    parts = Add.make_args(expand(function, power_exp=False, power_base=False, log=False, basic=False))
    return [term for part in parts for term in _closed_part(part, k, low, high, whole, conditions)]


def _closed_part(part, k, low, high, whole, conditions):
    """The terms of a sum of one product; the ends where a binomial coefficient of it is 0 are cut off."""
    while True:
        if never(high - low, conditions):
            return []
        need(high - low, conditions)
        try:
            terms = normal(part, whole | {k}, [*conditions, k - low, high - k])
            break
        except Edge as edge:
            slope = coefficients(edge.form).get(k, S.Zero) if coefficients(edge.form) else S.Zero
            if slope == 0:
                raise
            if not edge.vanishing:
                raise Failure(str(edge)) from None
            if slope not in (1, -1):
                raise Failure(f"{edge.form} holds a multiple of {k}") from None
            end = expand(k - edge.form) if slope == 1 else expand(k + edge.form)
            need(end - low if slope == 1 else high - end, conditions)
            low, high = (end, high) if slope == 1 else (low, end)
    return [result for term in terms for result in _closed_term(term, k, low, high, conditions)]


def _closed_term(term, k, low, high, conditions):
    rising, falling, fixed = {}, {}, {}
    for form, exponent in term.factorials.items():
        slope = form.coeff(k)
        if slope not in (0, 1, -1):
            raise Failure(f"{form}! holds a multiple of {k}")
        {0: fixed, 1: rising, -1: falling}[int(slope)][form] = exponent
    lower, above = _single(rising)
    upper, below = _single(falling)
    start, end = k - lower, k + upper
    numerator, denominator = fraction(cancel(term.coefficient * above * below))
    if denominator.has(k):
        raise Failure(f"{denominator} divides what is summed")
    if least(high - end, conditions) < 0:
        raise Failure(f"the sum stops at {high}, before {end}")
    results = []
    for order, factor in enumerate(_in_falling_factorials(numerator, k, start)):
        if factor == 0:
            continue
        begin = start + order
        if least(begin - low, conditions) < 0:
            raise Failure(f"the sum begins at {low}, after {begin}")
        length = expand(end - begin)
        if never(length, conditions):
            continue
        need(length, conditions)
        rest = Term(factor / denominator, dict(fixed))
        results += _by_binomial_theorem(rest, term.powers, k, begin, end, length, conditions)
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
        for form, exponent in family.items():
            product = Mul(*[form + step for step in range(1, int(highest - form) + 1)])
            rest *= product**-exponent
    if chosen is None:
        raise Failure("no factorial bounds the sum")
    return chosen, rest


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


def _by_binomial_theorem(rest, powers, k, begin, end, length, conditions):
    x, y = S.One, S.One
    for base, exponent in powers.items():
        slope = expand(exponent).coeff(k)
        if not slope.is_Integer or expand(exponent - slope * k).has(k):
            raise Failure(f"the exponent of {base} is not linear in {k}")
        rest = times(rest, power_of(base, exponent.subs(k, begin if slope >= 0 else end)))
        x, y = (x * base**slope, y) if slope > 0 else (x, y * base**-slope)
    whole = expand(x + y)
    rest = times(rest, factorial_of(length, -1))
    if whole == 0:
        if least(length, conditions) >= 1:
            return []
        raise Failure("a power of 0 whose exponent may be 0")
    return [times(rest, power_of(whole, length))]
