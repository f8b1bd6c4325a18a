"""The deck, section 2.2: hodographs and derivatives, at the ends and inside."""

from fractions import Fraction
from itertools import pairwise

from sympy import Derivative, Sum, oo

from bezteach.symbolic import B, b, i, j, n, t

from ..claims import derivatives, interior
from ..forms import FROM_ONE, curve
from ..planar import levels, velocity
from ..reading import amended, refuted, refuted_words, row

LINE = [(Fraction(0),), (Fraction(1),)]
SQUARE = [(Fraction(0),), (Fraction(0),), (Fraction(1),)]


def without_order(printed):
    """The slip of a derivative of order r with no word on r."""
    return amended(printed, "r <= n is left out: (n - r)! has no value for r > n, where the derivative is 0")


def for_cubics(general, cubic):
    """The slip of an equality that holds for cubics only."""
    return amended((general, cubic), "n = 3 is left out: for another degree the two sides differ", {n: (3, oo)})


def one_edge():
    """A line has one edge, not none."""
    return len(list(pairwise(LINE))) != len(LINE) - 2


def derivative_not_constant():
    """The derivative of t^2 is no curve with one control point, which would stay where it is."""
    return velocity(SQUARE, 0) != velocity(SQUARE, 1)


def two_points_for_first_order():
    """A line's first derivative takes both points of level 0, and not one."""
    return len(levels(LINE, Fraction(1, 2))[0]) != 1


