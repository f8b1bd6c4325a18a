"""The questions of the lesson on de Casteljau's algorithm; most numbers are the sources' examples."""

from fractions import Fraction as F

from ..examples import EXAMPLES
from ..numeric import de_casteljau, evaluate
from .asking import Choice, Entry, Goal

CUBIC = EXAMPLES["deck/split"].given["points"]
PARABOLA = EXAMPLES["games/quadratic"].given["points"]
TENT = ((0, 0), (2, 4), (6, 2))
ZIGZAG = ((0, 0), (1, 4), (2, 0), (3, 4), (4, 0))
SWAPPED = "The weights are exchanged: t belongs to the second point, 1 - t to the first."


def _level(points, t, k):
    return de_casteljau(points, t)[k]


def _missing_level():
    middle = _level(CUBIC, F(2, 3), 1)
    return [
        (_level(middle, F(1, 3), 1), SWAPPED),
        (_level(middle, F(1, 2), 1), "These are the middles of the edges: that is t = 1/2."),
        (_level(CUBIC, F(1, 3), 2), "This is level 2 at t = 1/3. Go on from the level 1 above, at t = 2/3."),
        (_level(CUBIC, F(2, 3), 3)[0], "This is the point of the curve, one level too far."),
    ]


def _touching_point():
    ends = _level(TENT, F(3, 4), 1)
    return [
        (evaluate(TENT, F(1, 4)), SWAPPED),
        (sum(ends) / 2, "This is the middle of the tangent between the two edges. It touches there only for t = 1/2."),
        (ends[1], "This is where the tangent meets the other edge. The point of the curve lies between the edges."),
        (ends[0], "This is the given point on the edge; the parabola does not pass through it."),
    ]


