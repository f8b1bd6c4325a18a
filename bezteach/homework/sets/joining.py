"""Homework on lesson 10: joins of unlike curves, C2 and G2, and cubics through data points."""

from fractions import Fraction as F

import numpy as np
from sympy import Eq, IndexedBase, Integer, oo, symbols

from bezteach import numeric
from bezteach.display import point
from bezteach.examples import EXAMPLES
from bezteach.numeric import joins
from bezteach.symbolic import b, n, r

from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value, listed

BOOK = {
    "parabola": ((0, 0), (3, 6), (9, 0)),
    "lengths": (1, 2),
    "before": (-4, 4),
    "edges": (2, 3),
    "behind": 4,
    "data": ((0, 2), (2, 6), (8, 2), (12, 0)),
    "heights": (0, 4, 2),
    "left": EXAMPLES["deck/split"].given["points"],
    "end": (8, 4),
}
x, y, z = symbols("x y z", real=True)
D = IndexedBase("y")


def draw(chance):
    """Whole points; edges in threes before a longer interval; a height that the edges divide; no edge of length 0."""
    first, second = ((3 * chance.randint(1, 2), 3 * rise) for rise in chance.sample([-2, -1, 1, 2], 2))
    start, (a, c) = (chance.randint(0, 3), chance.randint(0, 3)), chance.choice([(2, 1), (2, 3), (3, 1), (3, 2)])
    left = tuple(
        (2 * number + chance.randint(0, 1), height) for number, height in enumerate(chance.sample(range(6), 4))
    )
    return {
        "parabola": tuple(map(tuple, np.cumsum([start, first, second], axis=0).tolist())),
        "lengths": chance.choice([(1, 2), (2, 4), (1, 3), (2, 6)]),
        "before": (-a - chance.randint(1, 3), a * a * chance.randint(1, 2)),
        "edges": (a, c),
        "behind": c + chance.randint(1, 3),
        "data": tuple(
            (4 * k + 2 * chance.randint(0, 1), 2 * height) for k, height in enumerate(chance.sample(range(6), 4))
        ),
        "heights": tuple(chance.sample(range(7), 3)),
        "left": left,
        "end": (left[-1][0] + chance.randint(3, 6), chance.randint(0, 5)),
    }


# ---- A parabola, and a cubic behind it


def _ratio(data):
    return F(data["lengths"][1], data["lengths"][0])


def _onward(data):
    """The cubic that is the parabola, gone on with."""
    return numeric.segment(numeric.elevate(data["parabola"]), 1, 1 + _ratio(data))[:3]


def _beyond(data, first, second):
    """The join and two points behind it: so many last edges, so many second differences of the parabola."""
    start, middle, end = np.array(data["parabola"], dtype=object)
    after = end + first * (end - middle)
    return [end, after, 2 * after - end + second * (end - 2 * middle + start)]


def _onward_mistakes(data):
    ratio = _ratio(data)
    rate, bend = F(2, 3) * ratio, F(1, 3) * ratio**2  # the right ones
    return [
        (_beyond(data, ratio, ratio**2), "So the degrees were equal. Which factor has a velocity on each side?"),
        (_beyond(data, F(2, 3), F(1, 3)), "The degrees are right. But the intervals are not equally long."),
        (_beyond(data, F(2, 3) / ratio, F(1, 3) / ratio**2), "The intervals enter the other way round."),
        (_beyond(data, F(3, 2) * ratio, 3 * ratio**2), "The degrees enter the other way round."),
        (_beyond(data, rate, bend / ratio), "c_1 is right. A second derivative is divided by the length twice."),
        (_beyond(data, rate, F(4, 9) * ratio**2), "c_1 is right. The second factor is n (n - 1), and not n^2."),
        (
            _beyond(data, rate, 0),
            "c_1 is right. But your cubic goes straight on, and the parabola has a second derivative.",
        ),
    ]


# ---- One curvature


def _bend(data):
    """The height of b_5, from what a height of 0 leaves over of the second derivative, 6 (b_5 - 2 b_4 + b_3)."""
    before, after = data["edges"]
    left = [(0, 0), data["before"], (-before, 0), (0, 0)]
    right = [(0, 0), (after, 0), (data["behind"], 0), (0, 0)]
    return -joins.continuity(left, right).G2.residual[1] / 6


