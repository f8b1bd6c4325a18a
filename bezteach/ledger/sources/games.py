"""The games slides: power basis against Bernstein basis, properties, de Casteljau, joins."""

from sympy import Derivative, Integer, Mul, Sum, binomial

from bezteach.symbolic import B, i, n, r, t

from ..forms import DELTA, FALLING, FROM_ONE, FROM_TWO, WITHIN, G
from ..reading import amended, refuted, row
from .games_joins import CURVE, JOINS, LOST, end_properties, p


def cut(number):
    """One of the four slides on the point where the algorithm cuts the curve."""
    where = f"de Casteljau, slide {number} of 4 with the cut"
    return [
        row(
            f"{where}, ratio",
            "algorithm/ratio",
            amended(
                "bisect the control polygon in the ratio t : (1 - t)",
                "to bisect is to cut in equal halves, which is t = 1/2; each edge of each level is cut in this ratio",
            ),
        ),
        row(f"{where}, first part", "split/left"),
        row(f"{where}, second part", "split/right"),
        row(
            f"{where}, their control points",
            "algorithm/parts",
            amended(
                "the control points of both parts are the points generated on the way",
                "only the first and the last of each level, with b_0 and b_n, which are given: in a cubic the middle "
                "point b_1^1 of the first level is a control point of neither",
            ),
        ),
        row(f"{where}, use, polygons for the curve", "limit/halving"),
        row(f"{where}, use, roots", "curve/hull/range"),
    ]


def parabola(where):
    """The heading of the two slides on the power basis."""
    return row(
        f"{where}, quadratic curve (parabola)",
        "examples/quadratic/parabola",
        amended(
            "a quadratic polynomial curve is a parabola",
            "a and b must not be parallel: (1, 1) t^2 + (1, 1) t runs along a line; the example is a parabola",
        ),
    )