QUESTIONS = {
    "casteljau/before-ratio": Choice(
        "The point c = 3/4 a + 1/4 b divides the segment from a to b. In which ratio, seen from a?",
        {
            "1 : 3": "Yes: a quarter of the way lies behind it, three quarters before it.",
            "3 : 1": "The larger weight belongs to the nearer point: c is close to a.",
            "1 : 4": "A quarter of the whole way. A ratio compares the two parts with each other.",
        },
        "1 : 3",
    ),
    "casteljau/before-recursion": Choice(
        "The recursion of the Bernstein functions: which mixture is B₁,₃?",
        {
            "(1 - t) B₁,₂ + t B₀,₂": "Yes: t raises the index by one, 1 - t leaves it.",
            "t B₁,₂ + (1 - t) B₀,₂": "Test it near t = 0: B₀,₂ is nearly 1 there, and B₁,₃ nearly 0.",
            "B₁,₂ + B₀,₂": "At t = 0 this is 1, and the degree has not risen.",
        },
        "(1 - t) B₁,₂ + t B₀,₂",
    ),
    "casteljau/touch": Choice(
        "The straight line through the two points of level 1: how does it meet the parabola?",
        {
            "it touches it": "Yes. Move t on the board below: this line rolls along the curve.",
            "it crosses it in two points": "Then a part of the line would lie inside the arch. Draw it for t = 1/2.",
            "it crosses it once, at an angle": "A line that cuts into this arch must come out again.",
        },
        "it touches it",
    ),
    "casteljau/ratio": Choice(
        "The points of level 1 divide their edges in the ratio t : (1 - t). In which ratio does the last point "
        "divide the segment between them?",
        {
            "t : (1 - t)": "Yes: the third step of the construction has the same weights as the first two.",
            "1 : 1": "That holds for t = 1/2 alone.",
            "t² : (1 - t)²": "These are the weights of b₂ and b₀ in the sum. Look at the last step.",
        },
        "t : (1 - t)",
    ),
    "casteljau/missing-level": Entry(
        "Your turn: the two points of level 2 at t = 2/3.",
        lambda: _level(CUBIC, F(2, 3), 2),
        _missing_level,
        "(1, 2) (5/3, 1)",
    ),
    "casteljau/path": Choice(
        "Let t run from 0 to 1. On which curve does b₁² move, the second point of level 2 of the cubic?",
        {
            "on the quadratic curve with the control points b₁, b₂, b₃": "Yes: only these three are mixed into it.",
            "on the quadratic curve with the control points b₀, b₁, b₂": "Those are mixed into its neighbour b₀². "
            "Follow the lines of the triangle back.",
            "on the line from b₁ to b₂": "That is the path of b₁¹, a level earlier.",
            "on the cubic": "Only the last point of the triangle moves on it.",
        },
        "on the quadratic curve with the control points b₁, b₂, b₃",
    ),
    "casteljau/fixed-weights": Choice(
        "Mix the two quadratic curves with fixed numbers: 2/3 of the first and 1/3 of the second, for all t. "
        "What comes out?",
        {
            "the same cubic": "At t = 0 it begins in 2/3 b₀ + 1/3 b₁. Where does the cubic begin?",
            "another cubic": "A fixed number times a quadratic polynomial is quadratic.",
            "a quadratic curve": "Yes: fixed numbers cannot raise the degree. The weights must move with t.",
        },
        "a quadratic curve",
    ),
    "casteljau/backwards": Choice(
        "Let the inner loop run backwards, from i = n - r down to 0. Is the result the same?",
        {
            "yes, each level is computed all the same": "Write down one round with three numbers. What is in b[i+1]?",
            "no: b[i+1] is of the new level already": "Yes. Forwards, each place is overwritten when it was used last.",
            "no: b[i] is overwritten before it is used": "The line reads b[i] before it writes it. Look at b[i+1].",
        },
        "no: b[i+1] is of the new level already",
    ),
    "casteljau/cost": Choice(
        "One coordinate of one point of a cubic: how many multiplications does this loop do?",
        {
            "3": "That is Horner's scheme for a cubic in the power basis.",
            "6": "There are 6 mixtures. How many multiplications are in one?",
            "12": "Yes: 3 + 2 + 1 mixtures with two multiplications each.",
            "9": "Three rounds, but not of equal length.",
        },
        "12",
    ),
    "casteljau/worst": Choice(
        "Degree 50, uneven heights between -3 and 3, t in [0, 1], 64-bit numbers. Which way gives the largest error?",
        {
            "de Casteljau: it does the most operations": "Each operation adds a little error. But what happens to it "
            "later: does it grow or is it averaged?",
            "the Bernstein sum: binomial coefficients are huge": "They are, but each is multiplied by small powers, "
            "and the products sum to 1. Which coefficients stay huge?",
            "the power basis with Horner: its coefficients are huge and alternate": "Yes: huge numbers of both signs, "
            "whose sum must be small. What cancels takes the correct digits with it.",
        },
        "the power basis with Horner: its coefficients are huge and alternate",
    ),
    "casteljau/outside": Choice(
        "At t = 2, where does the first step put the point on the line from b₀ to b₁?",
        {
            "at b₁, the end of the edge": "Nothing is clipped. Put t = 2 into (1 - t) b₀ + t b₁.",
            "beyond b₁, as far again": "Yes: -b₀ + 2 b₁. A negative weight: it is no average any more.",
            "beyond b₀": "That is for t < 0.",
            "nowhere, t must lie in [0, 1]": "The formula does not ask. It continues the line.",
        },
        "beyond b₁, as far again",
    ),
    "casteljau/limit": Choice(
        "A source says that the algorithm converges to the point of the curve. How many rounds does a cubic need, "
        "in exact numbers?",
        {
            "infinitely many: it is a limit": "How many points are left after each round?",
            "3": "Yes: then one point is left, and it is the exact one. No limit is taken.",
            "as many as the precision asks for": "That is so for repeated halving, not for this algorithm.",
        },
        "3",
    ),
    "casteljau/exercise-point": Entry(
        "Exercise 1. The point of the quadratic curve (0,1) (1,1) (0,2) at t = 1/4:",
        lambda: evaluate(PARABOLA, F(1, 4)),
        lambda: [
            (evaluate(PARABOLA, F(3, 4)), SWAPPED),
            (_level(PARABOLA, F(1, 4), 1)[0], "This is the first point of level 1: one more step."),
            (sum(_level(PARABOLA, F(1, 4), 1)) / 2, "You took the middle in the last step. It has the same t again."),
        ],
        "(1/2, 2)",
    ),
    "casteljau/exercise-level": Entry(
        "Exercise 2. Level 2 of the triangle of (0,0) (1,3) (2,1) (3,3) at t = 1/4:",
        lambda: _level(CUBIC, F(1, 4), 2),
        lambda: [
            (_level(CUBIC, F(3, 4), 2), SWAPPED),
            (_level(CUBIC, F(1, 4), 1), "This is level 1: one more round."),
            (_level(CUBIC, F(1, 4), 3)[0], "This is the point of the curve, one level too far."),
            (_level(CUBIC, F(1, 4), 2)[::-1], "The right points in the wrong order: b₀² comes first."),
        ],
        "(1, 1) (2, 3)",
    ),
    "casteljau/exercise-tangent": Entry(
        "Exercise 3. The parabola (0,0) (2,4) (6,2) has a tangent that meets its first edge in (3/2, 3). "
        "Where does it touch the parabola?",
        lambda: evaluate(TENT, F(3, 4)),
        _touching_point,
        "(2, 5/2)",
    ),
    "casteljau/exercise-path": Entry(
        "Exercise 4. The quartic (0,0) (1,4) (2,0) (3,4) (4,0): the control points of the curve on which b₁² moves:",
        lambda: ZIGZAG[1:4],
        lambda: [
            (ZIGZAG[:3], "These belong to b₀². The lower index says where to begin."),
            (ZIGZAG[1:], "These belong to b₁³. A point of level 2 moves on a curve of degree 2."),
            (ZIGZAG[2:], "These belong to b₂². The lower index says where to begin."),
            (ZIGZAG[1:3], "These belong to b₁¹. A point of level 2 moves on a curve of degree 2."),
        ],
        "(0, 0) (1, 1) (2, 0)",
    ),
    "casteljau/exercise-count": Entry(
        "Exercise 5. One point of a space curve of degree 6 by de Casteljau: how many multiplications, for all three "
        "coordinates?",
        lambda: 3 * 6 * 7,
        lambda: [
            (6 * 7, "That is one coordinate."),
            (3 * 21, "You counted mixtures. Each one takes two multiplications."),
            (21, "These are the mixtures of one coordinate."),
            (3 * 6, "That is Horner's scheme in the power basis."),
            (3 * 2 * 36, "Six rounds, but not of six mixtures each: the rounds get shorter."),
        ],
        "24",
    ),
    "casteljau/exercise-line": Choice(
        "Exercise 6. The heights 0, 1, 2, ..., 50, t in [0, 1]: here Horner's error stays below u. Why?",
        {
            "the heights are whole numbers": "The uneven heights were whole numbers too.",
            "no height is negative": "Add 3 to the uneven heights: none is negative, and Horner still fails.",
            "the power coefficients are 0, 50, 0, ..., 0": "Yes: the curve is 50 t, and nothing cancels.",
            "50 multiplications are too few to go wrong": "For the uneven heights they were enough to go wrong.",
        },
        "the power coefficients are 0, 50, 0, ..., 0",
    ),
}


def _level_tangent(state):
    first, last = de_casteljau(state.points, state.t)[1]
    return first[1] == last[1] and first[0] != last[0]


def _stands_still(state):
    first, last = de_casteljau(state.points, state.t)[1]
    return (first == last).all()


GOALS = {
    "casteljau/horizontal": Goal(
        "Task: leave the points, and move t until the middle one of the three tangents is horizontal.",
        lambda state: state.points == TENT and _level_tangent(state),
        "Reached. In which ratio does it divide the two edges? Where on it does the curve touch?",
    ),
    "casteljau/still": Goal(
        "Task: move b₂ alone, until at t = 1/2 both points of level 1 fall together.",
        lambda state: (
            len(state.points) == 3 and (state.points[:2], state.t) == (TENT[:2], F(1, 2)) and _stands_still(state)
        ),
        "Reached: the curve runs to the middle of b₀ b₁ and back. At t = 1/2 it stands still and turns: no tangent.",
    ),
}
