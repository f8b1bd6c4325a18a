"""Derivatives, integrals and values at a point, term by term, in a real variable."""

from sympy import Integral, S, Subs, expand

from .edges import need, never
from .size import MOST, MOST_TERMS
from .terms import Failure, Term, factorial_of, power_of, times


def check_real(terms, variable):
    """``Failure`` where a variable stands in an exponent or under a factorial: a whole number, and no real one."""
    for term in terms:
        if any(form.has(variable) for form in (*term.factorials, *term.powers.values())):
            raise Failure(f"{variable} stands where a whole number must stand")


def derivative(terms, variable, count, conditions):
    """The derivative of a sum of terms; a symbolic number of times for one power of a base linear in the variable."""
    check_real(terms, variable)
    if not count.is_Integer:
        return [_often(term, variable, count, conditions) for term in terms]
    work = 0
    for _ in range(int(count)):
        terms = [derived for term in terms for derived in _once(term, variable, conditions)]
        work += sum(term.coefficient.count_ops() for term in terms)
        if len(terms) > MOST_TERMS or work > MOST:
            raise Failure("a derivative with too many terms")
    return terms


def _once(term, variable, conditions):
    slope = term.coefficient.diff(variable)
    results = [term._replace(coefficient=slope)] if slope != 0 else []
    for base, exponent in term.powers.items():
        if base.has(variable):
            if exponent.is_Integer is not True:
                need(exponent - 1, conditions)
            lowered = times(term, power_of(base, S.NegativeOne))
            results.append(lowered._replace(coefficient=lowered.coefficient * exponent * base.diff(variable)))
    return results


def _often(term, variable, count, conditions):
    """n!/(n-r)! times the slope to the power r times base^(n-r), for the r-th derivative of base^n."""
    bases = [base for base in term.powers if base.has(variable)]
    if len(bases) != 1 or term.coefficient.has(variable):
        raise Failure("only a single power is differentiated a symbolic number of times")
    (base,) = bases
    slope, exponent = expand(base.diff(variable)), term.powers[base]
    if slope.has(variable):
        raise Failure(f"{base} is not linear in {variable}")
    need(exponent - count, conditions)
    for factor in (
        factorial_of(exponent),
        factorial_of(exponent - count, -1),
        power_of(slope, count),
        power_of(base, -count),
    ):
        term = times(term, factor)
    return term


def at_point(terms, variable, value, conditions):
    """The terms with a value put in for a real variable."""
    check_real(terms, variable)
    if any(form.has(Integral, Subs) for term in terms for form in (term.coefficient, *term.powers)):
        raise Failure("a letter is bound inside")  # SymPy would bind there what is free in the value, too
    results = []
    for term in terms:
        kept = {base: exponent for base, exponent in term.powers.items() if not base.has(variable)}
        moved = {base: exponent for base, exponent in term.powers.items() if base.has(variable)}
        rest = Term(term.coefficient.subs(variable, value), term.factorials, kept)
        powers = [(base.subs(variable, value), exponent) for base, exponent in moved.items()]
        results += _times_powers(rest, powers, conditions)
    return results


def _times_powers(term, powers, conditions):
    """A term times powers with exponents >= 0; a power of 0 is 0 but for the exponent 0, which is an edge."""
    for base, exponent in powers:
        base = expand(base)
        if base == 0:
            if never(exponent - 1, conditions):
                need(exponent, conditions)
                continue
            need(exponent - 1, conditions)
            return []
        term = times(term, power_of(base, exponent))
    return [term]


def integral(terms, variable, conditions):
    """Powers of t and 1 - t from 0 to 1, by Euler's Beta integral: p! q! / (p + q + 1)!."""
    check_real(terms, variable)
    return [_beta(term, variable, conditions) for term in terms]


def _beta(term, variable, conditions):
    bases = {base for base in term.powers if base.has(variable)}
    if term.coefficient.has(variable) or not bases <= {variable, expand(1 - variable)}:
        raise Failure("it is no Beta integral")
    p, q = term.powers.get(variable, S.Zero), term.powers.get(expand(1 - variable), S.Zero)
    need(p, conditions)
    need(q, conditions)
    rest = term._replace(powers={base: exponent for base, exponent in term.powers.items() if base not in bases})
    for part in (factorial_of(p), factorial_of(q), factorial_of(p + q + 1, -1)):
        rest = times(rest, part)
    return rest