def _bend_mistakes(data):
    (before, after), high = data["edges"], data["before"][1]
    share = F(after, before)
    return [
        (F(high), "This would be right for two equal edges at the join."),
        (high * share, "The edges enter, but not so: how does the curvature depend on the edge?"),
        (high / share**2, "The edges the other way round: a longer edge makes the same height bend less."),
        (high * share**3, "The cube of the edge stands below, but above stands an area, with the edge once."),
        (-_bend(data), "The size is right. But so the curve turns left on one side and right on the other."),
    ]


# ---- Through data points


def _piece(data, share):
    """The cubic from D_1 to D_2, with this share of the chords."""
    d0, d1, d2, d3 = np.array(data["data"], dtype=object)
    return [d1, d1 + share * (d2 - d0), d2 - share * (d3 - d1), d2]


def _halfway(control_points):
    return numeric.evaluate(control_points, F(1, 2))


def _middle_mistakes(data):
    return [
        (_halfway(_piece(data, F(0))), "This is the middle between D_1 and D_2: the neighbours enter, too."),
        (_halfway(data["data"]), "You took the data for the control points: D_0 and D_3 are not on this piece."),
        (_halfway(_piece(data, F(1, 3))), "The control points are too far away: which share of the chord?"),
        (_halfway(_piece(data, F(1, 2))), "Half of the chord is the velocity. The edge is a third of it."),
        (_halfway(_piece(data, F(-1, 6))), "The control points are on the wrong sides of D_1 and D_2."),
        (
            _halfway(_piece(data, F(1, 6))[1:3]),
            "This is the middle between the inner control points: D_1, D_2 enter, too.",
        ),
    ]


def _velocities(cubics):
    """At the start of each of the cubics, and at the end of the last one."""
    return np.array([*(numeric.derivative(cubic, 0) for cubic in cubics), numeric.derivative(cubics[-1], 1)])


def _natural(data):
    return _velocities(joins.natural(data["heights"]))


def _natural_mistakes(data):
    heights = data["heights"]
    through = numeric.fit(heights, 2)
    return [
        (_velocities(joins.catmull_rom(heights)), "These are those of the one-sixth rule: is p'' = 0 at the ends?"),
        (_natural(data) / 3, "These are the edges of the control polygons: a velocity is three times as much."),
        (
            (0, F(3 * (heights[2] - heights[0]), 4), 0),
            "You set the velocities at the ends to 0. Natural means: p'' is 0.",
        ),
        (numeric.derivative(through, [0, F(1, 2), 1]) / 2, "So it is one parabola, and its p'' is nowhere 0."),
        (_natural(data)[::-1], "The numbers are right and their order is reversed."),
    ]


def _jump(right, left):
    """So many times the second derivatives by the one-sixth rule at the third of five data points, added."""
    cubics = joins.catmull_rom([D[number] for number in range(5)])
    return right * numeric.derivative(cubics[2], 0, 2) + left * numeric.derivative(cubics[1], 1, 2)


# ---- C3


def _next(number):
    """The point c_1, c_2 or c_3 with which a curve goes on like itself: its last few points taken at t = 2."""
    return numeric.evaluate([b[n - back] for back in range(number, -1, -1)], 2)


def _third_mistakes(data):
    difference = b[n] - 3 * b[n - 1] + 3 * b[n - 2] - b[n - 3]
    return [
        (_next(3) - difference, "Your third difference is 0. On the left it need not be: it goes on, too."),
        (_next(3) - 2 * difference, "The third difference has the other sign: the later point is the positive one."),
        (2 * _next(2) - _next(1), "Your c_1, c_2, c_3 are in one line. That looks at no third derivative."),
        (2 * b[n] - b[n - 3], "This is the left curve turned by half a turn. Is its second derivative right?"),
        (_next(2), "This is c_2. One step more."),
    ]


# ---- A join for the eye


