"""The questions of the lesson on why Bernstein's basis; the numbers are the slides' parabola, or close to it."""

from fractions import Fraction as F

import numpy as np

from ..examples import EXAMPLES
from ..numeric import bernstein, evaluate, from_power, to_power
from ..numeric.fitting import fit
from .asking import Choice, Entry, Goal

COEFFICIENTS = EXAMPLES["games/parabola"].given["coefficients"]
PARABOLA = EXAMPLES["games/parabola"].answer["points"]
SMOOTH = (0, 0, 3, -2)  # of 1, t, t^2, t^3: from 0 to 1, flat at both ends
POWERS = ((1, 2), (4, -2), (-3, 1))
POINTS = ((2, 0), (1, 3), (4, 2))
HEIGHTS = (0, 3, 3)
ENDS, PASSED = ((0, 0), (4, 0)), (2, 3)
TARGET = (1, 1)
MOVE = (0, 8)


def _on_circle(t):
    """The point ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)), numerators and denominator as polynomials."""
    across, up, below = (evaluate(from_power(row), t) for row in ((1, 0, -1), (0, 2, 0), (1, 0, 1)))
    return across / below, up / below


def _pulled():
    """The b_1 for which the curve is at ``PASSED`` for t = 1/2."""
    start, middle, end = bernstein(2, F(1, 2))
    return tuple((p - start * a - end * b) / middle for p, a, b in zip(PASSED, *ENDS, strict=True))


def _moved(weight):
    return tuple(weight * x for x in MOVE)


def _array(points):
    return np.array(points, dtype=object)


