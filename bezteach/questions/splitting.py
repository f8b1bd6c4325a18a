"""The questions of the lesson on splitting; the numbers are the sources' examples, or close to them."""

from fractions import Fraction as F

import numpy as np

from ..examples import EXAMPLES
from ..numeric import box, roots, segment, sign_changes, split, subdivide
from .asking import Choice, Entry, Goal

CUBIC = EXAMPLES["deck/split"].given["points"]
ARCH = EXAMPLES["deck/segment"].given["points"]
PARABOLA = EXAMPLES["games/quadratic"].given["points"]
HILL = ((0, 0), (2, 4), (4, -2))
TWO_ROOTS = (2, -3, 1)
RAILS = ((0, 0), (2, 2)), ((1, 0), (3, 2))  # parallel, and their boxes overlap


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


def _hill_top():
    """The greater height of the boxes of both halves."""
    return box(subdivide(HILL, 1))[:, 1, 1].max()


def _two_roots_left():
    left, right = split(TWO_ROOTS, F(1, 2))
    return [
        (right, "These are the heights of the right half."),
        (left[::-1], "The right numbers, from the cut to the start."),
        ((left[0], F(-1), left[-1]), "The inner height is the mean of the first two, not of the last two."),
        ((2, -3, left[-1]), "The polygon of the whole is no longer needed. Which number is between the first two?"),
    ]


def _rails_apart():
    """After how many halvings of both segments no box of the one meets a box of the other."""
    return next(k for k in range(9) if not any(_meet(p, q) for p in _boxes(0, k) for q in _boxes(1, k)))


def _boxes(which, depth):
    return box(subdivide(RAILS[which], depth))


def _meet(one, other):
    return (one[0] <= other[1]).all() and (other[0] <= one[1]).all()


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
    "splitting/finer": Choice(
        "The polyline shall be a hundred times closer to the curve. How many times as many pieces does it need?",
        {
            "2": "One halving leaves a quarter of the distance. A hundredth is much less.",
            "10": "Yes: the distance falls with the square of the number of pieces.",
            "100": "That many are needed if the distance falls like 1/N. It falls faster.",
        },
        "10",
    ),
    "splitting/box-top": Choice(
        "The parabola (0,0) (1,2) (2,0): its box reaches up to y = 2. How high does the curve reach?",
        {
            "to y = 2": "Only b₁ is that high, and the curve does not pass through b₁.",
            "to y = 1": "Yes: at t = 1/2, halfway up. The box is a bound, not the range itself.",
            "higher than y = 2": "Each point of the curve is an average of the control points.",
        },
        "to y = 1",
    ),
    "splitting/two-changes": Choice(
        "The heights 1, -1, 2 change their sign twice. How many roots are there between 0 and 1?",
        {
            "two": "Two is the most. The polygon dips under the axis; must the curve follow?",
            "one": "At both ends the polynomial is positive. It cannot pass the axis once only.",
            "two or none: the signs do not tell": "Yes: the changes, or fewer by an even number.",
            "none": "It may be so, but the signs alone do not tell: think of 1, -9, 2.",
        },
        "two or none: the signs do not tell",
    ),
    "splitting/boxes-overlap": Choice(
        "The boxes of two curves overlap. What follows?",
        {
            "the curves meet": "Draw a parabola and, above it but under b₁, a horizontal line.",
            "the curves do not meet": "Two segments that cross in their middle have overlapping boxes.",
            "nothing": "Yes: only boxes that are apart tell something. So halve, and look again.",
        },
        "nothing",
    ),
    "splitting/most-crossings": Choice(
        "A line meets a cubic at most three times. Two cubics, not parts of one curve, meet at most",
        {
            "3 times": "That is for a line. Bend it into a second cubic: it may come back for more.",
            "6 times": "Each bend brings the second cubic back to the first. Degrees are not added here.",
            "9 times": "Yes: the product of the degrees. This is Bézout's theorem; we do not prove it.",
        },
        "9 times",
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
    "splitting/exercise-box": Entry(
        "Exercise 9. The parabola (0,0) (2,4) (4,-2) is cut at t = 1/2, and each half gets a box. "
        "How high does the higher box reach?",
        _hill_top,
        lambda: [
            (4, "That is the box of the whole curve."),
            (
                split(HILL, F(1, 2))[0][-1][1],
                "That is the height of the cut. The left half has an inner control point.",
            ),
            (1, "That is the inner point of the right half. Look at all six control points."),
        ],
        "7/3",
    ),
    "splitting/exercise-left-heights": Entry(
        "Exercise 10. A polynomial has the heights 2, -3, 1. Cut it at t = 1/2: the heights of the left half.",
        lambda: split(TWO_ROOTS, F(1, 2))[0],
        _two_roots_left,
        "1, 2, 7/2",
    ),
    "splitting/exercise-count": Choice(
        "Exercise 11. The same polynomial, 2, -3, 1, and its right half too: what do the signs tell now?",
        {
            "there is no root": "Look at the ends of the left half: they have opposite signs.",
            "two roots or none": "So much the signs of the whole tell. Count the changes in each half.",
            "two roots, one in each half": "Yes: one change in each half, and at the cut it is not zero.",
            "two roots, both in the left half": "Count the changes in the right half too.",
        },
        "two roots, one in each half",
    ),
    "splitting/exercise-apart": Entry(
        "Exercise 12. Two parallel segments: (0,0) (2,2) and (1,0) (3,2). Both are halved, again and again. "
        "After how many halvings does no box of one touch a box of the other?",
        _rails_apart,
        lambda: [
            (0, "The two boxes are 2 wide, and one begins 1 further to the right."),
            (1, "Draw the four boxes: each is 1 wide. Two of them have an edge in common."),
            (2, "Now they have corners in common, and boxes that touch are not apart."),
        ],
        "7",
    ),
}


