"""The questions of the lesson on joining curves; small numbers, the data chosen so that the chords divide by six."""

from fractions import Fraction as F

import numpy as np

from ..numeric import derivative
from ..numeric.joins import catmull_rom, continuity
from .asking import Choice, Entry, Goal, all_but

LEFT = ((0, 0), (0, 2), (2, 4), (4, 4))
CORNER = ((4, 4), (4, 2), (6, 0), (8, 2))
SLOW = ((4, 4), (5, 4), (7, 3), (8, 0))
FAST = ((4, 4), (8, 4), (10, 2), (8, 0))
EVEN = ((4, 4), (6, 4), (8, 3), (8, 0))
PARABOLA = ((0, 0), (3, 6), (9, 0))
DATA = ((0, 0), (2, 5), (6, 6), (8, -1), (12, 0), (14, 5), (18, 6))


def goes_on(left, length=1):
    """The first three control points with which a cubic over this length goes on with C2 after one over length 1."""
    left = np.array(left, dtype=object)
    inner = left[3] + length * (left[3] - left[2])
    tip = left[2] + length * (left[2] - left[1])
    return np.array([left[3], inner, inner + length * (inner - tip)])


def _next(length):
    """The wrong ways to prolong an edge: another length, backwards, the way instead of the place."""
    (x, y), (u, v) = LEFT[3], np.subtract(LEFT[3], LEFT[2])
    right = {length}
    ways = [
        (1, "This keeps the length of the edge. Does the parameter run equally long?"),
        (F(1, length), "The intervals the other way round: a longer interval needs a longer edge."),
        (length**2, "The velocity is divided by the length once. The square comes with the second derivative."),
        (3 * length, "This is the whole velocity. The edge is a third of it."),
        (-length, "Here the curve would turn back."),
    ]
    found = [((x + s * u, y + s * v), said) for s, said in ways if s not in right]
    return [*found, ((length * u, length * v), "This is the edge, a vector. Where does it lead from b₃?")]


def _second():
    _, inner, _ = goes_on(LEFT)
    before = np.array(LEFT[1], dtype=object)
    return [
        (2 * inner - LEFT[3], "All in one line: then the second derivative is 0 on the right. Is it 0 on the left?"),
        (2 * inner - np.array(LEFT[2]), "Find the tip first: prolong b₁ b₂ by its own length."),
        (before, "This is a place on the left. C2 prolongs the curve."),
        (2 * np.array(LEFT[2]) - before, "This is the tip of the frame. One leg comes down from there to b₅."),
        ((7, 3), "The leg runs from the tip to b₄, and on. How much farther, for equal intervals?"),
    ]


def _beside():
    """The control point after D_1, by wrong rules."""
    d0, d1, d2 = (np.array(DATA[i], dtype=object) for i in (0, 1, 2))
    chord = d2 - d0
    return [
        (d1 - chord / F(6), "On the other side of D₁: the curve arrives through this one."),
        (d1 + chord / F(3), "You took a third of the chord. That would be the velocity of the whole chord."),
        (d1 + (d2 - d1) / F(6), "The chord joins the two neighbours of D₁; D₁ is not on it."),
        (d1 + (d2 - d1) / F(3), "This is a third of the way to D₂: then every piece is straight."),
        (chord / F(6), "This is the way. Where does it lead from D₁?"),
    ]


def _pieces():
    cubics = catmull_rom(DATA)
    return [
        (cubics[3], "This is the piece after this one: it starts in D₃."),
        (cubics[1], "This is the piece before this one: it ends in D₂."),
        (cubics[2][::-1], "The right points, last one first."),
    ]


