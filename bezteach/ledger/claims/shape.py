"""Where a Bézier curve lies: its tangents in words, barycentric combinations, affine maps, the convex hull."""

from fractions import Fraction

from sympy import Integer, Interval, Mul, Sum, binomial, oo

from bezteach.symbolic import i, r, t, u

from ..claim import Computed, Known, Shown, argued, eq
from ..planar import curve_point, in_hull
from ..signs import along_curve, roots_inside

TWELFTHS = [Fraction(place, 12) for place in range(13)]
WORKED = [(0, 0), (1, 3), (2, 1), (3, 3)]
ARCH, ABOVE = [(0, 0), (1, 2), (2, 0)], [(0, Fraction(3, 2)), (2, Fraction(3, 2))]


def first_edge_of_length_zero():
    points = [(0, 0), (0, 0), (1, 2)]
    return all(curve_point(points, at) == (at**2, 2 * at**2) for at in TWELFTHS)


def affine_instance():
    """The map (x, y) -> (2 x + 3 y - 1, x - y + 4) before and after."""
    mapped = [(2 * x + 3 * y - 1, x - y + 4) for x, y in WORKED]
    before = (curve_point(WORKED, at) for at in TWELFTHS)
    return [(2 * x + 3 * y - 1, x - y + 4) for x, y in before] == [curve_point(mapped, at) for at in TWELFTHS]


def hull_instance():
    return all(in_hull(WORKED, curve_point(WORKED, at)) for at in TWELFTHS)


def outside_the_hull():
    return not in_hull(WORKED, curve_point(WORKED, Fraction(2)))


def hulls_meet_and_curves_do_not():
    meeting = (Fraction(1), Fraction(3, 2))
    below = max(along_curve([0, 2, 0]).eval(at) for at in [Fraction(1, 2), 0, 1])
    slope = along_curve([0, 2, 0]).diff()
    highest = roots_inside(slope, 0, 1) == [1] and slope.eval(Fraction(1, 2)) == 0
    return in_hull(ARCH, meeting) and in_hull(ABOVE, meeting) and highest and below == 1


