"""The three-tangent theorem, de Casteljau's algorithm, and its operator form."""

from sympy import Derivative, Integer, Mul, Pow, Sum, binomial, oo

from bezteach.symbolic import E, b, i, j, k, n, step, t

from ..claim import claim
from ..forms import FROM_ONE, FROM_TWO, G, curve, derivative_at

QUADRATIC = curve(2)
FIRST, SECOND = (1 - t) * b[0] + t * b[1], (1 - t) * b[1] + t * b[2]
PUT_IN = [(1 - t) * FIRST + t * SECOND, (1 - t) ** 2 * b[0] + 2 * t * (1 - t) * b[1] + t**2 * b[2], QUADRATIC]
OPERATOR_STEP = [curve(n), (1 - t) * curve(n - 1) + t * curve(n - 1, 1), G * curve(n - 1)]
EXPANDED = [
    G**k * b[j],
    Sum(binomial(k, i) * (1 - t) ** (k - i) * t**i * E**i * b[j], (i, 0, k)),
    curve(k, j),
]

THREE_TANGENTS = [
    claim(
        "three-tangents/first-level",
        "one step takes each point a part t of the way to the next",
        (G * b[j], (1 - t) * b[j] + t * b[j + 1]),
        twins=[(G * b[j], t * b[j] + (1 - t) * b[j + 1])],
    ),
    claim(
        "three-tangents/second-level",
        "two steps are one between the two points of the first level",
        (G**2 * b[0], (1 - t) * G * b[0] + t * G * b[1]),
        twins=[(G**2 * b[0], (1 - t) * b[0] + t * G * b[1]), (G**2 * b[0], t * G * b[0] + (1 - t) * G * b[1])],
    ),
    claim(
        "three-tangents/quadratic",
        "two rounds of interpolation give the quadratic curve",
        PUT_IN,
        twins=[[PUT_IN[0], (1 - t) ** 2 * b[0] + t * (1 - t) * b[1] + t**2 * b[2]], [PUT_IN[0], curve(2, 1)]],
    ),
    claim(
        "three-tangents/ratio/edge",
        "a point of the first level divides its edge in the ratio t : 1 - t",
        ((1 - t) * (G * b[j] - b[j]), t * (b[j + 1] - G * b[j])),
        twins=[(t * (G * b[j] - b[j]), (1 - t) * (b[j + 1] - G * b[j]))],
    ),
    claim(
        "three-tangents/ratio/tangent",
        "the point of the curve divides the line between the first level's points in the ratio t : 1 - t",
        ((1 - t) * (G**2 * b[0] - G * b[0]), t * (G * b[1] - G**2 * b[0])),
        twins=[((1 - t) * (G**2 * b[0] - b[0]), t * (b[2] - G**2 * b[0]))],
    ),
    claim(
        "three-tangents/tangent/start",
        "the first edge has the direction of the quadratic curve at its start",
        (derivative_at(0, QUADRATIC), Mul(2, b[1] - b[0], evaluate=False)),
        twins=[(derivative_at(0, QUADRATIC), Mul(2, b[2] - b[0], evaluate=False))],
    ),
    claim(
        "three-tangents/tangent/end",
        "the last edge has the direction of the quadratic curve at its end",
        (derivative_at(1, QUADRATIC), Mul(2, b[2] - b[1], evaluate=False)),
        twins=[(derivative_at(1, QUADRATIC), b[2] - b[1])],
    ),
    claim(
        "three-tangents/tangent/inner",
        "the line between the first level's points has the direction of the quadratic curve",
        (Derivative(QUADRATIC, t), Mul(2, G * b[1] - G * b[0], evaluate=False)),
        twins=[(Derivative(QUADRATIC, t), Mul(2, G * b[0] - G * b[1], evaluate=False))],
    ),
]

ALGORITHM = [
    claim(
        "casteljau/start",
        "level 0 of the triangle holds the control points",
        (curve(0, j), b[j]),
        twins=[(curve(0, j), b[j + 1])],
    ),
    claim(
        "casteljau/step",
        "each point of a level from two neighbours of the level before",
        (curve(k, j), (1 - t) * curve(k - 1, j) + t * curve(k - 1, j + 1)),
        {k: (1, oo)},
        twins=[
            (curve(k, j), t * curve(k - 1, j) + (1 - t) * curve(k - 1, j + 1)),
            (curve(k, j), (1 - t) * curve(k - 1, j) + t * curve(k - 1, j)),
        ],
    ),
    claim(
        "casteljau/curve",
        "after n steps the point of the curve is left",
        (G**n * b[0], curve(n)),
        twins=[(G ** (n + 1) * b[0], curve(n)), (step(1 - t) ** n * b[0], curve(n))],
    ),
    claim(
        "casteljau/levels",
        "level k of the triangle has one point less than the level before",
        (Sum(Integer(1), (j, 0, n - k)), n + 1 - k),
        {k: (0, n)},
        twins=[(Sum(Integer(1), (j, 0, n - k)), n - k)],
    ),
    claim(
        "casteljau/interpolations",
        "the whole triangle takes n + ... + 2 + 1 interpolations, three for a quadratic curve",
        (Sum(k, (k, 1, n)), n * (n + 1) / 2),
        twins=[(Sum(k, (k, 1, n)), n * (n - 1) / 2)],
    ),
    claim(
        "casteljau/combination",
        "a curve of degree n from the curves of its first n and of its last n points",
        OPERATOR_STEP,
        FROM_ONE,
        twins=[[curve(n), (1 - t) * curve(n - 1) + t * curve(n - 1, 2)], [curve(n), G**2 * curve(n - 1)]],
    ),
    claim(
        "casteljau/points",
        "the point b_j^k moves on the curve of degree k with the points b_j, ..., b_{j+k}",
        EXPANDED,
        twins=[
            [EXPANDED[0], Sum(binomial(k, i) * (1 - t) ** i * t ** (k - i) * E**i * b[j], (i, 0, k))],
            [EXPANDED[0], curve(k)],
        ],
    ),
]

OPERATOR = [
    claim(
        "operator/identity",
        "the identity leaves every point where it is",
        (Mul(Pow(E, 0, evaluate=False), b[j], evaluate=False), b[j]),
        twins=[(Mul(Pow(E, 0, evaluate=False), b[j], evaluate=False), b[j + 1])],
    ),
    claim(
        "operator/shift",
        "the shift takes each point to the next",
        (E * b[j], b[j + 1]),
        twins=[(E * b[j], b[j])],
    ),
    claim(
        "operator/shift-often",
        "k shifts take a point k places on",
        (E**k * b[j], b[j + k]),
        twins=[(E**k * b[j], b[j * k])],
    ),
    claim(
        "operator/shift-back",
        "the inverse of the shift takes each point to the one before",
        (b[j] / E, b[j - 1]),
        {j: (1, oo)},
        twins=[(b[j] / E, b[j + 1])],
    ),
    claim(
        "casteljau/operator",
        "one step after the other: the curve is the n-th power of the step",
        [curve(n), G * curve(n - 1), G**2 * curve(n - 2), G ** (n - 1) * curve(1), G**n * b[0]],
        FROM_TWO,
        twins=[[curve(n), G ** (n - 1) * b[0]], [curve(n), G**2 * curve(n - 1)]],
    ),
]

CLAIMS = [*THREE_TANGENTS, *ALGORITHM, *OPERATOR]
