"""Homework on lesson 05: the triangle by hand, forwards, outwards and back, and what it costs."""

from fractions import Fraction as F
from itertools import accumulate

import numpy as np
from sympy import Interval, Le, Lt, Rational, Sum, factor, oo

from bezteach import numeric
from bezteach.display import point
from bezteach.examples import EXAMPLES
from bezteach.symbolic import B, i, j, k, n, t
from bezteach.symbolic.operator import tidy

from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value, listed

BOOK = {
    "cubic": EXAMPLES["deck/segment"].given["points"],
    "t": EXAMPLES["deck/segment"].given["end"],
    "heights": (9, 0, 27, 18),
    "at": F(1, 3),
    "parabola": EXAMPLES["games/quadratic"].given["points"],
    "outside": -1,
    "first": ((0, 0), (1, 2), (3, 3)),  # b_0, b_0^1, b_0^2 of a parabola
    "share": F(1, 3),
    "start": (0, 0),
    "tangent": ((2, 2), (4, 3)),  # b_0^2, b_1^2 of a cubic
    "touch": F(1, 3),
}


def draw(chance):
    """Points in multiples of 3 and heights of 9, so that thirds leave small numbers; no polygon is a straight line."""

    def whole(least, most):
        return chance.randint(least, most), chance.randint(least, most)

    def walk(*steps):
        return tuple(zip(*map(accumulate, zip(*steps, strict=True)), strict=True))

    places = accumulate(3 * chance.randint(1, 3) for _ in range(4))
    return {
        "cubic": tuple(zip(places, chance.sample([-3, 0, 3, 9, 12], 4), strict=True)),
        "t": chance.choice([F(1, 3), F(2, 3)]),
        "heights": tuple(chance.sample([0, 9, 18, 27, 36], 4)),
        "at": chance.choice([F(1, 3), F(2, 3)]),
        "parabola": (whole(0, 1), (chance.randint(2, 3), chance.choice([-4, -3, 3, 4])), (4, chance.randint(0, 2))),
        "outside": chance.choice([-1, 2]),
        "first": walk(whole(0, 2), whole(1, 2), (chance.randint(1, 3), chance.randint(-1, 0))),
        "share": chance.choice([F(1, 3), F(1, 4)]),
        "start": whole(0, 2),
        "tangent": walk(whole(2, 4), (chance.randint(1, 3), chance.randint(-2, 2))),
        "touch": chance.choice([F(1, 3), F(2, 3)]),
    }


def _triangle(control_points, at):
    """All new points of a cubic's triangle, level by level."""
    return [row for level in numeric.de_casteljau(control_points, at)[1:] for row in level]


def _triangle_mistakes(data):
    cubic, right = data["cubic"], _triangle(data["cubic"], data["t"])
    return [
        (_triangle(cubic, 1 - data["t"]), "t and 1 - t are exchanged: t is the share of the later point."),
        (_triangle(cubic, F(1, 2)), "You took the middles of the edges: that is another t."),
        ([right[place] for place in (0, 3, 5, 1, 4, 2)], "All right, but listed along the rows: go level by level."),
        ([right[place] for place in (2, 1, 0, 4, 3, 5)], "In each level the order is reversed: b_0^k comes first."),
        ([*cubic, *right], "Leave out the control points: six new ones are asked for."),
        (right[-1:], "This is the point of the curve alone. The points on the way belong to the answer."),
    ]


def _after(data, rounds):
    """The four places after these rounds, each a list of the numbers i in the order in which they come."""
    places, at = list(data["heights"]), data["at"]
    for one in rounds:
        for place in one:
            places[place] = (1 - at) * places[place] + at * places[place + 1]
    return places


def _left_in_places(heights, at):
    """What the loop leaves in its places: the last number of each level, the last level first."""
    return numeric.split(heights, at)[1]


