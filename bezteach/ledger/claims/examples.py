"""The worked examples: one parabola in two bases, a quadratic curve in numbers, the basis functions of low degree."""

from sympy import Derivative, Ge, ImmutableMatrix, IndexedBase, Integer, MatMul, Mul, Subs, Sum, binomial, symbols

from bezteach.symbolic import B, b, i, n, t

from ..claim import Computed, Known, Shown, argued, claim, eq
from ..forms import WITHIN, curve, curve_of, derivative_at
from ..planar import cross

a, e = IndexedBase("a"), IndexedBase("e")
a1, a2, b1, b2 = symbols("a_1 a_2 b_1 b_2", real=True)

POWERS = (t**2, t, 1)
BERNSTEIN = ((1 - t) ** 2, 2 * t * (1 - t), t**2)
QUADRATIC = a[2] * t**2 + a[1] * t + a[0]
CUBIC = curve(3)


def weighted(weights, points):
    """A row of weights times points as rows times the unit vectors e_1 and e_2."""
    return MatMul(ImmutableMatrix([weights]), ImmutableMatrix(points), ImmutableMatrix([e[1], e[2]]))


PARABOLA = weighted(POWERS, [[1, 1], [-2, 0], [1, 0]])
THREE_POINTS = weighted(BERNSTEIN, [[0, 1], [1, 1], [0, 2]])

CLAIMS = [
    claim(
        "examples/quadratic/bases",
        "a quadratic curve in powers of t and in the Bernstein basis",
        (QUADRATIC, curve_of([a[0], a[0] + a[1] / 2, a[0] + a[1] + a[2]])),
        twins=[
            (QUADRATIC, curve_of([a[0], a[0] + a[1], a[0] + a[1] + a[2]])),
            (QUADRATIC, curve_of([a[0], a[1], a[2]])),
        ],
    ),
    argued(
        "examples/quadratic/parabola",
        "a t^2 + b t + c is a parabola exactly if a and b are not parallel",
        "Look at the vector from c to the point of the curve, a t^2 + b t.",
        Shown(
            "Its cross product with b is t^2 times that of a and b,",
            eq((a1 * t**2 + b1 * t) * b2 - (a2 * t**2 + b2 * t) * b1, t**2 * (a1 * b2 - a2 * b1)),
        ),
        Shown(
            "and the cross product of a with it is t times that of a and b.",
            eq(a1 * (a2 * t**2 + b2 * t) - a2 * (a1 * t**2 + b1 * t), t * (a1 * b2 - a2 * b1)),
        ),
        "If the cross product of a and b is not 0, divide by it: in the coordinates along a and b the curve is "
        "(t^2, t), an affine image of the parabola y = x^2, hence a parabola.",
        "If it is 0, all of the curve is on the line through c in the direction of a and b, or in the point c.",
        Computed("For the slides' curve, a = (1, 1) and b = (-2, 0), it is 2.", lambda: cross((1, 1), (-2, 0)) == 2),
    ),
    claim(
        "examples/parabola",
        "one parabola: rows (1, 1), (-2, 0), (1, 0) in powers of t, control points (1, 0), (0, 0), (0, 1)",
        (PARABOLA, weighted(BERNSTEIN, [[1, 0], [0, 0], [0, 1]])),
        twins=[
            (PARABOLA, weighted(BERNSTEIN, [[0, 1], [0, 0], [1, 0]])),
            (PARABOLA, weighted(BERNSTEIN, [[1, 0], [-2, 0], [1, 1]])),
        ],
    ),
    argued(
        "examples/power-points",
        "the coefficients of a t^2 + b t + c as points: c is the start, b its velocity, 2a the second derivative",
        Shown("At t = 0 the curve is in the point c.", eq(Subs(QUADRATIC, t, 0), a[0])),
        Shown("Its velocity there is b.", eq(derivative_at(0, QUADRATIC), a[1])),
        Shown("Its second derivative is 2a.", eq(Derivative(QUADRATIC, (t, 2)), 2 * a[2])),
        Shown(
            "If all three points move by a vector a_3, the curve moves by t^2 + t + 1 times that vector,",
            eq((a[2] + a[3]) * t**2 + (a[1] + a[3]) * t + a[0] + a[3], QUADRATIC + (t**2 + t + 1) * a[3]),
        ),
        "which is the vector itself only for t = 0 and t = -1: the weights t^2, t, 1 do not sum to 1. The curve does "
        "not move with its coefficient points, as it does with control points.",
        Known("The Bernstein functions sum to 1.", "basis/unity"),
    ),
    claim(
        "examples/three-points",
        "the control points (0, 1), (1, 1), (0, 2): x = 2t - 2t^2, y = 1 + t^2",
        (THREE_POINTS, weighted((1, t, t**2), [[0, 1], [2, 0], [-2, 1]])),
        twins=[
            (THREE_POINTS, weighted((1, t, t**2), [[0, 1], [1, 0], [-1, 1]])),
            (THREE_POINTS, weighted((1, t, t**2), [[0, 1], [2, 0], [-2, 2]])),
        ],
    ),
    claim(
        "constant/basis/0",
        "the only function of degree 0",
        (B(0, 0, t), Integer(1)),
        twins=[(B(0, 0, t), Integer(0)), (B(0, 1, t), Integer(1))],
    ),
    claim("linear/basis/0", "the first of degree 1", (B(0, 1, t), 1 - t), twins=[(B(0, 1, t), t)]),
    claim("linear/basis/1", "the second of degree 1", (B(1, 1, t), t), twins=[(B(1, 1, t), 1 - t)]),
    *(
        claim(
            f"quadratic/basis/{place}",
            f"number {place} of degree 2",
            (B(place, 2, t), function),
            twins=[(B(place, 2, t), wrong)],
        )
        for place, function, wrong in (
            (0, (1 - t) ** 2, 1 - t**2),
            (1, 2 * t * (1 - t), t * (1 - t)),
            (2, t**2, (1 - t) ** 2),
        )
    ),
    argued(
        "examples/exact-degree",
        "there are n + 1 functions of degree n, and each has degree n exactly: three quadratics, four cubics",
        Shown("The index runs through 0, 1, ..., n: these are n + 1 values.", eq(Sum(Integer(1), (i, 0, n)), n + 1)),
        Known(
            "In powers of t the highest term is that with t^n, with the coefficient (-1)^(i+n) C(n, n) C(n, i).",
            "basis/to-powers",
        ),
        Shown(
            "It is not 0, since C(n, n) = 1 and C(n, i) >= 1 for i from 0 to n.",
            Ge(binomial(n, i), 1, evaluate=False),
            WITHIN,
        ),
    ),
    *(
        claim(
            f"examples/cubic-speed/{name}",
            f"a cubic {verb} with three times the {which} edge",
            (derivative_at(end, CUBIC), Mul(3, edge, evaluate=False)),
            twins=[(derivative_at(end, CUBIC), edge), (derivative_at(end, CUBIC), Mul(3, -edge))],
        )
        for name, verb, which, end, edge in (
            ("start", "starts", "first", 0, b[1] - b[0]),
            ("end", "ends", "last", 1, b[3] - b[2]),
        )
    ),
]