CLAIMS = [
    argued(
        "curve/tangent/direction",
        "the tangent at the start points to the first control point apart from it; likewise at the end",
        "Let b_0 = ... = b_{k-1}, and let b_k be another point, 1 <= k <= n. (If all control points are the same, the "
        "curve is a point and has no tangent.)",
        Known(
            "For r <= n the r-th derivative at 0 is the sum of n!/(n-r)! (-1)^(r-i) C(r, i) b_i over i = 0, ..., r.",
            "curve/derivative-r/start",
        ),
        Shown(
            "For r >= 1 the coefficients (-1)^(r-i) C(r, i) add up to 0.",
            eq(Sum((-1) ** (r - i) * binomial(r, i), (i, 0, r)), Integer(0)),
            {r: (1, oo)},
        ),
        "So the derivatives at 0 of the orders 1, ..., k - 1 are 0, and that of order k is n!/(n-k)! (b_k - b_0).",
        "By Taylor's formula p(t) = b_0 + C(n, k) t^k (b_k - b_0) + terms with higher powers of t. Divided by t^k, "
        "p(t) - p(0) tends to C(n, k) (b_k - b_0) as t > 0 tends to 0: this is the direction of the tangent.",
        "For k = 1 it is the direction of the first edge, and p'(0) is n times that edge. For k > 1 the first edge has "
        "no direction and p'(0) = 0, but the curve has its tangent.",
        Computed(
            "An instance: the control points (0, 0), (0, 0), (1, 2) give p(t) = t^2 (1, 2), for t = 0, 1/12, ..., 1.",
            first_edge_of_length_zero,
        ),
        Known("The end is the start of the curve run through backwards.", "curve/symmetry"),
    ),
    argued(
        "curve/barycentric",
        "every point of the curve is a barycentric combination of the control points",
        "A combination of points is barycentric if its coefficients add up to one: it is then the same point, "
        "whichever origin the vectors to the points start from.",
        Known("p(t) is the combination of the b_j with the coefficients B_{j,n}(t).", "curve/definition"),
        Known("They add up to one, for every t.", "basis/unity"),
        Known("So if the origin moves, all control points and the curve move by the same v.", "curve/moved/together"),
        Known("For 0 <= t <= 1 no coefficient is negative: the combination is also convex.", "basis/non-negative"),
    ),
    argued(
        "curve/affine/coordinates",
        "an affine map of the plane or of space may be applied to the control points instead of the curve",
        "An affine map makes each new coordinate from the old ones as a_1 x_1 + ... + a_d x_d + c.",
        "Let x_1, ..., x_d be the coordinates of p(t), and x_{1,j}, ..., x_{d,j} those of b_j. Then a_1 x_1 + ... + "
        "a_d x_d is the sum over j of (a_1 x_{1,j} + ... + a_d x_{d,j}) B_{j,n}(t): sums may be taken in any order.",
        Known("The constant c is the sum of the c B_{j,n}(t), as the B_{j,n}(t) add up to one.", "basis/unity"),
        "Together: each coordinate of the mapped curve point is the combination of those of the mapped control points. "
        "Only that the coefficients add up to one was used; that they lie between 0 and 1 is not needed.",
        Known("In one line, A being a number or the matrix of the a's.", "curve/affine"),
        Computed(
            "An instance: (x, y) -> (2 x + 3 y - 1, x - y + 4) and the control points (0, 0), (1, 3), (2, 1), (3, 3), "
            "at t = 0, 1/12, ..., 1.",
            affine_instance,
        ),
    ),
    argued(
        "curve/affine/cost",
        "mapping the n + 1 control points is less work than mapping more than n + 1 points of the curve",
        Known("The curve of the mapped control points is the mapped curve.", "curve/affine/coordinates"),
        "An affine map of the plane takes 4 multiplications and 4 additions for a point: for m points of the drawn "
        "curve 4 m of each, for the control points 4 (n + 1) of each. It is less work if and only if n + 1 < m; for a "
        "cubic that is drawn with 100 points, a 25th.",
    ),
    argued(
        "hull/definition",
        "the convex combinations of some points are the smallest convex set that holds them",
        "A set is convex if with two points it holds the segment between them. A combination of points is convex if "
        "its coefficients a_0, ..., a_n are not negative and add up to one. Let V be the set of all convex "
        "combinations of b_0, ..., b_n.",
        "V holds each b_j: take a_j = 1, the others 0.",
        "V is convex: between two combinations with the coefficients a_j and c_j, the point at 0 <= u <= 1 has the "
        "coefficients (1 - u) a_j + u c_j, which are not negative, and whose sum is (1 - u) + u = 1.",
        "V is the smallest: let a convex set hold all b_j. It holds the convex combinations of a single one of them. "
        "If it holds those of m of them, it holds those of m + 1: with a_m < 1 the combination is the point at u = a_m "
        "on the segment from the combination of the first m with the coefficients a_j / (1 - a_m) to b_m; with a_m = 1 "
        "it is b_m.",
        Shown(
            "For at this u the coefficients come back: with t for a_j and u for a_m,",
            eq(Mul(1 - u, t / (1 - u), evaluate=False), t),
            {u: Interval.Ropen(0, 1)},
        ),
    ),
    argued(
        "curve/hull",
        "for 0 <= t <= 1 the curve lies in the convex hull of its control points",
        "A point is in the hull if it is a combination of the control points whose coefficients are not negative and "
        "add up to one.",
        Known("p(t) is the combination with the coefficients B_{j,n}(t).", "curve/definition"),
        Known("On [0, 1] they are not negative,", "basis/non-negative"),
        Known("and they add up to one.", "basis/unity"),
        Computed(
            "An instance: for (0, 0), (1, 3), (2, 1), (3, 3) the points at t = 0, 1/12, ..., 1 lie in the hull, by "
            "exact comparison with each of its edges.",
            hull_instance,
        ),
        Computed("Beyond [0, 1] it need not hold: at t = 2 the point of that curve is outside.", outside_the_hull),
    ),
    argued(
        "curve/hull/range",
        "every coordinate of the curve stays between the least and the greatest of the control points",
        Known("The curve lies in the convex hull of its control points.", "curve/hull"),
        "The points whose coordinate lies between the two bounds are a convex set that holds the control points.",
        Known("So this set holds the smallest such set, the hull, and the curve.", "hull/definition"),
    ),
    argued(
        "curve/hull/disjoint",
        "if the convex hulls of two curves have no point in common, neither have the curves",
        Known("Each curve lies in the convex hull of its control points.", "curve/hull"),
        "So a point of both curves would be a point of both hulls.",
        Computed(
            "The converse is false: the hulls of (0, 0), (1, 2), (2, 0) and of (0, 3/2), (2, 3/2) share (1, 3/2), but "
            "the first curve is highest at t = 1/2, where y = 1, and the second runs at y = 3/2.",
            hulls_meet_and_curves_do_not,
        ),
    ),
]
