"""De Casteljau's algorithm as a computation: what a step is geometrically, how exact it is, what it stores."""

from fractions import Fraction

from sympy import Add, Ge, Integer, oo

from bezteach.symbolic import b, i, r, t

from ..claim import Computed, Known, Shown, argued, claim, eq
from ..forms import UNIT, G
from ..planar import curve_point, levels

ROUNDOFF = Fraction(1, 2**53)
HEIGHTS = [[1], [3, -1], [0.1, -7.3, 2.2], [5, -5, 5, -5, 5], [(-1.7) ** k for k in range(12)]]


def in_place(points, t):
    """The last point of the triangle, each level written over the level before."""
    points = list(points)
    for last in range(len(points) - 1, 0, -1):
        for place in range(last):
            points[place] = (1 - t) * points[place] + t * points[place + 1]
    return points[0]


def within_bound(heights, t):
    """Whether the result in floating-point numbers is as near to the exact one as the bound says."""
    exact_heights = [Fraction(height) for height in heights]
    (exact,) = curve_point([(height,) for height in exact_heights], Fraction(t))
    bound = ((1 + ROUNDOFF) ** (3 * len(heights) - 3) - 1) * max(map(abs, exact_heights))
    return abs(Fraction(float(in_place(heights, t))) - exact) <= bound


def in_place_is_the_triangle(degree):
    """Whether overwriting gives the point of the curve, for one polygon of this degree."""
    heights = [k * k % 7 for k in range(degree + 1)]
    return (in_place(heights, Fraction(2, 5)),) == curve_point([(height,) for height in heights], Fraction(2, 5))


def unused_inner_point():
    """Whether, in a cubic cut in two, the middle point of the first level belongs to neither part."""
    rows = levels([(0, 0), (1, 3), (2, 1), (3, 3)], Fraction(1, 3))
    parts = {row[0] for row in rows} | {row[-1] for row in rows}
    return rows[1][1] not in parts and rows[0][0] in parts and rows[0][-1] in parts


CLAIMS = [
    claim(
        "algorithm/ratio",
        "on each level the new point divides an edge in the ratio t : (1 - t)",
        ((1 - t) * (G**r * b[i] - G ** (r - 1) * b[i]), t * (G ** (r - 1) * b[i + 1] - G**r * b[i])),
        {r: (1, oo)},
        twins=[
            (t * (G**r * b[i] - G ** (r - 1) * b[i]), (1 - t) * (G ** (r - 1) * b[i + 1] - G**r * b[i])),
            (G**r * b[i] - G ** (r - 1) * b[i], G ** (r - 1) * b[i + 1] - G**r * b[i]),
        ],
    ),
    argued(
        "algorithm/convex",
        "for t in [0, 1] each new point is a convex combination of two points of the level before",
        Shown("The weight 1 - t is not negative,", Ge(1 - t, 0, evaluate=False), UNIT),
        Shown("nor is t,", Ge(t, 0, evaluate=False), UNIT),
        Shown("and they sum to 1.", eq(Add(1 - t, t, evaluate=False), Integer(1))),
        Known("A step takes these two weights.", "casteljau/step"),
    ),
    argued(
        "algorithm/parts",
        "the two parts make the curve, with the first and the last point of each level as their control points",
        Known("The first point of each level, from level 0 on, for the part before the point at t,", "split/left"),
        Known("the last point of each level, from level n back to level 0, for the part after that.", "split/right"),
        "As u runs from 0 to 1, t u runs from 0 to t and 1 - (1 - t) (1 - u) from t to 1: the two parts together are "
        "the whole curve, and they meet in its point at t.",
        Computed(
            "Other points of the triangle belong to neither: in a cubic b_1^1 does not, while b_0 and b_3 do.",
            unused_inner_point,
        ),
    ),
    argued(
        "algorithm/stable",
        "stable for t in [0, 1]: the error is at most (1 + e)^(3n) - 1 times the greatest |coordinate|",
        "Let e be the unit roundoff: an operation gives its exact result times a factor between 1 - e and 1 + e, if no "
        "number is too large or too small for the format.",
        "In (1 - t) b + t c the term with b gets three such factors, for 1 - t, the product and the sum, and the term "
        "with c two.",
        "So on each way through the triangle from b_i to the last point a weight is multiplied by at most 3n of them, "
        "by a number between (1 - e)^(3n) and (1 + e)^(3n).",
        Known(
            "The weights on the ways are products of 1 - t and t, not negative, and those from b_i sum to B_{i,n}(t).",
            "casteljau/curve",
        ),
        Known(
            "So the error is at most (1 + e)^(3n) - 1, about 3n e, times the sum of B_{i,n}(t) |b_i|, which is at most "
            "the greatest |b_i|.",
            "basis/unity",
        ),
        "This is small beside the control points; beside the value itself it is not, where that is nearly 0.",
        Computed(
            "Five polygons, t = 0, 1/17, ..., 1 in 64-bit numbers with e = 2^-53: all within the bound. These are "
            "instances, the proof is above.",
            lambda: all(within_bound(heights, k / 17) for heights in HEIGHTS for k in range(18)),
        ),
    ),
    argued(
        "algorithm/storage",
        "n + 1 places are enough: a new level is written over the level before",
        "The new point b_i^r is made from b_i^{r-1} and b_{i+1}^{r-1}. After that b_i^{r-1} is not needed any more, so "
        "b_i^r takes its place, and i goes on to i + 1.",
        Computed(
            "For one polygon of each degree from 0 to 9 this gives the point of the curve. These are instances.",
            lambda: all(map(in_place_is_the_triangle, range(10))),
        ),
    ),
]
