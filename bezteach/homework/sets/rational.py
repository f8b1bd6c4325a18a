"""Homework on lesson 12: weights, points of space and their shadows, pieces of circles."""

from fractions import Fraction as F
from math import isqrt

import numpy as np
from sympy import Ge, Integer, Interval, Le, Sum, oo, sqrt, symbols

from bezteach import numeric
from bezteach.display import point
from bezteach.symbolic import B, b, i, n, t, u

from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value, listed

ROUND = (1, 1, 2)
BOOK = {
    "arch": ((0, 0), (3, 3), (6, 0)),
    "loads": (1, 2, 4),
    "flat": ((1, 0), (1, 1), (0, 1)),
    "weights": ROUND,
    "middle": (0, 0),
    "radius": 5,
    "at": F(1, 3),
    "legs": (3, 4),
    "left": 0,
    "round": ((2, 1), 3),
    "clockwise": False,
}


def draw(chance):
    """Small whole points; weights whose means at 1/2 and at 1/3 are small; right-angled triangles with whole sides."""
    size = chance.choice([1, 2, 3])

    def arch(width):
        heights = [chance.choice(pair) for pair in ([0, 2], [4, 6], [0, 2])]
        return tuple((width * place + chance.randint(0, 1), height) for place, height in enumerate(heights))

    return {
        "arch": arch(4),
        "loads": chance.choice([(1, 2, 4), (4, 2, 1), (1, 1, 3), (3, 1, 1)]),
        "flat": arch(3),
        "weights": chance.choice([(1, 1, 2), (2, 1, 1), (1, 1, 4), (4, 1, 1)]),
        "middle": (chance.randint(-2, 2), chance.randint(-2, 2)),
        "radius": chance.choice([5, 10]),
        "at": chance.choice([F(1, 3), F(2, 3), F(1, 4), F(3, 4)]),
        "legs": tuple(size * side for side in chance.choice([(3, 4), (4, 3), (5, 12), (12, 5), (8, 15), (15, 8)])),
        "left": chance.randint(-2, 2),
        "round": ((chance.randint(-3, 3), chance.randint(-3, 3)), chance.randint(2, 5)),
        "clockwise": chance.choice([True, False]),
    }


def _weighted(points, weights):
    return f"{listed(points)} with the weights {', '.join(map(str, weights))}"


# ---- The triangle, seen on the plane


def _triangle(lifted, place=F(1, 2)):
    """The two points of the first level and the one of the second."""
    _, first, second = numeric.de_casteljau(lifted, place)
    return np.array([*first, *second])


def _seen(data, power=1):
    """The triangle on the plane, of weights raised to a power."""
    weights = [F(weight) ** power for weight in data["loads"]]
    return numeric.rational.project(_triangle(numeric.rational.lift(data["arch"], weights)))


def _level_mistakes(data):
    first, second, _ = right = _seen(data)
    return [
        (_seen(data, 0), "This is the triangle for equal weights: you have not used the weights."),
        (
            _triangle(numeric.rational.lift(data["arch"], data["loads"]))[:, :2],
            "These are X and Y of points in space. Where in the plane are they seen?",
        ),
        (
            [first, second, (first + second) / F(2)],
            "The first level is right. Its two points have weights, too: the last one is not midway.",
        ),
        (_seen(data, -1), "The points are drawn to the smaller weights here: the larger weight pulls more."),
        (right[[1, 0, 2]], "The points are right. The two of the first level changed places."),
    ]


# ---- One degree more


def _raised(data):
    lifted = numeric.elevate(numeric.rational.lift(data["flat"], data["weights"]))
    return np.column_stack([numeric.rational.project(lifted), lifted[:, -1]])


