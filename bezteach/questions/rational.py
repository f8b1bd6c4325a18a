"""The questions of the lesson on rational curves; a quarter of a circle, and an arch with whole numbers."""

from fractions import Fraction as F

from ..numeric import bspline, evaluate, rational, split
from .asking import Choice, Entry, Goal

QUARTER = ((1, 0), (1, 1), (0, 1))
ROUND = (1, 1, 2)  # the weights that make it one
NEAR = ((1, 0), (1, F(11, 20)), (F(11, 20), 1), (0, 1))
ARCH = ((0, 0), (2, 4), (4, 0))
TARGET = (2, F(8, 3))
HEAVY = (1, 3, 1)

# the whole circle: four quarters, whose weights run up and down in turn
SQUARE = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0))
LOADS = (1, 1, 2, 1, 1, 1, 2, 1, 1)
KNOTS = (0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4)


def middle(w):
    """Where the arch with the weights 1, w, 1 is at t = 1/2."""
    return rational.evaluate(ARCH, (1, w, 1), F(1, 2))


def _on_quarter(t):
    above = evaluate(rational.lift(QUARTER, ROUND), t)
    return [
        (above[:2], "These are X and Y. A division is missing."),
        (above[:2] / F(sum(ROUND)), "You divided by the sum of the weights. Divide by W at this t."),
        (evaluate(QUARTER, t), "This is the point of the curve with equal weights."),
        (rational.evaluate(QUARTER, ROUND, t)[::-1], "The coordinates changed places."),
    ]


def _pulled():
    above = evaluate(rational.lift(ARCH, HEAVY), F(1, 2))
    return [
        (above[:2], "These are X and Y. Divide by W."),
        (middle(1), "This is the point for equal weights."),
        (ARCH[1], "This is the control point itself. What would be left of the other two?"),
        (above[:2] / F(sum(HEAVY)), "You divided by the sum of the weights. Their factors at t = 1/2 are not equal."),
    ]


def _lifted():
    above = rational.lift(ARCH, HEAVY)
    return [
        ([(x, y, w) for (x, y), w in zip(ARCH, HEAVY, strict=True)], "From the origin these are not seen at the bᵢ."),
        ([(x, y, 1) for x, y, _ in above], "The last coordinate is the weight."),
        ([(w, x, y) for x, y, w in above], "The weight stands last."),
    ]


def _right_half():
    """The middle control point, in the plane, of the right half of the quarter, cut at t = 1/2."""
    left, right = split(rational.lift(QUARTER, ROUND), F(1, 2))
    return rational.project(right)[1], [
        (rational.project(left)[1], "This one belongs to the left half."),
        (right[1][:2], "This is a point above the plane, without its last coordinate. Where is it seen?"),
        (split(QUARTER, F(1, 2))[1][1], "You cut the curve with equal weights. Lift the points first."),
    ]