QUESTIONS = {
    "why/before-line": Choice(
        "A and B are two points. Where is the point (1 - t) A + t B for t = 1/4?",
        {
            "a quarter of the way from A to B": "Yes: it starts in A at t = 0 and is in B at t = 1.",
            "three quarters of the way from A to B": "That would need t = 3/4: at t = 0 the point is A.",
            "beside the line through A and B": "Write it as A + t (B - A): where does it lead from A?",
        },
        "a quarter of the way from A to B",
    ),
    "why/before-binomial": Choice(
        "Multiply (u + t)³ out. Which numbers stand before u³, u²t, ut², t³?",
        {
            "1, 1, 1, 1": "In how many ways can one t and two u be taken out of the three brackets?",
            "1, 3, 3, 1": "Yes: a row of Pascal's triangle (杨辉三角), the binomial coefficients (二项式系数).",
            "1, 2, 2, 1": "These add up to 6. Put u = t = 1: what must they add up to?",
        },
        "1, 3, 3, 1",
    ),
    "why/before-parabola": Choice(
        "Where is the lowest point of the parabola y = x² - 2x + 3?",
        {
            "(0, 3)": "The 3 is the height at x = 0. Is that the lowest?",
            "(-2, 3)": "These are two of the coefficients. Complete the square.",
            "(1, 2)": "Yes: y = (x - 1)² + 2. The coefficients 1, -2, 3 did not show it, you had to compute.",
        },
        "(1, 2)",
    ),
    "why/turned": Choice(
        "The parabola y = x² is turned about the origin until the angle has the cosine 3/5 and the sine 4/5. "
        "Is the result the graph of a function y = g(x)?",
        {
            "yes, of another quadratic function": "Such a graph opens straight upwards or downwards. The turned one "
            "opens to the side.",
            "yes, but not of a quadratic one": "How many points may a graph have over one x?",
            "no: some vertical lines meet it twice": "Yes. A graph may meet a vertical line once at most.",
        },
        "no: some vertical lines meet it twice",
    ),
    "why/half": Choice(
        "x = 2t - 2t², y = 1 + t² for t from 0 to 1. Which half of the run is longer? Work out the points at "
        "t = 0, 1/2 and 1 first.",
        {
            "t from 0 to 1/2": "Compare the straight distances between your three points.",
            "both are equally long: t = 1/2 is the half": "Half of the time is not half of the way. Compare the "
            "straight distances between your three points.",
            "t from 1/2 to 1": "Yes: the point runs faster and faster.",
        },
        "t from 1/2 to 1",
    ),
    "why/end": Entry(
        "Where is f(t) = (1, 1) t² + (-2, 0) t + (1, 0) at t = 1?",
        lambda: evaluate(PARABOLA, 1),
        lambda: [
            (COEFFICIENTS[2], "That is the coefficient of t². At t = 1 the other two terms do not vanish."),
            (COEFFICIENTS[0], "That is where the curve is at t = 0."),
            ((4, 1), "A sign: the middle coefficient is negative."),
        ],
        "(2, 3)",
    ),
    "why/moved": Choice(
        "All three coefficient points are moved by (1, 0). By how much does the end of the curve, f(1), move?",
        {
            "by (1, 0), like everything else": "Put t = 1 into f, with the moved coefficients: how many terms changed?",
            "by (3, 0)": "Yes: at t = 1 the weights t², t and 1 are all 1, and they add up to 3.",
            "not at all": "f(1) is the sum of the three coefficients.",
        },
        "by (3, 0)",
    ),
    "why/through": Choice(
        "The control points are (1, 0), (0, 0), (0, 1). Does the curve pass through the middle one?",
        {
            "yes, at t = 1/2": "The weights at t = 1/2 are 1/4, 1/2, 1/4. Take the mean of the three points with them.",
            "yes, at some other t": "The first coordinate is (1 - t)², the second is t². When are both 0?",
            "no": "Yes. It starts at the first one, ends at the last, and is only drawn towards the middle one.",
        },
        "no",
    ),
    "why/same-fit": Choice(
        "The same samples are fitted twice with degree 2: once in the powers, once in the Bernstein basis. "
        "What is different?",
        {
            "the curve": "Both bases make the same set of curves. In one set, how many curves are the nearest?",
            "the three coefficients": "Yes: one curve, written in two ways.",
            "the curve and the coefficients": "Both bases make all polynomials of degree 2, the same set.",
        },
        "the three coefficients",
    ),
    "why/one-percent": Choice(
        "The graph has heights between 0 and 1. The coefficient -120 of t⁴ becomes -121.2, one percent more. "
        "By how much does the graph move at t = 1?",
        {
            "by 0.012": "The coefficient changes by 1.2. Which number is it multiplied with, at t = 1?",
            "by 1.2": "Yes: more than the height of the whole graph.",
            "not at all, t⁴ belongs to the middle": "At t = 1 every power of t is the same number. Which?",
        },
        "by 1.2",
    ),
    "why/one-height": Choice(
        "Now one of the seven Bernstein coefficients moves by 1/100. By how much does the graph move, "
        "anywhere over [0, 1]?",
        {
            "by 1/100 at most": "Yes: a weight on [0, 1] is never above 1.",
            "by 7/100 at the end": "At the end, t = 1, all weights but the last are 0.",
            "it depends on the other coefficients": "The change of one coefficient is multiplied with its own weight "
            "alone.",
        },
        "by 1/100 at most",
    ),
    "why/smooth": Entry(
        "The graph of your task: its four Bernstein coefficients, from left to right.",
        lambda: from_power(SMOOTH),
        lambda: [
            (SMOOTH, "These are the coefficients of the powers, on the right. Asked are those on the left."),
            ((0, F(1, 3), F(2, 3), 1), "That is the straight line from 0 to 1: it is not flat at the ends."),
            ((0, 1, 0, 1), "That is where the board began. Is the graph flat at its ends?"),
            ((1, 1, 0, 0), "This one runs from 1 down to 0."),
        ],
        "1, 0, 1, 2",
    ),
    "why/exercise-circle": Entry(
        "Exercise 1. x = (1 - t²) / (1 + t²), y = 2t / (1 + t²): the point at t = 1/3.",
        lambda: _on_circle(F(1, 3)),
        lambda: [
            (_on_circle(F(1, 3))[::-1], "The coordinates changed places."),
            ((F(8, 9), F(2, 3)), "These are the numerators. What are they divided by?"),
            (_on_circle(3), "You put t = 3."),
            ((_on_circle(F(1, 3))[0], F(3, 10)), "The first coordinate is right; the second has a factor 2."),
        ],
        "(0, 1)",
    ),
    "why/exercise-from-power": Entry(
        "Exercise 2. The control points of (1, 2) + (4, -2) t + (-3, 1) t²:",
        lambda: from_power(POWERS),
        lambda: [
            (POWERS, "These are the coefficients. Write 1, t and t² with the three weights."),
            (from_power(POWERS)[::-1], "The right points, the last one first: the curve begins where t = 0."),
            (
                (POWERS[0], tuple(_array(POWERS[0]) + _array(POWERS[1])), from_power(POWERS)[2]),
                "The ends are right. In t, what stands before the weight 2t(1 - t)?",
            ),
            (
                (POWERS[0], evaluate(from_power(POWERS), F(1, 2)), from_power(POWERS)[2]),
                "The ends are right. Your middle one is the point of the curve at t = 1/2, and no control point.",
            ),
        ],
        "(0, 0) (1, 2) (3, 3)",
    ),
    "why/exercise-to-power": Entry(
        "Exercise 3. The control points are (2, 0) (1, 3) (4, 2). The coefficients of 1, t, t²:",
        lambda: to_power(POINTS),
        lambda: [
            (to_power(POINTS)[::-1], "The right ones, the highest power first. Asked is the order 1, t, t²."),
            (
                (POINTS[0], tuple(_array(POINTS[1]) - _array(POINTS[0])), to_power(POINTS)[2]),
                "The coefficient of t lacks a factor: the middle weight is 2t(1 - t).",
            ),
            (POINTS, "These are the control points. Multiply the weights out and collect the powers."),
        ],
        "(0, 0) (1, 2) (3, 3)",
    ),
    "why/exercise-fit": Entry(
        "Exercise 4. The heights 0, 3, 3 are measured at t = 0, 1/2, 1. The two control heights of the straight line "
        "that fits best:",
        lambda: fit(HEIGHTS, 1),
        lambda: [
            ((0, 3), "That is the line through the first and the last sample. It misses the middle one by a lot."),
            ((F(1, 2), 3), "These are the coefficients of 1 and t. Where does the line end?"),
            ((2, 2), "That is the mean of the heights, the best constant. A line may rise."),
            (fit(HEIGHTS, 1)[::-1], "The right heights, the last one first."),
        ],
        "1, 2",
    ),
    "why/exercise-degree": Choice(
        "Exercise 5. Seven samples, at seven different t. Which is the lowest degree whose best fit passes through all "
        "of them, wherever they lie?",
        {
            "2": "A parabola has three coefficients, and seven points to pass through.",
            "6": "Yes: seven coefficients for seven samples.",
            "7": "It would do. But is it the lowest? Count the coefficients of a polynomial of degree 7.",
            "none: a fit never passes through the samples": "It does when the sum of the squares can become 0.",
        },
        "6",
    ),
    "why/exercise-move": Entry(
        "Exercise 6. The second control point b₁ of a cubic is moved by (0, 8). By which vector does the curve's point "
        "at t = 1/2 move?",
        lambda: _moved(bernstein(3, F(1, 2))[1]),
        lambda: [
            (MOVE, "So far moves the control point. The point of the curve follows with the weight of b₁."),
            (_moved(F(1, 4)), "That would be so if the four weights were equal."),
            (_moved(F(1, 8)), "The powers of 1/2 are right; the binomial coefficient is missing."),
            (_moved(F(1, 2)), "That is the weight of the middle point of a parabola. Here the degree is 3."),
        ],
        "(0, 1)",
    ),
    "why/exercise-pull": Entry(
        "Exercise 7. A parabola starts at b₀ = (0, 0) and ends at b₂ = (4, 0). Draw it. Where must b₁ lie so that the "
        "curve is at (2, 3) for t = 1/2?",
        _pulled,
        lambda: [
            (PASSED, "The curve is drawn towards b₁ and does not reach it."),
            ((4, 6), "The height is right. The ends pull sideways too: their middle is at (2, 0)."),
            ((2, 12), "Too far: the middle weight at t = 1/2 is not 1/4. It is the largest of the three."),
        ],
        "(1, 1)",
    ),
    "why/exercise-way": Entry(
        "Exercise 8. A point runs along a line by (2t², 4t²), for t from 0 to 1. At which t has it gone one ninth of "
        "its way?",
        lambda: F(1, 3),
        lambda: [
            (F(1, 9), "Work its place out at this t. How far has it come?"),
            (F(1, 81), "You squared. The way is given, and the time is asked for."),
            (F(1, 18), "Start with the length of the whole way, then with the part of it at t."),
        ],
        "1/2",
    ),
}

GOALS = {
    "why/through": Goal(
        "Task: move the middle control point, and no other, until the curve passes through (1, 1) at t = 1/2.",
        lambda state: (
            len(state.points) == 3
            and (state.points[0], state.points[-1]) == (PARABOLA[0], PARABOLA[-1])
            and tuple(evaluate(state.points, F(1, 2))) == TARGET
        ),
        "Reached. How far beyond (1, 1) is the control point? Compare with the middle of the two ends.",
    ),
}
