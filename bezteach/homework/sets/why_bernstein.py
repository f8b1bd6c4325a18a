"""Homework on lesson 01: the way and the time, and what moves with one number: a coefficient or a control point."""

from fractions import Fraction as F

import numpy as np
from sympy import Ge, Integer, Interval, Le, Rational, Sum, binomial, oo, symbols

from bezteach import numeric
from bezteach.display import number, point
from bezteach.examples import EXAMPLES
from bezteach.numeric.derivatives import cross
from bezteach.symbolic import B, b, i, j, k, n, t

from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value, listed

BOOK = {
    "road": (0, 4, 2),
    "cubic": EXAMPLES["deck/split"].given["points"],
    "push": (3, 6),
    "at": F(1, 3),
    "samples": ((F(1, 2), 11), (F(1, 4), 2)),
    "place": F(1, 2),
    "from": (0, 2),
    "to": (4, 0),
    "top": 3,
}
TURNS = [(4, 2), (2, 4), (6, 3), (3, 6), (3, 2), (2, 3), (6, 4), (4, 6)]  # the edges out and back: fifths and thirds
v = symbols("v", real=True)


def draw(chance):
    """Small whole points; two samples that leave a whole height; a second end that is lower than the first."""
    start, (out, back) = chance.randint(0, 3), chance.choice(TURNS)
    size, off = chance.randint(1, 3), chance.choice([-1, 1])
    low, (x, y) = chance.randint(0, 2), (chance.randint(0, 2), 2 * chance.randint(1, 2))
    return {
        "road": (start, start + out, start + out - back),
        "cubic": tuple((2 * step + chance.randint(-1, 1), chance.randint(0, 4)) for step in range(4)),
        "push": (3 * chance.randint(1, 2), 3 * chance.choice([-2, -1, 1, 2])),
        "at": chance.choice([F(1, 3), F(2, 3), F(1, 4), F(3, 4)]),
        "samples": ((F(1, 2), 4 * size + 3 * off), (chance.choice([F(1, 4), F(3, 4)]), 3 * size - 4 * off)),
        "place": chance.choice([F(1, 2), F(1, 3), F(2, 3), F(1, 4)]),
        "from": (x, low + y),
        "to": (x + chance.randint(2, 4), low),
        "top": low + y + chance.randint(1, 3),
    }


def _turn(road):
    """The t at which the velocity on a line is 0."""
    first, second = numeric.hodograph(road).tolist()
    return F(first, first - second)


def _parts(road, turn):
    """The ways before and after this t."""
    return abs(np.diff(numeric.evaluate(road, [0, turn, 1])))


def _way(data):
    return _parts(data["road"], _turn(data["road"])).sum()


def _way_mistakes(data):
    out, back = _parts(data["road"], _turn(data["road"]))
    return [
        (abs(out - back), "This is how far the end is from the start. But the car turns on the way."),
        (
            abs(np.diff(np.array(data["road"], dtype=object))).sum(),
            "This is the length of the polygon: the car never comes to b_1.",
        ),
        (_parts(data["road"], F(1, 2)).sum(), "The car does not turn at t = 1/2. When is its velocity 0?"),
        (out, "This is the way out. The car drives back, too."),
        (back, "This is the way back alone."),
    ]


def _raised(data, shares):
    return np.array(data["cubic"], dtype=object) + np.outer(shares, data["push"])


def _pushed(data):
    """The control points after the coefficient of t has been moved."""
    coefficients = numeric.to_power(data["cubic"])
    coefficients[1] = coefficients[1] + data["push"]
    return numeric.from_power(coefficients)


def _pushed_mistakes(data):
    third = F(1, 3)
    return [
        (_raised(data, (0, 1, 0, 0)), "You moved b_1 alone. A coefficient is no control point: write t in the B's."),
        (_raised(data, (0, 1, 1, 1)), "The ends are right. At the inner points t has not its full weight yet."),
        (_raised(data, (0, third, 0, 0)), "b_1 is right. But t has a part in the later functions, too."),
        (
            _raised(data, (0, third, third, third)),
            "b_1 is right. Is t as small at the end as at b_1?",
        ),
        (_raised(data, (1, 2 * third, third, 0)), "These are the shares of 1 - t. Where does the curve stay?"),
        (_raised(data, (1, 1, 1, 1)), "So the curve is moved as a whole. That is what the coefficient a_0 does."),
    ]


def _to_heights(at):
    """The matrix that makes control heights of the values at 0, ``at`` and 1."""
    return numeric.fit(np.eye(3, dtype=int), 2, (0, at, 1))


