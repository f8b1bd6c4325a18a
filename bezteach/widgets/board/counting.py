"""Changes of sign of a polynomial between 0 and 1, counted exactly."""

from itertools import dropwhile
from math import comb, lcm
from operator import not_

from ...numeric import sign_changes


def roots_inside(coefficients):
    """(passages, touches): the roots of odd and of even multiplicity in the open interval (0, 1), each counted once.

    ``coefficients``: ints and Fractions, in the Bernstein basis; None for the zero polynomial.

    >>> roots_inside([1, -1, 1]), roots_inside([1, -1, -1, 1]), roots_inside([0, 0])
    ((0, 1), (2, 0), None)
    """
    row = list(coefficients)
    if not any(row):
        return None
    changes = sign_changes(row)
    if changes < 2:  # with multiplicity the roots are as many as the changes, or fewer by an even number
        return changes, 0
    from sympy import Poly, Symbol  # half a second, and most boards do without

    # with x = t / (1 - t) the polynomial is (1 - t)^n sum of C(n, i) d_i x^i, and t in (0, 1) is x > 0
    scale = lcm(*(value.denominator for value in row))
    powers = [comb(len(row) - 1, i) * int(scale * value) for i, value in enumerate(row)]
    rooted = list(dropwhile(not_, powers))  # without the factor x^k, whose root is the end t = 0
    found = Poly(rooted[::-1], Symbol("x")).intervals(inf=0)
    passages = sum(multiplicity % 2 for _, multiplicity in found)
    return passages, len(found) - passages
