"""The questions of the lesson on splitting; the numbers are the sources' examples, or close to them."""

from fractions import Fraction as F

from ..examples import EXAMPLES
from ..numeric import segment, split
from .asking import Choice, Entry, Goal

CUBIC = EXAMPLES["deck/split"].given["points"]
ARCH = EXAMPLES["deck/segment"].given["points"]
PARABOLA = EXAMPLES["games/quadratic"].given["points"]


def _cubic_left():
    left, right = split(CUBIC, F(1, 4))
    return [
        (left[::-1], "These are the right points, last one first: a curve begins where t = 0."),
        (right, "These are the control points of the other half."),
        (
            right[::-1],
            "You read the last point of each level: these are the other half's control points, from its end.",
        ),
        (split(CUBIC, F(3, 4))[0], "You cut at 3/4: the weight of the second point is t, that of the first is 1 - t."),
    ]


def _parabola_right():
    left, right = split(PARABOLA, F(1, 3))
    return [
        (
            right[::-1],
            "The right points, but from the end of the curve to the cut: read the last row backwards.",
        ),
        (left, "These are the control points of the left half."),
        (
            split(PARABOLA, F(2, 3))[1],
            "You cut at 2/3: the weight of the second point is t, that of the first is 1 - t.",
        ),
    ]


def _arch_part():
    part = segment(ARCH, F(1, 3), F(2, 3))
    front = split(ARCH, F(2, 3))[0]
    return [
        (part[::-1], "The right points, backwards: the part runs from 1/3 to 2/3."),
        (
            split(front, F(1, 3))[1],
            "Your second cut is at 1/3 of the front piece; the curve's t = 1/3 lies elsewhere on it.",
        ),
        (front, "This is the part from 0 to 2/3: one more cut."),
        (split(ARCH, F(1, 3))[1], "This is the part from 1/3 to 1: one more cut."),
    ]


