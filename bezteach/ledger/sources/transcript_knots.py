"""The transcript of lecture 5, what it says of knots and their multiplicities, and its summary of B-splines."""

from ..claims.insertion import double_knot_of_a_cubic_is_passed_by, two_points_at_a_full_knot
from ..claims.shaping import inserting_makes_no_corner, multiple_knots_do_not_straighten
from ..claims.smoothness import smoother_by_chance
from ..claims.splines import right_end_is_lost
from ..reading import amended, refuted_words, row
from .transcript_splines import exactly

KNOTS = [
    row("knots, uniform", "bspline/uniform"),
    row("knots, quasi-uniform", "bspline/ends"),
    row("knots, quasi-uniform, ends", "bspline/ends"),
    row(
        "knots, any",
        "bspline/support",
        amended(
            "any knots that do not decrease",
            "none may stand more than p + 1 times, or a function is 0 everywhere and its control point has no "
            "influence",
        ),
    ),
    row(
        "multiple knots, less continuity",
        "bspline/smooth/sharp",
        exactly("at a knot of multiplicity k the continuity falls to C^(p-k)"),
    ),
    row(
        "multiple knots, p times",
        "bspline/corner",
        refuted_words(
            "for k = p the curve is only C^0",
            "degree 2, points (0, 0), (1/2, 0), (1, 1), (3/2, 2), (2, 4), knots 0, 0, 0, 1, 1, 2, 2, 2: all of it is "
            "y = x^2, with all derivatives at the double knot. C^0 is what is sure; there is a corner only if the "
            "edges at the control point there have different directions",
            smoother_by_chance,
        ),
    ),
    row(
        "multiple knots, p + 1 times",
        "bspline/jump",
        refuted_words(
            "for k = p + 1 the curve breaks, which may be understood as interpolating the control point",
            "it ends at one control point and begins again at the next: with the control points 0, 1, 2, ... on a "
            "line it jumps from p to p + 1 at an inner knot, for p = 1, ..., 4. What passes through one point is a "
            "knot p times",
            two_points_at_a_full_knot,
        ),
    ),
    row(
        "multiple knots, a span of length 0",
        "bspline/through",
        refuted_words(
            "a span of length 0 makes the curve pass through the control point that belongs to it",
            "the cubic with (0, 0), (1, 3), (3, 3), (4, 0), (6, 1), (7, 4) and the knots 0, 0, 0, 0, 1, 1, 2, 2, 2, 2 "
            "is at (7/2, 3/2) for t = 1, at none of them; it takes p equal knots, p - 1 such spans",
            double_knot_of_a_cubic_is_passed_by,
        ),
    ),
    row("multiple knots, the ends", "bspline/ends"),
    row(
        "multiple knots, corners",
        "bspline/corner",
        refuted_words(
            "inserting multiple knots makes corners",
            "the quadratic with (0, 0), (1, 2), (2, 0), knots 0, 0, 0, 2, 2, 2, and 1 inserted twice arrives at t = 1 "
            "and leaves it in one direction: inserting changes nothing. The corner comes when a control point beside "
            "the multiple knot is moved",
            inserting_makes_no_corner,
        ),
    ),
    row(
        "multiple knots, straight parts",
        "bspline/straight",
        refuted_words(
            "inserting multiple knots makes straight parts",
            "the cubic with the knots 0, 0, 0, 0, 1, 1, 2, 2, 2, 2 and the points (0, 0), (1, 3), (3, 3), (4, 0), (6, "
            "1), (7, 4): three of its points before the double knot are on no line. It takes p + 1 neighbouring "
            "control points on a line",
            multiple_knots_do_not_straighten,
        ),
    ),
    row("Bézier curves, a special case", "bspline/bezier"),
    row("Bézier curves, their knots", "bspline/bezier"),
    row(
        "Bézier curves, the functions",
        "bspline/bezier",
        refuted_words(
            "with these knots the B-spline functions are the Bernstein functions",
            "B_{2,2}(1) = 1, and by the half-open spans of degree 0 all functions on 0, 0, 0, 1, 1, 1 are 0 at t = 1; "
            "it is so with the last span closed",
            right_end_is_lost,
        ),
    ),
]

SUMMARY = [
    row("summary, local control", "bspline/local"),
    row(
        "summary, exact control of the continuity",
        "bspline/smooth/sharp",
        exactly("the multiplicities of the knots control the continuity exactly"),
    ),
    row("summary, Bézier curves generalised", "bspline/bezier"),
]

CLOSING = [
    row(
        "summary, what the basis decides",
        "bspline/smooth/sharp",
        exactly("the basis functions decide the continuity, the control points the geometry"),
    ),
    row("outlook, weights give conics", "rational/circle"),
]
