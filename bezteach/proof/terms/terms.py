"""Hypergeometric terms in a normal form in which the quotient of two of them is a rational function.

A term is a rational function times factorials of linear forms in the integer symbols times powers of bases that hold
none of them. It stands for its value where every form under a factorial is >= 0.
"""

from collections import defaultdict
from typing import NamedTuple

from sympy import Add, Expr, Integer, Mul, Pow, S, expand, factorial

from .failure import Failure
from .linear import coefficients
from .size import LARGEST, cancelled


class Term(NamedTuple):
    """coefficient * product of form!^exponent * product of base^exponent, as {form: exponent} and {base: exponent}."""

    coefficient: Expr = S.One
    factorials: dict = {}
    powers: dict = {}


def times(one, other):
    """The product of two terms."""
    return Term(
        one.coefficient * other.coefficient,
        _merged(one.factorials, other.factorials),
        _merged(one.powers, other.powers),
    )


def inverse(term):
    """One over a term; it assumes that the term is not 0."""
    return Term(
        1 / term.coefficient,
        {form: -exponent for form, exponent in term.factorials.items()},
        {base: -exponent for base, exponent in term.powers.items()},
    )


def _merged(one, other):
    total = defaultdict(lambda: S.Zero)
    for part in (one, other):
        for key, exponent in part.items():
            total[key] = expand(total[key] + exponent)
    return {key: exponent for key, exponent in total.items() if exponent != 0}


def factorial_of(form, exponent=1):
    form = expand(form)
    if form.is_Integer and form > LARGEST:
        raise Failure(f"{form}! is too large")
    if form.is_Integer and form >= 0:
        return Term(factorial(form) ** exponent)
    return Term(factorials={form: Integer(exponent)})


def binomial_of(top, bottom):
    """The binomial coefficient as factorials, for 0 <= bottom <= top."""
    return times(factorial_of(top), times(factorial_of(bottom, -1), factorial_of(top - bottom, -1)))


def power_of(base, exponent):
    """base^exponent for a base without integer symbols: products, quotients and signs taken apart."""
    base, exponent = expand(base), expand(exponent)
    if base == 1 or exponent == 0:
        return Term()
    if base.is_Mul:
        result = Term()
        for factor in base.args:
            result = times(result, power_of(factor, exponent))
        return result
    if base.is_Pow and base.exp.is_Integer:
        return power_of(base.base, base.exp * exponent)
    if base.is_Rational and base.q != 1:
        return times(power_of(Integer(base.p), exponent), power_of(Integer(base.q), -exponent))
    if base.is_Rational and base < 0 and base != -1:
        return times(power_of(S.NegativeOne, exponent), power_of(-base, exponent))
    if base.is_Add and base.as_coeff_Add()[0].is_negative:
        return times(power_of(S.NegativeOne, exponent), power_of(Add(*[-part for part in base.args]), exponent))
    if base == -1:
        exponent = Add(*[c % 2 * s for s, c in coefficients(exponent).items()]) if coefficients(exponent) else exponent
    return Term(powers={base: exponent}) if exponent != 0 else Term()


def common_part(terms):
    """The part that all terms share, and the rational function left of each; ``Failure`` if they differ in more.

    Factors (form + k) from quotients of factorials are >= 1 where the terms are valid, so nothing is divided by 0.
    """
    shared_factorials, shared_powers, left = {}, {}, [[term.coefficient] for term in terms]
    for family in _families(terms):
        lowest = min(family, key=lambda form: form.as_coeff_Add()[0])
        totals = {sum(term.factorials.get(form, 0) for form in family) for term in terms}
        if len(totals) > 1:
            raise Failure("the terms hold different numbers of factorials")
        shared_factorials[lowest] = totals.pop()
        for factors, term in zip(left, terms, strict=True):
            factors += [_rising(lowest, form) ** term.factorials.get(form, 0) for form in family]
    for base in dict.fromkeys(base for term in terms for base in term.powers):
        exponents = [term.powers.get(base, S.Zero) for term in terms]
        gaps = [expand(exponent - exponents[0]) for exponent in exponents]
        if not all(gap.is_Integer for gap in gaps):
            raise Failure(f"the exponents of {base} differ by more than a number")
        smallest = min(gaps)
        shared_powers[base] = expand(exponents[0] + smallest)
        for factors, gap in zip(left, gaps, strict=True):
            factors.append(base ** (gap - smallest))
    return Term(S.One, shared_factorials, shared_powers), [Mul(*factors) for factors in left]


def _families(terms):
    """The forms under factorials, grouped by what they are without their constants."""
    families = defaultdict(dict)  # in their order, which a set would not keep
    for term in terms:
        for form in term.factorials:
            families[form - form.as_coeff_Add()[0]][form] = None
    return families.values()


def _rising(lowest, form):
    """form! / lowest!, a product; ``Failure`` if it is too long."""
    if form - lowest > LARGEST:
        raise Failure(f"{form}! and {lowest}! are too far apart")
    return Mul(*[lowest + k for k in range(1, int(form - lowest) + 1)])


def joined(terms):
    """The same sum with those terms added up whose quotients are rational.

    Factorials below stand with their highest form, so that what is above them may cancel what divides.

    >>> from bezteach.symbolic import i, n
    >>> joined([binomial_of(n, i), binomial_of(n, i + 1)]) == [times(Term(n + 1), Term(S.One,
    ...     {n: S.One, i + 1: -S.One, n - i: -S.One}))]
    True
    """
    results = []
    for group in alike(terms):
        if len(group) == 1:
            results += group
            continue
        shared, rests = common_part(group)
        highest, factor = _highest(shared.factorials, group)
        total = cancelled(Add(*rests) * factor)
        if total != 0:
            results.append(times(Term(total), shared._replace(factorials=highest)))
    return results


def alike(terms):
    """The terms in groups whose quotients are rational."""
    groups = []
    for term in terms:
        for group in groups:
            try:
                common_part([group[0], term])
            except Failure:
                continue
            group.append(term)
            break
        else:
            groups.append([term])
    return groups


def _highest(factorials, terms):
    """The factorials below written with the highest form of their family, and what makes up for it."""
    found, factor = {}, S.One
    families = {min(family, key=lambda form: form.as_coeff_Add()[0]): family for family in _families(terms)}
    for lowest, exponent in factorials.items():
        form = max(families[lowest], key=lambda form: form.as_coeff_Add()[0]) if exponent < 0 else lowest
        factor *= _rising(lowest, form) ** -exponent
        found[form] = exponent
    return found, factor


def written(term):
    """A term as a SymPy expression, for a reader."""
    parts = [factorial(form) ** exponent for form, exponent in term.factorials.items()]
    return Mul(term.coefficient, *parts, *[Pow(base, exponent) for base, exponent in term.powers.items()])
