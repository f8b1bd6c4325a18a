"""Homework on lesson 04: the ends, the clock, maps, straight lines, and what a moved point does."""

from fractions import Fraction as F

import numpy as np
from sympy import Ge, Integer, Interval, Rational, Sum, binomial, oo
from sympy.abc import x, y

from bezteach import numeric
from bezteach.display import point
from bezteach.examples import EXAMPLES
from bezteach.symbolic import B, i, j, n, t, text

from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value, listed

BOOK = {
    "cubic": EXAMPLES["deck/split"].given["points"],
    "interval": (1, 3),
    "ways": ((9, 0), (0, 18)),
    "at": EXAMPLES["deck/split"].given["t"],
    "from": (1, 1),
    "half": (4, 7),
    "shift": (0, 2),
    "foot": (0, 0),
    "axis": 3,
    "top": 3,
}


def draw(chance):
    """Cubics on small whole points that run to the right; ways that leave whole numbers at thirds."""
    low, start = chance.randint(0, 3), (chance.randint(0, 3), chance.randint(0, 3))
    way = (3 * chance.randint(1, 3), 3 * chance.choice([-2, -1, 1, 2]))
    foot = (chance.randint(-1, 2), chance.randint(0, 2))
    return {
        "cubic": tuple((2 * k + chance.randint(0, 1), height) for k, height in enumerate(chance.sample(range(6), 4))),
        "interval": (low, low + chance.choice([2, 4])),
        "ways": tuple((9 * chance.randint(1, 2), 9 * chance.choice([-2, -1, 1, 2])) for _ in range(2)),
        "at": chance.choice([F(1, 3), F(2, 3)]),
        "from": start,
        "half": (start[0] + way[0], start[1] + way[1]),
        "shift": (chance.randint(1, 3), chance.choice([-2, -1, 1, 2])),
        "foot": foot,
        "axis": foot[0] + chance.randint(2, 4),
        "top": foot[1] + 3 * chance.randint(1, 2),
    }


def _array(control_points):
    return np.array(control_points, dtype=object)


def _length(data):
    return F(data["interval"][1] - data["interval"][0])


def _clock(data, place=1):
    return numeric.derivative(data["cubic"], place) / _length(data)


def _clock_mistakes(data):
    right, length = _clock(data), _length(data)
    return [
        (right * length, "This is p'(1), measured in t. In u the same way takes another time."),
        (right * length**2, "More time for the same way: is the point faster?"),
        (right / 3, "This is the last edge over the time. The velocity has a factor more."),
        (_clock(data, 0), "This is the velocity at the start."),
        (-right, "This arrow points back: later minus earlier."),
    ]


def _moved(data, place=None):
    weights = numeric.bernstein(3, data["at"] if place is None else place)
    return weights[1:3] @ _array(data["ways"])


def _moved_mistakes(data):
    first, second = ways = _array(data["ways"])
    return [
        (_moved(data, 1 - data["at"]), "t and 1 - t are exchanged."),
        (first + second, "Each way counts with the weight of its point."),
        (
            (first + second) / F(2),
            "The two weights are not 1/2 each: they depend on t, and the other points weigh, too.",
        ),
        (_moved(data) / 3, "The powers are right. The binomial coefficients are missing."),
        (numeric.bernstein(3, data["at"])[:2] @ ways, "These are the weights of b_0 and b_1: they are counted from 0."),
    ]


def _even(data, *shares):
    """The start and so many times the way to the middle."""
    start, half = _array(data["from"]), _array(data["half"])
    return [start + share * (half - start) for share in shares]


def _even_mistakes(data):
    return [
        (_even(data, *(F(k, 3) for k in range(4))), "Straight and evenly, but you are there at t = 1 only."),
        (_even(data, 0, 1, 1, 2), "Straight, and in time for t = 1/2. But the first edge is long: not evenly."),
        (
            _even(data, 0, F(1, 2), F(3, 2), 2),
            "Straight, and in time for t = 1/2. But the edges are not equal: not evenly.",
        ),
        (_even(data, 0, 1, 2), "The segment is right, with degree 2. A cubic has a point more."),
        (_even(data, 0, F(2, 3), F(4, 3), 2)[::-1], "The points are right and their order is reversed."),
    ]


def _mapped(control_points, shift):
    """(x, y) to (x - y, y), shifted."""
    return [(right - up + shift[0], up + shift[1]) for right, up in control_points]


def _image(data):
    return _mapped(data["cubic"], data["shift"])[::-1]


def _image_mistakes(data):
    shifted = _array(data["cubic"]) + _array(data["shift"])
    return [
        (_image(data)[::-1], "The map is right. But q begins where p ends."),
        (_mapped(data["cubic"], (0, 0))[::-1], "The shift is missing: it goes to each control point."),
        (data["cubic"][::-1], "You turned the curve round and did not map it."),
        (_mapped(shifted, (0, 0))[::-1], "You shifted first: the map takes x - y before it shifts."),
    ]


def _is_mirrored(data, found):
    back = found[::-1]
    return (found[:, 0] + back[:, 0] == 2 * data["axis"]).all() and (found[:, 1] == back[:, 1]).all()


def _mirrored(data):
    (left, low), high = data["foot"], F(4 * data["top"] - data["foot"][1], 3)
    right = 2 * data["axis"] - left
    return [(left, low), (left, high), (right, high), (right, low)]


