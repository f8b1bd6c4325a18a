"""The questions of the lesson on degree elevation, up and down; the sources' numbers, or small ones."""

from fractions import Fraction as F

import numpy as np

from ..examples import EXAMPLES
from ..numeric import elevate, lower, polygon_gap, sign_changes, to_power
from .asking import Choice, Entry, Goal, all_but

CUBIC = EXAMPLES["deck/split"].given["points"]
HILL = ((0, 0), (3, 3), (6, 0))
SECRET = ((0, 0), (2, 4), (5, 5), (9, 3))  # a parabola in disguise
STEADY = (1, 2, 4, 7, 11)
CUBE = (0, 0, 0, 1)  # t^3
TASK = ((0, 0), (1, 3), (5, 2), (6, 3))  # b_2 at (3, 4) would make it a parabola


def _hill_elevated():
    right = elevate(HILL)
    b0, b1, b2 = np.array(HILL, dtype=object)
    return [
        (
            [b0, (b0 + 2 * b1) / F(3), (b1 + 2 * b2) / F(3), b2],
            "You used one ratio on both edges. i is 1 on the first and 2 on the second.",
        ),
        (
            [b0, (2 * b0 + b1) / F(3), (b1 + 2 * b2) / F(3), b2],
            "Your points are too near the ends. Which weight belongs to the point before, bᵢ₋₁?",
        ),
        ([b0, (b0 + b1) / F(2), (b1 + b2) / F(2), b2], "You took the middles of the edges. The denominator is n + 1."),
        (right[1:-1], "These are the inner points. The ends belong to the polygon, too."),
    ]


def _edge_point():
    return [
        ((4, 3), "You swapped the weights: i/(n + 1) belongs to the point before, bᵢ₋₁."),
        ((5, F(5, 2)), "This is the middle. With which i does a point fall into the middle of an edge?"),
        ((F(20, 3), F(5, 3)), "You worked with thirds. The denominator is the new degree."),
        ((8, 1), "This ratio belongs to the first edge: which c lies on b₁b₂?"),
    ]


def _lowered_cube():
    return [
        ((0, 0, 1), "These heights give t². How far is t² from t³ in the middle?"),
        ((0, F(-1, 4), 1), "This keeps both ends. The nearest parabola gives them up."),
        (elevate(lower(CUBE)), "This is the nearest parabola, still written with degree 3: one more step down."),
        ((0, 0, 0), "You dropped the term t³. Then the error at t = 1 is 1."),
    ]


