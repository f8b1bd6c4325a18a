"""The deck, section 1: the properties of the curve."""

from fractions import Fraction

from sympy import Mul, Sum, Symbol, binomial, factorial

from bezteach.symbolic import B, b, i, j, k, n, u

from ..claims.curve import CURVE, p, q
from ..claims.quartic import HEIGHTS, omega, x
from ..forms import curve, derivative_at
from ..planar import curve_point, polygon_places
from ..reading import amended, refuted, refuted_words, row

SIGNED = (-1) ** (k - i) * binomial(k, i)

LOOP = [(0, 0), (1, 1), (-1, 1), (6, -6)]


def derivative_k(at, point):
    """The printed formula of the k-th derivative at an end."""
    return derivative_at(at, CURVE, k), factorial(n) / factorial(n - k) * Sum(SIGNED * point, (i, 0, k))


def one_place_for_two():
    """The polygon has one place on y = 0, the curve two, at its start and at t = 1/2."""
    axis = (0, 1, 0)
    met = [curve_point(LOOP, at) for at in (Fraction(0), Fraction(1, 2))]
    return polygon_places(LOOP, axis) == {(0, 0)} and met == [(0, 0), (Fraction(3, 4), 0)]


def places_for_passages(printed):
    """The slip of counting the places where the polygon meets a line, and not its passages."""
    return refuted_words(
        printed,
        "the polygon (0, 0), (1, 1), (-1, 1), (6, -6) meets y = 0 in the one point (0, 0), through which it passes "
        "twice; its curve meets y = 0 in two points, (0, 0) and (3/4, 0). What must be counted are the passages",
        one_place_for_two,
    )


INTERVAL = Mul(u - Symbol("a", real=True), 1 / (Symbol("b", real=True) - Symbol("a", real=True)), evaluate=False)

ROWS = [
    row("1.2, curve property 1, start", "curve/start"),
    row("1.2, curve property 1, end", "curve/end"),
    row("1.2, curve property 2, tangent at the start", "curve/tangent/start"),
    row("1.2, curve property 2, tangent at the end", "curve/tangent/end"),
    row(
        "1.2, curve property 2, in words",
        "curve/tangent/direction",
        amended(
            "the tangent vectors at the ends are parallel to the first and the last edge, and n times as long",
            "edges of length 0 are left out: if b_0 = b_1, the edge has no direction and p'(0) = 0, but the curve can "
            "have a tangent, towards the next control point",
        ),
    ),
    row("1.2, curve property 2, second derivative at the start", "curve/second/start"),
    row("1.2, curve property 2, second derivative at the end", "curve/second/end"),
    row(
        "1.2, curve property 2, k-th derivative at the start",
        "curve/derivative-r/start",
        amended(
            derivative_k(0, b[i]),
            "k <= n is left out: for k > n the derivative is 0 and (n - k)! has no value; p^k is the k-th derivative, "
            "its brackets are missing",
        ),
    ),
    row(
        "1.2, curve property 2, k-th derivative at the end",
        "curve/derivative-r/end",
        refuted(derivative_k(1, b[n - i]), {k: (0, n)}),
    ),
    row("1.2, curve property 2, first k edges, k + 1 vertices", "curve/derivative-r/start/edges"),
    row("1.2, curve property 2, last k edges, k + 1 vertices", "curve/derivative-r/end/edges"),
    row("1.2, curve property 3, affine invariance", "curve/affine/coordinates"),
    row("1.2, curve property 3, reason, not negative", "basis/non-negative"),
    row("1.2, curve property 3, reason, at most 1", "basis/at-most-one"),
    row("1.2, curve property 3, reason, sum", "basis/unity"),
    row("1.2, curve property 3, barycentric combination", "curve/barycentric"),
    row("1.2, curve property 3, use", "curve/affine/cost"),
    row("1.2, curve property 4, symmetry", "curve/symmetry"),
    row("1.2, curve property 5, definition of the hull", "hull/definition"),
    row("1.2, curve property 5, hull", "curve/hull"),
    row("1.2, curve property 5, use, range of the curve", "curve/hull/range"),
    row("1.2, curve property 5, use, no intersection", "curve/hull/disjoint"),
    row(
        "1.2, curve property 6, definition of convex",
        "curve/convexity",
        amended(
            "a plane curve or polygon is convex if every line meets it in at most two points",
            "lines along an edge are left out: they meet a polygon in infinitely many points, so that no polygon at "
            "all would be convex; and points are to be counted as often as they are passed",
        ),
    ),
    row("1.2, curve property 6, line and segment", "line/meets-segment"),
    row("1.2, curve property 6, line and curve from A to B", "line/meets-curve"),
    row(
        "1.2, curve property 6, variation diminishing",
        "curve/variation-diminishing",
        places_for_passages(
            "a line (plane) does not meet a plane (space) curve in more points than its control polygon"
        ),
    ),
    row(
        "1.2, curve property 6, convexity theorem",
        "curve/convexity",
        amended(
            "if the control polygon is convex, so is the curve",
            "convex must not be taken as it is defined on the slide before: that no line along an edge counts, and "
            "that a place counts as often as it is passed, is left out there; with the first alone, the right angle "
            "(1, 0), (0, 0), (0, 1), (0, 0), whose second leg is passed twice, would be convex and its curve not",
        ),
    ),
    row("1.2, curve property 6, converse of the theorem", "curve/convexity/converse"),
    row("1.2, curve property 6, quartic, x", "quartic/x"),
    row(
        "1.2, curve property 6, quartic, y",
        "quartic/y",
        refuted((HEIGHTS, (1 - x) ** 3 * x + 6 * omega * (1 - x**2) * x**2 + (1 - x) * x**3)),
    ),
    row("1.2, curve property 6, quartic, y''", "quartic/second-derivative"),
    row("1.2, curve property 6, quartic, convex for 0 <= omega <= 1/2", "quartic/convex"),
    row("1.2, curve property 6, quartic, two inflections", "quartic/inflections"),
    row("1.2, curve property 6, quartic, 0 < omega < 1/4", "curve/convexity/converse"),
    row(
        "1.2, curve property 7, linear precision",
        "curve/linear-precision",
        amended(
            (Sum(B(j, n, u) * ((1 - j / n) * p + j / n * q), (j, 0, n)), (1 - u) * p + u * q),
            "n >= 1 is left out, without which j/n is no number, and so is that the two points are different: else the "
            "segment is a point",
        ),
    ),
    row(
        "1.2, curve property 8, affine change of the parameter",
        "curve/reparametrised",
        amended(
            (curve(), curve(at=INTERVAL)),
            "that t stands for (u - a)/(b - a) is left out, and that a < b: for a = b nothing is defined, for a > b "
            "the interval is [b, a]",
        ),
    ),
    row(
        "1.2, curve property 9, influence of the j-th control point",
        "curve/influence",
        amended(
            "moving the j-th control point of a curve of degree n has the most influence at the parameter j/n",
            "control points are counted from 0, as their indices are: the first one is b_0 and acts most at 0; and "
            "n >= 1 is left out",
        ),
    ),
    row("1.2, summary, a curve of polynomials", "curve/powers"),
    row("1.2, summary, shortcoming 1, not local", "influence/everywhere"),
    row("1.2, summary, shortcoming 2, number of control points and degree", "curve/count"),
    row("1.2, summary, shortcoming 3, still polynomials", "curve/powers"),
]
