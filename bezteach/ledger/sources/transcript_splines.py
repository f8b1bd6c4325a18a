"""The transcript of lecture 5, what it says of B-splines: the recursion and the curve."""

from fractions import Fraction

from ..claims.shaping import touches
from ..claims.splines import right_end_is_lost
from ..knots import as_printed
from ..reading import amended, refuted_words, row
from .deck_curve import places_for_passages


def end_is_in_no_half_open_span():
    """With limits from the left the last control point is the end, and t = 1 is not in [t_2, t_5) = [0, 1)."""
    knots = [Fraction(knot) for knot in (0, 0, 0, 1, 1, 1)]
    near = as_printed(2, 2, knots, 1 - Fraction(1, 1000))
    return near > Fraction(99, 100) and not knots[2] <= 1 < knots[5]


def exactly(printed):
    """The slip on what a knot alone decides."""
    return amended(
        printed,
        "C^(p-m) is what every curve on these knots has; particular control points give more, as y = x^2 written with "
        "a double knot does, which has all derivatives there",
    )


LOCAL = [
    row(
        "B-splines, local instead",
        "bspline/local",
        amended(
            "functions with local support solve the problem completely",
            "with as many control points as the degree plus 1 there is one span, and every point still moves all of "
            "it; with more, each moves p + 1 spans at most",
        ),
    ),
]

DEFINITION = [
    row("B-splines, functions that are not 0 on a part only", "bspline/support"),
    row("B-splines, each control point moves a part", "bspline/local"),
    row("B-spline basis, knots that do not decrease", "bspline/definition"),
    row(
        "B-spline basis, degree or order",
        "bspline/definition",
        amended(
            "degree p (or order p, the order being the degree plus 1)",
            "not both: N_{i,p} of the recursion has the degree p, and the order p + 1",
        ),
    ),
    row(
        "B-spline basis, degree 0",
        "bspline/domain",
        refuted_words(
            "N_{i,0} is 1 for t_i <= t < t_{i+1}, else 0, for a curve on the closed domain t_p <= t <= t_{n+1}",
            "degree 2, knots 0, 0, 0, 1, 1, 1: at t = 1, which is in the domain, all functions are 0 and the curve "
            "would be at the origin; the last span must be closed, that is, the value there a limit from the left",
            right_end_is_lost,
        ),
    ),
    row("B-spline basis, recursion", "bspline/definition"),
    row(
        "B-spline basis, 0/0",
        "bspline/definition",
        amended(
            "0/0 = 0",
            "at a multiple knot the fractions are x/0 with x not 0, except at the knot; it is the product with a "
            "function that is 0 everywhere that counts as 0",
        ),
    ),
    row(
        "B-spline basis, from two of the degree below",
        "bspline/definition",
        amended(
            "a linear combination of two neighbours of one order less",
            "the factors are not numbers, they are linear in t: a combination with numbers would not raise the degree",
        ),
    ),
    row(
        "B-spline basis, what a step inherits",
        "bspline/non-negative",
        amended(
            "it inherits the properties of the lower functions",
            "sign and sum, not the support, which is one span longer at each step",
        ),
    ),
    row(
        "B-spline basis, what a step makes smoother",
        "bspline/smooth",
        amended(
            "each step makes it smoother",
            "by one derivative at a knot of multiplicity m <= p; a knot that stands p + 1 times is a jump as before",
        ),
    ),
]

CURVE = [
    row("B-spline curve, how many knots", "bspline/count"),
    row("B-spline curve, definition", "bspline/de-boor"),
    row("B-spline curve, domain", "bspline/unity"),
    row("B-spline curve, local support of the functions", "bspline/support"),
    row(
        "B-spline curve, what a control point moves",
        "bspline/local",
        refuted_words(
            "P_i affects the curve only for t_i <= t < t_{i+p+1}",
            "degree 2, knots 0, 0, 0, 1, 1, 1: P_2 is the end C(1), and t = 1 is not in [t_2, t_5) = [0, 1); at the "
            "end of the domain the interval is closed",
            end_is_in_no_half_open_span,
        ),
    ),
    row(
        "B-spline curve, hull of p + 1 points",
        "bspline/hull",
        amended(
            "for t_i <= t <= t_{i+1} the curve is in the hull of P_{i-p}, ..., P_i",
            "for p <= i <= n and t_i < t_{i+1}; at a knot t_{i+1} that stands p + 1 times the point of the curve is "
            "that of the next span, and may be elsewhere",
        ),
    ),
    row("B-spline curve, hull of all points", "bspline/hull"),
    row(
        "B-spline curve, smooth within a span",
        "bspline/smooth",
        amended(
            "within a span the curve is infinitely smooth",
            "it is a polynomial with all derivatives there, and may have a cusp where the first is 0, as a Bézier "
            "curve",
        ),
    ),
    row("B-spline curve, at a knot", "bspline/smooth"),
    row(
        "B-spline curve, exact control of the continuity",
        "bspline/smooth/sharp",
        exactly("the multiplicities of the knots control the continuity of the curve exactly"),
    ),
    row(
        "B-spline curve, variation diminishing",
        "bspline/variation-diminishing",
        places_for_passages("as for Bézier curves: no more intersections with a line than the polygon has"),
    ),
    row("B-spline curve, affine maps", "bspline/affine"),
    row(
        "B-spline curve, strong hull",
        "bspline/hull",
        amended(
            "a stronger hull property than that of Bézier curves: smaller hulls",
            "not larger ones: with p + 1 control points there is one span, and the two hulls are the same",
        ),
    ),
    row("B-spline curve, knots inserted", "bspline/insert"),
    row(
        "B-spline curve, knots adjusted",
        "bspline/knots-matter",
        refuted_words(
            "the knots may be adjusted without changing the shape of the curve",
            "degree 2, points (0, 0), (0, 2), (2, 2), (2, 0): with the knots 0, 0, 0, 1, 2, 2, 2 the curve touches y "
            "= 2 at (1, 2), with 3/2 for 1 at (3/2, 2). Only a knot inserted, with new control points, leaves it as "
            "it is",
            lambda: [touches(knot) for knot in (1, Fraction(3, 2))] == [(1, 2), (Fraction(3, 2), 2)],
        ),
    ),
    row("B-spline curve, local refinement", "bspline/insert"),
]