def _matrix_mistakes(data):
    places, right = (0, data["at"], 1), _to_heights(data["at"])
    return [
        (numeric.bernstein(2, places), "This is the matrix the other way: from the heights to the values."),
        (numeric.to_power(right), "This gives the coefficients of 1, t, t^2. Asked are control heights."),
        (right.T, "Rows and columns are exchanged: a row says what goes into one height."),
        (_to_heights(1 - data["at"]), "t and 1 - t are exchanged."),
        (_to_heights(F(1, 2)), "This would be right if the middle value were taken at t = 1/2."),
        (np.eye(3, dtype=int), "Then the curve would pass through its middle control point."),
    ]


def _middle(data):
    """The weights of b_1 at the samples, and the samples."""
    places, heights = zip(*data["samples"], strict=True)
    return numeric.bernstein(2, places)[:, 1], np.array(heights, dtype=object)


def _nearest(data):
    weights, heights = _middle(data)
    return weights @ heights / (weights @ weights)


def _nearest_mistakes(data):
    weights, heights = _middle(data)
    through = heights / weights
    return [
        (through[0], "This parabola passes through the first sample and does not care for the second."),
        (through[1], "This parabola passes through the second sample and does not care for the first."),
        (through.mean(), "This is the mean of the two heights that hit one sample each: they do not count alike."),
        (heights.mean(), "This is the mean of the samples. The parabola is lower than b_1."),
        (
            weights @ heights / weights.sum(),
            "You divided by the sum of the weights. But b_1 comes with a weight twice.",
        ),
        (weights @ heights, "This sum is not b_1 yet: in the equation b_1 is multiplied with another one."),
    ]


def _place(data):
    return Rational(data["place"])


def _powers(data, count):
    """1 + c + c^2 + ... at the place c, so many terms."""
    return (1 - _place(data) ** count) / (1 - _place(data))


DEMANDS = (
    (lambda data, found: len(found) == 3, "A curve of degree 2 has three control points."),
    (
        lambda data, found: tuple(found[0]) == data["from"] and tuple(found[-1]) == data["to"],
        "The ends are not both where they should be.",
    ),
    (
        lambda data, found: numeric.evaluate(found, F(1, 2))[1] == data["top"],
        "At t = 1/2 the curve has another height. Which weights have the three points there?",
    ),
    (
        lambda data, found: (np.diff(found[:, 0]) < 0).any(),
        "From left to right all the time: this is a graph. Where must b_1 lie, so that the curve turns back?",
    ),
    (
        lambda data, found: len(found) == 3 and any(cross(*(found[1:] - found[0]))),
        "Your points lie on one line: the curve turns back on it, and is a graph after all.",
    ),
)
SIZE = binomial(n, i) * 2 ** (n - i)
LINES = (
    Sum((b[i] + v) * B(i, n, t), (i, 0, n)),
    Sum(b[i] * B(i, n, t), (i, 0, n)) + v * Sum(B(i, n, t), (i, 0, n)),
    Sum(b[i] * B(i, n, t), (i, 0, n)) + v,
)

