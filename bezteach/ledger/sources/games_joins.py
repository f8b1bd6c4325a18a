"""The games slides on joins, and those on the ends of a curve, which come twice."""

from fractions import Fraction

from sympy import IndexedBase

from bezteach.symbolic import n

from ..claims.joins import TURNING_BACK, c2, tangents_oppose, velocities_agree
from ..forms import FROM_ONE, curve, derivative_at
from ..planar import dot, minus
from ..reading import amended, refuted, refuted_words, row

p = IndexedBase("p")
CURVE = curve(points=p)
LOST = "sign lost in the text"

REFLECTED = [(-1, 1), (-1, 0), (0, 0)], [(0, 0), (1, 0), (1, -1)]
ENLARGED_THRICE = [(-3, -4), (-1, 0), (0, 0)], [(0, 0), (1, 0), (3, -4)]
SMOOTH = [(-1, 1), (-1, 0), (0, 0)], [(0, 0), (1, 0), (3, 1)]


def sides(triangle):
    """The squares of the sides of a triangle, ascending."""
    return sorted(dot(minus(triangle[k], triangle[k - 1]), minus(triangle[k], triangle[k - 1])) for k in range(3))


def similar(first, second):
    """Whether two triangles have sides in one ratio."""
    ratios = {Fraction(one, other) for one, other in zip(sides(first), sides(second), strict=True)}
    return len(ratios) == 1


def similar_is_not_c2():
    """Whether similar triangles may come without C2 in both readings of the lost picture, and C2 without them."""
    (far, near, _), (_, next_near, next_far) = ENLARGED_THRICE
    apex = (0, 2)
    outer, inner = (apex, far, next_far), (apex, near, next_near)
    without = similar(*REFLECTED) and similar(outer, inner) and not (c2(*REFLECTED) or c2(*ENLARGED_THRICE))
    kept = velocities_agree(*REFLECTED) and velocities_agree(*ENLARGED_THRICE)
    return without and kept and c2(*SMOOTH) and not similar(*SMOOTH)


def end_properties(where):
    """The slide of the properties at the ends, which is printed twice."""
    return [
        row(f"{where}, f(0)", "curve/start"),
        row(f"{where}, f(1)", "curve/end"),
        row(
            f"{where}, tangents along the edges",
            "curve/tangent/direction",
            amended(
                "the tangents at the ends have the directions of the first and the last edge",
                "an edge that is zero has no direction: p_0 and p_1 must differ, and so must p_{n-1} and p_n",
            ),
        ),
        row(f"{where}, f'(0)", "curve/tangent/start"),
        row(
            f"{where}, f'(1)",
            "curve/tangent/end",
            refuted((derivative_at(1, CURVE), n * (p[n - 1] - p[n])), FROM_ONE),
        ),
        row(f"{where}, k-th derivative from k + 1 points, start", "curve/derivative-r/start"),
        row(f"{where}, k-th derivative from k + 1 points, end", "curve/derivative-r/end"),
        row(f"{where}, f''(0)", "curve/second/start"),
        row(f"{where}, f''(1)", "curve/second/end"),
    ]


JOINS = [
    row("joins, C0", "joins/c0"),
    row(
        "joins, G1",
        "joins/g1",
        refuted_words(
            "G1: the three points are on one line",
            "P_{n-1} = (1, 0), P_n = Q_0 = (0, 0), Q_1 = (1, 0) are on one line, and the tangent turns round: P_n must "
            "lie strictly between the two others",
            lambda: tangents_oppose(*TURNING_BACK),
        ),
    ),
    row(
        "joins, C1",
        "joins/c1",
        refuted_words(
            "C1: the three points are on one line, equally far apart",
            "P_{n-1} = (1, 0), P_n = Q_0 = (0, 0), Q_1 = (1, 0) are on one line at equal distances, and for cubics the "
            "velocity jumps from (-3, 0) to (3, 0): P_n must be the middle, for equal degrees and equal intervals",
            lambda: tangents_oppose(*TURNING_BACK) and not velocities_agree(*TURNING_BACK),
        ),
    ),
    row(
        "joins, C2, second derivative at the start",
        "curve/second/start",
        amended("d^2/dt^2 is proportional to p_2 2 p_1 + p_0", LOST),
    ),
    row(
        "joins, C2, second derivative at the end",
        "curve/second/end",
        amended("d^2/dt^2 is proportional to p_n 2 p_{n-1} + p_{n-2}", LOST),
    ),
    row(
        "joins, C2, similar triangles",
        "joins/c2",
        refuted_words(
            "C2: the shaded triangles are similar",
            "the triangles (-1, 1), (-1, 0), (0, 0) and (0, 0), (1, 0), (1, -1) of the last and the first three points "
            "are congruent and the join of these quadratic curves is C1, but the second derivative jumps from (2, 2) "
            "to (-2, -2); triangles with their apex where the outer edges meet must have the ratio 2, not any",
            similar_is_not_c2,
        ),
    ),
    row("joins, what of G2", "joins/g2"),
]
