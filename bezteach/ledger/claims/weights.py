"""Where a control point weighs most, and how many control points a curve has."""

from sympy import Rational

from bezteach.symbolic import B

from ..claim import Known, Shown, argued, eq

CLAIMS = [
    argued(
        "curve/influence",
        "moving b_j moves the curve most at the parameter j/n (n >= 1, j counted from 0)",
        Known("If b_j moves by v, the point at t moves by B_{j,n}(t) v.", "curve/moved"),
        Known("On [0, 1] the factor is greatest at t = j/n,", "basis/maximum"),
        Known(
            "and nowhere else: inside, t (1 - t) times its derivative is (j - n t) B_{j,n}(t),",
            "basis/maximum/from-derivative",
        ),
        Known("and B_{j,n}(t) is positive there:", "basis/positive-inside"),
        "it rises before j/n and falls after it. If v is not 0, the point at j/n moves farther than every other.",
        Shown(
            "An instance: moving b_1 of a cubic moves the point at 1/3 by 4/9 of the way.",
            eq(B(1, 3, Rational(1, 3)), Rational(4, 9)),
        ),
    ),
    argued(
        "curve/count",
        "n + 1 control points for degree n: each curve of degree n at most has exactly one polygon of n + 1 points",
        Known(
            "The n + 1 Bernstein functions of degree n are a basis of the polynomials of degree n at most.",
            "basis/is-basis",
        ),
        "So each coordinate of such a curve has exactly one list of n + 1 coefficients: one polygon.",
        Known(
            "A function of degree n is a combination of two of degree n + 1: with one control point more the same "
            "curve is written with a degree higher by one.",
            "basis/elevation/third",
        ),
    ),
]
