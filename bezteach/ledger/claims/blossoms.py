"""The blossom: the affine step is what de Boor's and de Casteljau's algorithms have in common.

Degree p, knots t_0 <= t_1 <= ..., control points b_i. A run is p neighbouring knots t_{i+1}, ..., t_{i+p}, that of b_i.
The arguments are for every p; the equation of two steps is proved for all knots, and what is computed are instances.
"""

from sympy import symbols

from bezteach.symbolic import b
from bezteach.symbolic.bspline import affine_step

from ..claim import Computed, Known, Shown, argued, claim, eq
from ..knots import DEGREES, blossom, letters, one_span, piece, units

s, u, v = symbols("s u v", real=True)
h0, h1, h2 = symbols("h0:3", positive=True)
FOUR = [s, s + h0, s + h0 + h1, s + h0 + h1 + h2]
OTHER = [s, s + h0, s + h0 + h1 + h2, s + h0 + h1]
POINTS = [b[0], b[1], b[2]]


def two_steps(first, second, knots=FOUR):
    """Three neighbours of a level, and the one value that two steps leave; the second step has ``knots``."""
    return affine_step(affine_step(POINTS, FOUR, 1, first), knots, 1, second)[0]


def stepped(knots, u):
    """One step between two knots, from b_0 and b_1."""
    return affine_step([b[0], b[1]], knots, 0, u)[0]


def control_points_are_values():
    """On one span among letters, degree 0 to 4: the value at the run of b_i is b_i, whatever the others are."""
    return all(
        blossom(unit, knots, p, knots[place + 1 : place + p + 1]) == (place == which)
        for p in DEGREES
        for knots, t in [one_span(p)]
        for which, unit in enumerate(units(p, t**0))
        for place in range(p + 1)
    )


def de_boor_is_the_sum():
    return all(
        blossom(unit, knots, p, [t] * p) == piece(place, p, knots, t, p)
        for p in DEGREES
        for knots, t in [one_span(p)]
        for place, unit in enumerate(units(p, t**0))
    )


def segments_are_values():
    """Degree 0 to 4, Bézier knots: the value at j times v and p - j times u is the control point of the part [u, v]."""
    low, high, t = letters(1, 1, 1)[0][0], letters(1, 1, 1)[0][1], letters(1, 1, 1)[1]
    for p in DEGREES:
        knots = [0 * t] * (p + 1) + [1 + 0 * t] * (p + 1)
        for unit in units(p, t**0):
            part = [blossom(unit, knots, p, [low] * (p - j) + [high] * j) for j in range(p + 1)]
            whole = blossom(unit, knots, p, [(1 - t) * low + t * high] * p)
            if blossom(part, knots, p, [t] * p) != whole:
                return False
    return True


CLAIMS = [
    claim(
        "blossom/step/commutes",
        "two affine steps, with u and then with v, leave the value that they leave with v and then u",
        (two_steps(u, v), two_steps(v, u)),
        twins=[(two_steps(u, v), two_steps(u, u)), (two_steps(u, v, OTHER), two_steps(v, u, OTHER))],
    ),
    argued(
        "blossom/spline",
        "steps from the control points of a span make a function f of p arguments: symmetric, affine in each, and b_i "
        "at the run of b_i",
        "Let span k be not empty. Level 0 is b_{k-p}, ..., b_k. A step with u takes two neighbours to "
        "((y - u) d + (u - x) d')/(y - x), where x and y are the knots in which they differ: t_i and t_{i+p+1-r} at "
        "level r. Since t_i <= t_k < t_{k+1} <= t_{i+p+1-r}, nothing is divided by 0. After p steps one "
        "value is left, f(u_1, ..., u_p).",
        Known(
            "Two steps one after the other may change places: their four knots are x <= x' < y <= y', and the equation "
            "holds also where h_0 or h_2 is 0, as no denominator is 0 there.",
            "blossom/step/commutes",
        ),
        "Neighbours may be exchanged, so all orders give one value: f is symmetric. It is affine in the argument of "
        "the last step, so in each.",
        Shown("With u = x a step gives the first of the two,", eq(stepped([s, s + h1], s), b[0])),
        Shown("with u = y the other.", eq(stepped([s, s + h1], s + h1), b[1])),
        "So, with the arguments in the order t_{i+1}, ..., t_k, then t_{i+p}, ..., t_{k+1}, each step hands b_i on: "
        "f(t_{i+1}, ..., t_{i+p}) = b_i for k - p <= i <= k.",
        Computed("With letters as knots, for p = 0, ..., 4.", control_points_are_values),
    ),
    argued(
        "bspline/de-boor",
        "p steps with t leave the point of the curve: de Boor's algorithm, and f(t, ..., t) = p(t)",
        "Put the recursion into the sum of N_{i,p}(t) b_i, t in span k: N_{i,p-1} gets the factor "
        "(t_{i+p} - t)/(t_{i+p} - t_i) b_{i-1} + (t - t_i)/(t_{i+p} - t_i) b_i, which is a step with t.",
        Known("Only the i from k - p + 1 to k matter, for which the denominator is positive.", "bspline/support"),
        "So the curve is the same sum with degree p - 1 and the points of level 1, and so on, down to N_{k,0} = 1 and "
        "the point of level p: this holds for every p.",
        Known("These steps are those of f, with all arguments t.", "blossom/spline"),
        Known("For degree 2 both written out, all simple knots:", "bspline/de-boor/quadratic"),
        Computed("with letters as knots the steps give the pieces, for p = 0, ..., 4.", de_boor_is_the_sum),
        "Within the span each step is a convex combination, as t lies between both knots; it needs "
        "p + ... + 2 + 1 of them.",
    ),
    argued(
        "blossom/casteljau",
        "de Casteljau's algorithm is the steps with knots 0 and 1 alone, and the part over [u, v] has the control "
        "points f(u, ..., u, v, ..., v)",
        Shown(
            "A step between the knots 0 and 1 is a step of de Casteljau's algorithm.",
            eq(stepped([0, 1], u), (1 - u) * b[0] + u * b[1]),
        ),
        Known("So with all arguments t the steps leave p(t), and with others f.", "casteljau/points"),
        "f is affine in each argument, and (1 - w) u + w v as p arguments, expanded, is the sum over j of B_{j,p}(w) "
        "times f with j arguments v and p - j arguments u: the curve over [u, v] with these control points.",
        Known("In the operator they are g(u)^(p-j) g(v)^j b_0.", "segment/points"),
        Known("For degree 2 with all knots written out:", "blossom/segment/quadratic"),
        Computed("for p = 0, ..., 4 and letters u, v.", segments_are_values),
    ),
]
