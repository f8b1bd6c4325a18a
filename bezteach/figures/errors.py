"""De Casteljau's points as curves of their own, and the rounding errors of the ways to evaluate, measured and drawn.

A measurement has the same digits on every machine with IEEE doubles: each way is written here with single products and
sums in a fixed order, and no library decides how it adds.
"""

from fractions import Fraction
from functools import lru_cache
from math import ceil, comb, log10

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import number, point
from ..palette import FIRST, INK, QUIET, SECOND
from .style import SAMPLES, STYLE

UNIT = 2.0**-53  # the unit roundoff of doubles
INSIDE = tuple(k / 37 for k in range(38))
OUTSIDE = tuple(1 + k / 37 for k in range(38))
POLYGONS = {
    "zigzag": lambda n: [(-1) ** i for i in range(n + 1)],
    "uneven": lambda n: [i * i % 7 - 3 for i in range(n + 1)],
    "line": lambda n: list(range(n + 1)),
}
LOOKS = {
    "power basis, Horner": (SECOND, "--", "s"),
    "Bernstein sum": (INK, ":", "^"),
    "de Casteljau": (FIRST, "-", "o"),
    "Woźny and Chudy": (QUIET, "-.", "D"),
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
        "power basis, Horner": lambda heights, t: horner(list(map(float, numeric.to_power(heights))), t),
        "Bernstein sum": bernstein_sum,
        "de Casteljau": casteljau,
    }
    if all(0 <= t <= 1 for t in parameters):
        ways["Woźny and Chudy"] = lambda heights, t: numeric.evaluate_accurate(list(map(float, heights)), t)
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


@mpl.rc_context(STYLE)
def error_growth(degrees, errors):
    """Errors (``measured``) against the degree, on a logarithmic scale; an error of 0 lies on the floor."""
    figure = Figure(figsize=(7.6, 5.2), layout="constrained")
    axes = figure.subplots()
    for name, sizes in errors.items():
        colour, dash, marker = LOOKS[name]
        drawn = np.maximum(sizes, UNIT / 8)
        axes.semilogy(
            degrees, drawn, color=colour, linestyle=dash, marker=marker, markersize=6, markevery=(4, 5), label=name
        )
    axes.axhline(1, color=QUIET, linewidth=1)
    axes.annotate("as large as the points", (degrees[0], 1), xytext=(0, 5), textcoords="offset points", fontsize=12)
    axes.set(xlabel="degree", ylabel="largest error / largest |b|")
    figure.legend(loc="outside upper center", ncols=2)
    told = "; ".join(f"{name} {power_of_ten(sizes[-1])}" for name, sizes in errors.items())
    figure.set_label(
        f"The largest rounding error of {len(errors)} ways to evaluate, against the degree, on a logarithmic scale. "
        f"At degree {degrees[-1]} it is at most: {told}, in units of the largest control height."
    )
    return figure


@mpl.rc_context(STYLE)
def lower_curves(points, t):
    """A curve, the two curves of its first n and of its last n points, and the line between their points at t."""
    first, last, here = points[:-1], points[1:], numeric.evaluate(points, t)
    ends = np.array([numeric.evaluate(part, t) for part in (first, last)])
    figure = Figure(figsize=(7, 5.2), layout="constrained")
    axes = figure.subplots()
    axes.plot(*_floats(points).T, ":", color=QUIET, marker="o", markerfacecolor="white", linewidth=1.6)
    for i, place in enumerate(_floats(points)):
        away = place - _floats(points).mean(axis=0)
        away = away / (np.hypot(*away) or 1.0)
        axes.annotate(f"$b_{{{i}}}$", place, xytext=16 * away, textcoords="offset points", ha="center", va="center")
    degree = len(points) - 1
    axes.plot(*_sampled(first), "--", color=SECOND, label=f"first {degree} points")
    axes.plot(*_sampled(last), "-.", color=INK, label=f"last {degree} points")
    axes.plot(*_sampled(points), "-", color=FIRST, linewidth=4, label="the curve")
    axes.plot(*_floats(ends).T, "-", color=INK, marker="s", markerfacecolor="white", linewidth=1.6)
    axes.plot(*_floats([here]).T, "o", color=FIRST, markersize=11)
    axes.set(aspect="equal")
    axes.margins(0.12)
    axes.locator_params(nbins=5, integer=True)
    figure.legend(loc="outside lower center", ncols=3)
    figure.set_label(
        f"A curve of degree {degree} between two curves of degree {degree - 1}, of its first and of its last {degree} "
        f"points. At t = {number(t)} these are at {point(ends[0])} and {point(ends[1])}; "
        f"the curve's point {point(here)} lies on the line between them."
    )
    return figure


def _floats(points):
    return np.asarray(points, dtype=float)


def _sampled(points):
    return numeric.sample(_floats(points), SAMPLES).T