QUESTIONS = {
    "joining/before-velocity": Entry(
        "A cubic ends with the points (2, 4), (4, 4). Its velocity p'(1)?",
        lambda: derivative(LEFT, 1),
        lambda: [
            ((2, 0), "This is the edge. Is the end tangent as long as the edge?"),
            ((-6, 0), "This points back. In which direction does the curve run at its end?"),
            ((8, 0), "You multiplied by the number of points; the factor is the degree."),
        ],
        "(1, 2)",
    ),
    "joining/before-second": Choice(
        "On which control points of a cubic does p''(1) depend?",
        {
            "b₂, b₃": "These two give the first derivative.",
            "b₁, b₂, b₃": "Yes: r + 1 points for the r-th derivative at an end.",
            "all four": "The farther from the end, the more derivatives do not see a point. How many see b₀?",
        },
        "b₁, b₂, b₃",
    ),
    "joining/degree": Choice(
        "A font designer needs 31 control points. One Bézier curve with all of them: what is its degree, and how "
        "much of it moves when one inner point moves?",
        {
            "31, and all of it": "Count the edges of a polygon with 31 points.",
            "30, and all of it": "Yes. Degree 30 is not what anyone wants to compute with, or to steer.",
            "30, and the part near the point": "Each basis function is positive between 0 and 1. Where is it zero?",
        },
        "30, and all of it",
    ),
    "joining/where": Entry(
        "The left cubic is (0, 0) (0, 2) (2, 4) (4, 4), and both run on intervals of length 1. "
        "Where must b₄ lie, so that the velocity does not jump?",
        lambda: goes_on(LEFT)[1],
        lambda: _next(1),
        "(1, 2)",
    ),
    "joining/half": Choice(
        "Now b₄ = (5, 4): the right edge has the direction of the left one, and half of its length. What is seen at "
        "the join?",
        {
            "a corner": "A corner is a jump of the direction. Does the direction jump?",
            "nothing: the tangent direction goes on": "Yes. Only the speed jumps, and a picture has no speed.",
            "a gap": "Both curves still pass through b₃.",
        },
        "nothing: the tangent direction goes on",
    ),
    "joining/collinear": Choice(
        "The slides say of G1: b₂, b₃, b₄ are on one line. Which of these has all three on one line and still a turn "
        "by 180°?",
        {
            "b₂ = (2, 4), b₃ = (4, 4), b₄ = (9, 4)": "From left to right, and on: no turn.",
            "b₂ = (2, 4), b₃ = (4, 4), b₄ = (3, 4)": "Yes: the curve arrives to the right and leaves to the left.",
            "b₂ = (2, 4), b₃ = (4, 4), b₄ = (4, 9)": "These three are not on one line.",
        },
        "b₂ = (2, 4), b₃ = (4, 4), b₄ = (3, 4)",
    ),
    "joining/other-interval": Choice(
        "No point is moved. The right cubic now takes twice as long: its interval has length 2, not 1. The join was "
        "C1. And now?",
        {
            "still C1": "Same way, twice the time: what happens to the speed on the right?",
            "G1, no longer C1": "Yes: the direction stays, the speed on the right is halved.",
            "not even G1": "Does a direction depend on the time one takes?",
        },
        "G1, no longer C1",
    ),
    "joining/second-place": Entry(
        "Both intervals have length 1, and b₄ = (6, 4). Where must b₅ lie for C2?",
        lambda: goes_on(LEFT)[2],
        _second,
        "(1, 2)",
    ),
    "joining/free-points": Choice(
        "The left cubic is given, and the join shall be C2. How many of the right cubic's four points can still be "
        "chosen?",
        {
            "3": "That is C0: only b₃ is given. Each further derivative fixes one more.",
            "2": "That is C1: b₃ and b₄ are given.",
            "1": "Yes: b₃, b₄, b₅ are given, and only the end is free. C2 has a price.",
            "0": "Then it would be C3, and both were parts of one cubic.",
        },
        "1",
    ),
    "joining/cut": Choice(
        "A parabola is cut at t = 1/3, and each part runs on its own interval of length 1. Which classes has the join?",
        {
            "all: it is one parabola": "One picture, but the clock changed. Compare the end edges of both parts.",
            "G1 and G2, neither C1 nor C2": "Yes: direction and curvature belong to the picture, speed to the clock.",
            "only G1": "Curvature is seen in the picture, and the picture is one parabola.",
        },
        "G1 and G2, neither C1 nor C2",
    ),
    "joining/beside": Entry(
        "The data are (0, 0) (2, 5) (6, 6) ... The control point right after D₁ = (2, 5), by the one-sixth rule:",
        lambda: catmull_rom(DATA)[1][1],
        _beside,
        "(1, 2)",
    ),
    "joining/how-many-move": Choice(
        "One data point in the middle is moved. How many cubics of the one-sixth rule change?",
        {
            "2": "The transcript thinks so, too. But the neighbours' chords end in this point.",
            "3": "Four data points make a piece. In how many pieces is a given point one of the four?",
            "4": "Yes: two on each side.",
            "all": "Each piece is made from four data points only.",
        },
        "4",
    ),
    "joining/which-jumps": Choice(
        "At the data points of the one-sixth rule, what jumps in general?",
        {
            "the direction": "Both sides have half the chord of the neighbours as velocity.",
            "the speed": "Speed is the length of the velocity: compare the velocities on both sides.",
            "the curvature": "Yes: nothing in the rule looks at second derivatives.",
        },
        "the curvature",
    ),
    "joining/exercise-class": Choice(
        "Exercise 1. ..., (1, 1), (3, 2) | (3, 2), (7, 4), ... Two cubics on intervals of length 1. What is true at "
        "the join?",
        {
            "C1": "Compare the two edges at the join: are they one vector?",
            "G1, not C1": "Yes: (4, 2) is twice (2, 1).",
            "C0 only": "Is one edge a positive multiple of the other?",
        },
        "G1, not C1",
    ),
    "joining/exercise-interval": Entry(
        "Exercise 2. In exercise 1 the left interval has length 1. Which length must the right one have for C1?",
        lambda: F(2),
        lambda: [
            (F(1, 2), "The other way round: the longer edge needs the longer time."),
            (F(4), "The velocity is divided by the length, not by its root."),
            (F(1), "With equal lengths the speeds are as 1 : 2."),
        ],
        "3",
    ),
    "joining/exercise-next": Entry(
        "Exercise 3. Left: (0, 0) (0, 2) (2, 4) (4, 4) on an interval of length 1. The right cubic has length 2. b₄ "
        "for C1:",
        lambda: goes_on(LEFT, 2)[1],
        lambda: _next(2),
        "(1, 2)",
    ),
    "joining/exercise-second": Entry(
        "Exercise 4. The same two cubics. Both tips of the A-frame must be one point; which point b₅ makes them so?",
        lambda: goes_on(LEFT, 2)[2],
        lambda: [
            (goes_on(LEFT)[2], "This is b₅ for two equal intervals."),
            ((6, 8), "This is the tip. From there one leg passes b₄."),
            ((10, 0), "Beyond b₄ the leg goes on in the ratio of the intervals, not as far again."),
        ],
        "(1, 2)",
    ),
    "joining/exercise-piece": Entry(
        "Exercise 5. Data (0, 0) (2, 5) (6, 6) (8, -1) (12, 0) ... The four control points from (6, 6) to (8, -1), "
        "one-sixth rule:",
        lambda: catmull_rom(DATA)[2],
        _pieces,
        "(6, 6) (1, 2) (2, 1) (8, -1)",
    ),
}


