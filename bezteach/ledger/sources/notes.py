"""The notes, chapter 2: implicit and parametric form, the algorithm, properties, differences, matrix form."""

from fractions import Fraction

from sympy import Add, Derivative, IndexedBase, Integer, Mul, Sum, Symbol, binomial

from bezteach.symbolic import B, b, i, n, t

from ..claims.lines import passes_second_point
from ..forms import DELTA, FROM_ONE, WITHIN, curve, difference
from ..planar import curve_point, polygon_places, side
from ..reading import amended, refuted, refuted_words, row
from ..signs import along_curve, roots_inside

x = Symbol("x", real=True)
p = IndexedBase("p")
CONVENTION = (
    "n >= 1 is left out, and so is that functions with an index outside 0..n are 0, which it needs at i = 0 and i = n: "
    "there is no B_{-1,n-1} and no B_{n,n-1} otherwise"
)

DENTED = [(0, 0), (0, 6), (1, 1), (6, 0)]
ARCH = [(0, 0), (1, 1), (2, 0)]


def outside_the_polygon():
    """Whether the point at t = 1/2 is outside: in the dent, to the left of both edges that make it."""
    point = curve_point(DENTED, Fraction(1, 2))
    _, top, dent, right = DENTED
    return point == (Fraction(9, 8), Fraction(21, 8)) and side(top, dent, point) > 0 and side(dent, right, point) > 0


def as_often_as_the_polygon():
    """Whether the line y = 3/8 meets the curve of the arch twice, and its polygon twice."""
    heights = along_curve([y - Fraction(3, 8) for _, y in ARCH])
    return roots_inside(heights, 0, 1) == [1, 1] and len(polygon_places(ARCH, (0, 1, Fraction(3, 8)))) == 2


def moved_by_translation():
    """Whether the arch, moved by (1, 0), has another curve."""
    moved = [(x + 1, y) for x, y in ARCH]
    return curve_point(moved, Fraction(1, 2)) == (2, Fraction(1, 2)) != curve_point(ARCH, Fraction(1, 2))


