"""Homework on lesson 11: knots and what they allow, de Boor's algorithm, knots inserted, a span as a Bézier curve."""

from fractions import Fraction as F

import numpy as np
from sympy import Eq, Ge, Interval, Rational, Sum, Symbol, oo, symbols

from bezteach import numeric
from bezteach.examples import EXAMPLES
from bezteach.numeric import bspline
from bezteach.symbolic import i, j, k, n, r, t, text
from bezteach.symbolic.bspline import piece, polar, terms

from ..formulas import is_expanded
from ..kinds import Set, asks_derivation, asks_formula, asks_truth, asks_value, listed

UNIFORM = EXAMPLES["transcript/uniform-knots"].given
BOOK = {
    "breaks": (1, 2, 4),
    "classes": (2, 0, 1),
    "end": 5,
    "hump": (0, 2, 3, 4),
    "cubic": ((0, 0), (0, 4), (4, 8), (8, 0), (12, 8), (12, 0)),
    "knots": tuple(bspline.clamped(6, 3).tolist()),
    "bezier": EXAMPLES["deck/split"].given["points"],
    "over": EXAMPLES["transcript/clamped-knots"].printed["knots"],
    "slope": 2,
    "first": UNIFORM["first"],
    "step": UNIFORM["step"],
}
p = Symbol("p", integer=True, nonnegative=True)
h, s, v, x = symbols("h s v x", real=True)


def draw(chance):
    """Whole knots with steps of 1 to 3, control points in multiples of 4, so that quarters of the edges are whole."""
    breaks, (left, right) = sorted(chance.sample(range(1, 6), 3)), chance.sample(range(1, 4), 2)
    start, step = chance.randint(0, 3), chance.randint(1, 2)
    heights = chance.sample(range(0, 24, 4), 6)
    return {
        "breaks": tuple(breaks),
        "classes": tuple(chance.sample(range(3), 3)),
        "end": breaks[-1] + chance.randint(1, 2),
        "hump": tuple(np.cumsum([0, left, chance.randint(1, 2), right]).tolist()),
        "cubic": tuple((4 * (k + chance.randint(0, 1)), height) for k, height in enumerate(heights)),
        "knots": tuple((start + step * bspline.clamped(6, 3)).tolist()),
        "bezier": tuple((k + chance.randint(0, 1), height) for k, height in enumerate(chance.sample(range(6), 4))),
        "over": (0, 0, 0, *sorted(chance.sample(range(1, 6), 3)), 6, 6, 6),
        "slope": chance.randint(1, 5),
        "first": chance.randint(1, 4),
        "step": chance.randint(2, 4),
    }


def _row(items):
    return ", ".join(map(str, items))


# ---- A list of knots, and how many control points they take


def _list(data, times, ends=4):
    """The knots of a cubic, inner ones as many times as ``times`` says for the class that is wanted there."""
    inner = zip(data["breaks"], data["classes"], strict=True)
    return (0,) * ends + sum(((knot,) * times(smooth) for knot, smooth in inner), ()) + (data["end"],) * ends


def _list_mistakes(data):
    return [
        (_list(data, lambda smooth: smooth + 1), "The other way round: each time more costs one derivative."),
        (
            _list(data, lambda smooth: 4 - smooth),
            "Each inner knot stands once too often: what is sure where it is simple?",
        ),
        (_list(data, lambda smooth: 1), "Each inner knot once: then C2 is sure at each of them."),
        (_list(data, lambda smooth: 3 - smooth, 3), "Inside it is right. Count the ends by the order, not the degree."),
        (_list(data, lambda smooth: 3 - smooth, 1), "Inside it is right. But clamped ends stand more than once."),
    ]


def _count(times, others=p + 1):
    return k * times + others


# ---- The middle piece of a quadratic function


def _hats(data, rise, fall):
    """The two hats on the middle span, each with the line that is 0 at one knot and 1 at another."""
    knots = data["hump"]
    (first,), (second,) = (terms(place, 1, knots, t, 1) for place in (0, 1))
    lines = [(t - knots[start]) / (knots[end] - knots[start]) for start, end in (rise, fall)]
    return lines[0] * first + lines[1] * second


