"""Halving again and again: the polygons tend to the curve."""

from fractions import Fraction
from itertools import pairwise

from sympy import Integer, Interval, Le, Rational, Sum, Symbol

from bezteach.examples import EXAMPLES
from bezteach.symbolic import B, b, i, j, k, n, step, t

from ..claim import Computed, Known, Shown, argued, claim, eq
from ..forms import DELTA, FROM_ONE, FROM_TWO, difference
from ..planar import curve_point, dot, halves, minus
from .segments import part_point, t1, t2

m = Symbol("m", integer=True, nonnegative=True)
w = Symbol("w", real=True)

EDGE = part_point(j + 1) - part_point(j)
BEND = part_point(j + 2) - 2 * part_point(j + 1) + part_point(j)
SMALLER_EDGE = (t2 - t1) * step(t1) ** (n - 1 - j) * step(t2) ** j * DELTA * b[0]
SMALLER_BEND = (t2 - t1) ** 2 * step(t1) ** (n - 2 - j) * step(t2) ** j * DELTA**2 * b[0]
MOMENT = Sum((i - j) * (i - j - 1) * B(i, n, t), (i, 0, n))
ON_EDGE = b[j] + (n * t - j) * (b[j + 1] - b[j])


def pieces(points, rounds):
    """The pieces after so many rounds, in their order."""
    found = [points]
    for _ in range(rounds):
        found = [half for piece in found for half in halves(piece, Fraction(1, 2))]
    return found


def largest_bend(points):
    """The square of the length of the longest second difference."""
    edges = [minus(after, before) for before, after in pairwise(points)]
    bends = [minus(after, before) for before, after in pairwise(edges)]
    return max((dot(bend, bend) for bend in bends), default=0)


def on_polygon(points, at):
    """The point of the polygon at a parameter; the vertices are at 0, 1/n, ..., 1."""
    degree = len(points) - 1
    place = min(int(at * degree), degree - 1)
    ahead = at * degree - place
    return tuple((1 - ahead) * x + ahead * y for x, y in zip(points[place], points[place + 1], strict=True))


def within_bound(points, rounds, samples):
    """Whether, at so many parameters of each piece, the polygon is within n D / (8 4^rounds) of the curve."""
    degree, count = len(points) - 1, 2**rounds
    bound = Fraction(degree, 8 * 4**rounds) ** 2 * largest_bend(points)
    for number, piece in enumerate(pieces(points, rounds)):
        for at in (Fraction(place, samples) for place in range(samples + 1)):
            off = minus(on_polygon(piece, at), curve_point(points, (number + at) / count))
            if dot(off, off) > bound:
                return False
    return True


def cubic_within_bound():
    points = [tuple(map(Fraction, point)) for point in EXAMPLES["deck/split"].given["points"]]
    return all(within_bound(points, rounds, 6) for rounds in range(5))


def parabola_on_bound():
    points = [(Fraction(0), Fraction(0)), (Fraction(1), Fraction(2)), (Fraction(2), Fraction(0))]
    off = minus(on_polygon(points, Fraction(1, 2)), curve_point(points, Fraction(1, 2)))
    return dot(off, off) == Fraction(2, 8) ** 2 * largest_bend(points)