QUESTIONS = {
    "splitting/before-weights": Choice(
        "At t = 1/4, de Casteljau's algorithm puts a point on the edge from b₀ to b₁. Where?",
        {
            "a quarter of the way from b₀": "Yes: (1 - t) b₀ + t b₁ with t = 1/4.",
            "three quarters of the way from b₀": "That is the way for t = 3/4: t is the weight of the second point.",
            "in the middle": "The middle belongs to t = 1/2.",
        },
        "a quarter of the way from b₀",
    ),
    "splitting/before-levels": Choice(
        "How many new points does the algorithm make for a cubic before it stops?",
        {
            "3": "Three levels, but the first has more than one point.",
            "4": "Four is the number of control points. Count the levels: each has one point less than the one before.",
            "6": "Yes: 3 + 2 + 1.",
            "10": "That counts the given points too.",
        },
        "6",
    ),
    "splitting/how-many-points": Choice(
        "A cubic is cut into two pieces. How many control points does each piece need?",
        {
            "2": "Two points make a straight line.",
            "3": "A piece of a cubic is a cubic still: its degree does not fall.",
            "4": "Yes: each piece is a cubic again. They share one point, so there are seven in all.",
        },
        "4",
    ),
    "splitting/where-is-half": Choice(
        "The cut at t = 1/2: does it halve the length of the curve?",
        {
            "always": "Think of a curve with its points b₀, b₁, b₂ crowded at one end.",
            "never": "A symmetric curve is cut in its middle.",
            "only by luck or symmetry": "Yes: t is a parameter, not a fraction of the length.",
        },
        "only by luck or symmetry",
    ),
    "splitting/right-half-order": Choice(
        "The right half's control points are the last points of the levels. In which order?",
        {
            "as the levels come: b₃ first": "Then the right half would begin at b₃, where the curve ends.",
            "backwards: the cut point first, b₃ last": "Yes: the right half begins at the cut.",
        },
        "backwards: the cut point first, b₃ last",
    ),
    "splitting/local-parameter": Choice(
        "You keep [0, 3/4] of a curve. At which parameter of this piece lies the old t = 1/4?",
        {
            "1/4": "The piece has a parameter of its own: it is 1 where the curve had 3/4.",
            "1/3": "Yes: a quarter is a third of three quarters.",
            "3/16": "That is 1/4 times 3/4. The piece's parameter runs faster, not slower.",
            "1/2": "Half of the piece is the old t = 3/8.",
        },
        "1/3",
    ),
    "splitting/other-order": Choice(
        "Now you cut the front away first and keep [1/4, 1]. At which parameter of this piece lies the old t = 3/4?",
        {
            "3/4": "The piece has a parameter of its own: 0 at the old 1/4, 1 at the old 1.",
            "1/3": "That is 1/4 over 3/4, for the other order. Measure from 1/4: how far is 3/4, how far is 1?",
            "2/3": "Yes: (3/4 - 1/4) / (1 - 1/4).",
            "1/2": "Half of the piece is the old t = 5/8.",
        },
        "2/3",
    ),
    "splitting/rate": Choice(
        "Each halving brings the polygons closer to the curve. By which factor, in the long run?",
        {
            "1/2": "The edges get half as long, but the distance falls faster.",
            "1/4": "Yes: second differences fall by 4, and they measure how far a polygon is from its curve.",
            "1/8": "That would be the rate for something of third order.",
        },
        "1/4",
    ),
    "splitting/exercise-cut-point": Entry(
        "Exercise 1. Where is the cubic (0,0) (1,3) (2,1) (3,3) cut at t = 1/2?",
        lambda: split(CUBIC, F(1, 2))[0][-1],
        lambda: [
            (
                (F(3, 2), F(7, 4)),
                "That is the mean of the four control points: the inner two weigh three times as much.",
            ),
            (
                (F(3, 2), 2),
                "That is the middle of the edge from b₁ to b₂, a point of the first level: two more levels.",
            ),
        ],
        "(1/2, 2)",
    ),
    "splitting/exercise-left-half": Entry(
        "Exercise 2. The control points of the left half of (0,0) (1,3) (2,1) (3,3) at t = 1/4:",
        lambda: split(CUBIC, F(1, 4))[0],
        _cubic_left,
        "(0, 0) (1/2, 2) (1, 1) (3, 3)",
    ),
    "splitting/exercise-right-half": Entry(
        "Exercise 3. The control points of the right half of the quadratic (0,1) (1,1) (0,2) at t = 1/3:",
        lambda: split(PARABOLA, F(1, 3))[1],
        _parabola_right,
        "(0, 1) (1/2, 2) (3, 3)",
    ),
    "splitting/exercise-local-parameter": Entry(
        "Exercise 4. You have the piece [1/5, 1]. At which parameter of it do you cut to keep [1/5, 3/5]?",
        lambda: F(1, 2),
        lambda: [
            (F(3, 5), "3/5 is the old parameter; the piece has its own, 0 at the old 1/5."),
            (F(1, 3), "That is (1/5) / (3/5), the number for the other order of cuts."),
            (F(2, 5), "2/5 is the length of what you keep. What part is it of the piece, which is 4/5 long?"),
        ],
        "1/4",
    ),
    "splitting/exercise-part": Entry(
        "Exercise 5. The control points of the part [1/3, 2/3] of (-9,0) (-3,6) (3,6) (9,0):",
        lambda: segment(ARCH, F(1, 3), F(2, 3)),
        _arch_part,
        "(0, 0) (1/2, 2) (1, 1) (3, 3)",
    ),
    "splitting/exercise-backwards": Choice(
        "Exercise 6. What are the control points of the part over [1, 0], from the end to the beginning?",
        {
            "those of the curve": "Then the part would begin at b₀; at parameter 1 the curve is at b_n.",
            "those of the curve, in reverse order": "Yes: the same curve, run backwards.",
            "all equal": "A part that is one point has equal ends: [a, a].",
        },
        "those of the curve, in reverse order",
    ),
}


def _middle_edge(state):
    """The way from the second to the third control point of a cubic's part over [a, b]."""
    part = segment(state.points, state.a, state.b)
    return tuple(part[2] - part[1])


GOALS = {
    "splitting/middle-edge": Goal(
        "Task: choose a and b so that the part's middle edge is horizontal and 2 long, from left to right.",
        lambda state: state.points == ARCH and _middle_edge(state) == (2, 0),
        "Reached. How are a and b related, and how does the length of the middle edge depend on them?",
    ),
}