def _hump_mistakes(data):
    parts = terms(0, 2, data["hump"], t, 1)
    others = [piece(0, 2, data["hump"], t, span) for span in (0, 2)]
    return [
        *((part, "This is one of the two terms: two hats live on this span.") for part in parts),
        *((other, "This is the piece of another span.") for other in others),
        (_hats(data, (0, 1), (3, 2)), "Each line goes over both spans of its hat: you let it go over one."),
        (_hats(data, (2, 0), (1, 3)), "Rising and falling are exchanged: the first hat takes the rising line."),
    ]


# ---- De Boor's algorithm, in the middle of the middle span, and the knot before it inserted

SPAN = 4  # of the cubic with six control points, the one between the two inner knots


def _middle(data):
    return F(data["knots"][SPAN] + data["knots"][SPAN + 1], 2)


def _shares(data, at, level=1, length=None):
    """The weights of the later points on a level; each clock runs from t_i over so many knots, 4 - level."""
    knots, length = data["knots"], length or 4 - level
    return [(at - knots[i]) / F(knots[i + length] - knots[i]) for i in range(SPAN - 3 + level, SPAN + 1)]


def _blended(control_points, shares):
    points, shares = (np.array(rows, dtype=object) for rows in (control_points, shares))
    return (1 - shares)[:, None] * points[:-1] + shares[:, None] * points[1:]


def _climbed(control_points, levels):
    for shares in levels:
        control_points = _blended(control_points, shares)
    return control_points[0]


def _point_mistakes(data):
    points, at = data["cubic"], _middle(data)
    shares, too_long = ([_shares(data, at, level, length) for level in (1, 2, 3)] for length in (None, 3))
    exchanged = [[1 - share for share in level] for level in shares]
    second = bspline.de_boor(points, data["knots"], at)[2]
    return [
        (numeric.evaluate(points[1:5], F(1, 2)), "De Casteljau halves each time. Here each pair has its own clock."),
        (_climbed(points[1:5], exchanged), "The weights are exchanged in every step."),
        (
            _climbed(points[1:5], too_long),
            "Level 1 is right. Then the knots of a clock must come nearer to each other.",
        ),
        (_climbed(points[:4], shares), "The right weights on the wrong points: which four belong to this span?"),
        *((point, "This is on the second level: one step is missing.") for point in second),
    ]


def _again(data, place=SPAN):
    return bspline.insert(data["cubic"], data["knots"], data["knots"][place])[0]


def _cut(data, *shares):
    """The corner b_2 replaced by a point on each of its edges."""
    points = data["cubic"]
    return [*points[:2], *_blended(points[1:4], shares), *points[3:]]


def _again_mistakes(data):
    points, right = data["cubic"], _again(data)
    first, second, _ = _shares(data, data["knots"][SPAN])
    return [
        (_cut(data, first, 1 - second), "The weights on one edge are exchanged: from which knot does its clock run?"),
        (_cut(data, F(1, 2), F(1, 2)), "You took the middle of both edges: the two clocks are not alike."),
        ([*points[:2], right[2], points[2], *right[3:]], "An old corner is left: its run is none of the new list."),
        (right[2:4], "These are the new ones. The others belong to the curve, too."),
        (_again(data, SPAN + 1), "This is for the other inner knot."),
    ]


# ---- From the Bézier points of a span to control points


def _values(data, first, last):
    """The blossom of the Bézier curve over [3, 4] at these two runs, and at (2, 3, 4) and (3, 4, 5) between."""
    runs = (first, (2, 3, 4), (3, 4, 5), last)
    return [bspline.blossom(data["bezier"], (3,) * 4 + (4,) * 4, 3, *run) for run in runs]


def _back(data):
    return _values(data, (1, 2, 3), (4, 5, 6))


def _back_mistakes(data):
    forward = bspline.to_bezier(data["bezier"], range(8))[0][0]
    return [
        (
            data["bezier"],
            "These are the Bézier points. Both are the same for the knots 0, 0, 0, 0, 1, 1, 1, 1, but not here.",
        ),
        (forward, "You took the Bézier points for control points, and went from them to Bézier points."),
        (_values(data, (2, 3, 3), (4, 4, 5)), "The ends are f(2, 3, 3) and f(4, 4, 5): one argument more must change."),
        (
            _values(data, (2, 2, 3), (4, 5, 5)),
            "The ends are f(2, 2, 3) and f(4, 5, 5): these are no runs of the knots.",
        ),
        (_back(data)[::-1], "The points are right and their order is reversed."),
    ]


