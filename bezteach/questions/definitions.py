"""The questions of the lesson on Bézier's definition and Forrest's."""

from fractions import Fraction as F

import numpy as np

from ..examples import EXAMPLES
from ..numeric import bernstein, from_power, to_power
from .asking import Choice, Entry, Goal

ARCH = EXAMPLES["deck/segment"].given["points"]
POLYGON = ((0, 0), (1, 2), (3, 3), (4, 0))
START, EDGES = (1, 1), ((2, 0), (0, 3))
NUMBERS = (1, 3, 2)
POWERS = (2, 3, -1)


def _edges(points):
    return np.diff(np.array(points, dtype=object), axis=0)


def _vertices():
    return np.cumsum(np.array((START, *EDGES), dtype=object), axis=0)


def _differences(numbers):
    """The first number and the differences at it, without the binomial coefficients."""
    return [np.diff(np.array(numbers, dtype=object), r)[0] for r in range(len(numbers))]


QUESTIONS = {
    "definitions/before-count": Choice(
        "A Bézier curve of degree 3 has how many control points?",
        {
            "2": "With two points there is a straight line.",
            "3": "Degree and number of points are not the same: a line, of degree 1, has two.",
            "4": "Yes: one more than the degree.",
        },
        "4",
    ),
    "definitions/before-sum": Choice(
        "What is (t + (1 - t))³ for every t?",
        {
            "1": "Yes. Keep it in mind: this lesson multiplies it out.",
            "t³ + (1 - t)³": "A power of a sum has terms in the middle too.",
            "it depends on t": "Look into the bracket before you take the power.",
        },
        "1",
    ),
    "definitions/which-is-no-edge": Choice(
        "Bézier's polygon is given by a₀, a₁, a₂, a₃. Which of them is no edge of the polygon?",
        {
            "a₀": "Yes: a₀ leads from the origin to the first point. It is a position, the others are ways.",
            "a₃": "The last edge ends where the curve ends, but an edge it is.",
            "none: a polygon has four edges": "A cubic's polygon has four points. How many ways lie between them?",
        },
        "a₀",
    ),
    "definitions/which-functions-move": Choice(
        "You change a₂ and keep a₀, a₁, a₃. Which vertices of the polygon move?",
        {
            "b₂ only": "Then the edge to b₃ would change too; but a₃ is kept.",
            "b₂ and b₃": "Yes: all that comes after the edge goes along.",
            "all of them": "b₀ and b₁ are reached before the edge a₂.",
        },
        "b₂ and b₃",
    ),
    "definitions/sum": Choice(
        "The four values of the cubic Bernstein functions at t = 1/3 are added. What comes out?",
        {
            "1/3": "That is the parameter. Think of (t + (1 - t))³.",
            "1": "Yes, and it does so at every t.",
            "4/3": "That would be four times 1/3; the functions are not equal.",
        },
        "1",
    ),
    "definitions/row": Choice(
        "The row -3  3  0  0 of the matrix says what stands before t. What is that, for the curve?",
        {
            "the way from b₀ to b₁": "Almost: count the factor.",
            "three times the way from b₀ to b₁": "Yes: 3 (b₁ - b₀), the velocity at the start.",
            "the point at t = 1/3": "A row of the matrix knows no t: it multiplies a power of t.",
        },
        "three times the way from b₀ to b₁",
    ),
    "definitions/shift-all": Choice(
        "Every control point is moved by the same v. In Bézier's form, what has to change?",
        {
            "every aᵢ, by v": "An edge is a difference of two points that both move by v.",
            "a₀ only": "Yes: the edges stay, the first position takes v.",
            "nothing": "Then the curve would not move at all.",
        },
        "a₀ only",
    ),
    "definitions/exercise-vectors": Entry(
        "Exercise 1. The control points are (0, 0) (1, 2) (3, 3) (4, 0). Which are the edges a₁, a₂, a₃?",
        lambda: _edges(POLYGON),
        lambda: [
            (-_edges(POLYGON), "The signs: an edge leads from a point to the next, so the next one comes first."),
            (POLYGON[1:], "These are points. An edge is the difference of two."),
            ((POLYGON[0], *_edges(POLYGON)), "a₀ is not asked for: it is no edge."),
        ],
        "(1, 0) (0, 1) (2, 2)",
    ),
    "definitions/exercise-points": Entry(
        "Exercise 2. a₀ = (1, 1), a₁ = (2, 0), a₂ = (0, 3). Which are the control points?",
        _vertices,
        lambda: [
            ((START, *EDGES), "These are the vectors as given. Lay them end to end."),
            (_vertices() - START, "Your polygon starts at the origin. What is a₀ for?"),
        ],
        "(1, 0) (0, 1) (2, 2)",
    ),
    "definitions/exercise-value": Entry(
        "Exercise 3. What is B₂,₄(1/3), the function number 2 of degree 4 at t = 1/3?",
        lambda: bernstein(4, F(1, 3))[2],
        lambda: [
            (bernstein(4, F(1, 3))[2] / 6, "The powers are right; the binomial coefficient is missing."),
            (bernstein(4, F(1, 3))[1], "That is function number 1: they are counted from 0."),
            (bernstein(4, F(1, 3))[3], "That is function number 3."),
            (bernstein(3, F(1, 3))[2], "That is of degree 3."),
        ],
        "3/16",
    ),
    "definitions/exercise-to-powers": Entry(
        "Exercise 4. The control points 1, 3, 2 (numbers) give a parabola. What stands before 1, t, t²?",
        lambda: to_power(NUMBERS),
        lambda: [
            (to_power(NUMBERS)[::-1], "The right numbers, the highest power first. Asked is the order 1, t, t²."),
            (_differences(NUMBERS), "The differences are right. Each power has a binomial coefficient before it."),
            (NUMBERS, "These are the control points. Multiply by the matrix of degree 2."),
        ],
        "2, 0, 5",
    ),
    "definitions/exercise-from-powers": Entry(
        "Exercise 5. Which control points (numbers) has the parabola 2 + 3t - t²?",
        lambda: from_power(POWERS),
        lambda: [
            (POWERS, "These are the coefficients. Control points stand over t = 0, 1/2 and 1."),
            ((2, 5, 4), "t is not 0, 1, 1 in the Bernstein basis: its middle control point lies halfway."),
            ((2, F(13, 4), 4), "The middle control point is not the point of the curve at t = 1/2."),
        ],
        "1, 5/2, 3",
    ),
}

GOALS = {
    "definitions/closed": Goal(
        "Task: make the edges a₁ + a₂ + a₃ add up to nothing, without any two neighbouring points in one place.",
        lambda state: (
            len(state.points) == 4
            and state.points[0] == state.points[-1]
            and all(p != q for p, q in zip(state.points, state.points[1:], strict=False))
        ),
        "Reached: the curve is closed, b₃ = b₀. Is it smooth there? Look at the directions of a₁ and a₃.",
    ),
}