ROWS = [
    row(
        "2.2, hodograph, derivative of the basis",
        "basis/derivative",
        amended(
            (Derivative(B(i, n, t), t), n * (B(i - 1, n - 1, t) - B(i, n - 1, t))),
            "i = 0 is left out of the range i = 1, ..., n, and the next line needs it: the formula holds there too",
            FROM_ONE | {i: (1, n)},
        ),
    ),
    row("2.2, hodograph, derivative of the curve", "curve/hodograph/from-basis"),
    row("2.2, hodograph, functions with a negative index", "basis/vanishes-below"),
    row("2.2, hodograph, functions with an index above the degree", "basis/vanishes-above"),
    row("2.2, hodograph, simplified", "curve/hodograph/proof"),
    row("2.2, hodograph, relative vectors", "difference/first"),
    row(
        "2.2, hodograph, number of absolute vectors",
        "curve/hodograph/points",
        refuted_words(
            "the relative vectors b_{j+1} - b_j, j = 0, ..., n - 1, make n - 1 absolute vectors",
            "n = 1: there is one, b_1 - b_0, and n - 1 = 0; they are n",
            one_edge,
        ),
    ),
    row(
        "2.2, hodograph, number of its control points",
        "curve/hodograph/points",
        refuted_words(
            "n - 1 absolute vectors as control points make a curve of degree n - 1",
            "n = 2: one control point makes a curve that stays where it is, and the derivative of t^2, which has the "
            "control points 0, 0, 1, is 0 at t = 0 and 2 at t = 1; n control points are needed",
            derivative_not_constant,
        ),
    ),
    row(
        "2.2, hodograph, first hodograph",
        "curve/hodograph",
        amended(
            (Derivative(curve(), t), Sum((b[j + 1] - b[j]) * B(j, n - 1, t), (j, 0, n - 1))),
            "the curve whose control points are the differences is the derivative without its factor n; two slides on, "
            "the derivative of order r with its factor is called the hodograph of order r",
            FROM_ONE,
        ),
    ),
    row("2.2, hodograph, those of higher order", "curve/derivative-r"),
    row("2.2, higher derivatives, operator form", "casteljau/curve"),
    row("2.2, higher derivatives, first", "curve/derivative/operator"),
    row(
        "2.2, higher derivatives, second",
        "curve/second-derivative/operator",
        amended(
            derivatives.SECOND,
            "n >= 2 is left out: for a line the power has the exponent -1",
            FROM_ONE,
        ),
    ),
    row("2.2, higher derivatives, factor of order r", "curve/derivative-r/factor"),
    row("2.2, higher derivatives, order r", "curve/derivative-r", without_order(derivatives.ORDER_R_LINES)),
    row(
        "2.2, at the ends, order r at 0",
        "curve/derivative-r/start/difference",
        without_order(derivatives.START_R),
    ),
    row(
        "2.2, at the ends, order r at 1",
        "curve/derivative-r/end/difference",
        without_order(derivatives.END_R),
    ),
    row("2.2, at the ends, r + 1 control points, at 0", "curve/derivative-r/start"),
    row("2.2, at the ends, r edges, at 0", "curve/derivative-r/start/edges"),
    row("2.2, at the ends, r + 1 control points, at 1", "curve/derivative-r/end"),
    row("2.2, at the ends, r edges, at 1", "curve/derivative-r/end/edges"),
    row("2.2, at the ends, tangent at 0", "curve/tangent/start/difference"),
    row("2.2, at the ends, tangent at 1", "curve/tangent/end/difference"),
    row("2.2, at the ends, second derivative at 0", "curve/second/start/difference"),
    row("2.2, at the ends, second derivative at 1", "curve/second/end/difference"),
    row("2.2, at the ends, curvature at 0, cross product", "curve/curvature/start/cross"),
    row(
        "2.2, at the ends, curvature at 0, first equality",
        "curve/curvature/start/derivatives",
        amended(
            "the curvature at 0 is |p' x p''|/|p'|^3, whatever the control points",
            "that b_1 - b_0 is not 0 is left out: else 0 is divided by 0",
        ),
    ),
    row("2.2, at the ends, curvature at 0, second equality", "curve/curvature/start"),
    row("2.2, at the ends, curvature at 1, cross product", "curve/curvature/end/cross"),
    row(
        "2.2, at the ends, curvature at 1, first equality",
        "curve/curvature/end/derivatives",
        amended(
            "the curvature at 1 is |p' x p''|/|p'|^3, whatever the control points",
            "that b_n - b_{n-1} is not 0 is left out: else 0 is divided by 0",
        ),
    ),
    row("2.2, at the ends, curvature at 1, second equality", "curve/curvature/end"),
    row(
        "2.2, inside, order r again",
        "curve/derivative-r",
        without_order((derivatives.ORDER_R_LINES[0], derivatives.ORDER_R_LINES[-1])),
    ),
    row("2.2, inside, from intermediate points", "curve/derivative-r/inside"),
    row("2.2, inside, in words", "curve/derivative-r/inside"),
    row("2.2, inside, difference of order r", "casteljau/difference"),
    row(
        "2.2, inside, number of points",
        "casteljau/difference/points",
        refuted_words(
            "b_0^{n-r}, ..., b_r^{n-r} are the r points of column n - r",
            "n = r = 1: b_0^0 and b_1^0 are two points, and r = 1; they are r + 1",
            two_points_for_first_order,
        ),
    ),
    row(
        "2.2, inside, column",
        "casteljau/difference/points",
        amended(
            "the points of level n - r are column n - r of the triangle",
            "columns are counted from 0 here, by the upper index: the first column holds the control points",
        ),
    ),
    row("2.2, inside, by-product of the algorithm", "curve/derivative-r/inside"),
    row(
        "2.2, inside, third derivative",
        "casteljau/derivative/third",
        refuted(
            (Derivative(derivatives.CURVE, (t, 3)), interior.from_points(n * (n - 1) * (n - 2), n - 3, (1, -3, 3, 1))),
            {n: (3, oo)},
        ),
    ),
    row(
        "2.2, inside, third derivative, n = 3",
        "cubic/derivative/third",
        refuted((interior.cubic(3), interior.from_points(6, 0, (1, -3, 3, 1)))),
    ),
    row("2.2, inside, second derivative", "casteljau/derivative/second"),
    row(
        "2.2, inside, second derivative, n = 3",
        "cubic/derivative/second",
        for_cubics(interior.SECOND, interior.from_points(6, 1, (1, -2, 1))),
    ),
    row("2.2, inside, first derivative", "casteljau/derivative/first"),
    row(
        "2.2, inside, first derivative, n = 3",
        "cubic/derivative/first",
        for_cubics(interior.FIRST, interior.from_points(3, 2, (1, -1))),
    ),
    row("2.2, inside, triangle of a cubic", "casteljau/levels"),
]
