"""Homework on lesson 09: one curve written with a higher degree, and with a lower one where this is possible."""

from fractions import Fraction as F
from itertools import accumulate
from math import comb

import numpy as np
from sympy import Eq, Interval, Le, Sum, binomial, oo

from bezteach import numeric
from bezteach.display import point
from bezteach.examples import EXAMPLES
from bezteach.symbolic import B, b, i, j, n, r, t

from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value, listed

BOOK = {
    "cubic": EXAMPLES["deck/split"].given["points"],
    "parabola": EXAMPLES["games/quadratic"].given["points"],
    "lower": ((0, 0), (0, 4), (6, 6), (10, 2)),  # asked for: the question prints it with degree 4
    "heights": (3, 6, 2),
    "quartic": (0, F(1, 4), F(1, 2), F(1, 4), 0),  # deck, 1.2, note on the convexity theorem, for w = 1/2
    "from": (0, 0),
    "to": (6, 3),
}


def draw(chance):
    """Small whole points, no arch of them flat; what is asked for going down has whole points with degree 4, too."""
    start, way = chance.randint(0, 2), (chance.randint(1, 3), chance.randint(-2, 2))
    wide = [chance.randint(1, 2) * size for size in (4, 2, 4)]
    high = [4 * chance.randint(1, 2), 2 * chance.randint(0, 1), -4 * chance.randint(0, 1)]

    def places(heights):
        return tuple((3 * k + chance.randint(-1, 1), height) for k, height in enumerate(heights))

    return {
        "cubic": places(chance.sample(range(6), 4)),
        "parabola": places([chance.randint(0, 2), chance.randint(4, 6), chance.randint(0, 3)]),
        "lower": tuple(zip(accumulate([0, *wide]), accumulate([start, *high]), strict=True)),
        "heights": (*chance.sample([3, 6, 9], 2), chance.choice([1, 2, 4, 5])),
        "quartic": tuple(chance.randint(0, 4) for _ in range(5)),
        "from": (start, 0),
        "to": (start + 3 * way[0], 3 * way[1]),
    }


def _on_edges(control_points, shares):
    """The ends and a point on each edge, ``shares`` of the points before."""
    vertices = np.array(control_points, dtype=object)
    shares = np.array(shares, dtype=object)[:, None]
    return [vertices[0], *(shares * vertices[:-1] + (1 - shares) * vertices[1:]), vertices[-1]]


def _elevated_mistakes(data):
    cubic, right = data["cubic"], numeric.elevate(data["cubic"])
    return [
        (
            _on_edges(cubic, [F(k, 4) for k in (3, 2, 1)]),
            "The weights are exchanged: i/(n + 1) belongs to the point before, b_(i-1).",
        ),
        (_on_edges(cubic, [F(1, 4)] * 3), "You used the ratio of the first edge on all of them: i grows by 1."),
        (_on_edges(cubic, [F(1, 2)] * 3), "You took the middles of the edges: the ratio changes from edge to edge."),
        (_on_edges(cubic, [F(k, 3) for k in (1, 2, 3)]), "You divided by the old degree: divide by n + 1."),
        (right[1:-1], "These are the inner points: the ends belong to the answer, too."),
    ]


def _twice_mistakes(data):
    once = numeric.elevate(data["parabola"])
    return [
        (once, "This is degree 3: one more step."),
        (
            _on_edges(once, [F(k, 3) for k in (1, 2, 3)]),
            "The second step has other denominators than the first: n is 3 by then.",
        ),
        (
            _on_edges(once, [F(1, 2)] * 3),
            "The first step is right. In the second one you took the middles of the edges.",
        ),
        (_on_edges(once, [F(k, 4) for k in (3, 2, 1)]), "In the second step the weights are exchanged."),
    ]


def _raised(data):
    return numeric.elevate(data["lower"])


def _back_mistakes(data):
    c0, c1, _, c3, c4 = raised = _raised(data)
    half = F(1, 2)
    return [
        (
            [c0, c1 + half * (c1 - c0), c3 + half * (c3 - c4), c4],
            "You prolonged the end edges by half of their length: that is the way from degree 3 to degree 2.",
        ),
        ([c0, c1, c3, c4], "You left the middle point out. But the other inner points do not stay where they are."),
        (numeric.elevate(raised), "This is one degree higher: you have gone up instead of down."),
        (data["lower"][::-1], "The points are right and their order is reversed."),
    ]


