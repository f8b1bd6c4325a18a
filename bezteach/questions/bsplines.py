"""The questions of the lesson on B-splines, asked before the answers; a quadratic and a cubic with clamped knots."""

from fractions import Fraction as F

from ..numeric import bspline
from .asking import Choice, Entry

KNOTS = tuple(bspline.clamped(6, 2).tolist())  # the transcript's
QUADRATIC = ((0, 0), (0, 4), (4, 6), (8, 2), (12, 4), (12, 0))
CUBIC_KNOTS = tuple(bspline.clamped(7, 3).tolist())
CUBIC = ((0, 0), (0, 6), (6, 6), (6, 0), (12, 0), (12, 6), (18, 6))
DATA = ((0, 0), (2, 5), (6, 6), (8, -1), (12, 0), (14, 5), (18, 6), (20, 1), (24, 2))


def one_function(knots, t):
    """The value at t of the one B-spline over all the knots."""
    (value,) = bspline.basis(knots, len(knots) - 2, t)
    return value


def _between(start, end, w):
    return tuple((1 - w) * x + w * y for x, y in zip(start, end, strict=True))


def _step():
    """The first point of de Boor's level 1 at t = 3/2, by wrong weights."""
    before, after = QUADRATIC[1], QUADRATIC[2]
    return [
        (_between(before, after, F(1, 2)), "You measured t in its own span. b₁ and b₂ differ in the knots 0 and 2."),
        (_between(before, after, F(1, 4)), "The weights are exchanged: is t nearer to 0 or to 2?"),
        (_between(before, after, F(3, 2)), "This leaves the edge. Divide the way of t by the way between the knots."),
        (_between(QUADRATIC[2], QUADRATIC[3], F(1, 4)), "This is the second new point, between b₂ and b₃."),
    ]