def _program_mistakes(data):
    heights, right = data["heights"], _left_in_places(data["heights"], data["at"])
    return [
        (
            numeric.split(heights, data["at"])[0],
            "These are the first numbers of the levels. All of them stood in b[0], one after the other.",
        ),
        (right[::-1], "The numbers are right and their order is reversed: the result is in b[0]."),
        (_left_in_places(heights, 1 - data["at"]), "t and 1 - t are exchanged: t stands before b[i+1]."),
        (
            _after(data, [range(2, -1, -1), range(1, -1, -1), range(1)]),
            "Your inner loop ran backwards: b[i+1] must still be of the old level when it is used.",
        ),
        (_after(data, [range(3)] * 3), "Your rounds are equally long. The inner loop ends with i = n - r."),
        ((right[0], *heights[1:]), "The result is right. But the other places were written over, too."),
        (_after(data, [range(3)]), "This is one round. There are as many rounds as the degree."),
    ]


def _outside_mistakes(data):
    parabola, place = data["parabola"], data["outside"]
    first, last = numeric.de_casteljau(parabola, place)[1]
    return [
        (numeric.evaluate(parabola, 1 - place), "t and 1 - t are exchanged."),
        (numeric.evaluate(parabola, min(max(place, 0), 1)), "You stopped at the end: nothing is cut off at 0 or 1."),
        (
            abs(numeric.bernstein(2, place)) @ np.array(parabola),
            "A sign was lost: one weight in each step is negative, and the two sum to 1.",
        ),
        (first, "This is b_0^1, on the line of the first edge. Go on: the curve is not straight."),
        (last, "This is b_1^1, on the line of the second edge. Go on: the curve is not straight."),
        ((first + last) / F(2), "You took the middle in the last step. It has the same t again."),
    ]


def _back_mistakes(data):
    first, times = data["first"], 1 / data["share"]
    edge, other = numeric.de_casteljau(first, times)[1]
    return [
        (edge, "This is b_1, from the first edge. Now find b_1^1 in the same way."),
        (other, "This is b_1^1. On which edge does it lie, and in which ratio does it divide it?"),
        (numeric.evaluate(first, 1 / (1 - data["share"])), "t and 1 - t are exchanged: b_0^1 is t of the way to b_1."),
        (
            numeric.evaluate(first, 1 + times),
            "You went 1/t times the part on from its end. The whole edge is 1/t times the part, from its start.",
        ),
        (
            numeric.evaluate(first, data["share"]),
            "You divided the segments once more. The given points are results: go outwards.",
        ),
    ]


def _second_level(found, at):
    return tuple(map(tuple, numeric.de_casteljau(found, at)[2])) if len(found) == 4 else ()


def _touches(data, found):
    return _second_level(found, data["touch"]) == data["tangent"]


DEMANDS = (
    (lambda data, found: len(found) == 4, "A cubic has four control points."),
    (lambda data, found: tuple(found[0]) == data["start"], "The curve does not start where it should."),
    (
        lambda data, found: data["tangent"] != _second_level(found, 1 - data["touch"]) or _touches(data, found),
        "At 1 - t this is as it should be: t and 1 - t are exchanged.",
    ),
    (
        lambda data, found: _second_level(found, data["touch"]) != data["tangent"][::-1],
        "The two points of level 2 are the right ones in the wrong order.",
    ),
    (
        lambda data, found: _second_level(found, data["touch"])[:1] == data["tangent"][:1],
        "b_0^2 is somewhere else. Which three control points are mixed into it?",
    ),
    (
        lambda data, found: _second_level(found, data["touch"])[1:] == data["tangent"][1:],
        "b_1^2 is somewhere else. Which three control points are mixed into it?",
    ),
)


def _with_tangent(data):
    """b_0 and b_1 = b_0^2; then each point of level 2 gives the control point that it is the first to contain."""
    points = [np.array(data["start"]), np.array(data["tangent"][0])]
    one, two, three = numeric.bernstein(2, data["touch"])
    for target in data["tangent"]:
        points.append((np.array(target) - one * points[-2] - two * points[-1]) / three)
    return points