DEMANDS = (
    (lambda data, found: len(found) == 4, "A cubic has four control points."),
    (lambda data, found: tuple(found[0]) == data["foot"], "The curve does not start where it should."),
    (
        _is_mirrored,
        "The mirror does not exchange the points in pairs: the first with the last, the second with the third.",
    ),
    (
        lambda data, found: tuple(numeric.evaluate(found, F(1, 2))) == (data["axis"], data["top"]),
        "At t = 1/2 the curve is somewhere else. Which weights have the four points there?",
    ),
)
LINES = (
    Sum(2**j * B(j, n, t), (j, 0, n)),
    Sum((2 * t) ** j * (1 - t) ** (n - j) * binomial(n, j), (j, 0, n)),
    (1 + t) ** n,
)

SET = Set(
    BOOK,
    draw,
    {
        "clock": asks_value(
            "point",
            lambda data: (
                f"The cubic {listed(data['cubic'])} is run through while u goes from {data['interval'][0]} to "
                f"{data['interval'][1]}. Its velocity at the end, measured in u, as a vector?"
            ),
            _clock,
            _clock_mistakes,
            ("First the velocity in t: which edge, and how many times?", "Then divide by the length of the interval."),
        ),
        "moved": asks_value(
            "point",
            lambda data: (
                f"Of a cubic, b_1 is moved by {point(data['ways'][0])} and b_2 by {point(data['ways'][1])}. By which "
                f"vector does the point at t = {data['at']} move?"
            ),
            _moved,
            _moved_mistakes,
            ("Two of the four terms change.", "Each way times the weight of its point, B(1,3,t) or B(2,3,t)."),
        ),
        "even": asks_value(
            "points",
            lambda data: (
                f"A point runs straight on and evenly. It is at {point(data['from'])} for t = 0 and at "
                f"{point(data['half'])} for t = 1/2. Write its way for t in [0, 1] as a cubic: four control points."
            ),
            lambda data: _even(data, 0, F(2, 3), F(4, 3), 2),
            _even_mistakes,
            ("Where is the point at t = 1?", "Linear precision: control points at equal steps."),
        ),
        "image": asks_value(
            "points",
            lambda data: (
                f"p is the cubic {listed(data['cubic'])}. A map sends (x, y) to ({text(x - y + data['shift'][0])}, "
                f"{text(y + data['shift'][1])}). The curve q(t) is the image of p(1 - t). Its four control points, in "
                f"its own order?"
            ),
            _image,
            _image_mistakes,
            ("Two properties, one after the other.", "Map the control points; then think of where q begins."),
        ),
        "alternate": asks_formula(
            lambda data: (
                "A function of degree n >= 1 has the control heights 1, -1, 1, -1, ..., (-1)^n: its polygon passes 0 "
                "as often as it can. Write the function in n and t, for t in (0, 1)."
            ),
            lambda data: (1 - 2 * t) ** n,
            {i, j, n, t},
            {n: (1, oo), t: Interval.open(0, 1)},
            lambda data: [
                ((1 - t) ** n - t**n, "These are the two ends alone. The heights between them count, too."),
                ((1 - t) ** n + (-t) ** n, "These are the two ends alone. The heights between them count, too."),
                (1 - 2 * t, "This is right for n = 1. What is the function at t = 1, for n = 2?"),
                ((2 * t - 1) ** n, "The sign: at t = 0 it is b_0 = 1."),
                (Integer(1), "The heights alternate: this is the sum with all of them 1."),
            ],
            (
                "Write the sum with its binomials and powers.",
                "(-1)^j belongs to t^j: which binomial theorem is this?",
            ),
        ),
        "half": asks_truth(
            lambda data: (
                "b_i is moved by v. The point at t = i/n moves most, by B(i, n, i/n) v. True or false, for all n >= 1 "
                "and i = 0, ..., n: B(i, n, i/n) >= 1/2? If false, give a counterexample."
            ),
            lambda data: Ge(B(i, n, i / n), Rational(1, 2)),
            {n: (1, oo), i: (0, n)},
            ("Begin with n = 1 and n = 2.", "The more control points, the less weight for each."),
        ),
        "parabola": asks_truth(
            lambda data: (
                "The control points (j/n, (j/n)^2) lie on the parabola y = x^2, and then x(t) = t. True or false: the "
                "curve is never below the parabola, that is, sum((j/n)^2 B(j,n,t), j, 0, n) >= t^2 for all n >= 1 and "
                "t in [0, 1]? If false, give a counterexample."
            ),
            lambda data: Ge(Sum((j / n) ** 2 * B(j, n, t), (j, 0, n)), t**2),
            {n: (1, oo), t: Interval(0, 1)},
            ("Try n = 1 and n = 2.", "In which hull is the point, and where does this hull lie?"),
        ),
        "doubling": asks_derivation(
            lambda data: (
                "The control heights are 1, 2, 4, ..., 2^n. Derive the function, from sum(2^j B(j,n,t), j, 0, n) to "
                "(1+t)^n, with at least one line between."
            ),
            LINES,
            {i, j, n, t},
            {n: (0, oo)},
            hints=("Write B(j,n,t) out, and put 2^j to one of its powers.", "The binomial theorem for 2t and 1-t."),
        ),
        "mirror": asks_position(
            lambda data: (
                f"Give four control points of a cubic that starts at {point(data['foot'])} and is its own mirror image "
                f"in the line x = {data['axis']}, with p(1/2) = ({data['axis']}, {data['top']}). The mirror "
                f"exchanges b_0 with b_3 and b_1 with b_2."
            ),
            DEMANDS,
            _mirrored,
            (
                "Where is b_3? Only b_1 is left to choose.",
                "At t = 1/2 the weights are 1/8, 3/8, 3/8, 1/8: which y has b_1?",
            ),
        ),
    },
)
