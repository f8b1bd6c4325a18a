"""A rational function times binomial coefficients as a product that has a value where the rational function has none.

C(n, k)/(n + 1 - k) has none at k = n + 1; C(n + 1, k)/(n + 1) is the same for every other k, and is 1/(n + 1) there.
Whether that is the value that is needed, the proof decides in which it is put.
"""

from sympy import Mul, Poly, Pow, S, binomial, cancel, fraction


def absorbed(rational, term, k):
    """The rational function times the term; its factors that hold k go into the binomial coefficients where they fit.

    >>> from sympy import binomial
    >>> from sympy.abc import k, n
    >>> absorbed(k / (n + 1 - k), binomial(n, k), k)
    k*binomial(n + 1, k)/(n + 1)
    >>> absorbed(n + 1 - k, 1 / binomial(n, k), k)
    (n + 1)/binomial(n + 1, k)
    """
    binomials, result = _taken_apart(term)
    for expr, exponent in zip(fraction(cancel(rational)), (1, -1), strict=True):
        content, factors = Poly(expr, k).factor_list()
        result *= content**exponent
        for factor in [part.as_expr() for part, times in factors for _ in range(times)]:
            binomials, front = _into(binomials, factor, k, exponent)
            result *= front
    return result * Mul(*[Pow(binomial(top, bottom), sign) for top, bottom, sign in binomials])


def _taken_apart(term):
    """(top, bottom, 1 or -1) of each binomial coefficient of a product, and the rest of it."""
    binomials, rest = [], S.One
    for part in Mul.make_args(term):
        base, exponent = part.as_base_exp()
        if isinstance(base, binomial) and exponent.is_Integer:
            binomials += [(*base.args, 1 if exponent > 0 else -1)] * abs(int(exponent))
        else:
            rest *= part
    return binomials, rest


def _into(binomials, factor, k, exponent):
    """The binomial coefficients that are left when one takes up the factor, and what stands in front then."""
    for place, (top, bottom, sign) in enumerate(binomials):
        for other_factor, other, front in _neighbours(top, bottom, sign, exponent):
            share = cancel(factor / other_factor) if other_factor != 0 else S.Zero
            if share != 0 and not share.has(k):
                return [*binomials[:place], (*other, sign), *binomials[place + 1 :]], front * share**exponent
    return binomials, factor**exponent


def _neighbours(top, bottom, sign, exponent):
    """(d, other, c) with d^exponent C^sign = c C(other)^sign, where the new one has values at more places."""
    if exponent == -sign:  # C/d, or d/C
        yield top - bottom + 1, (top + 1, bottom), (top + 1) ** exponent
        yield bottom + 1, (top + 1, bottom + 1), (top + 1) ** exponent
    elif sign < 0:  # 1/(C d)
        yield top - bottom, (top - 1, bottom), 1 / top
        yield bottom, (top - 1, bottom - 1), 1 / top