def _seam(data):
    """One right answer: half of the velocity, a quarter of the second difference."""
    _, before, inner, last = np.array(data["left"], dtype=object)
    return [
        last,
        last + F(1, 2) * (last - inner),
        last + (last - inner) + F(1, 4) * (last - 2 * inner + before),
        data["end"],
    ]


def _holds(name):
    return lambda data, found: len(found) == 4 and getattr(joins.continuity(data["left"], found), name).holds


DEMANDS = (
    (lambda data, found: len(found) == 4, "A cubic has four control points."),
    (
        lambda data, found: tuple(found[0]) == data["left"][-1] and tuple(found[-1]) == data["end"],
        "The ends are not both where they should be.",
    ),
    (_holds("G1"), "At the join there is a corner, or no tangent. Where may c_1 lie?"),
    (
        lambda data, found: not _holds("C1")(data, found),
        "The direction is right. But the velocity does not jump: it is C1.",
    ),
    (_holds("G2"), "The direction is right, but the curvature jumps. How far from the tangent must c_2 be?"),
)
CLOCK = """n(n-1)((1+r)^2 b[n] - 2r(1+r) b[n-1] + r^2 b[n-2] - 2(b[n] + r(b[n] - b[n-1])) + b[n])/r^2
= n(n-1)((1+r)^2 b[n] - 2b[n] - 2r b[n] + b[n] - 2r^2 b[n-1] + r^2 b[n-2])/r^2
= n(n-1)(b[n] - 2b[n-1] + b[n-2])"""