QUESTIONS = {
    "elevation/before-edge": Choice(
        "Where on the edge from a to b is the point 1/3 a + 2/3 b?",
        {
            "a third of the way from a": "The larger weight pulls more. Which point has the larger one?",
            "two thirds of the way from a": "Yes: the weight of b says how far you have gone from a.",
            "beyond b": "Both weights are positive and their sum is 1: you stay between a and b.",
        },
        "two thirds of the way from a",
    ),
    "elevation/before-power": Choice(
        "A cubic is multiplied out. What stands before t³?",
        {
            "b₃": "Put all points in one place: then the curve is one point, and nothing stands before t³.",
            "b₃ - b₀": "Think of equal steps on a line: 0, 1, 2, 3. The curve is 3t, without t³.",
            "b₃ - 3b₂ + 3b₁ - b₀": "Yes: the third difference, (E - 1)³ b₀.",
        },
        "b₃ - 3b₂ + 3b₁ - b₀",
    ),
    "elevation/what-changes": Choice(
        "The parabola is written with four control points. How does the curve change?",
        {
            "it comes nearer to the polygon": "The polygon comes nearer to the curve. Does the curve move?",
            "it becomes a true cubic": "A cubic has a term with t³. Where should this one have it from?",
            "not at all": "Yes: the same points at the same t, only the notation has changed.",
        },
        "not at all",
    ),
    "elevation/first-ratio": Choice(
        "A cubic is written with degree 4. Where on the edge b₀b₁ is the new point c₁?",
        {
            "1/4 of the way from b₀": "That would be the weights 3/4 and 1/4. The parabola's c₁ was nearer to b₁.",
            "in the middle": "Take i = 1, n = 3: the weights are i/(n + 1) and 1 - i/(n + 1).",
            "2/3 of the way from b₀": "That is the parabola's ratio. The denominator is the new degree.",
            "3/4 of the way from b₀": "Yes: c₁ = 1/4 b₀ + 3/4 b₁.",
        },
        "3/4 of the way from b₀",
    ),
    "elevation/which-is-it": Choice(
        "Here the weights depend on t: Bᵢ,ₙ = (1 - t) Bᵢ,ₙ₋₁ + t Bᵢ₋₁,ₙ₋₁. Is this elevation?",
        {
            "yes: it leads from degree n - 1 to n": "Both sides are one function of degree n. Elevation writes a "
            "function of low degree with functions of high degree, and with numbers.",
            "no: it is the recursion": "Yes: the recursion has t in its weights and makes new functions. Elevation has "
            "numbers and makes nothing new.",
        },
        "no: it is the recursion",
    ),
    "elevation/crossings": Choice(
        "A line crosses the polygon of a cubic 3 times, at no vertex. How often can it cross the elevated polygon?",
        {
            "3 or 1 times": "Yes: cutting a corner can take two crossings away, and never one alone.",
            "3, 2, 1 or 0 times": "Both polygons have the same ends. Are they on the same side of the line?",
            "up to 4 times: it has an edge more": "At a cut corner: can a line pass the cut and miss both old edges?",
        },
        "3 or 1 times",
    ),
    "elevation/rate": Choice(
        "You double the degree again and again. What is left of the distance each time, in the long run?",
        {
            "all of it": "The new points are means of the old ones; look at the pictures again.",
            "1/2": "Yes: the distance falls like 1 over the degree.",
            "1/4": "That is halving the pieces. Elevation is slower.",
        },
        "1/2",
    ),
    "elevation/when-down": Choice(
        "Which cubics can be written with three control points?",
        {
            "those with b₁ = b₂": "Try the heights 0, 1, 1, 1: their third difference is 1, so t³ is there.",
            "those with b₃ - 3b₂ + 3b₁ - b₀ = 0": "Yes: no term with t³, so the degree is 2 at most.",
            "those without an inflection point": "A parabola has none; but many cubics have none on [0, 1] either.",
            "all": "A cubic can have an inflection point. Can a parabola?",
        },
        "those with b₃ - 3b₂ + 3b₁ - b₀ = 0",
    ),
    "elevation/dropping": Choice(
        "To make a parabola of a cubic, somebody drops its term with t³. Where is the error largest on [0, 1]?",
        {
            "at t = 0": "There t³ is 0: nothing is lost.",
            "in the middle": "The error is a multiple of t³. Where is t³ largest?",
            "at t = 1": "Yes: t³ grows up to 1. All the error is at one end.",
        },
        "at t = 1",
    ),
    "elevation/exercise-elevate": Entry(
        "Exercise 1. The parabola (0, 0) (3, 3) (6, 0), written with four control points:",
        lambda: elevate(HILL),
        _hill_elevated,
        "(0, 0) (1, 2) (2, 1) (3, 3)",
    ),
    "elevation/exercise-edge": Entry(
        "Exercise 2. In a quartic (degree 4), b₁ = (0, 5) and b₂ = (10, 0). Written with degree 5, where is the new "
        "point on the edge b₁b₂?",
        lambda: elevate([(0, 0), (0, 5), (10, 0), (0, 0), (0, 0)])[2],
        _edge_point,
        "(1, 2)",
    ),
    "elevation/exercise-distance": Entry(
        "Exercise 3. The polygon of a parabola is 1 away from it. How far is its polygon of degree 10?",
        lambda: F(float(polygon_gap(elevate([F(0), F(2), F(0)], 8)))).limit_denominator(1000),
        lambda: [
            (F(1, 5), "Five times the degree leaves about a fifth. For parabolas section 4 has an exact rule."),
            (F(1, 81), "The square belongs to halving."),
            (F(1, 8), "The degree was raised eight times, that is right. But the rule counts the degree itself."),
        ],
        "2/3",
    ),
    "elevation/exercise-degree": Entry(
        "Exercise 4. The heights 1, 2, 4, 7, 11 are written with degree 4. Which degree has the polynomial?",
        lambda: max(k for k, c in enumerate(to_power(STEADY)) if c),
        lambda: [
            (4, "It is written with degree 4. Take differences: 1, 2, 3, 4, and again."),
            (3, "The fourth difference is 0. Look at the third one."),
            (1, "The steps 1, 2, 3, 4 are not equal: it is no straight line."),
            (5, "That is the number of the heights, the order."),
        ],
        "7",
    ),
    "elevation/exercise-lower": Entry(
        "Exercise 5. The cubic (0, 0) (2, 4) (5, 5) (9, 3) is a parabola. Its three control points:",
        lambda: lower(SECRET),
        lambda: [
            (
                [(0, 0), (F(7, 2), F(9, 2)), (9, 3)],
                "You took the middle of b₁ and b₂. c₁ lies on the prolonged edge b₀b₁.",
            ),
            ([(0, 0), (4, 8), (9, 3)], "You doubled the edge b₀b₁. It was two thirds of the way, so add one half."),
            (lower(SECRET)[::-1], "The right points, from the end to the beginning."),
            (SECRET[:3], "These are the first three of the four. Only the ends stay what they are."),
        ],
        "(0, 0) (1, 2) (2, 1)",
    ),
    "elevation/exercise-missing": Entry(
        "Exercise 6. A cubic has the heights 1, 5, x, 4. For which x has it degree 2?",
        lambda: F(4 + 3 * 5 - 1, 3),
        lambda: [
            (9, "Equal steps 1, 5, 9 would go on to 13. The last height has to fit, too."),
            (F(20, 3), "Check the signs of the third difference: 1, -3, 3, -1."),
            (F(9, 2), "This makes the last second difference 0. Which difference belongs to t³?"),
        ],
        "1/2",
    ),
    "elevation/exercise-nearest": Entry(
        "Exercise 7. The cubic with the heights 0, 0, 0, 1 is t³. The three heights of the parabola nearest to it:",
        lambda: lower(CUBE),
        _lowered_cube,
        "1, 2, 3",
    ),
}


def _changes(points, line):
    """How often a polygon passes a line: the sign changes of its vertices, zeros left out."""
    (x0, y0), (x1, y1) = line
    sides = [(x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) for x, y in points]
    return sign_changes(sides)


GOALS = {
    "elevation/parabola": Goal(
        "Task: move b₂, and no other point, so that the cubic is a parabola.",
        lambda state: all_but(2, state, TASK) and not to_power(state.points)[-1].any(),
        "Reached. Prolong the edges b₀b₁ and b₃b₂ by half their length: where do they end?",
    ),
    "elevation/cut-off": Goal(
        "Task: leave the control points (Reset puts them back), and move the line so that it passes the polygon three "
        "times and the elevated polygon only once.",
        lambda state: (
            state.points == CUBIC
            and (_changes(CUBIC, state.line), _changes(elevate(CUBIC, state.raised), state.line)) == (3, 1)
        ),
        "Reached: the corners that the line passed are cut off. Can a line do it the other way round?",
    ),
}
