"""Homework on lesson 07: velocities, ends, curvature, and derivatives of every order and degree."""

from fractions import Fraction as F
from math import isqrt

import numpy as np
from sympy import Derivative, Eq, Integer, Integral, Interval, Sum, oo, symbols

from bezteach import numeric
from bezteach.display import point
from bezteach.examples import EXAMPLES
from bezteach.symbolic import B, b, i, n, t

from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value, listed

SEGMENT = EXAMPLES["deck/segment"].given
BOOK = {
    "cubic": SEGMENT["points"],
    "t": SEGMENT["end"],
    "tail": ((3, 7), (3, 4), (4, 2)),
    "bend": ((0, 0), (0, 3), (4, 3), (7, 7)),
    "arch": ((0, 1), (2, 5), (6, 3)),
    "end": (6, 0),
    "velocity": (3, 6),
}
h, u, v, w = symbols("h u v w", real=True)


def draw(chance):
    """Whole points; curvature over an edge of whole length, a highest point at a third, velocities in threes."""

    def whole(least, most):
        return chance.randint(least, most), chance.randint(least, most)

    def mirrored(points):
        side, up = chance.choice([1, -1]), chance.choice([1, -1])
        return tuple((side * x, up * y) for x, y in points)

    rise, fall = chance.choice([(4, 2), (2, 4), (2, 1), (1, 2)])
    start, first, second = chance.randint(0, 3), chance.randint(1, 4), chance.randint(1, 4)
    up, along, (x, y) = chance.choice([2, 3, 4]), chance.choice([1, 2, 4]), chance.choice([(3, 4), (4, 3)])
    return {
        "cubic": tuple((4 * k + 2 * chance.randint(-1, 1), 2 * chance.randint(0, 4)) for k in range(4)),
        "t": chance.choice([F(1, 4), F(3, 4), F(1, 3), F(2, 3)]),
        "tail": (whole(0, 8), whole(0, 8), whole(1, 8)),
        "bend": mirrored(((0, 0), (0, up), (along, up), (along + x, up + y))),
        "arch": ((0, start), (first, start + rise), (first + second, start + rise - fall)),
        "end": (chance.randint(4, 8), chance.randint(-1, 1)),
        "velocity": (3 * chance.randint(0, 2), 3 * chance.choice([-3, -2, 2, 3])),
    }


def _velocity_mistakes(data):
    right = numeric.derivative(data["cubic"], data["t"])
    return [
        (right / F(3), "This is the difference of two points of the triangle: the factor before it is missing."),
        (-right, "This arrow points backwards: the difference is the later point minus the earlier one."),
        (right * F(2, 3), "The factor is the degree of the curve, and not the number of the level."),
        (right * F(4, 3), "The factor is the degree of the curve, and not the number of its points."),
        (numeric.derivative(data["cubic"], 1 - data["t"]), "t and 1 - t are exchanged."),
        (numeric.evaluate(data["cubic"], data["t"]), "This is where the curve is, not how it moves."),
    ]


# ---- A quartic from its end


def _at_end(data, r):
    """The r-th derivative at 1 of a quartic with these last points; r <= 2, so that the others do not enter."""
    return numeric.derivative(((0, 0), (0, 0), *data["tail"]), 1, r)


def _tail_mistakes(data):
    _, before, last = map(np.array, data["tail"])
    velocity, second = _at_end(data, 1), _at_end(data, 2)

    def found(edge, bend):
        return bend + 2 * (last - edge) - last

    edge, bend = velocity / F(4), second / F(12)
    return [
        (before, "This is b_3, from the velocity alone. One more step back."),
        (before + bend, "The second difference is not the edge from b_3 to b_2: b_4 - 2 b_3 + b_2."),
        (found(-edge, bend), "You found b_3 by going on from the end: the last edge leads from b_3 to b_4."),
        (found(velocity, second), "The factors are missing: both vectors are longer than the differences."),
        (found(edge, second / F(16)), "The factor of the second derivative is not n^2: the degree has fallen by one."),
        (found(edge, second / F(4)), "The factor of a second derivative has two parts, and one is missing."),
        (found(edge, -bend), "The second difference has the other sign: b_4 - 2 b_3 + b_2, at the end as well."),
        (found(edge, 0 * bend), "You went straight on from b_4 over b_3: the second derivative was not used."),
    ]


# ---- Curvature at the end


def _curvature(points, at):
    """The signed curvature of a plane curve where its speed is a whole number."""
    (x, y), (u, v) = (numeric.derivative(points, at, r) for r in (1, 2))
    return F(x * v - y * u, isqrt(x * x + y * y) ** 3)


