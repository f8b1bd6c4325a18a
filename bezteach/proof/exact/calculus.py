"""The derivative and the antiderivative of a polynomial by one of its letters, and a value put in its place."""

from fractions import Fraction

from ..errors import Undefined, Unsupported
from .polynomial import MOST_BITS, Polynomial, bits, monomials, reduced


def _split(value, letter):
    """The (exponent of the letter, what it multiplies) of a value, gathered."""
    parts = {}
    for monomial, coefficient in monomials(value):
        exponent = dict(monomial).get(letter, 0)
        rest = tuple(pair for pair in monomial if pair[0] != letter)
        parts[exponent] = parts.get(exponent, 0) + reduced({rest: coefficient})
    return parts


def _letter(variable):
    ((((letter, _),), _),) = variable.terms.items()
    return letter


def derivative(value, variable):
    """The derivative by a letter that ``atom`` made.

    >>> from bezteach.proof.exact.polynomial import VARIABLE, atom
    >>> t = atom(VARIABLE, "t")
    >>> derivative(t * t * t, t)
    3*t**2
    """
    total = 0
    for exponent, rest in _split(value, _letter(variable)).items():
        if exponent:
            step = variable ** (exponent - 1) if exponent > 0 else variable.inverse() ** (1 - exponent)
            total = rest * exponent * step + total
    return total


def antiderivative(value, variable):
    """The antiderivative by a letter, without a constant."""
    total = 0
    for exponent, rest in _split(value, _letter(variable)).items():
        if exponent < 0:
            raise Unsupported("an integral over powers of an operator")
        total = rest * Fraction(1, exponent + 1) * variable ** (exponent + 1) + total
    return total


def put(value, variable, replacement):
    """The value with a number or a polynomial in the place of a letter."""
    total = 0
    for exponent, rest in _split(value, _letter(variable)).items():
        base = replacement
        if bits(base) * abs(exponent) > MOST_BITS:
            raise Unsupported("a power with thousands of digits")
        if exponent < 0:
            if base == 0:
                raise Undefined("division by 0")
            base = base.inverse() if isinstance(base, Polynomial) else Fraction(1) / base
        total = rest * base ** abs(exponent) + total
    return total
