"""Numbers that divide exactly, Fractions and SymPy expressions, and what is known of their signs."""

from fractions import Fraction
from math import lcm
from numbers import Rational

import numpy as np


def exact(values):
    """The numbers as Fractions or SymPy expressions, which divide exactly."""
    return np.frompyfunc(lambda x: Fraction(x) if isinstance(x, (int, float)) else x, 1, 1)(values)


over = np.frompyfunc(Fraction, 2, 1)


def all_rational(points, t):
    """Whether t is a Fraction and all of the points are Fractions and ints."""
    return type(t) is Fraction and all(type(x) in (int, Fraction) for x in points.flat)


def integer_triangle(points, t):
    """De Casteljau's levels of rational numbers, each in integers over one denominator: pairs (level, denominator).

    A sum of Fractions looks for a common divisor each time; here that is left to whoever divides in the end.
    """
    below, p, q = lcm(*(x.denominator for x in points.flat)), t.numerator, t.denominator
    level = np.frompyfunc(lambda x: x.numerator * (below // x.denominator), 1, 1)(points)
    levels = [(level, below)]
    while level.shape[-2] > 1:
        level, below = (q - p) * level[..., :-1, :] + p * level[..., 1:, :], below * q
        levels.append((level, below))
    return levels


def nested(value):
    """An array, or points in lists, as nested tuples of Fractions; what is no fraction of whole numbers stays."""
    if np.ndim(value):
        return tuple(map(nested, value))
    return Fraction(int(value.numerator), int(value.denominator)) if isinstance(value, Rational) else value


def tidy(values):
    """SymPy expressions as quotients of polynomials in lowest terms, and what is known to be 0 as 0."""
    return np.frompyfunc(lambda x: simple(x.cancel()) if hasattr(x, "cancel") else x, 1, 1)(values)


def simple(x):
    return 0 * x if is_zero(x) else x


def is_zero(x):
    """Whether an exact number is 0: True, False, or None if that depends on symbols."""
    if not hasattr(x, "is_zero"):
        return x == 0
    return x.equals(0) if x.is_number else x.is_zero


def is_positive(x):
    """Whether an exact number is positive: True, False, or None if that depends on symbols."""
    return x.is_positive if hasattr(x, "is_positive") else x > 0
