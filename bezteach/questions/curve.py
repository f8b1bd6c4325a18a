"""The questions of the lesson on the properties of the curve; the sources' numbers, or small ones."""

from fractions import Fraction as F

import numpy as np

from ..examples import EXAMPLES
from ..numeric import bernstein, derivative, evaluate, sign_changes
from .asking import Choice, Entry, Goal, all_but

CUBIC = EXAMPLES["deck/split"].given["points"]
ARCH = EXAMPLES["deck/segment"].given["points"]
DENT = ((0, 0), (0, 6), (1, 1), (6, 0))  # its curve leaves the polygon at the dent in (1, 1)
LOOP = ((0, 0), (1, 1), (-1, 1), (6, -6))  # its polygon passes the axis twice in one place, its curve in two
QUARTIC = ((0, 0), (1, 2), (2, 3), (4, 3), (6, 0))
HEIGHTS = (2, -1, -3, 0, 4, -2)  # over a line, of the control points of a curve of degree 5
TARGET = (F(9, 4), F(9, 4))


def _quartic_end():
    end = derivative(QUARTIC, 1)
    return [
        (end / F(4), "This is the last edge. The velocity has its direction, but not its length."),
        (-end, "This arrow points back along the last edge. Which way does the curve run at its end?"),
        (end * F(5, 4), "You multiplied by the number of points; the factor is the degree."),
        (derivative(QUARTIC, 0), "This is the velocity at the start."),
    ]


def _quartic_second():
    second = derivative(QUARTIC, 0, 2)
    return [
        (second / F(12), "This is the second edge minus the first. A factor is missing."),
        (second / F(3), "The factor of a second derivative has two parts, n and n - 1."),
        (second * F(4, 3), "The factor is not n²: after one derivative the degree is n - 1."),
        (-second, "The first edge minus the second: the other way round."),
    ]


def _mapped():
    return evaluate([(2 * x - y, y + 3) for x, y in CUBIC], F(1, 3))


def _point_mapped():
    mapped, point = _mapped(), evaluate(CUBIC, F(1, 3))
    return [
        (point, "This is the old point. The curve goes along with its control points."),
        (mapped - np.array([0, 3]), "The shift is missing: the point goes up by 3, as each control point does."),
        (mapped + np.array([0, 9]), "You added 3 for each of the four control points. What do their weights sum to?"),
    ]


def _backwards():
    return derivative(CUBIC[::-1], 0)


def _pull(t=F(1, 4)):
    """The vector by which b_1 of a quartic must move so that the point at t moves by (27, 0)."""
    return F(27) / bernstein(4, t)[1], F(0)


def _convex_range():
    """The slide's quartic, stretched upwards by 4."""
    return tuple(4 * w for w in EXAMPLES["deck/quartic"].answer["convex_for_w"])


