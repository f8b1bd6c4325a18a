"""Degree 2 with all knots written out: what the arguments say for every degree, as equations that are proved.

A span has the control points b_0, b_1, b_2 and the knots s, s + h_0, s + h_0 + h_1, s + h_0 + h_1 + h_2 around it.
"""

from sympy import Add, symbols

from bezteach.symbolic import B, b, t
from bezteach.symbolic.bspline import affine_step, terms

from ..claim import claim
from ..forms import curve_of
from .blossoms import POINTS, two_steps

s, u, v, w = symbols("s u v w", real=True)
g0, g1, g2, g3, g4 = symbols("h0:5", positive=True)
FIVE = [s, s + g0, s + g0 + g1, s + g0 + g1 + g2, s + g0 + g1 + g2 + g3]
SIX = [*FIVE, s + g0 + g1 + g2 + g3 + g4]


def steps(points, knots, first, second):
    """The value that two steps leave of three points, with the four knots around the span."""
    return affine_step(affine_step(points, knots, 1, first), knots, 1, second)[0]


SUM = Add(*[Add(*terms(place, 2, SIX, t, 2)) * b[place] for place in range(3)])
LEFT, RIGHT = FIVE[:4], FIVE[1:]  # the knots around two spans; FIVE[2] is between them
NEXT = [b[1], b[2], b[3]]

OLD = [FIVE[0], FIVE[1], FIVE[3], FIVE[4]]  # without the knot that is inserted, FIVE[2]
NEW = affine_step(POINTS, OLD, 1, FIVE[2])
BEFORE, AFTER = [b[0], *NEW], [*NEW, b[2]]

BETWEEN = (1 - w) * u + w * v


def blended(middle):
    """The Bézier curve over [u, v] at w with this middle control point."""
    return B(0, 2, w) * two_steps(u, u) + B(1, 2, w) * middle + B(2, 2, w) * two_steps(v, v)


CLAIMS = [
    claim(
        "bspline/de-boor/quadratic",
        "degree 2, simple knots: the three pieces weight the control points as two steps with t do",
        (SUM, steps(POINTS, SIX[1:5], t, t)),
        twins=[(SUM, steps(POINTS, SIX[:4], t, t)), (SUM, steps(POINTS, SIX[1:5], t, s))],
    ),
    claim(
        "bspline/bezier/quadratic",
        "degree 2, the knots 0, 0, 1, 1 around the span: two steps with t leave the point of the Bézier curve",
        (steps(POINTS, [0, 0, 1, 1], t, t), curve_of(POINTS)),
        twins=[
            (steps(POINTS, [0, 0, 1, 2], t, t), curve_of(POINTS)),
            (steps(POINTS, [-1, 0, 1, 1], t, t), curve_of(POINTS)),
        ],
    ),
    claim(
        "blossom/agree/quadratic",
        "degree 2: the values of neighbouring spans with the knot between them and any u agree",
        (steps(POINTS, LEFT, FIVE[2], u), steps(NEXT, RIGHT, FIVE[2], u)),
        twins=[
            (steps(POINTS, LEFT, v, u), steps(NEXT, RIGHT, v, u)),
            (steps(POINTS, LEFT, FIVE[1], u), steps(NEXT, RIGHT, FIVE[1], u)),
        ],
    ),
    claim(
        "bspline/insert/quadratic",
        "degree 2, a knot inserted: before it the new control points leave the same curve",
        (steps(BEFORE, FIVE[:4], t, t), steps(POINTS, OLD, t, t)),
        twins=[
            (steps([b[0], NEW[0], b[2]], FIVE[:4], t, t), steps(POINTS, OLD, t, t)),
            (steps(POINTS, FIVE[:4], t, t), steps(POINTS, OLD, t, t)),
        ],
    ),
    claim(
        "bspline/insert/quadratic/after",
        "degree 2, a knot inserted: after it the new control points leave the same curve",
        (steps(AFTER, FIVE[1:], t, t), steps(POINTS, OLD, t, t)),
        twins=[(steps([b[0], *NEW], FIVE[1:], t, t), steps(POINTS, OLD, t, t))],
    ),
    claim(
        "blossom/segment/quadratic",
        "degree 2: over [u, v] the curve has the control points f(u, u), f(u, v), f(v, v)",
        (two_steps(BETWEEN, BETWEEN), blended(two_steps(u, v))),
        twins=[
            (two_steps(BETWEEN, BETWEEN), blended((two_steps(u, u) + two_steps(v, v)) / 2)),
            (two_steps(BETWEEN, BETWEEN), blended(b[1])),
        ],
    ),
]
