"""Circles, and the curves that can be one: points with weights, a polynomial curve of space seen from the origin.

A coordinate of a point is one letter. R and S are the sums of w_i B_{i,n}(t) and of w_i B_{i,n}(t) b_i over all i but
j, f is B_{j,n}(t), and x a coordinate of b_j with the weight w.
"""

from fractions import Fraction

from sympy import IndexedBase, Interval, Mul, Poly, Sum, oo, symbols

from bezteach.symbolic import B, b, i, n, t

from ..claim import Computed, Known, Shown, argued, claim, eq
from ..forms import curve, curve_of, difference, quotient
from ..planar import curve_point, in_hull

weight = IndexedBase("w")
w0, w1, w2, c, k, w, h, x, y, u, v = symbols("w_0 w_1 w_2 c k w h x y u v", real=True)
R, S, f = symbols("R S f", real=True)
POSITIVE = Interval.open(0, oo)

WEIGHT = curve_of([1, 1, 2])
X, Y = curve_of([1, 1, 0]), curve_of([0, 1, 2])  # (1, 0), (1, 1), (0, 1), each times its weight
QUARTER = [(1, 0, 1), (1, 1, 1), (0, 2, 2)]  # the same points, lifted

OFF = curve_of([1, 1, k, 0]) ** 2 + curve_of([0, k, 1, 1]) ** 2 - 1  # the cubic (1, 0), (1, k), (k, 1), (0, 1)
FLAT = t * (1 - t)

ABOUT = curve_of([w0, w1, 0]) ** 2 + curve_of([0, w1, w2]) ** 2 - curve_of([w0, w1, w2]) ** 2

SHARE = quotient(w * f, R + w * f)
PULLED = quotient(S + w * f * x, R + w * f)
PULLING = {R: POSITIVE, f: POSITIVE, w: POSITIVE}


def top_is_a_sum_of_squares():
    """For the degrees 1 to 6, all coefficients and the centre letters: the coefficient of t^(2n), and none above."""
    return all(
        Poly(squares, t).degree() == 2 * degree
        and (Poly(squares, t).LC() - highest[0] ** 2 - highest[1] ** 2).expand() == 0
        for degree, squares, highest in map(distance_squared, range(1, 7))
    )


def distance_squared(degree):
    """The degree, |p - c|^2 as an expression in t, and the two highest coefficients of p."""
    rows = [symbols(f"{name}_0:{degree + 1}", real=True) for name in "xy"]
    parts = [sum(a * t**power for power, a in enumerate(row)) - c for row, c in zip(rows, (u, v), strict=True)]
    return degree, sum(part**2 for part in parts).expand(), [row[-1] for row in rows]


def shadow(lifted):
    """The point of the plane that a point of space with w > 0 is seen at."""
    *place, height = lifted
    return tuple(Fraction(coordinate) / height for coordinate in place)


def shadows_at_half():
    """The lifted quarter of a circle at t = 1/2, and where it is seen."""
    middle = curve_point(QUARTER, Fraction(1, 2))
    return middle == (Fraction(3, 4), 1, Fraction(5, 4)) and shadow(middle) == (Fraction(3, 5), Fraction(4, 5))


def a_negative_weight_leaves_the_hull():
    """The quarter's points with the weights 1, -1, 2: at t = 1/2 they give (-1, 0), on the circle, out of the hull."""
    place = shadow(curve_point([(1, 0, 1), (-1, -1, -1), (0, 2, 2)], Fraction(1, 2)))
    return place == (-1, 0) and not in_hull([(1, 0), (1, 1), (0, 1)], place)


