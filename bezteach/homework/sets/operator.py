"""Homework on lesson 06: the shift E and the step g(t) = (1 - t) + t E, on points and in formulas."""

from fractions import Fraction as F
from itertools import accumulate

import numpy as np
from sympy import Derivative, Eq, Interval, Le, Rational, expand, oo, solve, symbols

from bezteach import numeric, symbolic
from bezteach.display import point
from bezteach.examples import EXAMPLES
from bezteach.symbolic import E, b, j, k, n, step, t

from ..kinds import Set, asks_derivation, asks_formula, asks_position, asks_truth, asks_value, listed

h, s, v, w, x = symbols("h s v w x", real=True)

BOOK = {
    "cubic": EXAMPLES["deck/split"].given["points"],
    "numbers": (2, 1, 3),
    "points": EXAMPLES["deck/segment"].given["points"],
    "steps": (F(1, 3), F(1, 2)),
    "t": F(1, 3),
    "middle": (1, 2),
}


def draw(chance):
    """Points on which steps at thirds and a half leave small numbers; t is never its own 1 - t."""
    places = accumulate(3 * chance.randint(1, 3) for _ in range(4))
    ahead, behind = chance.sample(range(2, 6), 2)
    return {
        "cubic": tuple((2 * k + chance.randint(-1, 1), height) for k, height in enumerate(chance.sample(range(6), 4))),
        "numbers": (ahead, chance.randint(1, 3), behind),
        "points": tuple(zip(places, chance.sample([-3, 0, 3, 9, 12], 4), strict=True)),
        "steps": (chance.choice([F(1, 3), F(2, 3)]), F(1, 2)),
        "t": chance.choice([F(1, 3), F(2, 3), F(1, 4), F(3, 4), *(F(part, 5) for part in range(1, 5))]),
        "middle": (chance.randint(1, 4), chance.choice([-3, -2, -1, 1, 2, 3])),
    }


def _acted(operator, control_points):
    """The point that a polynomial in E makes of b_0; its coefficients are numbers."""
    return np.array([symbolic.apply(operator, heights) for heights in zip(*control_points, strict=True)])


def _looked(data, start=2, forth=E, back=1 / E):
    """What the sum of shifts makes of b_start, with these in the place of E and of E^(-1)."""
    ahead, here, behind = data["numbers"]
    return _acted(expand((ahead * forth - here + behind * back) * E**start), data["cubic"])


def _looked_mistakes(data):
    return [
        (_looked(data, forth=1 / E, back=E), "E and E^(-1) are exchanged: E goes on to the next point."),
        (_looked(data, start=1), "You began one point too early: the first point has the number 0."),
        (_looked(data, back=-E), "E^(-1) is not -E: it goes back to the point before."),
        (_looked(data, forth=1, back=1), "You took every term at b_2 itself. E moves to another point."),
        (
            _looked(data) + data["numbers"][1] * (np.array(data["cubic"][2]) - 1),
            "The number in the middle stands for a multiple of 1, the identity: it multiplies a point, too.",
        ),
    ]


def _mixed(data, *steps):
    return _acted(np.prod([step(place) for place in steps]), data["points"])


def _mixed_mistakes(data):
    first, second = data["steps"]
    mean = (first + second + 1) / 3
    return [
        (_mixed(data, first, second), "g(1) is not 1. Put t = 1 into g(t)."),
        (_mixed(data, first, 1, first), "Both other steps of yours are at the first parameter."),
        (_mixed(data, second, 1, second), "Both other steps of yours are at the second parameter."),
        *((_mixed(data, one, 1), "A step is missing: there are three, and you made two.") for one in data["steps"]),
        (_mixed(data, first * second, 1), "Two steps are not one step at the product of the parameters."),
        (_mixed(data, mean, mean, mean), "Three steps at the mean of the parameters are not the same: multiply out."),
        (_mixed(data, 1 - first, 0, 1 - second), "t and 1 - t are exchanged in each step: g(1) goes to the next one."),
        (_mixed(data, 1 - first, 1, 1 - second), "g(1) is right. In the other steps t and 1 - t are exchanged."),
    ]


def _row(operator):
    """The numbers before 1, E, E^2, E^3."""
    return [expand(operator).coeff(E, power) for power in range(4)]