def _times_t(data):
    return numeric.from_power([0, *numeric.to_power(data["heights"])])


def _times_t_mistakes(data):
    h0, h1, h2 = heights = data["heights"]
    return [
        ((0, h0, h1, h2), "The heights have moved one place up, and that is right; a factor is missing before each."),
        ((h0, F(2, 3) * h1, F(1, 3) * h2, 0), "This is (1 - t) p(t)."),
        ((0, h0, F(2, 3) * h1, F(1, 3) * h2), "The factors are there, the other way round: count i up from 0."),
        (numeric.elevate(heights), "This is p(t) itself with degree 3: the factor t is missing."),
        ((0, F(1, 4) * h0, F(2, 4) * h1, F(3, 4) * h2), "Compare the degrees: the new one is 3, not 4."),
    ]


def _difference(heights, sign=-1):
    return sum(sign**k * comb(len(heights) - 1, k) * height for k, height in enumerate(heights))


def _loss(data):
    heights = np.array(data["quartic"], dtype=object)
    return abs((heights - numeric.elevate(numeric.lower(heights)))[0])


def _loss_mistakes(data):
    top = abs(_difference(data["quartic"]))
    return [
        (F(top), "This is the error at t = 1 if the term with t^4 is dropped. The nearest cubic does much better."),
        (F(top, 20), "20 belongs to a cubic that becomes a parabola. Which number stands in its place?"),
        (F(top, 16), "You divided by the sum of the binomials. Each of them has to be squared."),
        (F(_difference(data["quartic"], 1), 70), "The signs in the fourth difference alternate."),
        (-_loss(data), "An error is a distance here: it is not negative."),
    ]


def _third_difference(found):
    return found[3] - 3 * found[2] + 3 * found[1] - found[0]


DEMANDS = (
    (lambda data, found: len(found) == 4, "A cubic has four control points."),
    (
        lambda data, found: tuple(found[0]) == data["from"] and tuple(found[-1]) == data["to"],
        "The ends are not both where they should be.",
    ),
    (
        lambda data, found: len(found) > 1 and found[1][0] == found[0][0] and found[1][1] > found[0][1],
        "At the start the curve does not go straight up. Which edge decides that?",
    ),
    (
        lambda data, found: len(found) == 4 and not _third_difference(found).any(),
        "This is a true cubic: its third difference is not 0.",
    ),
)
WEIGHT = binomial(n, i) * binomial(2, j - i) / binomial(n + 2, j)  # of b_i in c_j, degree n + 2
LINES = (
    t * (1 - t) * B(i, n, t),
    t * (n + 1 - i) / (n + 1) * B(i, n + 1, t),
    (i + 1) * (n + 1 - i) / ((n + 1) * (n + 2)) * B(i + 1, n + 2, t),
)
FIRST = (r * b[0] + n * b[1]) / (n + r)

