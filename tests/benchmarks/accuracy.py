"""Rounding errors of every way of evaluating, against exact fractions, in units of u max|b| with u = 2^-53."""

from fractions import Fraction
from math import comb

import numpy as np

import bezteach as bz

from .evaluation import contenders
from .job import Row

UNIT = Fraction(1, 2**53)
DEGREES = (3, 5, 10, 20, 50, 100)
FEW, MANY = 40, 4000  # parameters; many, for the ways that are taken for many, of which as few are looked at
PICTURE = 10**5


def rows(small=False):
    """A row for each of our ways and each degree; the others' errors stand in it, too."""
    for n in DEGREES[:2] if small else DEGREES:
        yield from of_degree(n)


def of_degree(n):
    """The rows of one degree."""
    points = np.random.default_rng(n).uniform(-1, 1, (n + 1, 2))
    numbers = np.random.default_rng(n + 1000)
    t = np.concatenate([[0, 1], numbers.uniform(0, 1, FEW - 2)])
    crowd = np.concatenate([t, numbers.uniform(0, 1, MANY - FEW)])
    exact = values(points, t)
    others = {name: worst(run(), exact, points) for name, run in contenders_at(points, t).items()}
    allowed = max(4, 1.5 * n)
    ways = {
        "evaluate, few t": (bz.evaluate(points, t), allowed),
        "evaluate, many t": (bz.evaluate(points, crowd)[:FEW], allowed),
        "evaluate_accurate": (bz.evaluate_accurate(points, t), 10),
        "de_casteljau": ([bz.de_casteljau(points, value)[-1][0] for value in t], None),
        "powers, Horner": (horner(points, t), None),
    }
    for name, (found, bar) in ways.items():
        yield Row(f"error of {name}, n={n}", worst(found, exact, points), others, (), bar, True, "u")
    for count in (256, PICTURE):
        yield Row(f"error of sample m={count}, n={n}", worst_sample(points, count), {}, (), allowed, True, "u")


def contenders_at(points, t):
    """The peers' ways that take an array."""
    return {name: run for name, run in contenders(points, t).items() if name not in ("kurbopy", "fonttools")}


def values(points, t):
    """The points at some parameters, floats taken as the fractions that they are."""
    return [value(points, Fraction(place)) for place in t.tolist()]


def value(points, t):
    """One point, exactly."""
    n, p, q = len(points) - 1, t.numerator, t.denominator
    weights = [comb(n, i) * p**i * (q - p) ** (n - i) for i in range(n + 1)]
    columns = ([Fraction(x) for x in column] for column in points.T.tolist())
    return [sum(w * b for w, b in zip(weights, column, strict=True)) / q**n for column in columns]


def worst(found, exact, points):
    """The largest error of some points, in units of u max|b|."""
    pairs = zip(np.asarray(found, dtype=float).ravel().tolist(), (x for point in exact for x in point), strict=True)
    return float(max(abs(Fraction(x) - y) for x, y in pairs) / Fraction(float(abs(points).max())) / UNIT)


def worst_sample(points, m):
    """The error of a sample at parameters that are fractions themselves, of which a few are looked at.

    The m-1 steps are not a power of two, so that also the parameters are rounded.
    """
    at = np.unique(np.linspace(0, m - 1, FEW).astype(int))
    exact = [value(points, Fraction(int(i), m - 1)) for i in at]
    return worst(bz.sample(points, m)[at], exact, points)


def horner(points, t):
    """Through the power basis, the way not to take."""
    total = np.zeros((t.size, points.shape[1]))
    for coefficient in bz.to_power(points)[::-1]:
        total = total * t[:, None] + coefficient
    return total
