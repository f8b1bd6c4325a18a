"""What knots and control points do to the shape of a B-spline curve.

Degree p, knots t_0, ..., t_{n+p+1}, control points b_0, ..., b_n.
"""

from fractions import Fraction

from ..claim import Computed, Known, argued
from ..knots import point
from ..planar import cross, minus
from .insertion import CLAMPED_CUBIC, ZIGZAG


def touches(knot):
    """Where the quadratic on 0, 0, 0, knot, 2, 2, 2 with the points (0, 0), (0, 2), (2, 2), (2, 0) meets y = 2."""
    knots = [Fraction(value) for value in (0, 0, 0, knot, 2, 2, 2)]
    points = [(0, 0), (0, 2), (2, 2), (2, 0)]
    return point(points, knots, 2, [knots[3]] * 2)


def inserting_makes_no_corner():
    """The quadratic on 0, 0, 0, 2, 2, 2 with the knot 1 once and twice more: the same point and direction at 1."""
    points = [(0, 0), (1, 2), (2, 0)]
    knots = [Fraction(value) for value in (0, 0, 0, 2, 2, 2)]
    new = [point(points, knots, 2, run) for run in ([0, 0], [0, 1], [1, 1], [1, 2], [2, 2])]
    return minus(new[2], new[1]) == minus(new[3], new[2])


def corner_at_a_double_knot():
    """The quadratic on 0, 0, 0, 1, 1, 2, 2, 2 with (0, 0), (0, 1), (1, 1), (2, 1), (2, 0) has none, with (1, 2) one."""
    flat, bent = [[(0, 0), (0, 1), middle, (2, 1), (2, 0)] for middle in ((1, 1), (1, 2))]
    return [cross(minus(x[2], x[1]), minus(x[3], x[2])) == 0 for x in (flat, bent)] == [True, False]


def straight_with_points_on_a_line():
    """On its first span the quadratic on 0, ..., 6 is straight if b_0, b_1, b_2 are on a line, whatever b_3 is."""
    points, knots = [(0, 0), (1, 1), (3, 3), (4, 0)], [Fraction(knot) for knot in range(7)]
    places = [point(points, knots, span, [at, at]) for span in (2, 3) for at in (span, span + Fraction(1, 2))]
    return [x == y for x, y in places] == [True, True, True, False]


def multiple_knots_do_not_straighten():
    """The cubic with the double knot 1: three points of the span before it are not on a line."""
    first, middle, last = [point(ZIGZAG, CLAMPED_CUBIC, 3, [Fraction(at, 2)] * 3) for at in range(3)]
    return cross(minus(middle, first), minus(last, first)) != 0


CLAIMS = [
    argued(
        "bspline/knots-matter",
        "moving a knot, with the control points kept, changes the curve in general, as a set of points too",
        "A quadratic with simple inner knots touches each inner edge of its polygon at a knot.",
        Computed(
            "With (0, 0), (0, 2), (2, 2), (2, 0) and the knots 0, 0, 0, s, 2, 2, 2 it touches y = 2 at (s, 2).",
            lambda: [touches(knot) for knot in (1, Fraction(3, 2))] == [(1, 2), (Fraction(3, 2), 2)],
        ),
        "The tangent there is that edge, y < 2 elsewhere: for another s it is another set.",
    ),
    argued(
        "bspline/corner",
        "at a knot p times the curve arrives along b_i - b_{i-1} and leaves along b_{i+1} - b_i, if these are not 0: a "
        "corner if their directions differ",
        Known("It passes through b_i.", "bspline/through"),
        Known("On both sides it is a Bézier curve; b_{i-1} and b_{i+1} are on its end tangents:", "bspline/to-bezier"),
        "the last step before f(s, ..., s) lies between f(u, s, ..., s) and f(s, ..., s), and the former is on the "
        "line from b_{i-1} to b_i, as f is affine in u.",
        Computed(
            "A double knot of a quadratic, with and without a corner: the knot alone makes none.",
            corner_at_a_double_knot,
        ),
        Computed("Inserting the knots keeps the tangent: the new edges have one direction.", inserting_makes_no_corner),
        Known("For inserting leaves the curve as it is.", "bspline/insert"),
    ),
    argued(
        "bspline/straight",
        "if b_{k-p}, ..., b_k are on a line, the curve on span k is on that line",
        Known("It lies in their hull.", "bspline/hull"),
        Computed("A quadratic with three points on a line, and the next span.", straight_with_points_on_a_line),
        Computed("A multiple knot makes nothing straight.", multiple_knots_do_not_straighten),
    ),
]