SET = Set(
    BOOK,
    draw,
    {
        "way": asks_value(
            "number",
            lambda data: (
                f"A car drives on a straight road. Its place there, in km, is a function of degree 2 with the control "
                f"heights {listed(data['road'])}. How many km does it drive from t = 0 to t = 1, forth and back?"
            ),
            _way,
            _way_mistakes,
            (
                "Where does the car turn?",
                "At the turn the velocity is 0. It is 2 (b_1 - b_0) at t = 0 and 2 (b_2 - b_1) at t = 1; in between it "
                "changes evenly.",
                "Then add the way out and the way back.",
            ),
        ),
        "coefficient": asks_value(
            "points",
            lambda data: (
                f"The cubic {listed(data['cubic'])} is written as a_0 + a_1 t + a_2 t^2 + a_3 t^3. Then somebody adds "
                f"{point(data['push'])} to a_1 and to no other coefficient. The four control points of the new curve?"
            ),
            _pushed,
            _pushed_mistakes,
            ("You need not compute the coefficients: only t times a vector is added.", "Write t in the cubic basis."),
        ),
        "values": asks_value(
            "matrix",
            lambda data: (
                f"A function of degree 2 has the values y_0, y_1, y_2 at t = 0, {number(data['at'])} and 1. Give the "
                f"matrix M with b = M y, which makes its control heights of these values: a list of three rows."
            ),
            lambda data: _to_heights(data["at"]),
            _matrix_mistakes,
            ("Two of the heights are values.", "Write y_1 with the three weights, and solve for b_1."),
        ),
        "nearest": asks_value(
            "number",
            lambda data: (
                "A function of degree 2 has b_0 = b_2 = 0. Two samples: "
                + " and ".join(f"height {height} at t = {place}" for place, height in data["samples"])
                + ". For which control height b_1 is the sum of the squared errors at the two samples least?"
            ),
            _nearest,
            _nearest_mistakes,
            (
                "The function is b_1 times 2t (1 - t). Only one number is free.",
                "At the least sum, the errors times the weights of b_1 add up to 0.",
            ),
        ),
        "raised": asks_formula(
            lambda data: (
                f"A function is written in powers, a_0 + a_1 t + ... + a_n t^n, with n >= 1. All n + 1 coefficients "
                f"are raised by 1. By how much does the value at t = {data['place']} rise? A formula in n."
            ),
            lambda data: _powers(data, n + 1),
            {n, k},
            {n: (1, oo)},
            lambda data: [
                (n + 1, "This is what happens at t = 1, where every power is 1."),
                (Integer(1), "So do control heights, whose weights add up to 1. Do these weights?"),
                (_powers(data, n), "One term is missing: the powers run from 0 to n."),
                (_powers(data, n + 1) - 1, "The term a_0 is missing: it is raised, too."),
                (1 / (1 - _place(data)), "This is the sum of infinitely many powers. Here they end with t^n."),
                (_place(data) ** n, "This is what the last coefficient brings. All of them are raised."),
            ],
            ("Which number is each coefficient multiplied with?", "The sum of a geometric series."),
        ),
        "size": asks_formula(
            lambda data: (
                "Multiply B(i,n,t) out into powers of t. How large is the sum of the absolute values of its "
                "coefficients? A formula in i and n, for n >= 1 and i = 0, ..., n."
            ),
            lambda data: SIZE,
            {i, j, k, n},
            {n: (1, oo), i: (0, n)},
            lambda data: [
                (2**n, "This is right for i = 0. How many brackets are there for the other i?"),
                (2 ** (n - i), "The brackets are right. B(i,n,t) has a factor before them."),
                (binomial(n, i), "This is the first coefficient alone: the power of 1 - t brings more."),
                (binomial(n, i) * 2**n, "Only the power of 1 - t is multiplied out. How many brackets is that?"),
                (Integer(0), "With their signs most sums are 0. Asked is for the sum of their sizes."),
            ],
            (
                "Try B(1,3,t) = 3t (1-t)^2 first.",
                "The sizes of the coefficients of (1-t)^m are those of (1+t)^m. How do you get their sum?",
            ),
        ),
        "arc": asks_truth(
            lambda data: (
                "The control points (1, 0), (1, 1), (0, 1) give the parabola x = 1 - t^2, y = 2t - t^2. It looks like "
                "a quarter of the circle x^2 + y^2 = 1. True or false, for all t in [0, 1]: it is never inside, "
                "(1 - t^2)^2 + (2t - t^2)^2 >= 1? If false, give a counterexample."
            ),
            lambda data: Ge((1 - t**2) ** 2 + (2 * t - t**2) ** 2, 1),
            {t: Interval(0, 1)},
            ("Begin with t = 1/2.", "Subtract 1 and look for a square."),
        ),
        "weaker": asks_truth(
            lambda data: (
                "Raise the control height b_i by 1, or in powers the coefficient a_i by 1: the value at t rises by "
                "B(i,n,t) or by t^i. True or false: the control height never moves the graph more, B(i,n,t) <= t^i "
                "for all n >= 1, i = 0, ..., n and t in [0, 1]? If false, give a counterexample."
            ),
            lambda data: Le(B(i, n, t), t**i),
            {n: (1, oo), i: (0, n), t: Interval(0, 1)},
            ("Look at the far end, and then near the start.", "Where is B(i,n,t) greatest, and what is t^i there?"),
        ),
        "shifted": asks_derivation(
            lambda data: (
                "All control heights are raised by v. Derive that the whole graph rises by v: begin with "
                "sum((b_i + v) B(i,n,t), i, 0, n), end with sum(b_i B(i,n,t), i, 0, n) + v, with at least one line "
                "between."
            ),
            LINES,
            {b, i, j, n, t, v},
            {n: (0, oo)},
            hints=("Multiply the bracket out and part the sum.", "v does not depend on i. What is left of its sum?"),
        ),
        "turned": asks_position(
            lambda data: (
                f"Give three control points of a parabola from {point(data['from'])} to {point(data['to'])} that has "
                f"the height {data['top']} at t = 1/2 and is not the graph of any function y = g(x)."
            ),
            DEMANDS,
            lambda data: (
                data["from"],
                (data["to"][0] + 2, 2 * data["top"] - F(data["from"][1] + data["to"][1], 2)),
                data["to"],
            ),
            (
                "The ends are given, and the height at t = 1/2 gives the height of b_1: the weights are 1/4, 1/2, 1/4.",
                "A curve that turns back in x is over some x twice.",
            ),
        ),
    },
)