QUESTIONS = {
    "bsplines/before-global": Choice(
        "A Bézier curve of degree 5: b₂ is moved. Which points of the curve stay where they are?",
        {
            "those far away from b₂": "Their way is short, but it is not zero: when is B₂,₅(t) = 0?",
            "the two ends only": "Yes: B₂,₅(t) is zero at t = 0 and t = 1, and positive between.",
            "none": "Does the end b₅ depend on b₂?",
        },
        "the two ends only",
    ),
    "bsplines/before-between": Entry(
        "A point runs evenly along a straight line. At t = 1 it is in (2, 0), at t = 3 in (6, 4). Where at t = 3/2?",
        lambda: _between((2, 0), (6, 4), F(1, 4)),
        lambda: [
            (_between((2, 0), (6, 4), F(3, 4)), "The weights are exchanged: t = 3/2 is nearer to the start."),
            (_between((2, 0), (6, 4), F(1, 2)), "That is the middle. When is it there?"),
            (_between((2, 0), (6, 4), F(3, 2)), "You took t itself. Which part of the time from 1 to 3 is over?"),
        ],
        "(1, 2)",
    ),
    "bsplines/before-clock": Choice(
        "Two curves of degree 2 meet with C1. The left one takes the time 1, the right one the time 2. The edges at "
        "the join are as",
        {
            "1 : 1": "Equal edges belong to equal times.",
            "1 : 2": "Yes: the edges are as the intervals.",
            "2 : 1": "Twice the time at the same speed: which edge is longer?",
        },
        "1 : 2",
    ),
    "bsplines/how-much": Choice(
        "The board above: four spans, and b₂ is dragged. How many of the spans will move? Answer, then drag.",
        {
            "all four": "So it is with one Bézier curve. Drag b₂ and look at the right end.",
            "three": "Yes: one more than the degree. The last span does not feel it.",
            "the nearest one": "Drag it, and compare the curve on the left and on the right of it.",
        },
        "three",
    ),
    "bsplines/hat": Entry(
        "The knots 0, 1, 3. The hat of degree 1 over them rises from t = 0 to 1 and falls from 1 to 3. Its value at 2?",
        lambda: one_function((0, 1, 3), 2),
        lambda: [
            (F(2, 3), "You divided by the whole support. The hat falls on its second span only: how long is that?"),
            (2, "This is the rising line, prolonged. At t = 2 the hat falls."),
            (F(1, 3), "Take the way to the end, divided by the length of the second span."),
        ],
        "2/5",
    ),
    "bsplines/quadratic-value": Entry(
        "N₀,₂(3/2) on the knots 0, 1, 2, 3, by the recursion from the two hats?",
        lambda: one_function(range(4), F(3, 2)),
        lambda: [
            (F(3, 8), "This is one of the two terms."),
            (F(1, 2), "This is the value of each hat there. What stands before them?"),
            (1, "The factors before the hats do not add up to one here; they belong to different functions."),
            (F(9, 8), "You kept the first factor alone and prolonged its hat. The first hat falls at 3/2."),
        ],
        "2/5",
    ),
    "bsplines/how-many-knots": Entry(
        "A curve of degree 3 with 7 control points: how many knots?",
        lambda: F(len(CUBIC_KNOTS)),
        lambda: [
            (10, "Points and degree alone. Count for one function of degree 0: how many knots does a span have?"),
            (7, "One for each point? Even one function of degree 0 has a span with two ends."),
            (8, "So it is for degree 0. Each degree more makes the supports one span longer."),
            (12, "Did you add the order, and one more? The order is already the degree plus 1."),
        ],
        "3",
    ),
    "bsplines/sum-outside": Entry(
        "Degree 2, knots 0, 1, 2, 3, 4, 5, three functions. What is their sum at t = 3/2?",
        lambda: bspline.basis(range(6), 2, F(3, 2)).sum(),
        lambda: [
            (1, "Three functions must meet for that. Which of them have begun at 3/2?"),
            (F(3, 4), "This is the first function alone. The second one begins at 1."),
            (F(1, 8), "This is the second function alone."),
        ],
        "2/5",
    ),
    "bsplines/domain": Choice(
        "Six control points, degree 2, knots 0, 1, ..., 8. For which t is there a curve?",
        {
            "0 ≤ t ≤ 8": "At t = 1/2 only one function is above 0: the sum is not 1 there.",
            "2 ≤ t ≤ 6": "Yes: from t_p to t_{n+1}, where three functions meet everywhere.",
            "2 ≤ t ≤ 7": "n is 5, the last index, not the number of points.",
            "0 ≤ t ≤ 6": "Cut off as much on the left as on the right.",
        },
        "2 ≤ t ≤ 6",
    ),
    "bsplines/passes": Choice(
        "The quadratic of the first board. Through which of its six control points does it pass?",
        {
            "through all six": "Look at b₂: the curve turns below it.",
            "through b₀ and b₅ only": "Yes. At the inner knots it touches edges, and passes no corner of the polygon.",
            "through none": "Where does it begin?",
            "through one for each knot": "The squares are the places at the knots. Is a control point there?",
        },
        "through b₀ and b₅ only",
    ),
    "bsplines/where-is-a-knot": Choice(
        "In the picture with the clamped knots: where is the knot t₄ = 2?",
        {
            "in the control point b₄": "Then each knot had a control point. Count both.",
            "at the place (2, 0)": "A knot is one number. A place in the plane needs two.",
            "nowhere: it is a time, when one span ends and the next begins": "Yes. The picture shows where the curve "
            "is at that time.",
        },
        "nowhere: it is a time, when one span ends and the next begins",
    ),
    "bsplines/step": Entry(
        "t = 3/2. The first new point, between b₁ = (0, 4) and b₂ = (4, 6)?",
        lambda: bspline.de_boor(QUADRATIC, KNOTS, F(3, 2))[1][0],
        _step,
        "(1, 2)",
    ),
    "bsplines/value-at-a-knot": Entry(
        "b₁ = f(0, 1) = (0, 4) and b₂ = f(1, 2) = (4, 6). What is f(1, 1)?",
        lambda: bspline.blossom(QUADRATIC, KNOTS, 3, 1, 1),
        lambda: [
            ((0, 4), "This is f(0, 1). One of its arguments must go from 0 to 1."),
            ((4, 6), "This is f(1, 2)."),
            ((1, F(9, 2)), "One argument runs from 0 to 2. Which part of the way is 1?"),
            ((4, 10), "You added both. f is affine in each argument: take a mean."),
        ],
        "(1, 2)",
    ),
    "bsplines/how-many-new": Choice(
        "A cubic B-spline with 7 control points. The new knot 3/2 is inserted. What happens to the points?",
        {
            "1 new one, the 7 others stay": "Which p + 1 points does the span of 3/2 depend on? Some of them must go.",
            "3 new ones in the place of 2 old ones": "Yes: the points of de Boor's first level.",
            "all 8 are new": "Far from 3/2 no run of three knots has changed.",
        },
        "3 new ones in the place of 2 old ones",
    ),
    "bsplines/second-piece": Entry(
        "The quadratic of the first board: the three Bézier points of its span from t = 1 to t = 2?",
        lambda: bspline.to_bezier(QUADRATIC, KNOTS)[0][1],
        lambda: [
            (QUADRATIC[1:4], "These are the control points of the span. Where does the curve start at t = 1?"),
            (bspline.to_bezier(QUADRATIC, KNOTS)[0][2], "This is the next span, from 2 to 3."),
            (bspline.to_bezier(QUADRATIC, KNOTS)[0][1][::-1], "The right points, last one first."),
        ],
        "(0, 4) (1, 2) (8, 2)",
    ),
    "bsplines/raise": Choice(
        "A cubic B-spline. One of its simple inner knots becomes double. What is sure there now?",
        {
            "C3: more knots, smoother": "Each knot more is one condition less. What is sure at a simple knot?",
            "C2": "This is what was sure before.",
            "C1": "Yes: one derivative less for each time more.",
            "C0": "For that it must stand three times.",
        },
        "C1",
    ),
    "bsplines/insert-a-corner": Choice(
        "A quadratic. The knot 1 is inserted once more, so that it is double. Will there be a corner?",
        {
            "yes: C0 is all that is sure": "What is sure is the least. What does inserting do to the curve?",
            "no: the curve is as it was": "Yes. A corner is allowed now; nobody has made one yet.",
            "only if t = 1 is a break": "A corner is a jump of the direction. Did anything move?",
        },
        "no: the curve is as it was",
    ),
    "bsplines/both": Choice(
        "Which of the four is local and C2 at once?",
        {
            "the one-sixth rule": "Local it is. Lesson 10: what jumps at its data points?",
            "the natural spline": "C2 it is. How far does a change go?",
            "the B-spline": "Yes. Its price is another: look for the points that it passes.",
            "none": "Count what moves in the fourth picture, and recall what is sure at a simple knot of a cubic.",
        },
        "the B-spline",
    ),
}