# ---- A parabola as a B-spline


def _parabola(data):
    return x**2 - data["slope"] * x


def _on_runs(data, first=1):
    """Mean and value of the blossom at each two neighbouring knots, from t_first on."""
    runs = [data["over"][place : place + 2] for place in range(first, first + len(data["over"]) - 3)]
    return [(F(sum(run), 2), polar(_parabola(data), 2, x, run)) for run in runs]


def _graph_mistakes(data):
    right, knots, sums = _on_runs(data), data["over"], "The blossom of t is the mean of u and v, not their sum."
    return [
        (
            _on_curve(data, bspline.averages(knots, 2)),
            "All these lie on the parabola. Does a B-spline pass its points?",
        ),
        (_on_curve(data, sorted({*knots})), "These are the points of the curve at the knots."),
        (_on_runs(data, 0), "Your runs begin one knot too early: that of b_i begins with the knot behind t_i."),
        ([(mean, height - data["slope"] * mean) for mean, height in right], sums),
        ([(2 * mean, height) for mean, height in right], sums),
    ]


def _on_curve(data, places):
    return [(place, place**2 - data["slope"] * place) for place in places]


# ---- Statements


def _knot(data, index):
    return data["first"] + data["step"] * index


def _in_the_middle(data):
    middle = (_knot(data, i) + _knot(data, i + p + 1)) * Rational(1, 2)
    return Eq(Sum(_knot(data, j), (j, i + 1, i + p)), p * middle, evaluate=False)


MEANS = """(x+h-v)/h * (x+s)/p + (v-x)/h * (s+x+h)/p
= ((x+h-v)(x+s) + (v-x)(s+x+h))/(h p)
= (h s + h v)/(h p)
= (s+v)/p"""

