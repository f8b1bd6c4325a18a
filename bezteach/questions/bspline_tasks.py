"""The exercises of the lesson on B-splines that are answered in a cell, and the tasks of its boards."""

from collections import Counter
from fractions import Fraction as F

import numpy as np

from ..numeric import bspline
from .asking import Choice, Entry, Goal
from .bsplines import CUBIC, CUBIC_KNOTS, KNOTS, QUADRATIC, one_function

UNEVEN = (0, 0, 0, 0, 1, 2, 2, 5, 5, 5, 5)  # degree 3
CUT = F(5, 2)
EDGE_AT = (5, 5)  # a quarter of the way from b_2 to b_3


def _new_ones():
    """The points that the knot 5/2 brings."""
    return bspline.insert(QUADRATIC, KNOTS, CUT)[0][3:5]


def _support(i, degree):
    return (F(UNEVEN[i]), F(UNEVEN[i + degree + 1]))


QUESTIONS = {
    "bsplines/exercise-count": Entry(
        "Exercise 1. The knots 0, 0, 0, 0, 1, 2, 2, 5, 5, 5, 5 and degree 3. How many control points belong to them?",
        lambda: F(len(UNEVEN) - 3 - 1),
        lambda: [
            (8, "Knots minus degree: one is still too many."),
            (11, "This is the number of knots."),
            (4, "These are the points of one span. All of the points are asked."),
            (6, "Did you take the order twice? Knots, minus degree, minus 1."),
        ],
        "3",
    ),
    "bsplines/exercise-class": Choice(
        "Exercise 2. The same knots: what is sure at t = 2?",
        {
            "C3": "That is so inside of a span.",
            "C2": "That is so at t = 1, where one knot stands.",
            "C1": "Yes: degree 3, and the knot stands twice.",
            "a corner": "C0 is not even near: how many times does it stand? And a corner is never sure.",
        },
        "C1",
    ),
    "bsplines/exercise-support": Entry(
        "Exercise 3. The same knots: b₅ is moved. From which t to which t does the curve change?",
        lambda: _support(5, 3),
        lambda: [
            (_support(4, 3), "This is the support of N₄,₃. Count the knots from index 0."),
            ((2, 4), "There is no knot 4. The support ends in a knot."),
            (_support(3, 3), "This is the support of N₃,₃: it begins with t₃."),
        ],
        "0, 3",
    ),
    "bsplines/exercise-value": Entry(
        "Exercise 4. N₀,₂(2) on the knots 0, 1, 3, 4?",
        lambda: one_function((0, 1, 3, 4), 2),
        lambda: [
            (F(1, 3), "This is one of the two terms."),
            (F(1, 2), "This is the value of the hats. Their factors are longer ways: from 0 to 3, and from 1 to 4."),
            (F(3, 4), "So it is in the middle of equal spans. Here the middle one has length 2."),
            (1, "Two hats with 1/2 each; but before each of them stands a factor."),
        ],
        "2/5",
    ),
    "bsplines/exercise-point": Entry(
        "Exercise 5. The quadratic (0, 0) (0, 4) (4, 6) (8, 2) (12, 4) (12, 0), knots 0, 0, 0, 1, 2, 3, 4, 4, 4. "
        "Its point at t = 5/2, by de Boor's algorithm:",
        lambda: bspline.evaluate(QUADRATIC, KNOTS, CUT),
        lambda: [
            ((8, 2), "This is the control point b₃. Does the curve pass through it?"),
            (bspline.evaluate(QUADRATIC, KNOTS, F(3, 2)), "This is the point at 3/2, in another span."),
            (
                bspline.evaluate(QUADRATIC[2:5], (0, 0, 0, 1, 1, 1), F(1, 2)),
                "De Casteljau with the ratio 1/2 in all steps. The first level has longer ways between its knots.",
            ),
            (_new_ones()[0], "This is a point of the first level. One step more."),
        ],
        "(1, 2)",
    ),
    "bsplines/exercise-insert": Entry(
        "Exercise 6. The knot 5/2 is inserted into the curve of exercise 5. The two new control points, in order:",
        _new_ones,
        lambda: [
            (_new_ones()[::-1], "The right points, the second one first."),
            ([QUADRATIC[2], QUADRATIC[3]], "These are old ones. The new ones are on the edges."),
            (
                [(6, 4), (10, 3)],
                "These are the middles of the edges: the points for the knots 2 and 3. For 5/2 they lie elsewhere.",
            ),
        ],
        "(1, 2) (2, 1)",
    ),
    "bsplines/exercise-piece": Entry(
        "Exercise 7. The three Bézier points of the same curve from t = 3 to t = 4:",
        lambda: bspline.to_bezier(QUADRATIC, KNOTS)[0][3],
        lambda: [
            (QUADRATIC[3:], "These are the control points of the span. At t = 3 the curve is on an edge."),
            (bspline.to_bezier(QUADRATIC, KNOTS)[0][2], "This is the span before."),
            (bspline.to_bezier(QUADRATIC, KNOTS)[0][3][::-1], "The right points, last one first."),
        ],
        "(0, 4) (1, 2) (8, 2)",
    ),
}


