"""The questions of the tour: what a control point does, and a misprint found with small numbers."""

from fractions import Fraction as F

from ..numeric import evaluate
from .asking import Choice, Entry, Goal

PARABOLA = ((0, 0), (2, 4), (4, 0))


def _middle():
    return [
        ((2, 4), "This is the control point. The curve does not reach it."),
        ((2, 0), "This is the middle of the two ends. The control point above pulls the curve up."),
        ((2, F(4, 3)), "The mean of the three points, all with one weight: but the weights are 1/4, 1/2, 1/4."),
        ((2, 1), "Half of the height is right for a weight of 1/4. What weight has the middle point?"),
    ]


QUESTIONS = {
    "start/how-far": Choice(
        "You lift the control point b₁ by 2. By how much does the point of the curve at t = 1/2 rise?",
        {
            "by 2": "Then the whole weight would lie on b₁. Lift it, and look.",
            "by 1": "Yes: at t = 1/2 the weights of the three points are 1/4, 1/2, 1/4.",
            "not at all": "Only the two ends of the curve stay where they are.",
        },
        "by 1",
    ),
    "start/which-range": Choice(
        "The weights add up to 1 for t between 0 and 1. And for t = 2?",
        {
            "still 1": "Yes: the proof does not ask where t is. But some weights are negative there.",
            "more than 1": "Count the negative weights as well.",
            "less than 1": "Put t = 2 into the identity, and add.",
        },
        "still 1",
    ),
    "start/second-difference": Entry(
        "The second difference of p₀, p₁, p₂ is p₂ - 2 p₁ + p₀. What is it for the numbers 0, 1, 4?",
        lambda: F(2),
        lambda: [
            (-1, "You began with p₁, as the notes do. Which of the three comes first?"),
            (6, "The middle one is taken away, not added: the signs are 1, -2, 1."),
            (3, "You took the middle one once only."),
        ],
        "7",
    ),
    "start/exercise-middle": Entry(
        "Exercise 1. The curve with the control points (0, 0) (2, 4) (4, 0): its point at t = 1/2.",
        lambda: evaluate(PARABOLA, F(1, 2)),
        _middle,
        "(1, 2)",
    ),
    "start/exercise-verdict": Choice(
        "Exercise 2. A program has tried an identity for all degrees up to 8, exactly, and found no fault. It is",
        {
            "proved": "A fault may begin at degree 9. No list of cases reaches the end.",
            "checked": "Yes. Here that is another word, CHECKED, and it is never shown as a proof.",
            "refuted": "For that, one case would have to fail.",
        },
        "checked",
    ),
    "start/exercise-difference": Entry(
        "Exercise 3. The second difference of 1, 3, 9:",
        lambda: F(4),
        lambda: [
            (-2, "You began with the number in the middle. Begin with the last one."),
            (16, "The signs are 1, -2, 1."),
            (6, "This is the last first difference. Take the one before away from it."),
        ],
        "5",
    ),
}

GOALS = {
    "start/lift": Goal(
        "Task: move b₁ so that the point at t = 1/2 lies at (2, 3).",
        lambda state: state.t == F(1, 2) and tuple(evaluate(state.points, state.t)) == (2, 3),
        "Reached. Must b₁ stand where you put it?",
    ),
}