SET = Set(
    BOOK,
    draw,
    {
        "elevated": asks_value(
            "points",
            lambda data: f"The cubic {listed(data['cubic'])} is written with degree 4. All five control points?",
            lambda data: numeric.elevate(data["cubic"]),
            _elevated_mistakes,
            ("The ends stay, and on every edge there is one new point.", "c_i = i/4 b_(i-1) + (1 - i/4) b_i."),
        ),
        "twice": asks_value(
            "points",
            lambda data: f"The parabola {listed(data['parabola'])} is written with degree 4. All five control points?",
            lambda data: numeric.elevate(data["parabola"], 2),
            _twice_mistakes,
            ("Two steps, one after the other.", "The first step divides by 3, the second one by 4."),
        ),
        "back": asks_value(
            "points",
            lambda data: (
                f"The curve {listed(_raised(data), 'c')}, written with degree 4, is in truth a cubic. "
                f"Its four control points?"
            ),
            lambda data: numeric.lower(_raised(data)),
            _back_mistakes,
            (
                "Which point of the cubic's first edge is c_1?",
                "c_1 = 1/4 b_0 + 3/4 b_1, and b_0 = c_0: solve for b_1. From the other end likewise.",
            ),
        ),
        "times-t": asks_value(
            "numbers",
            lambda data: (
                f"p(t) has degree 2 and the control heights {listed(data['heights'])}. Give the four control heights "
                f"of t p(t), written with degree 3, as a list of numbers."
            ),
            _times_t,
            _times_t_mistakes,
            (
                "Multiply each term b_i B(i, 2, t) by t. Which function of degree 3 is it a multiple of?",
                "The second of the three elevation formulas: t B(i, n, t) = (i+1)/(n+1) B(i+1, n+1, t).",
            ),
        ),
        "loss": asks_value(
            "number",
            lambda data: (
                f"A function of degree 4 has the control heights {listed(data['quartic'])}. The nearest function of "
                f"degree 3 (least squares) is taken in its place. How large is the error where it is largest on [0, 1]?"
            ),
            _loss,
            _loss_mistakes,
            (
                "The error is a multiple of Legendre's polynomial of degree 4.",
                "Its control heights are 1, -4, 6, -4, 1. On [0, 1] it is largest at the ends, and 1 there.",
                "Divide the fourth difference by the sum of the squares of these numbers.",
            ),
        ),
        "first": asks_formula(
            lambda data: (
                "A curve of degree n >= 1 with the points b_0, ..., b_n is written with degree n + r, r >= 1. Write "
                "the new point c_1 in n, r, b_0 and b_1."
            ),
            lambda data: FIRST,
            {n, r, b},
            {n: (1, oo), r: (1, oo)},
            lambda data: [
                (
                    (n * b[0] + r * b[1]) / (n + r),
                    "The weights are exchanged. In a cubic's first step, is c_1 nearer to b_0 or to b_1?",
                ),
                ((b[0] + n * b[1]) / (n + 1), "This is right for r = 1: the other steps move c_1 again."),
                ((b[0] + (n + r - 1) * b[1]) / (n + r), "This is the last step alone, as if b_1 had stayed till then."),
            ],
            (
                "Follow the share of b_1 in c_1 over the first two steps.",
                "It is n/(n+1) after the first step and is multiplied by (n+1)/(n+2) in the second. Go on.",
            ),
        ),
        "share": asks_truth(
            lambda data: (
                "The degree is raised by 2 at once. The old point b_i then has the weight C(n,i) C(2,j-i)/C(n+2,j) in "
                "the new point c_j, for j = i, i+1, i+2. True or false, for all n >= 0 and i = 0, ..., n: whichever "
                "point it is, its three weights sum to (n+3)/(n+1)? If false, give a counterexample."
            ),
            lambda data: Eq(Sum(WEIGHT, (j, i, i + 2)), (n + 3) / (n + 1), evaluate=False),
            {n: (0, oo), i: (0, n)},
            ("Raise the degree by 1 first: in which two points does b_i occur?", "Add up its two shares: does i stay?"),
        ),
        "smaller": asks_truth(
            lambda data: (
                "Of a higher degree there are more functions, and their sum is 1 as before. True or false, for all "
                "n >= 0, i = 0, ..., n and t in [0, 1]: B(i, n+1, t) <= B(i, n, t)? If false, give a counterexample."
            ),
            lambda data: Le(B(i, n + 1, t), B(i, n, t)),
            {n: (0, oo), i: (0, n), t: Interval(0, 1)},
            ("Draw the functions of degree 1 and 2.", "Near t = 0, compare t with 2t (1 - t)."),
        ),
        "product": asks_derivation(
            lambda data: (
                "Both factors at once: begin with t (1-t) B(i,n,t), end with "
                "(i+1)*(n+1-i)/((n+1)*(n+2)) * B(i+1,n+2,t), and write at least one line between."
            ),
            LINES,
            {i, n, t},
            {n: (0, oo), i: (0, n)},
            hints=(
                "One factor after the other.",
                "The first elevation formula for (1-t) B(i,n,t); then the second one, and mind that n has grown.",
            ),
        ),
        "disguise": asks_position(
            lambda data: (
                f"Give four control points of a cubic that is in truth a parabola. It runs from {point(data['from'])} "
                f"to {point(data['to'])}, and at its start it goes straight up (as y grows)."
            ),
            DEMANDS,
            lambda data: numeric.elevate([data["from"], (data["from"][0], data["from"][1] + 3), data["to"]]),
            (
                "Choose the parabola first: three points. Where is its middle one?",
                "Then write it with degree 3.",
            ),
        ),
    },
)