def _report(state):
    return continuity(state.points[:4], state.points[3:], (state.t, 1 - state.t))


def _moved_alone(state, right, place):
    """Whether both intervals are equal, and no point of the two cubics but the one at ``place`` has moved."""
    return state.t == F(1, 2) and all_but(place, state, (*LEFT, *right[1:]))


def _moved_to(right, place, name):
    return lambda state: _moved_alone(state, right, place) and getattr(_report(state), name).holds


def _bend_goes_on(state):
    """G2 without C2, by moving b_5 alone."""
    report = _report(state) if _moved_alone(state, EVEN, 5) else None
    return bool(report and report.G2.holds and not report.C2.holds)


GOALS = {
    "joining/no-corner": Goal(
        "Task: t stays 1/2. Move b₄, and no other point, so that the join is C1.",
        _moved_to(CORNER, 4, "C1"),
        "Reached: b₃ is in the middle of b₂ and b₄. Is it the only place?",
    ),
    "joining/clock": Goal(
        "Task: move no point. Find the t, where the parameter passes the join, for which the join is C1.",
        lambda state: state.points == (*LEFT, *FAST[1:]) and 0 < state.t < 1 and _report(state).C1.holds,
        "Reached: the intervals are as long as the edges, 1 : 2.",
    ),
    "joining/close-the-frame": Goal(
        "Task: t stays 1/2. Move b₅, and no other point, so that the join is C2: circle and square must meet.",
        _moved_to(EVEN, 5, "C2"),
        "Reached: one tip, one second derivative.",
    ),
    "joining/same-bend": Goal(
        "Task: t stays 1/2. Move b₅, and no other point, so that the join is G2 but not C2.",
        _bend_goes_on,
        "Reached: the curvature goes on, the second derivative jumps. On which line may b₅ move?",
    ),
}
