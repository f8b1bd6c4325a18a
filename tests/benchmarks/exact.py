"""Exact arithmetic: Fractions, SymPy's numbers, and python-flint's."""

from fractions import Fraction
from itertools import pairwise
from math import comb

import numpy as np

import bezteach as bz

from .job import Job, same
from .peers import present


def jobs(small=False):
    """All jobs in exact numbers; small ones of low degree."""
    n = 4 if small else 30
    yield power_matrix(n)
    for degree in (4,) if small else (5, 20):
        yield triangle(degree)
        yield evaluating(degree)
        yield splitting(degree)


def power_matrix(n):
    """The change to the power basis: column i has the coefficients of B_{i,n}."""
    unit = np.eye(n + 1, dtype=int)
    expected = [
        [(-1) ** (k - i) * comb(n, k) * comb(k, i) if i <= k else 0 for i in range(n + 1)] for k in range(n + 1)
    ]
    peers = present(
        {("sympy", "Poly"): lambda sympy: columns_by_sympy(sympy, n), "python-flint": lambda f: by_flint(f, n)}
    )
    name = f"exact power matrix n={n}"
    return Job(name, 0.1, lambda: bz.to_power(unit), peers, same(expected), against=("sympy Poly",))


def columns_by_sympy(sympy, n):
    """Each B_{i,n} multiplied out as a Poly."""
    t = sympy.Symbol("t")
    one, rest = sympy.Poly(t, t), sympy.Poly(1 - t, t)

    def run():
        columns = [(comb(n, i) * one**i * rest ** (n - i)).all_coeffs()[::-1] for i in range(n + 1)]
        return [[int(column[k]) for column in columns] for k in range(n + 1)]

    return run


def by_flint(flint, n):
    """The same with flint's polynomials over the integers."""
    one, rest = flint.fmpz_poly([0, 1]), flint.fmpz_poly([1, -1])

    def run():
        columns = [comb(n, i) * one**i * rest ** (n - i) for i in range(n + 1)]
        return [[int(column[k]) for column in columns] for k in range(n + 1)]

    return run


def polygon(n):
    """Exact control points (n+1, 2) with small denominators."""
    return [[Fraction(i * i % 7 - 3, 4), Fraction(5 * i % 11, 3)] for i in range(n + 1)]


T = Fraction(2, 7)


def levels(points, t):
    """De Casteljau's triangle, number by number, in whatever arithmetic."""
    found = [points]
    while len(found[-1]) > 1:
        last = found[-1]
        found.append([[(1 - t) * a + t * b for a, b in zip(p, q, strict=True)] for p, q in pairwise(last)])
    return found


def rivals(n, make):
    """Contenders that do `make(points, t)` with Fractions, with SymPy's and with flint's numbers."""
    points = polygon(n)

    def arithmetic(number):
        converted = [[number(x.numerator, x.denominator) for x in point] for point in points]
        return lambda: make(converted, number(T.numerator, T.denominator))

    others = {"sympy Rational": lambda sympy: arithmetic(sympy.Rational), "python-flint": lambda f: arithmetic(f.fmpq)}
    named = {("sympy", "Rational"): others["sympy Rational"], "python-flint": others["python-flint"]}
    return {"Fraction": arithmetic(Fraction)} | present(named)


def as_fractions(answer):
    """Nested numbers of any arithmetic as one row of Fractions."""
    if isinstance(answer, (list, tuple, np.ndarray)):
        return [number for part in answer for number in as_fractions(part)]
    return [Fraction(int(answer.numerator), int(answer.denominator))]


def job(name, n, ours, make, bar=None):
    """A job on the polygon of degree n, against the same in other arithmetics."""
    points = polygon(n)
    expected, array = as_fractions(make(points, T)), np.array(points)
    peers = rivals(n, make)
    return Job(
        f"{name} n={n}",
        bar,
        lambda: ours(array, T),
        peers,
        same(expected),
        against=("Fraction",),
        seen={name: as_fractions for name in ("ours", *peers)},
    )


def triangle(n):
    """All levels of de Casteljau's triangle."""
    return job("exact triangle", n, bz.de_casteljau, levels, bar=0.1 if n == 20 else None)


def evaluating(n):
    """Its last point alone."""
    return job("exact point", n, bz.evaluate, lambda points, t: levels(points, t)[-1][0])


def splitting(n):
    """Both halves, the first and the last points of the levels."""

    def both(points, t):
        found = levels(points, t)
        return [level[0] for level in found] + [level[-1] for level in found[::-1]]

    return job("exact split", n, bz.split, both)
