"""The control points of any part of a curve, by two cuts one after the other."""

from sympy import Add, Ge, Interval, Le, Mul, Sum, Symbol, symbols

from bezteach.symbolic import B, b, i, j, n, step, u

from ..claim import Shown, argued, claim, eq
from ..forms import curve, quotient

t1, t2 = symbols("t_1 t_2", real=True)
c = Symbol("c", real=True)
PLACE = {j: (0, n)}
UP_TO_T2 = {t2: Interval.open(0, 1), t1: Interval.open(0, t2)}
WHOLE_FRONT = {u: Interval(0, 1), t2: Interval.open(0, 1)}
FROM_T1 = {t1: Interval.open(0, 1), t2: Interval.open(t1, 1)}


def part_point(place, start=t1, end=t2):
    """The control point with this number of the part from start to end."""
    return step(start) ** (n - place) * step(end) ** place * b[0]


PART = Sum(B(j, n, u) * part_point(j), (j, 0, n))
FIRST_SCHEME = Sum(B(i, n - j, c) * step(t2) ** (i + j) * b[0], (i, 0, n - j))
SECOND_SCHEME = Sum(B(i, j, c) * step(t1) ** (n - i) * b[i], (i, 0, j))
FRONT_AGAIN = Sum(B(i, j, c) * part_point(i), (i, 0, j))
BACK_AGAIN = Sum(B(i, n - j, c) * part_point(i + j), (i, 0, n - j))
CUT = (1 - c) * t1 + c * t2
IN_FRONT = Mul(quotient(t1, t2), t2, evaluate=False)
BEHIND = Add(t1, Mul(1 - t1, quotient(t2 - t1, 1 - t1), evaluate=False), evaluate=False)
BEHIND_AS_PRINTED = Add(t1, Mul(1 - t1, quotient(t1, t2), evaluate=False), evaluate=False)

CLAIMS = [
    claim(
        "segment/points",
        "the part from t_1 to t_2 has the points that n - j steps at t_1 and j steps at t_2 give",
        (PART, curve(at=(1 - u) * t1 + u * t2)),
        twins=[(PART, curve(at=(1 - u) * t2 + u * t1))],
    ),
    claim(
        "segment/first-scheme",
        "cut at t_2, then the front part at c: the back of that is the part from c t_2 to t_2",
        (FIRST_SCHEME, part_point(j, c * t2, t2)),
        PLACE,
        twins=[(FIRST_SCHEME, part_point(j, c, t2)), (FIRST_SCHEME, part_point(j, t2, c * t2))],
    ),
    claim(
        "segment/first-scheme/parameter",
        "in the front part, which ends at t_2, the parameter t_1/t_2 is t_1 of the whole curve",
        (IN_FRONT, t1),
        UP_TO_T2,
        twins=[(quotient(t2, t1), t1), (quotient(t1, t2), t1)],
    ),
    argued(
        "segment/first-scheme/range",
        "u = t/t_2 runs from 0 to 1 while t runs from 0 to t_2",
        "Let 0 < t_2 < 1 and 0 <= t <= t_2. Divided by the positive number t_2, that is 0 <= t/t_2 <= 1.",
        "Each u from 0 to 1 is reached, by t = u t_2:",
        Shown("this gives u back,", eq(quotient(u * t2, t2), u), {t2: Interval.open(0, 1)}),
        Shown("it is not below 0,", Ge(u * t2, 0, evaluate=False), WHOLE_FRONT),
        Shown("and not beyond t_2.", Le(u * t2, t2, evaluate=False), WHOLE_FRONT),
    ),
    claim(
        "segment/second-scheme",
        "cut at t_1, then the back part at c: the front of that is the part from t_1 to t_1 + (1 - t_1) c",
        (SECOND_SCHEME, part_point(j, t1, t1 + (1 - t1) * c)),
        PLACE,
        twins=[(SECOND_SCHEME, part_point(j, t1, c)), (SECOND_SCHEME, part_point(j, t1, t1 * c))],
    ),
    claim(
        "segment/second-scheme/parameter",
        "in the back part, which begins at t_1, the parameter (t_2 - t_1)/(1 - t_1) is t_2 of the whole curve",
        (BEHIND, t2),
        FROM_T1,
        twins=[(BEHIND_AS_PRINTED, t2)],
    ),
    claim(
        "segment/front",
        "cut a part at c: the control points of its front",
        (FRONT_AGAIN, part_point(j, t1, CUT)),
        PLACE,
        twins=[(FRONT_AGAIN, part_point(j, CUT, t2))],
    ),
    claim(
        "segment/back",
        "cut a part at c: the control points of its back",
        (BACK_AGAIN, part_point(j, CUT, t2)),
        PLACE,
        twins=[(BACK_AGAIN, part_point(j, t1, CUT))],
    ),
]
