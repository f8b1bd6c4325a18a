"""The shift operator E and the de Casteljau step g(t) = (1 - t) + t E, the one idea behind every formula of the course.

E^k b_0 = b_k. An operator is a SymPy expression in the symbol E: a polynomial, a power of a factor linear in E with a
symbolic exponent, a product of such, or a sum. Source: deck, section 2.1, "operator form".
"""

from collections import defaultdict
from functools import reduce
from operator import add

from sympy import Add, IndexedBase, Integer, Mul, Pow, Sum, Symbol, binomial, expand, factor, sympify

from .basis import B
from .symbols import E
from .symbols import b as control_points


def step(t):
    """One de Casteljau step, g(t) = (1 - t) + t E: it takes b_j to (1 - t) b_j + t b_{j+1}.

    >>> from sympy.abc import t
    >>> step(t)
    E*t - t + 1
    >>> step(0), step(1)
    (1, E)
    """
    return 1 - t + t * E


def binomial_theorem(x, y, m, index):
    """The sum that (x + y)^m is: C(m, index) x^(m-index) y^index for ``index`` from 0 to m, an integer or a symbol.

    The one lemma that the operator form needs.

    >>> from sympy.abc import k, m, x, y
    >>> binomial_theorem(x, y, m, k)
    Sum(x**(-k + m)*y**k*binomial(m, k), (k, 0, m))
    """
    return Sum(binomial(m, index) * x ** (m - index) * y**index, (index, 0, m))


def apply(operator, b=control_points):
    """Let an operator act on the point b_0: expand it in E and put b[k] for E**k.

    ``b`` is an ``IndexedBase`` or, when every power of E is a number, a sequence of expressions or SymPy matrices. A
    power (u + v E)^m with symbolic m becomes a Sum over 0..m by the binomial theorem; where u + v = 1 its terms are
    written B(i, m, v). ``ValueError`` for what is no polynomial in E, and for a point that the sequence does not have.
    Source: deck, section 2.1.

    >>> from sympy.abc import n, t
    >>> apply(step(t)**2)
    t**2*b[2] + 2*t*(1 - t)*b[1] + (1 - t)**2*b[0]
    >>> apply(step(t)**n)
    Sum(B(i, n, t)*b[i], (i, 0, n))
    """
    operator = sympify(operator)
    return _act(operator, b, Integer(0), operator.free_symbols)


def _act(operator, b, shift, taken):
    """The operator acting on b[shift]; ``taken`` holds the symbols that a new summation index must not use."""
    if not operator.has(Sum) and not any(map(_is_symbolic_power, operator.atoms(Pow))):
        return _act_polynomial(operator, b, shift)
    if isinstance(operator, Add):
        return Add(*[_act(term, b, shift, taken) for term in operator.args])
    factors = Mul.make_args(operator)
    for position, part in enumerate(factors):
        rest = Mul(*factors[:position], *factors[position + 1 :])
        if isinstance(part, Sum):
            summand = _act(part.function * rest, b, shift, taken | set(part.variables))
            return _sum(1, summand, part.limits)
        if _is_symbolic_power(part):
            return _act_symbolic_power(part, rest, b, shift, taken)
    raise ValueError(f"{operator} is not a polynomial in E")


def _act_polynomial(operator, b, shift):
    scalar, operator = operator.as_independent(E, as_Add=False)
    coefficients = defaultdict(list)
    for term in Add.make_args(expand(operator)):
        coefficient, power = term.as_coeff_exponent(E)
        if coefficient.has(E) or not power.is_Integer:
            raise ValueError(f"{term} is not a number times a power of E")
        coefficients[power].append(coefficient)
    terms = [tidy(factor(Add(*parts))) * _point(b, shift + k) for k, parts in sorted(coefficients.items())]
    return scalar * reduce(add, terms)


def _act_symbolic_power(power, rest, b, shift, taken):
    base, exponent = power.as_base_exp()
    if exponent.is_integer is False:
        raise ValueError(f"{power} has no whole number for its power of E")
    if base == E:
        return _act(rest, b, shift + exponent, taken)
    constant, slope = base.subs(E, 0), expand(base).coeff(E, 1)
    if expand(base - constant - slope * E) != 0:
        raise ValueError(f"{base} is not linear in E, so its power {exponent} cannot be expanded")
    index = next(name for name in (Symbol(c, integer=True, nonnegative=True) for c in "iklmpqsvw") if name not in taken)
    if expand(constant + slope) == 1:
        coefficient = B(index, exponent, slope)
    else:
        coefficient = binomial_theorem(constant, slope * E, exponent, index).function / E**index
    return _sum(coefficient, _act(rest, b, shift + index, taken | {index}), [(index, 0, exponent)])


def _sum(coefficient, summand, limits):
    """A sum of a sum as one Sum over all indices, what depends on none of them in front of it."""
    inner = next((part for part in Mul.make_args(summand) if isinstance(part, Sum)), None)
    if inner is not None:
        summand, limits = summand.subs(inner, inner.function), [*inner.limits, *limits]
    front, summand = (coefficient * summand).as_independent(*[limit[0] for limit in limits], as_Add=False)
    return front * Sum(summand, *limits)


def _is_symbolic_power(part):
    return isinstance(part, Pow) and part.base.has(E) and not part.exp.is_Integer


def _point(b, index):
    if isinstance(b, IndexedBase):
        return b[index]
    if not (index.is_Integer and 0 <= index < len(b)):
        raise ValueError(f"there is no control point b_{index} among b_0 .. b_{len(b) - 1}")
    return b[int(index)]


def tidy(product):
    """The product with 1 - t in the place of t - 1, the way the course writes it."""
    factors = []
    for part in Mul.make_args(product):
        base, exponent = part.as_base_exp()
        turn = base.is_Add and exponent.is_Integer and base.as_coeff_Add()[0].is_negative
        factors += [(-1) ** exponent, Add(*[-term for term in base.args]) ** exponent] if turn else [part]
    return Mul(*factors)