ROUNDS = tidy(factor(Sum(n + 1 - j, (j, 1, k)).doit()))  # round j makes n + 1 - j
EVEN = """sum((j+i) B(i,k,t), i, 0, k)
= j sum(B(i,k,t), i, 0, k) + sum(i B(i,k,t), i, 0, k)
= j + sum(k t B(i-1,k-1,t), i, 1, k)
= j + k t sum(B(i,k-1,t), i, 0, k-1)
= j + k t"""

SET = Set(
    BOOK,
    draw,
    {
        "triangle": asks_value(
            "points",
            lambda data: (
                f"The triangle of the cubic {listed(data['cubic'])} at t = {data['t']}. Its six new points, level by "
                f"level, as a list: b_0^1, b_1^1, b_2^1, b_0^2, b_1^2, b_0^3."
            ),
            lambda data: _triangle(data["cubic"], data["t"]),
            _triangle_mistakes,
            ("Each point is (1 - t) times its left neighbour and t times the next.", "Level 2 from level 1 alone."),
        ),
        "program": asks_value(
            "numbers",
            lambda data: (
                f"In the places {', '.join(f'b[{place}] = {height}' for place, height in enumerate(data['heights']))} "
                f"runs the loop of lesson 05: for r = 1, 2, 3 and then for i = 0, ..., 3 - r: b[i] <- (1-t) b[i] + "
                f"t b[i+1], with t = {data['at']}. Which four numbers stand in b[0], b[1], b[2], b[3] at its end?"
            ),
            lambda data: _left_in_places(data["heights"], data["at"]),
            _program_mistakes,
            (
                "Write down the four places after each round.",
                "Round r stops at i = n - r. When is b[3] written for the last time, and when b[2]?",
            ),
        ),
        "outside": asks_value(
            "point",
            lambda data: f"The point at t = {data['outside']} of the parabola {listed(data['parabola'])}.",
            lambda data: numeric.evaluate(data["parabola"], data["outside"]),
            _outside_mistakes,
            ("The same three interpolations: the formula does not ask where t is.", "What is 1 - t here?"),
        ),
        "back": asks_value(
            "point",
            lambda data: (
                f"Of the triangle of a parabola at t = {data['share']} only the first point of each level is left: "
                f"b_0 = {point(data['first'][0])}, b_0^1 = {point(data['first'][1])}, b_0^2 = "
                f"{point(data['first'][2])}. Where is b_2?"
            ),
            lambda data: numeric.evaluate(data["first"], 1 / data["share"]),
            _back_mistakes,
            (
                "b_0^1 lies on the way from b_0 to b_1. Where is b_1?",
                "b_0^2 lies on the way from b_0^1 to b_1^1: find b_1^1, and then b_2 from b_1 and b_1^1.",
            ),
        ),
        "rounds": asks_formula(
            lambda data: (
                "A curve of degree n >= 1. How many interpolations do the first k rounds make together, 1 <= k <= n? "
                "Write a formula in n and k."
            ),
            lambda data: ROUNDS,
            {n, k},
            {n: (1, oo), k: (1, n)},
            lambda data: [
                (k * n, "The rounds are not equally long: each one makes one interpolation fewer."),
                (n * (n + 1) / 2, "These are all n rounds."),
                (k * (k + 1) / 2, "You counted from the other end: these are the last k rounds."),
                ((n - k) * (n - k + 1) / 2, "This is what is still to be done after k rounds."),
                (
                    k * (2 * n - k) / 2,
                    "This is k times a mean, but not of the first round and of round k: count that one.",
                ),
                (2 * ROUNDS, "You counted multiplications. How many are in one interpolation?"),
                (Sum(n - j, (j, 1, k)), "In each round one is missing. How many does the first round make?"),
                (Sum(n + 1 - j, (j, 0, k)), "Level 0 is given: no interpolation is made for it."),
            ],
            ("n in the first round, then one fewer each time.", "First and last round, their mean, times k."),
        ),
        "share": asks_formula(
            lambda data: (
                "The intermediate point b_j^k, k >= 1, is a mixture of b_j, ..., b_(j+k). Which weight has b_i in it, "
                "for i = j, ..., j+k and 0 < t < 1? Write a formula in i, j, k and t."
            ),
            lambda data: B(i - j, k, t),
            {i, j, k, t},
            {k: (1, oo), j: (0, oo), i: (j, j + k), t: Interval.open(0, 1)},
            lambda data: [
                (B(i, k, t), "This counts the points from b_0 on. Which is the first that b_j^k contains?"),
                (B(i, j + k, t), "This is the weight in b_0^(j+k), which begins at b_0."),
                (B(i - j, k, 1 - t), "t and 1 - t are exchanged."),
                (
                    t ** (i - j) * (1 - t) ** (k - i + j),
                    "This is the weight along one way through the triangle. How many ways are there from b_i?",
                ),
                (B(i - j, k - 1, t), "This is the weight in a point of level k - 1."),
                (B(i + j, k, t), "Test it with i = j: b_j is the first of the points, and not number 2j of them."),
            ],
            (
                "On which curve does b_j^k move?",
                "Number the control points of that curve from 0: which one is b_i?",
            ),
        ),
        "half": asks_truth(
            lambda data: (
                "The algorithm for degree 2n has 2n rounds. True or false, for every n >= 1: the first n of them make "
                "less than three quarters of all the interpolations? If false, give a counterexample."
            ),
            lambda data: Lt(
                Sum(2 * n + 1 - j, (j, 1, n)).doit(), Rational(3, 4) * Sum(2 * n + 1 - j, (j, 1, 2 * n)).doit()
            ),
            {n: (1, oo)},
            ("n = 1: 2 of 3. And n = 2?", "Count what the last n rounds make: more than a quarter?"),
        ),
        "heavier": asks_truth(
            lambda data: (
                "The last step mixes b_0^(n-1) and b_1^(n-1) into p(t). True or false, for all n >= 1, i = 1, ..., n "
                "and t in [0, 1]: the weight of b_i in p(t) is at most its weight in b_1^(n-1), that is, "
                "B(i, n, t) <= B(i-1, n-1, t)? If false, give a counterexample."
            ),
            lambda data: Le(B(i, n, t), B(i - 1, n - 1, t)),
            {n: (1, oo), i: (1, n), t: Interval(0, 1)},
            ("p(t) is a mean of the two. Where may b_i weigh more than in b_1^(n-1)?", "Try n = 2 and i = 1."),
        ),
        "even": asks_derivation(
            lambda data: (
                "The heights are b_i = i. Show that then b_j^k = j + k t for k >= 1: begin with "
                "sum((j+i) B(i,k,t), i, 0, k), end with j + k t, and write at least two lines between."
            ),
            EVEN,
            {i, j, k, t},
            {k: (1, oo), j: (0, oo)},
            least=2,
            hints=(
                "Two sums: one with j, one with i.",
                "i C(k,i) = k C(k-1,i-1), so i B(i,k,t) is a multiple of B(i-1,k-1,t).",
                "What is the sum of all Bernstein functions of one degree?",
            ),
        ),
        "tangent": asks_position(
            lambda data: (
                f"Give four control points of a cubic that starts at {point(data['start'])}, and in whose triangle at "
                f"t = {data['touch']} the points of level 2 are b_0^2 = {point(data['tangent'][0])} and b_1^2 = "
                f"{point(data['tangent'][1])}: this line touches the curve."
            ),
            DEMANDS,
            _with_tangent,
            (
                "There are many. b_1 can be any point.",
                "With b_0, b_1 and b_0^2 you find b_2; go on like that.",
                "b_0^2 = (1-t)^2 b_0 + 2t (1-t) b_1 + t^2 b_2: solve it for b_2.",
            ),
        ),
    },
)
