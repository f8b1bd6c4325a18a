"""Where a polynomial is zero in [0, 1]: the signs of its Bernstein coefficients, and halving."""

from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from bezteach.numeric.arrays import read
from bezteach.numeric.dyadic import common, halves, integers, rational, rounds


class Root(NamedTuple):
    """Where roots are: start = end is a root itself, start < end stands for the open interval between the two.

    certain: there is one root, and no other. Else nobody knows yet: there may be none, one, several or a multiple one.
    """

    start: Fraction
    end: Fraction
    certain: bool


def sign_changes(heights):
    """How often the sign changes along the numbers b_0, ..., b_n; zeros are passed over.

    The polynomial with these Bernstein coefficients has in 0 < t < 1 as many roots, counted with their multiplicity, or
    fewer by an even number. So 0 says that there is none, 1 that there is one.

    >>> sign_changes([-4, 7, 0, -7, 4])
    3

    Takes ints, Fractions and floats, shape (n+1,). Raises ValueError for other numbers and shapes. Source: deck, 1.2,
    property 6, variation diminishing: the line is the t-axis; the rule is Descartes's.
    """
    return changes(row_of(heights))


def roots(heights, tolerance=Fraction(1, 2**20)):
    """The roots in [0, 1] of the polynomial with the Bernstein coefficients b_0, ..., b_n: a list of `Root`, in order.

    No sign change: no root inside. Otherwise the polynomial is halved, until the parts are no longer than the
    tolerance. Every root in [0, 1] is in exactly one of the answers. One at 0, at 1 or at a joint of two parts is met
    exactly, start = end, whatever its multiplicity. Of the open intervals those with one sign change are certain: they
    hold one root, a single one. Those with more are not: a multiple root, or several, or none.

    >>> for root in roots([-4, 7, -7, 4], Fraction(1, 16)):
    ...     print(*root)
    3/16 1/4 True
    1/2 1/2 True
    3/4 13/16 True
    >>> [root.certain for root in roots([1, -2, 4], Fraction(1, 16))]
    [False]

    The second is (1 - 3t)^2. Takes ints, Fractions and floats, shape (n+1,); floats count as the fractions that they
    are. All is computed in integers and answered in Fractions. Raises ValueError for other numbers and shapes, for a
    tolerance that is not positive or below 2^-1000, and if all coefficients are 0. Source: games, de Casteljau, "for
    root finding"; J. Lane and R. Riesenfeld, Bounds on a polynomial, BIT 21, 1981.
    """
    row, depth = row_of(heights), rounds(tolerance)
    if not row.any():
        raise ValueError("all heights are 0: then every t is a root")
    row = integers(row, common(row) << (len(row) - 1) * depth)
    ends = [Root(Fraction(t), Fraction(t), True) for t, height in ((0, row[0]), (1, row[-1])) if height == 0]
    return sorted(ends + inside(row, depth))


def row_of(heights):
    """The coefficients as Fractions, shape (n+1,)."""
    values = read(heights, "height b")
    if values.ndim != 1:
        raise ValueError(f"the heights have {values.ndim} axes: one row of Bernstein coefficients is needed")
    return rational(values, "height b")


def changes(row):
    signs = [height > 0 for height in row if height]
    return sum(one != other for one, other in pairwise(signs))


def inside(row, depth):
    """The roots in 0 < t < 1, in any order, of integers that bear so many halvings."""
    found, waiting = [], [(row, 0, 0)]
    while waiting:  # part i of 2^k
        part, i, k = waiting.pop()
        count = changes(part)
        if count and k == depth:
            found.append(Root(Fraction(i, 2**k), Fraction(i + 1, 2**k), count == 1))
        elif count:
            left, right = halves(part)
            if right[0] == 0:
                middle = Fraction(2 * i + 1, 2 ** (k + 1))
                found.append(Root(middle, middle, True))
            waiting += [(left, 2 * i, k + 1), (right, 2 * i + 1, k + 1)]
    return found