SET = Set(
    BOOK,
    draw,
    {
        "knots": asks_value(
            "numbers",
            lambda data: (
                f"A cubic B-spline on [0, {data['end']}] has clamped ends and the inner knots {_row(data['breaks'])}. "
                f"The classes that are sure there, and no more, are in this order "
                f"{_row(f'C{smooth}' for smooth in data['classes'])}. The list of all its knots?"
            ),
            lambda data: _list(data, lambda smooth: 3 - smooth),
            _list_mistakes,
            ("What is sure at a knot that stands once? And twice?", "Clamped: as often as the order, degree plus 1."),
        ),
        "count": asks_formula(
            lambda data: (
                "A B-spline of degree p >= 1, clamped at both ends, has k different inner knots. Each of them stands "
                "as often as it may while C^r is still sure there, 0 <= r < p. How many control points has the curve? "
                "Write the number in p, k and r."
            ),
            lambda data: _count(p - r),
            {p, k, r},
            {p: (1, oo), r: (0, p - 1), k: (0, oo)},
            lambda data: [
                (_count(p - r, 2 * (p + 1)), "This is the number of knots."),
                (_count(p - r, p + 2), "Knots minus degree: one is still too many."),
                (_count(p - r, p), "This is n, the last index. How many are they, from b_0 to b_n?"),
                (_count(r), "The multiplicity is not the class. Try r = p - 1: how often may the knot stand?"),
                (_count(p + 1 - r), "Each inner knot stands once too often: C^r is not sure any more."),
                (_count(1), "So it is with simple inner knots. They may stand more often."),
            ],
            ("How often may an inner knot stand?", "Count the knots, and take away the degree and one more."),
        ),
        "piece": asks_formula(
            lambda data: (
                f"The knots are {_row(data['hump'])}. Which polynomial is N_{{0,2}} on its middle span, for "
                f"{data['hump'][1]} <= t < {data['hump'][2]}? Write it in t, multiplied out, such as "
                "1/2 * t^2 - t."
            ),
            lambda data: piece(0, 2, data["hump"], t, 1).expand(),
            {t},
            mistakes=_hump_mistakes,
            hints=(
                "Two hats live on this span: one falls, the other rises.",
                "The first hat times the line that rises over both of its spans, plus the second times the line that "
                "falls over its own two.",
            ),
            form=("multiplied out", is_expanded),
        ),
        "de-boor": asks_value(
            "point",
            lambda data: (
                f"The cubic B-spline {listed(data['cubic'])} on the knots {_row(data['knots'])}. Its point at "
                f"t = {_middle(data)}?"
            ),
            lambda data: bspline.evaluate(data["cubic"], data["knots"], _middle(data)),
            _point_mistakes,
            (
                "Which four control points belong to this span? Three levels lead from them to the point.",
                "Level 1: b_(i-1) and b_i have a clock that runs from t_i to t_(i+3).",
                "Level 2 has clocks from t_i to t_(i+2), level 3 the one of the span.",
            ),
        ),
        "again": asks_value(
            "points",
            lambda data: (
                f"The cubic B-spline {listed(data['cubic'])} on the knots {_row(data['knots'])}. The knot "
                f"{data['knots'][SPAN]} is inserted once more, and the curve stays as it is. All seven control points?"
            ),
            _again,
            _again_mistakes,
            (
                "Write the runs of three knots, of the old list and of the new one. Which ones are new?",
                "One control point goes, and two come, each on an edge.",
                "f is affine in each argument: between which two knots is the new one, and where?",
            ),
        ),
        "back": asks_value(
            "points",
            lambda data: (
                f"The knots of a cubic B-spline are 0, 1, 2, 3, 4, 5, 6, 7. Its span over [3, 4] has the Bézier points "
                f"{listed(data['bezier'], 'c')}. The four control points b_0, ..., b_3?"
            ),
            _back,
            _back_mistakes,
            (
                "Which values of the blossom are the Bézier points, and which are the control points?",
                "f(3, 4, u) is known for u = 3 and u = 4: go on along this line to u = 2 and to u = 5.",
                "For b_0 first find f(2, 3, 3), then go along f(2, 3, u).",
            ),
        ),
        "graph": asks_value(
            "points",
            lambda data: (
                f"The parabola y = {text(_parabola(data))} from x = 0 to x = {data['over'][-1]} is a quadratic "
                f"B-spline, with x(t) = t, on the knots {_row(data['over'])}. All its control points?"
            ),
            _on_runs,
            _graph_mistakes,
            (
                "A control point is the value of the blossom at its run, here of two knots; for each coordinate apart.",
                "The blossom of x = t is (u + v)/2, and that of t^2 is u v.",
            ),
        ),
        "middle": asks_truth(
            lambda data: (
                f"The mean of the run of b_i is called its Greville abscissa. The knots are t_j = "
                f"{text(_knot(data, j))}. True or false, for all p >= 1 and i >= 0: this mean is the middle of the "
                f"support of N_{{i,p}}, that is, sum({text(_knot(data, j))}, j, i+1, i+p) = p (t_i + t_(i+p+1))/2? "
                "If false, give a counterexample, p and i."
            ),
            _in_the_middle,
            {p: (1, oo), i: (0, oo)},
            (
                "Try p = 1 and p = 2.",
                "Add the first and the last knot of the run, then the second and the last but one.",
            ),
        ),
        "reach": asks_truth(
            lambda data: (
                "A clamped B-spline of degree p with the control points b_0, ..., b_n and simple inner knots has "
                "n-p+1 spans, and on each p+1 control points count. So a control point moves (p+1)(n-p+1)/(n+1) "
                "spans on average. True or false, for all p >= 1 and n >= p: this average is at least (p+1)/2? If "
                "false, give a counterexample, p and n."
            ),
            lambda data: Ge((p + 1) * (n - p + 1) / (n + 1), (p + 1) * Rational(1, 2)),
            {p: (1, oo), n: (p, oo)},
            ("A long curve has many spans. And the shortest one?", "How many spans has a Bézier curve?"),
        ),
        "means": asks_derivation(
            lambda data: (
                "The runs of two neighbouring control points have p - 1 knots in common, with the sum s; one run "
                "begins with x, the other ends with x + h, h > 0. The means of the runs are (x+s)/p and (s+x+h)/p. The "
                "knot v is inserted; the new point between the two has the weights (x+h-v)/h and (v-x)/h. Show that "
                "these weights make of the two means the mean of the new run: from "
                "(x+h-v)/h * (x+s)/p + (v-x)/h * (s+x+h)/p to (s+v)/p, with at least one line between. Write h*p for a "
                "product of letters."
            ),
            MEANS,
            {h, p, s, v, x},
            {p: (1, oo), h: Interval.open(0, oo)},
            hints=("One denominator for both.", "Multiply out: what cancels, and what has the factor h?"),
        ),
    },
)