CLAIMS = [
    claim(
        "limit/pieces",
        "each round cuts every piece: round i adds 2^(i-1) pieces, and after k rounds there are 2^k",
        (1 + Sum(2 ** (i - 1), (i, 1, k)), 2**k),
        twins=[(1 + Sum(Integer(1), (i, 1, k)), 2**k), (1 + Sum(2**i, (i, 1, k)), 2**k)],
    ),
    claim(
        "limit/points",
        "the 2^k - 1 joints belong to two pieces each: 2^k n + 1 control points",
        (difference(2**k * (n + 1), 2**k - 1), 2**k * n + 1),
        twins=[(2**k * (n + 1), 2**k * n + 1)],
    ),
    claim(
        "limit/edges",
        "the edges of a part of length t_2 - t_1",
        (EDGE, SMALLER_EDGE),
        FROM_ONE | {j: (0, n - 1)},
        twins=[(EDGE, (t2 - t1) * step(t1) ** (n - 1 - j) * step(t2) ** j * b[0])],
    ),
    claim(
        "limit/bends",
        "the second differences of a part: the square of its length stands in front",
        (BEND, SMALLER_BEND),
        FROM_TWO | {j: (0, n - 2)},
        twins=[(BEND, (t2 - t1) * step(t1) ** (n - 2 - j) * step(t2) ** j * DELTA**2 * b[0])],
    ),
    claim(
        "limit/moment",
        "the mean of (i - j)(i - j - 1) under the Bernstein functions",
        (MOMENT, n * t * (1 - t) + (n * t - j) * (n * t - j - 1)),
        twins=[(MOMENT, n * t * (1 - t))],
    ),
    claim(
        "limit/sum-of-differences",
        "the differences of neighbours sum to the difference of the ends",
        (Sum(b[i + j] - b[i + j - 1], (i, 1, m)), b[j + m] - b[j]),
        twins=[(Sum(b[i + j] - b[i + j - 1], (i, 0, m)), b[j + m] - b[j])],
    ),
    argued(
        "limit/halving",
        "halving every piece k times gives polygons that are nowhere further than n D / (8 4^k) from the curve, at the "
        "same parameter, D the length of the longest second difference; so they tend to it, and their vertices do",
        "Let n >= 1, and write g(t) for the step (1 - t) + t E. Each round cuts all pieces in halves.",
        Known(
            "The part from s to t of the curve has the control points c_j = g(s)^(n-j) g(t)^j b_0.", "segment/points"
        ),
        Known("Cut at c = 1/2, it gives in front the part from s to (s + t)/2,", "segment/front"),
        Known("and behind the part from (s + t)/2 to t.", "segment/back"),
        "So, by induction on k, the pieces after k rounds are the parts from a/2^k to (a + 1)/2^k, with a from 0 to "
        "2^k - 1, and what is said of parts is said of them with t - s = 1/2^k.",
        Known(
            "Second differences of a part are (t - s)^2 g(s)^(n-2-j) g(t)^j applied to those of the curve.",
            "limit/bends",
        ),
        Known(
            "Applied to points, g(s)^p g(t)^q weights them with products of Bernstein functions:", "casteljau/points"
        ),
        Known("none of the weights is negative, for s and t in [0, 1],", "basis/non-negative"),
        Known("and their sum is 1, as each factor sums to 1.", "basis/unity"),
        "A mean of vectors of length at most D has a length of at most D, so no second difference of a piece after k "
        "rounds is longer than d = D/4^k. A line, n = 1, has no second differences: there D = 0.",
        "Now take one piece, with the control points c_0, ..., c_n, its curve q(t) over [0, 1], and its polygon with "
        "the vertex c_i at the parameter i/n. Fix t, and j with j <= n t <= j + 1 and j <= n - 1. The line through c_j "
        "and c_{j+1} has the point l_i = c_j + (i - j)(c_{j+1} - c_j) at i/n, and at t the point of the polygon.",
        Shown(
            "The weighted mean of the l_i is the point of the line at t, so of the polygon.",
            eq(Sum(B(i, n, t) * (b[j] + (i - j) * (b[j + 1] - b[j])), (i, 0, n)), ON_EDGE),
        ),
        "So q(t) less the point of the polygon is the mean of the vectors c_i - l_i with the weights B_{i,n}(t).",
        Known("Edges less the edge at j are sums of second differences:", "limit/sum-of-differences"),
        "the edge s places away from the edge at j differs from it by s second differences, so by at most s d.",
        Known("Likewise c_i - c_j is a sum of edges, |i - j| of them,", "limit/sum-of-differences"),
        "so c_i - l_i is a sum of edges less the edge at j. For i = j + m these are 0, ..., m - 1 places away; for "
        "i = j - m they are 1, ..., m places away, with the sign turned.",
        Shown(
            "For i > j: 0 + 1 + ... + (m - 1), with m = i - j, is (i - j)(i - j - 1)/2;",
            eq(Sum(k, (k, 1, m)) - m, m * (m - 1) / 2),
        ),
        Shown(
            "for i < j: 1 + ... + m, with m = j - i, is the same (i - j)(i - j - 1)/2.",
            eq(Sum(k, (k, 1, m)), (-m) * (-m - 1) / 2),
        ),
        "In both cases c_i - l_i is not longer than d (i - j)(i - j - 1)/2.",
        Known("The mean of (i - j)(i - j - 1) is n t (1 - t) + (n t - j)(n t - j - 1).", "limit/moment"),
        Shown(
            "With w = n t - j from 0 to 1 the second part is not positive,",
            Le(w * (w - 1), 0, evaluate=False),
            {w: Interval(0, 1)},
        ),
        Shown("and t (1 - t) is at most 1/4.", Le(t * (1 - t), Rational(1, 4), evaluate=False)),
        "So the polygon of a piece is nowhere further than (d/2)(n/4) = n d/8 from the curve at the same parameter; "
        "with d = D/4^k that is n D / (8 4^k): as k grows, the polygons tend to the curve, evenly in t.",
        Known("The edges after k rounds are not longer than 1/2^k times the longest edge,", "limit/edges"),
        "by the same mean. So the control points alone, as a set, tend to the curve too: each is as near to it as the "
        "polygon, and no point of the curve is further from them than that and an edge.",
        Computed(
            "Only a check of instances: for the cubic with the points (0, 0), (1, 3), (2, 1), (3, 3), 0 to 4 rounds, "
            "seven parameters of each piece keep the bound.",
            cubic_within_bound,
        ),
        Computed(
            "Only an instance: for the quadratic with the points (0, 0), (1, 2), (2, 0) and k = 0 the bound is reached "
            "at t = 1/2, so it cannot be made smaller for all curves.",
            parabola_on_bound,
        ),
    ),
]