SET = Set(
    BOOK,
    draw,
    {
        "unlike": asks_value(
            "points",
            lambda data: (
                f"The parabola {listed(data['parabola'])} runs over an interval of length {data['lengths'][0]}. Behind "
                f"it a cubic c_0, ..., c_3 runs over one of length {data['lengths'][1]}, and the join is C2. Give c_0, "
                f"c_1 and c_2."
            ),
            _onward,
            _onward_mistakes,
            (
                "First c_1, from the velocities: degree times edge over length.",
                "Then c_2: n (n - 1) times the second difference, over the square of the length.",
            ),
        ),
        "bend": asks_value(
            "number",
            lambda data: (
                f"The left cubic ends with b_1 = {point(data['before'])}, b_2 = ({-data['edges'][0]}, 0), "
                f"b_3 = (0, 0). The right one begins with b_3, b_4 = ({data['edges'][1]}, 0), "
                f"b_5 = ({data['behind']}, y). For which y is the curvature the same on both sides of the join?"
            ),
            _bend,
            _bend_mistakes,
            (
                "Only three things count: the edge at the join, how high the third point is, and on which side.",
                "The curvature is a number times the height over the square of the edge.",
            ),
        ),
        "middle": asks_value(
            "point",
            lambda data: (
                f"Cubics run through {listed(data['data'], 'D')} by the one-sixth rule. Where is the cubic from D_1 to "
                f"D_2 at t = 1/2?"
            ),
            lambda data: _halfway(joins.catmull_rom(data["data"])[1]),
            _middle_mistakes,
            ("First the two inner control points.", "Then the weights 1/8, 3/8, 3/8, 1/8."),
        ),
        "natural": asks_value(
            "numbers",
            lambda data: (
                f"The natural cubic spline runs through the heights {listed(data['heights'], 'D')}, both intervals of "
                f"length 1. Give its three velocities v_0, v_1, v_2 at the data points."
            ),
            _natural,
            _natural_mistakes,
            (
                "One equation for each data point. At the ends p'' = 0: 2 v_0 + v_1 = 3 (D_1 - D_0), and likewise.",
                "In the middle p'' does not jump: v_0 + 4 v_1 + v_2 = 3 (D_2 - D_0).",
            ),
        ),
        "jump": asks_formula(
            lambda data: (
                "The data heights y_0, y_1, y_2, y_3, y_4 are joined by the one-sixth rule, on intervals of length 1. "
                "By how much does the second derivative jump at y_2, the right side minus the left one? A formula in "
                "y_0, ..., y_4."
            ),
            lambda data: _jump(1, -1),
            {D},
            mistakes=lambda data: [
                (_jump(-1, 1), "This is the left side minus the right one."),
                (_jump(1, 0), "This is the second derivative on the right. Subtract what arrives from the left."),
                (_jump(0, 1), "This is the second derivative on the left. How does it go on?"),
                (_jump(1, 1), "You added the two sides."),
                (_jump(1, -1) / 6, "These are the second differences. A factor is missing."),
                (Integer(0), "The rule makes the velocity go on. Does it look at second derivatives?"),
            ],
            hints=(
                "Write down the three last control points on the left and the three first on the right.",
                "A cubic's p'' at an end is 6 times the second difference there.",
            ),
        ),
        "third": asks_formula(
            lambda data: (
                "A curve of degree n >= 3 with b_0, ..., b_n is followed by one of the same degree with c_0, ..., c_n, "
                "over an interval of the same length. Even the third derivative goes on: the join is C3. Write c_3 in "
                "b[n], b[n-1], b[n-2] and b[n-3]."
            ),
            lambda data: _next(3),
            {b, n},
            {n: (3, oo)},
            _third_mistakes,
            (
                "c_1 and c_2 are those of the lesson. The third differences on both sides are equal.",
                "For n = 3 both are parts of one cubic: then c_3 is its point at t = 2.",
            ),
        ),
        "raised": asks_truth(
            lambda data: (
                "A curve of degree n is written with degree n + 1: b_n stays, and the height of the last point but one "
                "changes from x to (n x + y)/(n+1), where y is that of b_n. True or false, for all n >= 1 and all x, "
                "y: degree times last edge stays as it is, so that every C1 join stays C1: "
                "(n+1) (y - (n x + y)/(n+1)) = n (y - x)? If false, give a counterexample."
            ),
            lambda data: Eq((n + 1) * (y - (n * x + y) / (n + 1)), n * (y - x), evaluate=False),
            {n: (1, oo)},
            ("Has the curve changed?", "Try n = 1 with x = 0, y = 2."),
        ),
        "half-turn": asks_truth(
            lambda data: (
                "A cubic is turned about its end b_3 by half a turn, and so goes on: b_4 = 2 b_3 - b_2, "
                "b_5 = 2 b_3 - b_1. This is C1 over equal intervals. Let x, y, z be the heights of b_1, b_2, b_3. True "
                "or false, for all x, y, z: it is C2, too, x - 2y + z = z - 2(2z - y) + (2z - x)? If false, give a "
                "counterexample."
            ),
            lambda data: Eq(x - 2 * y + z, z - 2 * (2 * z - y) + (2 * z - x), evaluate=False),
            {},
            (
                "Draw a bend and turn it: to which side does it bend then?",
                "Take heights that do not rise in equal steps.",
            ),
        ),
        "clock": asks_derivation(
            lambda data: (
                "A curve of degree n >= 2 is followed by one of the same degree, over an interval r >= 1 times as "
                "long, with c_0 = b[n], c_1 = b[n] + r(b[n] - b[n-1]) and c_2 = (1+r)^2 b[n] - 2r(1+r) b[n-1] + "
                "r^2 b[n-2]. Derive that the second derivative goes on, from n(n-1)(c_2 - 2c_1 + c_0)/r^2, which is "
                f"{CLOCK.splitlines()[0]}, to n(n-1)(b[n] - 2b[n-1] + b[n-2]), with at least one line between."
            ),
            CLOCK,
            {b, n, r},
            {n: (2, oo), r: (1, oo)},
            hints=("Collect what stands before b[n], and before b[n-1].", "(1+r)^2 - 2 - 2r + 1 = r^2."),
        ),
        "seam": asks_position(
            lambda data: (
                f"A drawing needs no clock. The left cubic is {listed(data['left'])}. Give the four control points of "
                f"a right one from b_3 to {point(data['end'])} so that direction and curvature go on (G2), and the "
                f"velocity jumps: over intervals of length 1 the join is not C1."
            ),
            DEMANDS,
            _seam,
            (
                "Choose c_1 on the tangent, with an edge of another length: half of it, or twice.",
                "With s times the edge, c_2 - 2 c_1 + c_0 = s^2 (b_3 - 2 b_2 + b_1) gives the curvature.",
            ),
        ),
    },
)
