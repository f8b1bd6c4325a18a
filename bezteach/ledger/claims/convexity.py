"""A convex polygon has a convex curve."""

from fractions import Fraction
from itertools import combinations, product

from ..claim import Computed, Known, argued
from ..planar import curve_point, line_values, polygon_places, side
from ..signs import along_curve, roots_inside, sign_changes

CONVEX = [(0, 0), (0, 2), (2, 3), (4, 2), (3, 0)]
ANGLE = [(1, 0), (0, 0), (0, 1), (0, 0)]


def no_line_of_the_grid_meets_it_thrice():
    """All lines through two points of a grid around the convex polygon, those along its edges among them."""
    edges = zip(CONVEX, CONVEX[1:] + CONVEX[:1], strict=True)
    if not all(side(p, q, other) <= 0 for p, q in edges for other in CONVEX):
        return False
    for p, q in combinations(product(range(5), range(4)), 2):
        line = (p[1] - q[1], q[0] - p[0], p[1] * q[0] - p[0] * q[1])
        values = line_values(CONVEX, line)
        ends = (values[0] == 0) + (values[-1] == 0)
        if len(roots_inside(along_curve(values), 0, 1)) + ends > 2:
            return False
    return True


def angle_cut_thrice():
    """Three different points of the curve are on the line 18 x + 21 y = 10, which has two places of its polygon."""
    line = (18, 21, 10)
    met = {curve_point(ANGLE, at) for at in (Fraction(1, 3), Fraction(4, 9), Fraction(2, 3))}
    places, passages = polygon_places(ANGLE, line), sign_changes(line_values(ANGLE, line))
    return len(met) == 3 and not any(line_values(met, line)) and (len(places), passages) == (2, 3)


CLAIMS = [
    argued(
        "curve/convexity",
        "if the control polygon is convex, so is the curve (no line passes it more than twice)",
        "A plane polygon is called convex if no line passes it more than twice, a curve if no line meets it more than "
        "twice; passages are counted as parameters, and where b_0 = b_n the two ends count as one. A line along an "
        "edge passes the polygon infinitely often and is left out; so is, for the curve, a line that holds all of it. "
        "Only lines through no control point will be needed for the polygon.",
        "Suppose that a line l = 0 does not hold all control points and meets the curve three times. Let d_i = l(b_i), "
        "let V be the number of sign changes of the d_i, zeros left out, and e the number of ends of the curve on the "
        "line (one if they are one point).",
        Known(
            "As shown for variation diminishing, the curve meets the line at most V times between its ends,",
            "curve/variation-diminishing",
        ),
        "so that V + e >= 3.",
        "Move the line a little: let l' = l + f m with an affine function m and a small f > 0. The d_i that are not 0 "
        "keep their signs. Choose m so that it is 0 at no control point on the line: then the moved line goes through "
        "none. If b_0 is on the line, let m(b_0) have the sign opposite to that of the first d_i that is not 0; if b_n "
        "is, let m(b_n) have the sign opposite to that of the last. Both can be had at once if b_0 and b_n are "
        "different points; if they are one point, e is 1 and the first is enough.",
        "Each end on the line has brought one more sign change: the moved line has V + e >= 3 of them. So it passes "
        "the polygon three times or more, and the polygon is not convex.",
        Computed(
            "An instance: the polygon (0, 0), (0, 2), (2, 3), (4, 2), (3, 0) is convex, and of the lines through two "
            "points of the grid 0..4 x 0..3, its edges' lines among them, none meets the curve more than twice.",
            no_line_of_the_grid_meets_it_thrice,
        ),
        Computed(
            "Places instead of passages would not do: the polygon (1, 0), (0, 0), (0, 1), (0, 0) has two places on the "
            "line 18 x + 21 y = 10, one of which it passes twice; its curve meets it in three points, at t = 1/3, 4/9, "
            "2/3.",
            angle_cut_thrice,
        ),
    ),
]
