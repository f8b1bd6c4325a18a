"""The questions of the lesson on derivatives and the hodograph; the sources' numbers, or small ones."""

from fractions import Fraction as F

from ..examples import EXAMPLES
from ..numeric import curvature, de_casteljau, derivative, hodograph
from .asking import Choice, Entry, Goal

CURVE = ((0, 0), (1, 2), (3, 2), (3, 0))  # its hodograph runs through all directions from up to down
CUBIC = EXAMPLES["deck/split"].given["points"]
ARCH = EXAMPLES["deck/segment"].given["points"]
PARABOLA = EXAMPLES["games/quadratic"].given["points"]
BENT = ((0, 0), (2, 0), (3, 3), (9, 9))


def _parabola_end():
    end = derivative(PARABOLA, 1)
    return [
        (-end, "This arrow points back along the last edge. In which direction does the curve run at its end?"),
        (end / F(2), "This is the edge itself. The velocity is longer."),
        (end * F(3, 2), "You multiplied by the number of points; the factor is the degree."),
        (derivative(PARABOLA, 0), "This is the velocity at the start."),
    ]


def _arch_second():
    second = derivative(ARCH, 1, 2)
    return [
        (-second, "The other sign. The second difference is b₃ - 2 b₂ + b₁, at the end as well."),
        (second / F(6), "This is the second difference. Its factor is missing."),
        (second / F(2), "The factor is not n but n (n - 1): two derivatives, two factors."),
        (second * F(3, 2), "The factor is not n². The first derivative has the degree n - 1."),
    ]


def _cubic_hodograph():
    points = hodograph(CUBIC)
    return [
        (points / F(3), "These are the edges. The derivative has a factor before them."),
        (-points, "All vectors point backwards: the difference is the next point minus this one."),
        (points[::-1], "The right vectors, last one first: the hodograph begins where t = 0."),
        (points * F(4, 3), "You multiplied by the number of points; the factor is the degree."),
    ]


def _first_from_triangle():
    first = derivative(CUBIC, F(1, 3))
    return [
        (first / F(3), "This is the difference of the two points. Its factor is missing."),
        (-first, "The first point minus the second one: the other way round."),
        (first * F(2, 3), "The factor is the degree of the curve, not the number of the level."),
    ]


def _second_from_triangle():
    second = derivative(CUBIC, F(1, 3), 2)
    start, _, end = de_casteljau(CUBIC, F(1, 3))[1]
    return [
        (second / F(6), "This is the second difference. Its factor is missing."),
        (second / F(2), "The factor of a second derivative has two parts."),
        (6 * (end - start), "You left the middle point out: it enters with the weight -2."),
    ]