def _curvature_mistakes(data):
    right, (before, last) = _curvature(data["bend"], 1), numeric.hodograph(data["bend"])[1:] // 3
    length, other = isqrt(last @ last), isqrt(before @ before)
    return [
        (-right, "The sign: edge before the last times last edge, in the order in which the curve runs them."),
        (right * F(3, 2), "The factor (n - 1)/n is missing."),
        (right * F(9, 8), "In the factor (n - 1)/n stands the degree, and not the number of the points."),
        (right / 2, "You took the triangle; the cross product is the area of the whole parallelogram."),
        (right * length, "The length of the edge enters with its cube, not its square."),
        (right * F(length, other) ** 3, "The cube of a length stands below, but it is that of the edge at the end."),
        (_curvature(data["bend"], 0), "This is the curvature at t = 0."),
    ]


# ---- The highest point


def _highest(data):
    """The parameter at which the second coordinate of a quadratic's hodograph is 0."""
    start, end = numeric.hodograph(data["arch"])[:, 1]
    return F(start, start - end)


def _highest_mistakes(data):
    place, points = _highest(data), data["arch"]
    first, last = numeric.de_casteljau(points, place)[1]
    return [
        (points[1], "This is the highest control point. The curve does not reach it."),
        (numeric.evaluate(points, F(1, 2)), "This is the point at t = 1/2. Is the velocity horizontal there?"),
        (numeric.evaluate(points, 1 - place), "Right idea, but t and 1 - t are exchanged."),
        (first, "The height is right, but this is a point of the tangent, on the first edge."),
        (last, "The height is right, but this is a point of the tangent, on the second edge."),
    ]


# ---- Formulas


def _third(weights, factor):
    return factor * sum(weight * b[n - k] for k, weight in enumerate(weights))


THIRD, FALLING = EXAMPLES["deck/derivatives"].answer["weights"][2][::-1], n * (n - 1) * (n - 2)
PRINTED = EXAMPLES["deck/derivatives"].printed["weights"][2][::-1]
SPEEDS = u + v + w

# ---- The second derivative of a Bernstein function, as a student writes it

SECOND = """diff(B(i,n,t), t, 2)
= n(diff(B(i-1,n-1,t), t) - diff(B(i,n-1,t), t))
= n((n-1)(B(i-2,n-2,t) - B(i-1,n-2,t)) - (n-1)(B(i-1,n-2,t) - B(i,n-2,t)))
= n(n-1)(B(i-2,n-2,t) - 2B(i-1,n-2,t) + B(i,n-2,t))"""

# ---- A curve with a straight end


def _is_cubic(data, points):
    return len(points) == 4


def _ends(data, points):
    return tuple(points[0]) == (0, 0) and tuple(points[-1]) == data["end"]


def _starts(data, points):
    return tuple(numeric.derivative(points, 0)) == data["velocity"]


def _moves(data, points):
    return bool(numeric.derivative(points, 1).any())


def _straight(data, points):
    (x, y), (u, v) = (numeric.derivative(points, 1, r) for r in (1, 2))
    return x * v == y * u


def _straight_end(data):
    first, end = np.array(data["velocity"]) / F(3), np.array(data["end"])
    return [(0, 0), first, (first + end) / F(2), end]


