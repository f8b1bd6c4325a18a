"""Homework on lesson 02: Bézier's edges, Forrest's points, and powers of t."""

from fractions import Fraction as F
from math import factorial

import numpy as np
from sympy import Eq, Interval, Sum, binomial, oo

from bezteach import numeric
from bezteach.display import point
from bezteach.examples import EXAMPLES
from bezteach.symbolic import B, b, i, j, n, t, text

from ..formulas import is_bernstein
from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value, listed

ARCH = EXAMPLES["deck/segment"].given["points"]
BOOK = {
    "walk": (ARCH[0], *map(tuple, np.diff(ARCH, axis=0).tolist())),
    "t": EXAMPLES["deck/segment"].given["end"],
    "k": 2,
    "v": (9, 18),
    "at": F(1, 3),
    "powers": (1, 6, -3, 2),
    "cubic": ((0, 0), (0, 3), (3, 3), (3, 0)),
    "start": (0, 0),
    "velocity": (3, 6),
    "middle": (3, 3),
}


def draw(chance):
    """Edges and vectors in multiples that leave small fractions at thirds; no polygon is a straight line."""

    def turn(size):
        return chance.choice([-2, -1, 1, 2]) * size

    start = (chance.randint(0, 3), chance.randint(0, 3))
    up = chance.sample([-3, 0, 3, 6], 3)
    return {
        "walk": ((chance.randint(1, 4), chance.randint(1, 4)), *((3 * chance.randint(1, 2), rise) for rise in up)),
        "t": chance.choice([F(1, 3), F(2, 3)]),
        "k": chance.randint(1, 2),
        "v": (turn(9), turn(9)),
        "at": chance.choice([F(1, 3), F(2, 3)]),
        "powers": (chance.randint(1, 4), turn(3), turn(3), chance.choice([-2, -1, 1, 2])),
        "cubic": tuple((2 * k + chance.randint(-1, 1), height) for k, height in enumerate(chance.sample(range(6), 4))),
        "start": start,
        "velocity": (turn(3), turn(3)),
        "middle": (start[0] + chance.randint(2, 4), start[1] + chance.randint(2, 4)),
    }


def _vertices(data):
    return np.cumsum(np.array(data["walk"], dtype=object), axis=0)


def _walk_mistakes(data):
    vertices, place = _vertices(data), data["t"]
    return [
        (numeric.evaluate(data["walk"], place), "You took the vectors for control points: lay them end to end first."),
        (
            numeric.evaluate(vertices - vertices[0], place),
            "Your polygon begins at the origin: a_0 leads to its first point.",
        ),
        (numeric.evaluate(vertices, 1 - place), "t and 1 - t are exchanged: this is the point at 1 - t."),
        (
            numeric.evaluate([*data["walk"][:1], *(vertices[1:] - vertices[0])], place),
            "b_0 is right, and the other points stand as seen from b_0: a_0 belongs to each of them.",
        ),
    ]


def _switch(first, place):
    """Bézier's f_i of degree 3 at a place: the Bernstein functions from number i on."""
    return numeric.bernstein(3, place)[first:].sum()


def _shift_mistakes(data):
    k, place, v = data["k"], data["at"], np.array(data["v"], dtype=object)
    return [
        (
            numeric.bernstein(3, place)[k] * v,
            "This is the way if b_k alone moves. Which vertices move with a_k?",
        ),
        (_switch(k + 1, place) * v, "One function is missing: b_k moves, too."),
        (v, "This is the way of the vertices behind the edge. A point of the curve is a mean of all four."),
        (_switch(k, 1 - place) * v, "t and 1 - t are exchanged."),
    ]


def _combined(heights):
    return sum(height * B(number, 3, t) for number, height in enumerate(heights))


def _polynomial(coefficients):
    return sum(coefficient * t**power for power, coefficient in enumerate(coefficients))


def _combination_mistakes(data):
    powers = data["powers"]
    values = [_polynomial(powers).subs(t, F(place, 3)) for place in range(4)]
    return [
        (_combined(powers), "You put the coefficients of the powers before the B's: t is not B(1, 3, t)."),
        (_combined(np.cumsum(powers).tolist()), "You added up the coefficients. Divide each by its binomial first."),
        (_combined(values), "These are the values of q at 0, 1/3, 2/3, 1. Control heights are not on the curve."),
    ]