QUESTIONS = {
    "curve/before-sum": Choice(
        "At t = 1/3 the weights of b₀, b₁, b₂ of a cubic are 8/27, 12/27, 6/27. What is the weight of b₃?",
        {
            "0": "It is t³, and t is not 0.",
            "1/27": "Yes: the four weights sum to 1.",
            "2/27": "Then the four would sum to more than 1.",
        },
        "1/27",
    ),
    "curve/before-peak": Choice(
        "Where on [0, 1] is the weight B₁,₃ greatest?",
        {
            "at t = 1/4": "There are four weights, but the degree is 3.",
            "at t = 1/3": "Yes: number i of degree n is greatest at i/n.",
            "at t = 1/2": "That would make it symmetric. Its mirror image is B₂,₃.",
        },
        "at t = 1/3",
    ),
    "curve/passes": Choice(
        "Which of its control points does a cubic pass, wherever you put them?",
        {
            "all four": "Look at b₁ on the board. To be there the curve would need the weights 0, 1, 0, 0.",
            "b₀ and b₃": "Yes: only there one weight is 1 and all others are 0.",
            "none of them": "At t = 0, which point has all the weight?",
        },
        "b₀ and b₃",
    ),
    "curve/start-velocity": Choice(
        "At t = 0 the four weights change at the rates -3, 3, 0, 0. So the velocity p'(0) is",
        {
            "b₁ - b₀": "That is the edge. Multiply each control point by the rate of its weight.",
            "3 (b₀ - b₁)": "Look at the signs: b₀ loses weight, b₁ gains it.",
            "3 (b₁ - b₀)": "Yes: the direction of the first edge, three times its length.",
        },
        "3 (b₁ - b₀)",
    ),
    "curve/how-many-enter": Choice(
        "A curve of degree 5. On how many control points does its third derivative at t = 0 depend?",
        {
            "3": "Look at the row for order 2 of the cubic: how many numbers in it are not 0?",
            "4": "Yes: order r needs r + 1 points. The degree has no say in it.",
            "6": "All six enter inside. At t = 0 only the next ones do.",
        },
        "4",
    ),
    "curve/end-sign": Choice(
        "For k = 1 this says p'(1) = n (bₙ₋₁ - bₙ). A few lines above, the slide says n (bₙ - bₙ₋₁). Which is right?",
        {
            "n (bₙ₋₁ - bₙ)": "Take n = 1, b₀ = 0 and b₁ = 1, so p(t) = t. Is its velocity -1?",
            "n (bₙ - bₙ₋₁)": "Yes: later minus earlier, at both ends. With the other sign the point would go back.",
            "both, the line is the same": "The line is the same, but a velocity also says in which direction.",
        },
        "n (bₙ - bₙ₋₁)",
    ),
    "curve/needed": Choice(
        "All control points move by v, and so does p(t). Which property of the weights did you use?",
        {
            "they are not negative": "Try weights like 2 and -1: do not two points that move by v give it again?",
            "they sum to 1": "Yes, and nothing else. So it holds for every t, also outside of [0, 1].",
            "each is greatest at j/n": "v stands beside each weight. What is left when you take it out of the sum?",
        },
        "they sum to 1",
    ),
    "curve/reversed": Choice(
        "The control points in reverse order, (3, 3) (2, 1) (1, 3) (0, 0). What happens to the curve?",
        {
            "it gets another shape": "Exchange t and 1 - t in the weights of the first curve: what do you get?",
            "the same shape, run backwards": "Yes: the new curve at t is the old one at 1 - t.",
            "nothing, p(t) is the same": "Where does the new curve start?",
        },
        "the same shape, run backwards",
    ),
    "curve/longer-interval": Choice(
        "The same curve, but its parameter u runs from 2 to 6. What is the velocity at the start, measured in u?",
        {
            "four times p'(0)": "The way is the same, and there is more time. Is the point faster?",
            "p'(0)": "The shape is the same. But the time is not.",
            "a quarter of p'(0)": "Yes: four times the time for the same way.",
        },
        "a quarter of p'(0)",
    ),
    "curve/even": Choice(
        "The control points (0, 0) (2, 1) (4, 2) (6, 3) stand on a line at equal steps. Where is p(1/4)?",
        {
            "before the quarter of the way": "Add up: weights 27/64, 27/64, 9/64, 1/64 for the x = 0, 2, 4, 6.",
            "at the quarter of the way": "Yes: at equal steps the point runs evenly.",
            "after the quarter of the way": "Try degree 2 first, the points 0, 1, 2 with the weights 9/16, 6/16, 1/16.",
        },
        "at the quarter of the way",
    ),
    "curve/crowded": Choice(
        "Now (0, 0) (0, 0) (2, 1) (6, 3): the same segment, from (0, 0) to (6, 3). Where is p(1/2)?",
        {
            "before the middle": "Yes: three of the four points stand in the first third and hold it back.",
            "in the middle": "t is the clock. Is the point where it is at half time, if it starts slowly?",
            "after the middle": "Which end pulls harder at t = 1/2: how many control points stand there?",
        },
        "before the middle",
    ),
    "curve/inside": Choice(
        "The control points (0, 0) (0, 6) (1, 1) (6, 0), at t = 1/2 with the weights 1/8, 3/8, 3/8, 1/8. "
        "Join b₃ to b₀ too. Where is p(1/2)?",
        {
            "inside the polygon": "Compute it, draw the four points, and see on which side of b₁b₂ and b₂b₃ it is.",
            "outside of the polygon": "Yes: the polygon has a dent at b₂, and the curve runs past it.",
            "on the polygon": "Compute it: eighths. Is it on one of the four lines?",
        },
        "outside of the polygon",
    ),
    "curve/passages": Choice(
        "A line passes the control polygon three times and goes through no control point. "
        "How often can it cross the curve?",
        {
            "0, 1, 2 or 3 times": "b₀ and b₃ are on different sides of the line. Can the curve cross it twice?",
            "1 or 3 times": "Yes: not more often than the polygon, and its ends are on different sides.",
            "3 times": "The curve is smoother than the polygon: it may miss some passages.",
        },
        "1 or 3 times",
    ),
    "curve/concave": Choice(
        "w = 1/8: the polygon has a dent in the middle, at b₂. And the curve?",
        {
            "it has a dent too": "Polygon convex, so curve convex: does this say what happens if the polygon is not?",
            "it is convex": "Yes: the dent is too shallow, the average over five points smooths it out.",
        },
        "it is convex",
    ),
    "curve/convex-range": Choice(
        "For exactly which w is the curve convex?",
        {
            "0 ≤ w < 1/4": "There the polygon is concave and the curve convex. Does the curve turn concave at 1/4?",
            "1/4 ≤ w ≤ 1/2": "There the polygon is convex. You have just seen convex curves for smaller w.",
            "0 ≤ w ≤ 1/2": "Yes: beyond each end y'' changes its sign twice.",
            "every w ≥ 0": "Pull b₂ up to 1. Between the hill and each end, which way does the curve bend?",
        },
        "0 ≤ w ≤ 1/2",
    ),
    "curve/far": Choice(
        "b₁ of the arch moves by (3, 6). Does the point at t = 9/10 move, near the other end?",
        {
            "no, it is too far away": "By how much does a point move? Look at its weight: B₁,₃(9/10) is not 0.",
            "yes, a little": "Yes: the weight is small there, 27/1000, but not 0.",
            "yes, by (3, 6)": "For this the weight of b₁ would have to be 1.",
        },
        "yes, a little",
    ),
    "curve/strongest": Choice(
        "Which point of the arch moves most?",
        {
            "that at t = 1/4": "b₁ is number 1 of degree 3: count the steps between the points, not the points.",
            "that at t = 1/3": "Yes: where the weight B₁,₃ is greatest. It moves by 4/9 of the way.",
            "that at t = 1/2": "There b₁ and b₂ weigh the same. Where does b₁ weigh more?",
        },
        "that at t = 1/3",
    ),
    "curve/circle-degree": Choice(
        "x(t) and y(t) are polynomials with real coefficients, and the larger of their degrees is 3. "
        "What is the degree of x² + y²?",
        {
            "3": "Squaring doubles a degree.",
            "6": "Yes: at t⁶ stands a sum of two squares, not both 0. It cannot vanish.",
            "at most 5, the highest terms can cancel": "At t⁶ stands the sum of two squares of real numbers. When is "
            "it 0?",
        },
        "6",
    ),
    "curve/exercise-end": Entry(
        "Exercise 1. The quartic (0, 0) (1, 2) (2, 3) (4, 3) (6, 0): the vector p'(1).",
        lambda: derivative(QUARTIC, 1),
        _quartic_end,
        "(1, 2)",
    ),
    "curve/exercise-second": Entry(
        "Exercise 2. The same quartic: the vector p''(0).",
        lambda: derivative(QUARTIC, 0, 2),
        _quartic_second,
        "(1, 2)",
    ),
    "curve/exercise-possible": Choice(
        "Exercise 3. The control points are (0, 0) (0, 6) (1, 1) (6, 0). "
        "Which of these points is surely not on the curve?",
        {
            "(1, 2)": "It lies in the convex hull: the hull alone does not exclude it.",
            "(2, 3)": "It lies outside of the polygon. Does this exclude it?",
            "(4, 3)": "Yes: x + y is 7 there, and at most 6 at every control point.",
        },
        "(4, 3)",
    ),
    "curve/exercise-passages": Entry(
        "Exercise 4. Over a line, the control points of a curve of degree 5 have the heights 2, -1, -3, 0, 4, -2. "
        "At most how often does the curve cross the line?",
        lambda: sign_changes(HEIGHTS),
        lambda: [
            (5, "That is the bound by the degree. The polygon gives a smaller one."),
            (4, "A height 0 is passed over: what counts is whether the sign before it and after it differ."),
            (2, "Some changes of sign are missing: go from number to number."),
        ],
        "1",
    ),
    "curve/exercise-mapped": Entry(
        "Exercise 5. The cubic (0, 0) (1, 3) (2, 1) (3, 3) is at (1, 5/3) for t = 1/3. Each control point (x, y) goes "
        "to (2x - y, y + 3). Where is the new curve at t = 1/3?",
        _mapped,
        _point_mapped,
        "(1, 1/2)",
    ),
    "curve/exercise-backwards": Entry(
        "Exercise 6. The same cubic is run backwards: q(t) = p(1 - t). The vector q'(0):",
        _backwards,
        lambda: [
            (-_backwards(), "With this velocity p ends. q runs the other way."),
            (_backwards() / F(3), "This is the edge. The velocity is longer."),
            (-derivative(CUBIC, 0), "q starts where p ends: which edge is there?"),
            (derivative(CUBIC, 0), "This is p'(0). Where does q start?"),
        ],
        "(1, 2)",
    ),
    "curve/exercise-range": Entry(
        "Exercise 7. The quartic with the heights 0, 1, w, 1, 0 at equal steps: the smallest and the largest w "
        "with a convex curve.",
        _convex_range,
        lambda: [
            ((0, F(1, 2)), "These belong to the heights 0, 1/4, w, 1/4, 0. Which map takes them to yours?"),
            ((1, 2), "For these the polygon is convex. The curve is so for some more."),
            ((0, 1), "Between these the polygon is concave. When it is convex, so is the curve."),
        ],
        "1, 5",
    ),
    "curve/exercise-pull": Entry(
        "Exercise 8. By which vector must b₁ of a quartic move, so that the point at t = 1/4 moves by (27, 0)?",
        _pull,
        lambda: [
            ((27, 0), "Then p(1/4) moves by less: b₁ has only a part of the weight."),
            ((F(27) * bernstein(4, F(1, 4))[1], 0), "You multiplied by the weight: so far moves p if b₁ moves by 27."),
            (_pull(F(3, 4)), "You took the weight at t = 3/4."),
            ((108, 0), "You divided by t. The weight of b₁ at t = 1/4 is not 1/4."),
        ],
        "(1, 0)",
    ),
}