def _row_mistakes(data):
    place, right = data["t"], _row(step(data["t"]) ** 2 * (E - 1))
    stays, moves = 1 - place, place * E
    return [
        ([-number for number in right], "The signs are turned: E - 1 is the later point minus the earlier one."),
        (right[::-1], "The numbers are right and their order is reversed: the one before b_0 comes first."),
        (_row(step(1 - place) ** 2 * (E - 1)), "t and 1 - t are exchanged: t stands before E."),
        (_row((stays**2 + stays * moves + moves**2) * (E - 1)), "The square of g(t) has a term twice."),
        (_row((stays**2 + moves**2) * (E - 1)), "The square of a sum is not the sum of the squares."),
        (_row(step(place) * (E - 1)), "One step is missing: g(t) is squared."),
        (_row(step(place) ** 2 * (E + 1)), "This is a sum of two points, and a difference is asked for."),
        (_row(3 * step(place) ** 2 * (E - 1)), "This is p'(t) of the cubic: a factor has come in."),
    ]


def _turned(data, found):
    """Whether E^2 acts on the points as -1."""
    return not (found[2:] + found[:-2]).any()


DEMANDS = (
    (lambda data, found: len(found) == 4, "Four control points: b_0, b_1, b_2, b_3."),
    (_turned, "E^2 b_0 is not -b_0, or E^2 b_1 not -b_1. To which points does E^2 lead from these two?"),
    (
        lambda data, found: tuple(numeric.evaluate(found, F(1, 2))) == data["middle"],
        "p(1/2) is somewhere else. Which number is E^2 here, and which one E^3?",
    ),
)


def _turning(data):
    """(1 + E)^3 = 2 (E - 1) where E^2 = -1, so p(1/2) is a quarter of b_1 - b_0."""
    first = np.array(data["middle"])
    return [first, 5 * first, -first, -5 * first]


AGAIN = step(s).subs(E, solve(step(t) - x, E)[0])
RATIO = """(1-t)*(g(t)^n b_0 - g(t)^(n-1) b_0)
= (1-t)*(g(t) - 1)*g(t)^(n-1) b_0
= (1-t)*t*(E - 1)*g(t)^(n-1) b_0
= t*(E - g(t))*g(t)^(n-1) b_0
= t*(g(t)^(n-1) b_1 - g(t)^n b_0)"""


def _newton(second):
    return h + j * v + second * w


def _number(steps, shifts, place=t):
    return step(place) ** steps * E**shifts * b[0]