ROWS = [
    row("2.1, implicit form, several values to one x", "implicit/several"),
    row("2.1, implicit form, dy/dx undefined", "implicit/slope"),
    row(
        "2.1, implicit form, change of axes",
        "implicit/axes",
        amended(
            "f(x, y) = 0 is not invariant under a change of axes",
            "true of the coefficients, and of a graph y = g(x): the equation changes, but stays one of the same degree",
        ),
    ),
    row("2.1, parametric form c(t) = (x(t), y(t))", "implicit/parametric"),
    row("2.1, parametric form, t as time", "implicit/motion"),
    row(
        "2.1, parametric form, track",
        "implicit/motion",
        amended("the curve is the track of a moving example", "a slip of the pen: of a moving particle"),
    ),
    row("2.2.1, level 0", "casteljau/start"),
    row("2.2.1, a step", "casteljau/step"),
    row("2.2.1, the point of the curve", "casteljau/curve"),
    row("2.2.2, the curve that the algorithm gives", "casteljau/curve"),
    row("2.2.2, stable", "algorithm/stable"),
    row("2.2.2, convex combinations", "algorithm/convex"),
    row("2.2.2, time O(n^2)", "casteljau/interpolations"),
    row("2.2.2, space O(n)", "algorithm/storage"),
    row("2.2.2, x(0)", "curve/start"),
    row("2.2.2, x(1)", "curve/end"),
    row(
        "2.2.2, the other points",
        "points/inner",
        refuted_words(
            "the other control points are only approximated",
            "the cubic with (0, 0), (1, 1), (2, 0), (-1, 5) passes its second control point at t = 1/2",
            passes_second_point,
        ),
    ),
    row(
        "2.2.2, convex hull",
        "curve/hull",
        refuted_words(
            "the curve is inside the Bézier polygon",
            "for (0, 0), (0, 6), (1, 1), (6, 0) the point at t = 1/2 is (9/8, 21/8), outside of the polygon, in its "
            "dent at (1, 1): the curve is in the convex hull",
            outside_the_polygon,
        ),
    ),
    row(
        "2.2.2, variation diminishing",
        "curve/variation-diminishing",
        refuted_words(
            "a line meets the curve fewer times than the polygon",
            "y = 3/8 meets the curve of (0, 0), (1, 1), (2, 0) twice, and the polygon twice: no more times",
            as_often_as_the_polygon,
        ),
    ),
    row("2.2.2, global influence", "influence/everywhere"),
    row("2.2.2, nearly local influence", "curve/influence"),
    row(
        "2.2.2, affine invariance",
        "curve/affine/coordinates",
        refuted_words(
            "under an affine map the curve and the polygon do not change",
            "moved by (1, 0), the curve of (0, 0), (1, 1), (2, 0) passes (2, 1/2) at t = 1/2 instead of (1, 1/2): it "
            "is mapped along with its polygon",
            moved_by_translation,
        ),
    ),
    row(
        "2.2.2, symmetry",
        "curve/symmetry",
        amended(
            "x(t) = [b_0, ..., b_n] and x'(t) = [b_n, ..., b_0]",
            "x' is a second curve here, not the derivative that 2.3.2 calls x', and what holds is left out: "
            "x'(t) = x(1 - t)",
        ),
    ),
    row(
        "2.2.2, linear precision",
        "line/collinear",
        amended(
            "the curve is a line segment exactly if b_0, ..., b_n are on one line",
            "that not all points are one is left out: they are on a line then, and the segment is a point; nor need it "
            "be the segment from b_0 to b_n, the points 0, 2, 1 on a line reach 4/3",
        ),
    ),
    row("2.3, the curve by its basis", "curve/definition"),
    row(
        "2.3, the curve, second line",
        "curve/definition",
        refuted([curve(), Sum(binomial(n, i) * x**i * (1 - x) ** (n - i) * b[i], (i, 0, n))]),
    ),
    row("2.3, the basis", "basis/definition"),
    row(
        "2.3.1, recursion",
        "basis/recursion",
        amended(
            (B(i, n, t), (1 - t) * B(i, n - 1, t) + t * B(i - 1, n - 1, t)),
            CONVENTION,
            WITHIN,
        ),
    ),
    row("2.3.1, recursion, start", "constant/basis/0"),
    row("2.3.1, symmetry", "basis/symmetry"),
    row("2.3.1, not negative", "basis/non-negative"),
    row("2.3.1, positive", "basis/positive-inside"),
    row("2.3.1, B_0 at 0", "basis/start/first"),
    row("2.3.1, the others at 0", "basis/start/others"),
    row("2.3.1, the others at 1", "basis/end/others", refuted((B(i, n, 0), Integer(0)), FROM_ONE | {i: (0, n - 1)})),
    row(
        "2.3.1, B_n at 1",
        "basis/end/last",
        amended(
            (B(0, n, 0), Integer(1)),
            "true, but said in the line before, and the opposite of what this line says of the same B_0^n(0): meant is "
            "B_n^n(1) = 1",
        ),
    ),
    row(
        "2.3.1, derivative",
        "basis/derivative",
        amended(
            (Derivative(B(i, n, t), t), n * (B(i - 1, n - 1, t) - B(i, n - 1, t))),
            CONVENTION,
            WITHIN,
        ),
    ),
    row("2.3.2, the curve", "curve/definition"),
    row("2.3.2, derivative", "curve/hodograph"),
    row("2.3.2, derivative at 0", "curve/tangent/start"),
    row("2.3.2, derivative at 1", "curve/tangent/end"),
    row("2.3.2, r-th derivative", "curve/derivative-r"),
    row("2.3.2, r-th derivative, the product in front", "curve/derivative-r/factor"),
    row("2.3.2, first difference", "difference/first"),
    row("2.3.2, difference of order r", "difference/step"),
    row(
        "2.3.2, second difference",
        "difference/second",
        refuted(
            [
                DELTA**2 * p[i],
                difference(DELTA * p[i + 1], DELTA * p[i]),
                Add(p[i + 1], Mul(-2, p[i + 1], evaluate=False), p[i], evaluate=False),
            ]
        ),
    ),
    row("2.3.2, difference of order r written out", "difference/r"),
    row("2.3.2, ends, x(0)", "curve/start"),
    row("2.3.2, ends, x(1)", "curve/end"),
    row("2.3.3, n + 2 points for the same curve", "elevation/points"),
    row("2.3.3, first point", "elevation/points"),
    row("2.3.3, last point", "elevation/points"),
    row("2.3.3, points between", "elevation/points"),
    row(
        "2.3.4, what is given",
        "curve/definition",
        amended("given b_0, b_n, which make x(t)", "the points between are lost: b_0, ..., b_n"),
    ),
    row("2.3.4, two curves that make one", "algorithm/parts"),
    row("2.3.4, points of the first part", "split/left"),
    row("2.3.4, points of the second part", "split/right"),
    row("2.3.5, curve range, picture lost, another interval of the parameter", "curve/reparametrised"),
    row("2.3.5, curve range, picture lost, where the curve can be", "curve/hull/range"),
    row("2.4, cubic curve", "matrix/cubic"),
    row("2.4, B_0", "cubic/basis/0"),
    row("2.4, B_1", "cubic/basis/1"),
    row("2.4, B_2", "cubic/basis/2"),
    row("2.4, B_3", "cubic/basis/3"),
    row("2.4, matrix form", "matrix/descending"),
    row("2.4, tangent vector", "matrix/tangent"),
]