def _only_inner_moved(state):
    """Whether the state has as many points as the cubic, and its ends."""
    return len(state.points) == len(CUBIC) and (state.points[0], state.points[-1]) == (CUBIC[0], CUBIC[-1])


def _velocities(state):
    ends = (tuple(derivative(state.points, end)) for end in (0, 1))
    return _only_inner_moved(state) and tuple(ends) == ((6, 0), (0, -6))


def _three_crossings(state):
    """Whether the line crosses the cubic three times: the heights alternate and their polynomial has three roots.

    In x = t/(1 - t) > 0 the polynomial has the coefficients C(3, i) d_i. If they alternate, no root is 0 or negative,
    and three different real roots, which a positive discriminant says, are three crossings.
    """
    if state.points != CUBIC:
        return False
    (x0, y0), (x1, y1) = state.line
    d = [(x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) for x, y in state.points]
    s, r, q, p = d[0], 3 * d[1], 3 * d[2], d[3]
    discriminant = q * q * r * r - 4 * p * r**3 - 4 * q**3 * s - 27 * p * p * s * s + 18 * p * q * r * s
    return sign_changes(d) == 3 and discriminant > 0


def _dented(state):
    """Whether the slide's quartic, no point of it moved but b_2, has a concave polygon and a convex curve."""
    return all_but(2, state, EXAMPLES["deck/quartic"].given["points"]) and 0 <= state.points[2][1] < F(1, 4)


def _pulled(state):
    return all_but(2, state, CUBIC) and tuple(evaluate(state.points, F(1, 2))) == TARGET


GOALS = {
    "curve/velocities": Goal(
        "Task: move b₁ and b₂, but not the ends, so that p'(0) = (6, 0) and p'(1) = (0, -6).",
        _velocities,
        "Reached. The point starts and arrives with the speed 6. How long are the first and the last edge?",
    ),
    "curve/three-crossings": Goal(
        "Task: leave the control points (Reset puts them back), and move the line so that it crosses the curve three "
        "times.",
        _three_crossings,
        "Reached. How often does the line pass the polygon? Turn it on until it crosses the curve once. And now?",
    ),
    "curve/dented": Goal(
        "Task: move b₂ only, or the slider of w, so that the polygon is concave and the curve convex.",
        _dented,
        "Reached. How far down may w go? And how far up may it go, if only the curve has to be convex?",
    ),
    "curve/pulled": Goal(
        "Task: move b₂, and no other point, until p(1/2) is at (9/4, 9/4).",
        _pulled,
        "Reached. How far did b₂ go, and how far did p(1/2) go? Compare with the weight of b₂ at t = 1/2.",
    ),
}
