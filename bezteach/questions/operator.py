"""The questions of the lesson on the shift operator."""

from fractions import Fraction as F

import numpy as np

from ..examples import EXAMPLES
from ..numeric import de_casteljau
from .asking import Choice, Entry, Goal

CUBIC = EXAMPLES["deck/split"].given["points"]
NUMBERS = (2, 5, 1, 7)


def _difference(r, j):
    return np.diff(np.array(NUMBERS, dtype=object), r)[j]


def _level(t, k, j):
    return de_casteljau(NUMBERS, t)[k][j]


def _at_two_parameters():
    """Number 0 of level 2 where the first level is made at 1/2 and the second at 1/3."""
    first, second = de_casteljau(NUMBERS[:3], F(1, 2))[1]
    return first + (second - first) * F(1, 3)


QUESTIONS = {
    "operator/before-binomial": Choice(
        "(x + y)³ multiplied out: how often does the term x y² occur?",
        {
            "once": "x³ and y³ occur once. Here one of three factors gives the x: which one?",
            "twice": "That is the middle term of (x + y)².",
            "three times": "Yes: any of the three factors may be the one that gives x.",
        },
        "three times",
    ),
    "operator/before-step": Choice(
        "One step of de Casteljau's algorithm at t takes two neighbours, p and q, to",
        {
            "(1 - t) p + t q": "Yes, and the same for each pair of neighbours: this lesson lives on that.",
            "t p + (1 - t) q": "At t = 0 that would give q. The curve starts at the first point.",
            "(p + q)/2": "That is the step for one value of t only.",
        },
        "(1 - t) p + t q",
    ),
    "operator/difference": Entry(
        "The points are the numbers 2, 5, 1, 7. What is (E - 1) b₁?",
        lambda: _difference(1, 1),
        lambda: [
            (-_difference(1, 1), "E moves on: the next one comes first, and the 1 leaves b₁ where it is."),
            (_difference(1, 0), "That is (E - 1) b₀: the indices begin with 0."),
            (NUMBERS[2], "That is E b₁. The 1 in the bracket has something to take away."),
        ],
        "3",
    ),
    "operator/order": Choice(
        "A step at s, then one at t; or first at t and then at s. Is the point the same?",
        {
            "never, unless s = t": "Try it with three points: multiply the two steps out.",
            "always": "Yes: g(s) g(t) = g(t) g(s), because polynomials in E may be multiplied in any order.",
            "only on the curve's ends": "The steps do not know where they are. Multiply them out, both ways.",
        },
        "always",
    ),
    "operator/paths": Choice(
        "A cubic, level 2 of the triangle. While t runs from 0 to 1, its points draw",
        {
            "one curve of degree 2": "How many points are there on level 2? Each has a path of its own.",
            "two curves of degree 2": "Yes: number j of level k draws a curve of degree k, that of bⱼ, ..., bⱼ₊ₖ.",
            "two straight lines": "The points of level 1 do that: they run along the edges.",
            "two parts of the cubic": "Only the last level lies on the curve.",
        },
        "two curves of degree 2",
    ),
    "operator/derivative-of-step": Choice(
        "What is the derivative of the step g(t) = (1 - t) + t E?",
        {
            "0, for E is a constant": "E is a constant. But what is multiplied by it?",
            "E - 1": "Yes: the way from a point to the next. It does not depend on t.",
            "E": "The part 1 - t has a derivative too.",
            "1 - E": "Look at the signs: the part with E grows with t.",
        },
        "E - 1",
    ),
    "operator/reversed": Choice(
        "With the points in reverse order each shift goes back, and the step is R = (1 - t) + t E⁻¹. Then E R is",
        {
            "g(t)": "Multiply it out: which of the two, 1 or E, has the factor t?",
            "g(1 - t)": "Yes: (1 - t) E + t. The curve backwards is the curve at 1 - t, moved to its other end.",
            "1": "E undoes E⁻¹, but not the mixture.",
        },
        "g(1 - t)",
    ),
    "operator/exercise-first": Entry(
        "Exercise 1. The points are 2, 5, 1, 7. What is (E - 1)² b₀?",
        lambda: _difference(2, 0),
        lambda: [
            (_difference(1, 0), "That is the first difference: one E - 1 is left to do."),
            (_difference(1, 0) ** 2, "Not the square of the difference: E - 1 is done twice, to a list of numbers."),
            (_difference(2, 1), "That is (E - 1)² b₁."),
            (-_difference(2, 0), "The sign: E² - 2E + 1, and E moves on."),
        ],
        "3",
    ),
    "operator/exercise-step": Entry(
        "Exercise 2. The same points. What is g(1/2)² b₁?",
        lambda: _level(F(1, 2), 2, 1),
        lambda: [
            (_level(F(1, 2), 2, 0), "That is g(1/2)² b₀: begin one point later."),
            (_level(F(1, 2), 1, 1), "That is one step. Two are to be done."),
            (_level(F(1, 4), 1, 1), "Two steps at 1/2 are not one step at 1/4: multiply g(1/2) g(1/2) out."),
        ],
        "13/3",
    ),
    "operator/exercise-two-parameters": Entry(
        "Exercise 3. The same points. What is g(1/3) g(1/2) b₀?",
        _at_two_parameters,
        lambda: [
            (_level(F(1, 2), 2, 0), "Both of your steps were at 1/2."),
            (_level(F(1, 3), 2, 0), "Both of your steps were at 1/3."),
        ],
        "7/3",
    ),
    "operator/exercise-path": Entry(
        "Exercise 4. For the cubic (0, 0) (1, 3) (2, 1) (3, 3), number 1 of level 2 draws a parabola. "
        "Which control points has it?",
        lambda: CUBIC[1:],
        lambda: [
            (CUBIC[:3], "These belong to number 0 of level 2."),
            (CUBIC, "With four points it would be a cubic. How far does g(t)² look from where it begins?"),
            (
                CUBIC[1:3],
                "Two points make a line; g(t)² holds E².",
            ),
        ],
        "(0, 0) (1, 2) (2, 0)",
    ),
    "operator/exercise-quarter": Choice(
        "Exercise 5. Which of these is the same operator as g(1/2) g(1/2)?",
        {
            "g(1/4)": "That looks one point ahead at most; two steps look two points ahead.",
            "g(1)": "That is E. Parameters of steps are not added.",
            "1/4 + E/2 + E²/4": "Yes: the binomial theorem with both halves.",
            "1/2 + E²/2": "Where is the term in the middle?",
        },
        "1/4 + E/2 + E²/4",
    ),
}


def _evenly_spaced(state):
    edges = [
        tuple(b - a for a, b in zip(p, q, strict=True)) for p, q in zip(state.points, state.points[1:], strict=False)
    ]
    return len(state.points) == 4 and len(set(edges)) == 1 and any(edges[0])


GOALS = {
    "operator/no-second-difference": Goal(
        "Task: move the points so that (E - 1)² b₀ and (E - 1)² b₁ are both 0, and not all points are one.",
        _evenly_spaced,
        "Reached. The curve is a straight line, and its point runs along it evenly: nothing bends, nothing speeds up.",
    ),
}
