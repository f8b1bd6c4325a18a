"""The functions of the course at exact values, with the project's conventions, and with bounds on the size.

A value is an ``int``, a ``Fraction`` or a ``Polynomial``. Undefined where there is no value; Unsupported where there
may be one that is too large or not rational. ``0**0`` is 1, as everywhere where polynomials are written as sums.
"""

import math
from fractions import Fraction
from functools import lru_cache

from ..errors import Undefined, Unsupported
from .polynomial import MOST_BITS, Polynomial, bits

LARGEST_INTEGER = 4_000
LARGEST_FACTORIAL = 1_000


def whole(value, what="a number"):
    """The value as an int.

    >>> whole(Fraction(4, 2))
    2
    """
    if type(value) is int:
        return value
    if isinstance(value, Fraction) and value.denominator == 1:
        return value.numerator
    raise Unsupported(f"{what} is {value}, not a whole number")


def number(value, what):
    """The value itself, if it is a number."""
    if isinstance(value, Polynomial):
        raise Unsupported(f"{what} of {value}")
    return value


def small(value):
    """The value itself, if it is not too large to go on with."""
    if bits(value) > MOST_BITS:
        raise Unsupported("a number with thousands of digits")
    return value


def divided(value, by):
    """A quotient; division by 0 is undefined, even 0/0.

    >>> divided(1, 3)
    Fraction(1, 3)
    """
    if isinstance(by, Polynomial):
        return value * by.inverse()
    if by == 0:
        raise Undefined("division by 0")
    return value * (Fraction(1) / by)


def power(base, exponent):
    """A power, exact where it is rational; 0**0 is 1, and 0 to a negative power is undefined.

    >>> power(0, 0), power(2, -1), power(Fraction(4, 9), Fraction(1, 2))
    (1, Fraction(1, 2), Fraction(2, 3))
    """
    exponent = number(exponent, "the exponent")
    if exponent.denominator != 1:
        return power(_root(number(base, "a root"), exponent.denominator), exponent.numerator)
    exponent = exponent.numerator
    if exponent < 0:
        return divided(1, power(base, -exponent))
    if base in (0, 1, -1):
        return base ** (exponent if base != -1 else exponent % 2)
    if exponent > LARGEST_INTEGER or bits(base) * exponent > MOST_BITS:
        raise Unsupported("a power with thousands of digits")
    return base**exponent


def _root(base, degree):
    """The root of a number >= 0, if it is rational."""
    if base < 0:
        raise Unsupported("a root of a negative number")
    if degree > 64:
        raise Unsupported(f"a root of degree {degree}")
    parts = [_integer_root(part, degree) for part in (base.numerator, base.denominator)]
    if [part**degree for part in parts] != [base.numerator, base.denominator]:
        raise Unsupported("an irrational root")
    return Fraction(*parts)


def _integer_root(value, degree):
    """The largest integer whose power is at most the value, by halving the interval."""
    low, high = 0, 1 << (value.bit_length() // degree + 1)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**degree <= value else (low, middle)
    return low


def _bounded(value, what, largest=LARGEST_INTEGER):
    value = whole(value, what)
    if abs(value) > largest:
        raise Unsupported(f"{what} is {value}, larger than {largest}")
    return value


def bernstein(i, n, t):
    """B_{i,n}(t): 0 for i outside 0..n, undefined for n < 0.

    >>> bernstein(1, 2, Fraction(1, 3)), bernstein(3, 2, Fraction(1, 3))
    (Fraction(4, 9), 0)
    """
    i, n = whole(i, "the index of B"), _bounded(n, "the degree of B")
    if n < 0:
        raise Undefined(f"B of degree {n}")
    if not 0 <= i <= n:
        return 0
    if isinstance(t, Polynomial):
        return _bernstein(i, n, t)
    if n * bits(t) > MOST_BITS:
        raise Unsupported("a value of B with thousands of digits")
    above, below = t.numerator, t.denominator
    return Fraction(math.comb(n, i) * above**i * (below - above) ** (n - i), below**n)


@lru_cache(maxsize=4096)
def _bernstein(i, n, t):
    return math.comb(n, i) * power(t, i) * power(1 - t, n - i)


def binomial(n, k):
    """C(n, k): 0 for k outside 0..n when n >= 0, undefined for n < 0. A convention of the project, not SymPy's.

    >>> binomial(4, 2), binomial(4, 5), binomial(4, -1)
    (6, 0, 0)
    """
    n, k = _bounded(n, "the upper number of C"), whole(k, "the lower number of C")
    if n < 0:
        raise Undefined(f"C({n}, {k})")
    return math.comb(n, k) if 0 <= k <= n else 0


def factorial(n):
    """n!, undefined for n < 0."""
    n = _bounded(n, "the argument of a factorial", LARGEST_FACTORIAL)
    if n < 0:
        raise Undefined(f"({n})!")
    return math.factorial(n)


def falling(x, k, step=-1):
    """x (x - 1) ... (x - k + 1), for an integer k >= 0."""
    k = _bounded(k, "the number of factors", LARGEST_FACTORIAL)
    if k < 0:
        raise Unsupported(f"a factorial power with {k} factors")
    total = 1
    for place in range(k):
        total = small(total * (x + step * place))
    return total


def rising(x, k):
    """x (x + 1) ... (x + k - 1), for an integer k >= 0.

    >>> rising(3, 2), falling(3, 2)
    (12, 6)
    """
    return falling(x, k, step=1)
