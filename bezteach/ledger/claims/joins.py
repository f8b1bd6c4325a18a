"""Where two curves meet: the conditions for C0, C1, G1, C2 and G2.

In the equations the left curve has the points b_0 .. b_n, and the right one goes on with b_n .. b_{2n}. In the
arguments they are P_0 .. P_n and Q_0 .. Q_m; h and l are the lengths of the intervals on which they run.
"""

from fractions import Fraction

from sympy import Sum, symbols

from bezteach.symbolic import B, b, i, n, t

from ..claim import Computed, Known, Shown, argued, claim, eq
from ..forms import FROM_ONE, FROM_TWO, curve, derivative_at
from ..planar import acceleration, cross, curvature_squared, dot, halves, minus, velocity

c, d, s, x1, y1, x2, y2 = symbols("c d s x1 y1 x2 y2", real=True)
join, velocity_there, before, after = symbols("p v a c", real=True)
h, k = symbols("h l", positive=True)

LEFT, RIGHT = curve(), curve(first=n)
JUMP = derivative_at(0, RIGHT) - derivative_at(1, LEFT)
SECOND_JUMP = derivative_at(0, RIGHT, 2) - derivative_at(1, LEFT, 2)
CONTINUED = (
    B(0, n, t) * b[n]
    + B(1, n, t) * (2 * b[n] - b[n - 1])
    + B(2, n, t) * (b[n - 2] + 4 * b[n] - 4 * b[n - 1])
    + Sum(B(i, n, t) * b[n + i], (i, 3, n))
)

TURNING_BACK = [(0, 1), (1, 1), (1, 0), (0, 0)], [(0, 0), (1, 0), (2, -1), (1, -2)]
PARABOLA_IN_TWO = halves([(0, 0), (3, 6), (9, 0)], Fraction(1, 3))
EVEN_THEN_FASTER = [(0, 0), (1, 0), (2, 0)], [(2, 0), (3, 0), (5, 0)]
EVEN_THEN_TWICE = [(0, 0), (1, 0), (2, 0)], [(2, 0), (4, 0), (6, 0)]


LAST_INNER, FIRST_INNER = join - h * velocity_there, join + k * velocity_there
TIP_LEFT = LAST_INNER + (k / h) * (LAST_INNER - before)
TIP_RIGHT = FIRST_INNER + (h / k) * (FIRST_INNER - after)
BENDS = (after - 2 * FIRST_INNER + join) / k**2 - (join - 2 * LAST_INNER + before) / h**2


def tangents_oppose(left, right):
    """Whether the last edge and the first one lie on one line and point against each other."""
    before, after = minus(left[-1], left[-2]), minus(right[1], right[0])
    return cross(before, after) == 0 and dot(before, after) < 0


def velocities_agree(left, right):
    return velocity(left, 1) == velocity(right, 0)


def accelerations_agree(left, right):
    return acceleration(left, 1) == acceleration(right, 0)


def c2(left, right):
    """Whether two curves that meet, each on an interval of length 1, meet with C2."""
    return velocities_agree(left, right) and accelerations_agree(left, right)


def curvatures_agree(left, right):
    return curvature_squared(left, 1) == curvature_squared(right, 0)