ROWS = [
    row("review, the powers as a basis", "powers/there-and-back"),
    row("review, quadratic polynomial in powers of t", "examples/quadratic/bases"),
    row("review, parametric form", "implicit/parametric"),
    parabola("power basis, slide 1"),
    row("power basis, slide 1, the example", "examples/parabola"),
    row("power basis, slide 1, coefficients as points", "examples/power-points"),
    parabola("power basis, slide 2"),
    row(
        "power basis, slide 2, no geometric meaning",
        "examples/power-points",
        amended(
            "the coefficient points have no geometric meaning",
            "too strong: c is the start of the curve and b its velocity there; what is lacking is that the curve moves "
            "along with the points",
        ),
    ),
    row("two kinds of modelling, powers as weights of points", "examples/power-points"),
    row("Bernstein instead of powers, the example in powers again", "examples/parabola"),
    row("Bernstein instead of powers, the example in the Bernstein basis", "examples/parabola"),
    row("Bernstein basis, definition", "basis/definition"),
    row("Bernstein basis, binomial coefficient", "binomial/factorials"),
    row("Bernstein basis, binomial coefficient 0 below", "binomial/vanishes-below"),
    row("Bernstein basis, binomial coefficient 0 above", "binomial/vanishes-above"),
    row("the first few, definition again", "basis/definition"),
    row("the first few, B_0 of degree 1", "linear/basis/0"),
    row("the first few, B_0 of degree 0", "constant/basis/0"),
    row("the first few, B_1 of degree 1", "linear/basis/1"),
    row("the first few, B_0 of degree 2", "quadratic/basis/0"),
    row("the first few, B_1 of degree 2", "quadratic/basis/1"),
    row("the first few, B_2 of degree 2", "quadratic/basis/2"),
    row("another example, three points", "examples/three-points"),
    row("Bézier curve, degree n with n + 1 points", "curve/count"),
    row("Bézier curve, definition", "curve/definition"),
    row("Bézier curve, its properties from those of the basis", "curve/definition"),
    row(
        "cubic example, sum from 1",
        "curve/definition",
        refuted((G**3 * p[0], Sum(B(i, 3, t) * p[i], (i, 1, 3)))),
    ),
    row(
        "curves in space, sum from 1",
        "curve/definition",
        refuted((G**n * p[0], Sum(B(i, n, t) * p[i], (i, 1, n)))),
    ),
    row("properties, degree n is order n + 1", "examples/exact-degree"),
    row("properties, definition again", "basis/definition"),
    row("properties, symmetry", "basis/symmetry"),
    row(
        "properties, greatest value",
        "basis/maximum",
        amended(
            "B_i^n(t) is greatest at t = i/n",
            "on [0, 1], and for n >= 1, is left out: B_{0,2} = (1 - t)^2 is 1 at t = 0 and 4 at t = 3",
        ),
    ),
    row("property 1, not negative", "basis/non-negative"),
    row("property 1, sum from 1", "basis/unity", refuted((Sum(B(i, n, t), (i, 1, n)), Integer(1)))),
    row("property 1, convex hull", "curve/hull"),
    row("property 2, a basis", "basis/is-basis"),
    row("property 2, independent", "basis/independent"),
    row("property 2, every polynomial of degree at most n", "basis/spans"),
    row("property 2, from powers", "basis/from-powers"),
    row("property 2, to powers", "basis/to-powers"),
    row("property 2, the matrix", "matrix/triangular"),
    row(
        "property 3, recursion",
        "basis/recursion",
        refuted((B(i, n, t), (1 - t) * B(i, n - 1, t) + t * B(i - 1, n - 1, 1 - t)), FROM_ONE | WITHIN),
    ),
    row("property 3, B_0 of degree 0", "constant/basis/0"),
    row("property 3, index below 0", "basis/vanishes-below"),
    row("property 3, index above n", "basis/vanishes-above"),
    row(
        "property 3, binomial coefficients",
        "basis/pascal",
        amended(
            (binomial(n - 1, i) + binomial(n - 1, i - 1), binomial(n, i)),
            "n >= 1 is left out: by the slides' own definition the left side is 0 for n = 0, i = 0, and the right 1",
            WITHIN,
        ),
    ),
    row(
        "property 3, from two of lower degree",
        "basis/recursion",
        amended(
            "a function of higher degree is raised from two of lower degree",
            "at i = 0 and i = n one of the two is the zero function; and this is the recursion, not the raising of the "
            "degree of property 6",
        ),
    ),
    row("property 4, B_0 at 0", "basis/start/first"),
    row("property 4, the others at 0", "basis/start/others"),
    row("property 4, the others at 1", "basis/end/others"),
    row("property 4, B_n at 1", "basis/end/last", refuted((B(n, n, 0), Integer(1)))),
    row("property 4, first point", "curve/start"),
    row("property 4, last point", "curve/end"),
    row(
        "property 5, derivative of the basis",
        "basis/derivative",
        amended((Derivative(B(i, n, t), t), n * (B(i - 1, n - 1, t) * B(i, n - 1, t))), LOST, FROM_ONE | WITHIN),
    ),
    row(
        "property 5, second derivative of the basis",
        "basis/second-derivative",
        amended(
            (
                Derivative(B(i, n, t), (t, 2)),
                n * (n - 1) * (Mul(B(i - 2, n - 2, t), 2, B(i - 1, n - 2, t), evaluate=False) + B(i, n - 2, t)),
            ),
            LOST,
            FROM_TWO | WITHIN,
        ),
    ),
    row("property 5, the curve", "curve/definition"),
    row(
        "property 5, derivative of the curve",
        "curve/hodograph",
        amended((Derivative(CURVE, t), n * Sum(B(i, n - 1, t) * (p[i + 1] * p[i]), (i, 0, n - 1))), LOST, FROM_ONE),
    ),
    row(
        "property 5, r-th derivative of the curve",
        "curve/derivative-r",
        amended(
            (
                Derivative(CURVE, (t, r)),
                FALLING * Sum(B(i, n - r, t) * DELTA**r * p[i], (i, 0, n - r)),
            ),
            "r <= n is left out: for r > n the factor has no value, and the derivative is 0",
        ),
    ),
    *end_properties("ends of the curve"),
    row("property 6, times 1 - t", "basis/elevation/first"),
    row(
        "property 6, times t",
        "basis/elevation/second",
        refuted((t * B(i, n, t), (i + 1) / (n + 1) * B(i, n + 1, t)), WITHIN),
    ),
    row(
        "property 6, the curve",
        "curve/elevation",
        amended(
            (CURVE, Sum(B(i, n + 1, t) * ((n + 1 - i) / (n + 1) * p[i] + i / (n + 1) * p[i - 1]), (i, 0, n + 1))),
            "it names P_{-1} at i = 0 and P_{n+1} at i = n + 1, which do not exist: they come with the factor 0",
        ),
    ),
    row("de Casteljau, level 0", "casteljau/start"),
    row("de Casteljau, a step", "casteljau/step"),
    row("de Casteljau, the point of the curve", "casteljau/curve"),
    row("de Casteljau, convex combination", "algorithm/convex"),
    row("de Casteljau, convex combination, the step again", "casteljau/step"),
    *cut(1),
    *cut(2),
    *cut(3),
    *cut(4),
    row("splines, a piece between each two data points, C0 and C1", "interpolation/c1"),
    row("splines, a piece between each two data points, C2", "interpolation/c2"),
    *end_properties("joins, ends of the curve again"),
    *JOINS,
    row("construction of interpolating cubics, picture lost", "interpolation/one-sixth"),
    row("splines in general, pieces of polynomials are Bézier curves", "curve/count"),
]