def _differences(data):
    return [np.diff(np.array(data["cubic"], dtype=object), k, axis=0)[0] for k in range(4)]


def _powers_mistakes(data):
    right, differences = numeric.to_power(data["cubic"]), _differences(data)
    derivatives = [factorial(k) * row for k, row in enumerate(right)]
    return [
        (right[::-1], "The right vectors, the highest power first: c_0 stands before 1."),
        (differences, "These are the differences at b_0: each power has a binomial coefficient, too."),
        (derivatives, "These are the derivatives at t = 0: p'' and p''' have a factor more than c_2 and c_3."),
        (_matrix(3).T @ np.array(data["cubic"], dtype=object), "The rows and the columns of the matrix are exchanged."),
    ]


def _matrix(degree):
    """Its row k says what stands before t^k."""
    return numeric.to_power(np.eye(degree + 1, dtype=int))


def _starts(data):
    """One cubic as asked for: with b_2 in the middle, the last point follows."""
    first, velocity, middle = (np.array(data[name], dtype=object) for name in ("start", "velocity", "middle"))
    second = first + velocity / F(3)
    return [first, second, middle, 8 * middle - first - 3 * second - 3 * middle]


DEMANDS = (
    (lambda data, found: len(found) == 4, "A cubic has four control points."),
    (lambda data, found: tuple(found[0]) == data["start"], "The curve does not start where it should."),
    (
        lambda data, found: len(found) == 4 and tuple(3 * (found[1] - found[0])) == data["velocity"],
        "The velocity at t = 0 is another one. How many times the first edge is it?",
    ),
    (
        lambda data, found: tuple(numeric.evaluate(found, F(1, 2))) == data["middle"],
        "At t = 1/2 the curve is somewhere else. Which four weights have the points there?",
    ),
)
SECOND = binomial(n, 2) * (b[2] - 2 * b[1] + b[0])
LINES = (
    Sum(B(i, n, t), (i, 1, n)),
    Sum(B(i, n, t), (i, 0, n)) - B(0, n, t),
    1 - B(0, n, t),
    1 - (1 - t) ** n,
)


def _late(number, place=t):
    """Bézier's function with this number, of degree n."""
    return Sum(B(j, n, place), (j, number, n))