QUESTIONS = {
    "rational/before-square": Choice(
        "x(t) = 2t³ - t + 1. What is the highest term of x(t)²?",
        {
            "2t⁶": "The factor is squared as well.",
            "4t⁶": "Yes: the square of the highest term, and nothing can cancel it.",
            "4t⁹": "t³ times t³: are the exponents added, or multiplied?",
        },
        "4t⁶",
    ),
    "rational/before-sum": Choice(
        "A point of a Bézier curve is a mean of the control points with the factors Bᵢ,ₙ(t). Why does it move along "
        "when all control points are shifted?",
        {
            "no factor is negative": "This keeps the curve in the hull. A shift asks for something else.",
            "the factors add up to 1": "Yes: so the whole shift arrives. Keep this in mind for section 2.",
            "the largest factor belongs to the nearest point": "The factors know t, and nothing of places.",
        },
        "the factors add up to 1",
    ),
    "rational/high-degree": Choice(
        "A curve of degree 30 can come much closer to the circle than this cubic. Can it run on the circle exactly, "
        "along a small piece at least?",
        {
            "yes, if the degree is high enough": "Closer is not equal. What is the highest term of x² + y²?",
            "yes, with irrational control points": "Are squares of irrational numbers not positive?",
            "no, whatever the degree": "Yes. The proof needs one look at the highest term.",
        },
        "no, whatever the degree",
    ),
    "rational/touching": Choice(
        "Choose k so that the middle of the cubic, at t = 1/2, is on the circle, too. What about the points between "
        "the middle and the ends?",
        {
            "they are on the circle": "Then x² + y² - 1 would be 0 for every t. Is there a k for which the formula is?",
            "they are off it": "Yes: with this k the formula vanishes at 0, 1/2 and 1 alone.",
            "it depends on the exact k": "There is one positive k for the middle. Put it into the formula.",
        },
        "they are off it",
    ),
    "rational/half": Entry(
        "The lifted points are (1, 0, 1), (1, 1, 1), (0, 2, 2). Where is the curve in the plane at t = 1/2?",
        lambda: rational.evaluate(QUARTER, ROUND, F(1, 2)),
        lambda: _on_quarter(F(1, 2)),
        "(1, 2/3)",
    ),
    "rational/middle-of-arc": Choice(
        "At t = 1/2 the quarter is at (3/5, 4/5). Is this the middle of the arc?",
        {
            "yes, t = 1/2 is the middle": "The parameter is no length. Where on the arc are both ends equally far?",
            "no, it is past the middle": "Yes: the middle has x = y. The point with the larger weight takes more.",
            "no, it is before the middle": "The arc starts in (1, 0). Which coordinate is the larger one here?",
        },
        "no, it is past the middle",
    ),
    "rational/shadow": Choice(
        "The control point (0, 1) with the weight 2 is lifted to (0, 2, 2). An eye in the origin looks at it. "
        "Where in the plane w = 1 does it see it?",
        {
            "(0, 2)": "Then the weight would move the point. Follow the ray from (0, 0, 0) to (0, 2, 2).",
            "(0, 1)": "Yes. The weight moves it along the ray, away from the eye; its place in the plane stays.",
            "(0, 4)": "The weight is already in the lifted point. The ray goes down to w = 1, not up.",
        },
        "(0, 1)",
    ),
    "rational/threefold": Choice(
        "The weights 1, 1, 2 become 3, 3, 6. What happens to the curve?",
        {
            "it is three times as large": "The weights are in the denominator, too.",
            "it comes closer to its control points": "Each of them pulls three times as strongly. Who wins?",
            "nothing": "Yes: the factor 3 cancels. Only the ratios of the weights count.",
        },
        "nothing",
    ),
    "rational/heavy": Entry(
        "The points (0, 0), (2, 4), (4, 0) have the weights 1, 3, 1. Where is the curve at t = 1/2?",
        lambda: middle(HEAVY[1]),
        _pulled,
        "(1, 2)",
    ),
    "rational/twice": Choice(
        "Now the weight of b₁ is doubled, from 3 to 6. A quarter of the way from (2, 0) to b₁ was left to go. "
        "How much is left now?",
        {
            "an eighth": "A weight is no distance: twice the weight does not halve what is left.",
            "a seventh": "Yes: 1/(1 + w). The two others still have the weight 1 each.",
            "nothing": "As long as the others weigh anything, they hold the point back.",
        },
        "a seventh",
    ),
    "rational/no-weight": Choice(
        "The arch (0, 0), (2, 4), (4, 0) gets the weights 1, 0, 1. What is drawn?",
        {
            "a curve through b₁": "A weight of 0 pulls with no force at all.",
            "the straight segment from b₀ to b₂": "Yes: b₁ has left the sum, but the basis function of its place still "
            "belongs to it.",
            "nothing, for a weight must be positive": "Is the denominator 0 anywhere? At t = 1/2 it is 1/2.",
        },
        "the straight segment from b₀ to b₂",
    ),
    "rational/minus": Choice(
        "The weights 1, -1, 2 obey 2 w₁² = w₀ w₂ as well. Which part of the circle is drawn for 0 ≤ t ≤ 1?",
        {
            "the same quarter": "At t = 1/2: X = 1/4 - 1/2 and Y = -1/2 + 1/2. Where is that?",
            "the other three quarters": "Yes: b₁ now pushes, and the curve goes round the other way, out of the hull.",
            "none": "The claim holds for all weights. And the denominator has no root here.",
        },
        "the other three quarters",
    ),
    "rational/all-ones": Choice(
        "All weights of a NURBS curve are 1. What is it?",
        {
            "a circle": "A circle needs weights that differ: a polynomial piece never is one.",
            "a B-spline curve": "Yes: B-splines are the NURBS with equal weights, as Bézier curves are B-splines with "
            "no knot inside.",
            "a polygon": "The weights do not decide the degree.",
        },
        "a B-spline curve",
    ),
    "rational/how-many-knots": Entry(
        "The whole circle as one curve of degree 2 has nine control points. How many knots?",
        lambda: len(bspline.clamped(len(SQUARE), 2)),
        lambda: [
            (len(SQUARE) + 2, "Points + degree is one too few."),
            (len(SQUARE), "As many as points: then no span would have three points."),
            (len(SQUARE) - 2, "So many are the spans, if all inner knots are single, not the knots."),
        ],
        "10",
    ),
    "rational/exercise-point": Entry(
        "Exercise 1. The quarter of the circle, weights 1, 1, 2: its point at t = 2/3.",
        lambda: rational.evaluate(QUARTER, ROUND, F(2, 3)),
        lambda: _on_quarter(F(2, 3)),
        "(1, 2/3)",
    ),
    "rational/exercise-lift": Entry(
        "Exercise 2. The control points (0, 0), (2, 4), (4, 0) with the weights 1, 3, 1: the points in space.",
        lambda: rational.lift(ARCH, HEAVY),
        _lifted,
        "(0, 0, 1) (1, 2, 3) (1, 1, 1)",
    ),
    "rational/exercise-weight": Entry(
        "Exercise 3. The same points with the weights 1, w, 1. Which w leads the curve through (2, 7/2)?",
        lambda: F(7, 2) / (4 - F(7, 2)),
        lambda: [
            (F(7, 8), "This is the share of the way from (2, 0) to b₁. It is w/(1 + w), not w."),
            (F(7, 2), "This is a height. Which share of the way to b₁ is it?"),
            (8, "This is 1 + w."),
            (F(1, 7), "Upside down: this weight would leave the curve low."),
        ],
        "1/2",
    ),
    "rational/exercise-half": Entry(
        "Exercise 4. Cut the quarter of the circle at t = 1/2. The middle control point of its right half, in the "
        "plane:",
        lambda: _right_half()[0],
        lambda: _right_half()[1],
        "(1, 2/3)",
    ),
    "rational/exercise-gap": Entry(
        "Exercise 5. The cubic (1, 0), (1, 2/3), (2/3, 1), (0, 1): the exact value of x² + y² - 1 at t = 1/2.",
        lambda: _square(F(2, 3)) - 1,
        lambda: [
            (_square(F(2, 3)), "This is x² + y². How far is it from 1?"),
            (F(1, 2), "t (1 - t) enters with its square."),
            (2, "This is the bracket. Its factor is missing."),
            (F(113, 160) ** 2 * 2 - 1, "This is the cubic with k = 11/20."),
        ],
        "1/2",
    ),
}


def _square(k):
    x, y = evaluate(((1, 0), (1, k), (k, 1), (0, 1)), F(1, 2))
    return x * x + y * y


def _weights(state):
    """The weights of a state; one without weights is a polynomial curve, with all weights equal."""
    return getattr(state, "weights", (1,) * len(state.points))


def _passes(state):
    return state.points == ARCH and tuple(rational.evaluate(ARCH, _weights(state), F(1, 2))) == TARGET


GOALS = {
    "rational/circle": Goal(
        "Task: move no point. Find the weight of b₂ with which the curve runs on the unit circle.",
        lambda state: state.points == QUARTER and rational.on_unit_circle(QUARTER, _weights(state)),
        "Reached: x² + y² = 1, exactly, for every t. Move t and see.",
    ),
    "rational/through": Goal(
        "Task: move no point. Find the weight of b₁ with which the curve passes the square at (2, 8/3).",
        _passes,
        "Reached: two thirds of the way from (2, 0) to b₁. How does the share follow from the weights 1, w, 1?",
    ),
}
