"""The rounding errors of the ways to evaluate a curve, and their multiplications, measured.

A measurement has the same digits on every machine with IEEE doubles: each way is written here with single products and
sums in a fixed order, and no library decides how it adds.
"""

from fractions import Fraction
from functools import lru_cache
from math import ceil, comb, log10

import numpy as np

from bezteach.numeric.basis import to_power
from bezteach.numeric.evaluation import evaluate_accurate

UNIT = 2.0**-53  # the unit roundoff of doubles
INSIDE = tuple(k / 37 for k in range(38))
OUTSIDE = tuple(1 + k / 37 for k in range(38))
POLYGONS = {
    "zigzag": lambda n: [(-1) ** i for i in range(n + 1)],
    "uneven": lambda n: [i * i % 7 - 3 for i in range(n + 1)],
    "line": lambda n: list(range(n + 1)),
}


def horner(coefficients, t):
    """The value of a polynomial with these ascending power coefficients, by nested multiplication."""
    value = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        value = value * t + coefficient
    return value


def bernstein_sum(heights, t):
    """The sum of C(n, i) b_i times t^i (1-t)^(n-i), term by term, the powers by repeated multiplication."""
    n = len(heights) - 1
    rising, falling = _powers(t, n), _powers(1 - t, n)
    total = 0
    for i, height in enumerate(heights):
        total = total + (comb(n, i) * height) * (rising[i] * falling[n - i])
    return total


def casteljau(heights, t):
    """De Casteljau's algorithm for one coordinate, each level written over the one before. Source: deck, 2.1; notes."""
    row, rest = list(heights), 1 - t
    for last in range(len(row) - 1, 0, -1):
        for i in range(last):
            row[i] = rest * row[i] + t * row[i + 1]
    return row[0]


def _powers(base, n):
    """1, base, ..., base^n: n - 1 multiplications."""
    powers = [1, base]
    while len(powers) <= n:
        powers.append(powers[-1] * base)
    return powers


def multiplications(degree):
    """{way: how many multiplications it does for one coordinate of one point}, counted while it runs.

    >>> multiplications(3)
    {'power basis, Horner': 3, 'Bernstein sum': 16, 'de Casteljau': 12}
    """
    ways = {"power basis, Horner": horner, "Bernstein sum": bernstein_sum, "de Casteljau": casteljau}
    return {name: _counted(way, degree) for name, way in ways.items()}


def _counted(way, degree):
    tally = []
    way([_Counting(tally) for _ in range(degree + 1)], _Counting(tally))
    return len(tally)


class _Counting:
    """A number without a value that notes each multiplication in a tally."""

    def __init__(self, tally):
        self.tally = tally

    def __mul__(self, other):
        self.tally.append("*")
        return self

    def __add__(self, other):
        return self

    __rmul__, __radd__, __rsub__ = __mul__, __add__, __add__


def worst(way, degrees, polygon="zigzag", parameters=INSIDE):
    """The largest error of way(heights, t) at the parameters, for each degree, in units of the largest |b_i|.

    ``polygon`` names heights b_i: "zigzag" is 1, -1, 1, ..., "line" is 0, 1, 2, ... Heights and parameters are doubles,
    taken as exact: the error is only what the way itself adds.
    """
    t = np.array(parameters, dtype=float)
    cases = [(POLYGONS[polygon](n), _exact(n, polygon, parameters)) for n in degrees]
    return tuple(_largest(way(heights, t), exact, heights) for heights, exact in cases)


def measured(degrees, polygon="zigzag", parameters=INSIDE):
    """{way: its ``worst`` errors}; the power coefficients are exact, then rounded once.

    Woźny and Chudy's way is measured in [0, 1] alone, where it is defined.

    >>> errors = measured([30])
    >>> [(name, power_of_ten(worst)) for name, (worst,) in errors.items()][:2]
    [('power basis, Horner', '10^-2'), ('Bernstein sum', '10^-15')]
    """
    ways = {
        "power basis, Horner": lambda heights, t: horner(list(map(float, to_power(heights))), t),
        "Bernstein sum": bernstein_sum,
        "de Casteljau": casteljau,
    }
    if all(0 <= t <= 1 for t in parameters):
        ways["Woźny and Chudy"] = lambda heights, t: evaluate_accurate(list(map(float, heights)), t)
    return {name: worst(way, degrees, polygon, parameters) for name, way in ways.items()}


@lru_cache(maxsize=256)
def _exact(n, polygon, parameters):
    """The values as Fractions, each summed in whole numbers."""
    heights, values = POLYGONS[polygon](n), []
    for t in parameters:
        above, below = float(t).as_integer_ratio()
        terms = (comb(n, i) * b * above**i * (below - above) ** (n - i) for i, b in enumerate(heights))
        values.append(Fraction(sum(terms), below**n))
    return tuple(values)


def _largest(values, exact, heights):
    error = max(abs(Fraction(float(value)) - true) for value, true in zip(values, exact, strict=True))
    return float(error / max(map(abs, heights)))


def power_of_ten(value):
    """The least power of ten that is not below a positive number, as text.

    >>> power_of_ten(3e-9), power_of_ten(20)
    ('10^-8', '10^2')
    """
    return f"10^{ceil(log10(value))}" if value else "0"