def _raised_mistakes(data):
    right, lifted = _raised(data), numeric.rational.lift(data["flat"], data["weights"])
    third = (lifted[1:] - lifted[:-1]) / F(3)
    exchanged = np.array([lifted[0], lifted[0] + third[0], lifted[2] - third[1], lifted[2]])
    return [
        (
            np.column_stack([numeric.elevate(data["flat"]), right[:, -1]]),
            "The weights are right. The points are those of equal weights: lift first, then raise the degree.",
        ),
        (numeric.elevate(lifted), "These are the points in space. Asked for are their places in the plane."),
        (
            np.column_stack([right[:, :-1], [1] * 4]),
            "The places are right. Each of the new points has a weight of its own.",
        ),
        (
            np.column_stack([numeric.rational.project(exchanged), exchanged[:, -1]]),
            "Right idea, but 1/3 and 2/3 are exchanged in the means.",
        ),
    ]


# ---- Half a turn


def _half_circle(data, share=1):
    """The points in space, with so many times the one in the middle, which stands nowhere in the plane."""
    (x, y), radius = data["middle"], data["radius"]
    return ((x + radius, y, 1), (0, share * radius, 0), (x - radius, y, 1))


def _turned(data, at, share=1):
    return numeric.rational.project(numeric.evaluate(_half_circle(data, share), at))


def _turned_mistakes(data):
    above = numeric.evaluate(_half_circle(data), data["at"])
    return [
        (above[:2], "These are X and Y. Divide by W, which is not 1 here: the middle point adds nothing to it."),
        (above[:2] / F(2), "You divided by the sum of the weights. Divide by W at this t."),
        (_turned(data, data["at"], F(1, 2)), "The basis function in the middle has a factor more."),
        (_turned(data, data["at"], 0), "You left the middle point out: it adds nothing to W, but it does to Y."),
        (_turned(data, 1 - data["at"]), "t and 1 - t are exchanged."),
    ]


# ---- The weight of an arc


def _legs(data):
    half, height = data["legs"]
    return half, height, isqrt(half * half + height * height)


def _triangle_of(data):
    half, height, _ = _legs(data)
    return ((data["left"], 0), (data["left"] + half, height), (data["left"] + 2 * half, 0))


def _top(data):
    """How high the circle rises that touches both legs at their ends: over its centre by its radius."""
    half, height, leg = _legs(data)
    return F(half * leg, height) - F(half * half, height)


def _arc(data):
    share = _top(data) / data["legs"][1]
    return share / (1 - share)


def _arc_mistakes(data):
    half, height, leg = _legs(data)
    return [
        (_top(data) / height, "This is the share of the way up to b_1. It is w/(1 + w), not w."),
        (_top(data), "This is how high the curve rises. Which weight lifts it so far?"),
        (1 / _arc(data), "Upside down: with this weight the curve passes above the circle."),
        (
            F(height, leg),
            "This is the height over a leg. A flat triangle: is its arc nearly a parabola, with w near 1, or not?",
        ),
        (
            F(half, height),
            "This is half of the base over the height. The circle touches the legs: their length enters.",
        ),
        (_arc(data) ** 2, "This is w^2: it is w_1^2 that is compared with w_0 w_2."),
        (sqrt(Integer(2)) / 2, "This is the weight for a right angle at b_1."),
    ]


# ---- Round


def _is_round(data, found):
    middle, radius = data["round"]
    return len(found) == 3 and numeric.rational.on_unit_circle((found - np.array(middle)) / F(radius), ROUND)


def _turn(found):
    """Twice the area of the triangle of three points, positive if they run counterclockwise."""
    (x0, y0), (x1, y1), (x2, y2) = found
    return (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)


def _ends_on_circle(data, found):
    offsets = found[[0, -1]] - np.array(data["round"][0])
    return ((offsets * offsets).sum(axis=1) == data["round"][1] ** 2).all()


DEMANDS = (
    (lambda data, found: len(found) == 3, "Three weights: three control points."),
    (_ends_on_circle, "The curve starts in b_0 and ends in b_2. Are both on the circle?"),
    (_is_round, "Both ends are on the circle, but the way between is not. How long are the edges, at which angle?"),
    (
        lambda data, found: len(found) == 3 and (_turn(found) < 0 if data["clockwise"] else _turn(found) > 0),
        "It runs the other way round, or not round at all.",
    ),
)