SET = Set(
    BOOK,
    draw,
    {
        "velocity": asks_value(
            "point",
            lambda data: f"The vector p'({data['t']}) of the cubic {listed(data['cubic'])}.",
            lambda data: numeric.derivative(data["cubic"], data["t"]),
            _velocity_mistakes,
            (
                "De Casteljau's triangle has it as a by-product.",
                "Take level 2: later point minus earlier point, times n.",
            ),
        ),
        "from-end": asks_value(
            "point",
            lambda data: (
                f"A curve of degree 4 ends at b_4 = {point(data['tail'][2])}; there p'(1) = {point(_at_end(data, 1))}, "
                f"p''(1) = {point(_at_end(data, 2))}. Where is b_2?"
            ),
            lambda data: data["tail"][0],
            _tail_mistakes,
            ("First find b_3.", "p''(1) is n (n - 1) times b_4 - 2 b_3 + b_2: solve it for b_2."),
        ),
        "curvature": asks_value(
            "number",
            lambda data: (
                f"The curvature at t = 1 of the cubic {listed(data['bend'])}, as an exact fraction, positive where "
                "the curve turns left."
            ),
            lambda data: _curvature(data["bend"], 1),
            _curvature_mistakes,
            ("Two edges are enough: the last two.", "(n - 1)/n times their cross product, over a cube of a length."),
        ),
        "highest": asks_value(
            "point",
            lambda data: f"The highest point of the parabola {listed(data['arch'])}, 0 <= t <= 1.",
            lambda data: numeric.evaluate(data["arch"], _highest(data)),
            _highest_mistakes,
            (
                "What is the direction of the velocity at the highest point?",
                "The heights of the hodograph's two control points: where on the way from one to the other is 0?",
                "Now you have t: the point is one more evaluation away.",
            ),
        ),
        "third": asks_formula(
            lambda data: (
                "A curve of degree n >= 3 has the control points b[0], ..., b[n]. Write p'''(1) in n and the control "
                "points that enter, such as b[n-1]."
            ),
            lambda data: _third(THIRD, FALLING),
            {n, b},
            {n: (3, oo)},
            lambda data: [
                (_third(THIRD, -FALLING), "The sign is turned: the point b[n] itself must count positive."),
                (_third(THIRD, 6), "This factor is that of cubics. Which one has degree n?"),
                (_third(THIRD, n), "This is the factor of the first derivative. Each one brings another."),
                (_third(THIRD, n * (n - 1)), "This is the factor of the second derivative. One is missing."),
                (_third(THIRD, n**3), "The degree falls by one with each derivative, and so does the factor."),
                (_third(THIRD, 1), "This is the third difference. The factor is missing."),
                (_third(PRINTED, FALLING), "The sum of the weights of a vector must be 0; these sum to 2."),
                (FALLING * (b[3] - 3 * b[2] + 3 * b[1] - b[0]), "This is p'''(0)."),
            ],
            ("It is a third difference of the last four points.", "(E - 1)^3 gives the weights; n (n - 1) ... before."),
        ),
        "integrate": asks_formula(
            lambda data: (
                "Heights only: a curve of degree n >= 3 starts at the height h, and the first three control points of "
                "its hodograph have the heights u, v, w. Write the height of the control point b_3 in n, h, u, v, w."
            ),
            lambda data: h + SPEEDS / n,
            {n, h, u, v, w},
            {n: (3, oo)},
            lambda data: [
                (h + SPEEDS, "The control points of the hodograph are longer than the edges of the polygon."),
                (
                    h + n * SPEEDS,
                    "You multiplied by n. Is an edge longer than its vector in the hodograph, or shorter?",
                ),
                (h + SPEEDS / 3, "The factor is the degree of the curve, not the number of edges that you add."),
                (h + SPEEDS / (n - 1), "n is the degree of the curve; that of the hodograph is n - 1."),
                (SPEEDS / n, "This is a way. From which height does it lead to b_3?"),
                (h + w / n, "This is one edge, but there are three on the way from b_0 to b_3."),
            ],
            ("Which edge of the polygon belongs to u?", "Add the edges up, from b_0 on."),
        ),
        "steady": asks_truth(
            lambda data: (
                "True or false, for every n >= 1 and t in [0, 1]: the derivative of sum(i B(i, n, t), i, 0, n) is n? "
                "If false, give a counterexample."
            ),
            lambda data: Eq(Derivative(Sum(i * B(i, n, t), (i, 0, n)), t), n, evaluate=False),
            {n: (1, oo), t: Interval(0, 1)},
            (
                "Which control points has the curve of which this is the velocity?",
                "Equal steps: what is its hodograph?",
            ),
        ),
        "area": asks_truth(
            lambda data: (
                "True or false, for every n >= 1 and 0 <= i <= n: the integral of the derivative of B(i, n, t) from "
                "t = 0 to 1 is 0? If false, give a counterexample, i and n."
            ),
            lambda data: Eq(Integral(n * (B(i - 1, n - 1, t) - B(i, n - 1, t)), (t, 0, 1)), Integer(0), evaluate=False),
            {n: (1, oo), i: (0, n)},
            (
                "The integral of a velocity is the way from the start to the end.",
                "Which functions end where they start?",
            ),
        ),
        "basis-second": asks_derivation(
            lambda data: (
                "Derive the second derivative of a Bernstein function, from diff(B(i,n,t), t, 2) to "
                "n(n-1)(B(i-2,n-2,t) - 2B(i-1,n-2,t) + B(i,n-2,t)), for n >= 2 and 0 <= i <= n, with two lines between "
                "at least. The first derivative n(B(i-1,n-1,t) - B(i,n-1,t)) is known."
            ),
            SECOND,
            {i, n, t},
            {n: (2, oo), i: (0, n)},
            least=2,
            hints=(
                "Differentiate once, and leave a diff in the line: diff(B(i-1,n-1,t), t).",
                "The same rule again, with n - 1 in the place of n.",
            ),
        ),
        "straight-end": asks_position(
            lambda data: (
                f"The four control points of a cubic from (0, 0) to {point(data['end'])} with p'(0) = "
                f"{point(data['velocity'])} whose curvature at t = 1 is 0, and whose velocity there is not."
            ),
            [
                (_is_cubic, "A cubic has four control points."),
                (_ends, "The ends are not where they should be."),
                (_starts, "p'(0) is another vector: compare it with the first edge, in direction and in length."),
                (_moves, "At t = 1 the velocity is 0, and then there is no curvature."),
                (_straight, "At t = 1 the curvature is not 0: look at the last three points."),
            ],
            _straight_end,
            (
                "Three of the points are given by the ends and p'(0).",
                "When does the cross product of two edges vanish?",
            ),
        ),
    },
)