def _fits(state, points, knots):
    """Whether there are as many control points and knots as these."""
    return state.knots is not None and len(state.points) == len(points) and len(state.knots) == len(knots)


def _untouched(state, points, knots):
    """Whether the control points are these, and the knots as many as these, wherever they are."""
    return _fits(state, points, knots) and state.points == points


def _two_spans_move(state):
    if not _fits(state, QUADRATIC, KNOTS) or state.knots != KNOTS:
        return False
    moved = sum(now != then for now, then in zip(state.points, QUADRATIC, strict=True))
    pieces, starts = (bspline.to_bezier(points, KNOTS)[0] for points in (state.points, QUADRATIC))
    return moved == 1 and int((pieces != starts).any(axis=(1, 2)).sum()) == 2


def _touches_a_quarter(state):
    if not _untouched(state, QUADRATIC, KNOTS):
        return False
    at = bspline.evaluate(state.points, state.knots, state.knots[4])
    return tuple(at) == EDGE_AT


def _has_a_corner(state):
    """A double knot inside: no three control points in a row are collinear here."""
    if not _untouched(state, QUADRATIC, KNOTS):
        return False
    inside = [knot for knot in state.knots if state.knots[2] < knot < state.knots[6]]
    return max(Counter(inside).values(), default=0) == 2


def _passes_b3(state):
    return _untouched(state, CUBIC, CUBIC_KNOTS) and state.knots[4] == state.knots[6]


def _inserted_until_through(state):
    if state.knots is None:
        return False
    points, knots = bspline.insert(CUBIC, CUBIC_KNOTS, 2, 2)
    return state.knots == tuple(knots) and np.array_equal(np.array(state.points, dtype=object), points)


GOALS = {
    "bsplines/two-spans": Goal(
        "Task: move one control point, and no knot, so that exactly two of the four spans move.",
        _two_spans_move,
        "Reached: a function over two of the spans. Is there another such point?",
    ),
    "bsplines/quarter": Goal(
        "Task: move no control point. Move knots, so that the curve touches the edge b₂ b₃ in (5, 5), a quarter of the "
        "way from b₂.",
        _touches_a_quarter,
        "Reached: the edge is divided as the knots divide the time. Is there another knot that could do it?",
    ),
    "bsplines/corner": Goal(
        "Task: make a sharp corner by knots alone. Move knots; no control point may move, none may be added.",
        _has_a_corner,
        "Reached: two knots together, and the curve turns in a control point. In which one?",
    ),
    "bsplines/through": Goal(
        "Task: the degree is 3. Move knots, and no control point, until the curve passes through b₃ = (6, 0).",
        _passes_b3,
        "Reached: all three knots of the run of b₃ are one. Two were not enough.",
    ),
    "bsplines/insert": Goal(
        "Task: the degree is 3. Insert the knot 2 again, by a click on it or by the key +, until the curve passes "
        "through a control point.",
        _inserted_until_through,
        "Reached: the knot stands three times, and the curve is the same as before. Which control point is it?",
    ),
}