SET = Set(
    BOOK,
    draw,
    {
        "look": asks_value(
            "point",
            lambda data: (
                f"The cubic has the control points {listed(data['cubic'])}. Which point is "
                f"({data['numbers'][0]} E - {data['numbers'][1]} + {data['numbers'][2]} E^(-1)) b_2?"
            ),
            _looked,
            _looked_mistakes,
            ("Three points, each with its number.", "E b_2 is b_3. What is E^(-1) b_2, and what is 1 b_2?"),
        ),
        "mixed": asks_value(
            "point",
            lambda data: (
                f"The control points are {listed(data['points'])}. Which point is "
                f"g({data['steps'][0]}) g(1) g({data['steps'][1]}) b_0?"
            ),
            lambda data: _mixed(data, data["steps"][0], 1, data["steps"][1]),
            _mixed_mistakes,
            ("The order of the steps does not count: begin with the easiest.", "g(1) = E: then b_0 is left behind."),
        ),
        "weights": asks_value(
            "numbers",
            lambda data: (
                f"g(t)^2 (E - 1) b_0 with t = {data['t']} is a sum of b_0, b_1, b_2, b_3, each with a number. Give the "
                f"list of the four numbers, that of b_0 first."
            ),
            lambda data: _row(step(data["t"]) ** 2 * (E - 1)),
            _row_mistakes,
            ("Multiply out as with a letter.", "First g(t)^2, three numbers. Then E times it minus it."),
        ),
        "newton": asks_formula(
            lambda data: (
                "The third differences of a long list of control points are 0: (E - 1)^3 b_i = 0 for all i. Write b_j, "
                "j >= 0, in j, h, v, w, where h = b_0, v = (E - 1) b_0 and w = (E - 1)^2 b_0."
            ),
            lambda data: _newton(j * (j - 1) / 2),
            {h, v, w, j},
            {j: (0, oo)},
            lambda data: [
                (_newton(j**2 / 2), "This is how far something falls in the time j. Here there are steps: test j = 1."),
                (_newton(j**2), "Test j = 1: how many w's are in b_1?"),
                (_newton(j * (j - 1)), "A factor is missing before w. Test j = 2: how many w's are in b_2?"),
                (_newton(j * (j + 1) / 2), "One w too early: the first edge is v, and only the second one v + w."),
                (_newton(j), "Then every edge would be v + w. Already the first one is not."),
                (_newton(0), "These are points at equal steps: w is missing."),
            ],
            ("b_j = E^j b_0, and E = 1 + (E - 1).", "The binomial theorem; all powers from the third on are gone."),
        ),
        "again": asks_formula(
            lambda data: (
                "Two parameters, 0 < s < 1 and 0 < t < 1. Let x stand for the operator g(t). Write g(s) in s, t and x, "
                "without E."
            ),
            lambda data: AGAIN,
            {s, t, x},
            {s: Interval.open(0, 1), t: Interval.open(0, 1)},
            lambda data: [
                (1 - s + s * x, "This is g(s t): a step of the parameter s on the part that ends at t."),
                (1 - t / s + t / s * x, "The quotient is upside down: for small s, g(s) is near to 1."),
                (s / t * x, "For s = 0 this is 0, but g(0) is 1."),
                (x + s - t, "g(s) and g(t) differ by a multiple of E - 1, not by a number."),
                (1 - s + s / t * x, "The number before x is right. The two numbers of a step have the sum 1."),
            ],
            ("Solve x = 1 - t + t E for E.", "Or write g(s) = 1 + s (E - 1) and g(t) likewise."),
        ),
        "last": asks_formula(
            lambda data: (
                "A curve of degree n >= 1, and a level k, 1 <= k <= n. Write the last point of this level as an "
                "operator on b_0: a formula in n, k, t, E and b_0, such as (1-t+t E)^n b_0 for the point of the curve. "
                "g(t) may stand for 1-t+t E."
            ),
            lambda data: _number(k, n - k),
            {n, k, t, E, b},
            {n: (1, oo), k: (1, n)},
            lambda data: [
                (_number(k, 0), "This is the first point of the level."),
                (_number(n - k, k), "This is a point of level n - k: the number of steps is the level."),
                (_number(k, n - k + 1), "One shift too many: this would need b_(n+1)."),
                (_number(k, n - k - 1), "One shift too few: this is the last point but one."),
                (_number(k, n), "This begins at b_n. Already the first step would need a point behind it."),
                (_number(k, k), "This is number k of the level. Which number has the last point?"),
                (_number(n, 0), "This is the point of the curve, the last level."),
                (_number(k, n - k, 1 - t), "t and 1 - t are exchanged."),
            ],
            ("Which numbers do the points of level k have?", "So many shifts first, then k steps."),
        ),
        "speed": asks_truth(
            lambda data: (
                "True or false, for every n >= 1 and every t: t p'(t) = n (p(t) - q), where p(t) = g(t)^n b_0, and q = "
                "g(t)^(n-1) b_0 is the first point of the last level but one? If false, give a counterexample."
            ),
            lambda data: Eq(
                t * Derivative(step(t) ** n * b[0], t),
                n * (step(t) ** n * b[0] - step(t) ** (n - 1) * b[0]),
                evaluate=False,
            ),
            {n: (1, oo)},
            ("p'(t) = n (E - 1) g(t)^(n-1) b_0.", "What is t (E - 1), if you know g(t)?"),
        ),
        "two-steps": asks_truth(
            lambda data: (
                "In g(t)^2 b_0 the weight of b_1 is 2t (1-t), which is never more than 1/2. True or false, for all s "
                "and t in [0, 1]: in g(s) g(t) b_0 the weight of b_1 is at most 1/2, too? If false, give a "
                "counterexample, s and t."
            ),
            lambda data: Le(expand(step(s) * step(t)).coeff(E, 1), Rational(1, 2)),
            {s: Interval(0, 1), t: Interval(0, 1)},
            ("Multiply g(s) g(t) out. What stands before E?", "Which two steps lead from b_0 to b_1, and no further?"),
        ),
        "ratio": asks_derivation(
            lambda data: (
                "Show for every n >= 1 that the last segment is divided in the ratio t : 1-t, for parabolas the "
                "three-tangent theorem: begin with (1-t)*(g(t)^n b_0 - g(t)^(n-1) b_0), end with "
                "t*(g(t)^(n-1) b_1 - g(t)^n b_0), and write at least one line between. For g(t) you may also write "
                "1-t+t E in brackets."
            ),
            RATIO,
            {n, t, E, b},
            {n: (1, oo)},
            hints=(
                "Both points have the factor g(t)^(n-1) b_0.",
                "g(t) - 1 is a multiple of E - 1. And E - g(t)?",
            ),
        ),
        "turn": asks_position(
            lambda data: (
                "Give four control points on which a double shift acts like the number -1, E^2 b_0 = -b_0 and "
                f"E^2 b_1 = -b_1, and whose curve is in {point(data['middle'])} at t = 1/2."
            ),
            DEMANDS,
            _turning,
            (
                "Two of the points can be written with the other two.",
                "p(1/2) = 1/8 (1 + E)^3 b_0. Multiply out, and put -1 for E^2.",
            ),
        ),
    },
)
