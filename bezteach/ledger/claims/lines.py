"""The curve and lines and points: on which line it lies, which control points it may pass, where it is not smooth."""

from fractions import Fraction

from sympy import Derivative, Lt

from bezteach.symbolic import B, i, n, t

from ..claim import Computed, Known, Shown, argued, claim, eq
from ..forms import FROM_TWO, UNIT, curve_of
from ..planar import cross, curve_point, minus, velocity
from ..signs import along_curve

THROUGH_SECOND = [(0, 0), (1, 1), (2, 0), (-1, 5)]
CUSP = [(0, 0), (1, 1), (0, 1), (1, 0)]


def passes_second_point():
    """Whether a curve whose points are not on a line passes b_1 at t = 1/2."""
    first, second, third, _ = THROUGH_SECOND
    return (
        curve_point(THROUGH_SECOND, Fraction(1, 2)) == second and cross(minus(second, first), minus(third, first)) != 0
    )


def turns_beyond_the_end():
    """Whether the points 0, 2, 1 on a line give a curve that reaches 4/3 and nothing beyond."""
    heights = along_curve([0, 2, 1])
    slope = heights.diff()
    return [slope.eval(Fraction(2, 3)), heights.eval(Fraction(2, 3))] == [0, Fraction(4, 3)] and slope.degree() == 1


def stands_still():
    """Whether the curve of the cusp has velocity 0 at t = 1/2, rises before that and falls after it."""
    before, after = velocity(CUSP, Fraction(1, 4)), velocity(CUSP, Fraction(3, 4))
    return velocity(CUSP, Fraction(1, 2)) == (0, 0) and before[1] > 0 > after[1]


CLAIMS = [
    argued(
        "line/collinear",
        "the curve lies on a line exactly if its control points do; then it covers a segment of it",
        "Take an affine function d that is 0 on the line and nowhere else, in space two with this in common, and let "
        "d_i be its values at the control points.",
        Known("Along the curve d is the sum of the d_i B_{i,n}(t), because the basis sums to 1.", "basis/unity"),
        "If all control points are on the line, all d_i are 0, and so is d along the curve.",
        Known(
            "If the curve is on the line, this sum is 0 for all t in [0, 1], so all d_i are: the basis is independent.",
            "basis/independent",
        ),
        "The curve is the image of [0, 1] under a continuous map. On a line such an image is a closed interval: a "
        "segment, or one point if all control points are one.",
        Computed(
            "The segment need not end at b_0 and b_n: the points 0, 2, 1 on a line give 4t - 3t^2, which covers "
            "[0, 4/3] and turns back.",
            turns_beyond_the_end,
        ),
    ),
    claim(
        "points/weight-of-one",
        "an inner control point never has the whole weight",
        Lt(B(i, n, t), 1, evaluate=False),
        FROM_TWO | {i: (1, n - 1)} | UNIT,
        twins=[Lt(B(i, n, t), B(i, n, i / n), evaluate=False), Lt(B(i - 1, n, t), 1, evaluate=False)],
    ),
    argued(
        "points/inner",
        "the curve passes its first and last control point always, an inner one only for special polygons",
        Known("It starts at the first,", "curve/start"),
        Known("and ends at the last, whatever the others are.", "curve/end"),
        Known(
            "For a polygon with b_i in one place and all other points in a second place, the curve misses b_i: it "
            "would need the weight B_{i,n}(t) = 1.",
            "points/weight-of-one",
        ),
        Computed(
            "Others are passed: the cubic with (0, 0), (1, 1), (2, 0), (-1, 5) is at (1, 1) for t = 1/2.",
            passes_second_point,
        ),
    ),
    argued(
        "points/cusp",
        "a curve has derivatives of every order, and still it may have a cusp",
        Known("Each coordinate is a polynomial in t, which has all derivatives.", "curve/powers"),
        Shown(
            "For the cubic with the points (0, 0), (1, 1), (0, 1), (1, 0) the velocity is 3 (1 - 2t)^2 in x,",
            eq(Derivative(curve_of([x for x, _ in CUSP]), t), 3 * (1 - 2 * t) ** 2),
        ),
        Shown("and 3 (1 - 2t) in y.", eq(Derivative(curve_of([y for _, y in CUSP]), t), 3 * (1 - 2 * t))),
        Computed("At t = 1/2 it stands still, before that it rises, after that it falls.", stands_still),
        "The direction of the velocity tends to (0, 1) from the left and to (0, -1) from the right: the curve turns "
        "back on itself, which is a cusp.",
    ),
]