SET = Set(
    BOOK,
    draw,
    {
        "walk": asks_value(
            "point",
            lambda data: f"In Bézier's form a cubic has {listed(data['walk'], 'a')}. Its point at t = {data['t']}?",
            lambda data: numeric.evaluate(_vertices(data), data["t"]),
            _walk_mistakes,
            ("Walk first: where are the four vertices?", "Then weigh them with the Bernstein functions of degree 3."),
        ),
        "shift": asks_value(
            "point",
            lambda data: (
                f"In Bézier's form of a cubic, a_{data['k']} is changed by the vector {point(data['v'])}; the other "
                f"three vectors stay. By which vector does the point at t = {data['at']} move?"
            ),
            lambda data: _switch(data["k"], data["at"]) * np.array(data["v"], dtype=object),
            _shift_mistakes,
            ("p = a_0 f_0 + ... + a_3 f_3: which summand changes?", "f_i is the sum of the B(j, 3, t) from j = i on."),
        ),
        "combination": asks_formula(
            lambda data: (
                f"Write q(t) = {text(_polynomial(data['powers'])).replace('*', ' ')} as a "
                f"combination of B(0,3,t), B(1,3,t), B(2,3,t) and B(3,3,t), with numbers before them."
            ),
            lambda data: _combined(numeric.from_power(data["powers"])),
            {t},
            mistakes=_combination_mistakes,
            hints=(
                "The numbers are the control heights of q. Two of them are q(0) and q(1).",
                "Divide the coefficient of t^k by C(3, k): that is the k-th difference at b_0. Sums undo differences.",
            ),
            form=("a combination of the four B's with numbers", lambda formula: is_bernstein(formula, 3, t)),
        ),
        "powers": asks_value(
            "points",
            lambda data: (
                f"The cubic {listed(data['cubic'])} is written as c_0 + c_1 t + c_2 t^2 + c_3 t^3. Give c_0, c_1, "
                f"c_2, c_3 in this order."
            ),
            lambda data: numeric.to_power(data["cubic"]),
            _powers_mistakes,
            (
                "Rows of the matrix: each says what stands before one power.",
                "C(3, k) times the k-th difference at b_0.",
            ),
        ),
        "matrix": asks_value(
            "matrix",
            lambda data: (
                "The notes put the highest power first. Give the matrix M of degree 2 in their order: the curve is "
                "[t^2 t 1] M times the column of b_0, b_1, b_2. A list of three rows."
            ),
            lambda data: _matrix(2)[::-1],
            lambda data: [
                (_matrix(2), "This is the matrix for [1 t t^2]."),
                (_matrix(2)[::-1, ::-1], "In the rows, the points stand in the order b_2, b_1, b_0."),
                (_matrix(2)[:, ::-1], "The points stand in the order b_2, b_1, b_0 here, and the powers 1, t, t^2."),
                (
                    numeric.from_power(np.eye(3, dtype=int)),
                    "This is the way back: from 1, t, t^2 to the control points.",
                ),
            ],
            ("Multiply out (1-t)^2 b_0 + 2t(1-t) b_1 + t^2 b_2.", "The first row says what stands before t^2."),
        ),
        "second": asks_formula(
            lambda data: (
                "A curve of degree n >= 2 is multiplied out. Write what stands before t^2, in n, b_0, b_1 and b_2."
            ),
            lambda data: SECOND,
            {n, b},
            {n: (2, oo)},
            lambda data: [
                (b[2] - 2 * b[1] + b[0], "The difference is right. A factor is missing: try the cubic's matrix."),
                (2 * SECOND, "This is the second derivative at t = 0, which is twice as much."),
                (n * (b[2] - 2 * b[1] + b[0]), "The factor is not n: that one belongs to t."),
                (binomial(n, 2) * b[2], "b_0 and b_1 bring a t^2, too: multiply out their powers of 1 - t."),
            ],
            (
                "Which of B(0,n,t), B(1,n,t), B(2,n,t), ... contain t^2, and how often?",
                "C(n,2) times a combination of the three points that you know from n = 2.",
            ),
        ),
        "steady": asks_truth(
            lambda data: (
                "Bézier's functions are f_i = B(i,n,t) + ... + B(n,n,t). True or false, for all n >= 1 and t in "
                "[0, 1]: f_1 + f_2 + ... + f_n = n t? If false, give a counterexample."
            ),
            lambda data: Eq(Sum(_late(i), (i, 1, n)), n * t, evaluate=False),
            {n: (1, oo), t: Interval(0, 1)},
            (
                "Try n = 1 and n = 2.",
                "How often does B(j,n,t) occur in the whole sum?",
                "Put the control points in equal steps on a line: which curve is it?",
            ),
        ),
        "symmetric": asks_truth(
            lambda data: (
                "For n = 3, the graph of Bézier's f_2 = B(2,3,t) + B(3,3,t) stays as it is when it is turned about "
                "(1/2, 1/2) by half a turn. Write f_i(t) = B(i,n,t) + ... + B(n,n,t). True or false, for all n >= 1, "
                "i = 1, ..., n and t in [0, 1]: f_i(t) + f_i(1-t) = 1? If false, give a counterexample."
            ),
            lambda data: Eq(_late(i) + _late(i, 1 - t), 1, evaluate=False),
            {n: (1, oo), i: (1, n), t: Interval(0, 1)},
            ("Which of the three graphs f_1, f_2, f_3 look like this?", "Take t = 1/2: what is f_i there?"),
        ),
        "switch": asks_derivation(
            lambda data: (
                "How is the first edge switched on? Derive it for every n >= 1, from sum(B(i,n,t), i, 1, n) "
                "to 1 - (1-t)^n, with at least one line between."
            ),
            LINES,
            {i, j, n, t},
            {n: (1, oo)},
            hints=("Which term is missing from the sum of all?", "The sum of all is 1: subtract B(0,n,t)."),
        ),
        "start": asks_position(
            lambda data: (
                f"Give four control points of a cubic that starts at {point(data['start'])} with the velocity "
                f"p'(0) = {point(data['velocity'])} and is at {point(data['middle'])} for t = 1/2."
            ),
            DEMANDS,
            _starts,
            (
                "Two of the four points are fixed by the start and the velocity.",
                "Choose b_2 as you like. The weights at t = 1/2 are 1/8, 3/8, 3/8, 1/8: solve for b_3.",
            ),
        ),
    },
)
