"""How often a line or a plane meets a Bézier curve and its polygon: variation diminishing, by the rule of signs."""

from fractions import Fraction
from itertools import product

from sympy import Mul, Poly, Rational, binomial
from sympy.abc import t as variable

from bezteach.symbolic import B, i, n, t

from ..claim import Computed, Known, Shown, argued, eq
from ..forms import WITHIN
from ..signs import along_curve, bernstein, minors, roots_inside, sign_changes

MOST_DEGREE = 4


def wiggles():
    """The products of m factors t - k/(m + 1) have m roots in (0, 1), for m to 8."""
    return all(
        roots_inside(
            Poly(Mul(*[variable - Rational(place, count + 1) for place in range(1, count + 1)]), variable), 0, 1
        )
        == [1] * count
        for count in range(9)
    )


def no_more_roots_than_changes():
    """For all values -1, 0, 1 at the control points, not all 0, up to the degree."""
    return all(
        sum(roots_inside(along_curve(values), 0, 1)) <= sign_changes(values)
        for degree in range(MOST_DEGREE + 1)
        for values in product((-1, 0, 1), repeat=degree + 1)
        if next(filter(None, values), 0) == 1
    )


def positive_minors():
    return all(
        minor > 0
        for degree in range(MOST_DEGREE + 1)
        for minor in minors(
            [
                [bernstein(j, degree, Fraction(place, degree + 2)) for j in range(degree + 1)]
                for place in range(1, degree + 2)
            ]
        )
    )


CLAIMS = [
    argued(
        "line/meets-segment",
        "a line that does not hold the whole segment AB meets it at most once",
        "The line is where an affine function l is 0. The points of the segment are (1 - t) A + t B, 0 <= t <= 1.",
        Known("There l is (1 - t) l(A) + t l(B): the case n = 1 of a mapped curve.", "curve/affine/coordinates"),
        "If l(A) and l(B) are both 0, the line holds the segment; this case is left out. Else l is along the segment a "
        "polynomial of degree 1 at most and not the zero polynomial: it has at most one root.",
    ),
    argued(
        "line/meets-curve",
        "a curve from A to B can meet a line as often as one likes",
        "For m = 0, 1, 2, ... let x(t) = t and let y(t) be the product of the factors t - k/(m + 1), k = 1, ..., m. On "
        "the line y = 0 lie the points with t = k/(m + 1) and no others: m different points, for every m.",
        Computed("Counted by Sturm's sequences for m = 0, ..., 8.", wiggles),
        Known("It is a Bézier curve of degree m, or 1 if m = 0, as every polynomial is in the basis.", "basis/spans"),
    ),
    argued(
        "curve/variation-diminishing",
        "a line meets a plane curve, and a plane a space curve, at most as often as it passes the control polygon",
        "The line or plane L is where an affine function l is 0. Let d_i = l(b_i). If all d_i are 0, the polygon and "
        "the curve lie in L; this case is left out. Passages of the polygon and of the curve are counted as "
        "parameters: what runs through the same point twice passes it twice. If an edge lies in L, the polygon passes "
        "L infinitely often, and only the bound by V below says something.",
        "Let V be the number of sign changes of d_0, ..., d_n, zeros left out. Between two control points with values "
        "of opposite sign the polygon has a point in L, so it passes L at least V times away from its ends b_0, b_n, "
        "and once more at each end that lies in L. (It passes more often where it only touches L.)",
        Known("Along the curve l is the sum of the d_i B_{i,n}(t).", "curve/affine/coordinates"),
        Shown(
            "Each function is a power in disguise: dividing by (1 - t)^i, not 0 for 0 < t < 1, gives "
            "B_{i,n}(t) = (1 - t)^n C(n, i) x^i with x = t/(1 - t).",
            eq((1 - t) ** i * B(i, n, t), (1 - t) ** n * binomial(n, i) * t**i),
            WITHIN,
        ),
        "As t runs from 0 to 1, x runs through all positive numbers once, with positive speed. So the roots of l in "
        "0 < t < 1 are the positive roots of q(x), the sum of the C(n, i) d_i x^i, with the same multiplicities; and "
        "the coefficients of q have the signs of the d_i.",
        "Rule of signs: a polynomial q, not 0, has at most as many positive roots, counted with multiplicity, as its "
        "coefficients have sign changes. Proof by induction on the degree. A power of x that divides q changes "
        "neither number; so let the constant coefficient c_0 not be 0. If q is constant, both numbers are 0. Else let "
        "c_m x^m be the next term with c_m not 0.",
        "A root of multiplicity k of q is one of multiplicity k - 1 of q', and between two neighbouring roots of q "
        "lies a further one of q' (Rolle): if q has p positive roots, q' has p - 1 or more. The coefficients of q' "
        "have the signs of those of q without c_0, and by induction the rule holds for q'.",
        "If c_0 and c_m have opposite signs, q has one sign change more than q', and at most one positive root more: "
        "the rule holds for q.",
        "If they have the same sign, q and q' have equally many sign changes, and near 0 the same sign: |q| grows at "
        "first. If q has a positive root, |q| has a greatest value between 0 and the first one: there q' has a further "
        "root, before all those above. So q' has no fewer positive roots than q, and the rule holds for q.",
        "Hence the curve meets L at most V times in 0 < t < 1, even if it is counted with multiplicity; and it begins "
        "and ends at b_0 and b_n as the polygon does. So it does not meet L more often than the polygon passes L.",
        Computed(
            f"Instances: for all d_i out of -1, 0, 1, the first that is not 0 being 1, and n = 0, ..., {MOST_DEGREE}, "
            "Sturm's sequences count no more roots than sign changes.",
            no_more_roots_than_changes,
        ),
        Computed(
            "The same is at work in the matrix of the B_{j,n}(t_i): it is totally positive. Instances, no proof for "
            f"other n: for n = 0, ..., {MOST_DEGREE} and t_i = i/(n + 2), i = 1, ..., n + 1, all minors are positive.",
            positive_minors,
        ),
    ),
]
