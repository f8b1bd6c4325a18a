"""B-spline curves: their domain, where they lie, and what one control point moves.

Degree p, knots t_0, ..., t_{n+p+1}, control points b_0, ..., b_n; span k is [t_k, t_{k+1}).
"""

from fractions import Fraction

from sympy import Integer, Sum, Symbol

from bezteach.symbolic import i, n

from ..claim import Computed, Known, argued, claim
from ..knots import DEGREES, as_printed, letters, piece

p = Symbol("p", integer=True, nonnegative=True)


def right_end_is_lost():
    """The quadratics on the knots 0, 0, 0, 1, 1, 1 at 1, with half-open spans, and shortly before 1."""
    knots = [Fraction(knot) for knot in (0, 0, 0, 1, 1, 1)]
    at = [[as_printed(place, 2, knots, at) for place in range(3)] for at in (1, 1 - Fraction(1, 1000))]
    return at[0] == [0, 0, 0] and sum(at[1]) == 1


def shifted():
    """On whole knots each function is the first one moved: N_i(t) = N_0(t - i)."""
    return all(
        piece(1, p, range(p + 3), t, span + 1) == piece(0, p, range(p + 2), t - 1, span)
        for p in DEGREES
        for _, t in [letters(1)]
        for span in range(p + 1)
    )


CLAIMS = [
    claim(
        "bspline/count",
        "n + 1 functions of degree p take the n + p + 2 knots t_0, ..., t_{n+p+1}",
        (Sum(Integer(1), (i, 0, n + p + 1)), (n + 1) + p + 1),
        twins=[(Sum(Integer(1), (i, 0, n + p + 1)), (n + 1) + p), (Sum(Integer(1), (i, 1, n + p + 1)), n + p + 2)],
    ),
    argued(
        "bspline/domain",
        "at the end t_{n+1} of the closed domain values are limits from the left: no half-open span holds that end",
        "The curve is the sum of N_{i,p}(t) b_i for t_p <= t <= t_{n+1}. At an inner knot N_{i,0} takes the span "
        "on the right, so that every value is a limit from the right.",
        Computed(
            "By the half-open spans the quadratics on 0, 0, 0, 1, 1, 1 are all 0 at t = 1, and add up to 1 before.",
            right_end_is_lost,
        ),
        "So there the curve would jump to 0. With limits from the left the last span is closed, and what holds on it "
        "holds at its end.",
        Known("The sum of the functions is then 1 on the whole closed domain.", "bspline/unity"),
    ),
    argued(
        "bspline/hull",
        "on span k the curve lies in the hull of b_{k-p}, ..., b_k, so all of it in the hull of all control points",
        Known("On the span the other functions are 0,", "bspline/support"),
        Known("these are not negative,", "bspline/non-negative"),
        Known("and add up to one.", "bspline/unity"),
        Known("So every point is a convex combination of these p + 1 points.", "hull/definition"),
        Known("At the end of the last span take limits from the left.", "bspline/domain"),
        "At the end t_{k+1} of another span the limit from the left lies in the hull too: it is closed. It is the "
        "point of the curve unless t_{k+1} stands p + 1 times. With n = p there is one span, and both hulls are one.",
    ),
    argued(
        "bspline/affine",
        "an affine map may be applied to the control points instead of the curve",
        "The linear part may be applied to each term of the sum of N_{i,p}(t) b_i.",
        Known("The constant c is the sum of the c N_{i,p}(t) on the domain.", "bspline/unity"),
    ),
    argued(
        "bspline/local",
        "moving b_i by v moves the curve by N_{i,p}(t) v: only within the support, and by no more than v",
        "The curve is linear in b_i, and N_{i,p}(t) is its factor.",
        Known("It is 0 outside of the support,", "bspline/support"),
        Known("positive inside,", "bspline/non-negative"),
        Known("and at most 1, as all of them add up to one; it may be 1 at a knot.", "bspline/unity"),
        Known("With the end of the domain closed, t_{n+1} belongs to the last span.", "bspline/domain"),
        "With n = p the domain is one span, with p + 1 control points in all: each of them moves all of the curve.",
    ),
    argued(
        "bspline/uniform",
        "with knots at equal distances every function is the first one moved",
        "In the recursion only differences of knots and of t and a knot occur: moving all knots and t changes nothing.",
        Computed("N_{1,p}(t) = N_{0,p}(t - 1) on the knots 0, 1, 2, ..., for p = 0, ..., 4.", shifted),
    ),
]