def _quarter(data):
    (x, y), radius = data["round"]
    end = y - radius if data["clockwise"] else y + radius
    return [(x + radius, y), (x + radius, end), (x, end)]


v, w = symbols("v w", real=True)
POSITIVE = Interval.open(0, oo)
STEP = b[n] - b[n - 1]
LINE = 2 * t + (n - 1) * t**2
HALF_CIRCLE = """((1-t)^2 - t^2)^2 + (2t(1-t))^2
= (1-t)^4 - 2t^2 (1-t)^2 + t^4 + 4t^2 (1-t)^2
= (1-t)^4 + 2t^2 (1-t)^2 + t^4
= ((1-t)^2 + t^2)^2"""

SET = Set(
    BOOK,
    draw,
    {
        "level": asks_value(
            "points",
            lambda data: (
                f"The points {_weighted(data['arch'], data['loads'])}: de Casteljau's algorithm at t = 1/2, and each "
                f"point of it seen on the plane. Give the two points of the first level, then the point of the curve."
            ),
            _seen,
            _level_mistakes,
            (
                "Lift the points, take the means in space, and divide each by its last coordinate.",
                "On each edge, the new point is a mean of two points with their weights: (w_0 b_0 + w_1 b_1)/(w_0 + "
                "w_1).",
            ),
        ),
        "raised": asks_value(
            "points",
            lambda data: (
                f"The curve with {_weighted(data['flat'], data['weights'])} is written with degree 3. Give a list of "
                f"four rows (x, y, w): each new control point in the plane, and its weight."
            ),
            _raised,
            _raised_mistakes,
            (
                "Go up, raise the degree there, come down.",
                "The weights are raised like points: 1/3 of one and 2/3 of the next, then the other way round.",
            ),
        ),
        "half-turn": asks_value(
            "point",
            lambda data: (
                f"In space, the control points are {', '.join(map(point, _half_circle(data)))}. The middle one is seen "
                f"nowhere in the plane: its weight is 0. Where in the plane is the curve at t = {data['at']}?"
            ),
            lambda data: _turned(data, data["at"]),
            _turned_mistakes,
            (
                "Nothing new: evaluate in space, and divide by the last coordinate in the end.",
                "W is (1-t)^2 + t^2 here. Does the middle point enter X or Y?",
            ),
        ),
        "arc": asks_value(
            "number",
            lambda data: (
                f"The points {listed(_triangle_of(data))} have the weights 1, w, 1. For one w > 0 the curve is a piece "
                f"of a circle. Which w?"
            ),
            _arc,
            _arc_mistakes,
            (
                "The circle touches the legs in b_0 and b_2. Where is its centre? How large is its radius?",
                "The curve at t = 1/2 is the top of the circle, and it has gone the share w/(1 + w) of the way to b_1.",
            ),
        ),
        "end-velocity": asks_formula(
            lambda data: (
                "A curve of degree n >= 1 has the weights w_(n-1) = u and w_n = v, both positive. Write its velocity "
                "at t = 1 in n, u, v, b_n and b_(n-1)."
            ),
            lambda data: n * u * STEP / v,
            {n, u, v, b},
            {n: (1, oo), u: POSITIVE, v: POSITIVE},
            lambda data: [
                (n * STEP, "This is the velocity for equal weights."),
                (n * v * STEP / u, "Upside down: if b_n grows heavier, does the curve arrive there faster?"),
                (-n * u * STEP / v, "The sign: which way does the curve arrive?"),
                (u * STEP / v, "The factor n is missing."),
                (n * u * STEP, "A common factor of both weights must change nothing. Is that so here?"),
                (
                    n * (v * b[n] - u * b[n - 1]),
                    "This is the velocity in space, without its last coordinate. A quotient has another rule.",
                ),
                (
                    n * (v * b[n] - u * b[n - 1]) / v,
                    "You divided the velocity by W. In the quotient's derivative a second term is taken off.",
                ),
            ],
            (
                "x = X/W, so x' = (X' W - X W')/W^2. Which of the lifted points enter at t = 1?",
                "W is v there, and W' is n (v - u).",
            ),
        ),
        "line": asks_formula(
            lambda data: (
                "With equal weights, the points 0, 1/n, ..., 1 of a line give x(t) = t. Now they have the weights "
                "1, 2, ..., n+1, for n >= 1, and x(t) = X(t)/W(t) with W(t) = sum((i+1) B(i,n,t), i, 0, n) = 1 + n t. "
                "Write X(t) in n and t, without a sum."
            ),
            lambda data: LINE,
            {i, n, t},
            {n: (1, oo)},
            lambda data: [
                (t * (1 + n * t), "Then x would still be t. The mean of i^2 is not the square of the mean of i."),
                (t, "This is X for equal weights."),
                (LINE - t, "Your weights are 0, 1, ..., n."),
                (n * LINE, "The points are i/n, not i."),
                (1 + n * t, "This is W. The points are missing."),
            ],
            (
                "X is the sum of the (i+1) i/n B(i,n,t).",
                "Split (i+1) i into i (i-1) and 2i: lesson 03 has both sums.",
            ),
            form=("without a sum", lambda formula: not formula.has(Sum, B)),
        ),
        "strongest": asks_truth(
            lambda data: (
                "The weights are 1, w, 1 with w > 0. Is the pull of b_1 strongest at t = 1/2? There its factor is "
                "w/(1+w). True or false, multiplied out, for all w > 0 and t in [0, 1]: "
                "2 w t (1-t) (1+w) <= w ((1-t)^2 + 2 w t (1-t) + t^2)? If false, give a counterexample."
            ),
            lambda data: Le(2 * w * t * (1 - t) * (1 + w), w * ((1 - t) ** 2 + 2 * w * t * (1 - t) + t**2)),
            {w: POSITIVE, t: Interval(0, 1)},
            ("Divide by w. What stands on both sides?", "Compare 2t(1-t) with (1-t)^2 + t^2."),
        ),
        "denominator": asks_truth(
            lambda data: (
                "With the weights 1, w, 1, the denominator is never negative on [0, 1] if w >= -1. True or false: it "
                "is so with the weights 1, w, w, 1 as well, (1-t)^3 + 3 w t (1-t)^2 + 3 w t^2 (1-t) + t^3 >= 0 for all "
                "w >= -1 and t in [0, 1]? If false, give a counterexample."
            ),
            lambda data: Ge((1 - t) ** 3 + 3 * w * t * (1 - t) ** 2 + 3 * w * t**2 * (1 - t) + t**3, 0),
            {w: Interval(-1, oo), t: Interval(0, 1)},
            ("Where do the two in the middle weigh most?", "Put t = 1/2: for which w is this 0?"),
        ),
        "half-circle": asks_derivation(
            lambda data: (
                "The points (1, 0, 1), (0, 1, 0), (-1, 0, 1) in space give half of the unit circle: show that "
                "X^2 + Y^2 = W^2 for every t. Begin with ((1-t)^2 - t^2)^2 + (2t(1-t))^2, end with "
                "((1-t)^2 + t^2)^2, and write at least one line between."
            ),
            HALF_CIRCLE,
            {t},
            {},
            hints=("Multiply both squares out, with t and 1-t as they are.", "Two of the terms belong together."),
        ),
        "round": asks_position(
            lambda data: (
                "The weights are 1, 1, 2. Give three control points with which the curve runs on the circle around {} "
                "with radius {}, {}, wherever it starts.".format(
                    point(data["round"][0]),
                    data["round"][1],
                    "clockwise" if data["clockwise"] else "counterclockwise",
                )
            ),
            DEMANDS,
            _quarter,
            (
                "What did the quarter of the unit circle look like? Its edges touch the circle.",
                "Start on the circle to the right of the centre. A square has the centre and your three points as "
                "corners.",
            ),
            on_board=False,
        ),
    },
)
