"""What knots do: end points, Bézier curves as a special case, knots inserted, Bézier points.

Degree p, knots t_0, ..., t_{n+p+1}, control points b_0, ..., b_n; f is the blossom of a span.
"""

from fractions import Fraction

from ..claim import Computed, Known, argued
from ..knots import DEGREES, blossom, letters, one_span, piece, point, units
from ..signs import bernstein

ZIGZAG = [(0, 0), (1, 3), (3, 3), (4, 0), (6, 1), (7, 4)]
CLAMPED_CUBIC = tuple(map(Fraction, (0, 0, 0, 0, 1, 1, 2, 2, 2, 2)))  # 1 stands twice


def bernstein_basis():
    """On p + 1 knots 0 and p + 1 knots 1 the piece of N_{j,p} is B_{j,p}, for p = 0, ..., 4."""
    _, t = letters(1)
    return all(
        piece(j, p, [0 * t] * (p + 1) + [t**0] * (p + 1), t, p) == bernstein(j, p, t)
        for p in DEGREES
        for j in range(p + 1)
    )


def ends_are_met():
    """With p equal knots at the end of a span and letters after it: f at p times the knot is the control point."""
    return all(
        blossom(unit, knots, p, [0 * t] * p) == (place == 0)
        for p in DEGREES[1:]
        for knots, t in [letters(1, p, *[1] * (p + 1), zero=1)]
        for place, unit in enumerate(units(p, t**0))
    )


def old_from_new():
    """Boehm: a knot v more in span [0, 1]. N_{i,p} = a N'_{i,p} + (1 - a') N'_{i+1,p} on both parts, p = 0, ..., 4."""
    for p in DEGREES:
        new, t = letters(*[1] * (2 * p + 3), zero=p)  # the knot of place p + 1 is the one inserted
        old = new[: p + 1] + new[p + 2 :]
        for i in range(p + 1):
            for span in (p, p + 1):
                parts = share(i, p, old, new) * piece(i, p, new, t, span)
                parts += (1 - share(i + 1, p, old, new)) * piece(i + 1, p, new, t, span)
                if piece(i, p, old, t, p) - parts != 0:
                    return False
    return True


def share(i, p, old, new):
    """What b_i has in b'_i, b'_i = (1 - a) b_{i-1} + a b_i, if the knot of place p + 1 is inserted in span p."""
    if not 1 <= i <= p:
        return i == 0
    return (new[p + 1] - old[i]) / (old[i + p] - old[i])


def bezier_points_give_the_piece():
    """On the span [0, 1] among letters: f(0, ..., 0, 1, ..., 1) as Bézier points, p = 0, ..., 4."""
    return all(
        sum(blossom(unit, knots, p, [0 * t] * (p - j) + [t**0] * j) * bernstein(j, p, t) for j in range(p + 1))
        == piece(i, p, knots, t, p)
        for p in DEGREES
        for knots, t in [one_span(p)]
        for i, unit in enumerate(units(p, t**0))
    )


def double_knot_of_a_cubic_is_passed_by():
    """The point at the double knot lies on the edge from b_2 to b_3, in its middle, and is no control point."""
    there = point(ZIGZAG, CLAMPED_CUBIC, 3, [Fraction(1)] * 3)
    return there == (Fraction(7, 2), Fraction(3, 2)) and there not in ZIGZAG


def two_points_at_a_full_knot():
    """At a knot p + 1 times the curve ends at one control point and begins at the next, p = 1, ..., 4."""
    for p in DEGREES[1:]:
        knots = [Fraction(0)] * (p + 1) + [Fraction(1)] * (p + 1) + [Fraction(2)] * (p + 1)
        ends = [blossom(list(range(span - p, span + 1)), knots, span, [Fraction(1)] * p) for span in (p, 2 * p + 1)]
        if ends != [p, p + 1]:
            return False
    return True