def _promised(state, depth):
    """The square of the bound n D / (8 4^depth) on the distance of polygons and curve: the ledger's limit/halving."""
    points = np.array(state.points, object)
    longest = max((bend @ bend for bend in np.diff(points, 2, axis=0)), default=0)
    return longest * F(len(points) - 1, 8 * 4**depth) ** 2


def _just_enough(state):
    """So many halvings promise a distance of at most 1/50, and one less does not."""
    return state.depth > 0 and _promised(state, state.depth) <= F(1, 50) ** 2 < _promised(state, state.depth - 1)


def _heights(state):
    """The heights of the control points over the board's line: the Bernstein coefficients of the curve's own height."""
    (x0, y0), (x1, y1) = state.line
    return [(x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) for x, y in state.points]


def _three_changes_one_root(state):
    """The polygon passes the line three times, the curve surely once only."""
    heights = _heights(state)
    return sign_changes(heights) == 3 and [root.certain for root in roots(heights)] == [True]


def _middle_edge(state):
    """The way from the second to the third control point of a cubic's part over [a, b]."""
    part = segment(state.points, state.a, state.b)
    return tuple(part[2] - part[1])


GOALS = {
    "splitting/middle-edge": Goal(
        "Task: leave the control points, and choose a and b so that the part's middle edge is horizontal and 2 long, "
        "from left to right.",
        lambda state: state.points == ARCH and _middle_edge(state) == (2, 0),
        "Reached. How are a and b related, and how does the length of the middle edge depend on them?",
    ),
    "splitting/just-enough": Goal(
        "Task: halve just often enough that the bound promises a distance of at most 1/50.",
        _just_enough,
        "Reached: one halving less is not enough. How many more does a polygon ten times as large need?",
    ),
    "splitting/three-changes-one-root": Goal(
        "Task: leave the line, and move the heights: the polygon must still pass the axis three times, the curve once "
        "only.",
        _three_changes_one_root,
        "Reached: three changes of sign, one root. Which numbers of roots are impossible with three changes?",
    ),
}
