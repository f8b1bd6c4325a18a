"""An expression as a sum of hypergeometric terms: basis functions written out, points as powers of E, sums closed.

The conditions are linear forms >= 0 in the integer symbols. Where a step needs another form to be >= 0 and the
conditions do not give it, ``Edge`` asks the caller to look at the finitely many other cases apart.
"""

from sympy import Add, Derivative, Dummy, Indexed, Integral, Mul, Pow, S, Subs, Sum, binomial, expand, factorial

from bezteach.symbolic import B, E

from .linear import least
from .terms import Failure, Term, binomial_of, factorial_of, inverse, power_of, times

# b[k] is E^k times this: without it b[0] would be the number 1.
POINT = Dummy("point")


MOST_TERMS = 400
_TAKEN_APART = (Sum, Integral, Derivative, Subs, Indexed, B)


class Edge(Exception):
    """The form may be negative, and it matters where it is; ``vanishing`` if a binomial coefficient is 0 there."""

    def __init__(self, form, vanishing):
        super().__init__(f"{form} may be negative")
        self.form, self.vanishing = form, vanishing


def need(form, conditions, vanishing=False):
    """Go on where a form is >= 0: return if it always is, raise ``Failure`` if it never is, else ``Edge``."""
    if least(form, conditions) >= 0:
        return
    if never(form, conditions):
        raise Failure(f"{form} is negative")
    raise Edge(expand(form), vanishing)


def never(form, conditions):
    """Whether the conditions make a form negative."""
    return least(-form - 1, conditions) >= 0


def normal(expr, whole, conditions):
    """The terms whose sum an expression is where the conditions hold; ``whole`` holds its integer symbols."""
    if not expr.has(*_TAKEN_APART) and expr.is_polynomial(*expr.free_symbols):
        return [Term(expr)] if expr != 0 else []
    if isinstance(expr, Add):
        return [term for part in expr.args for term in normal(part, whole, conditions)]
    if isinstance(expr, Mul):
        parts = [normal(part, whole, conditions) for part in expr.args]  # all of them: 0 times undefined is undefined
        terms = [Term()]
        for part in parts:
            terms = [times(one, other) for one in terms for other in part]
            if len(terms) > MOST_TERMS:
                raise Failure("a product with too many terms")
        return terms
    for kind, rule in _RULES.items():
        if isinstance(expr, kind):
            return rule(expr, whole, conditions)
    if expr.is_Symbol:
        return [Term(expr)]
    raise Failure(f"{expr} is no hypergeometric term")


def _plain(expr, whole):
    """Whether an expression holds no integer symbol and nothing that has to be taken apart."""
    return not expr.free_symbols & whole and not expr.has(*_TAKEN_APART)


def _power(expr, whole, conditions):
    base, exponent = expr.as_base_exp()
    if _plain(base, whole) and base.is_polynomial(*base.free_symbols) and base != 0:
        if base != E and not base.is_number:
            need(exponent, conditions)
        return [power_of(base, exponent)]
    if not exponent.is_Integer:
        raise Failure(f"the base of {expr} holds an integer symbol")
    if exponent > 0:
        return normal(expand(expr), whole, conditions) if base.is_Add else _repeated(base, exponent, whole, conditions)
    return [_reciprocal(base, -exponent, whole, conditions)]


def _repeated(base, exponent, whole, conditions):
    if base.is_Symbol:
        return [Term(base**exponent)]
    terms = [Term()]
    for _ in range(exponent):
        terms = [times(one, other) for one in terms for other in normal(base, whole, conditions)]
    return terms


def _reciprocal(base, exponent, whole, conditions):
    """One over a linear form that is never 0, or over a product of factorials."""
    if isinstance(base, binomial | factorial):
        (term,) = normal(base, whole, conditions) or (None,)
        if term is None:
            raise Failure(f"{base} is 0 somewhere, and something is divided by it")
        result = Term()
        for _ in range(exponent):
            result = times(result, inverse(term))
        return result
    if least(base - 1, conditions) >= 0 or least(-base - 1, conditions) >= 0:
        return Term(base**-exponent)
    raise Failure(f"{base} may be 0, and something is divided by it")


def _basis(expr, whole, conditions):
    i, n, x = expr.args
    if x.free_symbols & whole:
        raise Failure(f"the argument of {expr} holds an integer symbol")
    terms = _binomial(binomial(n, i, evaluate=False), whole, conditions)
    return [result for term in terms for result in _times_powers(term, {x: i, 1 - x: n - i}, conditions)]