QUESTIONS = {
    "derivatives/before-basis": Choice(
        "What is the derivative of the Bernstein function B₁,₃?",
        {
            "3 (B₀,₂ - B₁,₂)": "Yes: n times the left neighbour minus the right one, one degree lower.",
            "3 (B₁,₂ - B₀,₂)": "At t = 0 the function B₁,₃ rises. Which sign has this at t = 0?",
            "B₀,₂ - B₁,₂": "At t = 0 this is 1. How steeply does 3t(1 - t)² begin?",
        },
        "3 (B₀,₂ - B₁,₂)",
    ),
    "derivatives/before-difference": Choice(
        "Which operator takes b₁ to b₃ - b₂?",
        {
            "E - 1": "This takes b₁ to b₂ - b₁, one edge too early.",
            "E² - 1": "This takes b₁ to b₃ - b₁: two edges in one.",
            "E² - E": "Yes: E (E - 1), first the difference, then one place on.",
        },
        "E² - E",
    ),
    "derivatives/how-many-points": Choice(
        "A cubic has four control points. How many has its hodograph?",
        {
            "2": "The slides print n - 1, and that is 2. Count the edges of the polygon.",
            "3": "Yes: n edges, n points, and so the degree n - 1.",
            "4": "Each control point of the hodograph needs an edge. Count the edges.",
        },
        "3",
    ),
    "derivatives/moved": Choice(
        "Now the whole curve is moved by (10, 5). What happens to its hodograph?",
        {
            "it moves by (10, 5)": "Points move. Does the arrow from one point to the next change?",
            "it moves by (30, 15)": "The factor 3 is before the edges. Do the edges change?",
            "nothing": "Yes: its control points are differences, and a shift leaves them as they are.",
        },
        "nothing",
    ),
    "derivatives/renamed": Choice(
        "How does line 4 follow from line 3?",
        {
            "the first sum loses a term": "Write both sums out for n = 2: they have the same terms.",
            "j is renamed: j + 1 in the place of j": "Yes: now both sums have the same functions and can be joined.",
            "bⱼ₊₁ = bⱼ is used": "That would make all control points one.",
        },
        "j is renamed: j + 1 in the place of j",
    ),
    "derivatives/third": Choice(
        "What is the hodograph of order 3 of a cubic?",
        {
            "0": "That is the next one. The degree falls by one with each derivative: 3, 2, 1, ...",
            "one vector": "Yes: degree 0, the same vector for every t.",
            "a straight line": "That is the one of order 2: it has degree 1.",
        },
        "one vector",
    ),
    "derivatives/end-sign": Choice(
        "The last edge of our cubic runs from (3, 2) to (3, 0). What is p'(1)?",
        {
            "(0, -2)": "This is the edge. Is the end tangent as long as the edge?",
            "(0, 6)": "This arrow points up. Does the curve run up at its end?",
            "(0, -6)": "Yes: 3 times the last edge, in the direction in which the curve runs.",
            "(0, 2)": "This arrow points up, and it is only as long as the edge.",
        },
        "(0, -6)",
    ),
    "derivatives/reversed": Choice(
        "Run the curve backwards: q(s) = p(1 - s). What is its second derivative q''(0)?",
        {
            "p''(1)": "Yes: each derivative brings a factor -1, and two of them cancel.",
            "-p''(1)": "One derivative changes the sign. What do two of them do?",
            "p''(0)": "q starts where p ends.",
        },
        "p''(1)",
    ),
    "derivatives/weights": Choice(
        "The slides give b₀, b₁, b₂, b₃ the weights 1, 3, -3, 1 in p'''. Which test do these weights fail?",
        {
            "their sum must be 0": "Yes: else the derivative would change when the whole curve is moved.",
            "their sum must be 1": "That is the test for a point of the curve. A derivative is a vector.",
            "they must read the same from both ends": "This happens to even orders only: think of -1, 1 for p'.",
        },
        "their sum must be 0",
    ),
    "derivatives/not-involved": Choice(
        "Which control point of a cubic has no influence on its curvature at t = 0?",
        {
            "b₀": "It is an end of the first edge.",
            "b₂": "It enters the second derivative at 0.",
            "b₃": "Yes: first and second derivative at 0 need the first three points only.",
            "each has": "Write p'(0) and p''(0) down: which points enter?",
        },
        "b₃",
    ),
    "derivatives/scaled": Choice(
        "Make the whole curve twice as large. What happens to its curvature?",
        {
            "it doubles": "Think of a circle: does a large one bend more than a small one?",
            "it stays": "The shape stays, but think of the circle that touches the curve: its radius does not stay.",
            "it halves": "Yes: area times 4, cube of the length times 8.",
        },
        "it halves",
    ),
    "derivatives/at-a-cusp": Choice(
        "At a cusp (尖点) the curve turns back on itself. Where is the hodograph at that moment?",
        {
            "at the origin": "Yes: to turn back, the velocity must pass through zero.",
            "it has a gap": "The hodograph is a polynomial curve: it has no gaps.",
            "far away": "A long arrow is a high speed. Is the point fast when it turns back?",
        },
        "at the origin",
    ),
    "derivatives/exercise-end": Entry(
        "Exercise 1. The quadratic (0, 1) (1, 1) (0, 2): the vector p'(1).",
        lambda: derivative(PARABOLA, 1),
        _parabola_end,
        "(1, 2)",
    ),
    "derivatives/exercise-from-velocity": Entry(
        "Exercise 2. A cubic starts at (1, 1) with the velocity (6, -3). Where is b₁?",
        lambda: tuple(place + F(speed, 3) for place, speed in zip((1, 1), (6, -3), strict=True)),
        lambda: [
            ((7, -2), "You went the whole velocity. It is longer than the edge."),
            ((2, -1), "This is the edge, a vector. Where does it lead from b₀?"),
            ((-1, 2), "You went backwards."),
            ((4, F(-1, 2)), "You went half of the velocity. Which degree has a cubic?"),
        ],
        "(0, 1)",
    ),
    "derivatives/exercise-second-end": Entry(
        "Exercise 3. The cubic (-9, 0) (-3, 6) (3, 6) (9, 0): the vector p''(1).",
        lambda: derivative(ARCH, 1, 2),
        _arch_second,
        "(1, 2)",
    ),
    "derivatives/exercise-hodograph": Entry(
        "Exercise 4. The control points of the hodograph of (0, 0) (1, 3) (2, 1) (3, 3):",
        lambda: hodograph(CUBIC),
        _cubic_hodograph,
        "(0, 0) (1, 2) (2, 1)",
    ),
    "derivatives/exercise-from-triangle": Entry(
        "Exercise 5. For the same cubic at t = 1/3, level 2 of the triangle is (2/3, 13/9), (5/3, 19/9). "
        "The vector p'(1/3):",
        lambda: derivative(CUBIC, F(1, 3)),
        _first_from_triangle,
        "(1, 2)",
    ),
    "derivatives/exercise-second-from-triangle": Entry(
        "Exercise 6. Level 1 is (1/3, 1), (4/3, 7/3), (7/3, 5/3). The vector p''(1/3):",
        lambda: derivative(CUBIC, F(1, 3), 2),
        _second_from_triangle,
        "(1, 2)",
    ),
    "derivatives/exercise-curvature": Entry(
        "Exercise 7. The cubic (0, 0) (2, 0) (3, 3) (9, 9): its curvature at t = 0, positive where it turns left.",
        lambda: F(float(curvature(BENT, 0))),
        lambda: [
            (F(3, 4), "The factor (n - 1)/n is missing."),
            (F(1, 4), "You took the triangle; the cross product is the whole parallelogram."),
            (1, "The length of the first edge enters with its cube, not its square."),
            (F(-1, 2), "The curve turns left: first edge times second edge, in this order."),
        ],
        "2/3",
    ),
}


