"""Halving on whole numbers: rational numbers are scaled so that no halving of [0, 1] leaves the integers."""

from fractions import Fraction
from math import lcm

import numpy as np

from bezteach.numeric.arrays import read, shown

DEEPEST = 1000  # halvings


def rational(values, name):
    """An array of Fractions; a float counts as the fraction that it is. ``ValueError`` names what is none."""
    numbers = [_fraction(value) for value in values.ravel().tolist()]
    for i, number in enumerate(numbers):
        if number is None:
            place = np.unravel_index(i, values.shape)[-2:][0]
            raise ValueError(f"{name}_{place} is {shown(values.flat[i])}: an integer, a fraction or a float is needed")
    return np.fromiter(numbers, object, len(numbers)).reshape(values.shape)


def _fraction(value):
    """int, float, Fraction and SymPy's Rational as a Fraction, None for other expressions."""
    if getattr(value, "is_Rational", False):
        return Fraction(int(value.p), int(value.q))
    return None if hasattr(value, "free_symbols") else Fraction(value)


def rounds(tolerance):
    """How many halvings make [0, 1] no longer than the tolerance."""
    allowed = read(tolerance, "tolerance")
    length = None if allowed.ndim else _fraction(allowed[()])
    if length is None or length <= 0:
        raise ValueError(f"tolerance is {shown(tolerance)}: a positive number is needed")
    found = next((k for k in range(DEEPEST + 1) if length * 2**k >= 1), None)
    if found is None:
        raise ValueError(f"tolerance is {shown(tolerance)}: at least 2^-{DEEPEST} is needed")
    return found


def common(*arrays):
    """A positive integer that makes all the Fractions in some arrays whole."""
    return lcm(*(number.denominator for values in arrays for number in values.flat))


def integers(values, scale):
    """Fractions times a scale that makes them whole, as Python integers."""
    return np.frompyfunc(lambda x: x.numerator * (scale // x.denominator), 1, 1)(values)


def halves(points):
    """Integer control points (n+1, ...) of both halves: de Casteljau's algorithm at 1/2.

    With a factor 2^(n depth) in the points, every sum is even for so many rounds of halving, and nothing is rounded:
    a control point over [a, b] is a product of n steps at a and b.
    """
    levels = [points]
    while len(levels[-1]) > 1:
        levels.append((levels[-1][:-1] + levels[-1][1:]) // 2)
    first, last = [level[0] for level in levels], [level[-1] for level in levels[::-1]]
    return np.array(first, object), np.array(last, object)