def _times_powers(term, powers, conditions):
    """A term times powers with exponents >= 0; a power of 0 is 0 but for the exponent 0, which is an edge."""
    for base, exponent in powers.items():
        base = expand(base)
        if base == 0:
            if never(exponent - 1, conditions):
                continue
            need(exponent - 1, conditions)
            return []
        term = times(term, power_of(base, exponent))
    return [term]


def _binomial(expr, whole, conditions):
    """The coefficient as factorials; 0 for a lower number outside 0..top, undefined for a negative top."""
    top, bottom = expr.args
    if least(top, conditions) < 0:
        raise Failure(f"{expr} is not defined where {top} is negative")
    for form in (bottom, top - bottom):
        if never(form, conditions):
            return []
        need(form, conditions, vanishing=True)
    return [binomial_of(top, bottom)]


def _factorial(expr, whole, conditions):
    (form,) = expr.args
    if least(form, conditions) < 0:
        raise Failure(f"{expr} is not defined where {form} is negative")
    return [factorial_of(form)]


def _point(expr, whole, conditions):
    (index,) = expr.indices
    return [times(Term(POINT), power_of(E, index))]


def _derivative(expr, whole, conditions):
    """Term by term; a symbolic number of times for one power of a base that is linear in the variable."""
    terms = normal(expr.expr, whole, conditions)
    for variable, count in expr.variable_count:
        if count.is_Integer:
            for _ in range(int(count)):
                terms = [derived for term in terms for derived in _differentiated(term, variable, conditions)]
        else:
            terms = [_differentiated_often(term, variable, count, conditions) for term in terms]
    return terms


def _differentiated_often(term, variable, count, conditions):
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


def _at_point(expr, whole, conditions):
    """An expression at a value of a real variable, term by term."""
    if len(expr.variables) != 1 or expr.point[0].free_symbols & whole:
        raise Failure(f"{expr} is not at one real value")
    (variable,), (value,) = expr.variables, expr.point
    results = []
    for term in normal(expr.expr, whole, conditions):
        kept = {base: exponent for base, exponent in term.powers.items() if not base.has(variable)}
        moved = {base: exponent for base, exponent in term.powers.items() if base.has(variable)}
        rest = Term(term.coefficient.subs(variable, value), term.factorials, kept)
        parts = [rest]
        for base, exponent in moved.items():
            parts = [
                p for part in parts for p in _times_powers(part, {base.subs(variable, value): exponent}, conditions)
            ]
        results += parts
    return results


def _differentiated(term, variable, conditions):
    slope = term.coefficient.diff(variable)
    results = [term._replace(coefficient=slope)] if slope != 0 else []
    for base, exponent in term.powers.items():
        if base.has(variable):
            if exponent.is_Integer is not True:
                need(exponent - 1, conditions)
            lowered = times(term, power_of(base, S.NegativeOne))
            results.append(lowered._replace(coefficient=lowered.coefficient * exponent * base.diff(variable)))
    return results


def _integral(expr, whole, conditions):
    """Powers of t and 1 - t from 0 to 1, by Euler's Beta integral: p! q! / (p + q + 1)!."""
    ((variable, *limits),) = expr.limits
    if limits != [0, 1]:
        raise Failure(f"the limits of {expr} are not 0 and 1")
    result = []
    for term in normal(expr.function, whole, conditions):
        bases = {base for base in term.powers if base.has(variable)}
        if term.coefficient.has(variable) or not bases <= {variable, expand(1 - variable)}:
            raise Failure(f"{expr} is no Beta integral")
        p, q = term.powers.get(variable, S.Zero), term.powers.get(expand(1 - variable), S.Zero)
        need(p, conditions)
        need(q, conditions)
        rest = term._replace(powers={base: exponent for base, exponent in term.powers.items() if base not in bases})
        for part in (factorial_of(p), factorial_of(q), factorial_of(p + q + 1, -1)):
            rest = times(rest, part)
        result.append(rest)
    return result


def _sum(expr, whole, conditions):
    from .closing import closed

    return closed(expr, whole, conditions)


_RULES = {
    B: _basis,
    binomial: _binomial,
    factorial: _factorial,
    Pow: _power,
    Indexed: _point,
    Derivative: _derivative,
    Integral: _integral,
    Sum: _sum,
    Subs: _at_point,
}
