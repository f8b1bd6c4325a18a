"""Derivatives by the blossom, and how smooth a B-spline curve is at a knot of any multiplicity.

Degree p, knots t_0 <= t_1 <= ..., control points b_i, whose runs are t_{i+1}, ..., t_{i+p}; f is the blossom of a span.
"""

from fractions import Fraction
from math import comb, factorial

from ..claim import Computed, Known, argued
from ..knots import DEGREES, blossom, jump_orders, letters, one_span, piece, point, units


def derivatives_are_values():
    """Degree 0 to 3: the r-th derivative of each piece is p!/(p-r)! times an r-th difference of values."""
    return all(
        nth_derivative(piece(place, p, knots, t, p), t, r)
        - factorial(p) // factorial(p - r) * direction(unit, knots, t, r)
        == 0
        for p in DEGREES[:4]
        for knots, t in [one_span(p)]
        for place, unit in enumerate(units(p, t**0))
        for r in range(p + 1)
    )


def nth_derivative(element, t, r):
    for _ in range(r):
        element = element.diff(t)
    return element


def direction(unit, knots, t, r):
    """f(t, ..., t, 1, ..., 1) with r vectors 1: the sum of (-1)^(r-j) C(r, j) f(t, ..., t, t + 1, ..., t + 1)."""
    p = len(unit) - 1
    return sum(
        (-1) ** (r - j) * comb(r, j) * blossom(unit, knots, p, [t] * (p - j) + [t + 1] * j) for j in range(r + 1)
    )


def neighbours_agree():
    """Degree 1 to 3, spans j and j + m with letters as knots: values whose arguments hold the m knots between."""
    return all(
        value(p, p, unit, knots, [*knots[p + 1 : p + 1 + m], *[t] * (p - m)])
        == value(p, p + m, unit, knots, [*knots[p + 1 : p + 1 + m], *[t] * (p - m)])
        for p in DEGREES[1:4]
        for m in range(1, p + 1)
        for knots, t in [letters(*[1] * (2 * p + 2 + m), zero=p)]
        for unit in range(p + 1 + m)
    )


def value(p, span, unit, knots, arguments):
    """The value of the blossom of a span if one control point is 1 and the others are 0."""
    one = knots[-1] ** 0
    return blossom([one * (place == unit) for place in range(span - p, span + 1)], knots, span, arguments)


def orders(p, m):
    """The least power of t - s in a jump at a knot s of multiplicity m."""
    return min(jump_orders(p, m))


def as_smooth_as_said():
    return all(orders(p, m) >= p - m + 1 for p in DEGREES for m in range(1, p + 2))


def no_smoother():
    return all(orders(p, m) == p - m + 1 for p in DEGREES for m in range(1, p + 2))


def smoother_by_chance():
    """A parabola with control points at the runs of 0, 0, 0, 1, 1, 2, 2, 2: C1 and more at the double knot 1."""
    knots = [Fraction(knot) for knot in (0, 0, 0, 1, 1, 2, 2, 2)]
    points = [(Fraction(x + y, 2), x * y) for x, y in zip(knots[1:6], knots[2:7], strict=True)]
    return all(
        point(points, knots, span, [at, at]) == (at, at * at) for span in (2, 4) for at in (Fraction(1, 3), Fraction(3))
    )


CLAIMS = [
    argued(
        "blossom/derivatives",
        "the r-th derivative at t is p!/(p-r)! f(t, ..., t, 1, ..., 1) with r times the vector 1 for a number",
        "f is affine in each argument: f(u + 1, ...) - f(u, ...) is the same for every u. Call it f(1, ...), with the "
        "vector 1; then f(t + h, ...) = f(t, ...) + h f(1, ...).",
        Known("f is symmetric,", "blossom/spline"),
        "so f(t + h, ..., t + h) is the sum over r of C(p, r) h^r f(t, ..., t, 1, ..., 1) with r vectors.",
        Known("It is p(t + h);", "bspline/de-boor"),
        "by Taylor's formula the factor of h^r is the r-th derivative divided by r!.",
        Computed("With letters as knots, for p = 0, ..., 3 and r = 0, ..., p.", derivatives_are_values),
    ),
    argued(
        "blossom/agree",
        "the f of span j and the f of span j + m, m <= p, agree if the m knots between are among the arguments",
        "Let both spans be not empty; the knots between are t_{j+1}, ..., t_{j+m}. Both curves use b_i for "
        "j + m - p <= i <= j, which are p - m + 1 points, and the run of each holds all knots between.",
        Known("Both f are b_i at the run of b_i.", "blossom/spline"),
        "Keep the knots between fixed among the arguments. In the others both f are symmetric and affine, p - m of "
        "them, and have the same p - m + 1 values at the runs that are left, of t_{j+m-p+1}, ..., t_j and "
        "t_{j+m+1}, ..., t_{j+p}. Steps with these knots, the same for both, lead from these values to all others; "
        "nothing is divided by 0, as the first p - m are below the others.",
        Known("For degree 2 and a simple knot written out:", "blossom/agree/quadratic"),
        Computed("with letters as knots, for p = 1, ..., 3 and m = 1, ..., p.", neighbours_agree),
    ),
    argued(
        "bspline/smooth",
        "the curve is one polynomial on each span, and at least C^(p-m) at an inner knot of multiplicity m <= p",
        Known("On each span it is a polynomial.", "bspline/definition"),
        Known("At a knot s of multiplicity m both f agree if m of the arguments are s.", "blossom/agree"),
        Known(
            "The r-th derivative at s is a number times f(s, ..., s, 1, ..., 1), with p - r arguments s.",
            "blossom/derivatives",
        ),
        "A value with a vector is a difference of values with numbers. So for p - r >= m the derivatives from both "
        "sides agree: r = 0, ..., p - m, for every p and m <= p. A knot p + 1 times is C^(-1): nothing is said.",
        Computed(
            "With letters as knots, for p = 0, ..., 4 and m = 1, ..., p + 1: the jump of every function at s is "
            "divided by (t - s)^(p-m+1).",
            as_smooth_as_said,
        ),
    ),
    argued(
        "bspline/smooth/sharp",
        "C^(p-m) is what every curve on the knots has; some have no more, and particular control points have more",
        Known("Every curve has that much.", "bspline/smooth"),
        "The function N_{i,p} whose support begins at s has no more: its first m knots are s, m <= p. On the left of s "
        "it is 0, on the right it is a polynomial with a blossom f.",
        Known("f is 0 if m of its arguments are s, as the f of the left side is.", "blossom/agree"),
        "So f(s, ..., s, u_1, ..., u_{p-m+1}), with s m - 1 times, is affine in each u and 0 at u = s: it is "
        "c (u_1 - s) ... (u_{p-m+1} - s).",
        Known("At the run of b_i it is 1, so c is not 0;", "blossom/spline"),
        Known("the derivative of order p - m + 1 from the right is a number times c,", "blossom/derivatives"),
        "and from the left it is 0. With m = p + 1 the function itself jumps, from 0 to 1. This is for every p.",
        Computed(
            "With letters as knots, p = 0, ..., 4, m = 1, ..., p + 1: some jump is not divided by (t - s)^(p-m+2).",
            no_smoother,
        ),
        Computed(
            "Particular control points: y = x^2 written on the knots 0, 0, 0, 1, 1, 2, 2, 2 has all derivatives at the "
            "double knot 1, of which C^0 is sure.",
            smoother_by_chance,
        ),
    ),
]