CLAIMS = [
    argued(
        "joins/c0",
        "C0, which is G0: the last point of one curve is the first point of the next",
        Known("The left curve ends at P_n,", "curve/end"),
        Known("and the right one starts at Q_0.", "curve/start"),
        "So the whole is continuous at the join exactly if P_n = Q_0. No parameter enters, hence G0 is the same.",
    ),
    claim(
        "joins/c1/jump",
        "equal degrees: the velocity jumps by n times the second difference about the join",
        (JUMP, n * (b[n + 1] - 2 * b[n] + b[n - 1])),
        FROM_ONE,
        twins=[(JUMP, b[n + 1] - 2 * b[n] + b[n - 1]), (JUMP, n * (b[n + 1] - b[n - 1]))],
    ),
    argued(
        "joins/c1",
        "C1: the curves meet, and degree times edge over length of the interval agrees on both sides",
        Known("C1 includes C0.", "joins/c0"),
        Known("The velocity arrives as n (P_n - P_{n-1}),", "curve/tangent/end"),
        Known("and starts as m (Q_1 - Q_0), each in its own parameter.", "curve/tangent/start"),
        "In the common parameter a derivative is divided by the length of the interval: C1 is C0 with "
        "m (Q_1 - Q_0) / l = n (P_n - P_{n-1}) / h.",
        Known(
            "For equal degrees and equal intervals P_n is the middle of P_{n-1} and Q_1: the three points are on a "
            "line, equally far apart, and P_n is the one between.",
            "joins/c1/jump",
        ),
        Computed(
            "On a line and equally far apart is not enough: with P_{n-1} = Q_1 the velocity turns round.",
            lambda: tangents_oppose(*TURNING_BACK) and not velocities_agree(*TURNING_BACK),
        ),
    ),
    argued(
        "joins/g1",
        "G1, where no edge at the join is zero: the curves meet, and both edges have the same direction",
        Known("G1 includes G0.", "joins/c0"),
        Known("The tangent arrives along P_n - P_{n-1}, times a positive number,", "curve/tangent/end"),
        Known("and starts along Q_1 - Q_0, times a positive number.", "curve/tangent/start"),
        "So they have one direction exactly if Q_1 - Q_0 = s (P_n - P_{n-1}) with a number s > 0.",
        Shown(
            "Then (1 + s) P_n = s P_{n-1} + Q_1: a mean with positive weights, so P_n lies strictly between P_{n-1} "
            "and Q_1. Here b_0 and b_1 are P_{n-1} and P_n.",
            eq((1 + s) * b[1], s * b[0] + (b[1] + s * (b[1] - b[0]))),
        ),
        Computed(
            "That the three points are on a line is not enough: the direction may be reversed.",
            lambda: tangents_oppose(*TURNING_BACK),
        ),
        "It is C1 exactly if s m / l = n / h, which is s = 1 for equal degrees and intervals; any other s > 0 gives "
        "equal directions at unequal speeds.",
    ),
    claim(
        "joins/c2/jump",
        "equal degrees: the second derivative jumps by n (n - 1) times this, where the join itself cancels",
        (SECOND_JUMP, n * (n - 1) * (b[n + 2] - 2 * b[n + 1] + 2 * b[n - 1] - b[n - 2])),
        FROM_TWO,
        twins=[
            (SECOND_JUMP, n * (n - 1) * (b[n + 2] - 2 * b[n + 1] + 2 * b[n - 1] + b[n - 2])),
            (SECOND_JUMP, n**2 * (b[n + 2] - 2 * b[n + 1] + 2 * b[n - 1] - b[n - 2])),
        ],
    ),
    claim(
        "joins/c2/points",
        "equal degrees: the three points with which the next curve keeps velocity and second derivative",
        (derivative_at(0, CONTINUED, 2), derivative_at(1, LEFT, 2)),
        FROM_TWO,
        twins=[
            (derivative_at(0, CONTINUED, 2), derivative_at(0, LEFT, 2)),
            (derivative_at(0, RIGHT, 2), derivative_at(1, LEFT, 2)),
        ],
    ),
    argued(
        "joins/c2",
        "C2: the join is C1, and the second derivatives in the common parameter agree",
        Known("C2 includes C1.", "joins/c1"),
        Known("The second derivative arrives as n (n-1) (P_n - 2 P_{n-1} + P_{n-2}),", "curve/second/end"),
        Known("and starts as m (m-1) (Q_2 - 2 Q_1 + Q_0), each in its own parameter.", "curve/second/start"),
        "In the common parameter it is divided by the square of the length: C2 is C1 with m (m-1) (Q_2 - 2 Q_1 + Q_0) "
        "/ l^2 = n (n-1) (P_n - 2 P_{n-1} + P_{n-2}) / h^2.",
        Known(
            "For equal degrees and intervals P_n = Q_0 cancels: this condition alone ties P_{n-2}, P_{n-1}, Q_1, Q_2.",
            "joins/c2/jump",
        ),
        Known(
            "Together with C1, Q_1 = 2 P_n - P_{n-1}, it gives Q_2 = P_{n-2} + 4 (P_n - P_{n-1}), tying five points.",
            "joins/c2/points",
        ),
        "In other words 2 P_{n-1} - P_{n-2} and 2 Q_1 - Q_2 are one point d, and the triangle d, P_{n-2}, Q_2 is the "
        "triangle d, P_{n-1}, Q_1 enlarged from d by the factor 2.",
        Computed(
            "Equal second derivatives alone are not C2: here both are 0, and the speed is not the same.",
            lambda: accelerations_agree(*EVEN_THEN_TWICE) and not velocities_agree(*EVEN_THEN_TWICE),
        ),
    ),
    argued(
        "joins/a-frame",
        "equal degrees, C1: the join is C2 exactly if the two tips of its A-frame are one point",
        "The tips are P_{n-1} + (P_{n-1} - P_{n-2}) l / h, the edge before the last one prolonged in the ratio of the "
        "intervals, and Q_1 + (Q_1 - Q_2) h / l, the same from the right.",
        Known(
            "C1 means that n (P_n - P_{n-1}) / h and n (Q_1 - Q_0) / l are one velocity: with an n-th v of it, "
            "P_{n-1} = p - h v and Q_1 = p + l v about the join p.",
            "joins/c1",
        ),
        Shown(
            "Then the second derivative jumps by n (n-1) times this, with a = P_{n-2} and c = Q_2: the left tip minus "
            "the right one, over h l.",
            eq(BENDS, (TIP_LEFT - TIP_RIGHT) / (h * k)),
        ),
        Known("So it does not jump, and the join is C2, exactly if the tips are one point.", "joins/c2"),
        "For equal intervals this is 2 P_{n-1} - P_{n-2} = 2 Q_1 - Q_2: each leg is as long again beyond the crossbar.",
    ),
    argued(
        "joins/g2",
        "G2 in the plane, where no edge at the join is zero: G1, and the same signed curvature on both sides",
        "G2 says that a change of parameter on one side, with slope c > 0 and second derivative d at the join, makes "
        "the join C2: q' = c p' and q'' = c^2 p'' + d p', where p and q are the curves on the left and on the right.",
        Known("The first of these is G1.", "joins/g1"),
        Shown(
            "The cross product of q' and q'' is then c^3 times that of p' and p''.",
            eq(c * x1 * (c**2 * y2 + d * y1) - c * y1 * (c**2 * x2 + d * x1), c**3 * (x1 * y2 - y1 * x2)),
        ),
        "The cube of the speed is c^3 times as large too, so the quotient, the signed curvature, is the same.",
        "Conversely, if q' = c p' and the signed curvatures agree, the cross product of p' and q'' - c^2 p'' is 0, so "
        "q'' - c^2 p'' is a multiple d p', since p' is not 0.",
        Computed(
            "A parabola cut at 1/3, each part run through on [0, 1]: equal curvature, other velocity. G2, not C1.",
            lambda: curvatures_agree(*PARABOLA_IN_TWO) and not velocities_agree(*PARABOLA_IN_TWO),
        ),
        Computed(
            "A line run through evenly, then faster and faster: C1 and curvature 0, and the second derivative "
            "jumps. G2, not C2.",
            lambda: (
                velocities_agree(*EVEN_THEN_FASTER)
                and curvatures_agree(*EVEN_THEN_FASTER)
                and not accelerations_agree(*EVEN_THEN_FASTER)
            ),
        ),
    ),
]
