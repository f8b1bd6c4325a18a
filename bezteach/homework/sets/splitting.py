"""Homework on lesson 08: splitting a curve, and the part of it between two parameters."""

from fractions import Fraction as F

from sympy import Eq, Interval, oo

from bezteach import numeric
from bezteach.examples import EXAMPLES
from bezteach.symbolic import B, b, i, n, t

from ..kinds import Set, asks_derivation, asks_formula, asks_truth, asks_value, listed

SPLIT, SEGMENT = EXAMPLES["deck/split"], EXAMPLES["deck/segment"]
BOOK = {
    "points": SPLIT.given["points"],
    "t": SPLIT.given["t"],
    "arch": SEGMENT.given["points"],
    "a": SEGMENT.given["start"],
    "b": SEGMENT.given["end"],
}
PARTS = [(F(1, 4), F(3, 4)), (F(1, 3), F(2, 3)), (F(1, 4), F(1, 2)), (F(1, 2), F(3, 4)), (F(1, 3), F(5, 6))]


def draw(chance):
    """Cubics on small whole numbers, cut at thirds or quarters."""

    def cubic(size):
        return tuple((size * k + chance.randint(-1, 1), size * chance.randint(0, 4)) for k in range(4))

    a, end = chance.choice(PARTS)
    return {"points": cubic(2), "t": chance.choice([F(1, 3), F(2, 3)]), "arch": cubic(4), "a": a, "b": end}


def _half(side):
    return lambda data: numeric.split(data["points"], data["t"])[side]


def _half_mistakes(side):
    def mistakes(data):
        right, other = _half(side)(data), _half(1 - side)(data)
        mirrored = numeric.split(data["points"], 1 - data["t"])[side]
        return [
            (right[::-1], "The points are right and their order is reversed: a half runs the way of the curve."),
            (other, "This is the other half."),
            (mirrored, "t and 1 - t are exchanged: t is the share of the later point."),
            (
                numeric.de_casteljau(data["points"], data["t"])[-2 if len(right) < 3 else 1],
                "This is one level of the triangle: a half takes one point of each level.",
            ),
        ]

    return mistakes


def _part(data):
    return numeric.segment(data["arch"], data["a"], data["b"])


def _part_mistakes(data):
    front = numeric.split(data["arch"], data["b"])[0]
    return [
        (_part(data)[::-1], "The points are right and their order is reversed: the part runs from a to b."),
        (
            numeric.split(front, data["a"])[1],
            "The second cut stands at a in the front piece, which has a parameter of its own.",
        ),
        (front, "This is the whole piece in front of b: cut off what is before a."),
        (numeric.split(data["arch"], data["a"])[1], "This is all behind a: cut off what is after b."),
    ]


def _local_mistakes(data):
    a, end = data["a"], data["b"]
    return [
        (a, "This is a itself: the front piece has a parameter of its own, from 0 to 1."),
        ((end - a) / (1 - a), "This is where b stands in the piece behind a. Here the cut at b came first."),
        (end - a, "This is the length of the part, and not where its start stands in the front piece."),
        (a * end, "Multiplied: but a is a share of the front piece, so it grows when the piece is taken as 1."),
    ]


UNITY = """sum(B(i, n, t), i, 0, n)
= sum(C(n, i) t^i (1-t)^(n-i), i, 0, n)
= 1"""

SET = Set(
    BOOK,
    draw,
    {
        "point": asks_value(
            "point",
            lambda data: f"The point at t = {data['t']} of the cubic {listed(data['points'])}.",
            lambda data: numeric.evaluate(data["points"], data["t"]),
            lambda data: [
                (
                    numeric.evaluate(data["points"], 1 - data["t"]),
                    "t and 1 - t are exchanged: this is the point at 1 - t.",
                ),
                (
                    numeric.de_casteljau(data["points"], data["t"])[1][1],
                    "This is on the first level of the triangle: go on.",
                ),
                (
                    numeric.de_casteljau(data["points"], data["t"])[2][0],
                    "This is on the second level: one step is missing.",
                ),
            ],
            ("Divide each edge in the ratio t : 1 - t, then the edges between the new points.", "Three levels."),
        ),
        "left": asks_value(
            "points",
            lambda data: f"The control points of the part before t = {data['t']} of {listed(data['points'])}.",
            _half(0),
            _half_mistakes(0),
            ("Draw the triangle of intermediate points.", "The first point of each level."),
        ),
        "right": asks_value(
            "points",
            lambda data: f"The control points of the part after t = {data['t']} of {listed(data['points'])}.",
            _half(1),
            _half_mistakes(1),
            ("It starts where the other half ends.", "The last point of each level, from the last level back."),
        ),
        "local": asks_value(
            "number",
            lambda data: (
                f"The part over [{data['a']}, {data['b']}] of a curve is cut out: first at {data['b']}, and the front "
                f"piece is kept. At which parameter of the front piece is the second cut?"
            ),
            lambda data: data["a"] / data["b"],
            _local_mistakes,
            ("The front piece runs over [0, b]; its own parameter goes from 0 to 1.", "b is its 1, so divide by b."),
        ),
        "part": asks_value(
            "points",
            lambda data: f"The control points of the part over [{data['a']}, {data['b']}] of {listed(data['arch'])}.",
            _part,
            _part_mistakes,
            ("Two cuts, one after the other.", "The second at the local parameter, not at the original one."),
        ),
        "formula": asks_formula(
            lambda data: (
                "Over [0, t] a curve of degree n with the points b_0, ..., b_n has the control points c_0, ..., c_n. "
                "Write c_2 for n >= 2 in t and b_0, b_1, b_2."
            ),
            lambda data: (1 - t) ** 2 * b[0] + 2 * t * (1 - t) * b[1] + t**2 * b[2],
            {t, b},
            mistakes=lambda data: [
                (t**2 * b[0] + 2 * t * (1 - t) * b[1] + (1 - t) ** 2 * b[2], "t and 1 - t are exchanged."),
                (
                    (1 - t) ** 2 * b[0] + t * (1 - t) * b[1] + t**2 * b[2],
                    "The weights must sum to 1: one factor is missing.",
                ),
                ((1 - t) * b[1] + t * b[2], "This is on the first level of the triangle."),
            ],
            hints=("c_2 is the first point of level 2.", "Its weights are the Bernstein functions of degree 2 at t."),
        ),
        "front-weight": asks_truth(
            lambda data: (
                "True or false, for every n >= 1 and t in [0, 1]: B(0, n, t/2) = B(0, n, t)/2^n? "
                "If false, give a counterexample."
            ),
            lambda data: Eq(B(0, n, t / 2), B(0, n, t) / 2**n, evaluate=False),
            {n: (1, oo), t: Interval(0, 1)},
            ("Write both sides in powers.", "Try n = 1."),
        ),
        "last-weight": asks_truth(
            lambda data: (
                "True or false, for every n >= 1 and t in [0, 1]: B(n, n, t/2) = B(n, n, t)/2^n? "
                "If false, give a counterexample."
            ),
            lambda data: Eq(B(n, n, t / 2), B(n, n, t) / 2**n, evaluate=False),
            {n: (1, oo), t: Interval(0, 1)},
            ("Write both sides in powers.",),
        ),
        "unity": asks_derivation(
            lambda data: (
                "The weights of a control point of the front half sum to 1. Show it, from sum(B(i, n, t), i, 0, n) "
                "to 1, with at least one line between."
            ),
            UNITY,
            {i, n, t},
            {n: (0, oo)},
            hints=("Write the functions out.", "The binomial theorem: the sum is ((1 - t) + t)^n."),
        ),
    },
)