CLAIMS = [
    argued(
        "bspline/through",
        "where p neighbouring knots t_{i+1}, ..., t_{i+p} are one knot s, the curve passes through b_i at s",
        Known("p(s) = f(s, ..., s) for the span that begins or ends at s,", "bspline/de-boor"),
        Known("and f is b_i at the run of b_i.", "blossom/spline"),
        Computed("With letters as the other knots, p = 1, ..., 4.", ends_are_met),
        Computed(
            "One interval of length 0 is not enough: a cubic with six control points and the knots 0, 0, 0, 0, 1, 1, "
            "2, 2, 2, 2 is at the double knot 1 in the middle of an edge.",
            double_knot_of_a_cubic_is_passed_by,
        ),
    ),
    argued(
        "bspline/ends",
        "with p + 1 equal knots at each end the curve goes from b_0 to b_n; the p inner ones of them suffice",
        Known("t_1 = ... = t_p is the run of b_0, t_{n+1} = ... = t_{n+p} that of b_n.", "bspline/through"),
        Known("At t_{n+1} the value is a limit from the left.", "bspline/domain"),
        "The knots t_0 and t_{n+p+1} enter in no point of the domain: they may be anywhere beyond.",
    ),
    argued(
        "bspline/jump",
        "at a knot p + 1 times the curve ends at b_i and begins again at b_{i+1}: whole only if they are one point",
        Known("From the left p of these knots are the run of b_i, from the right of b_{i+1}.", "bspline/through"),
        Computed("On 0, 1 and 2, each p + 1 times, p = 1, ..., 4.", two_points_at_a_full_knot),
    ),
    argued(
        "bspline/bezier",
        "with the knots 0 and 1, each p + 1 times, the B-splines are the Bernstein functions, the curve a Bézier curve",
        Known("All steps are steps of de Casteljau's algorithm, for every p,", "blossom/casteljau"),
        Known("and those with t leave the point of the curve.", "bspline/de-boor"),
        Known("Those of de Casteljau's algorithm leave the sum of the B_{j,p}(t) b_j.", "casteljau/curve"),
        Known("For degree 2 written out:", "bspline/bezier/quadratic"),
        Computed("by the recursion, p = 0, ..., 4.", bernstein_basis),
        Known("At t = 1 the values are limits from the left.", "bspline/domain"),
    ),
    argued(
        "bspline/insert",
        "a knot v more leaves the curve as it is: the new control points are the values of f at the new runs",
        "Let v lie in span k, b'_i be the value of f at the new run of b'_i: b_i for i <= k - p, b_{i-1} for i > k. "
        "For k - p < i <= k the run holds v in the place of a knot: b'_i is what one step with v makes of b_{i-1} and "
        "b_i, p points in the place of p - 1.",
        Known(
            "The run of b'_i holds all knots between span k and the spans on which b'_i enters, so "
            "it does not matter of which of these spans f is.",
            "blossom/agree",
        ),
        Known("The new steps begin with values of f, and f is affine: they leave f.", "blossom/spline"),
        Known("With all arguments t that is the curve.", "bspline/de-boor"),
        Known("For degree 2 written out, before the new knot,", "bspline/insert/quadratic"),
        Known("and after it.", "bspline/insert/quadratic/after"),
        Computed("N_{i,p} from the two new functions, with letters as knots, for p = 0, ..., 4.", old_from_new),
    ),
    argued(
        "bspline/to-bezier",
        "on the span [u, v] the curve has the Bézier points f(u, ..., u, v, ..., v)",
        Known("The curve is f(t, ..., t),", "bspline/de-boor"),
        Known("and expanded at t = (1 - w) u + w v it has these control points.", "blossom/casteljau"),
        Known("Inserting u and v until each stands p times gives them too.", "bspline/insert"),
        Computed("The pieces on [0, 1], with letters as the other knots, p = 0, ..., 4.", bezier_points_give_the_piece),
    ),
    argued(
        "bspline/variation-diminishing",
        "a plane B-spline curve crosses a line, a space curve a plane, at most as often as its polygon does",
        "Take an affine function l that is 0 on it, and let V be the number of sign changes of the l(b_i).",
        Known("Knots may be inserted until the curve is Bézier curves, one polygon in all.", "bspline/to-bezier"),
        Known("Each insertion puts points of edges, in order, in the place of control points:", "bspline/insert"),
        "a broken line whose vertices lie one after the other on the old one has no more sign changes than the old "
        "one. So V does not grow.",
        Known("Each Bézier curve meets the line at most as often as its own polygon.", "curve/variation-diminishing"),
        "Crossings are changes of the sign of l; where it only touches, the curve does not cross. Near an end of a "
        "part l has the sign of the nearest value that is not 0. So also where two parts meet in the line the curve "
        "changes sign only if the row of all values does: no more than V times in all. At a knot that stands p + 1 "
        "times the curve jumps, and the jump is counted as a crossing if l changes its sign there.",
    ),
]