CLAIMS = [
    argued(
        "rational/no-polynomial-circle",
        "no polynomial curve of a degree n >= 1 runs along a circle, not even on a small piece",
        "Suppose that on a piece the squared distance of p(t) from a centre c is a constant. Both are polynomials in "
        "t and equal at infinitely many t: then they are equal for every t.",
        "Let n be the degree, and x and y the coefficients of t^n in the two coordinates: they are not both 0.",
        Shown(
            "Squared and added, the highest terms give",
            eq((x * t**n) ** 2 + (y * t**n) ** 2, (x**2 + y**2) * t ** (2 * n)),
        ),
        "All other products have a lower degree, those with the centre c too: its degree is 0, and n < 2n.",
        Computed(
            "With letters for all coefficients and the centre, n = 1, ..., 6: degree 2n, and x^2 + y^2 before it.",
            top_is_a_sum_of_squares,
        ),
        "A sum of squares of real numbers that are not both 0 is positive. So the squared "
        "distance has the degree 2n >= 2: it is no constant.",
    ),
    claim(
        "rational/cubic-gap",
        "the cubic (1, 0), (1, k), (k, 1), (0, 1) along the unit circle: what is left over of x^2 + y^2 - 1",
        (OFF, FLAT**2 * (9 * k**2 + 6 * k - 6 - 2 * (3 * k - 2) ** 2 * FLAT)),
        twins=[
            (OFF, FLAT**2 * (9 * k**2 + 6 * k - 6)),
            (OFF, FLAT**2 * (9 * k**2 - 6 * k - 6 - 2 * (3 * k - 2) ** 2 * FLAT)),
        ],
    ),
    claim(
        "rational/circle",
        "the points (1, 0), (1, 1), (0, 1) with the weights 1, 1, 2: x^2 + y^2 = w^2, (x/w, y/w) is on the unit circle",
        (X**2 + Y**2, WEIGHT**2),
        twins=[(X**2 + curve_of([0, 1, 1]) ** 2, curve_of([1, 1, 1]) ** 2), (X**2 + Y**2, curve_of([1, 2, 2]) ** 2)],
    ),
    claim(
        "rational/quarter",
        "the points (1, 0), (1, 1), (0, 1) with any weights: X^2 + Y^2 - W^2, which is 0 if 2 w_1^2 = w_0 w_2",
        (ABOUT, 2 * (2 * w1**2 - w0 * w2) * FLAT**2),
        twins=[(ABOUT, 2 * (w1**2 - w0 * w2) * FLAT**2), (ABOUT, 2 * (2 * w1**2 - w0 * w2) * FLAT)],
    ),
    argued(
        "rational/projection",
        "a rational curve is a polynomial curve one dimension up, seen from the origin on the plane w = 1",
        "The points (w_i b_i, w_i) are control points of a polynomial curve, with the coordinates X, Y and W.",
        Shown(
            "Where W > 0, a coordinate of the rational curve times W is that coordinate,",
            eq(Mul(w, quotient(x, w), evaluate=False), x),
            {w: POSITIVE},
        ),
        "so (X, Y, W) is W times (X/W, Y/W, 1): both are on one ray from the origin.",
        Computed("The quarter of a circle at t = 1/2: (3/4, 1, 5/4) is seen at (3/5, 4/5).", shadows_at_half),
    ),
    claim(
        "rational/equal-weights",
        "with equal weights w the numerator is p(t) times the denominator: the quotient is the polynomial curve p",
        (Sum(w * B(i, n, t) * b[i], (i, 0, n)), curve() * Sum(w * B(i, n, t), (i, 0, n))),
        twins=[
            (Sum(w * B(i, n, t) * b[i], (i, 0, n)), curve() * Sum(w * B(i, n, t), (i, 1, n))),
            (Sum(w * B(i, n, t) * b[i], (i, 0, n)), curve()),
        ],
    ),
    argued(
        "rational/common-factor",
        "a common factor c > 0 of all weights changes no point: only ratios of weights matter",
        Shown(
            "The denominator is multiplied by c,",
            eq(Sum(c * weight[i] * B(i, n, t), (i, 0, n)), c * Sum(weight[i] * B(i, n, t), (i, 0, n))),
        ),
        "and so is each coordinate of the numerator, the same sum with w_i times that coordinate of b_i for w_i.",
        Shown("It cancels:", eq(quotient(c * S, c * R), quotient(S, R)), {c: POSITIVE, R: POSITIVE}),
    ),
    argued(
        "rational/ends",
        "a rational curve with end weights that are not 0 starts in b_0 and ends in b_n",
        Known("The lifted curve starts in (w_0 b_0, w_0),", "curve/start"),
        Known("and ends in (w_n b_n, w_n).", "curve/end"),
        Shown(
            "The division gives back the point, here with a positive weight:",
            eq(quotient(w * x, w), x),
            {w: POSITIVE},
        ),
        "A negative weight cancels in the same way.",
    ),
    argued(
        "rational/hull",
        "with positive weights the curve over [0, 1] lies in the convex hull of its control points",
        "Divide each w_i B_{i,n}(t) by their sum: these are the factors of the control points.",
        Known("None of them is negative,", "basis/non-negative"),
        "the sum that they are divided by is positive, and together they are 1: a convex combination.",
        Computed(
            "With a negative weight it fails: the weights 1, -1, 2 and the points (1, 0), (1, 1), (0, 1) at t = 1/2.",
            a_negative_weight_leaves_the_hull,
        ),
    ),
    claim(
        "rational/share",
        "p(t) is on the line from S/R, where it is without b_j, to b_j with the weight w; R and S: the sums of w_i "
        "B_{i,n}(t) and of w_i B_{i,n}(t) b_i, i not j; f is B_{j,n}(t), x a coordinate of b_j",
        (PULLED, (1 - SHARE) * quotient(S, R) + SHARE * x),
        PULLING,
        twins=[
            (PULLED, (1 - w) * quotient(S, R) + w * x),
            (PULLED, quotient(S, R) + SHARE * x),
        ],
    ),
    argued(
        "rational/pull",
        "with positive weights and 0 < t < 1, a larger weight w_j takes p(t) straight on towards b_j, never into it",
        Known("On the line from S/R to b_j it has gone the share w f / (R + w f).", "rational/share"),
        Known("Here f, the basis function of b_j, is positive.", "basis/positive-inside"),
        Shown(
            "If the weight grows by h, the share grows by",
            eq(
                difference(quotient((w + h) * f, R + (w + h) * f), SHARE),
                quotient(h * f * R, (R + (w + h) * f) * (R + w * f)),
            ),
            PULLING | {h: POSITIVE},
        ),
        "which is positive. What is still to go is R / (R + w f): never 0, but as small as one likes.",
        "Divide by h and let it go to 0: the derivative of p(t) is f / (R + w f) times b_j - p(t).",
    ),
]