def _only_moved(state, place):
    """Whether no control point but the one at ``place`` differs from the lesson's cubic, and that one does."""
    return [i for i, (now, then) in enumerate(zip(state.points, CURVE, strict=True)) if now != then] == [place]


def _turn(points):
    """The cross product of the first two edges, signed."""
    (x0, y0), (x1, y1), (x2, y2) = points[:3]
    return (x1 - x0) * (y2 - y1) - (y1 - y0) * (x2 - x1)


def _same_count(state):
    return len(state.points) == len(CURVE)


def _cusp(state):
    """The ends are the lesson's, and at t = 1/2 the velocity is 0 and the second derivative is not."""
    if not _same_count(state) or (state.points[0], state.points[-1]) != (CURVE[0], CURVE[-1]):
        return False
    first, second = (derivative(state.points, F(1, 2), r) for r in (1, 2))
    return not first.any() and bool(second.any())


GOALS = {
    "derivatives/straight-start": Goal(
        "Task: move b₂, and no other point, so that the curvature at t = 0 vanishes.",
        lambda state: _same_count(state) and _only_moved(state, 2) and _turn(state.points) == 0,
        "Reached: the three points next to the start lie on one line. Is the curve straight now?",
    ),
    "derivatives/same-circle": Goal(
        "Task: move b₂, and no other point, to another place; the circle at t = 0 must stay as it is.",
        lambda state: _same_count(state) and _only_moved(state, 2) and _turn(state.points) == _turn(CURVE),
        "Reached: the circle has not changed, the curve has. On which line may b₂ move?",
    ),
    "derivatives/cusp": Goal(
        "Task: move b₁ and b₂, but not the ends, so that the curve has a cusp at t = 1/2.",
        _cusp,
        "Reached: the hodograph runs through the origin. Which vector is b₁ - b₂, and why?",
    ),
}
